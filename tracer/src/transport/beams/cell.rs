//! A cell: the part of a family that one beam carries.

/// v is halved down to this part of a stratum; then its middle stands for it.
const NARROWEST_V: f64 = 1.0 / 8.0;

/// A cell of u and v.
#[derive(Clone, Copy)]
pub(super) struct Cell {
    pub u: [f64; 2],
    pub v: [f64; 2],
    /// Its part of the family's v: more than v's width where one place stands for it.
    pub part: f64,
    /// How often u was halved for the form of the beam.
    pub halved: u32,
    /// The ray in its middle has all of its light.
    pub is_ray: bool,
}

impl Cell {
    pub fn width(&self) -> f64 {
        self.u[1] - self.u[0]
    }

    pub fn middle(&self) -> f64 {
        0.5 * (self.u[0] + self.u[1])
    }

    /// One place of v stands for all of the cell's.
    pub fn is_line(&self) -> bool {
        self.v[0] == self.v[1]
    }

    /// The same in parts of v: its halves, or its middle where it is narrow already.
    pub fn across(&self) -> Vec<Cell> {
        let middle = 0.5 * (self.v[0] + self.v[1]);
        if self.v[1] - self.v[0] <= NARROWEST_V {
            return vec![Cell { v: [middle; 2], ..*self }];
        }
        [[self.v[0], middle], [middle, self.v[1]]].map(|v| Cell { v, part: 0.5 * self.part, ..*self }).to_vec()
    }
}
