//! The lamp controller: what each lamp is told to do, and the filament that follows.
//!
//! Integers only: a lamp's level is part of the state that a recording must reproduce. Refuses to know why a lamp is
//! lit (the rules) and how its light falls (the tracer).

mod eye;
mod glow;

pub use eye::{Brightness, Eye, LOOK_TICKS, REFERENCE_MM, given};
pub use glow::{Glow, Mode};

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
pub struct Lamps {
    lamps: Vec<Lamp>,
}

/// One lamp's orders and its filament.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
struct Lamp {
    /// The colour that the rules gave it, sRGB. Its own one is paint, and no part of the game's state.
    color: Option<[u8; 3]>,
    /// What it does when no show is on.
    glow: Glow,
    /// What it does for a while instead.
    show: Option<Show>,
    /// The filament's level, 0 to 1000 * [`FINE`].
    level: i32,
}

/// Something that a lamp does for a while.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Show {
    /// What it does, counted from the show's first tick.
    pub glow: Glow,
    /// In which colour, sRGB; without it the lamp keeps its own.
    pub color: Option<[u8; 3]>,
    /// The show's first tick; until then the lamp goes on as it was.
    pub since: u64,
    /// The tick at which it is over.
    pub until: u64,
}

impl Lamps {
    /// The lamps of a table, all dark.
    pub fn new(table: &Table) -> Lamps {
        let dark = Lamp { color: None, glow: Glow::OFF, show: None, level: 0 };
        Lamps { lamps: vec![dark; table.lamps.len()] }
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
    pub fn set(&mut self, lamp: usize, glow: Glow) {
        if let Some(lamp) = self.lamps.get_mut(lamp) {
            lamp.glow = glow;
        }
    }

    /// Gives a lamp a colour (sRGB), or its own one back.
    pub fn paint(&mut self, lamp: usize, color: Option<[u8; 3]>) {
        if let Some(lamp) = self.lamps.get_mut(lamp) {
            lamp.color = color;
        }
    }

    /// Lets a lamp do something else for a while, or ends that with `None`.
    pub fn show(&mut self, lamp: usize, show: Option<Show>) {
        if let Some(lamp) = self.lamps.get_mut(lamp) {
            lamp.show = show;
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

impl Lamp {
    fn tick(&mut self, now: u64) {
        if self.show.as_ref().is_some_and(|show| show.until <= now) {
            self.show = None;
        }
        let target = match self.on_show(now) {
            Some(show) => show.glow.level(now - show.since),
            None => self.glow.level(now),
        };
        self.level = filament(self.level, i32::from(target) * FINE);
    }

    /// The show, once it has begun.
    fn on_show(&self, now: u64) -> Option<&Show> {
        self.show.as_ref().filter(|show| show.since <= now)
    }

    fn light(&self, own_color: [u8; 3], now: u64) -> LampLight {
        let shown = self.on_show(now).and_then(|show| show.color);
        LampLight { level: (self.level / FINE) as u16, color: shown.or(self.color).unwrap_or(own_color) }
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
