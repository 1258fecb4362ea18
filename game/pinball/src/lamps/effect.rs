//! Lamp effects: what a lamp can be told to do, a level that follows time.

use serde::{Deserialize, Serialize};

/// The shape of a lamp's light over time.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Mode {
    /// Steady at this level, 0 to 1000.
    Steady(u16),
    /// Half of the time on, half of it off.
    Blink,
    /// Swells and sinks smoothly, never dark.
    Pulse,
    /// Swells and sinks slowly and dimly: a lamp that waits.
    Breathe,
    /// A short bright stroke in each period.
    Strobe,
    /// Bright at once, then sinking until the period is over. With shifts along a row of lamps, a light that runs.
    Chase,
}

/// A mode with its time.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct LampEffect {
    /// The shape.
    pub mode: Mode,
    /// The length of a period, ms, at least 1.
    pub period_ms: u32,
    /// How much later than the other lamps this one does the same, ms.
    pub shift_ms: u32,
}

impl Mode {
    /// The names that rules use, in the order in which an error lists them.
    pub const NAMES: [&str; 9] =
        ["off", "on", "dim", "blink", "pulse", "breathe", "strobe", "chase", "a level 0 to 1000"];

    /// The mode with this name.
    pub fn named(name: &str) -> Option<Mode> {
        Some(match name {
            "off" => Mode::Steady(0),
            "on" => Mode::Steady(1000),
            "dim" => Mode::Steady(160),
            "blink" => Mode::Blink,
            "pulse" => Mode::Pulse,
            "breathe" => Mode::Breathe,
            "strobe" => Mode::Strobe,
            "chase" => Mode::Chase,
            _ => return None,
        })
    }

    /// The period that suits it, ms.
    pub fn usual_period_ms(self) -> u32 {
        match self {
            Mode::Steady(_) => 1000,
            Mode::Blink => 500,
            Mode::Pulse => 1200,
            Mode::Breathe => 4200,
            Mode::Strobe => 160,
            Mode::Chase => 1400,
        }
    }
}

impl LampEffect {
    /// Dark.
    pub const OFF: LampEffect = LampEffect { mode: Mode::Steady(0), period_ms: 1000, shift_ms: 0 };

    /// The level that the filament aims at, 0 to 1000, `tick` ms after the start.
    pub fn level(&self, tick: u64) -> u16 {
        if let Mode::Steady(level) = self.mode {
            return level.min(1000);
        }
        let period = u64::from(self.period_ms.max(1));
        let late = u64::from(self.shift_ms) % period;
        // In thousandths of a period.
        let phase = ((tick % period + period - late) % period * 1000 / period) as u32;
        (match self.mode {
            Mode::Steady(level) => u32::from(level),
            Mode::Blink => 1000 * u32::from(phase < 500),
            Mode::Pulse => 180 + 820 * swell(phase) / 1000,
            Mode::Breathe => 60 + 160 * swell(phase) / 1000,
            Mode::Strobe => 1000 * u32::from(phase < 300),
            Mode::Chase => (1000 - phase) * (1000 - phase) / 1000,
        }) as u16
    }
}

/// From 0 up to 1000 and back in one period, smooth at both ends: the cubic 3t^2 - 2t^3 of a triangle wave.
fn swell(phase: u32) -> u32 {
    let t = u64::from(if phase < 500 { 2 * phase } else { 2000 - 2 * phase });
    (t * t * (3000 - 2 * t) / 1_000_000) as u32
}
