//! The scene of the race: a square with four point lamps and three circles, at one time and on one grid of pixels.

use geometry::{Circle, DVec2, trig};
use tracer::Rgb;

/// The square's side; the origin is its upper left corner.
pub const SIDE: f64 = 5.0;

/// The same in single precision.
pub(crate) const SIDE_F32: f32 = SIDE as f32;

/// The colours of the lamps: upper left, upper right, lower left, lower right.
pub(crate) const COLORS: [Rgb; 4] = [[1.0, 0.6, 0.3], [0.3, 0.5, 1.0], [0.4, 1.0, 0.5], [1.0, 0.3, 0.5]];

/// A lamp's irradiance at distance 0: with the brightest colour of each channel, the sum of four stays below 1.
pub(crate) const POWER: f32 = 0.9;
/// The level of a full byte: light is summed in levels, so that nothing needs to be scaled later.
const WHITE: f32 = 255.0;

/// A lamp's colour at full power, in levels of a byte.
#[inline(always)]
pub(crate) fn color(lamp: usize, channel: usize) -> f32 {
    COLORS[lamp][channel] * (POWER * WHITE)
}

/// How far the circles' centres are from the square's.
const ORBIT_RADIUS: f64 = 1.3;

/// How fast the circles go round, radians a second: one round in nine seconds.
const ORBIT_RAD_S: f64 = 0.7;

/// The circles at a time: they go round the middle, a third of a turn apart.
///
/// Their centres stay 2.25 from each other, and the circles 0.2 off the walls.
pub fn circles(seconds: f64) -> [Circle; 3] {
    [0.0, 1.0, 2.0].map(|number| {
        let angle = seconds * ORBIT_RAD_S + number * std::f64::consts::TAU / 3.0;
        Circle { center: DVec2::splat(SIDE * 0.5) + trig::direction(angle) * ORBIT_RADIUS, radius: 1.0 }
    })
}

/// The corner that a lamp stands in.
#[inline(always)]
pub(crate) fn corner(lamp: usize) -> (f32, f32) {
    ((lamp % 2) as f32 * SIDE_F32, (lamp / 2) as f32 * SIDE_F32)
}

/// A circle in single precision.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Disc {
    pub x: f32,
    pub y: f32,
    pub radius: f32,
    /// The square of its radius.
    pub square: f32,
}

impl From<Circle> for Disc {
    fn from(circle: Circle) -> Disc {
        let radius = circle.radius as f32;
        Disc { x: circle.center.x as f32, y: circle.center.y as f32, radius, square: radius * radius }
    }
}

/// The circles at one time, and where the pixels are.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scene {
    pub discs: [Disc; 3],
    pub width: usize,
    /// A pixel's width in the scene.
    step: f32,
    /// A pixel's height in the scene.
    step_down: f32,
}

impl Scene {
    pub fn new(seconds: f64, width: usize, height: usize) -> Scene {
        let discs = circles(seconds).map(Disc::from);
        Scene { discs, width, step: SIDE_F32 / width as f32, step_down: SIDE_F32 / height as f32 }
    }

    /// The centre of a column of pixels.
    #[inline(always)]
    pub fn x(&self, column: usize) -> f32 {
        (column as u32 as f32 + 0.5) * self.step
    }

    /// The centre of a row of pixels.
    #[inline(always)]
    pub fn y(&self, row: usize) -> f32 {
        (row as u32 as f32 + 0.5) * self.step_down
    }
}
