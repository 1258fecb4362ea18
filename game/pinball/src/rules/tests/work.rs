//! How much the rules may work: what froze the game for minutes ends after a number of steps, the same everywhere.

use super::bench::{Bench, table};
use crate::lamps::LampController;
use crate::rules::work::{MAX_DEBT, SILENT_DEBT, TICK_STEPS, Work};
use crate::rules::{Program, Rules, State, TickInput};
use crate::{Buttons, Table};
use physics::Fingerprint;
use std::sync::Arc;

const SPENT: &str =
    "this does not come to an end, or does too much at once (the rules may take 1000000 steps in a second)";

/// What a script with this `on_launch` complains about, and the steps that its first call takes.
fn launched(body: &str) -> (Vec<String>, u64) {
    let mut bench = Bench::new(table(&format!("fn on_launch() {{\n  {body}\n}}"), &["plunger"], &[])).expect("sound");
    bench.launch();
    (bench.rules.take_complaints(), bench.rules.state().work.debt() + TICK_STEPS)
}

/// Each took 10 to 92 seconds for one event, and a limit of 200,000 operations did not see it: the work was inside of
/// the functions of lists and maps, which were one operation each.
#[test]
fn work_inside_of_functions_is_counted() {
    for body in [
        "let a = []; a.pad(4096, 1); loop { a.map(|x| x); }",
        "let a = []; for i in 0..4096 { a.push(i); } loop { a.dedup(); a.index_of(-1); }",
        "let m = #{}; for i in 0..4096 { m[`${i}`] = i; } loop { let copy = m; }",
        "let t = \"\"; t.pad(4096, \"a\"); loop { t.contains(\"ab\"); }",
        "let name = \"no such lamp\"; loop { try { lamp(name, \"on\"); } catch {} }",
        "loop {}",
    ] {
        let (complaints, steps) = launched(body);
        assert_eq!(complaints, [format!("bench/rules.rhai:2: {SPENT}")], "{body}");
        assert_eq!(steps, MAX_DEBT, "{body}: all that there was, and no more");
    }
}

/// The panic of Rust's sort was printed on the way to the sentence; the sort of the rules has none.
#[test]
fn a_sort_by_chance_is_one_sentence() {
    let (complaints, _) =
        launched("let a = []; for i in 0..200 { a.push(random(100)); } a.sort(|x, y| random(3) - 1);");
    let what = "sort's function contradicts itself: of the same two values now one goes first, now the other";
    assert_eq!(complaints, [format!("bench/rules.rhai:2: {what}")]);
}

/// A table whose rules work without end whenever a button goes down.
fn busy() -> Arc<Table> {
    let rules =
        "fn on_button(name) { this.n = now(); loop { this.n += 1; } } fn on_release(name) { this.calm = now(); }";
    Arc::new(table(rules, &["plunger"], &["red"]))
}

fn press(rules: &mut Rules, lamps: &mut LampController, now: u64) {
    let (before, buttons) =
        if now.is_multiple_of(2) { (Buttons::NONE, Buttons::LEFT) } else { (Buttons::LEFT, Buttons::NONE) };
    rules.tick(&TickInput { now, buttons, before, events: &[], balls: Vec::new }, lamps);
}

#[test]
fn a_thousand_ticks_never_take_more_than_their_steps() {
    let table = busy();
    let mut lamps = LampController::new(&table);
    let mut rules = Rules::new(Arc::new(Program::new(&table).expect("sound")), 1, &mut lamps).expect("sound");
    let mut taken = Vec::new();
    for now in 1..=2500 {
        let before = rules.state().work.debt();
        press(&mut rules, &mut lamps, now);
        let after = rules.state().work.debt();
        taken.push(if after == 0 { 0 } else { after + TICK_STEPS - before });
    }
    let most = taken.windows(1000).map(|window| window.iter().sum::<u64>()).max().expect("windows");
    assert!(most > MAX_DEBT && most <= Work::most(1000), "{most}");
}

#[test]
fn rules_that_owe_go_on_from_a_save_as_they_would_have() {
    let table = busy();
    let program = Arc::new(Program::new(&table).expect("sound"));
    let mut lamps = LampController::new(&table);
    let mut rules = Rules::new(program.clone(), 1, &mut lamps).expect("sound");
    for now in 1..100 {
        press(&mut rules, &mut lamps, now);
    }
    let bytes = postcard::to_stdvec(rules.state()).expect("plain data");
    let state: State = postcard::from_bytes(&bytes).expect("what was written");
    let (mut restored, mut other_lamps) = (Rules::restored(program, state), lamps.clone());
    for now in 100..300 {
        press(&mut rules, &mut lamps, now);
        press(&mut restored, &mut other_lamps, now);
        assert_eq!(rules.state(), restored.state(), "tick {now}");
    }
}

#[test]
fn a_large_debt_is_in_the_hash_and_a_small_one_leaves_it_as_it_was() {
    let hash = |work: Work| {
        let mut fingerprint = Fingerprint::default();
        work.add_to(&mut fingerprint);
        fingerprint.finish()
    };
    let none = Fingerprint::default().finish();
    let mut work = Work::default();
    work.add(SILENT_DEBT);
    assert_eq!(hash(work), none);
    work.add(1);
    let one = hash(work);
    assert_ne!(one, none);
    work.add(1);
    assert_ne!(hash(work), one);
    work.end_tick();
    assert_eq!(hash(work), none, "and is paid back");
    assert_eq!(work.debt(), SILENT_DEBT + 2 - TICK_STEPS);
}

#[test]
fn after_an_endless_event_the_game_goes_on() {
    let rules =
        "fn on_launch() { loop {} } fn on_switch(name) { this.n = 1; score(10); } fn on_start() { start_game(3); }";
    let mut bench = Bench::new(table(rules, &["plunger", "lane"], &[])).expect("sound");
    bench.launch();
    for _ in 0..20 {
        bench.hit("lane");
    }
    assert_eq!(bench.score(), 200);
    assert_eq!(bench.rules.take_complaints().len(), 1);
}
