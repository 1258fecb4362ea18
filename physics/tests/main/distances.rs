//! The oracle's own geometry: how far a point is from an outline, by the plainest means.
//!
//! None of the crate's distances or rays is used: a wrong one there must show here.

use geometry::DVec2;

/// What a ball may meet, as the oracle sees it.
#[derive(Clone, Copy, Debug)]
pub enum Outline {
    Disc {
        center: DVec2,
        radius: f64,
    },
    Capsule {
        a: DVec2,
        b: DVec2,
        radius: f64,
    },
    /// A bent strip: its line's centre and radius, where it starts and how far it goes (positive), and half its width.
    Bow {
        center: DVec2,
        line: f64,
        start: f64,
        sweep: f64,
        radius: f64,
    },
    /// The hull of two discs.
    Hull {
        a: DVec2,
        a_radius: f64,
        b: DVec2,
        b_radius: f64,
    },
}

impl Outline {
    /// Distance of `point` from the outline; below 0 inside.
    pub fn distance(&self, point: DVec2) -> f64 {
        match *self {
            Outline::Disc { center, radius } => (point - center).length() - radius,
            Outline::Capsule { a, b, radius } => {
                let part = ((point - a).dot(b - a) / (b - a).dot(b - a)).clamp(0.0, 1.0);
                (point - (a + (b - a) * part)).length() - radius
            }
            Outline::Bow { center, line, start, sweep, radius } => {
                let from = point - center;
                let turn = (libm::atan2(from.y, from.x) - start).rem_euclid(std::f64::consts::TAU);
                let end = |angle: f64| center + line * DVec2::new(libm::cos(angle), libm::sin(angle));
                let to_line = (from.length() - line).abs();
                let to_ends = (point - end(start)).length().min((point - end(start + sweep)).length());
                (if turn <= sweep { to_line } else { to_ends }) - radius
            }
            Outline::Hull { a, a_radius, b, b_radius } => {
                // The nearest of all the discs between the two: a convex function of how far along they are.
                let disc =
                    |part: f64| (point - (a + (b - a) * part)).length() - (a_radius + (b_radius - a_radius) * part);
                least(disc)
            }
        }
    }

    /// The unit vector in which the distance grows fastest at `point`.
    pub fn normal(&self, point: DVec2) -> DVec2 {
        slope(|point| self.distance(point), point)
    }
}

/// The direction in which `distance` grows fastest, by differences.
pub fn slope(distance: impl Fn(DVec2) -> f64, point: DVec2) -> DVec2 {
    let step = 1e-6;
    let along = |way: DVec2| distance(point + way * step) - distance(point - way * step);
    DVec2::new(along(DVec2::X), along(DVec2::Y)).normalize()
}

/// The least value of a convex function on [0, 1], by ever smaller thirds.
fn least(value: impl Fn(f64) -> f64) -> f64 {
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..64 {
        let third = (high - low) / 3.0;
        if value(low + third) < value(high - third) {
            high -= third;
        } else {
            low += third;
        }
    }
    value(low).min(value(high)).min(value(0.0)).min(value(1.0))
}
