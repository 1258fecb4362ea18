//! The whole of a simulation: it goes on from its bytes and from its clone as if nothing had been.

use super::Simulation;
use crate::Buttons;
use crate::rules::tests::bench::table;
use std::sync::Arc;

const RULES: &str = "
fn on_start() { this.count = 0; lamp(\"red\", \"breathe\"); }
fn on_button(name) {
    if name == \"start\" { start_game(3); flippers(true); kickers(true); add_ball(); after(40, \"beat\"); }
    this.count += 1;
    flash(\"green\", 80);
}
fn on_timer(name) {
    score(random(100));
    lamp(\"red\", [\"on\", \"off\", \"pulse\", \"chase\"][random(4)], 200 + random(100));
    after(20 + random(50), name);
}
";

fn simulation(seed: u64) -> Simulation {
    let parts = ["lane", "drain", "saucer", "drop-1", "plunger"];
    Simulation::new(Arc::new(table(RULES, &parts, &["red", "green"])), seed).expect("the rules are sound")
}

/// Hands that press something now and then.
fn hands(tick: u64) -> Buttons {
    match tick {
        10..20 => Buttons::START,
        _ if tick % 97 < 20 => Buttons::LEFT,
        _ if tick % 131 < 30 => Buttons::PLUNGER,
        _ => Buttons::NONE,
    }
}

fn play(simulation: &mut Simulation, ticks: u64) {
    for _ in 0..ticks {
        let buttons = hands(simulation.ticks());
        simulation.tick(buttons);
    }
}

#[test]
fn a_saved_game_goes_on_as_if_nothing_had_been() {
    let mut original = simulation(3);
    play(&mut original, 700);
    let bytes = original.save();
    let mut restored = Simulation::restore(original.table().clone(), &bytes).expect("what was saved");
    let mut shared = original.restored(&bytes).expect("what was saved");
    let mut clone = original.clone();
    for tick in 0..5000 {
        for other in [&mut restored, &mut shared, &mut clone] {
            assert_eq!(other.hashes(), original.hashes(), "{tick} ticks later");
            assert_eq!(other.display(), original.display());
            play(other, 1);
        }
        play(&mut original, 1);
    }
    assert_eq!(original.save(), restored.save());
}

#[test]
fn another_seed_is_another_game() {
    let (mut one, mut two) = (simulation(1), simulation(2));
    play(&mut one, 500);
    play(&mut two, 500);
    assert_ne!(one.hashes().rules, two.hashes().rules);
    assert_ne!(one.hash(), two.hash());
}

#[test]
fn every_damaged_byte_is_noticed() {
    let mut game = simulation(1);
    play(&mut game, 300);
    let bytes = game.save();
    for place in 0..bytes.len() {
        let mut damaged = bytes.clone();
        damaged[place] ^= 0x10;
        assert!(game.restored(&damaged).is_err(), "byte {place} of {}", bytes.len());
        assert!(game.restored(&bytes[..place]).is_err(), "cut after {place} bytes");
    }
}

#[test]
fn another_table_is_refused() {
    let game = simulation(1);
    let mut other = table(RULES, &["lane"], &["red", "green"]);
    other.hash += 1;
    assert!(Simulation::restore(Arc::new(other), &game.save()).is_err_and(|error| error.to_string().contains("table")));
}
