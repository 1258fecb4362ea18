//! Target: a standup target, whose switch closes when it is hit hard enough.

use crate::collision::obstacle::ObstacleRole;
use crate::mechanisms::model::Model;
use crate::part::PartId;
use crate::part::material::Material;
use crate::part::validation::{self, Checked};
use geometry::Shape;
use serde::{Deserialize, Serialize};

/// A standup target.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Target {
    /// Its face.
    pub shape: Shape,
    /// What the face is made of.
    pub material: Material,
    /// Slowest approach that closes its switch, m/s.
    pub threshold_m_s: f64,
}

/// A target's switch.
#[derive(Clone, Debug)]
pub(crate) struct TargetModel {
    /// Slowest approach that closes it, m/s.
    pub threshold: f64,
}

impl Target {
    pub(crate) fn check(&self) -> Checked {
        validation::shape(&self.shape)?;
        validation::not_negative("the threshold", self.threshold_m_s)?;
        validation::material(&self.material)
    }

    pub(crate) fn add_to(&self, part: PartId, model: &mut Model) {
        let targets = &mut model.mechanisms.targets;
        model.collision.add_obstacle(part, self.shape, self.material, ObstacleRole::Target(targets.len()));
        targets.push(TargetModel { threshold: self.threshold_m_s });
    }
}
