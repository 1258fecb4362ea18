//! A beam: four rays, and the light between them in the pixels that it crosses.

use super::cell::{self, mean_place};
use super::family::Bulge;
use super::film::{Along, BeamFilm, Trapezoid};
use crate::View;
use geometry::DVec2;

/// Where a beam's end is slanted, a row of pixels is divided into so many.
const STRIPS: f64 = 4.0;

/// Where its rays end farther apart along it than this, pixels, a beam's end is laid in parts of its width in v, so that no light is
/// spread into what ends it; and no more parts than these.
const SLANT_PX: f64 = 1.5;
const MOST_PARTS: f64 = 16.0;

/// Cells whose widths at v 0 and v 1 differ by more than this part of their sum end at a line where rays part.
const SLANTED: f64 = 0.05;

/// The edges of a triangle meet at one v, within this part of their distance.
const ROUNDING: f64 = 1e-6;

/// A straight piece of a beam, in pixels.
#[derive(Clone)]
pub struct Piece {
    /// Where its rays begin: u 0 and 1 at v 0, then at v 1.
    pub from: [DVec2; 4],
    /// Where they end.
    pub to: [DVec2; 4],
    /// Its widths in u at v 0 and at v 1, in any unit: how its light is spread over v.
    pub widths: [f64; 2],
    /// Between v 0 and v 1 its rays begin on the rim of a disc.
    pub bulge: Option<Bulge>,
}

/// A straight line as y = at + slope x.
#[derive(Clone, Copy)]
struct Line {
    at: f64,
    slope: f64,
}

/// A piece, seen along the axis that it crosses more squarely: `x` is that axis, `y` the one across.
struct Lanes {
    along: Along,
    /// Where its edges begin and end: the middles over v.
    edges: [[DVec2; 2]; 2],
    /// By edges: the line that is the mean over v.
    lines: [Line; 2],
    /// By edges: the box of the width in v.
    blurs: [Line; 2],
    /// Its light lies over v in proportion to its width there, and not evenly.
    is_slanted: bool,
    /// From the middle of its beginning to the middle of its end.
    middle: [DVec2; 2],
    /// The length of its rays for each step along x, in the mean.
    stretch: f64,
}

impl Piece {
    /// The same in pixels of a view.
    pub fn on_screen(&self, view: &View) -> Piece {
        let screen = |places: &[DVec2; 4]| places.map(|place| view.screen_from_table(place));
        let bulge = self.bulge.map(|bulge| Bulge { radius: bulge.radius / view.mm_per_px, ..bulge });
        Piece { from: screen(&self.from), to: screen(&self.to), bulge, ..*self }
    }

    /// Lays its light on the film: `light` is asked with the part of the way that has gone.
    pub fn splat(&self, film: &mut BeamFilm, light: impl Fn(f64) -> f64) {
        let Some(along) = self.along() else { return };
        let Some(whole) = self.lanes(along) else { return };
        let [width, height] = film.size().map(|side| side as f64);
        let rows = if along == Along::Row { height } else { width };
        let within = |place: f64| place.clamp(0.0, rows);
        // Where all four of its rays are.
        let [begins, ends] = self.zones(along);
        let inner = [within(begins[1]), within(ends[0])];
        if inner[0] < inner[1] {
            whole.splat_strips(film, inner, 1.0, &light);
        }
        let parts = ((begins[1] - begins[0]).max(ends[1] - ends[0]) / SLANT_PX).ceil().clamp(1.0, MOST_PARTS);
        for number in 0..parts as usize {
            let [v0, v1] = [number, number + 1].map(|number| number as f64 / parts);
            let part = if parts > 1.0 { self.part(v0, v1) } else { self.clone() };
            let Some(lanes) = part.lanes(along) else { continue };
            let mut bounds = [lanes.edges[0][0].x, lanes.edges[1][0].x, lanes.edges[0][1].x, lanes.edges[1][1].x];
            bounds.sort_unstable_by(f64::total_cmp);
            let share = self.share(v0, v1);
            let light = |gone: f64| light(gone) * share;
            for (range, strips) in bounds.windows(2).zip([STRIPS, 1.0, STRIPS]) {
                let [low, high] = [within(range[0]), within(range[1])];
                if inner[0] < inner[1] {
                    lanes.splat_strips(film, [low, high.min(inner[0])], strips, &light);
                    lanes.splat_strips(film, [low.max(inner[1]), high], strips, &light);
                } else {
                    lanes.splat_strips(film, [low, high], strips, &light);
                }
            }
        }
    }

    /// The axis that it crosses more squarely; `None` for a piece without a length.
    fn along(&self) -> Option<Along> {
        let way = mean_place(&self.to) - mean_place(&self.from);
        let is_way = way.length_squared() > 0.0 && way.is_finite();
        is_way.then_some(if way.y.abs() >= way.x.abs() { Along::Row } else { Along::Column })
    }

    /// On that axis: from where to where its rays begin, and where they end, in the order in which places grow.
    fn zones(&self, along: Along) -> [[f64; 2]; 2] {
        let zone = |places: &[DVec2]| {
            let places = places.iter().map(|place| turned(along, *place).x);
            [places.clone().fold(f64::INFINITY, f64::min), places.fold(f64::NEG_INFINITY, f64::max)]
        };
        let foremost = self.bulge.map_or(0.0, |bulge| bulge.foremost());
        let [a, b, c, d] = self.from;
        let (from, to) = (zone(&[a, b, c, d, self.begin(0, foremost), self.begin(1, foremost)]), zone(&self.to));
        if turned(along, mean_place(&self.to) - mean_place(&self.from)).x >= 0.0 { [from, to] } else { [to, from] }
    }

    /// Where the ray at this edge and v (0 to 1) begins.
    fn begin(&self, u: usize, v: f64) -> DVec2 {
        let straight = self.from[u].lerp(self.from[u + 2], v);
        let Some(bulge) = self.bulge else { return straight };
        let [low, high] = [0.0, 1.0].map(|v| bulge.height(v));
        let direction = (self.to[u].lerp(self.to[u + 2], v) - straight).normalize_or_zero();
        straight + direction * (bulge.height(v) - (low + (high - low) * v))
    }

    /// The part of its light between two places of v.
    fn share(&self, v0: f64, v1: f64) -> f64 {
        let [low, high] = self.widths;
        let whole = 0.5 * (low + high);
        if whole > 0.0 { (v1 - v0) * (low + (high - low) * 0.5 * (v0 + v1)) / whole } else { v1 - v0 }
    }

    /// The part of it between two places of v, 0 to 1.
    fn part(&self, v0: f64, v1: f64) -> Piece {
        let end = |u: usize, v: f64| self.to[u].lerp(self.to[u + 2], v);
        let from = [self.begin(0, v0), self.begin(1, v0), self.begin(0, v1), self.begin(1, v1)];
        Piece { from, to: [end(0, v0), end(1, v0), end(0, v1), end(1, v1)], bulge: None, ..*self }
    }

    fn lanes(&self, along: Along) -> Option<Lanes> {
        let middle = [mean_place(&self.from), mean_place(&self.to)].map(|place| turned(along, place));
        let way = middle[1] - middle[0];
        if !(way.x.abs() > 0.0 && way.is_finite()) {
            return None;
        }
        let slope = way.y / way.x;
        let line = |[from, to]: [DVec2; 2]| {
            let (x, y) = (to.x - from.x, to.y - from.y);
            // One that hardly crosses rows, or backwards, goes as the middle does.
            let slope = if x * way.x > 1e-3 * way.x * way.x { y / x } else { slope };
            Line { at: from.y - slope * from.x, slope }
        };
        let ends = |at: usize| [self.from[at], self.to[at]].map(|place| turned(along, place));
        let edges = [0, 1].map(|u| {
            let (low, high) = (ends(u), ends(u + 2));
            [0, 1].map(|end| (low[end] + high[end]) * 0.5)
        });
        let rays: [Line; 4] = std::array::from_fn(|at| line(ends(at)));
        let lines = [0, 1].map(|u| rays[u].mean(&rays[u + 2]));
        let blurs = [0, 1].map(|u| Line { at: rays[u + 2].at - rays[u].at, slope: rays[u + 2].slope - rays[u].slope });
        let length = |slope: f64| (1.0 + slope * slope).sqrt();
        let stretch = cell::mean(rays.map(|ray| length(ray.slope)), length(slope));
        let [low, high] = self.widths;
        let is_slanted = (high - low).abs() > SLANTED * (high + low);
        Some(Lanes { along, edges, lines, blurs, is_slanted, middle, stretch })
    }
}

impl Line {
    fn mean(&self, other: &Line) -> Line {
        Line { at: 0.5 * (self.at + other.at), slope: 0.5 * (self.slope + other.slope) }
    }

    fn y(&self, x: f64) -> f64 {
        self.at + self.slope * x
    }
}

/// A place with the axis that is crossed as x.
fn turned(along: Along, place: DVec2) -> DVec2 {
    if along == Along::Row { DVec2::new(place.y, place.x) } else { place }
}

impl Lanes {
    /// Lays the light between two places along x, each row divided into at most so many strips.
    fn splat_strips(&self, film: &mut BeamFilm, [low, high]: [f64; 2], strips: f64, light: &impl Fn(f64) -> f64) {
        if low >= high {
            return;
        }
        let mut row = low.floor();
        while row < high {
            let (begin, end) = (row.max(low), (row + 1.0).min(high));
            let count = ((end - begin) * strips).ceil().max(1.0);
            let step = (end - begin) / count;
            for strip in 0..count as usize {
                self.splat_strip(film, row as usize, begin + (strip as f64 + 0.5) * step, step, light);
            }
            row += 1.0;
        }
    }

    /// Lays the light of a strip of a row round `x`, `step` long.
    fn splat_strip(&self, film: &mut BeamFilm, row: usize, x: f64, step: f64, light: &impl Fn(f64) -> f64) {
        let [a, b] = self.lines.map(|line| line.y(x));
        let [Some(begin), Some(end)] = [0, 1].map(|edge| self.place(edge, [a, b][edge], x)) else { return };
        let (whole, covered) = ((b - a).abs(), (end - begin).abs());
        let part = if covered < whole { covered / whole } else { 1.0 };
        let gone = (x - self.middle[0].x) / (self.middle[1].x - self.middle[0].x);
        let mut blurs = self.blurs.map(|blur| blur.y(x));
        // Where the edges have changed sides at one v and not at the other, the mean of their boxes stands for both.
        let apart = 0.5 * (blurs[1] - blurs[0]).abs() * (1.0 - ROUNDING);
        if !self.is_slanted || (b - a).abs() < apart || (end - begin).abs() < apart {
            blurs = [0.5 * (blurs[0] + blurs[1]); 2];
        }
        let moved = 0.5 * (self.lines[0].slope + self.lines[1].slope) * step;
        // One box for both, with the variance of the two. The widths in u, which beams share their edges of, stay exact.
        let blurs = blurs.map(|blur| (blur * blur + moved * moved).sqrt());
        let light = light(gone) * part * step * self.stretch;
        film.lay(self.along, row, light, &Trapezoid { ends: [begin, end], blurs });
    }

    /// Where the beam's border is at x on the side of an edge: on its ray, which is at `ray` there, or, where that has not begun or
    /// has ended, on the line from its end to the other edge's. `None` if neither is there.
    fn place(&self, edge: usize, ray: f64, x: f64) -> Option<f64> {
        let [from, to] = self.edges[edge];
        let side = match ((x - from.x) * (x - to.x) <= 0.0, (x - from.x).abs() < (x - to.x).abs()) {
            (true, _) => return Some(ray),
            (false, true) => 0,
            (false, false) => 1,
        };
        let (own, other) = (self.edges[edge][side], self.edges[1 - edge][side]);
        let part = (x - own.x) / (other.x - own.x);
        (0.0..=1.0).contains(&part).then_some(own.y + (other.y - own.y) * part)
    }
}
