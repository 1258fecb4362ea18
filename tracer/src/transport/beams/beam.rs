//! A beam: four rays, and the light between them in the pixels that it crosses.

use super::film::{Along, BeamFilm, Trapezoid};
use crate::View;
use geometry::DVec2;

/// Where a beam's end is slanted, a row of pixels is divided into so many.
const STRIPS: f64 = 4.0;

/// Where its rays end farther apart along it than this, pixels, a beam's end is laid in parts of its width in v, so that no light is
/// spread into what ends it; and no more parts than these.
const SLANT_PX: f64 = 1.5;
const MOST_PARTS: f64 = 16.0;

/// A straight piece of a beam, in pixels.
#[derive(Clone)]
pub struct Piece {
    /// Where its rays begin: u 0 and 1 at v 0, then at v 1.
    pub from: [DVec2; 4],
    /// Where they end.
    pub to: [DVec2; 4],
}

/// A piece, seen along the axis that it crosses more squarely: `x` is that axis, `y` the one across.
struct Lanes {
    along: Along,
    /// Where its edges begin and end: the middles over v.
    edges: [[DVec2; 2]; 2],
    /// How far they go along y for each step along x.
    slopes: [f64; 2],
    /// The box of its width in v where it begins and where it ends; within a row the beam moves aside, too.
    blurs: [f64; 2],
    /// From the middle of its beginning to the middle of its end.
    middle: [DVec2; 2],
    /// Its length for each step along x.
    stretch: f64,
}

impl Piece {
    /// The same in pixels of a view.
    pub fn on_screen(&self, view: &View) -> Piece {
        let screen = |places: &[DVec2; 4]| places.map(|place| view.screen_from_table(place));
        Piece { from: screen(&self.from), to: screen(&self.to) }
    }

    /// Lays its light on the film: `color` is asked with the part of the way that has gone.
    pub fn splat(&self, film: &mut BeamFilm, color: impl Fn(f64) -> [f64; 3]) {
        let Some(along) = self.along() else { return };
        let Some(whole) = self.lanes(along) else { return };
        let [width, height] = film.size().map(|side| side as f64);
        let rows = if along == Along::Row { height } else { width };
        let within = |place: f64| place.clamp(0.0, rows);
        // Where all four of its rays are.
        let [begins, ends] = self.zones(along);
        let inner = [within(begins[1]), within(ends[0])];
        if inner[0] < inner[1] {
            whole.splat_strips(film, inner, 1.0, &color);
        }
        let parts = ((begins[1] - begins[0]).max(ends[1] - ends[0]) / SLANT_PX).ceil().clamp(1.0, MOST_PARTS);
        for number in 0..parts as usize {
            let part =
                if parts > 1.0 { self.part(number as f64 / parts, (number + 1) as f64 / parts) } else { self.clone() };
            let Some(lanes) = part.lanes(along) else { continue };
            let mut bounds = [lanes.edges[0][0].x, lanes.edges[1][0].x, lanes.edges[0][1].x, lanes.edges[1][1].x];
            bounds.sort_unstable_by(f64::total_cmp);
            let light = |gone: f64| color(gone).map(|channel| channel / parts);
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
        let way = mean(&self.to) - mean(&self.from);
        let is_way = way.length_squared() > 0.0 && way.is_finite();
        is_way.then_some(if way.y.abs() >= way.x.abs() { Along::Row } else { Along::Column })
    }

    /// On that axis: from where to where its rays begin, and where they end, in the order in which places grow.
    fn zones(&self, along: Along) -> [[f64; 2]; 2] {
        let zone = |places: &[DVec2; 4]| {
            let places = places.map(|place| turned(along, place).x);
            [
                places.iter().copied().fold(f64::INFINITY, f64::min),
                places.iter().copied().fold(f64::NEG_INFINITY, f64::max),
            ]
        };
        let (from, to) = (zone(&self.from), zone(&self.to));
        if turned(along, mean(&self.to) - mean(&self.from)).x >= 0.0 { [from, to] } else { [to, from] }
    }

    /// The part of it between two places of v, 0 to 1.
    fn part(&self, v0: f64, v1: f64) -> Piece {
        let part = |places: &[DVec2; 4]| {
            let at = |u: usize, v: f64| places[u].lerp(places[u + 2], v);
            [at(0, v0), at(1, v0), at(0, v1), at(1, v1)]
        };
        Piece { from: part(&self.from), to: part(&self.to) }
    }

    fn lanes(&self, along: Along) -> Option<Lanes> {
        let middle = [mean(&self.from), mean(&self.to)].map(|place| turned(along, place));
        let way = middle[1] - middle[0];
        if !(way.x.abs() > 0.0 && way.is_finite()) {
            return None;
        }
        let edge = |u: usize| [&self.from, &self.to].map(|places| turned(along, (places[u] + places[u + 2]) * 0.5));
        let slope = way.y / way.x;
        let edges = [edge(0), edge(1)];
        let slopes = edges.map(|[from, to]| {
            let (x, y) = (to.x - from.x, to.y - from.y);
            // An edge that hardly crosses rows, or backwards, goes as the middle does.
            if x * way.x > 1e-3 * way.x.abs() { y / x } else { slope }
        });
        let blur = |places: &[DVec2; 4]| {
            let across = turned(along, ((places[2] - places[0]) + (places[3] - places[1])) * 0.5);
            across.y - across.x * slope
        };
        let blurs = [blur(&self.from), blur(&self.to)];
        Some(Lanes { along, edges, slopes, blurs, middle, stretch: way.length() / way.x.abs() })
    }
}

/// A place with the axis that is crossed as x.
fn turned(along: Along, place: DVec2) -> DVec2 {
    if along == Along::Row { DVec2::new(place.y, place.x) } else { place }
}

impl Lanes {
    /// Lays the light between two places along x, each row divided into at most so many strips.
    fn splat_strips(&self, film: &mut BeamFilm, [low, high]: [f64; 2], strips: f64, color: &impl Fn(f64) -> [f64; 3]) {
        if low >= high {
            return;
        }
        let mut row = low.floor();
        while row < high {
            let (begin, end) = (row.max(low), (row + 1.0).min(high));
            let count = ((end - begin) * strips).ceil().max(1.0);
            let step = (end - begin) / count;
            for strip in 0..count as usize {
                self.splat_strip(film, row as usize, begin + (strip as f64 + 0.5) * step, step, color);
            }
            row += 1.0;
        }
    }

    /// Lays the light of a strip of a row round `x`, `step` long.
    fn splat_strip(&self, film: &mut BeamFilm, row: usize, x: f64, step: f64, color: &impl Fn(f64) -> [f64; 3]) {
        let [a, b] = [0, 1].map(|edge| self.edges[edge][0].y + self.slopes[edge] * (x - self.edges[edge][0].x));
        let [Some(begin), Some(end)] = [0, 1].map(|edge| self.place(edge, [a, b][edge], x)) else { return };
        let (whole, covered) = ((b - a).abs(), (end - begin).abs());
        let part = if covered < whole { covered / whole } else { 1.0 };
        let gone = (x - self.middle[0].x) / (self.middle[1].x - self.middle[0].x);
        let blur = self.blurs[0] + (self.blurs[1] - self.blurs[0]) * gone;
        let moved = 0.5 * (self.slopes[0] + self.slopes[1]) * step;
        // One box for both, with the variance of the two. The widths in u, which beams share their edges of, stay exact.
        let blur = (blur * blur + moved * moved).sqrt();
        let light = color(gone).map(|channel| channel * (part * step * self.stretch));
        film.lay(self.along, row, light, &Trapezoid { begin, end, blur });
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

fn mean(places: &[DVec2; 4]) -> DVec2 {
    (places[0] + places[1] + places[2] + places[3]) * 0.25
}
