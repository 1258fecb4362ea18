//! Light sources: what sends light out, how much, and of which wavelengths.

use super::spectrum::{Emission, WavelengthSampler, Weights};
use geometry::{DVec2, Ray, Segment, trig};
use std::f64::consts::{PI, TAU};

/// A source of light. Nothing is in its own way: light of others passes it.
#[derive(Clone, Debug, PartialEq)]
pub struct LightSource {
    /// From where, and in which directions.
    pub form: SourceForm,
    /// Its wavelengths.
    pub emission: Emission,
    /// The power that it would have with equal energy, P: alone, at distance d from a point of light, the fluence is
    /// P / (2 pi d). A colour that is not white has less.
    pub power: f64,
    /// How its light fades with the way that it has gone.
    pub falloff: Falloff,
}

/// From where light comes, and in which directions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SourceForm {
    /// A point that shines alike in all directions.
    Point(DVec2),
    /// A disc whose rim shines as a matt surface does: radiance alike in all outward directions.
    Disc {
        /// Its middle.
        center: DVec2,
        /// Its radius, over 0.
        radius: f64,
    },
    /// A line of points that each shine alike in all directions, as the gas in a tube does.
    Tube(Segment),
    /// A point that shines alike in all directions of an angle.
    Cone {
        /// The point.
        center: DVec2,
        /// The direction of the middle, of length 1.
        axis: DVec2,
        /// From the middle to the edge, rad, over 0 to pi.
        half_angle: f64,
    },
    /// A line of points that all shine to its left (y up), alike in all directions of an angle; parallel light if that is 0.
    Beam {
        /// The line.
        line: Segment,
        /// From the middle to the edge, rad, 0 to pi/2.
        half_angle: f64,
    },
}

/// How light fades with the way that it has gone, beside its spreading out.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Falloff {
    /// As light does in two dimensions: not at all.
    #[default]
    Plane,
    /// As on the game's tables: a way s weighs `2 pi s F(s)` with `F(s) = r^2 / (s^2 + h^2) (1 - (s / reach)^2)^2` and
    /// r = 100 mm, so that light that meets nothing is that of a [`crate::Lamp`].
    Table {
        /// h, mm.
        height_mm: f64,
        /// Where its light ends, mm.
        reach_mm: f64,
    },
}

impl Falloff {
    /// What no weight is over: a table's `2 pi r^2 s / (s^2 + h^2)` is highest at s = h.
    pub fn most(&self) -> f64 {
        match *self {
            Falloff::Plane => 1.0,
            Falloff::Table { height_mm, .. } => PI * crate::Lamp::REFERENCE_MM * crate::Lamp::REFERENCE_MM / height_mm,
        }
    }

    /// The weight of light that has gone this way.
    pub fn weight(&self, way: f64) -> f64 {
        match *self {
            Falloff::Plane => 1.0,
            Falloff::Table { height_mm, reach_mm } => {
                let window = (1.0 - (way / reach_mm) * (way / reach_mm)).max(0.0);
                let reference = crate::Lamp::REFERENCE_MM * crate::Lamp::REFERENCE_MM;
                TAU * way * reference / (way * way + height_mm * height_mm) * window * window
            }
        }
    }
}

/// Draws of a spectrum for its colour.
const COLOR_DRAWS: u32 = 4096;

impl LightSource {
    /// The colour of its light, linear and signed, times its power.
    pub fn color(&self, weights: &Weights) -> [f64; 3] {
        let sampler = WavelengthSampler::new(&self.emission);
        let mut sum = [0.0; 3];
        for draw in 0..COLOR_DRAWS {
            let sample = sampler.sample((f64::from(draw) + 0.5) / f64::from(COLOR_DRAWS));
            let at = weights.at(sample.nm);
            (0..3).for_each(|channel| sum[channel] += sample.weight * f64::from(at[channel]));
        }
        sum.map(|channel| channel * self.power * sampler.mean() / f64::from(COLOR_DRAWS))
    }
}

impl SourceForm {
    /// The ray at a place of the unit square: equal areas of the square have equal power.
    pub fn emit(&self, [u, v]: [f64; 2]) -> Ray {
        match *self {
            SourceForm::Point(origin) => Ray { origin, direction: trig::direction(TAU * u) },
            SourceForm::Disc { center, radius } => {
                let outward = trig::direction(TAU * u);
                Ray { origin: center + outward * radius, direction: lambert(outward, v) }
            }
            SourceForm::Tube(line) => Ray { origin: line.a + line.along() * v, direction: trig::direction(TAU * u) },
            SourceForm::Cone { center, axis, half_angle } => {
                Ray { origin: center, direction: trig::rotate(axis, (2.0 * u - 1.0) * half_angle) }
            }
            SourceForm::Beam { line, half_angle } => {
                let forward = line.left_normal().unwrap_or(DVec2::X);
                let direction =
                    if half_angle == 0.0 { forward } else { trig::rotate(forward, (2.0 * v - 1.0) * half_angle) };
                Ray { origin: line.a + line.along() * u, direction }
            }
        }
    }

    /// How far light of this ray counts as having come where it leaves the source, mm: ways are measured from a disc's middle, as
    /// those of a [`crate::Lamp`] are.
    pub fn head_start(&self, ray: &Ray) -> f64 {
        match *self {
            SourceForm::Disc { center, .. } => (ray.origin - center).dot(ray.direction),
            _ => 0.0,
        }
    }

    /// A point of it.
    pub fn middle(&self) -> DVec2 {
        match *self {
            SourceForm::Point(center) | SourceForm::Disc { center, .. } | SourceForm::Cone { center, .. } => center,
            SourceForm::Tube(line) | SourceForm::Beam { line, .. } => (line.a + line.b) * 0.5,
        }
    }

    /// The fluence of unit power at a point that sees all of it with nothing between; infinite at a point of light. `None` for
    /// parallel light, which is found by its beam alone.
    pub fn fluence(&self, point: DVec2) -> Option<f64> {
        match *self {
            SourceForm::Point(center) => Some(1.0 / (TAU * point.distance(center))),
            SourceForm::Disc { center, radius } => {
                let distance = point.distance(center);
                // Radiance 1 / (4 pi a), from all directions within the disc.
                let angle = if distance > radius { 2.0 * libm::asin(radius / distance) } else { TAU };
                Some(angle / (4.0 * PI * radius))
            }
            SourceForm::Tube(line) => {
                // The integral of dx / sqrt(x^2 + h^2) over the line, over its length and 2 pi.
                let length = line.length();
                let along = line.along() / length;
                let [from, to] = [line.a, line.b].map(|end| (end - point).dot(along));
                let height = (line.a - point).perp_dot(along).abs();
                Some((libm::asinh(to / height) - libm::asinh(from / height)) / (TAU * length))
            }
            SourceForm::Cone { center, axis, half_angle } => {
                let away = point - center;
                let inside = away.dot(axis) >= libm::cos(half_angle) * away.length();
                Some(if inside { 1.0 / (2.0 * half_angle * away.length()) } else { 0.0 })
            }
            SourceForm::Beam { .. } => None,
        }
    }
}

/// The direction at `unit` (0 to 1) of what a matt surface sends out: the sine of its angle is uniform.
pub fn lambert(normal: DVec2, unit: f64) -> DVec2 {
    let sine = 2.0 * unit - 1.0;
    let cosine = (1.0 - sine * sine).max(0.0).sqrt();
    normal * cosine + normal.perp() * sine
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The ways in which rays leave say what a point gets: counted over a small disc there.
    #[test]
    fn the_fluence_of_a_source_is_that_of_its_rays() {
        let forms = [
            SourceForm::Point(DVec2::new(1.0, 2.0)),
            SourceForm::Disc { center: DVec2::new(1.0, 2.0), radius: 3.0 },
            SourceForm::Tube(Segment { a: DVec2::new(-4.0, 1.0), b: DVec2::new(5.0, 3.0) }),
            SourceForm::Cone { center: DVec2::ZERO, axis: DVec2::new(0.6, 0.8), half_angle: 0.7 },
        ];
        let (point, radius) = (DVec2::new(9.0, 8.0), 0.5);
        for form in forms {
            let side = 2_000;
            let mut length = 0.0;
            for cell in 0..side * side {
                let [u, v] = [cell % side, cell / side].map(|at| (f64::from(at) + 0.5) / f64::from(side));
                let ray = form.emit([u, v]);
                assert!((ray.direction.length() - 1.0).abs() < 1e-12);
                let to = point - ray.origin;
                let (along, across) = (to.dot(ray.direction), to.perp_dot(ray.direction));
                if along > 0.0 && across.abs() < radius {
                    length += 2.0 * (radius * radius - across * across).sqrt();
                }
            }
            let counted = length / f64::from(side * side) / (PI * radius * radius);
            let expected = form.fluence(point).expect("it has one");
            // The mean over a disc of this size is not its middle's value: 0.2 % is its second order.
            assert!((counted / expected - 1.0).abs() < 4e-3, "{form:?}: {counted} {expected}");
        }
    }
}
