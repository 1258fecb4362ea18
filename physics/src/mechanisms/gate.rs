//! Gate: a flap of bent wire across a lane that lets the ball through one way.
//!
//! The flap is a rigid body on a hinge (`crate::mechanisms::rigid_mechanisms`); against the other direction it is an
//! obstacle. Its switch closes when a ball's centre goes through.

use crate::collision::obstacle::ObstacleRole;
use crate::collision::time_of_impact::StraightPath;
use crate::collision::trigger::TriggerKind;
use crate::collision::world::SKIN_M;
use crate::mechanisms::flap::FLAP_REACH_M;
use crate::mechanisms::model::Model;
use crate::part::material::Material;
use crate::part::validation::{self, Checked};
use crate::part::{Numbered, PartId};
use geometry::{DVec2, Segment, Shape};
use serde::{Deserialize, Serialize};

/// How far the direction may lean from straight through the flap: the rounding of a drawing's decimals, m.
const LEAN_TOLERANCE_M: f64 = 1e-6;

/// A one-way flap across a lane. Its switch closes when a ball's centre passes below it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Gate {
    /// The flap seen from above.
    pub segment: Segment,
    /// The unit vector of the free direction, straight through the flap.
    pub direction: DVec2,
    /// What it throws back from the other direction.
    pub material: Material,
}

impl Gate {
    pub(crate) fn check(&self) -> Checked {
        validation::segment(&self.segment)?;
        validation::unit("the gate's direction", self.direction)?;
        if self.segment.along().dot(self.direction).abs() > LEAN_TOLERANCE_M {
            return Err("the gate's direction must lead straight through it".to_string());
        }
        validation::material(&self.material)
    }

    pub(crate) fn add_to(&self, part: PartId, model: &mut Model) {
        let gates = &mut model.mechanisms.gates;
        let thin = |radius| Shape::capsule(self.segment.a, self.segment.b, radius);
        model.collision.add_obstacle(part, thin(0.0), self.material, ObstacleRole::Gate(gates.len()));
        model.collision.add_trigger(part, thin(FLAP_REACH_M), TriggerKind::Gate(gates.len()));
        gates.push(Numbered { part, numbers: self.clone() });
    }

    /// Whether the flap stops a ball on this path, `distance` from touching it: a ball that comes back from beyond it.
    pub(crate) fn stops(&self, path: &StraightPath, distance: f64) -> bool {
        let beyond = (path.center - self.segment.a).dot(self.direction) > 0.0;
        beyond && distance > -SKIN_M && path.velocity.dot(self.direction) <= 0.0
    }

    /// Whether a ball's centre has gone below the flap in the free direction.
    pub(crate) fn is_passed(&self, start: DVec2, center: DVec2) -> bool {
        let beyond = |point: DVec2| (point - self.segment.a).dot(self.direction);
        let (before, after) = (beyond(start), beyond(center));
        // `parameter` is clamped to the flap's ends, so beside the flap it is exactly one of them.
        let parameter = self.segment.parameter(center);
        before <= 0.0 && after > 0.0 && parameter > 0.0 && parameter < 1.0
    }
}
