//! Where rays end that meet nothing.

use crate::View;
use geometry::{DVec2, Ray};

/// A circle round the picture: the ends of rays lie beyond it.
#[derive(Clone, Copy)]
pub(super) struct Horizon {
    center: DVec2,
    radius: f64,
}

impl Horizon {
    /// So wide that lines between the ends of neighbouring rays do not cut the picture's corners.
    pub fn new(view: &View) -> Horizon {
        let size = DVec2::new(view.width as f64, view.height as f64) * view.mm_per_px;
        Horizon { center: view.origin_mm + size * 0.5, radius: 0.75 * size.length() }
    }

    /// Where a ray has left it behind, whether it crosses it or passes it: on the line that touches it and that the ray crosses
    /// squarely. Where it begins if it goes away.
    pub fn end(&self, ray: &Ray) -> DVec2 {
        let to_middle = (self.center - ray.origin).dot(ray.direction);
        ray.at((to_middle + self.radius).max(0.0))
    }
}
