//! The sweep over a family: beams that are halved until they hold, through all surfaces.

use super::beam::Piece;
use super::cell::Cell;
use super::corner::{Corner, Side};
use super::family::Family;
use super::film::BeamFilm;
use super::tracer::BeamTracer;
use crate::View;
use crate::transport::{Contacts, EdgeId, Falloff, Media};
use geometry::{DVec2, Ray};

/// No beam is halved that is narrower in u than this: the ray in its middle has all of its light.
const NARROWEST: f64 = 1.0 / (1 << 16) as f64;

/// Where beams of this width in u part because of their width in v, that is divided.
const NARROW_U: f64 = 1.0 / (1 << 12) as f64;

/// How far the end of the ray in the middle may be from the line between the edges' ends, pixels.
const MOST_SAG_PX: f64 = 0.2;

/// How far aside of the middle between the edges that ray may be: this part of the beam's width, and no less and no more than these
/// pixels. Light is spread evenly over a beam; with this its halves differ by 1 %. Of weak beams less is seen: what has a part of
/// its family's power may bend so much more, and be so much more uneven.
const MOST_BEND: f64 = 0.0025;
const BENDS_PX: [f64; 2] = [0.02, 0.2];

/// No beam may bend more than this, pixels.
const MOST_BEND_PX: f64 = 2.0;

/// How much power may differ between a beam's edges that is wider than two pixels, of all its family's power.
const MOST_FADE: f64 = 0.04;

/// Halvings of a beam for its form alone.
const MOST_HALVINGS: u32 = 10;

/// A circle round the picture, beyond which no ray is followed.
#[derive(Clone, Copy)]
pub(super) struct Horizon {
    center: DVec2,
    radius: f64,
}

impl Horizon {
    /// So wide that lines between the ends of two rays, as far as a right angle apart, do not cut the picture's corners.
    pub fn new(view: &View) -> Horizon {
        let size = DVec2::new(view.width as f64, view.height as f64) * view.mm_per_px;
        Horizon { center: view.origin_mm + size * 0.5, radius: 0.75 * size.length() }
    }

    /// Where a ray leaves it, or is nearest to its middle; where it begins if it goes away.
    fn end(&self, ray: &Ray) -> DVec2 {
        let to_middle = (self.center - ray.origin).dot(ray.direction);
        let aside = ray.at(to_middle).distance_squared(self.center);
        ray.at((to_middle + (self.radius * self.radius - aside).max(0.0).sqrt()).max(0.0))
    }
}

/// Whether a beam is what its edges say.
#[expect(clippy::large_enum_variant, reason = "it lives for a moment, and an allocation for each halving costs more")]
enum Form {
    Holds,
    /// It is not, and these are the rays in its middle.
    Bends {
        middle: Option<Side>,
    },
}

/// What a beam met before: which edge, and whether it went through.
#[derive(Clone, Copy)]
pub(super) struct Met {
    edge: EdgeId,
    through: bool,
}

/// One family's sweep onto a film.
pub(super) struct Sweep<'a, 'b> {
    pub tracer: &'b BeamTracer<'a>,
    pub family: &'b Family<'a>,
    pub media: Media,
    pub view: &'b View,
    pub film: &'b mut BeamFilm,
    /// Where rays that meet nothing end.
    pub horizon: Horizon,
    pub met: Vec<Met>,
    /// Pieces that may still be looked at.
    pub pieces_left: u64,
    /// Asked now and then whether to go on.
    pub goes_on: &'b (dyn Fn() -> bool + Sync),
}

/// From one question to the next whether to go on: pieces, some milliseconds.
const ASKED_EVERY: u64 = 1 << 10;

impl Sweep<'_, '_> {
    /// All beams of these; `false` if some were left out.
    pub fn run(&mut self, beams: std::ops::Range<u32>) -> bool {
        let count = f64::from(self.tracer.options.beams);
        for beam in beams {
            let u = [beam, beam + 1].map(|edge| f64::from(edge) / count);
            self.cell(Cell { u, v: [0.0, 1.0], part: 1.0, halved: 0, is_ray: false });
        }
        self.pieces_left > 0
    }

    /// A cell whose sides are not known yet.
    fn cell(&mut self, cell: Cell) {
        let [a, b] = cell.u.map(|u| self.again(u, cell.v));
        self.between(cell, a, b);
    }

    /// The beam between two sides; where only one is there, up to where it ends.
    fn between(&mut self, cell: Cell, a: Option<Side>, b: Option<Side>) {
        match (a, b) {
            (Some(a), Some(b)) => self.beam(cell, a, b),
            (None, None) => {}
            _ => self.halve(cell, a, b, 0),
        }
    }

    /// Both halves of a cell; `for_form` is 1 where its beam did not hold.
    fn halve(&mut self, cell: Cell, a: Option<Side>, b: Option<Side>, for_form: u32) {
        if cell.width() < NARROW_U && for_form == 0 && !cell.is_line() {
            return cell.across().into_iter().for_each(|cell| self.cell(cell));
        }
        if cell.width() < NARROWEST {
            return self.ray(cell);
        }
        let side = self.again(cell.middle(), cell.v);
        self.divide(Cell { halved: cell.halved + for_form, ..cell }, a, side, b);
    }

    /// Both halves of a cell, whose middle is known.
    fn divide(&mut self, cell: Cell, a: Option<Side>, middle: Option<Side>, b: Option<Side>) {
        let at = cell.middle();
        self.between(Cell { u: [cell.u[0], at], ..cell }, a, middle);
        self.between(Cell { u: [at, cell.u[1]], ..cell }, middle, b);
    }

    /// The ray in the middle of a cell, with all of its light.
    fn ray(&mut self, cell: Cell) {
        let v = [0.5 * (cell.v[0] + cell.v[1]); 2];
        if let Some(side) = self.again(cell.middle(), v) {
            self.beam(Cell { v, is_ray: true, ..cell }, side, side);
        }
    }

    /// The side at u after the same surfaces.
    fn again(&self, u: f64, v: [f64; 2]) -> Option<Side> {
        let mut side = self.tracer.start(self.family, self.media, u, v);
        for met in &self.met {
            for corner in &mut side {
                let contacts = self.tracer.surfaces.meet(&corner.ray, &corner.starts_on)?;
                if contacts.first().edge != met.edge {
                    return None;
                }
                *corner = corner.next(&self.tracer.surfaces, &contacts, met.through)?;
            }
        }
        Some(side)
    }

    fn beam(&mut self, cell: Cell, a: Side, b: Side) {
        let Some(left) = self.pieces_left.checked_sub(1) else { return };
        self.pieces_left = left;
        if left % ASKED_EVERY == 0 && !(self.goes_on)() {
            self.pieces_left = 0;
        }
        let corners = [a[0], b[0], a[1], b[1]];
        let contacts = corners.map(|corner| self.tracer.surfaces.meet(&corner.ray, &corner.starts_on));
        let edge = |at: usize| contacts[at].as_ref().map(|contacts| contacts.first().edge);
        if edge(0) != edge(1) || edge(2) != edge(3) {
            return self.halve(cell, Some(a), Some(b), 0);
        }
        if edge(0) != edge(2) {
            return cell.across().into_iter().for_each(|cell| self.cell(cell));
        }
        let piece = Piece {
            from: corners.map(|corner| corner.ray.origin),
            to: std::array::from_fn(|at| self.end(&corners[at].ray, contacts[at].as_ref())),
        };
        if !cell.is_ray
            && cell.halved < MOST_HALVINGS
            && let Form::Bends { middle } = self.form(&cell, &corners, &piece, edge(0))
        {
            return self.divide(Cell { halved: cell.halved + 1, ..cell }, Some(a), middle, Some(b));
        }
        self.splat(&cell, &corners, &piece);
        let [Some(c0), Some(c1), Some(c2), Some(c3)] = &contacts else { return };
        if self.met.len() >= self.tracer.options.most_surfaces as usize {
            return;
        }
        for through in [false, true] {
            let next = |corner: &Corner, contacts: &Contacts| corner.next(&self.tracer.surfaces, contacts, through);
            let side = |one: Option<Corner>, other: Option<Corner>| Some([one?, other?]);
            let a = side(next(&corners[0], c0), next(&corners[2], c2));
            let b = side(next(&corners[1], c1), next(&corners[3], c3));
            let sides = [a, b];
            let strengths = sides.iter().flatten().flatten().map(|corner| corner.power[0] + corner.power[1]);
            if strengths.fold(0.0, f64::max) < self.tracer.options.least_power {
                continue;
            }
            self.met.push(Met { edge: c0.first().edge, through });
            self.between(cell, a, b);
            self.met.pop();
        }
    }

    /// Where a ray ends that meets these, or nothing.
    fn end(&self, ray: &Ray, contacts: Option<&Contacts>) -> DVec2 {
        contacts.map_or_else(|| self.horizon.end(ray), |contacts| contacts.first().place)
    }

    /// Whether a beam is what its edges say: the ray in its middle goes where they have it, and they are as bright as each other.
    fn form(&self, cell: &Cell, corners: &[Corner; 4], piece: &Piece, edge: Option<EdgeId>) -> Form {
        let px = self.view.mm_per_px;
        let along = (piece.to[0] + piece.to[1] - piece.from[0] - piece.from[1]).normalize_or_zero();
        let widths = [&piece.from, &piece.to].map(|places| (places[1] - places[0]).perp_dot(along).abs());
        let widest = widths[0].max(widths[1]);
        if widest < 0.5 * px || !self.touches(piece) {
            return Form::Holds;
        }
        let middle = self.again(cell.middle(), cell.v);
        let bends = Form::Bends { middle };
        let Some([corner, _]) = middle else { return bends };
        let powers = [0, 1].map(|u| corners[u].power[0] + corners[u].power[1]);
        let strength = powers[0].max(powers[1]);
        let bend = MOST_BEND / strength;
        let [least, most] =
            [BENDS_PX[0] / strength, BENDS_PX[1] / strength.sqrt()].map(|bend| bend.min(MOST_BEND_PX) * px);
        if widest > 2.0 * px && (powers[0] - powers[1]).abs() > MOST_FADE {
            return bends;
        }
        let contacts = self.tracer.surfaces.meet(&corner.ray, &corner.starts_on);
        if contacts.as_ref().map(|contacts| contacts.first().edge) != edge {
            return bends;
        }
        let ends = [corner.ray.origin, self.end(&corner.ray, contacts.as_ref())];
        for ((end, places), width) in ends.into_iter().zip([&piece.from, &piece.to]).zip(widths) {
            let off = end - (places[0] + places[1]) * 0.5;
            // How far out a ray ends that meets nothing is nothing to see.
            let is_surface = edge.is_some() || places == &piece.from;
            if off.perp_dot(along).abs() > (bend * width).min(most).max(least)
                || is_surface && off.dot(along).abs() > MOST_SAG_PX * px
            {
                return bends;
            }
        }
        Form::Holds
    }

    /// Whether the piece may cross the picture.
    fn touches(&self, piece: &Piece) -> bool {
        let size = DVec2::new(self.view.width as f64, self.view.height as f64) * self.view.mm_per_px;
        let (min, max) = (self.view.origin_mm, self.view.origin_mm + size);
        let all = piece.from.iter().chain(&piece.to);
        let low = all.clone().fold(DVec2::INFINITY, |low, place| low.min(*place));
        let high = all.fold(DVec2::NEG_INFINITY, |high, place| high.max(*place));
        low.cmple(max).all() && high.cmpge(min).all()
    }

    fn splat(&mut self, cell: &Cell, corners: &[Corner; 4], piece: &Piece) {
        if !self.touches(piece) {
            return;
        }
        let part = 0.25 * corners.iter().map(|corner| corner.power[0] + corner.power[1]).sum::<f64>();
        let part = part * cell.width() * cell.part / self.tracer.brightest;
        let color = self.family.color.map(|channel| channel * part);
        let first = &corners[0];
        let absorption = first.media.absorption_per_mm(&self.tracer.surfaces, first.nm);
        let falloff = self.family.source.falloff;
        let length = piece.from[0].distance(piece.to[0]);
        let piece = piece.on_screen(self.view);
        if absorption == 0.0 && falloff == Falloff::Plane {
            return piece.splat(self.film, |_| color);
        }
        piece.splat(self.film, |gone| {
            let way = gone * length;
            let weight = falloff.weight(first.way + way) * libm::exp(-absorption * way);
            color.map(|channel| channel * weight)
        });
    }
}
