//! The lamp controller: what each lamp is told to do, and the filament that follows.
//!
//! Integers only: a lamp's level is part of the state that a recording must reproduce. Refuses to know why a lamp is
//! lit (the rules) and how its light falls (the tracer).

mod effect;
mod exposure_adaptation;

pub use effect::{LampEffect, Mode};
pub use exposure_adaptation::{ADAPTATION_TICKS, ExposureAdaptation, LampBrightness, REFERENCE_MM, mean_light};

use crate::Table;
use serde::{Deserialize, Serialize};

/// Time in which a filament closes all but 1/e of its way to more light, ms.
const RISE_MS: i32 = 24;
/// Time in which a filament closes all but 1/e of its way to less light, ms: it cools slower than it heats.
const FALL_MS: i32 = 70;
/// Levels are kept a thousand times finer than they are shown, so that slow filaments do not stall.
const FINE: i32 = 1000;

/// What a lamp does now.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct LampLight {
    /// Brightness, 0 to 1000.
    pub level: u16,
    /// Colour, sRGB.
    pub color: [u8; 3],
}

/// Every lamp of a table, in its order.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct LampController {
    lamps: Vec<LampState>,
}

/// One lamp's orders and its filament.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
struct LampState {
    /// The colour that the rules gave it, sRGB. Its own one is paint, and no part of the game's state.
    color: Option<[u8; 3]>,
    /// What it does when no override is on.
    effect: LampEffect,
    /// What it does for a while instead.
    timed_override: Option<TimedOverride>,
    /// The filament's level, 0 to 1000 * [`FINE`].
    level: i32,
}

/// A timed override: an effect that a lamp has for a while instead of its own.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct TimedOverride {
    /// What it does, counted from the override's first tick.
    pub effect: LampEffect,
    /// In which colour, sRGB; without it the lamp keeps its own.
    pub color: Option<[u8; 3]>,
    /// The override's first tick; until then the lamp goes on as it was.
    pub since: u64,
    /// The tick at which it is over.
    pub until: u64,
}

impl LampController {
    /// The lamps of a table, all dark.
    pub fn new(table: &Table) -> LampController {
        let dark = LampState { color: None, effect: LampEffect::OFF, timed_override: None, level: 0 };
        LampController { lamps: vec![dark; table.lamps.len()] }
    }

    /// How many lamps there are.
    pub fn len(&self) -> usize {
        self.lamps.len()
    }

    /// Whether there is no lamp.
    pub fn is_empty(&self) -> bool {
        self.lamps.is_empty()
    }

    /// Tells a lamp what to do until it is told otherwise. Lamps that do the same do it in step.
    pub fn set(&mut self, lamp: usize, effect: LampEffect) {
        if let Some(lamp) = self.lamps.get_mut(lamp) {
            lamp.effect = effect;
        }
    }

    /// Gives a lamp a colour (sRGB), or its own one back.
    pub fn paint(&mut self, lamp: usize, color: Option<[u8; 3]>) {
        if let Some(lamp) = self.lamps.get_mut(lamp) {
            lamp.color = color;
        }
    }

    /// Lets a lamp do something else for a while, or ends that with `None`.
    pub fn set_override(&mut self, lamp: usize, timed_override: Option<TimedOverride>) {
        if let Some(lamp) = self.lamps.get_mut(lamp) {
            lamp.timed_override = timed_override;
        }
    }

    /// One millisecond: every filament follows its orders.
    pub fn tick(&mut self, now: u64) {
        for lamp in &mut self.lamps {
            lamp.tick(now);
        }
    }

    /// What each lamp of `table` does now.
    pub fn lights(&self, table: &Table, now: u64) -> Vec<LampLight> {
        self.each_light(table, now).collect()
    }

    /// The same, one by one.
    pub fn each_light<'a>(&'a self, table: &'a Table, now: u64) -> impl Iterator<Item = LampLight> + 'a {
        self.lamps.iter().zip(&table.lamps).map(move |(lamp, drawn)| lamp.light(drawn.color, now))
    }
}

impl LampState {
    fn tick(&mut self, now: u64) {
        if self.timed_override.as_ref().is_some_and(|timed_override| timed_override.until <= now) {
            self.timed_override = None;
        }
        let target = match self.active_override(now) {
            Some(timed_override) => timed_override.effect.level(now - timed_override.since),
            None => self.effect.level(now),
        };
        self.level = filament(self.level, i32::from(target) * FINE);
    }

    /// The override, once it has begun.
    fn active_override(&self, now: u64) -> Option<&TimedOverride> {
        self.timed_override.as_ref().filter(|timed_override| timed_override.since <= now)
    }

    fn light(&self, own_color: [u8; 3], now: u64) -> LampLight {
        let overridden = self.active_override(now).and_then(|timed_override| timed_override.color);
        LampLight { level: (self.level / FINE) as u16, color: overridden.or(self.color).unwrap_or(own_color) }
    }
}

/// The level one millisecond later: an exponential approach that ends exactly at its target.
fn filament(level: i32, target: i32) -> i32 {
    let gap = target - level;
    if gap.abs() < FINE {
        return target;
    }
    level + gap / if gap > 0 { RISE_MS } else { FALL_MS }
}

#[cfg(test)]
mod tests;
