//! The interpreter against Rhai's own engine: what a script leaves behind, and what it has told the game, is the same.

use super::random_script::random_script;
use super::twin::Twin;
use super::{PLENTY, context};
use crate::rules::host::ScriptContext;
use crate::rules::names::Names;
use crate::rules::script::data::{Data, Entries};
use crate::rules::script::{Failed, Meter, Script, text};
use crate::rules::script_state::ScriptState;
use crate::rules::value::Value;
use crate::lamps::LampController;
use crate::{Table, table};
use geometry::rng::SplitMix64;
use std::sync::Arc;

/// What a call left behind: what the script remembers, and all that the game knows of it.
#[derive(Debug, PartialEq)]
struct Left {
    failed: bool,
    this: String,
    state: ScriptState,
    lamps: String,
}

fn left(failed: bool, this: &Data, context: &ScriptContext) -> Left {
    let mut written = String::new();
    // A text of any length: what is longer than a script's text is written in parts.
    describe(this, &mut written);
    Left { failed, this: written, state: context.script.clone(), lamps: format!("{:?}", context.lamps) }
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

fn call(script: &Script, name: &str, arguments: &[&str], this: &mut Data, on: &mut ScriptContext) -> Option<Box<Failed>> {
    let number = (0..).zip(script.functions()).find(|(_, function)| function.name == name).expect("a function").0;
    let arguments = arguments.iter().map(Data::text).collect();
    script.call(number, arguments, this, on, &mut Meter::new(PLENTY)).err()
}

/// Runs `fn main()` in both; whether both were right about it and it did not fail.
fn agree(script: &str) -> bool {
    let own = Script::read(script);
    let twin = Twin::read(script).unwrap_or_else(|error| panic!("{script}\n{error}"));
    let Ok(own) = own else {
        // A name that nobody has defined is found before play here, and in play there.
        let answer = twin.call("main", &[], &mut Data::Map(Entries::new()), &mut context());
        assert!(answer.is_err(), "{script}\nis refused, but Rhai runs it: {:?}", own.err());
        return false;
    };
    let (mut own_this, mut own_context) = (Data::Map(Entries::new()), context());
    let failed = call(&own, "main", &[], &mut own_this, &mut own_context);
    let (mut twin_this, mut twin_context) = (Data::Map(Entries::new()), context());
    let error = twin.call("main", &[], &mut twin_this, &mut twin_context);
    let own_left = left(failed.is_some(), &own_this, &own_context);
    let twin_left = left(error.is_err(), &twin_this, &twin_context);
    assert!(own_left == twin_left, "{script}\nown  {own_left:#?}\n{failed:?}\nrhai {twin_left:#?}\n{error:?}");
    failed.is_none()
}

#[test]
fn every_expression_of_the_tests_has_the_value_that_rhai_gives_it() {
    for expression in super::language::expressions() {
        assert!(agree(&format!("fn main() {{ this.out = {expression}; }}")), "{expression} fails");
    }
}

#[test]
fn random_scripts_leave_behind_what_they_leave_in_rhai() {
    let mut sound = 0;
    for seed in 0..SCRIPTS {
        sound += u64::from(agree(&random_script(seed)));
    }
    assert!(sound > SCRIPTS / 4, "{sound} of {SCRIPTS} come to their end: the others say little");
}

/// Random scripts.
const SCRIPTS: u64 = 1500;

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
            own: Script::read(&table.rules).expect("sound rules"),
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
        assert!(own_left == twin_left, "{call_name} {arguments:?}: {own_left:#?}\n{failed:?}\n{twin_left:#?}\n{error:?}");
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
