//! The classic race: a room, a lamp in each corner, three circles that move, everything lit anew for each picture.
//!
//! The room is 5 x 5, the circles have radius 1 and never overlap, and a pixel's light is `0.9 / (1 + d^2)` from each
//! lamp that no circle hides, each lamp in its own colour. The same picture is made five ways, from literal loops to
//! whole runs of pixels: a circle's shadow on a row of pixels is one interval, so nothing needs to be asked pixel by
//! pixel. Every way first fills a picture of floats and then turns it into 32-bit pixels.

use crate::lanes::{LANES, Lanes, Path, clones, max, min};
use crate::{Frame, Rgb};
use geometry::{Circle, DVec2, trig};
use rayon::prelude::*;

/// The room's side.
pub const SIDE: f64 = 5.0;

/// The colours of the lamps: upper left, upper right, lower left, lower right.
const COLORS: [Rgb; 4] = [[1.0, 0.6, 0.3], [0.3, 0.5, 1.0], [0.4, 1.0, 0.5], [1.0, 0.3, 0.5]];

/// A lamp's light at no distance.
const POWER: f32 = 0.9;

/// Rows that one task makes.
const ROWS: usize = 8;

/// The circles at a time: they go round the middle, a third of a turn apart.
///
/// Their middles stay 1.3 from the room's, so 2.25 from each other, and 0.2 off the walls.
pub fn circles(seconds: f64) -> [Circle; 3] {
    [0.0, 1.0, 2.0].map(|number| {
        let angle = seconds * 0.7 + number * std::f64::consts::TAU / 3.0;
        Circle { center: DVec2::splat(SIDE * 0.5) + trig::direction(angle) * 1.3, radius: 1.0 }
    })
}

/// The ways to make the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// For each pixel, for each lamp, for each circle: does it hide the lamp? One thread.
    Literal,
    /// The same on all threads of the current rayon pool.
    LiteralThreads,
    /// The same question for 16 pixels at a time. One thread.
    Lanes,
    /// Each lamp's and circle's shadow on a row is one interval; the rest of the row is lit. One thread.
    Spans,
    /// The same on all threads of the current rayon pool.
    SpansThreads,
    /// Writes the same bytes and computes nothing: what no method can beat.
    Fill,
}

impl Method {
    /// Every method, the slowest first.
    pub const ALL: [Method; 6] =
        [Method::Literal, Method::LiteralThreads, Method::Lanes, Method::Spans, Method::SpansThreads, Method::Fill];

    /// A name for tables.
    pub fn name(self) -> &'static str {
        match self {
            Method::Literal => "literal loops",
            Method::LiteralThreads => "literal loops, all threads",
            Method::Lanes => "lanes per pixel",
            Method::Spans => "shadow spans",
            Method::SpansThreads => "shadow spans, all threads",
            Method::Fill => "fill the same bytes",
        }
    }
}

/// The room's picture: keep one, and it allocates only when its size changes.
#[derive(Clone, Debug, Default)]
pub struct Room {
    width: usize,
    /// Red, green and blue of a row, one after another, row by row.
    light: Vec<f32>,
}

impl Room {
    /// Makes the picture of a moment, `width` x `height` pixels, into `frame`.
    pub fn render(&mut self, method: Method, seconds: f64, width: usize, height: usize, frame: &mut Frame) {
        (frame.width, frame.height) = (width, height);
        frame.pixels.resize(width * height, 0);
        self.width = width;
        self.light.resize(width * height * 3, 0.0);
        if width == 0 || height == 0 {
            return;
        }
        let scene = Moment { circles: circles(seconds).map(Disc::from), width, height };
        let path = Path::best();
        let render = |(band, (light, pixels)): (usize, (&mut [f32], &mut [u32]))| {
            let rows = light.chunks_mut(width * 3).zip(pixels.chunks_mut(width)).enumerate();
            for (row, (light, pixels)) in rows {
                let y = band * ROWS + row;
                match method {
                    Method::Literal | Method::LiteralThreads => literal_row(&scene, y, light),
                    Method::Lanes => lanes_row(path, &scene, y, light),
                    Method::Spans | Method::SpansThreads => spans_row(path, &scene, y, light),
                    Method::Fill => light.fill(0.5),
                }
                match method {
                    Method::Literal | Method::LiteralThreads => literal_pixels(light, pixels),
                    Method::Fill => pixels.fill(0x80_8080),
                    _ => pack(path, light, pixels),
                }
            }
        };
        let (floats, pixels) = (width * 3 * ROWS, width * ROWS);
        match method {
            Method::LiteralThreads | Method::SpansThreads => {
                let bands = self.light.par_chunks_mut(floats).zip(frame.pixels.par_chunks_mut(pixels));
                bands.enumerate().for_each(render);
            }
            _ => self.light.chunks_mut(floats).zip(frame.pixels.chunks_mut(pixels)).enumerate().for_each(render),
        }
    }
}

/// A circle in single precision.
#[derive(Clone, Copy, Debug)]
struct Disc {
    x: f32,
    y: f32,
    square: f32,
}

impl From<Circle> for Disc {
    fn from(circle: Circle) -> Disc {
        Disc { x: circle.center.x as f32, y: circle.center.y as f32, square: (circle.radius * circle.radius) as f32 }
    }
}

/// The room at one moment, on a grid of pixels.
#[derive(Clone, Copy, Debug)]
struct Moment {
    circles: [Disc; 3],
    width: usize,
    height: usize,
}

impl Moment {
    fn x(&self, column: usize) -> f32 {
        (column as f32 + 0.5) * (SIDE as f32 / self.width as f32)
    }

    fn y(&self, row: usize) -> f32 {
        (row as f32 + 0.5) * (SIDE as f32 / self.height as f32)
    }
}

/// The corner that a lamp stands in.
#[inline(always)]
fn corner(lamp: usize) -> (f32, f32) {
    ((lamp % 2) as f32 * SIDE as f32, (lamp / 2) as f32 * SIDE as f32)
}

/// Whether the straight way from a point to a lamp meets a circle, or the point is in it.
#[inline(always)]
fn hides(disc: &Disc, x: f32, y: f32, (lx, ly): (f32, f32)) -> bool {
    let (wx, wy) = (lx - x, ly - y);
    let (cx, cy) = (disc.x - x, disc.y - y);
    let along = (wx * cx + wy * cy) / (wx * wx + wy * wy);
    let nearest = max(min(along, 1.0), 0.0);
    let (dx, dy) = (cx - wx * nearest, cy - wy * nearest);
    dx * dx + dy * dy < disc.square
}

#[inline(always)]
fn falloff(x: f32, y: f32, (lx, ly): (f32, f32)) -> f32 {
    POWER / (1.0 + (lx - x) * (lx - x) + (ly - y) * (ly - y))
}

fn literal_row(scene: &Moment, row: usize, light: &mut [f32]) {
    let (width, y) = (scene.width, scene.y(row));
    for column in 0..width {
        let x = scene.x(column);
        let mut sum = [0.0; 3];
        for (lamp, color) in COLORS.iter().enumerate() {
            let mut lit = true;
            for disc in &scene.circles {
                if hides(disc, x, y, corner(lamp)) {
                    lit = false;
                    break;
                }
            }
            if lit {
                for channel in 0..3 {
                    sum[channel] += color[channel] * falloff(x, y, corner(lamp));
                }
            }
        }
        for channel in 0..3 {
            light[channel * width + column] = sum[channel];
        }
    }
}

fn literal_pixels(light: &[f32], pixels: &mut [u32]) {
    let width = pixels.len();
    for (column, pixel) in pixels.iter_mut().enumerate() {
        let byte = |channel: usize| (light[channel * width + column].clamp(0.0, 1.0) * 255.0 + 0.5) as u32;
        *pixel = byte(0) << 16 | byte(1) << 8 | byte(2);
    }
}

clones! {
    /// A row of light, with every question asked for 16 pixels at a time.
    fn lanes_row(scene: &Moment, row: usize, light: &mut [f32]) = lanes_row_lanes;
}

#[inline(always)]
fn lanes_row_lanes(scene: &Moment, row: usize, light: &mut [f32]) {
    let (width, y) = (scene.width, scene.y(row));
    let step = SIDE as f32 / width as f32;
    let (red, rest) = light.split_at_mut(width);
    let (green, blue) = rest.split_at_mut(width);
    for start in (0..width).step_by(LANES) {
        let mut sum: [Lanes; 3] = [[0.0; LANES]; 3];
        for i in 0..LANES {
            let x = ((start + i) as f32 + 0.5) * step;
            for (lamp, color) in COLORS.iter().enumerate() {
                let hidden = hides(&scene.circles[0], x, y, corner(lamp))
                    | hides(&scene.circles[1], x, y, corner(lamp))
                    | hides(&scene.circles[2], x, y, corner(lamp));
                let arriving = if hidden { 0.0 } else { falloff(x, y, corner(lamp)) };
                for channel in 0..3 {
                    sum[channel][i] += color[channel] * arriving;
                }
            }
        }
        let count = LANES.min(width - start);
        for (plane, sum) in [&mut *red, &mut *green, &mut *blue].into_iter().zip(&sum) {
            plane[start..start + count].copy_from_slice(&sum[..count]);
        }
    }
}

/// The part of the row at height `y` that is in a circle or behind it, seen from a lamp: one interval.
///
/// Behind the circle lies what is between its two tangents and farther than where they touch; on one row the tangents
/// and the circle itself have the ends.
fn shadow(disc: &Disc, y: f32, (lx, ly): (f32, f32)) -> Option<(f32, f32)> {
    let (cx, cy) = (disc.x - lx, disc.y - ly);
    let far = cx * cx + cy * cy;
    let tangent = max(far - disc.square, 0.0);
    let (along, across) = (tangent.sqrt(), disc.square.sqrt());
    let down = y - ly;
    let mut interval: Option<(f32, f32)> = None;
    let mut add = |x: f32| interval = Some(interval.map_or((x, x), |(low, high)| (min(low, x), max(high, x))));
    let off = y - disc.y;
    if off * off < disc.square {
        let half = (disc.square - off * off).sqrt();
        add(disc.x - half);
        add(disc.x + half);
    }
    for side in [-1.0, 1.0] {
        let (tx, ty) = (cx * along - side * cy * across, cy * along + side * cx * across);
        // The tangent touches at this part of its way; beyond it, its line bounds the shadow. One that runs away from
        // the row, or along it, never comes there: the shadow then reaches to the wall.
        let touch = ty * along / far;
        let beyond = if ty > 0.0 { down > touch } else { down < touch };
        if beyond && ty * down > 0.0 {
            add(lx + tx * (down / ty));
        } else if ty * down <= 0.0 && interval_is_open(cy, down, disc) {
            add(if tx > 0.0 { 2.0 * SIDE as f32 } else { -(SIDE as f32) });
        }
    }
    interval
}

/// Whether the row passes the circle on the circle's side of the lamp, so that a shadow cut by no tangent has no end.
fn interval_is_open(cy: f32, down: f32, disc: &Disc) -> bool {
    cy * down > 0.0 || cy * cy < disc.square
}

/// A row of light, as runs of pixels that the same lamps reach.
fn spans_row(path: Path, scene: &Moment, row: usize, light: &mut [f32]) {
    let (width, y) = (scene.width, scene.y(row));
    let scale = width as f32 / SIDE as f32;
    // Where something changes: the bits of the lamps that go dark or light again.
    let mut edges = [(0usize, 0usize, 0usize); 12];
    for lamp in 0..4 {
        for (at, disc) in scene.circles.iter().enumerate() {
            let Some((low, high)) = shadow(disc, y, corner(lamp)) else { continue };
            let pixel = |x: f32| max(min((x * scale + 0.5).floor(), width as f32), 0.0) as usize;
            edges[lamp * 3 + at] = (lamp, pixel(low), pixel(high));
        }
    }
    let mut start = 0;
    while start < width {
        let mut lit = [true; 4];
        let mut end = width;
        for &(lamp, low, high) in &edges {
            lit[lamp] &= !(low <= start && start < high);
            for edge in [low, high] {
                end = if edge > start { end.min(edge) } else { end };
            }
        }
        light_run(path, scene, y, lit, start, end, light);
        start = end;
    }
}

clones! {
    /// Lights the pixels from `start` to `end` with some of the lamps.
    fn light_run(
        scene: &Moment, y: f32, lit: [bool; 4], start: usize, end: usize, light: &mut [f32],
    ) = light_run_lanes;
}

#[inline(always)]
fn light_run_lanes(scene: &Moment, y: f32, lit: [bool; 4], start: usize, end: usize, light: &mut [f32]) {
    let step = SIDE as f32 / scene.width as f32;
    let power = |lamp: usize| if lit[lamp] { POWER } else { 0.0 };
    let powers = [power(0), power(1), power(2), power(3)];
    let (red, rest) = light.split_at_mut(scene.width);
    let (green, blue) = rest.split_at_mut(scene.width);
    let planes = red[start..end].iter_mut().zip(&mut green[start..end]).zip(&mut blue[start..end]);
    let near = |lamp: usize| 1.0 + (corner(lamp).1 - y) * (corner(lamp).1 - y);
    let (upper, lower) = (near(0), near(2));
    for (i, ((red, green), blue)) in planes.enumerate() {
        let x = ((start + i) as u32 as f32 + 0.5) * step;
        let (left, right) = (x * x, (SIDE as f32 - x) * (SIDE as f32 - x));
        let a = powers[0] / (upper + left);
        let b = powers[1] / (upper + right);
        let c = powers[2] / (lower + left);
        let d = powers[3] / (lower + right);
        *red = COLORS[0][0] * a + COLORS[1][0] * b + COLORS[2][0] * c + COLORS[3][0] * d;
        *green = COLORS[0][1] * a + COLORS[1][1] * b + COLORS[2][1] * c + COLORS[3][1] * d;
        *blue = COLORS[0][2] * a + COLORS[1][2] * b + COLORS[2][2] * c + COLORS[3][2] * d;
    }
}

clones! {
    /// Floats to pixels.
    fn pack(light: &[f32], pixels: &mut [u32]) = pack_lanes;
}

#[inline(always)]
fn pack_lanes(light: &[f32], pixels: &mut [u32]) {
    let width = pixels.len();
    let (red, rest) = light.split_at(width);
    let (green, blue) = rest.split_at(width);
    // 2^23 leaves no room for a fraction: adding it rounds, and the byte is in the lowest bits.
    let byte = |level: f32| (min(max(level, 0.0), 1.0) * 255.0 + 8_388_608.0).to_bits() & 0xff;
    for (pixel, ((&red, &green), &blue)) in pixels.iter_mut().zip(red.iter().zip(green).zip(blue)) {
        *pixel = byte(red) << 16 | byte(green) << 8 | byte(blue);
    }
}
