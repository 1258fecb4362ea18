//! The functions that a script can call. `assets/tables/README.md` tells them to table makers.

use super::desk::Desk;
use super::names::Names;
use super::score::{MAX_BALLS, MAX_PLAYERS};
use crate::lamps::{Glow, Lamps, Mode, Show};
use physics::Command;
use rhai::{Array, Dynamic, Engine, EvalAltResult, NativeCallContext};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// Longest time that a script can name, ms: a day.
const MAX_MS: i64 = 86_400_000;
/// Most things whose progress is shown.
const MAX_PROGRESS: usize = 64;

/// What the script's calls can reach while it runs.
#[derive(Clone)]
pub struct Hands(Arc<Mutex<Reach>>);

/// The desk, the lamps and the names.
struct Reach {
    desk: Desk,
    lamps: Lamps,
    names: Arc<Names>,
}

impl Hands {
    /// Lends these to a script.
    pub fn new(desk: Desk, lamps: Lamps, names: Arc<Names>) -> Hands {
        Hands(Arc::new(Mutex::new(Reach { desk, lamps, names })))
    }

    /// Takes them back.
    pub fn give_back(&self) -> (Desk, Lamps) {
        let mut reach = self.reach();
        (std::mem::take(&mut reach.desk), std::mem::take(&mut reach.lamps))
    }

    fn reach(&self) -> MutexGuard<'_, Reach> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

type Answer<T> = Result<T, Box<EvalAltResult>>;

/// Does something with what the script can reach; a sentence becomes an error at the script's line.
fn reach<T>(context: &NativeCallContext, act: impl FnOnce(&mut Reach) -> Result<T, String>) -> Answer<T> {
    let hands = context.tag().and_then(|tag| tag.clone().try_cast::<Hands>());
    let hands = hands.ok_or("this can only be called when something has happened, not while the script is read")?;
    let answer = act(&mut hands.reach());
    Ok(answer?)
}

/// Registers everything.
pub fn register(engine: &mut Engine) {
    register_score(engine);
    register_flow(engine);
    register_display(engine);
    register_time(engine);
    register_machine(engine);
    register_lamps(engine);
}

fn register_score(engine: &mut Engine) {
    engine
        .register_fn("score", |context: NativeCallContext, points: i64| {
            reach(&context, |reach| {
                reach.desk.score.add(points);
                Ok(())
            })
        })
        .register_fn("score", |context: NativeCallContext| {
            reach(&context, |reach| {
                let score = &reach.desk.score;
                Ok(score.scores.get(score.player).copied().unwrap_or(0))
            })
        })
        .register_fn("scores", |context: NativeCallContext| {
            reach(&context, |reach| Ok(reach.desk.score.scores.iter().map(|s| Dynamic::from(*s)).collect::<Array>()))
        })
        .register_fn("player", |context: NativeCallContext| reach(&context, |reach| Ok(reach.desk.score.player as i64)))
        .register_fn("players", |context: NativeCallContext| {
            reach(&context, |reach| Ok(reach.desk.score.scores.len() as i64))
        })
        .register_fn("ball", |context: NativeCallContext| reach(&context, |reach| Ok(i64::from(reach.desk.score.ball))))
        .register_fn("playing", |context: NativeCallContext| reach(&context, |reach| Ok(reach.desk.score.playing)))
        .register_fn("tilted", |context: NativeCallContext| reach(&context, |reach| Ok(reach.desk.score.tilted)));
}

fn register_flow(engine: &mut Engine) {
    engine
        .register_fn("start_game", |context: NativeCallContext, balls: i64| {
            reach(&context, |reach| {
                if !(1..=i64::from(MAX_BALLS)).contains(&balls) {
                    return Err(format!("a game has 1 to {MAX_BALLS} balls, not {balls}"));
                }
                reach.desk.score.start(balls as u32);
                Ok(())
            })
        })
        .register_fn("add_player", |context: NativeCallContext| {
            reach(&context, |reach| Ok(reach.desk.score.add_player()))
        })
        .register_fn("next_player", |context: NativeCallContext| {
            reach(&context, |reach| Ok(reach.desk.score.next_player()))
        })
        .register_fn("game_over", |context: NativeCallContext| {
            reach(&context, |reach| {
                reach.desk.score.game_over();
                Ok(())
            })
        })
        .register_fn("tilt", |context: NativeCallContext, on: bool| {
            reach(&context, |reach| {
                reach.desk.score.tilted = on && reach.desk.score.playing;
                if on { power(reach, Some(false), Some(false)) } else { Ok(()) }
            })
        })
        .register_fn("max_players", || MAX_PLAYERS as i64);
}

fn register_display(engine: &mut Engine) {
    engine
        .register_fn("message", |context: NativeCallContext, line: &str, ms: i64| {
            reach(&context, |reach| say(reach, &[line], ms))
        })
        .register_fn("message", |context: NativeCallContext, first: &str, second: &str, ms: i64| {
            reach(&context, |reach| say(reach, &[first, second], ms))
        })
        .register_fn("message", |context: NativeCallContext| reach(&context, |reach| say(reach, &[], 0)))
        .register_fn("progress", |context: NativeCallContext, name: &str, done: i64, of: i64| {
            reach(&context, |reach| progress(reach, name, done, of))
        });
}

fn say(reach: &mut Reach, lines: &[&str], ms: i64) -> Result<(), String> {
    let duration_ms = time_ms(ms)?;
    let lines = lines.iter().filter(|line| !line.is_empty());
    reach.desk.say(lines.map(|line| line.to_string()).collect(), duration_ms);
    Ok(())
}

/// Shows, changes or (with `of` 0) forgets the progress of something.
fn progress(reach: &mut Reach, name: &str, done: i64, of: i64) -> Result<(), String> {
    let shown = &mut reach.desk.progress;
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
        .register_fn("after", |context: NativeCallContext, ms: i64, timer: &str| {
            reach(&context, |reach| {
                let due = reach.desk.now + time_ms(ms)?.max(1);
                let started = reach.desk.timers.start(timer, due);
                started.then_some(()).ok_or_else(|| format!("too many timers run to start \"{timer}\""))
            })
        })
        .register_fn("cancel", |context: NativeCallContext, timer: &str| {
            reach(&context, |reach| {
                reach.desk.timers.cancel(timer);
                Ok(())
            })
        })
        .register_fn("running", |context: NativeCallContext, timer: &str| {
            reach(&context, |reach| Ok(reach.desk.timers.due(timer).is_some()))
        })
        .register_fn("time_left", |context: NativeCallContext, timer: &str| {
            reach(&context, |reach| {
                let due = reach.desk.timers.due(timer).unwrap_or(0);
                Ok(due.saturating_sub(reach.desk.now) as i64)
            })
        })
        .register_fn("now", |context: NativeCallContext| reach(&context, |reach| Ok(reach.desk.now as i64)))
        .register_fn("random", |context: NativeCallContext, count: i64| {
            reach(&context, |reach| match u64::try_from(count) {
                Ok(count) if count > 0 => Ok(reach.desk.random.below(count) as i64),
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
        .register_fn("exists", |context: NativeCallContext, name: &str| {
            reach(&context, |reach| Ok(reach.names.exists(name)))
        })
        .register_fn("closed", |context: NativeCallContext, name: &str| {
            reach(&context, |reach| Ok(reach.desk.switches.closed(reach.names.part(name)?)))
        })
        .register_fn("balls_in_play", |context: NativeCallContext| {
            reach(&context, |reach| Ok(i64::from(reach.desk.balls) + i64::from(reach.desk.owed)))
        })
        .register_fn("add_ball", |context: NativeCallContext| reach(&context, |reach| ordered(reach.desk.add_ball())))
        .register_fn("eject", |context: NativeCallContext, name: &str| {
            reach(&context, |reach| {
                let saucer = reach.names.saucer(name)?;
                ordered(reach.desk.order(Command::Eject(saucer)))
            })
        })
        .register_fn("raise", |context: NativeCallContext, name: &str| {
            reach(&context, |reach| {
                let target = reach.names.drop_target(name)?;
                ordered(reach.desk.order(Command::Raise(target)))
            })
        })
        .register_fn("kick", |context: NativeCallContext, name: &str| {
            reach(&context, |reach| {
                let kickback = reach.names.kickback(name)?;
                ordered(reach.desk.order(Command::Kick(kickback)))
            })
        })
        .register_fn("magnet", |context: NativeCallContext, name: &str, on: bool| {
            reach(&context, |reach| {
                let magnet = reach.names.magnet(name)?;
                ordered(reach.desk.order(Command::Magnet(magnet, on)))
            })
        })
        .register_fn("divert", |context: NativeCallContext, name: &str, on: bool| {
            reach(&context, |reach| {
                let diverter = reach.names.diverter(name)?;
                ordered(reach.desk.order(Command::Divert(diverter, on)))
            })
        })
        .register_fn("flippers", |context: NativeCallContext, on: bool| {
            reach(&context, |reach| power(reach, Some(on), None))
        })
        .register_fn("kickers", |context: NativeCallContext, on: bool| {
            reach(&context, |reach| power(reach, None, Some(on)))
        });
}

/// Switches the coils of flippers and kickers on or off.
fn power(reach: &mut Reach, flippers: Option<bool>, kickers: Option<bool>) -> Result<(), String> {
    if let Some(on) = flippers {
        reach.desk.flippers = on;
        ordered(reach.desk.order(Command::SetFlippers(on)))?;
    }
    if let Some(on) = kickers {
        reach.desk.kickers = on;
        ordered(reach.desk.order(Command::SetKickers(on)))?;
    }
    Ok(())
}

fn ordered(room: bool) -> Result<(), String> {
    room.then_some(()).ok_or_else(|| "too many orders for the machine in one tick".to_string())
}

fn register_lamps(engine: &mut Engine) {
    engine
        .register_fn("lamp", |context: NativeCallContext, name: &str, mode: &str| {
            reach(&context, |reach| set(reach, name, glow(mode, None, 0)?))
        })
        .register_fn("lamp", |context: NativeCallContext, name: &str, mode: &str, period: i64| {
            reach(&context, |reach| set(reach, name, glow(mode, Some(period), 0)?))
        })
        .register_fn("lamp", |context: NativeCallContext, name: &str, mode: &str, period: i64, shift: i64| {
            reach(&context, |reach| set(reach, name, glow(mode, Some(period), shift)?))
        })
        .register_fn("lamp", |context: NativeCallContext, name: &str, level: i64| {
            reach(&context, |reach| set(reach, name, Glow { mode: Mode::Steady(permille(level)?), ..Glow::OFF }))
        })
        .register_fn("lamp_color", |context: NativeCallContext, name: &str, color: &str| {
            reach(&context, |reach| paint(reach, name, Some(srgb(color)?)))
        })
        .register_fn("lamp_color", |context: NativeCallContext, name: &str| {
            reach(&context, |reach| paint(reach, name, None))
        })
        .register_fn("flash", |context: NativeCallContext, name: &str, ms: i64| {
            reach(&context, |reach| show(reach, name, glow("on", None, 0)?, ms, None))
        })
        .register_fn("flash", |context: NativeCallContext, name: &str, ms: i64, color: &str| {
            reach(&context, |reach| show(reach, name, glow("on", None, 0)?, ms, Some(srgb(color)?)))
        })
        .register_fn("show", |context: NativeCallContext, name: &str, mode: &str, period: i64, delay: i64, ms: i64| {
            reach(&context, |reach| show(reach, name, glow(mode, Some(period), delay)?, ms, None))
        })
        .register_fn(
            "show",
            |context: NativeCallContext, name: &str, mode: &str, period: i64, delay: i64, ms: i64, color: &str| {
                reach(&context, |reach| show(reach, name, glow(mode, Some(period), delay)?, ms, Some(srgb(color)?)))
            },
        );
}

fn set(reach: &mut Reach, name: &str, glow: Glow) -> Result<(), String> {
    for lamp in reach.names.lamps(name)? {
        reach.lamps.set(lamp, glow);
    }
    Ok(())
}

fn paint(reach: &mut Reach, name: &str, color: Option<[u8; 3]>) -> Result<(), String> {
    for lamp in reach.names.lamps(name)? {
        reach.lamps.paint(lamp, color);
    }
    Ok(())
}

fn show(reach: &mut Reach, name: &str, mut glow: Glow, ms: i64, color: Option<[u8; 3]>) -> Result<(), String> {
    let delay = std::mem::take(&mut glow.shift_ms);
    let since = reach.desk.now + u64::from(delay);
    let until = since + time_ms(ms)?;
    for lamp in reach.names.lamps(name)? {
        reach.lamps.show(lamp, (ms > 0).then_some(Show { glow, color, since, until }));
    }
    Ok(())
}

fn glow(mode: &str, period: Option<i64>, shift: i64) -> Result<Glow, String> {
    let unknown = || format!("a lamp cannot do \"{mode}\"; it can do {}", Mode::NAMES.join(", "));
    let mode = Mode::named(mode).ok_or_else(unknown)?;
    let period_ms = match period {
        None => mode.usual_period_ms(),
        Some(period) => time_ms(period)?.max(1) as u32,
    };
    Ok(Glow { mode, period_ms, shift_ms: time_ms(shift)? as u32 })
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
