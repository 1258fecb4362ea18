//! Wood from numbers: boards side by side along the table, their seams, and a long fine grain in each.

use super::heights::Heights;
use super::noise;
use geometry::DVec2;
use rayon::prelude::*;
use tracer::View;

/// How many times longer than wide a board is.
const BOARD_LENGTH: f64 = 7.5;
/// How deep a seam is, mm, when it is as wide as it is meant to be.
const SEAM_MM: f64 = 0.1;
/// Half the width of a seam, mm.
const SEAM_HALF_MM: f64 = 0.45;
/// How far a board's edges lean outwards, as a slope: boards are slightly crowned.
const CROWN: f64 = 0.03;
/// How far boards lean to one side or the other.
const LEAN: f64 = 0.012;
/// Fibres: their width, mm, their length as a multiple of it, and how steep they are.
const FIBRES: [(f64, f64, f32); 4] = [(9.0, 26.0, 0.020), (3.4, 34.0, 0.030), (1.4, 40.0, 0.045), (0.6, 44.0, 0.05)];

/// The wood of a table at one resolution.
#[derive(Clone, Copy, Debug)]
pub(in crate::art) struct Wood {
    planks_mm: f64,
    grain: f32,
    mm_per_px: f64,
}

/// A place on a board.
struct Place {
    /// From the left edge of the board, mm.
    across: f64,
    /// From its upper end, mm.
    along: f64,
    length: f64,
    /// What is particular to this board.
    seed: i32,
}

impl Wood {
    /// Boards of this width, mm (0 for one piece), grained 0 to 1, as pixels of this size see it.
    pub fn new(planks_mm: f64, grain: f64, mm_per_px: f64) -> Wood {
        Wood { planks_mm, grain: grain as f32, mm_per_px }
    }

    /// The heights of grain and seams where `wooden` pixels need them.
    pub(super) fn heights(&self, view: &View, wooden: &[u8]) -> Heights {
        let rows = wooden.len() / view.width;
        let needed = |x: usize, y: usize| {
            let columns = x.saturating_sub(1)..(x + 2).min(view.width);
            (y.saturating_sub(1)..(y + 2).min(rows))
                .any(|y| wooden[y * view.width..][columns.clone()].iter().any(|&part| part > 0))
        };
        Heights::new(
            view.width,
            view.height,
            |x, y| {
                if needed(x, y) { self.height(view.table_from_pixel(x, y)) } else { 0.0 }
            },
        )
    }

    /// How far the board leans along x, mm a mm, at a place.
    pub(super) fn crown(&self, at_mm: DVec2) -> f32 {
        if self.planks_mm <= 0.0 {
            return 0.0;
        }
        let Place { across, seed, .. } = self.place(at_mm);
        let lean = f64::from(noise::unit(seed, 17) - 0.5) * 2.0 * LEAN;
        (lean - CROWN * (across / self.planks_mm - 0.5) * 2.0) as f32
    }

    /// The height, mm.
    fn height(&self, at_mm: DVec2) -> f32 {
        let place = self.place(at_mm);
        let mut height = 0.0;
        for (fibre, (width, weight)) in self.fibres(&place).into_iter().zip(FIBRES.map(|fibre| (fibre.0, fibre.2))) {
            height += self.grain * weight * width as f32 * (fibre - 0.5);
        }
        height - self.seam(&place) * SEAM_MM as f32
    }

    /// How much brighter the wood is here than on average, as a factor: each board has its tone, each fibre its own, and
    /// seams are dark.
    fn tone(&self, at_mm: DVec2) -> f32 {
        let place = self.place(at_mm);
        let [broad, middle, fine, pore] = self.fibres(&place);
        let board = if self.planks_mm > 0.0 { noise::unit(place.seed, 3) - 0.5 } else { 0.0 };
        let rings = 0.55 * (broad - 0.5) + 0.55 * (middle - 0.5) + 0.35 * (fine - 0.5) + 0.2 * (pore - 0.5);
        let grain = 1.0 + self.grain * (rings + 0.3 * board);
        grain * (1.0 - 0.6 * self.seam(&place))
    }

    /// How far into a seam a place is, 0 to 1.
    fn seam(&self, place: &Place) -> f32 {
        if self.planks_mm <= 0.0 {
            return 0.0;
        }
        let from_end = place.along.min(place.length - place.along);
        let from_side = place.across.min(self.planks_mm - place.across);
        // A seam finer than a pixel is as wide as one and less deep.
        let half = SEAM_HALF_MM.max(0.8 * self.mm_per_px);
        let inside = (1.0 - from_side.min(from_end) / half).max(0.0);
        (inside * SEAM_HALF_MM / half) as f32
    }

    fn fibres(&self, place: &Place) -> [f32; 4] {
        // The grain wanders as the tree did.
        let bend = f64::from(noise::smooth(place.across / 34.0, place.along / 190.0, place.seed ^ 0x51)) * 16.0;
        let mut layer = 0;
        FIBRES.map(|(width, length, _)| {
            layer += 1;
            let seen = ((width / self.mm_per_px - 0.8) / 0.8).clamp(0.0, 1.0) as f32;
            if seen <= 0.0 {
                return 0.5;
            }
            let across = (place.across + bend) / width;
            let fibre = noise::smooth(across, place.along / (width * length), place.seed.wrapping_add(layer * 7919));
            0.5 + (fibre - 0.5) * seen
        })
    }

    fn place(&self, at_mm: DVec2) -> Place {
        if self.planks_mm <= 0.0 {
            return Place { across: at_mm.x, along: at_mm.y, length: f64::INFINITY, seed: 1 };
        }
        let board = (at_mm.x / self.planks_mm).floor();
        let length = self.planks_mm * BOARD_LENGTH;
        // The joints of neighbours are far from each other.
        let y = at_mm.y / length + 0.382 * board + 0.2 * f64::from(noise::unit(board as i32, 29));
        let row = y.floor();
        Place {
            across: at_mm.x - board * self.planks_mm,
            along: (y - row) * length,
            length,
            seed: noise::hash(board as i32, row as i32) as i32 & 0x00ff_ffff,
        }
    }

    /// Stains the `wooden` part of what is printed on `pixels`.
    pub fn stain(&self, view: &View, wooden: &[u8], pixels: &mut [[u8; 4]]) {
        let rows = pixels.par_chunks_mut(view.width).zip(wooden.par_chunks(view.width)).enumerate();
        rows.for_each(|(y, (row, wooden))| {
            for (x, (pixel, &part)) in row.iter_mut().zip(wooden).enumerate().filter(|(_, (_, part))| **part > 0) {
                let tone = self.tone(view.table_from_pixel(x, y)) - 1.0;
                let tone = 1.0 + f32::from(part) / 255.0 * tone;
                let alpha = f32::from(pixel[3]);
                for channel in &mut pixel[..3] {
                    *channel = (f32::from(*channel) * tone + 0.5).clamp(0.0, alpha) as u8;
                }
            }
        });
    }
}
