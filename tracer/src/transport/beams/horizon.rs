//! Where rays end that meet nothing.

use crate::View;
use geometry::{DVec2, Ray};

/// A circle round the picture, beyond which no ray is followed.
#[derive(Clone, Copy)]
pub(super) struct Horizon {
    center: DVec2,
    radius: f64,
}

impl Horizon {
    /// So wide that lines between the ends of two rays, as far as a right angle apart, do not cut the picture's corners.
    pub fn new(view: &View) -> Horizon {
        let size = DVec2::new(view.width as f64, view.height as f64) * view.mm_per_px;
        Horizon { center: view.origin_mm + size * 0.5, radius: 0.75 * size.length() }
    }

    /// Where a ray leaves it, or is nearest to its middle; where it begins if it goes away.
    pub fn end(&self, ray: &Ray) -> DVec2 {
        let to_middle = (self.center - ray.origin).dot(ray.direction);
        let aside = ray.at(to_middle).distance_squared(self.center);
        ray.at((to_middle + (self.radius * self.radius - aside).max(0.0).sqrt()).max(0.0))
    }
}
