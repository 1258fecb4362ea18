//! Snapshot: what a picture needs to know of a moment: plain data, independent of the simulation it came from.

use crate::lamps::{ExposureAdaptation, LampLight};
use crate::rules::Display;
use physics::Pose;

/// What a picture needs to know of a moment.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Snapshot {
    /// Ticks since the game was switched on.
    pub tick: u64,
    /// Where everything is.
    pub pose: Pose,
    /// Each lamp of the table, in its order.
    pub lamps: Vec<LampLight>,
    /// The light that somebody at the table has got used to.
    pub adaptation: ExposureAdaptation,
    /// What the display shows.
    pub display: Display,
}
