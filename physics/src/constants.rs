//! The numbers that hold for every machine.

/// Ticks in a second of play.
pub const TICKS_PER_SECOND: u32 = 1000;
/// The length of a tick.
pub const TICK_S: f64 = 1.0 / TICKS_PER_SECOND as f64;
/// A pinball's radius: 27 mm across (1 1/16 in).
pub const BALL_RADIUS_M: f64 = 0.0135;
/// A pinball's mass.
pub const BALL_MASS_KG: f64 = 0.08;
/// Standard gravity.
pub(crate) const GRAVITY_M_S2: f64 = 9.81;
