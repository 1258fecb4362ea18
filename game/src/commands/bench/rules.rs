//! What the most work that rules may do takes: scripts that never come to an end, told of a button in every tick.

use super::Row;
use super::clock::time_ms;
use crate::lamps::LampController;
use crate::rules::{Program, Rules, TickInput, Work};
use crate::storage::{assets, recordings, tables};
use crate::{Buttons, Failure};
use std::sync::Arc;

/// Ticks that are played: a second.
const TICKS: u64 = 1000;

/// What a script does without end: a name, what it does before, and what it does again and again.
const LOOPS: [(&str, &str, &str); 21] = [
    ("counting", "let n = 0;", "n += 1;"),
    ("calls", "", "f(1);"),
    ("a list copied", "let a = []; a.pad(4096, 1);", "let b = a;"),
    ("a list of lists copied", "let b = []; b.pad(8, 1); let a = []; a.pad(400, b);", "let b = a;"),
    ("a list compared", "let a = []; a.pad(4096, 1); let b = a;", "a == b;"),
    ("a list searched", "let a = []; a.pad(4096, \"aaaaaaaaaaaaaaaa\");", "a.contains(\"aaaaaaaaaaaaaaab\");"),
    ("a list mapped", "let a = []; a.pad(4096, 1);", "a.map(|x| x);"),
    ("a list sorted", "let a = []; for i in 0..2000 { a.push(random(9999)); }", "let b = a; b.sort();"),
    ("a list sorted by a function", "let a = []; for i in 0..200 { a.push(random(9999)); }", "a.sort(|x, y| y - x);"),
    ("a list pushed along", "let a = []; a.pad(4095, 1);", "a.insert(0, 1); a.pop();"),
    ("a list made by lists", "let a = [];", "a = [a.len(), [1, 2, 3], [4, 5, 6]];"),
    ("a map copied", "let m = #{}; for i in 0..2000 { m[`a long key number ${i}`] = i; }", "let b = m;"),
    ("a map looked up", "let m = #{}; for i in 0..2000 { m[`${i}`] = i; } let k = \"1234\";", "m[k];"),
    ("a map made", "", "#{ a: 1, b: 2, c: 3, d: 4, e: 5, f: 6 };"),
    (
        "a text searched",
        "let t = \"\"; t.pad(4096, \"a\"); let s = \"\"; s.pad(64, \"a\"); s += \"b\";",
        "t.contains(s);",
    ),
    ("a text split", "let t = \"\"; t.pad(4096, \"a \");", "t.split(\" \");"),
    ("a text gone through", "let t = \"\"; t.pad(4096, \"ab\");", "for c in t {}"),
    ("a text written", "let t = 0;", "t = `${[1, 2, 3]} and ${true}`;"),
    ("all lamps set", "", "lamp(\"*\", \"on\");"),
    ("an unknown lamp", "let name = \"no-such-lamp-as-this\";", "try { lamp(name, \"on\"); } catch {}"),
    ("timers", "for i in 0..200 { after(9999, `timer number ${i}`); }", "running(\"timer number x\");"),
];

/// The most steps that a tick of the demos takes, and what plays each script for a second.
///
/// # Errors
/// If Spectrum cannot be read, or a script is not as this file means it.
pub fn rows() -> Result<Vec<Row>, Failure> {
    let mut rows = vec![demos()?];
    let mut table = tables::load("spectrum").map_err(Failure::of_many)?;
    for (name, before, again) in LOOPS {
        let on_button = format!("fn on_button(name) {{ {before} loop {{ {again} }} }}");
        table.rules = format!("fn f(x) {{ x }} {on_button} fn on_release(name) {{ on_button(name); }}");
        let mut lamps = LampController::new(&table);
        let mut rules = Rules::new(Arc::new(Program::new(&table)?), 1, &mut lamps)?;
        let ms = time_ms(|| (1..=TICKS).for_each(|now| press(&mut rules, &mut lamps, now)));
        if let Some(other) = rules.take_complaints().iter().find(|complaint| !complaint.contains("come to an end")) {
            return Err(Failure::new(format!("the bench's rules \"{name}\" are wrong: {other}")));
        }
        let variant = format!("{name}, {} steps", Work::most(TICKS));
        rows.push(Row { bench: "rules", variant, threads: 1, ms, ..Row::default() });
    }
    Ok(rows)
}

/// The demos: how much of what a tick has their rules need.
fn demos() -> Result<Row, Failure> {
    let (mut most, mut owed) = (0, 0);
    let mut ticks = 0;
    let mut simulations = Vec::new();
    for path in assets::demos()? {
        let recording = recordings::read(&path)?;
        let simulation = recordings::start(&recording).map_err(|failure| failure.in_file(path.display()))?;
        simulations.push((recording, simulation));
    }
    let ms = time_ms(|| {
        for (recording, simulation) in &mut simulations {
            for tick in 0..recording.ticks() {
                simulation.tick(recording.buttons(tick));
                most = most.max(simulation.rule_steps());
                owed = owed.max(simulation.rule_debt());
            }
            ticks += recording.ticks();
        }
    });
    let variant = format!("the demos, a tick: at most {most} steps, {owed} owed of {}", Work::most(0));
    Ok(Row { bench: "rules", variant, threads: 1, ms: ms / ticks as f64, ..Row::default() })
}

/// A tick in which the left button goes down or up.
fn press(rules: &mut Rules, lamps: &mut LampController, now: u64) {
    let (down, up) = (Buttons::LEFT, Buttons::NONE);
    let (before, buttons) = if now.is_multiple_of(2) { (up, down) } else { (down, up) };
    rules.tick(&TickInput { now, buttons, before, events: &[], balls: Vec::new }, lamps);
}
