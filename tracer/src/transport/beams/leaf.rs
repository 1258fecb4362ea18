//! A leaf: a beam that holds, and its light on the film.

use super::beam::Piece;
use super::cell::{Cell, mean_place};
use super::corner::Probe;
use super::form::strength_of;
use super::sweep::Sweep;
use crate::transport::Falloff;
use geometry::DVec2;

/// A beam that holds.
pub(super) struct Leaf {
    pub cell: Cell,
    pub probes: [Probe; 4],
    piece: Piece,
    /// What of its light has come as far.
    strength: f64,
    /// The way of its light to where it begins, mm, the mean over its rays.
    come: f64,
}

/// Of how far the ray in the middle of a cell is off the mean of its corners, what the mean over the cell is off them, by Simpson's rule.
const OFF_IN_THE_MEAN: f64 = 2.0 / 3.0;

impl Sweep<'_, '_> {
    /// A beam that holds: it begins and ends where its rays do in the mean. Where its ends are curved a straight line between those of
    /// its corners would leave out what lies beyond.
    pub(super) fn leaf(&self, cell: &Cell, probes: &[Probe; 4], middle: Option<&Probe>, mut piece: Piece) -> Leaf {
        let along = (mean_place(&piece.to) - mean_place(&piece.from)).normalize_or_zero();
        let beyond = |place: DVec2, corners: &[DVec2; 4]| (place - mean_place(corners)).dot(along) * OFF_IN_THE_MEAN;
        let mut come = 0.25 * probes.iter().map(|probe| probe.corner.way).sum::<f64>();
        // The form of a source is another matter, and where light goes that meets nothing is nothing to see.
        if let Some(middle) = middle.filter(|_| !self.met.is_empty()) {
            let begins = beyond(middle.corner.ray.origin, &piece.from);
            piece.from = piece.from.map(|place| place + along * begins);
            come += begins;
        }
        if let Some(middle) = middle.filter(|middle| middle.edge.is_some()) {
            let ends = beyond(middle.end, &piece.to);
            piece.to = piece.to.map(|place| place + along * ends);
        }
        Leaf { cell: *cell, probes: *probes, piece, strength: strength_of(probes, middle), come }
    }

    /// Whether the piece may cross the picture.
    pub(super) fn touches(&self, piece: &Piece) -> bool {
        let size = DVec2::new(self.view.width as f64, self.view.height as f64) * self.view.mm_per_px;
        let (min, max) = (self.view.origin_mm, self.view.origin_mm + size);
        let all = piece.from.iter().chain(&piece.to);
        let low = all.clone().fold(DVec2::INFINITY, |low, place| low.min(*place));
        let high = all.fold(DVec2::NEG_INFINITY, |high, place| high.max(*place));
        low.cmple(max).all() && high.cmpge(min).all()
    }

    /// Lays a leaf's light on the film.
    pub(super) fn splat(&mut self, Leaf { cell, probes, piece, strength, come }: &Leaf) {
        if !self.touches(piece) {
            return;
        }
        let light = strength * cell.light / self.most;
        let first = &probes[0].corner;
        let absorption = first.media.absorption_per_mm(&self.tracer.surfaces, first.nm);
        let falloff = self.family.source.falloff;
        let length = 0.25 * piece.from.iter().zip(&piece.to).map(|(from, to)| from.distance(*to)).sum::<f64>();
        let bulge = if self.met.is_empty() { self.family.bulge(cell.v) } else { None };
        let piece = Piece { bulge, ..*piece }.on_screen(self.view);
        if absorption == 0.0 && falloff == Falloff::Plane {
            return piece.splat(self.film, |_| light);
        }
        piece.splat(self.film, |gone| {
            let way = gone * length;
            light * falloff.weight(come + way) * libm::exp(-absorption * way)
        });
    }
}
