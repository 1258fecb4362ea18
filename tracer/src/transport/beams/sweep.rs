//! The sweep over a family: cells that are divided until their beams hold, through all surfaces.

use super::beam::Piece;
use super::cell::{Cell, mean};
use super::corner::{Corner, Probe, Way};
use super::cut::alike;
use super::family::{Family, Lays};
use super::film::BeamFilm;
use super::form::Form;
use super::horizon::Horizon;
use super::leaf::Leaf;
use super::tracer::BeamTracer;
use crate::View;
use crate::transport::{EdgeId, Media};
use std::rc::Rc;

/// What a beam met before: which edge, and what became of it there.
#[derive(Clone, Copy)]
pub(super) struct Met {
    pub edge: EdgeId,
    way: Way,
}

/// A cell behind what its beam has met.
pub(super) struct Pending {
    met: Rc<[Met]>,
    cell: Cell,
    states: [State; 4],
}

/// Found while a beam is divided: its rays do not all meet the same surface.
struct Parted;

/// A ray that has come as far as its beam; `None` if it did not.
pub(super) type State = Option<Probe>;

/// One family's sweep onto a film.
pub(super) struct Sweep<'a, 'b> {
    pub tracer: &'b BeamTracer<'a>,
    pub family: &'b Family<'a>,
    pub media: Media,
    pub view: &'b View,
    pub film: &'b mut BeamFilm,
    /// What no light on the film is over: it holds parts of that.
    pub most: f64,
    /// Where rays that meet nothing end.
    pub horizon: Horizon,
    /// What the cell that is looked at has met.
    pub met: Rc<[Met]>,
    /// Cells behind surfaces that are not looked at yet: a list and no recursion, since light may meet hundreds of surfaces.
    pub pending: Vec<Pending>,
    /// Pieces that may still be looked at.
    pub pieces_left: u64,
    /// What was done since the last question whether to go on.
    pub work: u64,
    /// The family's light that had met the most surfaces, in units of [`GIVEN_UP_UNIT`].
    pub given_up: u64,
    /// Asked now and then whether to go on.
    pub goes_on: &'b (dyn Fn() -> bool + Sync),
}

/// A part of a family's light: whole numbers of it are the same sum in any order.
pub(super) const GIVEN_UP_UNIT: f64 = 1.0 / (1_u64 << 40) as f64;

/// What is less than this part of a beam counts as weaker in proportion.
const SMALL_PART: f64 = 4.0;

/// Beams with less than the least power are not divided any more, and with less than this part of it they are left out.
const LEFT_OUT: f64 = 1.0 / 8.0;

/// Leaves of one beam at most: where it bends more, what is left of it is laid as it is.
const MOST_LEAVES: usize = 1 << 12;

/// With more cells pending than this, some hundred megabytes, what is partly dark goes on whole.
const MOST_PENDING: usize = 1 << 17;

/// From one question to the next whether to go on: surfaces that rays are led through again, some milliseconds.
const ASKED_EVERY: u64 = 1 << 12;

impl Sweep<'_, '_> {
    /// All beams of these; `false` if some were left out.
    pub fn run(&mut self, beams: std::ops::Range<u32>) -> bool {
        let count = f64::from(self.tracer.options.beams);
        for beam in beams {
            let cell = Cell::new([beam, beam + 1].map(|edge| f64::from(edge) / count));
            self.met = Rc::default();
            self.cell(cell, std::array::from_fn(|at| self.probe(cell.corner(at))));
            while let Some(Pending { met, cell, states }) = self.pending.pop() {
                self.met = met;
                self.cell(cell, states);
            }
        }
        self.pieces_left > 0
    }

    /// Asks whether to go on, after as much work wherever it is done: behind hundreds of surfaces a single cell takes seconds.
    fn ask_now_and_then(&mut self) {
        self.work += 1 + self.met.len() as u64;
        if self.work >= ASKED_EVERY {
            self.work = 0;
            if !(self.goes_on)() {
                self.pieces_left = 0;
            }
        }
    }

    /// The ray at u and v behind the same surfaces, and what it meets next.
    pub(super) fn probe(&self, [u, v]: [f64; 2]) -> State {
        let surfaces = &self.tracer.surfaces;
        let mut corner = self.tracer.start(self.family, self.media, [u, v]);
        for met in self.met.iter() {
            let contacts = surfaces.meet(&corner.ray, &corner.starts_on)?;
            if contacts.first().edge != met.edge {
                return None;
            }
            corner = corner.next(surfaces, &contacts, met.way)?;
        }
        Some(self.onward(corner))
    }

    /// What a ray meets next.
    fn onward(&self, corner: Corner) -> Probe {
        let contacts = self.tracer.surfaces.meet(&corner.ray, &corner.starts_on);
        let edge = contacts.as_ref().map(|contacts| contacts.first().edge);
        let end = contacts.map_or_else(|| self.horizon.end(&corner.ray), |contacts| contacts.first().place);
        Probe { corner, edge, end }
    }

    /// A cell whose corners are known.
    pub(super) fn cell(&mut self, cell: Cell, states: [State; 4]) {
        let Some(left) = self.pieces_left.checked_sub(1) else { return };
        self.pieces_left = left;
        self.ask_now_and_then();
        if states.iter().all(Option::is_none) && self.probe(cell.center()).is_none() {
            return;
        }
        if let [Some(a), Some(b), Some(c), Some(d)] = states
            && states[1..].iter().all(|state| alike(state, &states[0]))
        {
            return self.beam(cell, &[a, b, c, d]);
        }
        self.cut(cell, &states);
    }

    /// One ray for all of a cell that go on: the one in its middle, or a corner's. It has what of the cell's light goes on, by
    /// Simpson's rule.
    pub(super) fn ray(&mut self, cell: Cell, states: &[State; 4]) {
        let middle = self.probe(cell.center());
        let corner = states.iter().zip(0..).find_map(|(state, at)| state.map(|probe| (probe, cell.corner(at))));
        let part = mean(states.map(|state| state.map_or(0.0, |_| 1.0)), middle.map_or(0.0, |_| 1.0));
        if let Some((probe, [u, v])) = middle.map(|probe| (probe, cell.center())).or(corner) {
            self.beam(Cell { u: [[u; 2]; 2], v: [v; 2], light: cell.light * part, ..cell }, &[probe; 4]);
        }
    }

    /// A cell whose corners meet the same surface. For its form it is divided into leaves, which are laid; behind the surface
    /// the whole cell goes on, to be divided as it needs there.
    fn beam(&mut self, cell: Cell, probes: &[Probe; 4]) {
        let cell = Cell { halved: [0; 2], ..cell };
        let mut leaves = Vec::new();
        if self.leaves(&cell, probes, &mut leaves).is_err() {
            return self.part(cell, probes);
        }
        if !self.met.is_empty() || self.family.lays != Lays::BehindSurfaces {
            leaves.iter().for_each(|leaf| self.splat(leaf));
        }
        let Some(edge) = probes[0].edge else { return };
        if self.family.lays == Lays::BeforeSurfaces {
            return;
        }
        if self.met.len() >= self.tracer.options.most_surfaces as usize {
            return self.give_up(&cell);
        }
        self.pieces_left = self.pieces_left.saturating_sub(leaves.len() as u64);
        for way in [Way::Reflected, Way::Through] {
            self.go_on(&cell, probes, &leaves, Met { edge, way });
        }
    }

    /// Divides a beam until its parts hold.
    fn leaves(&mut self, cell: &Cell, probes: &[Probe; 4], leaves: &mut Vec<Leaf>) -> Result<(), Parted> {
        let piece = Piece {
            from: probes.map(|probe| probe.corner.ray.origin),
            to: probes.map(|probe| probe.end),
            widths: cell.u.map(|[from, to]| to - from),
            bulge: None,
        };
        let is_seen = self.touches(&piece);
        self.ask_now_and_then();
        let may_divide = is_seen && leaves.len() < MOST_LEAVES && self.pieces_left > 0;
        let middle = if is_seen { self.middle(cell, probes) } else { None };
        match if may_divide { self.form(cell, probes, middle.as_ref(), &piece) } else { Form::Holds } {
            Form::Holds => {
                leaves.push(self.leaf(cell, probes, middle.as_ref(), piece));
                Ok(())
            }
            Form::Bends => {
                let middles = cell.middles();
                let low = self.alike_at([middles[0], cell.v[0]], probes[0].edge)?;
                let high = if cell.is_line() { low } else { self.alike_at([middles[1], cell.v[1]], low.edge)? };
                let [left, right] = Cell { halved: [cell.halved[0] + 1, cell.halved[1]], ..*cell }.divided(middles);
                self.leaves(&left, &[probes[0], low, probes[2], high], leaves)?;
                self.leaves(&right, &[low, probes[1], high, probes[3]], leaves)
            }
            Form::BendsAcross => {
                let middle = 0.5 * (cell.v[0] + cell.v[1]);
                let halved = Cell { halved: [cell.halved[0], cell.halved[1] + 1], ..*cell };
                let [first, second] = [[cell.v[0], middle], [middle, cell.v[1]]].map(|v| halved.slice(v));
                let [left, right] = second.u[0].map(|u| self.alike_at([u, middle], probes[0].edge));
                let (left, right) = (left?, right?);
                self.leaves(&first, &[probes[0], probes[1], left, right], leaves)?;
                self.leaves(&second, &[left, right, probes[2], probes[3]], leaves)
            }
            Form::Parts => Err(Parted),
        }
    }

    /// The ray at a place that meets this surface.
    fn alike_at(&self, place: [f64; 2], edge: Option<EdgeId>) -> Result<Probe, Parted> {
        self.probe(place).filter(|probe| probe.edge == edge).ok_or(Parted)
    }

    /// Both halves of a cell whose corners meet one surface and rays between them another: in u, or in v where only there they do.
    fn part(&mut self, cell: Cell, probes: &[Probe; 4]) {
        if cell.is_as_one() {
            return self.ray(cell, &probes.map(Some));
        }
        let cell = Cell { cuts: cell.cuts + 1, ..cell };
        let middles = cell.middles();
        let low = self.probe([middles[0], cell.v[0]]);
        let high = if cell.is_line() { low } else { self.probe([middles[1], cell.v[1]]) };
        let states = probes.map(Some);
        if !cell.is_line() && alike(&low, &states[0]) && alike(&high, &states[0]) {
            return self.halve_across(cell, &states);
        }
        let [left, right] = cell.divided(middles);
        self.cell(left, [states[0], low, states[2], high]);
        self.cell(right, [low, states[1], high, states[3]]);
    }

    /// The ray behind the surface that it meets.
    fn behind(&self, probe: &Probe, way: Way) -> Option<Corner> {
        let surfaces = &self.tracer.surfaces;
        let contacts = surfaces.meet(&probe.corner.ray, &probe.corner.starts_on)?;
        probe.corner.next(surfaces, &contacts, way)
    }

    /// Counts the light that goes on from a cell that is followed no farther.
    fn give_up(&mut self, cell: &Cell) {
        let Some(middle) = self.probe(cell.center()) else { return };
        let strengths = [Way::Reflected, Way::Through].map(|way| self.behind(&middle, way).map(|on| on.strength()));
        let light = cell.light * strengths.into_iter().flatten().sum::<f64>();
        self.given_up += (light / GIVEN_UP_UNIT) as u64;
    }

    /// A cell behind the surface that it meets: all of it, or leaf by leaf where some of its rays go nowhere, as beyond the angle of
    /// total reflection, so that no light is lost between corners that are all dark.
    fn go_on(&mut self, cell: &Cell, probes: &[Probe; 4], leaves: &[Leaf], met: Met) {
        let all = leaves.iter().flat_map(|leaf| leaf.probes).chain(self.probe(cell.center()));
        let strengths = all.map(|probe| self.behind(&probe, met.way).map(|corner| corner.strength()));
        let (mut strongest, mut is_dark) = (0.0_f64, false);
        strengths.for_each(|strength| match strength {
            Some(strength) => strongest = strongest.max(strength),
            None => is_dark = true,
        });
        // A small part of a beam is as little as a weak one.
        let part = (SMALL_PART * cell.light * f64::from(self.tracer.options.beams)).min(1.0);
        let power = strongest * part / self.tracer.options.least_power;
        if power < LEFT_OUT {
            return;
        }
        let whole = [(if power < 1.0 { cell.as_one() } else { *cell }, *probes)];
        let cells: Vec<(Cell, [Probe; 4])> = if is_dark && power >= 1.0 && self.pending.len() < MOST_PENDING {
            leaves.iter().map(|leaf| (leaf.cell, leaf.probes)).collect()
        } else {
            whole.into()
        };
        let behind: Rc<[Met]> = self.met.iter().copied().chain([met]).collect();
        for (cell, probes) in cells {
            let states = probes.each_ref().map(|probe| Some(self.onward(self.behind(probe, met.way)?)));
            self.pending.push(Pending { met: behind.clone(), cell, states });
        }
    }
}
