//! The interpreter against Rhai's own engine: what a script leaves behind, and what it has told the game, is the same.

use super::random_script::random_script;
use super::twin::Twin;
use super::{PLENTY, context, try_read};
use crate::lamps::LampController;
use crate::rules::host_function::ScriptContext;
use crate::rules::names::Names;
use crate::rules::script::data::{Data, Entries};
use crate::rules::script::library;
use crate::rules::script::{Failed, Meter, Script, text};
use crate::rules::script_state::ScriptState;
use crate::rules::value::Value;
use crate::{Table, table};
use geometry::rng::SplitMix64;
use rhai::EvalAltResult;
use std::sync::Arc;

/// What a call left behind: what the script remembers, and all that the game knows of it.
#[derive(Debug, PartialEq)]
struct Left {
    failed: bool,
    this: String,
    host: String,
}

fn left(failed: bool, this: &Data, context: &ScriptContext) -> Left {
    let mut written = String::new();
    // A text of any length: what is longer than a script's text is written in parts.
    describe(this, &mut written);
    Left { failed, this: written, host: format!("{:?} {:?}", context.script, context.lamps) }
}

fn describe(value: &Data, into: &mut String) {
    match value {
        Data::List(items) => {
            into.push('[');
            items.iter().for_each(|item| describe(item, into));
            into.push(']');
        }
        Data::Map(entries) => {
            into.push('{');
            for (key, value) in entries {
                into.push_str(key);
                describe(value, into);
            }
            into.push('}');
        }
        other => {
            let mut meter = Meter::new(PLENTY);
            let mut part = String::new();
            text::write(other, &mut part, &mut meter).expect("no longer than a text");
            into.push_str(&format!(" {}:{part}", other.type_name()));
        }
    }
}

fn call(
    script: &Script,
    name: &str,
    arguments: &[&str],
    this: &mut Data,
    on: &mut ScriptContext,
) -> Option<Box<Failed>> {
    let number = (0..).zip(script.functions()).find(|(_, function)| function.name == name).expect("a function").0;
    let arguments = arguments.iter().map(Data::text).collect();
    script.call(number, arguments, this, on, &mut Meter::new(PLENTY)).err()
}

/// Runs `fn main()` in both; whether it did not fail.
///
/// # Errors
/// How they differ.
fn agree(script: &str) -> Result<bool, String> {
    let own = try_read(script);
    let twin = Twin::read(script).unwrap_or_else(|error| panic!("{script}\n{error}"));
    let (mut twin_this, mut twin_context) = (Data::Map(Entries::new()), context());
    let error = twin.call("main", &[], &mut twin_this, &mut twin_context).err();
    if error.as_ref().is_some_and(|error| is_limit(error)) {
        return Ok(false);
    }
    let own = match own {
        Ok(own) => own,
        // What does not exist is found before play here, and in play there.
        Err(_) if error.is_some() => return Ok(false),
        Err(mistakes) => return Err(format!("{script}\nis refused, but Rhai runs it: {mistakes:?}")),
    };
    let (mut own_this, mut own_context) = (Data::Map(Entries::new()), context());
    let failed = call(&own, "main", &[], &mut own_this, &mut own_context);
    let own_left = left(failed.is_some(), &own_this, &own_context);
    let twin_left = left(error.is_some(), &twin_this, &twin_context);
    if own_left == twin_left {
        return Ok(failed.is_none());
    }
    Err(format!("{script}\nleaves {own_left:?}\n{failed:?}\nand in Rhai {twin_left:?}\n{error:?}"))
}

/// Whether Rhai has met a limit of its own: it counts other things, and elsewhere.
fn is_limit(error: &EvalAltResult) -> bool {
    matches!(
        error.unwrap_inner(),
        EvalAltResult::ErrorTooManyOperations(_)
            | EvalAltResult::ErrorDataTooLarge(..)
            | EvalAltResult::ErrorStackOverflow(_)
    )
}

#[test]
fn every_expression_of_the_tests_has_the_value_that_rhai_gives_it() {
    let script = |expression| format!("fn main() {{ this.out = {expression}; }}");
    let answers = super::language::expressions().map(|expression| agree(&script(expression)));
    let wrong: Vec<String> = answers.filter(|answer| *answer != Ok(true)).map(|answer| format!("{answer:?}")).collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Something of every type.
const VALUES: [&str; 13] =
    ["()", "true", "false", "1", "-3", "\"a\"", "\"\"", "[1]", "[]", "#{}", "#{ a: 1 }", "0..3", "1..=2"];

/// What can stand between two values.
const SIGNS: [&str; 23] = [
    "+", "-", "*", "/", "%", "**", "<<", ">>", "&", "|", "^", "==", "!=", "<", "<=", ">", ">=", "&&", "||", "??", "in",
    "!in", "..",
];

#[test]
fn every_operator_between_any_two_values_does_what_it_does_in_rhai() {
    let mut wrong = Vec::new();
    for (left, right) in VALUES.iter().flat_map(|left| VALUES.iter().map(move |right| (left, right))) {
        // Rhai has two types of ranges, which it cannot compare with each other.
        let ranges = left.contains("..") && right.contains("..") && left != right;
        // And a text that is taken away from an empty one is what is left.
        let empty = *left == "\"\"" && *right == "\"a\"";
        let has_twin = |sign: &&str| !(ranges && sign.contains(['=', '<', '>']) || empty && *sign == "-");
        let mut body = String::new();
        for sign in SIGNS.into_iter().filter(has_twin) {
            body += &attempt(&format!("this.out.push(a {sign} b);"));
            if SIGNS[..11].contains(&sign) {
                body += &attempt(&format!("let c = a; c {sign}= b; this.out.push(c);"));
            }
        }
        let script = format!("fn main() {{ this.out = []; let a = {left}; let b = {right}; {body} }}");
        wrong.extend(agree(&script).err());
    }
    assert!(wrong.is_empty(), "{} differ\n{}", wrong.len(), wrong.join("\n"));
}

/// Does something, or notes that it cannot be done.
fn attempt(what: &str) -> String {
    format!("try {{ {what} }} catch {{ this.out.push(\"no\"); }}\n")
}

/// Functions that have no twin by this name, or give there what cannot be compared.
const NO_TWIN: [&str; 2] = ["chars", "range"];

/// Whether the interpreter will have nothing of a function called so.
fn is_refused(script: &str) -> bool {
    let Ok(script) = try_read(script) else { return true };
    let failed = call(&script, "main", &[], &mut Data::Map(Entries::new()), &mut context());
    failed.is_some_and(|failed| failed.sentence("").contains(" cannot be called with "))
}

/// What is refused gives no value, so it cannot give another: Rhai has more functions, and more values to call them on.
#[test]
fn every_function_called_on_any_value_does_what_it_does_in_rhai_or_is_refused() {
    let mut wrong = Vec::new();
    let mut compared = 0;
    let arguments = ["", "2", "-1", "\"a\"", "[1]", "#{ a: 5 }", "1, 1", "0, \"b\"", "\"a\", \"b\"", "|x| x == 1"];
    for function in library::all().filter(|function| !NO_TWIN.contains(&function.name)) {
        for (value, given) in VALUES.iter().flat_map(|value| arguments.iter().map(move |given| (value, given))) {
            let call = format!("a.{}({given})", function.name);
            let script = format!("fn main() {{ let a = {value}; this.out = [{call}, a]; }}");
            if !is_refused(&script) {
                compared += 1;
                wrong.extend(agree(&script).err());
            }
        }
    }
    assert!(wrong.is_empty(), "{} differ\n{}", wrong.len(), wrong.join("\n"));
    assert!(compared > 300, "{compared} calls are not refused");
}

#[test]
fn random_scripts_leave_behind_what_they_leave_in_rhai() {
    let answers: Vec<_> = (0..SCRIPTS).map(|seed| agree(&random_script(seed))).collect();
    let mut wrong: Vec<&String> = answers.iter().filter_map(|answer| answer.as_ref().err()).collect();
    wrong.sort_by_key(|report| report.len());
    assert!(
        wrong.is_empty(),
        "{} differ; the shortest:\n{}",
        wrong.len(),
        wrong.into_iter().take(12).cloned().collect::<Vec<_>>().join("\n\n")
    );
    let sound = answers.iter().filter(|answer| **answer == Ok(true)).count();
    assert!(sound > SCRIPTS as usize / 4, "{sound} of {SCRIPTS} come to their end: the others say little");
}

/// Random scripts.
const SCRIPTS: u64 = 1000;

/// A table's rules in both engines, told of the same events.
struct Pair {
    own: Script,
    twin: Twin,
    this: [Data; 2],
    contexts: [ScriptContext; 2],
}

impl Pair {
    fn new(table: &Table) -> Pair {
        let names = Arc::new(Names::new(table));
        let context = || {
            let (script, lamps) = (ScriptState::new(1), LampController::new(table));
            ScriptContext { script, lamps, names: names.clone() }
        };
        Pair {
            own: try_read(&table.rules).expect("sound rules"),
            twin: Twin::read(&table.rules).expect("sound rules"),
            this: [Data::Map(Entries::new()), Data::Map(Entries::new())],
            contexts: [context(), context()],
        }
    }

    /// Tells both of an event, so many ms after the one before, with so many balls in play.
    fn tell(&mut self, call_name: &str, arguments: &[&str], ms: u64, balls: u32) {
        for context in &mut self.contexts {
            context.script.now += ms;
            context.script.balls = balls;
            context.script.owed = 0;
            context.script.commands.clear();
        }
        let [own_this, twin_this] = &mut self.this;
        let [own_context, twin_context] = &mut self.contexts;
        let failed = call(&self.own, call_name, arguments, own_this, own_context);
        let error = self.twin.call(call_name, arguments, twin_this, twin_context);
        let own_left = left(failed.is_some(), own_this, own_context);
        let twin_left = left(error.is_err(), twin_this, twin_context);
        assert!(
            own_left == twin_left,
            "{call_name} {arguments:?}: {own_left:#?}\n{failed:?}\n{twin_left:#?}\n{error:?}"
        );
        assert!(failed.is_none(), "{call_name} {arguments:?}: {failed:?}");
        let remembered = std::mem::take(own_this);
        *own_this = Value::from_script(remembered).expect("what can be remembered").to_script();
    }

    /// The name of a timer that is due, taken in both.
    fn due(&mut self) -> Option<String> {
        let [own, twin] = &mut self.contexts;
        let now = own.script.now;
        let due = own.script.timers.take_due(now);
        assert_eq!(due, twin.script.timers.take_due(now));
        due
    }
}

#[test]
fn spectrums_rules_do_what_they_do_in_rhai() {
    let table = table::tests::spectrum();
    let mut pair = Pair::new(&table);
    let parts: Vec<&str> = table.layout.parts.iter().map(|part| &*part.name).filter(|name| !name.is_empty()).collect();
    let buttons = ["left", "right", "start", "plunger", "nudge-left"];
    let mut chance = SplitMix64::new(5);
    pair.tell("on_start", &[], 0, 0);
    for _ in 0..4000 {
        let (ms, balls) = (chance.below(900), chance.below(3) as u32);
        let part = parts[chance.below(parts.len() as u64) as usize];
        match chance.below(40) {
            0 => pair.tell("on_button", &["start"], ms + 3000, balls),
            1..4 => pair.tell("on_button", &[buttons[chance.below(5) as usize]], ms, balls),
            4 => pair.tell("on_launch", &[], ms, balls),
            5 => pair.tell("on_feed", &[], ms, balls),
            6 if chance.below(8) == 0 => pair.tell("on_bob", &[], ms, balls),
            7 if chance.below(40) == 0 => pair.tell("on_slam", &[], ms, balls),
            8 if chance.below(4) == 0 => pair.tell("on_switch", &["drain"], ms, 0),
            _ if part != "drain" => pair.tell("on_switch", &[part], ms, balls),
            _ => {}
        }
        while let Some(timer) = pair.due() {
            pair.tell("on_timer", &[&timer], 0, balls);
        }
    }
    assert!(pair.contexts[0].script.score.scores.iter().any(|score| *score > 100_000), "games were played");
}
