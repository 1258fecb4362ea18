//! Rows of pixels: what lies between the outermost edges of a path, and how many edges meet in a row.

use super::area::Area;

/// Bands into which what a path covers is cut, from the top down.
const BANDS: usize = 32;
/// Rows at most; of what is higher a row is more than a pixel.
const MAX_ROWS: f64 = 8192.0;

/// The edges of a path as far as they are shown, row by row.
pub(super) struct Rows {
    shown: Area,
    /// The least and the largest x in each band.
    sides: [(f64, f64); BANDS],
    /// How many edges begin in each row, and how many have ended before it.
    begun: Vec<(u32, u32)>,
    /// Rows in a pixel.
    rows_per_px: f64,
}

impl Rows {
    /// No edges yet.
    pub fn new(shown: Area) -> Rows {
        let height = shown.height().max(1.0);
        let rows = height.ceil().min(MAX_ROWS);
        Rows {
            shown,
            sides: [(f64::INFINITY, f64::NEG_INFINITY); BANDS],
            begun: vec![(0, 0); rows as usize + 1],
            rows_per_px: (rows / height).min(1.0),
        }
    }

    fn band_height(&self) -> f64 {
        self.shown.height() / BANDS as f64
    }

    /// Adds an edge; returns how high it is within what is shown, px.
    pub fn add(&mut self, a: [f64; 2], b: [f64; 2]) -> f64 {
        let Some([top, bottom]) = self.cover(a, b) else { return 0.0 };
        let last = self.begun.len() - 1;
        let row = |y: f64| (((y - self.shown.top) * self.rows_per_px) as usize).min(last);
        let (first, after) = (row(top), row(bottom) + 1);
        self.begun[first].0 += 1;
        if let Some((_, ended)) = self.begun.get_mut(after) {
            *ended += 1;
        }
        bottom - top
    }

    /// Counts an edge among what bounds the path; its top and its bottom, as far as they are shown.
    pub fn cover(&mut self, a: [f64; 2], b: [f64; 2]) -> Option<[f64; 2]> {
        let ([x0, y0], [x1, y1]) = if a[1] <= b[1] { (a, b) } else { (b, a) };
        let (top, bottom) = (y0.max(self.shown.top), y1.min(self.shown.bottom));
        if top > bottom || self.shown.height() <= 0.0 {
            return None;
        }
        let x_at = |y: f64| if y1 > y0 { x0 + (x1 - x0) * ((y - y0) / (y1 - y0)) } else { x0 };
        let height = self.band_height();
        let number = |y: f64| (((y - self.shown.top) / height) as usize).min(BANDS - 1);
        for band in number(top)..=number(bottom) {
            let above = self.shown.top + band as f64 * height;
            let ends = [x_at(above.max(top)), x_at((above + height).min(bottom))];
            // A level edge has all of its x at one y.
            let ends = if y1 > y0 { ends } else { [x0, x1] };
            let (least, most) = &mut self.sides[band];
            *least = ends.into_iter().fold(*least, f64::min);
            *most = ends.into_iter().fold(*most, f64::max);
        }
        Some([top, bottom])
    }

    /// The pixels between the outermost edges.
    pub fn pixels(&self) -> f64 {
        let width = |&(least, most): &(f64, f64)| most.min(self.shown.right) - least.max(self.shown.left);
        self.sides.iter().map(|sides| width(sides).max(0.0)).sum::<f64>() * self.band_height()
    }

    /// Pairs of edges that meet in a row, each counted in the row where the later one begins.
    pub fn overlaps(&self) -> f64 {
        let (mut met, mut pairs) = (0.0, 0.0);
        for &(begun, ended) in &self.begun {
            let begun = f64::from(begun);
            met -= f64::from(ended);
            pairs += begun * (met + 0.5 * begun);
            met += begun;
        }
        pairs
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rows() -> Rows {
        Rows::new(Area::of_size((100.0, 200.0)))
    }

    #[test]
    fn a_triangle_covers_its_half() {
        let mut rows = rows();
        for (a, b) in [([0.0, 0.0], [100.0, 200.0]), ([100.0, 200.0], [0.0, 200.0]), ([0.0, 200.0], [0.0, 0.0])] {
            rows.add(a, b);
        }
        assert!((rows.pixels() - 10_000.0).abs() < 500.0, "{}", rows.pixels());
    }

    /// Art of 24,000 corners was estimated at a quarter of what it took, and more corners at ever less of it.
    #[test]
    fn edges_meet_where_they_have_a_row_in_common() {
        let mut crossing = rows();
        (0..100).for_each(|i| assert_eq!(crossing.add([f64::from(i), -9.0], [0.0, 300.0]), 200.0));
        assert_eq!(crossing.overlaps(), 5000.0);
        let mut ladder = rows();
        (0..100).for_each(|i| _ = ladder.add([0.0, 2.0 * f64::from(i)], [9.0, 2.0 * f64::from(i) + 0.9]));
        assert_eq!(ladder.overlaps(), 50.0);
        let mut beside = rows();
        (0..100).for_each(|i| _ = beside.add([0.0, 201.0], [f64::from(i), 300.0]));
        assert_eq!(beside.overlaps(), 0.0);
    }
}
