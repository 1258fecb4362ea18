//! A beam: four rays, and the light between them in the pixels that it crosses.

use super::spread::Spread;
use crate::View;
use crate::transport::SplatFilm;
use geometry::DVec2;

/// A straight piece of a beam, in pixels.
pub struct Piece {
    /// Where its rays begin: u 0 and 1 at v 0, then at v 1.
    pub from: [DVec2; 4],
    /// Where they end.
    pub to: [DVec2; 4],
}

fn mean(places: &[DVec2; 4]) -> DVec2 {
    (places[0] + places[1] + places[2] + places[3]) * 0.25
}

impl Piece {
    /// The same in pixels of a view.
    pub fn on_screen(&self, view: &View) -> Piece {
        let screen = |places: &[DVec2; 4]| places.map(|place| view.screen_from_table(place));
        Piece { from: screen(&self.from), to: screen(&self.to) }
    }

    /// Lays its light on the film: `color` is asked with the part of the way that has gone.
    pub fn splat(&self, film: &mut SplatFilm, color: impl Fn(f64) -> [f64; 3]) {
        let (from, to) = (mean(&self.from), mean(&self.to));
        let way = to - from;
        let length = way.length();
        if !(length > 0.0 && length.is_finite()) {
            return;
        }
        // Rows if it crosses them more squarely than columns.
        let major = if way.y.abs() >= way.x.abs() { 1 } else { 0 };
        let minor = 1 - major;
        let size = [film.width() as f64, film.height() as f64];
        let (low, high) = (from[major].min(to[major]).max(0.0), from[major].max(to[major]).min(size[major]));
        let mut row = low.floor();
        while row < high {
            let (begin, end) = (row.max(low), (row + 1.0).min(high));
            let middle = 0.5 * (begin + end);
            let part = (middle - from[major]) / way[major];
            let chord = (end - begin) * length / way[major].abs();
            let x: [f64; 4] = std::array::from_fn(|corner| self.place(corner, middle, part, major));
            let across_u = 0.5 * ((x[1] - x[0]) + (x[3] - x[2]));
            let across_v = 0.5 * ((x[2] - x[0]) + (x[3] - x[1]));
            let center = 0.25 * (x[0] + x[1] + x[2] + x[3]);
            // Within the row the beam moves aside: a third box.
            let moved = way[minor] / way[major] * (end - begin);
            let spread = Spread::new(center, [across_u, across_v, moved]);
            let light = color(part).map(|channel| channel * chord);
            lay(film, &spread, row as usize, major, size[minor], light);
            row += 1.0;
        }
    }

    /// Where a corner's ray is as it crosses the middle of a row.
    fn place(&self, corner: usize, middle: f64, part: f64, major: usize) -> f64 {
        let minor = 1 - major;
        let (from, to) = (self.from[corner], self.to[corner]);
        let along = to[major] - from[major];
        // A ray that hardly crosses the row is where its part of the way is.
        let own = if along.abs() > 1e-3 { (middle - from[major]) / along } else { part };
        let own = own.clamp(part - 1.0, part + 1.0);
        from[minor] + (to[minor] - from[minor]) * own
    }
}

/// Lays light that is spread over a row (or a column) into its pixels.
fn lay(film: &mut SplatFilm, spread: &Spread, row: usize, major: usize, width: f64, light: [f64; 3]) {
    let [begin, end] = spread.ends();
    if !(end > 0.0 && begin < width) {
        return;
    }
    let last = end.min(width).ceil() - 1.0;
    let mut at = begin.max(0.0).floor();
    // What lies beside the picture is left out; nothing lies left of the first pixel where the spread begins in it.
    let mut before = if begin >= 0.0 { 0.0 } else { spread.left_of(at) };
    while at <= last {
        let left = if at == last && end <= width { 1.0 } else { spread.left_of(at + 1.0) };
        let part = left - before;
        before = left;
        let (x, y) = if major == 1 { (at as usize, row) } else { (row, at as usize) };
        film.deposit(x, y, light.map(|channel| channel * part));
        at += 1.0;
    }
}
