//! The functions of the game that a script can call. `assets/tables/README.md` tells them to table makers.

use self::Searched::{Nothing, Progress, Timers};
use super::host_lamps;
use super::names::Names;
use super::part_commands::{Order, PART_COMMANDS, PartCommand};
use super::score::{MAX_BALLS, MAX_PLAYERS};
use super::script::{Data, text_steps};
use super::script_state::ScriptState;
use crate::lamps::LampController;
use physics::Command;
use std::sync::{Arc, LazyLock};

/// Longest time that a script can name, ms: a day.
const MAX_MS: i64 = 86_400_000;
/// Most things whose progress is shown.
const MAX_PROGRESS: usize = 64;
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
    fn kept(&self, place: usize) -> Result<&'a str, String> {
        let text = self.text(place)?;
        if text.len() > MAX_KEPT {
            return Err(format!("{} takes texts of at most {MAX_KEPT} bytes", self.name));
        }
        Ok(text)
    }

    fn unfit(&self) -> String {
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

/// Every function.
static FUNCTIONS: LazyLock<Vec<HostFunction>> = LazyLock::new(|| {
    let commands = PART_COMMANDS.iter().map(|command| {
        let count = 1 + usize::from(matches!(command.order, Order::Switch(_)));
        let body = Body::Command(command);
        HostFunction { name: command.word, least: count, most: count, searches: Nothing, body }
    });
    let own = [&SCORE[..], &FLOW, &DISPLAY, &TIME, &MACHINE, &host_lamps::FUNCTIONS].concat();
    own.into_iter().chain(commands).collect()
});

/// The function of this name.
pub fn named(name: &str) -> Option<&'static HostFunction> {
    FUNCTIONS.iter().find(|function| function.name == name)
}

/// Every function.
pub fn all() -> impl Iterator<Item = &'static HostFunction> {
    FUNCTIONS.iter()
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

static SCORE: [HostFunction; 7] = [
    function("score", (0, 1), Nothing, |context, arguments| match arguments.count() {
        0 => {
            let score = &context.script.score;
            Ok(Data::Int(score.scores.get(score.player).copied().unwrap_or(0)))
        }
        _ => {
            context.script.score.add(arguments.int(0)?);
            Ok(Data::Unit)
        }
    }),
    function("scores", (0, 0), Nothing, |context, _| {
        Ok(Data::List(context.script.score.scores.iter().map(|score| Data::Int(*score)).collect()))
    }),
    function("player", (0, 0), Nothing, |context, _| Ok(Data::count(context.script.score.player))),
    function("players", (0, 0), Nothing, |context, _| Ok(Data::count(context.script.score.scores.len()))),
    function("ball", (0, 0), Nothing, |context, _| Ok(Data::Int(i64::from(context.script.score.ball)))),
    function("playing", (0, 0), Nothing, |context, _| Ok(Data::Bool(context.script.score.playing))),
    function("tilted", (0, 0), Nothing, |context, _| Ok(Data::Bool(context.script.score.tilted))),
];

static FLOW: [HostFunction; 6] = [
    function("start_game", (1, 1), Nothing, |context, arguments| {
        let balls = arguments.int(0)?;
        if !(1..=i64::from(MAX_BALLS)).contains(&balls) {
            return Err(format!("a game has 1 to {MAX_BALLS} balls, not {balls}"));
        }
        context.script.score.start(balls as u32);
        Ok(Data::Unit)
    }),
    function("add_player", (0, 0), Nothing, |context, _| Ok(Data::Bool(context.script.score.add_player()))),
    function("next_player", (0, 0), Nothing, |context, _| Ok(Data::Bool(context.script.score.next_player()))),
    function("game_over", (0, 0), Nothing, |context, _| {
        context.script.score.game_over();
        Ok(Data::Unit)
    }),
    function("tilt", (1, 1), Nothing, |context, arguments| {
        let on = arguments.flag(0)?;
        context.script.score.tilted = on && context.script.score.playing;
        if on { power(context, Some(false), Some(false)) } else { Ok(Data::Unit) }
    }),
    function("max_players", (0, 0), Nothing, |_, _| Ok(Data::count(MAX_PLAYERS))),
];

static DISPLAY: [HostFunction; 2] = [
    function("message", (0, 3), Nothing, |context, arguments| {
        let lines = arguments.count().saturating_sub(1);
        let lines = (0..lines).map(|line| arguments.kept(line)).collect::<Result<Vec<&str>, String>>()?;
        let ms = if arguments.count() == 0 { 0 } else { arguments.int(arguments.count() - 1)? };
        // A time alone would be no message.
        if arguments.count() == 1 {
            return Err(arguments.unfit());
        }
        let duration_ms = time_ms(ms)?;
        let lines = lines.into_iter().filter(|line| !line.is_empty());
        context.script.show_message(lines.map(ToString::to_string).collect(), duration_ms);
        Ok(Data::Unit)
    }),
    function("progress", (3, 3), Progress, progress),
];

/// Shows, changes or (with `of` 0) forgets the progress of something.
fn progress(context: &mut ScriptContext, arguments: &Arguments) -> Result<Data, String> {
    let (name, done, of) = (arguments.kept(0)?, arguments.int(1)?, arguments.int(2)?);
    let shown = &mut context.script.progress;
    match shown.iter().position(|(other, ..)| other == name) {
        Some(index) if of == 0 => {
            shown.remove(index);
        }
        Some(index) => shown[index] = (name.to_string(), done, of),
        None if of == 0 => {}
        None if shown.len() >= MAX_PROGRESS => {
            return Err(format!("no more than {MAX_PROGRESS} things can show their progress"));
        }
        None => shown.push((name.to_string(), done, of)),
    }
    Ok(Data::Unit)
}

static TIME: [HostFunction; 6] = [
    function("after", (2, 2), Timers, |context, arguments| {
        let (ms, timer) = (arguments.int(0)?, arguments.kept(1)?);
        let due = context.script.now + time_ms(ms)?.max(1);
        let started = context.script.timers.start(timer, due);
        started.then_some(Data::Unit).ok_or_else(|| format!("too many timers run to start \"{timer}\""))
    }),
    function("cancel", (1, 1), Timers, |context, arguments| {
        context.script.timers.cancel(arguments.text(0)?);
        Ok(Data::Unit)
    }),
    function("running", (1, 1), Timers, |context, arguments| {
        Ok(Data::Bool(context.script.timers.due(arguments.text(0)?).is_some()))
    }),
    function("time_left", (1, 1), Timers, |context, arguments| {
        let due = context.script.timers.due(arguments.text(0)?).unwrap_or(0);
        Ok(Data::Int(due.saturating_sub(context.script.now) as i64))
    }),
    function("now", (0, 0), Nothing, |context, _| Ok(Data::Int(context.script.now as i64))),
    function("random", (1, 1), Nothing, |context, arguments| {
        let count = arguments.int(0)?;
        match u64::try_from(count) {
            Ok(count) if count > 0 => Ok(Data::Int(context.script.random.below(count) as i64)),
            _ => Err(format!("random needs a number above 0, not {count}")),
        }
    }),
];

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

static MACHINE: [HostFunction; 6] = [
    function("exists", (1, 1), Nothing, |context, arguments| Ok(Data::Bool(context.names.exists(arguments.text(0)?)))),
    function("closed", (1, 1), Nothing, |context, arguments| {
        Ok(Data::Bool(context.script.switches.closed(context.names.part(arguments.text(0)?)?)))
    }),
    function("balls_in_play", (0, 0), Nothing, |context, _| {
        Ok(Data::Int(i64::from(context.script.balls) + i64::from(context.script.owed)))
    }),
    function("add_ball", (0, 0), Nothing, |context, _| ordered(context.script.add_ball())),
    function("flippers", (1, 1), Nothing, |context, arguments| power(context, Some(arguments.flag(0)?), None)),
    function("kickers", (1, 1), Nothing, |context, arguments| power(context, None, Some(arguments.flag(0)?))),
];

fn command_part(context: &mut ScriptContext, command: &PartCommand, arguments: &Arguments) -> Result<Data, String> {
    let part = context.names.part_for(command, arguments.text(0)?)?;
    let order = match command.order {
        Order::Once(order) => order(part),
        Order::Switch(order) => order(part, arguments.flag(1)?),
    };
    ordered(context.script.order(order))
}

/// Switches the coils of flippers and kickers on or off.
fn power(context: &mut ScriptContext, flippers: Option<bool>, kickers: Option<bool>) -> Result<Data, String> {
    if let Some(on) = flippers {
        context.script.flippers = on;
        ordered(context.script.order(Command::SetFlippers(on)))?;
    }
    if let Some(on) = kickers {
        context.script.kickers = on;
        ordered(context.script.order(Command::SetCoils(on)))?;
    }
    Ok(Data::Unit)
}

fn ordered(room: bool) -> Result<Data, String> {
    room.then_some(Data::Unit).ok_or_else(|| "too many orders for the machine in one tick".to_string())
}
