//! Layout: what stands on the playfield, as plain data in SI units; its check, and the model that it comes to.

pub(crate) mod build;
pub(crate) mod check;

use crate::mechanisms::kind::Kind;
use geometry::DVec2;
use serde::{Deserialize, Serialize};

/// Everything that the ball can meet.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Layout {
    /// Width and height of the playfield, m.
    pub size_m: DVec2,
    /// The playfield's slope towards the player, rad.
    pub slope_rad: f64,
    /// Coefficient of friction between ball and playfield.
    pub playfield_friction: f64,
    /// The parts; a [`crate::PartId`] is an index into this.
    pub parts: Vec<Part>,
}

/// One named thing on the playfield.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Part {
    /// Its id in the drawing.
    pub name: String,
    /// What it is.
    pub kind: Kind,
}
