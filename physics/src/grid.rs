//! Which shapes are near: a uniform grid, made once.
//!
//! Refuses to know what the shapes are for.

use geometry::{Bounds, DVec2, Shape};

/// Edge of a cell, m: a little less than a ball.
const CELL_M: f64 = 0.02;

/// For each cell the indices of the shapes that come near it.
#[derive(Clone, Debug)]
pub(crate) struct Grid {
    columns: usize,
    rows: usize,
    /// Where each cell's list starts in `shapes`; one more at the end.
    starts: Vec<u32>,
    shapes: Vec<u16>,
}

impl Grid {
    /// The grid over a field of `size`. A shape belongs to every cell of which it is not farther than `reach`.
    pub fn new<'a>(size: DVec2, shapes: impl Iterator<Item = &'a Shape> + Clone, reach: f64) -> Grid {
        let cells = (size / CELL_M).ceil().max(DVec2::ONE);
        let (columns, rows) = (cells.x as usize, cells.y as usize);
        let half_diagonal = CELL_M * std::f64::consts::FRAC_1_SQRT_2;
        let mut grid = Grid { columns, rows, starts: vec![0], shapes: Vec::new() };
        for row in 0..rows {
            for column in 0..columns {
                let middle = (DVec2::new(column as f64, row as f64) + 0.5) * CELL_M;
                let near = |shape: &Shape| shape.distance(middle).0 <= half_diagonal + reach;
                // The outermost cells also stand for everything beyond them.
                let outer = row == 0 || column == 0 || row + 1 == rows || column + 1 == columns;
                let far = |shape: &Shape| outer && !inside(shape.bounds().grown(reach), size);
                let indices = shapes.clone().enumerate().filter(|(_, shape)| near(shape) || far(shape));
                grid.shapes.extend(indices.map(|(index, _)| index as u16));
                grid.starts.push(grid.shapes.len() as u32);
            }
        }
        grid
    }

    fn column(&self, x: f64) -> usize {
        ((x / CELL_M) as usize).min(self.columns - 1)
    }

    fn row(&self, y: f64) -> usize {
        ((y / CELL_M) as usize).min(self.rows - 1)
    }

    /// Calls `visit` with every shape that may be near the straight way from `from` to `to`, perhaps more than once.
    pub fn visit(&self, from: DVec2, to: DVec2, mut visit: impl FnMut(usize)) {
        let (min, max) = (from.min(to), from.max(to));
        let (first_column, last_column) = (self.column(min.x), self.column(max.x));
        for row in self.row(min.y)..=self.row(max.y) {
            for column in first_column..=last_column {
                let cell = row * self.columns + column;
                let list = self.starts[cell] as usize..self.starts[cell + 1] as usize;
                self.shapes[list].iter().for_each(|&index| visit(usize::from(index)));
            }
        }
    }
}

fn inside(bounds: Bounds, size: DVec2) -> bool {
    bounds.min.cmpge(DVec2::ZERO).all() && bounds.max.cmple(size).all()
}
