//! Detectors: lines that measure the rays which cross them and change nothing.

use geometry::{Ray, Segment};
use tracer::transport::Curve;

/// Bins of all detectors together at most.
pub const MOST_BINS: f64 = 1e6;

/// Detectors at most.
pub const MOST_DETECTORS: usize = 1_000;

/// A line that measures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Detector {
    /// Where it is; positions count from its first end.
    pub line: Segment,
    /// Rays from both sides count, with opposite signs; else those from one side.
    pub two_sided: bool,
    /// The width of a bin; `None` if the scene asks for no irradiance map.
    pub bin: Option<f64>,
}

/// What a detector has measured.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Measured {
    /// The power that has crossed it, one way less the other.
    pub power: f64,
    /// The force of the light across it, in units of power.
    pub normal_force: f64,
    /// The force along it, in units of power.
    pub shear_force: f64,
    /// The power in each bin.
    pub bins: Vec<f64>,
}

impl Detector {
    /// A detector that has measured nothing yet.
    pub fn start(&self) -> Measured {
        Measured { bins: vec![0.0; self.bins() as usize], ..Measured::default() }
    }

    /// How many bins it has.
    pub fn bins(&self) -> f64 {
        self.bin.map_or(0.0, |bin| (self.line.length() / bin).ceil())
    }

    /// Counts a ray of this power that goes so far.
    pub fn count(&self, ray: &Ray, distance: f64, power: f64, measured: &mut Measured) {
        let Some(crossing) = Curve::Line(self.line).cross(ray, false) else { return };
        let Some(along) = self.line.along().try_normalize() else { return };
        let across = ray.direction.perp_dot(along);
        if crossing.distance >= distance || (!self.two_sided && across <= 0.0) {
            return;
        }
        let signed = power * across.signum();
        measured.power += signed;
        measured.normal_force += across.abs() * power;
        measured.shear_force -= across.signum() * ray.direction.dot(along) * power;
        if let Some(bin) = self.bin {
            let position = (ray.at(crossing.distance) - self.line.a).dot(along);
            if let Some(sum) = measured.bins.get_mut((position / bin).floor() as usize) {
                *sum += signed;
            }
        }
    }

    /// The irradiance map: the start of each bin and the power in it over its width.
    pub fn irradiance(&self, measured: &Measured) -> Vec<(f64, f64)> {
        let Some(width) = self.bin else { return Vec::new() };
        measured.bins.iter().enumerate().map(|(bin, power)| (bin as f64 * width, power / width)).collect()
    }
}
