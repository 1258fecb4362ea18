//! Spinner: a plate on an axle across a lane that turns as the ball passes below it.
//!
//! The plate is a rigid body on a hinge (`crate::mechanisms::rigid_mechanisms`). Its switch closes at every half turn.

use crate::collision::trigger::TriggerKind;
use crate::mechanisms::flap::FLAP_REACH_M;
use crate::mechanisms::model::Model;
use crate::part::validation::{self, Checked};
use crate::part::{Numbered, PartId};
use geometry::{Segment, Shape};
use serde::{Deserialize, Serialize};

/// A plate on an axle across a lane; the ball passes in both directions. Its switch closes at every half turn.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Spinner {
    /// The axle seen from above.
    pub segment: Segment,
    /// How fast it loses its turning, 1/s.
    pub damping_per_s: f64,
}

impl Spinner {
    pub(crate) fn check(&self) -> Checked {
        validation::segment(&self.segment)?;
        validation::not_negative("the damping", self.damping_per_s)
    }

    pub(crate) fn add_to(&self, part: PartId, model: &mut Model) {
        let spinners = &mut model.mechanisms.spinners;
        let shape = Shape::capsule(self.segment.a, self.segment.b, FLAP_REACH_M);
        model.collision.add_trigger(part, shape, TriggerKind::Spinner(spinners.len()));
        spinners.push(Numbered { part, numbers: self.clone() });
    }
}
