//! The language by itself, without a game.

mod agreement;
mod cost;
mod language;
mod random_script;
mod syntax_errors;
mod twin;

use super::{Data, Failed, Meter, Mistake, Script, Stop};
use crate::lamps::LampController;
use crate::rules::host_function::ScriptContext;
use crate::rules::names::Names;
use crate::rules::script_state::ScriptState;
use crate::rules::tests::bench::table;
use std::sync::Arc;

/// More steps than any test needs.
const PLENTY: u64 = 100_000_000;

/// A game that nobody plays.
fn context() -> ScriptContext {
    let table = table("", &["lane", "saucer", "drop-1"], &["red", "green"]);
    let lamps = LampController::new(&table);
    ScriptContext { script: ScriptState::new(1), lamps, names: Arc::new(Names::new(&table)) }
}

fn read(text: &str) -> Script {
    try_read(text).unwrap_or_else(|mistakes| panic!("{text}: {mistakes:?}"))
}

fn try_read(text: &str) -> Result<Script, Vec<Mistake>> {
    let (script, mistakes) = Script::read(text);
    if mistakes.is_empty() { Ok(script) } else { Err(mistakes) }
}

/// Runs `fn main()` with a map as `this`; what is in its `out` afterwards, as a text, or the failure's line and
/// sentence.
fn run(text: &str) -> Result<String, (u32, String)> {
    let script = read(text);
    let number = (0..).zip(script.functions()).find(|(_, function)| function.name == "main").expect("a main").0;
    let mut meter = Meter::new(PLENTY);
    let mut this = Data::Map(Default::default());
    let told = |failed: Box<Failed>| (failed.line, failed.sentence("spent"));
    script.call(number, Vec::new(), &mut this, &mut context(), &mut meter).map_err(told)?;
    let Data::Map(entries) = this else { panic!("a map") };
    let mut out = String::new();
    match entries.get("out") {
        None | Some(Data::Unit) => out.push_str("()"),
        Some(value) => super::text::write(value, &mut out, &mut meter).expect("a short text"),
    }
    Ok(out)
}

/// The value of an expression, as a text.
fn value(expression: &str) -> String {
    run(&format!("fn main() {{ this.out = {expression}; }}")).unwrap_or_else(|(_, what)| what)
}

/// The steps that something takes; nothing if it fails.
fn steps(call: impl FnOnce(&mut super::Interpreter) -> Result<Data, Stop>, script: &Script) -> Option<(Data, u64)> {
    let mut meter = Meter::new(PLENTY);
    let mut context = context();
    let mut interpreter = super::Interpreter { script, meter: &mut meter, context: Some(&mut context), calls: 0 };
    let answer = call(&mut interpreter).ok()?;
    Some((answer, meter.spent()))
}
