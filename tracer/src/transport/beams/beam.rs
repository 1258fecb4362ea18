//! A beam: four rays, and the light between them in the pixels that it crosses.

use super::film::{Along, BeamFilm, Trapezoid};
use crate::View;
use geometry::DVec2;

/// Where a beam's end is slanted, a row of pixels is divided into so many.
const STRIPS: f64 = 4.0;

/// A straight piece of a beam, in pixels.
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
        let Some(lanes) = self.lanes() else { return };
        let [width, height] = film.size().map(|side| side as f64);
        let rows = if lanes.along == Along::Row { height } else { width };
        let mut ends = [lanes.edges[0][0].x, lanes.edges[1][0].x, lanes.edges[0][1].x, lanes.edges[1][1].x];
        ends.sort_unstable_by(f64::total_cmp);
        let [low, inner_low, inner_high, high] = ends.map(|end| end.clamp(0.0, rows));
        lanes.splat_strips(film, [low, inner_low], STRIPS, &color);
        lanes.splat_strips(film, [inner_low, inner_high], 1.0, &color);
        lanes.splat_strips(film, [inner_high, high], STRIPS, &color);
    }

    fn lanes(&self) -> Option<Lanes> {
        let middle = [mean(&self.from), mean(&self.to)];
        let way = middle[1] - middle[0];
        if !(way.length_squared() > 0.0 && way.is_finite()) {
            return None;
        }
        let along = if way.y.abs() >= way.x.abs() { Along::Row } else { Along::Column };
        let turn = |place: DVec2| if along == Along::Row { DVec2::new(place.y, place.x) } else { place };
        let edge = |u: usize| [&self.from, &self.to].map(|places| turn((places[u] + places[u + 2]) * 0.5));
        let middle = middle.map(turn);
        let way = turn(way);
        let slope = way.y / way.x;
        let edges = [edge(0), edge(1)];
        let slopes = edges.map(|[from, to]| {
            let (x, y) = (to.x - from.x, to.y - from.y);
            // An edge that hardly crosses rows, or backwards, goes as the middle does.
            if x * way.x > 1e-3 * way.x.abs() { y / x } else { slope }
        });
        let blur = |places: &[DVec2; 4]| {
            let across = ((places[2] - places[0]) + (places[3] - places[1])) * 0.5;
            let across = turn(across);
            across.y - across.x * slope
        };
        let blurs = [blur(&self.from), blur(&self.to)];
        Some(Lanes { along, edges, slopes, blurs, middle, stretch: way.length() / way.x.abs() })
    }
}

impl Lanes {
    /// Lays the light between two places along x, each row divided into at most so many strips.
    fn splat_strips(&self, film: &mut BeamFilm, [low, high]: [f64; 2], strips: f64, color: &impl Fn(f64) -> [f64; 3]) {
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
