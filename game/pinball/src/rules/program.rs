//! A compiled script: shared by every simulation of its table.

use super::handlers;
use super::host_function::ScriptContext;
use super::literal_names::unknown_names;
use super::memory::Memory;
use super::names::Names;
use super::script::{Data, Failed, Meter, Script, UNCLOSED_COMMENT, open_comment, too_many};
use super::script_state::ScriptState;
use super::value::Value;
use super::work::Work;
use crate::lamps::LampController;
use crate::table::LIMITS_BYTES;
use crate::{Failure, Table};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Steps that every call takes, whatever it does.
const CALL_STEPS: u64 = 20;
/// Bytes of what a script remembers that take a step: they are read before each call, and written behind it.
const STEP_BYTES: usize = 2;

/// A script that has been read and found good.
pub struct Program {
    script: Script,
    /// The functions that are called when something happens: number, and the line on which they begin.
    calls: BTreeMap<String, (u16, usize)>,
    names: Arc<Names>,
    file: String,
}

/// Mistakes of a script that are worth reading at once.
const MAX_MISTAKES: usize = 100;

/// What a script is told.
#[derive(Clone, Copy)]
pub struct Happening<'a> {
    /// The function that is called.
    pub call: &'a str,
    /// What it is told: a part, a button, a timer.
    pub name: Option<&'a str>,
}

impl Program {
    /// Reads the rules of a table.
    ///
    /// # Errors
    /// Every mistake that can be seen without playing, one line each with file and line.
    pub fn new(table: &Table) -> Result<Program, Failure> {
        let file = table.file("rules.rhai");
        let names = Arc::new(Names::new(table));
        if table.rules.len() as u64 > LIMITS_BYTES[2] {
            return Err(Failure::new(format!("{file}: it is larger than {} kB", LIMITS_BYTES[2] / 1024)));
        }
        if let Some((line, what)) = too_many(&table.rules) {
            return Err(Failure::new(format!("{file}:{line}: {what}")));
        }
        let (script, mut mistakes) = Script::read(&table.rules);
        handlers::tell(&script, &table.rules, &mut mistakes);
        mistakes.extend(unknown_names(&script, &names));
        if !mistakes.is_empty() {
            // What an endless comment has swallowed is missing everywhere else.
            if let Some(line) = open_comment(&table.rules) {
                mistakes = vec![(line, UNCLOSED_COMMENT.to_string())];
            }
            mistakes.sort();
            mistakes.dedup();
            let mistakes =
                mistakes.iter().take(MAX_MISTAKES).map(|(line, what)| Failure::new(format!("{file}:{line}: {what}")));
            return Err(Failure::of_many(mistakes.collect()));
        }
        let numbered = script.functions().zip(0..).filter(|(function, _)| handlers::is_handler(&function.name));
        let call = |name: &str, number| (name.to_string(), (number, handlers::line_of_function(name, &table.rules)));
        let calls = numbered.map(|(function, number)| call(&function.name, number)).collect();
        Ok(Program { script, calls, names, file })
    }

    /// What was read.
    pub fn script(&self) -> &Script {
        &self.script
    }

    /// The parts and lamps.
    pub fn names(&self) -> &Names {
        &self.names
    }

    /// Whether the script wants to hear of this.
    pub fn has(&self, call: &str) -> bool {
        self.calls.contains_key(call)
    }

    /// Tells the script what happened. What it did before an error stays done.
    ///
    /// # Errors
    /// A sentence with file and line.
    pub fn call(
        &self,
        happening: Happening,
        memory: &mut Memory,
        script: &mut ScriptState,
        lamps: &mut LampController,
        meter: &mut Meter,
    ) -> Result<(), String> {
        let Some((function, line)) = self.calls.get(happening.call).copied() else {
            return Ok(());
        };
        let steps = CALL_STEPS + (memory.bytes().len() / STEP_BYTES) as u64;
        if meter.charge(steps).is_err() {
            return Err(format!("{}:{line}: {}", self.file, spent()));
        }
        let mut this = memory.value().to_script();
        let (own_script, own_lamps) = (std::mem::take(script), std::mem::take(lamps));
        let mut context = ScriptContext { script: own_script, lamps: own_lamps, names: self.names.clone() };
        let arguments = happening.name.map(Data::text).into_iter().collect();
        let answer = self.script.call(function, arguments, &mut this, &mut context, meter);
        (*script, *lamps) = (context.script, context.lamps);
        let call = happening.call;
        let answer = answer.map_err(|failed| self.sentence(&failed, line, &this));
        memory.set(Value::from_script(this).map_err(|what| {
            format!("{}:{line}: after {call}, `this` holds {what}, which cannot be remembered", self.file)
        })?);
        answer
    }

    fn sentence(&self, failed: &Failed, called: usize, this: &Data) -> String {
        let line = if failed.line == 0 { called } else { failed.line as usize };
        format!("{}:{line}: {}", self.file, failed.told(&spent(), this))
    }
}

fn spent() -> String {
    format!(
        "this does not come to an end, or does too much at once (the rules may take {} steps in a second)",
        Work::most(1000)
    )
}
