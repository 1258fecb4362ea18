//! The functions that a script can call. `assets/tables/README.md` tells them to table makers.

use super::names::Names;
use super::part_commands::{Order, PART_COMMANDS, PartCommand};
use super::score::{MAX_BALLS, MAX_PLAYERS};
use super::script_state::ScriptState;
use crate::lamps::{LampController, LampEffect, Mode, TimedOverride};
use physics::{Command, PartId};
use rhai::{Array, Dynamic, Engine, EvalAltResult, NativeCallContext};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// Longest time that a script can name, ms: a day.
const MAX_MS: i64 = 86_400_000;
/// Most things whose progress is shown.
const MAX_PROGRESS: usize = 64;

/// What the script's calls can reach while it runs.
#[derive(Clone)]
pub struct SharedContext(Arc<Mutex<ScriptContext>>);

/// The desk, the lamps and the names.
struct ScriptContext {
    script: ScriptState,
    lamps: LampController,
    names: Arc<Names>,
}

impl SharedContext {
    /// Lends these to a script.
    pub fn new(script: ScriptState, lamps: LampController, names: Arc<Names>) -> SharedContext {
        SharedContext(Arc::new(Mutex::new(ScriptContext { script, lamps, names })))
    }

    /// Takes them back.
    pub fn take_parts(&self) -> (ScriptState, LampController) {
        let mut context = self.lock();
        (std::mem::take(&mut context.script), std::mem::take(&mut context.lamps))
    }

    fn lock(&self) -> MutexGuard<'_, ScriptContext> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

type CallResult<T> = Result<T, Box<EvalAltResult>>;

/// Does something with what the script can reach; a sentence becomes an error at the script's line.
fn with_context<T>(
    call: &NativeCallContext,
    act: impl FnOnce(&mut ScriptContext) -> Result<T, String>,
) -> CallResult<T> {
    let shared = call.tag().and_then(|tag| tag.clone().try_cast::<SharedContext>());
    let shared = shared.ok_or("this can only be called when something has happened, not while the script is read")?;
    let result = act(&mut shared.lock());
    Ok(result?)
}

/// Registers everything.
pub fn register(engine: &mut Engine) {
    register_score(engine);
    register_flow(engine);
    register_display(engine);
    register_time(engine);
    register_machine(engine);
    register_parts(engine);
    register_lamps(engine);
}

fn register_score(engine: &mut Engine) {
    engine
        .register_fn("score", |call: NativeCallContext, points: i64| {
            with_context(&call, |context| {
                context.script.score.add(points);
                Ok(())
            })
        })
        .register_fn("score", |call: NativeCallContext| {
            with_context(&call, |context| {
                let score = &context.script.score;
                Ok(score.scores.get(score.player).copied().unwrap_or(0))
            })
        })
        .register_fn("scores", |call: NativeCallContext| {
            with_context(&call, |context| {
                Ok(context.script.score.scores.iter().map(|s| Dynamic::from(*s)).collect::<Array>())
            })
        })
        .register_fn("player", |call: NativeCallContext| {
            with_context(&call, |context| Ok(context.script.score.player as i64))
        })
        .register_fn("players", |call: NativeCallContext| {
            with_context(&call, |context| Ok(context.script.score.scores.len() as i64))
        })
        .register_fn("ball", |call: NativeCallContext| {
            with_context(&call, |context| Ok(i64::from(context.script.score.ball)))
        })
        .register_fn("playing", |call: NativeCallContext| {
            with_context(&call, |context| Ok(context.script.score.playing))
        })
        .register_fn("tilted", |call: NativeCallContext| {
            with_context(&call, |context| Ok(context.script.score.tilted))
        });
}

fn register_flow(engine: &mut Engine) {
    engine
        .register_fn("start_game", |call: NativeCallContext, balls: i64| {
            with_context(&call, |context| {
                if !(1..=i64::from(MAX_BALLS)).contains(&balls) {
                    return Err(format!("a game has 1 to {MAX_BALLS} balls, not {balls}"));
                }
                context.script.score.start(balls as u32);
                Ok(())
            })
        })
        .register_fn("add_player", |call: NativeCallContext| {
            with_context(&call, |context| Ok(context.script.score.add_player()))
        })
        .register_fn("next_player", |call: NativeCallContext| {
            with_context(&call, |context| Ok(context.script.score.next_player()))
        })
        .register_fn("game_over", |call: NativeCallContext| {
            with_context(&call, |context| {
                context.script.score.game_over();
                Ok(())
            })
        })
        .register_fn("tilt", |call: NativeCallContext, on: bool| {
            with_context(&call, |context| {
                context.script.score.tilted = on && context.script.score.playing;
                if on { power(context, Some(false), Some(false)) } else { Ok(()) }
            })
        })
        .register_fn("max_players", || MAX_PLAYERS as i64);
}

fn register_display(engine: &mut Engine) {
    engine
        .register_fn("message", |call: NativeCallContext, line: &str, ms: i64| {
            with_context(&call, |context| show_message(context, &[line], ms))
        })
        .register_fn("message", |call: NativeCallContext, first: &str, second: &str, ms: i64| {
            with_context(&call, |context| show_message(context, &[first, second], ms))
        })
        .register_fn("message", |call: NativeCallContext| with_context(&call, |context| show_message(context, &[], 0)))
        .register_fn("progress", |call: NativeCallContext, name: &str, done: i64, of: i64| {
            with_context(&call, |context| progress(context, name, done, of))
        });
}

fn show_message(context: &mut ScriptContext, lines: &[&str], ms: i64) -> Result<(), String> {
    let duration_ms = time_ms(ms)?;
    let lines = lines.iter().filter(|line| !line.is_empty());
    context.script.show_message(lines.map(|line| line.to_string()).collect(), duration_ms);
    Ok(())
}

/// Shows, changes or (with `of` 0) forgets the progress of something.
fn progress(context: &mut ScriptContext, name: &str, done: i64, of: i64) -> Result<(), String> {
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
    Ok(())
}

fn register_time(engine: &mut Engine) {
    engine
        .register_fn("after", |call: NativeCallContext, ms: i64, timer: &str| {
            with_context(&call, |context| {
                let due = context.script.now + time_ms(ms)?.max(1);
                let started = context.script.timers.start(timer, due);
                started.then_some(()).ok_or_else(|| format!("too many timers run to start \"{timer}\""))
            })
        })
        .register_fn("cancel", |call: NativeCallContext, timer: &str| {
            with_context(&call, |context| {
                context.script.timers.cancel(timer);
                Ok(())
            })
        })
        .register_fn("running", |call: NativeCallContext, timer: &str| {
            with_context(&call, |context| Ok(context.script.timers.due(timer).is_some()))
        })
        .register_fn("time_left", |call: NativeCallContext, timer: &str| {
            with_context(&call, |context| {
                let due = context.script.timers.due(timer).unwrap_or(0);
                Ok(due.saturating_sub(context.script.now) as i64)
            })
        })
        .register_fn("now", |call: NativeCallContext| with_context(&call, |context| Ok(context.script.now as i64)))
        .register_fn("random", |call: NativeCallContext, count: i64| {
            with_context(&call, |context| match u64::try_from(count) {
                Ok(count) if count > 0 => Ok(context.script.random.below(count) as i64),
                _ => Err(format!("random needs a number above 0, not {count}")),
            })
        });
}

fn time_ms(ms: i64) -> Result<u64, String> {
    match u64::try_from(ms) {
        Ok(time) if ms <= MAX_MS => Ok(time),
        _ => Err(format!("a time must be from 0 to {MAX_MS} ms, not {ms}")),
    }
}

fn register_machine(engine: &mut Engine) {
    engine
        .register_fn("exists", |call: NativeCallContext, name: &str| {
            with_context(&call, |context| Ok(context.names.exists(name)))
        })
        .register_fn("closed", |call: NativeCallContext, name: &str| {
            with_context(&call, |context| Ok(context.script.switches.closed(context.names.part(name)?)))
        })
        .register_fn("balls_in_play", |call: NativeCallContext| {
            with_context(&call, |context| Ok(i64::from(context.script.balls) + i64::from(context.script.owed)))
        })
        .register_fn("add_ball", |call: NativeCallContext| {
            with_context(&call, |context| ordered(context.script.add_ball()))
        })
        .register_fn("flippers", |call: NativeCallContext, on: bool| {
            with_context(&call, |context| power(context, Some(on), None))
        })
        .register_fn("kickers", |call: NativeCallContext, on: bool| {
            with_context(&call, |context| power(context, None, Some(on)))
        });
}

/// Registers the words that command a part.
fn register_parts(engine: &mut Engine) {
    for command in &PART_COMMANDS {
        match command.order {
            Order::Once(order) => engine.register_fn(command.word, move |call: NativeCallContext, name: &str| {
                with_context(&call, |context| command_part(context, command, name, order))
            }),
            Order::Switch(order) => {
                engine.register_fn(command.word, move |call: NativeCallContext, name: &str, on: bool| {
                    with_context(&call, |context| command_part(context, command, name, |part| order(part, on)))
                })
            }
        };
    }
}

fn command_part(
    context: &mut ScriptContext,
    command: &PartCommand,
    name: &str,
    order: impl Fn(PartId) -> Command,
) -> Result<(), String> {
    let part = context.names.part_for(command, name)?;
    ordered(context.script.order(order(part)))
}

/// Switches the coils of flippers and kickers on or off.
fn power(context: &mut ScriptContext, flippers: Option<bool>, kickers: Option<bool>) -> Result<(), String> {
    if let Some(on) = flippers {
        context.script.flippers = on;
        ordered(context.script.order(Command::SetFlippers(on)))?;
    }
    if let Some(on) = kickers {
        context.script.kickers = on;
        ordered(context.script.order(Command::SetCoils(on)))?;
    }
    Ok(())
}

fn ordered(room: bool) -> Result<(), String> {
    room.then_some(()).ok_or_else(|| "too many orders for the machine in one tick".to_string())
}

fn register_lamps(engine: &mut Engine) {
    engine
        .register_fn("lamp", |call: NativeCallContext, name: &str, mode: &str| {
            with_context(&call, |context| set(context, name, effect(mode, None, 0)?))
        })
        .register_fn("lamp", |call: NativeCallContext, name: &str, mode: &str, period: i64| {
            with_context(&call, |context| set(context, name, effect(mode, Some(period), 0)?))
        })
        .register_fn("lamp", |call: NativeCallContext, name: &str, mode: &str, period: i64, shift: i64| {
            with_context(&call, |context| set(context, name, effect(mode, Some(period), shift)?))
        })
        .register_fn("lamp", |call: NativeCallContext, name: &str, level: i64| {
            with_context(&call, |context| {
                set(context, name, LampEffect { mode: Mode::Steady(permille(level)?), ..LampEffect::OFF })
            })
        })
        .register_fn("lamp_color", |call: NativeCallContext, name: &str, color: &str| {
            with_context(&call, |context| paint(context, name, Some(srgb(color)?)))
        })
        .register_fn("lamp_color", |call: NativeCallContext, name: &str| {
            with_context(&call, |context| paint(context, name, None))
        })
        .register_fn("flash", |call: NativeCallContext, name: &str, ms: i64| {
            with_context(&call, |context| override_lamps(context, name, effect("on", None, 0)?, ms, None))
        })
        .register_fn("flash", |call: NativeCallContext, name: &str, ms: i64, color: &str| {
            with_context(&call, |context| override_lamps(context, name, effect("on", None, 0)?, ms, Some(srgb(color)?)))
        })
        .register_fn("show", |call: NativeCallContext, name: &str, mode: &str, period: i64, delay: i64, ms: i64| {
            with_context(&call, |context| override_lamps(context, name, effect(mode, Some(period), delay)?, ms, None))
        })
        .register_fn(
            "show",
            |call: NativeCallContext, name: &str, mode: &str, period: i64, delay: i64, ms: i64, color: &str| {
                with_context(&call, |context| {
                    override_lamps(context, name, effect(mode, Some(period), delay)?, ms, Some(srgb(color)?))
                })
            },
        );
}

fn set(context: &mut ScriptContext, name: &str, effect: LampEffect) -> Result<(), String> {
    for lamp in context.names.lamps(name)? {
        context.lamps.set(lamp, effect);
    }
    Ok(())
}

fn paint(context: &mut ScriptContext, name: &str, color: Option<[u8; 3]>) -> Result<(), String> {
    for lamp in context.names.lamps(name)? {
        context.lamps.paint(lamp, color);
    }
    Ok(())
}

fn override_lamps(
    context: &mut ScriptContext,
    name: &str,
    mut effect: LampEffect,
    ms: i64,
    color: Option<[u8; 3]>,
) -> Result<(), String> {
    let delay = std::mem::take(&mut effect.shift_ms);
    let since = context.script.now + u64::from(delay);
    let until = since + time_ms(ms)?;
    for lamp in context.names.lamps(name)? {
        context.lamps.set_override(lamp, (ms > 0).then_some(TimedOverride { effect, color, since, until }));
    }
    Ok(())
}

fn effect(mode: &str, period: Option<i64>, shift: i64) -> Result<LampEffect, String> {
    let unknown = || format!("a lamp cannot do \"{mode}\"; it can do {}", Mode::NAMES.join(", "));
    let mode = Mode::named(mode).ok_or_else(unknown)?;
    let period_ms = match period {
        None => mode.usual_period_ms(),
        Some(period) => time_ms(period)?.max(1) as u32,
    };
    Ok(LampEffect { mode, period_ms, shift_ms: time_ms(shift)? as u32 })
}

fn permille(level: i64) -> Result<u16, String> {
    match u16::try_from(level) {
        Ok(level) if level <= 1000 => Ok(level),
        _ => Err(format!("a lamp's level is from 0 to 1000, not {level}")),
    }
}

/// The colour `#rrggbb`.
fn srgb(text: &str) -> Result<[u8; 3], String> {
    let wrong = || format!("a colour is written \"#rrggbb\", not \"{text}\"");
    let digits = text.strip_prefix('#').filter(|digits| digits.len() == 6).ok_or_else(wrong)?;
    if !digits.chars().all(|digit| digit.is_ascii_hexdigit()) {
        return Err(wrong());
    }
    let number = u32::from_str_radix(digits, 16).map_err(|_| wrong())?;
    let [_, red, green, blue] = number.to_be_bytes();
    Ok([red, green, blue])
}
