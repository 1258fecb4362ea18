//! A review of the rules: what can be seen of them without play and is no reason not to play, as a name that nothing has.
//! A recording plays whatever its rules are; a table's maker wants to know.

mod arguments;
mod calls;
mod comparison;
mod consequences;
mod entry_values;
mod facts;
mod given;
mod handlers;
mod hidden;
mod known;
mod literal;
mod lost_ball;
mod memory;
mod messages;
mod names;
mod remark;
mod tilt;
mod timers;
mod types;
mod undone;
mod unlit;
mod unreached;
mod unused_value;
mod words;

#[cfg(test)]
mod tests;

pub use calls::{NO_START, is_kicker};
pub use messages::KnownMessage;

use super::host_function::ScriptContext;
use super::names::Names;
use super::program::Program;
use super::script::{UNCLOSED_COMMENT, open_comment};
use super::script_state::ScriptState;
use crate::lamps::LampController;
use crate::table::FILES;
use crate::{Failure, Table};
use facts::Facts;
use remark::Remark;
use std::sync::Arc;

/// Remarks that are worth reading at once.
const MAX_REMARKS: usize = 100;

/// What a review has found.
#[derive(Debug, Default)]
pub struct Review {
    /// Mistakes and warnings, with file and line.
    pub findings: Vec<Failure>,
    /// The messages that the rules show.
    pub messages: Vec<KnownMessage>,
}

impl Review {
    /// The review of a table's rules; nothing is said of rules that cannot be played at all.
    pub fn of(table: &Table) -> Review {
        let Ok(program) = Program::new(table) else { return Review::default() };
        let (script, names) = (program.script(), program.names());
        let facts = Facts::new(script);
        let lamps = LampController::new(table);
        let context = &mut ScriptContext { script: ScriptState::new(0), lamps, names: Arc::new(Names::new(table)) };
        let misspelt = handlers::misspelt(script, &table.rules);
        if !misspelt.is_empty() {
            // What such a function was to do is missing everywhere else.
            let findings = misspelt.iter().map(|remark| failure(remark, table)).collect();
            return Review { findings, messages: messages::messages(&facts, script) };
        }
        let hidden = hidden::remarks(script, &table.rules);
        // What the game's own function was to do is missing for that reason.
        let missing = |remarks: Vec<Remark>| if hidden.is_empty() { remarks } else { Vec::new() };
        let silent = timers::silent(&facts, script, &table.rules);
        let hears_timers = script.functions().any(|function| function.name == "on_timer");
        let calls = calls::remarks(&facts, names, if hears_timers { &silent } else { &[] });
        let joined = if hidden.is_empty() && calls::names_timer(&calls) { &silent[..] } else { &[] };
        let mut remarks = [
            hidden.clone(),
            names::remarks(&facts, names, &table.rules),
            timers::remarks(&facts, script, &table.rules, joined),
            memory::remarks(script),
            entry_values::remarks(script),
            comparison::remarks(script),
            missing(calls),
            missing(lost_ball::remarks(&facts, names, script, &table.rules)),
            missing(unlit::remark(&facts, names, script, &table.rules).into_iter().collect()),
            arguments::remarks(&facts, script, context),
            unreached::remarks(script, &table.rules),
            types::remarks(&facts, script, &table.rules),
            tilt::remark(&facts, script).into_iter().collect(),
            undone::remarks(script),
            unused_value::remarks(script),
            // What a comment has swallowed is missing for that reason.
            match open_comment(&table.rules) {
                Some(line) => vec![Remark::error(line, UNCLOSED_COMMENT)],
                None => calls::none(script).into_iter().collect(),
            },
        ]
        .concat();
        remarks.sort();
        remarks.dedup();
        remarks.truncate(MAX_REMARKS);
        let findings = remarks.iter().map(|remark| failure(remark, table)).collect();
        Review { findings, messages: messages::messages(&facts, script) }
    }
}

fn failure(remark: &Remark, table: &Table) -> Failure {
    let file = table.file(FILES[2]);
    let Remark { line, what, is_warning } = remark;
    let sentence = if *line == 0 { format!("{file}: {what}") } else { format!("{file}:{line}: {what}") };
    if *is_warning { Failure::warning(sentence) } else { Failure::new(sentence) }
}
