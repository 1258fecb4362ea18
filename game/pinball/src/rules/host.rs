//! The functions of the game that a script can call. `assets/tables/README.md` tells them to table makers.

use super::host_function::Searched::{Nothing, Progress, Timers};
use super::host_function::{Arguments, Body, HostFunction, ScriptContext, function, ordered, time_ms};
use super::host_lamps;
use super::part_commands::{Order, PART_COMMANDS};
use super::score::{MAX_BALLS, MAX_PLAYERS};
use super::script::Data;
use physics::Command;
use std::sync::LazyLock;

/// Most things whose progress is shown.
const MAX_PROGRESS: usize = 64;

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
        context.script.restarts += u32::from(context.script.score.playing && context.script.balls > 0);
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
