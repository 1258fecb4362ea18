//! Reach: where on the playfield a ball can come to.
//!
//! A flood over a grid, from the place where new balls arrive: a square belongs to it if there is room for a ball
//! somewhere in it. What moves (drop targets, spinners, flippers, captive balls) is never in the way, a gate only against its
//! direction, and a ramp that a ball can come onto brings it to both of its ends. So nothing is called out of reach that a shot
//! could come to.

mod gaps;
mod one_way;
mod ramps;

pub use one_way::OneWayGates;
pub use ramps::{low_ends, ramp};

use geometry::{DVec2, Shape};
use physics::{BALL_RADIUS_M, Kind, Machine, PartId};

/// From one square to the next, m.
const STEP_M: f64 = 0.002;
/// Along each side of a square so many places are tried, if there is no room in its middle.
const TRIES: i32 = 4;
/// A ball that is put into a shape is so deep in it, m, or half its radius.
const INSIDE_M: f64 = 1e-3;
/// So far above the lowest row of a pocket there is room in the middle of a square, rows.
const PIT_ROWS: usize = 3;
/// No place is to the last bit above the middle of a post: a ball lies even there.
const ASIDE_M: f64 = 3e-4;

/// The squares that a ball can come to.
pub struct Reach {
    columns: usize,
    squares: Vec<Square>,
    /// The ramps that a ball can come onto.
    ramps: Vec<PartId>,
}

/// What a ball finds in a square of the grid.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Square {
    OutOfReach,
    Reached,
    /// Reached, and there is room for a ball in its middle, outside of drains.
    Roomy,
}

impl Reach {
    /// All that a ball can come to from `start`; through these gates it comes one way.
    pub fn new(machine: &Machine, start: DVec2, gates: OneWayGates) -> Reach {
        let size = machine.layout().size_m;
        let columns = ((size.x / STEP_M) as usize).max(1);
        let rows = ((size.y / STEP_M) as usize).max(1);
        let mut reach = Reach { columns, squares: vec![Square::OutOfReach; columns * rows], ramps: Vec::new() };
        let mut flood = Flood { machine, rooms: Rooms::new(machine), gates, found: Vec::new() };
        reach.flood(&mut flood, start);
        reach.follow_ramps(&mut flood);
        reach
    }

    /// Adds what a ball can come to from `start`.
    fn flood(&mut self, flood: &mut Flood, start: DVec2) {
        let Some(start) = self.square_of(start) else { return };
        self.visit(flood, start);
        while let Some(square) = flood.found.pop() {
            for near in self.beside(square) {
                if !flood.gates.stop(self.middle(square), self.middle(near)) {
                    self.visit(flood, near);
                }
            }
        }
    }

    /// The squares that have a side with this one.
    fn beside(&self, square: usize) -> impl Iterator<Item = usize> + use<> {
        let (column, row) = (square % self.columns, square / self.columns);
        let beside = [
            (column > 0).then(|| square - 1),
            (column + 1 < self.columns).then(|| square + 1),
            (row > 0).then(|| square - self.columns),
            (square + self.columns < self.squares.len()).then(|| square + self.columns),
        ];
        beside.into_iter().flatten()
    }

    fn visit(&mut self, flood: &mut Flood, square: usize) {
        if self.squares[square] != Square::OutOfReach {
            return;
        }
        let room = flood.room(self.middle(square));
        if room == Room::None {
            return;
        }
        self.squares[square] = Square::Reached;
        if flood.is_lost(self.middle(square)) {
            return; // no ball comes past a drain
        }
        flood.found.push(square);
        if room == Room::Middle {
            self.squares[square] = Square::Roomy;
        }
    }

    /// The squares at the edge of the playfield that a ball can come to.
    fn open_edges(&self) -> impl Iterator<Item = usize> {
        let last_row = self.squares.len() / self.columns - 1;
        let is_edge = move |square: usize| {
            let (column, row) = (square % self.columns, square / self.columns);
            column == 0 || row == 0 || column + 1 == self.columns || row == last_row
        };
        self.roomy().filter(move |square| is_edge(*square))
    }

    /// The squares in whose middle there is room for a ball, row by row.
    fn roomy(&self) -> impl Iterator<Item = usize> {
        let squares = self.squares.iter().enumerate();
        squares.filter(|(_, square)| **square == Square::Roomy).map(|(index, _)| index)
    }

    fn middle(&self, square: usize) -> DVec2 {
        DVec2::new((square % self.columns) as f64 + 0.5, (square / self.columns) as f64 + 0.5) * STEP_M + ASIDE_M
    }

    fn square_of(&self, place: DVec2) -> Option<usize> {
        let at = place / STEP_M;
        let inside = at.x >= 0.0 && at.y >= 0.0 && (at.x as usize) < self.columns;
        let square = at.y as usize * self.columns + at.x as usize;
        (inside && square < self.squares.len()).then_some(square)
    }

    /// All places where a ball has room, in an order in which those at the beginning are spread over all of the table,
    /// however many they are. Where a place stands in it does not depend on other places.
    pub fn spread_places(&self) -> Vec<DVec2> {
        let mut roomy: Vec<usize> = self.roomy().collect();
        roomy.sort_by_key(|square| dither_rank(square % self.columns, square / self.columns));
        roomy.into_iter().map(|square| self.middle(square)).collect()
    }

    /// Places that a ball could only leave upwards: in each pocket the lowest that has room, in the middle of its floor.
    pub fn pits(&self) -> Vec<DVec2> {
        let rows = self.squares.chunks(self.columns).enumerate();
        let pits = rows.flat_map(|(row, squares)| {
            let all: Vec<usize> = (0..self.columns).filter(|column| squares[*column] != Square::OutOfReach).collect();
            let runs = all.chunk_by(|one, next| one + 1 == *next).filter(|run| !self.leads_down(row, run));
            runs.filter_map(|run| self.lowest_room(row, run)).collect::<Vec<_>>()
        });
        pits.map(|square| self.middle(square)).collect()
    }

    /// Whether a ball can come down from this run of a row's columns.
    fn leads_down(&self, row: usize, run: &[usize]) -> bool {
        let columns = run[0].saturating_sub(1)..=(run[run.len() - 1] + 1).min(self.columns - 1);
        let below = |column| self.squares.get((row + 1) * self.columns + column);
        columns.into_iter().any(|column| below(column).is_none_or(|square| *square != Square::OutOfReach))
    }

    /// The square in whose middle a ball has room, in the run or just above it, that is nearest to the run's middle.
    fn lowest_room(&self, row: usize, run: &[usize]) -> Option<usize> {
        let middle = run[run.len() / 2];
        let rows = (row.saturating_sub(PIT_ROWS)..=row).rev();
        rows.into_iter().find_map(|row| {
            let roomy = run.iter().filter(|column| self.squares[row * self.columns + **column] == Square::Roomy);
            roomy.min_by_key(|column| column.abs_diff(middle)).map(|column| row * self.columns + column)
        })
    }

    /// The places that have room for a ball and are no farther from `shape` than `range_m`, row by row.
    pub fn roomy_near(&self, shape: Shape, range_m: f64) -> impl Iterator<Item = DVec2> {
        let roomy = self.near(&shape, range_m).filter(|square| self.squares[*square] == Square::Roomy);
        roomy.map(|square| self.middle(square)).filter(move |place| shape.distance(*place).0 <= range_m)
    }

    /// The reached place that is nearest to the surface of `shape` and has room for a ball, and how far it is from it;
    /// none if it is as far as `range_m`.
    pub fn nearest(&self, shape: &Shape, range_m: f64) -> Option<(DVec2, f64)> {
        let roomy = self.near(shape, range_m).filter(|square| self.squares[*square] == Square::Roomy);
        let places = roomy.map(|square| self.middle(square));
        let distances = places.map(|place| (place, shape.distance(place).0));
        let near = distances.filter(|(_, distance)| *distance < range_m);
        near.min_by(|one, other| one.1.total_cmp(&other.1))
    }

    /// A place inside of `shape`, at its edge, that a ball can come to.
    pub fn place_in(&self, machine: &Machine, shape: &Shape) -> Option<DVec2> {
        let near = self.near(shape, 0.0).filter(|square| self.squares[*square] != Square::OutOfReach);
        let inside = near.filter_map(|square| {
            let (distance, normal) = shape.distance(self.middle(square));
            let place = self.middle(square) - normal * (distance.max(0.0) + INSIDE_M.min(0.5 * shape.radius));
            let is_in = distance < 2.0 * STEP_M && shape.distance(place).0 <= 0.0;
            (is_in && machine.depth_in_fixed_m(place) <= 0.0).then_some((place, distance))
        });
        // The flood ends where a drain begins: the deepest of its squares are the nearest to its middle.
        inside.min_by(|one, other| one.1.total_cmp(&other.1)).map(|(place, _)| place)
    }

    /// Whether the centre of a ball can come as near as `reach_m` to `shape`.
    pub fn comes_to(&self, shape: &Shape, reach_m: f64) -> bool {
        self.near(shape, reach_m).any(|square| {
            self.squares[square] != Square::OutOfReach && shape.distance(self.middle(square)).0 <= reach_m + STEP_M
        })
    }

    /// The squares of the grid no farther than `reach_m` from the box round `shape`, and some beside them.
    fn near(&self, shape: &Shape, reach_m: f64) -> impl Iterator<Item = usize> + use<> {
        let grown = shape.bounds().grown(reach_m + STEP_M);
        let corner = |place: DVec2| (place / STEP_M).max(DVec2::ZERO);
        let (first, last) = (corner(grown.min), corner(grown.max));
        let (all_columns, all_rows) = (self.columns, self.squares.len() / self.columns);
        let columns = first.x as usize..(last.x as usize + 1).min(all_columns);
        let rows = first.y as usize..(last.y as usize + 1).min(all_rows);
        rows.flat_map(move |row| columns.clone().map(move |column| row * all_columns + column))
    }
}

/// Where a square stands in the order of a Bayer matrix: the bits of its coordinates, the finest first.
fn dither_rank(column: usize, row: usize) -> u64 {
    let bit = |number: usize, at: usize| ((number >> at) & 1) as u64;
    (0..16).fold(0, |rank, at| rank << 2 | bit(column ^ row, at) << 1 | bit(row, at))
}

/// How much room there is for a ball in a square.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Room {
    None,
    /// Somewhere in it.
    Some,
    /// In its middle.
    Middle,
}

/// A flood on its way.
struct Flood<'a> {
    machine: &'a Machine,
    rooms: Rooms,
    gates: OneWayGates,
    /// Squares whose neighbours have not been looked at.
    found: Vec<usize>,
}

impl Flood<'_> {
    /// Whether the centre of a ball there is in a drain.
    fn is_lost(&self, center: DVec2) -> bool {
        let drains = self.machine.layout().parts.iter().filter_map(|part| match &part.kind {
            Kind::Drain(drain) => Some(&drain.shape),
            _ => None,
        });
        drains.into_iter().any(|shape| shape.distance(center).0 <= 0.0)
    }

    fn room(&self, middle: DVec2) -> Room {
        let depth = |place: DVec2| {
            if self.rooms.has(place) { self.machine.depth_in_fixed_m(place) } else { f64::INFINITY }
        };
        let at = depth(middle);
        if at < 0.0 {
            return Room::Middle;
        }
        // No place of the square is farther from its middle.
        if at > STEP_M {
            return Room::None;
        }
        let along = |step: i32| ((f64::from(step) + 0.5) / f64::from(TRIES) - 0.5) * STEP_M;
        let mut tries = (0..TRIES * TRIES).map(|at| middle + DVec2::new(along(at % TRIES), along(at / TRIES)));
        if tries.any(|place| depth(place) < 0.0) { Room::Some } else { Room::None }
    }
}

/// Where there is no playfield for a ball: beyond its edges, and behind the faces of rods.
struct Rooms {
    size_m: DVec2,
    rods: Vec<Rod>,
}

/// The face of a plunger or a kickback.
struct Rod {
    tip: DVec2,
    direction: DVec2,
    half_width_m: f64,
    stroke_m: f64,
}

impl Rooms {
    fn new(machine: &Machine) -> Rooms {
        let rod = |kind: &Kind| match kind {
            Kind::Plunger(own) => Some((own.tip, own.direction, own.half_width_m, own.stroke_m)),
            Kind::Kickback(own) => Some((own.tip, own.direction, own.half_width_m, own.stroke_m)),
            _ => None,
        };
        let rods = machine.layout().parts.iter().filter_map(|part| rod(&part.kind));
        let rods = rods.map(|(tip, direction, half_width_m, stroke_m)| Rod { tip, direction, half_width_m, stroke_m });
        Rooms { size_m: machine.layout().size_m, rods: rods.collect() }
    }

    fn has(&self, center: DVec2) -> bool {
        let on = center.cmpge(DVec2::ZERO).all() && center.cmple(self.size_m).all();
        on && !self.rods.iter().any(|rod| rod.has_behind_it(center))
    }
}

impl Rod {
    /// Whether a ball there would be in the rod's face, or behind it.
    fn has_behind_it(&self, center: DVec2) -> bool {
        let from_tip = center - self.tip;
        let (along, aside) = (from_tip.dot(self.direction), from_tip.dot(self.direction.perp()).abs());
        aside < self.half_width_m + BALL_RADIUS_M && along < BALL_RADIUS_M && along > -self.stroke_m - BALL_RADIUS_M
    }
}
