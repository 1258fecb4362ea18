//! An axis-aligned box.

use glam::DVec2;
use serde::{Deserialize, Serialize};

/// An axis-aligned box from `min` to `max`, both inside it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Bounds {
    /// The corner with the smallest coordinates.
    pub min: DVec2,
    /// The corner with the largest coordinates.
    pub max: DVec2,
}

impl Bounds {
    /// The smallest box around two points.
    pub fn of(a: DVec2, b: DVec2) -> Bounds {
        Bounds { min: a.min(b), max: a.max(b) }
    }

    /// The smallest box around this one and `other`.
    pub fn union(self, other: Bounds) -> Bounds {
        Bounds { min: self.min.min(other.min), max: self.max.max(other.max) }
    }

    /// This box grown by `margin` on every side.
    pub fn grown(self, margin: f64) -> Bounds {
        Bounds { min: self.min - DVec2::splat(margin), max: self.max + DVec2::splat(margin) }
    }

    /// Whether `point` is in the box or on its edge.
    pub fn contains(&self, point: DVec2) -> bool {
        point.cmpge(self.min).all() && point.cmple(self.max).all()
    }

    /// Whether the two boxes share a point.
    pub fn overlaps(&self, other: &Bounds) -> bool {
        self.min.cmple(other.max).all() && other.min.cmple(self.max).all()
    }

    /// Width and height.
    pub fn size(&self) -> DVec2 {
        self.max - self.min
    }
}
