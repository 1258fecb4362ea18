//! What a floating ball hides of a lamp from the points of a tile.
//!
//! Seen from a point of the floor, a ball of radius R whose middle is z above the floor and d aside lies in a cone, and
//! that cuts the plane of a lamp of height H in an ellipse: with q = z^2 - R^2 its middle is d z H / q aside, it is
//! B = H R / sqrt(q) wide to each side, and sqrt(1 + d^2 / q) as long as wide. Only what is beyond the sphere is hidden,
//! or inside of it: of a ball that reaches above the lamp that is less, and nothing once its lowest point is as high as
//! the lamp, so its shadow fades as it rises past the lamp.
//!
//! What is hidden is convex, so it covers one interval of any line. A segment that shines is one line. A disc is cut into
//! strips, across what hides it, whose places and weights are those of the Gauss-Chebyshev rule of the second kind. The
//! slow twin is [`crate::sphere`].

use crate::angle::angle;
use crate::lanes::{LANES, Lanes, Path, clamp, clones, max, min, ones};
use crate::penumbra::Penumbra;
use crate::place::Place;
use crate::points::{Plane, Points};
use crate::{Ball, Group, Lamp};
use geometry::{DVec2, trig};

/// Into how many strips a lamp's disc is cut.
const STRIPS: usize = 16;

/// How near the point may be to the place under the ball's middle, mm: nearer ones are taken to be so far from it.
const LEAST_OFF_MM: f32 = 1e-3;

/// An end that no line has.
const FAR: f32 = 1e30;

/// Less of a lamp is nothing.
const UNSEEN: f32 = 1e-6;

/// A ball that may hide a lamp.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Floating {
    /// The ball's.
    pub group: Group,
    /// Where it may hide anything.
    pub penumbra: Penumbra,
    ball_mm: DVec2,
    lamp_mm: DVec2,
    sizes: Sizes,
    shape: Shape,
}

/// The ball and the lamp, as far as it does not matter where they are.
#[derive(Clone, Copy, Debug)]
struct Sizes {
    /// q, mm^2.
    square: f32,
    /// z H / q.
    stretch: f32,
    /// B^2, mm^2.
    width_square: f32,
    /// z H, mm^2.
    level: f32,
    /// Whether the ball reaches above the lamp.
    reaches_above: bool,
    /// The square of the radius of the ball's cut at the lamp's height, mm^2; below 0 if there is none.
    rim_square: f32,
}

/// What of the lamp shines.
#[derive(Clone, Copy, Debug)]
enum Shape {
    Point,
    /// How far each strip of a disc is from its middle, half of its length, and what a millimetre of it counts; and the
    /// radius.
    Disc([[f32; 3]; STRIPS], f32),
    /// The unit vector along a segment, half of its length, and the square of its height.
    Tube([f32; 2], f32, f32),
}

impl Floating {
    /// `ball`, which is one of [`crate::sphere::hiding`].
    pub fn new(lamp: &Lamp, ball: &Ball) -> Floating {
        let (height, radius, middle) = (lamp.height_mm(), ball.radius_mm, ball.radius_mm + ball.lift_mm());
        // As (z - R) (z + R), which a low ball leaves exact.
        let square = ball.lift_mm() * (middle + radius);
        let sizes = Sizes {
            square: square as f32,
            stretch: (middle * height / square) as f32,
            width_square: (height * radius * (height * radius) / square) as f32,
            level: (middle * height) as f32,
            reaches_above: height < middle + radius,
            rim_square: (radius * radius - (height - middle) * (height - middle)) as f32,
        };
        let shape = match lamp.tube() {
            Some(half) => {
                let along = half / half.length();
                Shape::Tube([along.x as f32, along.y as f32], half.length() as f32, (height * height) as f32)
            }
            None if lamp.radius_mm() == 0.0 => Shape::Point,
            None => Shape::Disc(strips(lamp.radius_mm()), lamp.radius_mm() as f32),
        };
        let penumbra = Penumbra::of_floating(lamp, ball);
        Floating { group: ball.group, penumbra, ball_mm: ball.center_mm, lamp_mm: lamp.center_mm, sizes, shape }
    }

    /// Takes what it hides from those blocks of a tile's points whose bits are set.
    pub fn veil(&self, path: Path, place: &Place, points: &Points, blocks: u16, fraction: &mut Plane) {
        let narrow = |at: DVec2| [(at.x - place.middle_mm.x) as f32, (at.y - place.middle_mm.y) as f32];
        let (ball, lamp) = (narrow(self.ball_mm), narrow(self.lamp_mm));
        veil(path, blocks, points, ball, lamp, &self.sizes, &self.shape, fraction);
    }
}

fn strips(radius: f64) -> [[f32; 3]; STRIPS] {
    let step = std::f64::consts::PI / (STRIPS + 1) as f64;
    std::array::from_fn(|strip| {
        let (sin, cos) = trig::sin_cos(step * (strip + 1) as f64);
        let weight = 2.0 * sin * sin / (STRIPS + 1) as f64;
        [radius * cos, radius * sin, weight / (2.0 * radius * sin)].map(|number| number as f32)
    })
}

clones! {
    fn veil(
        blocks: u16, points: &Points, ball: [f32; 2], lamp: [f32; 2], sizes: &Sizes, shape: &Shape,
        fraction: &mut Plane,
    ) = veil_lanes;
}

#[inline(always)]
fn veil_lanes(
    blocks: u16,
    points: &Points,
    ball: [f32; 2],
    lamp: [f32; 2],
    sizes: &Sizes,
    shape: &Shape,
    fraction: &mut Plane,
) {
    for block in ones(blocks) {
        let mut view = View::new(&points.x[block], &points.y[block], ball, lamp, sizes);
        let mut hidden = [0.0; LANES];
        match *shape {
            Shape::Point => {
                view.face_edge(0.0);
                view.cover(sizes, 0.0);
                for i in 0..LANES {
                    hidden[i] = if (view.low[i] <= 0.0) & (view.high[i] >= 0.0) { 1.0 } else { 0.0 };
                }
            }
            Shape::Disc(strips, radius) => {
                view.face_edge(max(radius - sizes.width_square.sqrt(), 0.0));
                for [aside, half, counts] in strips {
                    view.cover(sizes, aside);
                    for i in 0..LANES {
                        let length = min(view.high[i], half) - max(view.low[i], -half);
                        hidden[i] += max(length, 0.0) * counts;
                    }
                }
            }
            Shape::Tube(along, half, height_square) => {
                view.face(along);
                view.cover(sizes, 0.0);
                view.weigh(half, height_square, &mut hidden);
            }
        }
        let seen = &mut fraction[block];
        for i in 0..LANES {
            let open = clamp(1.0 - hidden[i], 0.0, 1.0);
            seen[i] *= if open < UNSEEN { 0.0 } else { open };
        }
    }
}

/// A lamp and a ball seen from a block of points. The first axis goes from the point to below the ball's middle.
struct View {
    /// How far that is.
    off: Lanes,
    /// That axis on the table.
    axis_x: Lanes,
    axis_y: Lanes,
    /// The lamp's middle, from the point.
    lamp_x: Lanes,
    lamp_y: Lanes,
    /// The same, from the ellipse's middle.
    from_x: Lanes,
    /// The square of the ellipse's width over that of its length.
    round: Lanes,
    /// The unit vector along the lines that are asked.
    along_x: Lanes,
    along_y: Lanes,
    /// Which part of a line is hidden, from its middle.
    low: Lanes,
    high: Lanes,
}

impl View {
    #[inline(always)]
    fn new(x: &Lanes, y: &Lanes, ball: [f32; 2], lamp: [f32; 2], sizes: &Sizes) -> View {
        let zero = [0.0; LANES];
        let (mut off, mut axis_x, mut axis_y, mut round) = (zero, zero, zero, zero);
        let (mut lamp_x, mut lamp_y, mut from_x) = (zero, zero, zero);
        for i in 0..LANES {
            let (dx, dy) = (ball[0] - x[i], ball[1] - y[i]);
            let distance = (dx * dx + dy * dy).sqrt();
            let here = distance < LEAST_OFF_MM;
            off[i] = max(distance, LEAST_OFF_MM);
            axis_x[i] = if here { 1.0 } else { dx / off[i] };
            axis_y[i] = if here { 0.0 } else { dy / off[i] };
            let (lx, ly) = (lamp[0] - x[i], lamp[1] - y[i]);
            lamp_x[i] = lx * axis_x[i] + ly * axis_y[i];
            lamp_y[i] = ly * axis_x[i] - lx * axis_y[i];
            from_x[i] = lamp_x[i] - off[i] * sizes.stretch;
            round[i] = sizes.square / (off[i] * off[i] + sizes.square);
        }
        View { off, axis_x, axis_y, lamp_x, lamp_y, from_x, round, along_x: zero, along_y: zero, low: zero, high: zero }
    }

    /// Asks lines across the ellipse's edge, where that is nearest to the lamp; `beyond` is how much wider to each side
    /// the lamp is than the ellipse: then both of its long edges may be before the lamp.
    #[inline(always)]
    fn face_edge(&mut self, beyond: f32) {
        for i in 0..LANES {
            let aside = if self.lamp_y[i] < 0.0 { self.lamp_y[i] - beyond } else { self.lamp_y[i] + beyond };
            let (x, y) = (self.round[i] * self.from_x[i], aside);
            let length = (x * x + y * y).sqrt();
            let here = length < 1e-6;
            let scale = 1.0 / max(length, 1e-6);
            self.along_x[i] = if here { 1.0 } else { x * scale };
            self.along_y[i] = if here { 0.0 } else { y * scale };
        }
    }

    /// Asks lines in a direction on the table.
    #[inline(always)]
    fn face(&mut self, along: [f32; 2]) {
        for i in 0..LANES {
            self.along_x[i] = along[0] * self.axis_x[i] + along[1] * self.axis_y[i];
            self.along_y[i] = along[1] * self.axis_x[i] - along[0] * self.axis_y[i];
        }
    }

    /// Finds what is hidden of a line that passes the lamp's middle at a distance.
    #[inline(always)]
    fn cover(&mut self, sizes: &Sizes, aside: f32) {
        for i in 0..LANES {
            let (ex, ey, round) = (self.along_x[i], self.along_y[i], self.round[i]);
            let (x, y) = (self.from_x[i] - aside * ey, self.lamp_y[i] + aside * ex);
            // round x^2 + y^2 = B^2 along the line.
            let scale = 1.0 / (round * ex * ex + ey * ey);
            let across = ex * y - ey * x;
            let half_square = (sizes.width_square - round * across * across * scale) * scale;
            let half = max(half_square, 0.0).sqrt();
            let middle = -(round * x * ex + y * ey) * scale;
            let meets = half_square > 0.0;
            self.low[i] = if meets { middle - half } else { FAR };
            self.high[i] = if meets { middle + half } else { -FAR };
        }
        if sizes.reaches_above {
            self.cut(sizes, aside);
        }
    }

    /// Leaves of the ellipse what is beyond where the cone touches the ball, and adds what is inside the ball.
    #[inline(always)]
    fn cut(&mut self, sizes: &Sizes, aside: f32) {
        for i in 0..LANES {
            let (ex, ey, off) = (self.along_x[i], self.along_y[i], self.off[i]);
            let touch = (off * off + sizes.square - sizes.level) / off;
            let before = touch - self.lamp_x[i] + aside * ey;
            let upright = max(ex, -ex) < 1e-6;
            let place = before / (if upright { 1.0 } else { ex });
            let from = if upright { if before > 0.0 { FAR } else { -FAR } } else { place };
            let forward = upright | (ex > 0.0);
            let low = if forward { max(self.low[i], from) } else { self.low[i] };
            let high = if forward { self.high[i] } else { min(self.high[i], from) };
            let empty = low > high;
            let (bx, by) = (off - self.lamp_x[i], -self.lamp_y[i]);
            let (middle, by_side) = (bx * ex + by * ey, by * ex - bx * ey - aside);
            let half_square = sizes.rim_square - by_side * by_side;
            let half = max(half_square, 0.0).sqrt();
            let meets = half_square > 0.0;
            let (inner_low, inner_high) = (middle - half, middle + half);
            self.low[i] = min(if empty { FAR } else { low }, if meets { inner_low } else { FAR });
            self.high[i] = max(if empty { -FAR } else { high }, if meets { inner_high } else { -FAR });
        }
    }

    /// Weighs what is hidden of a segment by what arrives: a stretch counts the angle that it is seen under.
    #[inline(always)]
    fn weigh(&self, half: f32, height_square: f32, hidden: &mut Lanes) {
        for i in 0..LANES {
            let (low, high) = (max(self.low[i], -half), min(self.high[i], half));
            let (foot, side) = (
                self.lamp_x[i] * self.along_x[i] + self.lamp_y[i] * self.along_y[i],
                self.lamp_y[i] * self.along_x[i] - self.lamp_x[i] * self.along_y[i],
            );
            let square = side * side + height_square;
            let off = square.sqrt();
            let part = angle(square + (foot + low) * (foot + high), max(high - low, 0.0) * off);
            let whole = angle(square + (foot - half) * (foot + half), 2.0 * half * off);
            hidden[i] = if high > low { part / whole } else { 0.0 };
        }
    }
}
