//! Wall: anything that only stands there, as walls, guides, posts and rubbers.

use crate::collision::obstacle::ObstacleRole;
use crate::mechanisms::model::Model;
use crate::part::PartId;
use crate::part::material::Material;
use crate::part::validation::{self, Checked};
use geometry::Shape;
use serde::{Deserialize, Serialize};

/// Anything that only stands there.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Wall {
    /// Its surfaces.
    pub shapes: Vec<Shape>,
    /// What they are made of.
    pub material: Material,
}

impl Wall {
    pub(crate) fn check(&self) -> Checked {
        self.shapes.iter().try_for_each(validation::shape)?;
        validation::material(&self.material)
    }

    pub(crate) fn add_to(&self, part: PartId, model: &mut Model) {
        for &shape in &self.shapes {
            model.collision.add_obstacle(part, shape, self.material, ObstacleRole::Static);
        }
    }
}
