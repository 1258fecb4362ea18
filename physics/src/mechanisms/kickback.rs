//! Kickback: a coil-fired rod across an outlane.
//!
//! How its rod moves is in `crate::mechanisms::rod`.

use crate::mechanisms::model::Model;
use crate::mechanisms::rod::{RodActuator, RodModel};
use crate::part::PartId;
use crate::part::validation::{self, Checked};
use geometry::DVec2;
use serde::{Deserialize, Serialize};

/// A coil-fired rod whose face lies across a lane. It shoots out when the rules say so, and goes back by its spring.
/// Its switch closes when a ball hits the face or comes to lie on it, and opens when no ball is near any more.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Kickback {
    /// The rod's tip at rest, m: the middle of its face.
    pub tip: DVec2,
    /// Half the width of the face, m.
    pub half_width_m: f64,
    /// The unit vector of the shot.
    pub direction: DVec2,
    /// How far the rod comes out, m.
    pub stroke_m: f64,
    /// Speed of the rod when it is out, and of the ball that it has pushed, m/s.
    pub speed_m_s: f64,
}

impl Kickback {
    pub(crate) fn check(&self) -> Checked {
        validation::point("the tip", self.tip)?;
        validation::unit("the kickback's direction", self.direction)?;
        validation::positive("half the face's width", self.half_width_m)?;
        validation::positive("the stroke", self.stroke_m)?;
        validation::positive("the speed", self.speed_m_s)
    }

    pub(crate) fn add_to(&self, part: PartId, model: &mut Model) {
        let Kickback { tip, half_width_m, direction, stroke_m, speed_m_s } = *self;
        let actuator = RodActuator::Coil { speed: speed_m_s };
        let rod = RodModel { part, tip, half_width: half_width_m, direction, stroke: stroke_m, actuator };
        model.mechanisms.rods.push(rod);
    }
}
