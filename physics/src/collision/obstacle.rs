//! Obstacle: a surface that stands still and that the ball bounces off.

use crate::BALL_RADIUS_M;
use crate::part::PartId;
use crate::part::material::Material;
use geometry::{Arc, Core, DVec2, Shape};

/// A surface, inflated by the ball's radius (Minkowski sum): the ball's centre is a point that meets it.
#[derive(Clone, Debug)]
pub(crate) struct Obstacle {
    pub part: PartId,
    /// The places of the ball's centre where it touches.
    pub shape: Shape,
    pub material: Material,
    pub role: ObstacleRole,
}

/// What an obstacle does beside being there; the index counts the parts of that kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ObstacleRole {
    /// Nothing.
    Static,
    Kicker(usize),
    Target(usize),
    DropTarget(usize),
    Gate(usize),
}

impl Obstacle {
    /// Of a surface whose own shape this is.
    pub fn new(part: PartId, shape: Shape, material: Material, role: ObstacleRole) -> Obstacle {
        Obstacle { part, shape: shape.inflated(BALL_RADIUS_M), material, role }
    }

    /// The curve on which the centre of a ball rides round the inside of an arc, if a ball at `center` touches that with
    /// this normal.
    pub fn inner_curve(&self, center: DVec2, normal: DVec2) -> Option<Arc> {
        let Core::Arc(arc) = &self.shape.core else { return None };
        let radius = arc.circle().radius - self.shape.radius;
        let is_inside = (arc.circle().center - center).dot(normal) > 0.0;
        (radius > 0.0 && is_inside).then(|| arc.with_radius(radius))
    }
}
