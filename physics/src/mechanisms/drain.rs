//! Drain: where a ball leaves the playfield.

use crate::collision::trigger::TriggerKind;
use crate::mechanisms::model::Model;
use crate::part::PartId;
use crate::part::validation::{self, Checked};
use geometry::Shape;
use serde::{Deserialize, Serialize};

/// Where a ball leaves the playfield. Its switch closes for every ball.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Drain {
    /// A ball is gone when its centre is in this shape.
    pub shape: Shape,
}

impl Drain {
    pub(crate) fn check(&self) -> Checked {
        validation::shape(&self.shape)
    }

    pub(crate) fn add_to(&self, part: PartId, model: &mut Model) {
        model.collision.add_trigger(part, self.shape, TriggerKind::Drain);
    }
}
