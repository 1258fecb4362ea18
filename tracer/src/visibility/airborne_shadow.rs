//! The shadow of an airborne ball: which fraction of a lamp a sphere hides from the samples of a tile.
//!
//! 1. Seen from a point of the floor, a sphere of radius R whose centre is z above the floor and d across fills a cone:
//!    the directions x with (x . m)^2 >= |x|^2 (|m|^2 - R^2), where m = (d, 0, z).
//! 2. The plane of a lamp of height H cuts the cone in an ellipse. With x = (X, Y, H) and q = z^2 - R^2, completing the
//!    square gives its centre X = d z H / q, its half width B = H R / sqrt(q) in Y, and its half length B sqrt(1 + d^2
//!    / q) in X.
//! 3. Only the part of the lamp's plane beyond the sphere is hidden, or inside it. A ball that reaches above the lamp
//!    hides less, and nothing once its lowest point is as high as the lamp: its shadow fades as it rises past the lamp.
//! 4. The hidden part is convex, so it covers one interval of any line. A tube is one line. A disc is cut into strips,
//!    across the ellipse's edge; their places cos(i pi / (n + 1)) and weights sin^2 are those of the Gauss-Chebyshev
//!    rule of the second kind (Abramowitz and Stegun, 25.4.40), whose weight function is a disc's width.
//!
//! The slow twin is [`crate::visibility::sphere_shadow`]; of lamps that are no larger than the ball they differ by a
//! thousandth of the lamp, of larger ones by up to a sixtieth.

use crate::simd::dispatch::{LANES, SimdLevel, clamp, max, min, multiversion, set_bits};
use crate::tile::packed_samples::PackedSamples;
use crate::tile::planes::Plane;
use crate::tile::rect::TileRect;
use crate::visibility::shadow_bounds::ShadowBounds;
use crate::{Ball, Group, Lamp};
use geometry::{DVec2, trig};
use lines::{Lines, View};

mod lines;

/// The strips of a lamp's disc: the nodes of the quadrature.
const DISC_STRIPS: usize = 16;

/// A smaller visible fraction is 0, so that rounding does not light an umbra.
const MIN_VISIBLE: f32 = 1e-6;

/// A ball that may hide a lamp.
#[derive(Clone, Copy, Debug)]
pub(crate) struct AirborneShadow {
    /// The ball's.
    pub group: Group,
    /// Where it may hide anything.
    pub bounds: ShadowBounds,
    ball_mm: DVec2,
    lamp_mm: DVec2,
    sizes: Sizes,
    shape: EmitterShape,
}

/// The ball and the lamp, as far as it does not matter where they are.
#[derive(Clone, Copy, Debug)]
struct Sizes {
    /// q, mm^2.
    square: f32,
    /// z H / q.
    stretch: f32,
    /// B, mm, and its square.
    width: f32,
    width_square: f32,
    /// The lamp's radius, or half of its length, mm.
    half: f32,
    /// z H, mm^2.
    level: f32,
    /// Whether the ball reaches above the lamp.
    reaches_above: bool,
    /// The radius of the ball's cut at the lamp's height, mm, 0 if there is none; and its square, below 0 if there is
    /// none.
    rim: f32,
    rim_square: f32,
}

/// What of the lamp shines.
#[derive(Clone, Copy, Debug)]
enum EmitterShape {
    Point,
    /// How far each strip of a disc is from its middle, half of its length, and what a millimetre of it counts.
    Disc([[f32; 3]; DISC_STRIPS]),
    /// The unit vector along a tube, and the square of its height.
    Tube([f32; 2], f32),
}

impl AirborneShadow {
    /// `ball`, which is one of [`crate::visibility::sphere_shadow::occluding_balls`].
    pub fn new(lamp: &Lamp, ball: &Ball) -> AirborneShadow {
        let (height, radius, middle) = (lamp.height_mm(), ball.radius_mm, ball.radius_mm + ball.lift_mm());
        // As (z - R) (z + R), which a low ball leaves exact.
        let square = ball.lift_mm() * (middle + radius);
        let rim_square = radius * radius - (height - middle) * (height - middle);
        let sizes = Sizes {
            square: square as f32,
            stretch: (middle * height / square) as f32,
            width: (height * radius / square.sqrt()) as f32,
            width_square: (height * radius * (height * radius) / square) as f32,
            half: lamp.radius_mm() as f32,
            level: (middle * height) as f32,
            reaches_above: height < middle + radius,
            rim: rim_square.max(0.0).sqrt() as f32,
            rim_square: rim_square as f32,
        };
        let shape = match lamp.tube() {
            Some(half) => {
                let along = half / half.length();
                EmitterShape::Tube([along.x as f32, along.y as f32], (height * height) as f32)
            }
            None if lamp.radius_mm() == 0.0 => EmitterShape::Point,
            None => EmitterShape::Disc(strips(lamp.radius_mm())),
        };
        let bounds = ShadowBounds::of_airborne(lamp, ball);
        AirborneShadow { group: ball.group, bounds, ball_mm: ball.center_mm, lamp_mm: lamp.center_mm, sizes, shape }
    }

    /// Takes what it hides from those blocks of a tile's samples whose bits are set.
    pub fn attenuate(
        &self,
        simd: SimdLevel,
        rect: &TileRect,
        samples: &PackedSamples,
        blocks: u16,
        fraction: &mut Plane,
    ) {
        let narrow = |at: DVec2| [(at.x - rect.middle_mm.x) as f32, (at.y - rect.middle_mm.y) as f32];
        let (ball, lamp) = (narrow(self.ball_mm), narrow(self.lamp_mm));
        attenuate(simd, blocks, samples, ball, lamp, &self.sizes, &self.shape, fraction);
    }
}

fn strips(radius: f64) -> [[f32; 3]; DISC_STRIPS] {
    let step = std::f64::consts::PI / (DISC_STRIPS + 1) as f64;
    std::array::from_fn(|strip| {
        let (sin, cos) = trig::sin_cos(step * (strip + 1) as f64);
        let weight = 2.0 * sin * sin / (DISC_STRIPS + 1) as f64;
        [radius * cos, radius * sin, weight / (2.0 * radius * sin)].map(|number| number as f32)
    })
}

multiversion! {
    fn attenuate(
        blocks: u16, samples: &PackedSamples, ball: [f32; 2], lamp: [f32; 2], sizes: &Sizes, shape: &EmitterShape,
        fraction: &mut Plane,
    ) = attenuate_lanes;
}

#[inline(always)]
fn attenuate_lanes(
    blocks: u16,
    samples: &PackedSamples,
    ball: [f32; 2],
    lamp: [f32; 2],
    sizes: &Sizes,
    shape: &EmitterShape,
    fraction: &mut Plane,
) {
    for block in set_bits(blocks) {
        let view = View::new(&samples.x[block], &samples.y[block], ball, lamp, sizes);
        if !view.may_hide(sizes) {
            continue;
        }
        let mut hidden = [0.0; LANES];
        match *shape {
            EmitterShape::Point => {
                let (low, high) = Lines::across_edge(&view, sizes).hidden(sizes, 0.0);
                for i in 0..LANES {
                    hidden[i] = if (low[i] <= 0.0) & (high[i] >= 0.0) { 1.0 } else { 0.0 };
                }
            }
            EmitterShape::Disc(strips) => {
                let lines = Lines::across_edge(&view, sizes);
                for [aside, half, counts] in strips {
                    let (low, high) = lines.hidden(sizes, aside);
                    for i in 0..LANES {
                        let length = min(high[i], half) - max(low[i], -half);
                        hidden[i] += max(length, 0.0) * counts;
                    }
                }
            }
            EmitterShape::Tube(along, height_square) => {
                let lines = Lines::towards(&view, sizes, along);
                let (low, high) = lines.hidden(sizes, 0.0);
                lines.weigh(&view, &low, &high, sizes.half, height_square, &mut hidden);
            }
        }
        let seen = &mut fraction[block];
        for i in 0..LANES {
            let open = clamp(1.0 - hidden[i], 0.0, 1.0);
            seen[i] *= if open < MIN_VISIBLE { 0.0 } else { open };
        }
    }
}
