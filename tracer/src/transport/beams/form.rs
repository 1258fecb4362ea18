//! Whether a beam is what its four rays say, or has to be divided.

use super::beam::Piece;
use super::cell::{Cell, mean, mean_place};
use super::corner::Probe;
use super::sweep::Sweep;
use geometry::DVec2;
use std::f64::consts::TAU;

/// How far the end of the ray in the middle may be from the line between the edges' ends, pixels.
const MOST_SAG_PX: f64 = 0.2;

/// How far aside of the middle between the edges that ray may be: this part of the beam's width, and no less and no more than these
/// pixels. Light is spread evenly over a beam; with this its halves differ by 1 %. Of faint beams less is seen: where light is so
/// many times thinner than all of its family's on a circle round the source, through the picture's farthest end, it may bend
/// so much more, and be so much more uneven.
const MOST_BEND: f64 = 0.0025;
const BENDS_PX: [f64; 2] = [0.02, 0.2];

/// The same part of a beam's width in v, which light is spread over once more: it shows at edges alone.
const MOST_BEND_ACROSS: f64 = 0.004;

/// How much power may differ between the edges of a beam that is wider than two pixels, of its own.
const MOST_FADE: f64 = 0.04;

/// How much light a beam may have more or less than its corners and the ray in its middle say, of its family's: beside a tangent
/// Fresnel's power falls like a root, within less than a pixel.
const MOST_DEFECT: f64 = 2e-6;

/// However faint a beam is, its rays are not farther from parallel than this, the cosine of 23 degrees: one that a hollow mirror sends
/// to its focus from all sides would have no direction.
const LEAST_COSINE: f64 = 0.92;

/// Narrower beams hold otherwise whatever they do, pixels.
const NARROW_PX: f64 = 0.1;

/// Halvings of a beam for its form alone, in u and in v.
const MOST_HALVINGS: [u32; 2] = [14, 6];

/// Whether a beam is what its edges say.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Form {
    Holds,
    /// It bends over u.
    Bends,
    /// It bends over v.
    BendsAcross,
    /// A ray in its middle meets something else.
    Parts,
}

/// How much a beam may bend, for its light.
struct Limits {
    /// A pixel, mm.
    px: f64,
    /// Its light, of its family's.
    light: f64,
    /// Light across a millimetre that is neither much nor little.
    usual: f64,
}

impl Limits {
    /// How many times thinner its light is than usual light, where it is so wide in u. Its width in v is that of its neighbours too,
    /// whose light lies over its own.
    fn faintness(&self, width: f64) -> f64 {
        (self.usual * width / self.light).max(1.0)
    }

    /// Aside, where it is so wide: `bend`, within limits.
    fn aside(&self, bend: f64, width: f64) -> f64 {
        let [least, most] = BENDS_PX.map(|bend| bend * self.px);
        bend.min(most).max(least) * self.faintness(width)
    }

    /// Along the beam, where it begins or ends and is so wide.
    fn sag(&self, width: f64) -> f64 {
        MOST_SAG_PX * self.px * self.faintness(width)
    }
}

/// A beam whose form is in question.
struct Question<'a> {
    cell: &'a Cell,
    probes: &'a [Probe; 4],
    piece: &'a Piece,
    along: DVec2,
    limits: Limits,
}

/// Corners at the same v, and at the same u.
const OVER_U: [[usize; 2]; 2] = [[0, 1], [2, 3]];
const OVER_V: [[usize; 2]; 2] = [[0, 2], [1, 3]];

impl Question<'_> {
    fn width(&self, places: &[DVec2; 4], [one, other]: [usize; 2]) -> f64 {
        (places[other] - places[one]).perp_dot(self.along).abs()
    }

    fn widest(&self, pairs: [[usize; 2]; 2]) -> f64 {
        let of = |pair: [usize; 2]| self.width(&self.piece.from, pair).max(self.width(&self.piece.to, pair));
        of(pairs[0]).max(of(pairs[1]))
    }

    /// Whether what rays leave in a row of pixels differs too much between corners, and with the one in the middle.
    fn fades(&self, size: f64, pairs: [[usize; 2]; 2], middle: &Probe) -> bool {
        // In a slanted beam light of the same power across it lies on more of the row.
        let is_steep = self.along.y.abs() >= self.along.x.abs();
        let squareness = |direction: DVec2| if is_steep { direction.y } else { direction.x }.abs();
        let left = |probe: &Probe| probe.corner.strength() * squareness(probe.corner.ray.direction);
        let strength = |at: usize| left(&self.probes[at]);
        let middle = left(middle);
        let most = pairs.map(|[a, b]| {
            let [a, b] = [strength(a), strength(b)];
            (a - b).abs().max((middle - 0.5 * (a + b)).abs()) / a.max(b).max(middle)
        });
        size > 2.0 * self.limits.px && most[0].max(most[1]) > MOST_FADE * self.limits.faintness(self.widest(OVER_U))
    }
}

impl Sweep<'_, '_> {
    /// Whether a beam is what its edges say: the rays in its middle go where they have them, they are as bright as each other, and
    /// nothing lies between them.
    pub(super) fn form(&self, cell: &Cell, probes: &[Probe; 4], middle: Option<&Probe>, piece: &Piece) -> Form {
        let px = self.view.mm_per_px;
        let along = (mean_place(&piece.to) - mean_place(&piece.from)).normalize_or_zero();
        let strength = probes.iter().map(|probe| probe.corner.strength()).fold(f64::MIN_POSITIVE, f64::max);
        let limits = Limits { px, light: cell.light * strength, usual: 1.0 / self.farthest() };
        let mut question = Question { cell, probes, piece, along, limits };
        let narrow = NARROW_PX * px;
        let wide = question.widest(OVER_U);
        let high = if cell.is_line() { 0.0 } else { question.widest(OVER_V) };
        let may_halve =
            [cell.halved[0] < MOST_HALVINGS[0] && wide >= narrow, cell.halved[1] < MOST_HALVINGS[1] && high >= narrow];
        if cell.is_as_one() {
            return Form::Holds;
        }
        if cell.halved[0] < MOST_HALVINGS[0] && spreads(probes, OVER_U) {
            return Form::Bends;
        }
        if cell.halved[1] < MOST_HALVINGS[1] && spreads(probes, OVER_V) {
            return Form::BendsAcross;
        }
        let defect = 0.5 * (strength_of(probes, middle) - strength_of(probes, None)).abs() * cell.light;
        if defect > MOST_DEFECT && cell.halved[0] < MOST_HALVINGS[0] {
            return Form::Bends;
        }
        if may_halve == [false; 2] {
            return Form::Holds;
        }
        let Some(middle) = middle else { return Form::Parts };
        question.limits.light = cell.light * strength.max(middle.corner.strength());
        if may_halve[0] {
            match self.bends_over_u(&question, middle, wide) {
                Some(true) => return Form::Bends,
                None => return Form::Parts,
                Some(false) => {}
            }
        }
        if may_halve[1] && self.bends_over_v(&question, middle, high) { Form::BendsAcross } else { Form::Holds }
    }

    /// The ray in a cell's middle, if it meets what the corners meet.
    pub(super) fn middle(&self, cell: &Cell, probes: &[Probe; 4]) -> Option<Probe> {
        self.probe(cell.center()).filter(|middle| middle.edge == probes[0].edge)
    }

    /// Round the source, through the picture's farthest end: over this its family's light is spread, mm.
    fn farthest(&self) -> f64 {
        let half = DVec2::new(self.view.width as f64, self.view.height as f64) * (0.5 * self.view.mm_per_px);
        TAU * (self.family.source.form.middle().distance(self.view.origin_mm + half) + half.length())
    }

    /// Whether it has to be halved in u; `None` where a ray meets something else.
    fn bends_over_u(&self, question: &Question, middle: &Probe, wide: f64) -> Option<bool> {
        if question.fades(wide, OVER_U, middle) || self.something_between(question) {
            return Some(true);
        }
        // At the v where the cell is wider.
        let cell = question.cell;
        let v = usize::from(cell.u[1][1] - cell.u[1][0] > cell.u[0][1] - cell.u[0][0]);
        let probe = if cell.is_line() {
            *middle
        } else {
            self.probe([cell.middles()[v], cell.v[v]]).filter(|probe| probe.edge == middle.edge)?
        };
        let most = |places: &[DVec2; 4]| {
            let width = question.width(places, OVER_U[v]);
            question.limits.aside(MOST_BEND * width, width)
        };
        Some(self.is_off(&probe, question, &OVER_U[v], most))
    }

    /// Whether it has to be halved in v.
    fn bends_over_v(&self, question: &Question, middle: &Probe, high: f64) -> bool {
        let most = |places: &[DVec2; 4]| {
            let high = question.width(places, OVER_V[0]).max(question.width(places, OVER_V[1]));
            let wide = question.width(places, OVER_U[0]).max(question.width(places, OVER_U[1]));
            question.limits.aside((MOST_BEND_ACROSS * high).max(MOST_BEND * wide), wide)
        };
        question.fades(high, OVER_V, middle) || self.is_off(middle, question, &[0, 1, 2, 3], most)
    }

    /// Whether the ray is farther than `most` aside of the mean of these corners, where it begins or ends.
    fn is_off(&self, probe: &Probe, question: &Question, corners: &[usize], most: impl Fn(&[DVec2; 4]) -> f64) -> bool {
        let Question { piece, along, limits, .. } = question;
        let off = |end: DVec2, places: &[DVec2; 4]| {
            end - corners.iter().map(|corner| places[*corner]).sum::<DVec2>() / corners.len() as f64
        };
        // A source's own form is no bend, and how far out a ray ends that meets nothing is nothing to see.
        let begins = (!self.met.is_empty()).then(|| (off(probe.corner.ray.origin, &piece.from), &piece.from, true));
        let ends = (off(probe.end, &piece.to), &piece.to, probe.edge.is_some());
        begins.into_iter().chain([ends]).any(|(off, places, is_surface)| {
            off.perp_dot(*along).abs() > most(places)
                || is_surface && off.dot(*along).abs() > limits.sag(question.width(places, OVER_U[0]))
        })
    }

    /// Whether something small lies between its rays.
    fn something_between(&self, question: &Question) -> bool {
        let piece = question.piece;
        let but = [question.probes[0].edge, self.met.last().map(|met| met.edge)];
        let but: Vec<_> = but.into_iter().flatten().collect();
        let outline = |v: usize| [piece.from[v], piece.to[v], piece.to[v + 1], piece.from[v + 1]];
        let between = |v: usize| self.tracer.landmarks.any_within(&outline(v), &but);
        between(0) || !question.cell.is_line() && between(2)
    }
}

/// Whether rays part or meet at too wide an angle.
fn spreads(probes: &[Probe; 4], pairs: [[usize; 2]; 2]) -> bool {
    let direction = |at: usize| probes[at].corner.ray.direction;
    pairs.iter().any(|[one, other]| direction(*one).dot(direction(*other)) < LEAST_COSINE)
}

/// What of a cell's light has come as far: the mean over it by Simpson's rule, from its corners and the ray in its middle.
pub(super) fn strength_of(probes: &[Probe; 4], middle: Option<&Probe>) -> f64 {
    let corners = probes.map(|probe| probe.corner.strength());
    middle.map_or(0.25 * corners.iter().sum::<f64>(), |middle| mean(corners, middle.corner.strength()))
}
