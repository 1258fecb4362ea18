//! A cell: the part of a family that one beam carries.

use geometry::DVec2;

/// v is halved down to this part of a stratum; then its middle stands for it.
const NARROWEST_V: f64 = 1.0 / 64.0;

/// After so many cuts, or with less of its family's light, the ray in a cell's middle has all of its light.
const MOST_CUTS: u32 = 48;
const LEAST_LIGHT: f64 = 1e-7;

/// A cell of u and v: two lines of constant v, and between their ends straight lines, slanted where the beam ends at an edge that
/// its rays of different v pass at different u. Its corners are numbered u first: 0 and 1 at the lower v, 2 and 3 at the upper one.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cell {
    /// By v: from and to.
    pub u: [[f64; 2]; 2],
    pub v: [f64; 2],
    /// Its part of the family's light.
    pub light: f64,
    /// How often u and v were halved for the form of the beam.
    pub halved: [u32; 2],
    /// How often it was cut where its rays part.
    pub cuts: u32,
}

impl Cell {
    /// All of v.
    pub fn new(u: [f64; 2]) -> Cell {
        Cell { u: [u; 2], v: [0.0, 1.0], light: u[1] - u[0], halved: [0; 2], cuts: 0 }
    }

    /// The place of a corner: u and v.
    pub fn corner(&self, at: usize) -> [f64; 2] {
        [self.u[at / 2][at % 2], self.v[at / 2]]
    }

    /// Its width in u, the mean over v.
    pub fn width(&self) -> f64 {
        0.5 * (self.u[0][1] - self.u[0][0] + self.u[1][1] - self.u[1][0])
    }

    /// Its height in v.
    pub fn height(&self) -> f64 {
        self.v[1] - self.v[0]
    }

    /// It is not to be divided any more: the ray in its middle stands for it.
    pub fn is_as_one(&self) -> bool {
        self.cuts >= MOST_CUTS || self.light < LEAST_LIGHT
    }

    /// The same, not to be divided any more.
    pub fn as_one(&self) -> Cell {
        Cell { cuts: MOST_CUTS, ..*self }
    }

    /// One place of v stands for all of the cell's.
    pub fn is_line(&self) -> bool {
        self.v[0] == self.v[1]
    }

    /// The middles of u at both v.
    pub fn middles(&self) -> [f64; 2] {
        self.u.map(|[from, to]| 0.5 * (from + to))
    }

    /// The place in its middle: u and v.
    pub fn center(&self) -> [f64; 2] {
        let middles = self.middles();
        [0.5 * (middles[0] + middles[1]), 0.5 * (self.v[0] + self.v[1])]
    }

    /// Both parts, divided at u of the lower and of the upper v.
    pub fn divided(&self, at: [f64; 2]) -> [Cell; 2] {
        let part = |u: [[f64; 2]; 2]| {
            let cell = Cell { u, ..*self };
            Cell { light: self.light * share(cell.width(), self.width()), ..cell }
        };
        let side = |end: usize| [0, 1].map(|v| if end == 0 { [self.u[v][0], at[v]] } else { [at[v], self.u[v][1]] });
        [part(side(0)), part(side(1))]
    }

    /// u from and to at a place of v.
    pub fn across(&self, v: f64) -> [f64; 2] {
        let part = if self.is_line() { 0.0 } else { (v - self.v[0]) / self.height() };
        [0, 1].map(|end| self.u[0][end] + (self.u[1][end] - self.u[0][end]) * part)
    }

    /// The part between two places of v.
    pub fn slice(&self, v: [f64; 2]) -> Cell {
        let cell = Cell { u: v.map(|v| self.across(v)), v, ..*self };
        Cell { light: self.light * share(cell.width() * cell.height(), self.width() * self.height()), ..cell }
    }

    /// Its halves in v, or its middle where it is narrow already.
    pub fn halves_across(&self) -> Vec<Cell> {
        let middle = 0.5 * (self.v[0] + self.v[1]);
        if self.height() <= NARROWEST_V {
            return vec![Cell { u: [self.across(middle); 2], v: [middle; 2], ..*self }];
        }
        vec![self.slice([self.v[0], middle]), self.slice([middle, self.v[1]])]
    }
}

fn share(part: f64, whole: f64) -> f64 {
    if whole > 0.0 { part / whole } else { 0.0 }
}

/// The mean over a cell by Simpson's rule, from its corners and its middle.
pub(super) fn mean(corners: [f64; 4], middle: f64) -> f64 {
    (0.25 * corners.iter().sum::<f64>() + 2.0 * middle) / 3.0
}

/// The middle of places.
pub(super) fn mean_place(places: &[DVec2; 4]) -> DVec2 {
    (places[0] + places[1] + places[2] + places[3]) * 0.25
}
