//! A function of the game that a script can call: what it works on, what it is given, and what a call costs.

use self::Searched::{Nothing, Progress, Timers};
use super::names::Names;
use super::part_commands::{Order, PartCommand};
use super::script::{Data, text_steps};
use super::script_state::ScriptState;
use crate::lamps::LampController;
use std::sync::Arc;

/// Longest time that a script can name, ms: a day.
const MAX_MS: i64 = 86_400_000;
/// Longest text that the game keeps for a script: a timer's name, a line of the display; bytes.
const MAX_KEPT: usize = 256;

/// What the game's functions work on while a script runs.
pub struct ScriptContext {
    /// Score, display, timers and orders.
    pub script: ScriptState,
    /// The lamps.
    pub lamps: LampController,
    /// The parts and lamps by name.
    pub names: Arc<Names>,
}

impl ScriptContext {
    /// The steps of an error: for a name that nobody knows, all names are searched for one like it.
    pub fn failure_steps(&self) -> u64 {
        128 * self.names.count() as u64
    }
}

/// What a function is given.
pub struct Arguments<'a> {
    name: &'static str,
    values: &'a [Data],
}

impl<'a> Arguments<'a> {
    /// How many values there are.
    pub fn count(&self) -> usize {
        self.values.len()
    }

    /// The whole number at this place.
    ///
    /// # Errors
    /// If it is something else.
    pub fn int(&self, place: usize) -> Result<i64, String> {
        match &self.values[place] {
            Data::Int(number) => Ok(*number),
            _ => Err(self.unfit()),
        }
    }

    /// The whole number at this place, if there is one.
    pub fn is_int(&self, place: usize) -> bool {
        matches!(self.values.get(place), Some(Data::Int(_)))
    }

    /// `true` or `false` at this place.
    ///
    /// # Errors
    /// If it is something else.
    pub fn flag(&self, place: usize) -> Result<bool, String> {
        match &self.values[place] {
            Data::Bool(flag) => Ok(*flag),
            _ => Err(self.unfit()),
        }
    }

    /// The text at this place.
    ///
    /// # Errors
    /// If it is something else.
    pub fn text(&self, place: usize) -> Result<&'a str, String> {
        match &self.values[place] {
            Data::Text(text) => Ok(text),
            _ => Err(self.unfit()),
        }
    }

    /// The text at this place, for the game to keep.
    ///
    /// # Errors
    /// If it is something else, or too long.
    pub fn kept(&self, place: usize) -> Result<&'a str, String> {
        let text = self.text(place)?;
        if text.len() > MAX_KEPT {
            return Err(format!("{} takes texts of at most {MAX_KEPT} bytes", self.name));
        }
        Ok(text)
    }

    /// A sentence: it cannot be called with these.
    pub fn unfit(&self) -> String {
        let types: Vec<&str> = self.values.iter().map(Data::type_name).collect();
        format!("{} cannot be called with ({})", self.name, types.join(", "))
    }
}

/// A function of the game.
#[derive(Clone, Copy, Debug)]
pub struct HostFunction {
    /// Its name.
    pub name: &'static str,
    /// How many values it takes at least.
    pub least: usize,
    /// How many values it takes at most.
    pub most: usize,
    /// What it goes through.
    pub searches: Searched,
    /// What it does.
    pub body: Body,
}

/// What a function goes through, one after the other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Searched {
    /// Nothing: at most names in their order.
    Nothing,
    /// The lamps.
    Lamps,
    /// The timers that run.
    Timers,
    /// The progress that is shown.
    Progress,
}

/// What a function does.
#[derive(Clone, Copy, Debug)]
pub enum Body {
    /// This.
    Call(fn(&mut ScriptContext, &Arguments) -> Result<Data, String>),
    /// It commands a part.
    Command(&'static PartCommand),
}

impl HostFunction {
    /// Whether it can be called with so many values.
    pub fn takes(&self, count: usize) -> bool {
        (self.least..=self.most).contains(&count)
    }

    /// The steps that a call takes.
    pub fn steps(&self, context: &ScriptContext, values: &[Data]) -> u64 {
        let texts = values.iter().filter_map(|value| match value {
            Data::Text(text) => Some(&**text),
            _ => None,
        });
        let name = texts.clone().next().unwrap_or_default();
        let searched = match self.searches {
            Searched::Lamps if name.ends_with('*') => context.names.count(),
            // A name is found among a thousand others with a dozen comparisons.
            Searched::Lamps | Nothing => 12,
            Timers => context.script.timers.count(),
            Progress => context.script.progress.len(),
        };
        let read: u64 = texts.map(|text| text_steps(text.len())).sum();
        2 + read + text_steps(name.len()) * searched as u64 / 4
    }

    /// Calls it.
    ///
    /// # Errors
    /// A sentence.
    pub fn call(&self, context: &mut ScriptContext, values: &[Data]) -> Result<Data, String> {
        let arguments = Arguments { name: self.name, values };
        match self.body {
            Body::Call(body) => body(context, &arguments),
            Body::Command(command) => command_part(context, command, &arguments),
        }
    }
}

/// A function.
pub const fn function(
    name: &'static str,
    (least, most): (usize, usize),
    searches: Searched,
    body: fn(&mut ScriptContext, &Arguments) -> Result<Data, String>,
) -> HostFunction {
    HostFunction { name, least, most, searches, body: Body::Call(body) }
}

/// A time that a script names.
///
/// # Errors
/// If it is longer than a day, or below 0.
pub fn time_ms(ms: i64) -> Result<u64, String> {
    match u64::try_from(ms) {
        Ok(time) if ms <= MAX_MS => Ok(time),
        _ => Err(format!("a time must be from 0 to {MAX_MS} ms, not {ms}")),
    }
}

fn command_part(context: &mut ScriptContext, command: &PartCommand, arguments: &Arguments) -> Result<Data, String> {
    let part = context.names.part_for(command, arguments.text(0)?)?;
    let order = match command.order {
        Order::Once(order) => order(part),
        Order::Switch(order) => order(part, arguments.flag(1)?),
    };
    ordered(context.script.order(order))
}

/// What an order gives, if there was room for it.
///
/// # Errors
/// If there was none.
pub fn ordered(room: bool) -> Result<Data, String> {
    room.then_some(Data::Unit).ok_or_else(|| "too many orders for the machine in one tick".to_string())
}
