//! Where the rays of a cell part: they meet different surfaces, or some go nowhere. The cell is divided along that line.

use super::cell::Cell;
use super::corner::Probe;
use super::sweep::{State, Sweep};

/// How finely a place is found where rays part, of all of u or of a stratum of v: so near to a tangent that the light between is
/// nothing to see.
const FINEST: f64 = 1.0 / (1_u64 << 36) as f64;

/// After so many cuts a cell is halved in v.
const HALVED_EVERY: u32 = 4;

/// A place where rays part.
struct Parting {
    place: f64,
    /// The last one on this side, and the first one on the other.
    before: State,
    behind: State,
}

/// Whether two rays come as far as each other and meet the same surface next.
pub(super) fn alike(one: &State, other: &State) -> bool {
    let edge = |state: &State| state.as_ref().map(|Probe { edge, .. }| *edge);
    edge(one) == edge(other)
}

impl Sweep<'_, '_> {
    /// Divides a cell whose corners are not alike, and goes on with its parts.
    pub(super) fn cut(&mut self, cell: Cell, states: &[State; 4]) {
        if cell.width() < FINEST {
            return;
        }
        if cell.is_as_one() {
            return self.ray(cell, states);
        }
        let cell = Cell { cuts: cell.cuts + 1, ..cell };
        if states.iter().all(Option::is_none) {
            // It comes here because the ray in its middle is not dark.
            return self.quarter(cell);
        }
        // Along a curve where rays part, chords between its points may cut off slivers for ever: halves come nearer to it.
        if !cell.is_line() && cell.cuts.is_multiple_of(HALVED_EVERY) {
            return self.halve_across(cell, states);
        }
        if cell.is_line() {
            let parting = self.parting_over_u(&cell, 0, states, false);
            let parts = cell.divided([parting.place; 2]);
            self.cell(parts[0], [states[0], parting.before, states[2], parting.before]);
            return self.cell(parts[1], [parting.behind, states[1], parting.behind, states[3]]);
        }
        let [low, high] = [!alike(&states[0], &states[1]), !alike(&states[2], &states[3])];
        let [left, right] = [!alike(&states[0], &states[2]), !alike(&states[1], &states[3])];
        match (low, high, left, right) {
            (true, true, false, _) | (true, true, true, false) => self.cut_over_u(cell, states, left),
            (false, false, ..) | (_, _, true, false) | (_, _, false, true) => self.cut_over_v(cell, states),
            _ => self.halve_across(cell, states),
        }
    }

    /// Divides a cell along a line from the lower to the upper v: on the left of it all is like the left corners, or on the right
    /// like the right ones.
    fn cut_over_u(&mut self, cell: Cell, states: &[State; 4], from_right: bool) {
        let partings = [0, 1].map(|v| self.parting_over_u(&cell, v, states, from_right));
        let parts = cell.divided([partings[0].place, partings[1].place]);
        self.cell(parts[0], [states[0], partings[0].before, states[2], partings[1].before]);
        self.cell(parts[1], [partings[0].behind, states[1], partings[1].behind, states[3]]);
    }

    /// Divides a cell where its left or its right side's rays part.
    fn cut_over_v(&mut self, cell: Cell, states: &[State; 4]) {
        let side = |end: usize| {
            let [low, high] = [&states[end], &states[2 + end]];
            let place = |v: f64| [cell.across(v)[end], v];
            (!alike(low, high)).then(|| (end, self.parting_along(place, cell.v, [low, high])))
        };
        let mut partings: Vec<(usize, Parting)> = [side(0), side(1)].into_iter().flatten().collect();
        partings.sort_by(|(_, one), (_, other)| one.place.total_cmp(&other.place));
        let mut from = (cell.v[0], [states[0], states[1]]);
        for (end, Parting { place, before, behind }) in partings {
            let mut low = cell.across(place).map(|u| self.probe([u, place]));
            let mut high = low;
            (low[end], high[end]) = (before, behind);
            if place > from.0 {
                self.cell(cell.slice([from.0, place]), [from.1[0], from.1[1], low[0], low[1]]);
            }
            from = (place, high);
        }
        if from.0 < cell.v[1] {
            self.cell(cell.slice([from.0, cell.v[1]]), [from.1[0], from.1[1], states[2], states[3]]);
        }
    }

    /// All four quarters of a cell whose corners are dark, or its halves.
    fn quarter(&mut self, cell: Cell) {
        let middles = cell.middles();
        let [low, high] = [0, 1].map(|v| self.probe([middles[v], cell.v[v]]));
        let [left, right] = cell.divided(middles);
        for (half, states) in [(left, [None, low, None, high]), (right, [low, None, high, None])] {
            if cell.is_line() { self.cell(half, states) } else { self.halve_across(half, &states) }
        }
    }

    /// Both halves of a cell in v, or its middle.
    pub(super) fn halve_across(&mut self, cell: Cell, states: &[State; 4]) {
        let halves = cell.halves_across();
        let [first, second] = halves[..] else {
            let line = halves[0];
            let [a, b] = line.u[0].map(|u| self.probe([u, line.v[0]]));
            return self.cell(line, [a, b, a, b]);
        };
        let middle = second.u[0].map(|u| self.probe([u, second.v[0]]));
        self.cell(first, [states[0], states[1], middle[0], middle[1]]);
        self.cell(second, [middle[0], middle[1], states[2], states[3]]);
    }

    /// Where rays of the lower or the upper v cease to be like the left one, or the right one.
    fn parting_over_u(&self, cell: &Cell, v: usize, states: &[State; 4], from_right: bool) -> Parting {
        let place = |u: f64| [u, cell.v[v]];
        let ([from, to], [left, right]) = (cell.u[v], [&states[2 * v], &states[2 * v + 1]]);
        if !from_right {
            return self.parting_along(place, [from, to], [left, right]);
        }
        let Parting { place, before, behind } = self.parting_along(place, [to, from], [right, left]);
        Parting { place, before: behind, behind: before }
    }

    /// Where rays cease to be like the first of two between two places, of which `place` says u and v.
    fn parting_along(&self, place: impl Fn(f64) -> [f64; 2], ends: [f64; 2], states: [&State; 2]) -> Parting {
        let [mut before, mut behind] = states.map(|state| *state);
        if alike(&before, &behind) {
            return Parting { place: 0.5 * (ends[0] + ends[1]), before, behind };
        }
        let [mut low, mut high] = ends;
        while (high - low).abs() > FINEST {
            let middle = 0.5 * (low + high);
            let state = self.probe(place(middle));
            if alike(&state, states[0]) {
                (low, before) = (middle, state);
            } else {
                (high, behind) = (middle, state);
            }
        }
        Parting { place: 0.5 * (low + high), before, behind }
    }
}
