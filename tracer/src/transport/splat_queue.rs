//! Light that waits for its place on the film.
//!
//! Ways of packets go all over the picture, and nearly every pixel of one is a miss of the processor's cache: five sixths of the
//! time of a splat were that. So ways wait until there are many, and are laid neighbourhood by neighbourhood. The film's sums
//! are whole numbers: they are the same in any order.

use super::film::SplatFilm;
use super::pixel_walk::{PixelSegment, PixelWalk};

/// A piece of a way and the colour of its light.
type Splat = (PixelWalk, [f32; 3]);

/// A neighbourhood's side, pixels: with those beside it, into which pieces reach, it fits into the cache of a core.
const SIDE: usize = 64;

/// Pieces that wait at most: 88 bytes each.
const MOST_WAITING: usize = 1 << 15;

/// Pieces of ways that wait, by the neighbourhood of their middles.
#[derive(Clone, Debug)]
pub struct SplatQueue {
    across: usize,
    down: usize,
    waiting: Vec<Vec<Splat>>,
    count: usize,
}

impl SplatQueue {
    /// An empty queue for a film.
    pub fn new(film: &SplatFilm) -> SplatQueue {
        let (across, down) = (film.width().div_ceil(SIDE), film.height().div_ceil(SIDE));
        SplatQueue { across, down, waiting: vec![Vec::new(); across * down], count: 0 }
    }

    /// As [`SplatFilm::splat`], now or later.
    pub fn splat(&mut self, segment: &PixelSegment, color: [f32; 3], film: &mut SplatFilm) {
        let mut rest = film.walk(segment);
        while let Some(walk) = rest {
            let (piece, more) = walk.cut(SIDE);
            rest = more;
            self.push(piece, color);
        }
        if self.count >= MOST_WAITING {
            self.flush(film);
        }
    }

    fn push(&mut self, piece: PixelWalk, color: [f32; 3]) {
        let [column, row] = piece.middle().map(|place| place / SIDE);
        let rows = if piece.axis == 0 { self.down } else { self.across };
        let row = row.min(rows - 1);
        let row = if piece.mirrored { rows - 1 - row } else { row };
        let [x, y] = if piece.axis == 0 { [column, row] } else { [row, column] };
        // There and back again: the next neighbourhood is beside the last one.
        let x = if y.is_multiple_of(2) { x } else { self.across - 1 - x };
        self.waiting[y * self.across + x].push((piece, color));
        self.count += 1;
    }

    /// Lays all that waits.
    pub fn flush(&mut self, film: &mut SplatFilm) {
        for waiting in &mut self.waiting {
            waiting.drain(..).for_each(|(piece, color)| film.splat_walk(&piece, color));
        }
        self.count = 0;
    }
}

#[cfg(test)]
mod tests {
    use super::super::film::PACKET_BITS;
    use super::*;
    use crate::View;
    use geometry::DVec2;
    use geometry::rng::SplitMix64;

    /// A film has the same bits whether its ways have waited or not; those outside of the picture and without an end leave
    /// nothing.
    #[test]
    fn waiting_changes_nothing() {
        let view = View { width: 150, height: 200, origin_mm: DVec2::ZERO, mm_per_px: 1.0 };
        let (mut direct, mut later) = (SplatFilm::new(&view, PACKET_BITS), SplatFilm::new(&view, PACKET_BITS));
        let mut queue = SplatQueue::new(&later);
        let mut random = SplitMix64::new(2);
        for turn in 0..MOST_WAITING + 5_000 {
            let mut point = || DVec2::new(random.uniform(-90.0, 240.0), random.uniform(-90.0, 290.0));
            let (from, mut to) = (point(), point());
            if turn % 1_000 == 0 {
                to *= f64::NAN;
            }
            let color = [random.unit() as f32, -0.1, 3.0];
            direct.splat(&PixelSegment { from, to }, color);
            queue.splat(&PixelSegment { from, to }, color, &mut later);
        }
        assert!(direct != later, "the last ones wait");
        queue.flush(&mut later);
        assert!(direct == later);
    }
}
