//! The whole of a simulation: it goes on from its bytes and from its clone as if nothing had been.

mod search;

use super::Simulation;
use crate::Buttons;
use crate::rules::tests::bench::table;
use physics::{Event, EventKind, Kind, TickEvent};
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
fn nothing_of_the_game_that_restores_is_in_the_restored_one() {
    let mut original = spectrum();
    (0..9000).for_each(|_| original.tick(blind_hands(original.ticks())));
    let bytes = original.save();
    // By three games: one from scratch, one that has never played, and one that is elsewhere in another game.
    let fresh = spectrum();
    let mut other = Simulation::new(original.table().clone(), 77).expect("the rules are sound");
    (0..6500).for_each(|_| other.tick(blind_hands(other.ticks() * 7 / 5)));
    assert_ne!(other.hashes(), original.hashes());
    let anew = Simulation::restore(original.table().clone(), &bytes).expect("what was saved");
    let mut games = [anew, fresh.restored(&bytes).expect("saved"), other.restored(&bytes).expect("saved")];
    for tick in 0..3000 {
        for game in &mut games {
            assert_eq!(game.hashes(), original.hashes(), "{tick} ticks later");
            assert_eq!(game.snapshot(), original.snapshot(), "{tick} ticks later");
            game.tick(blind_hands(game.ticks()));
        }
        original.tick(blind_hands(original.ticks()));
    }
    games.iter().for_each(|game| assert_eq!(game.save(), original.save()));
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

fn spectrum() -> Simulation {
    let table = crate::table::tests::spectrum();
    Simulation::new(Arc::new(table), 1).unwrap_or_else(|mistake| panic!("{mistake}"))
}

/// Hands that start a game, shoot every ball and flip without looking.
fn blind_hands(tick: u64) -> Buttons {
    let plunger = Buttons::NONE.with(Buttons::PLUNGER, tick % 3000 < 1300);
    plunger
        .with(Buttons::START, (100..150).contains(&tick))
        .with(Buttons::LEFT, tick % 430 < 120)
        .with(Buttons::RIGHT, tick % 510 < 120)
}

#[test]
fn a_game_of_spectrum_goes_from_start_to_game_over_without_a_complaint() {
    let mut game = spectrum();
    let mut switches = std::collections::BTreeSet::new();
    let mut last_ball = 0;
    while game.ticks() < 400_000 && (game.ticks() < 1000 || game.display().playing) {
        game.tick(blind_hands(game.ticks()));
        switches.extend(game.events().filter_map(|event| event.part));
        last_ball = last_ball.max(game.display().ball);
    }
    assert_eq!(game.complaints(), Vec::<String>::new());
    let display = game.display();
    assert!(!display.playing && last_ball == 3, "after {} ticks: ball {last_ball}", game.ticks());
    assert!(display.scores[0] > 0);
    assert!(switches.len() >= 6, "a ball meets more than {} switches", switches.len());
    assert!(game.pose().balls.is_empty(), "no ball is left on the table");
}

#[test]
fn a_game_of_spectrum_that_was_saved_in_play_goes_on_the_same() {
    let mut original = spectrum();
    let mut shots = 0;
    while original.ticks() < 1000 || shots == 0 {
        original.tick(blind_hands(original.ticks()));
        shots += original.events().filter(|event| event.kind == EventKind::Launched).count();
    }
    play(&mut original, 800);
    assert!(original.display().playing && !original.pose().balls.is_empty());
    let mut restored = original.restored(&original.save()).expect("what was saved");
    let mut clone = original.clone();
    for tick in 0..5000 {
        assert_eq!(restored.hashes(), original.hashes(), "{tick} ticks later");
        assert_eq!(clone.hashes(), original.hashes(), "{tick} ticks later");
        for game in [&mut original, &mut restored, &mut clone] {
            game.tick(blind_hands(game.ticks()));
        }
    }
}

#[test]
fn the_stream_of_a_tick_holds_its_events_and_contacts_and_a_hit_before_the_switch_that_it_closes() {
    let mut game = spectrum();
    let is_hit = |kind: &Kind| matches!(kind, Kind::Bumper(_) | Kind::Target(_) | Kind::DropTarget(_));
    let (mut contacts, mut hits) = (0, 0);
    for _ in 0..60_000 {
        game.tick(blind_hands(game.ticks()));
        let stream = game.tick_events();
        assert!(game.events().eq(game.machine().events()));
        assert!(stream.iter().filter_map(TickEvent::contact).eq(game.machine().contacts()));
        contacts += game.machine().contacts().len();
        for (place, event) in stream.iter().enumerate() {
            let Some(Event { part: Some(part), kind: EventKind::Closed }) = event.event() else { continue };
            if is_hit(&game.table().layout.parts[usize::from(part.0)].kind) {
                let before = place.checked_sub(1).and_then(|place| stream[place].contact());
                assert_eq!(before.and_then(|contact| contact.part), Some(*part), "tick {}", game.ticks());
                hits += 1;
            }
        }
    }
    assert!(contacts > 200 && hits > 20, "{contacts} contacts, {hits} hits");
}
