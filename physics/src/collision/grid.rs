//! Uniform grid: the broad phase, which shapes are near (Ericson, Real-Time Collision Detection, 2005, 7.1). Made once.
//!
//! Refuses to know what the shapes are for.

use geometry::{Bounds, DVec2, Shape};

/// Edge of a cell, m: a little less than a ball.
const CELL_M: f64 = 0.02;
/// A cell is divided into so many parts each way: a cell's list is short to keep, and of it only what comes near the
/// right parts is worth a closer look.
const PARTS: usize = 4;
/// Edge of a part, m: a power of two of them, so that a place is in a part exactly if it is in that part's cell.
const PART_M: f64 = CELL_M / PARTS as f64;
/// Far above rounding, far below anything else, m.
const GRID_ROUNDING_M: f64 = 1e-9;

/// For each cell the indices of the shapes that come near it.
#[derive(Clone, Debug)]
pub(crate) struct Grid {
    columns: usize,
    rows: usize,
    /// Where each cell's list starts in `entries`; one more at the end.
    starts: Vec<u32>,
    entries: Vec<Entry>,
}

/// A shape in a cell.
#[derive(Clone, Copy, Debug)]
struct Entry {
    shape: u16,
    /// The parts of the cell that it comes near: one bit for each, row by row.
    parts: u16,
}

impl Grid {
    /// The grid over a field of `size`. A shape belongs to every part of a cell of which it is not farther than `reach`.
    pub fn new<'a>(size: DVec2, shapes: impl Iterator<Item = &'a Shape> + Clone, reach: f64) -> Grid {
        let cells = (size / CELL_M).ceil().max(DVec2::ONE);
        let (columns, rows) = (cells.x as usize, cells.y as usize);
        let mut grid = Grid { columns, rows, starts: vec![0], entries: Vec::new() };
        for row in 0..rows {
            for column in 0..columns {
                let corner = DVec2::new(column as f64, row as f64) * CELL_M;
                // The outermost cells also stand for everything beyond them.
                let outer = row == 0 || column == 0 || row + 1 == rows || column + 1 == columns;
                for (index, shape) in shapes.clone().enumerate() {
                    let far = outer && !inside(shape.bounds().grown(reach), size);
                    let parts = if far { u16::MAX } else { parts_near(shape, corner, reach) };
                    if parts != 0 {
                        grid.entries.push(Entry { shape: index as u16, parts });
                    }
                }
                grid.starts.push(grid.entries.len() as u32);
            }
        }
        grid
    }

    /// Calls `visit` with every shape that may be near the straight path from `from` to `to`, perhaps more than once.
    pub fn visit(&self, from: DVec2, to: DVec2, mut visit: impl FnMut(usize)) {
        let (min, max) = (from.min(to), from.max(to));
        let (left, right) = (part(min.x, self.columns), part(max.x, self.columns));
        let (top, bottom) = (part(min.y, self.rows), part(max.y, self.rows));
        for row in top / PARTS..=bottom / PARTS {
            let rows = span(top, bottom, row);
            for column in left / PARTS..=right / PARTS {
                let parts = block(span(left, right, column), rows);
                let cell = row * self.columns + column;
                let list = self.starts[cell] as usize..self.starts[cell + 1] as usize;
                for entry in self.entries[list].iter().filter(|entry| entry.parts & parts != 0) {
                    visit(usize::from(entry.shape));
                }
            }
        }
    }
}

/// Which part of the parts of all `cells` a coordinate is in.
fn part(coordinate: f64, cells: usize) -> usize {
    ((coordinate / PART_M) as usize).min(cells * PARTS - 1)
}

/// The parts of this cell from `first` to `last`, counted from the cell's own first.
fn span(first: usize, last: usize, cell: usize) -> (usize, usize) {
    let own = cell * PARTS;
    (first.max(own) - own, last.min(own + PARTS - 1) - own)
}

/// The bits of these columns in these rows.
fn block(columns: (usize, usize), rows: (usize, usize)) -> u16 {
    let bits = |(first, last): (usize, usize)| (1_u32 << (last + 1)) - (1 << first);
    let in_row = bits(columns);
    (rows.0..=rows.1).fold(0, |all, row| all | in_row << (row * PARTS)) as u16
}

/// The parts of the cell at `corner` that a shape comes near.
fn parts_near(shape: &Shape, corner: DVec2, reach: f64) -> u16 {
    let near = |middle: DVec2, edge: f64| {
        let half_diagonal = edge * std::f64::consts::FRAC_1_SQRT_2;
        shape.distance(middle).0 <= half_diagonal + reach + GRID_ROUNDING_M
    };
    if !near(corner + 0.5 * CELL_M, CELL_M) {
        return 0;
    }
    let middle = |part: usize| DVec2::new((part % PARTS) as f64, (part / PARTS) as f64) + 0.5;
    let parts = (0..PARTS * PARTS).filter(|&part| near(corner + middle(part) * PART_M, PART_M));
    parts.fold(0, |all, part| all | 1 << part)
}

fn inside(bounds: Bounds, size: DVec2) -> bool {
    bounds.min.cmpge(DVec2::ZERO).all() && bounds.max.cmple(size).all()
}

#[cfg(test)]
mod tests {
    use super::*;
    use geometry::{Arc, Circle, Core};

    #[test]
    fn the_grid_leaves_out_nothing_that_a_look_at_every_shape_finds() {
        let size = DVec2::new(0.3, 0.41);
        let place = |k: u32| {
            let part = |k: u32| f64::from(k.wrapping_mul(2_654_435_761) >> 8) / f64::from(1 << 24);
            DVec2::new(part(k) * 0.34 - 0.02, part(k + 7777) * 0.45 - 0.02)
        };
        let shape = |k: u32| match k % 3 {
            0 => Shape::disc(place(k), 0.012),
            1 => Shape::capsule(place(k), place(k + 1), 0.0135),
            _ => Shape {
                core: Core::Arc(Arc::new(Circle { center: place(k), radius: 0.05 }, f64::from(k), 2.0)),
                radius: 0.01,
            },
        };
        let shapes: Vec<Shape> = (0..40).map(shape).collect();
        let reach = 25e-6;
        let grid = Grid::new(size, shapes.iter(), reach);
        let (mut all, mut found) = (0, 0);
        for k in 100..3000 {
            let from = place(k);
            let to = from + (place(k + 1) - from) * 0.02;
            let mut visited = vec![false; shapes.len()];
            grid.visit(from, to, |index| visited[index] = true);
            for (index, shape) in shapes.iter().enumerate() {
                let near = (0..=10).any(|part| shape.distance(from.lerp(to, f64::from(part) / 10.0)).0 <= reach);
                assert!(!near || visited[index], "{shape:?} is near {from}..{to}");
                all += usize::from(near);
                found += usize::from(visited[index]);
            }
        }
        assert!(all > 1000 && found < 5 * all, "{found} visited for {all} that are near");
    }
}
