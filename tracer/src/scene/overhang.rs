//! Overhangs: what hangs above the balls: a ramp's floor, the wires of a wire-form.
//!
//! Balls are drawn over everything else. Where one rolls below an overhang, only what the overhang lets through of it is seen; the
//! rest is what was there without the ball, the overhang's own look among it.

use crate::Ball;
use geometry::{DVec2, Shape};

/// Something that hangs above the balls.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Overhang {
    /// Its outline from above, mm.
    pub shape: Shape,
    /// How much is seen through it of what is below, 0 to 1.
    pub passes: f32,
}

impl Overhang {
    /// Whether it may hide a part of the ball.
    pub(crate) fn is_near(&self, ball: &Ball) -> bool {
        self.shape.bounds().grown(ball.radius_mm + 1.0).contains(ball.center_mm)
    }

    /// How much of what is below it is seen at a pixel of this size.
    pub(crate) fn passes_at(&self, point_mm: DVec2, mm_per_px: f64) -> f32 {
        let covered = (0.5 - self.shape.distance(point_mm).0 / mm_per_px).clamp(0.0, 1.0) as f32;
        1.0 - covered * (1.0 - self.passes.clamp(0.0, 1.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_overhang_hides_what_it_covers_and_half_at_its_edge() {
        let overhang = Overhang { shape: Shape::capsule(DVec2::ZERO, DVec2::new(100.0, 0.0), 20.0), passes: 0.6 };
        for (y, seen) in [(0.0, 0.6), (19.0, 0.6), (20.0, 0.8), (21.0, 1.0), (50.0, 1.0)] {
            assert!((overhang.passes_at(DVec2::new(40.0, y), 1.0) - seen).abs() < 1e-6, "at {y}");
        }
    }
}
