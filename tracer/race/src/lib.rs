//! The classic race: a room, a lamp in each corner, three circles that move, everything lit anew for each picture.
//!
//! The room is 5 x 5, the circles have radius 1 and never overlap, and a pixel's light is `0.9 / (1 + d^2)` from each
//! lamp that no circle hides, each lamp in its own colour. The same picture is made in several ways, from literal loops
//! to whole runs of pixels. Each of them sums red, green and blue as floats and then rounds them to a 32-bit pixel, and
//! none keeps anything from the picture before. This module knows nothing of the table's light, and lends it nothing.

mod columns;
mod lane_wise;
mod literal;
mod moment;
mod run;
mod scene;
mod shadows;
mod spans;

pub use moment::{SIDE, circles};
pub use scene::room;

use columns::Block;
use moment::Moment;
use rayon::prelude::*;
use tracer::{Frame, SimdLevel};

/// Rows that one task makes when all threads work.
const ROWS: usize = 24;

/// The ways to make the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// For each pixel, for each lamp, for each circle: does it hide the lamp?
    Literal,
    /// The same question, asked for 16 pixels at a time.
    LaneWise,
    /// A circle's shadow on a row of pixels is one interval, so nothing is asked pixel by pixel.
    Spans,
    /// Sets the same bytes to zero and computes nothing: what no other way can beat.
    Fill,
}

impl Way {
    /// Every way, the slowest first.
    pub const ALL: [Way; 4] = [Way::Literal, Way::LaneWise, Way::Spans, Way::Fill];

    /// A name for tables.
    pub fn name(self) -> &'static str {
        match self {
            Way::Literal => "literal loops",
            Way::LaneWise => "SIMD, 16 pixels at a time",
            Way::Spans => "spans on each scanline",
            Way::Fill => "memset of the same bytes",
        }
    }
}

/// Who makes the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Threads {
    /// The thread that asks for it.
    One,
    /// All of the current rayon pool.
    All,
}

/// What makes pictures of the room: keep one, and it allocates only when a picture is wider than all before.
#[derive(Clone, Debug)]
pub struct Room {
    path: SimdLevel,
    blocks: Vec<Block>,
}

impl Default for Room {
    fn default() -> Room {
        Room::on(SimdLevel::best())
    }
}

impl Room {
    /// One that uses this instruction set; the bits do not depend on it.
    pub fn on(path: SimdLevel) -> Room {
        Room { path, blocks: Vec::new() }
    }

    /// Makes the picture of a moment, as wide and as high as `frame` is.
    pub fn render(&mut self, way: Way, threads: Threads, seconds: f64, frame: &mut Frame) {
        let (width, height) = (frame.width, frame.height);
        frame.pixels.resize(width * height, 0);
        if width == 0 || height == 0 {
            return;
        }
        let moment = Moment::new(seconds, width, height);
        if way == Way::Spans {
            columns::fill(&mut self.blocks, &moment);
        }
        let (path, blocks) = (self.path, &self.blocks);
        let band = |first_row: usize, pixels: &mut [u32]| match way {
            Way::Literal => literal::band(&moment, first_row, pixels),
            Way::LaneWise => lane_wise::band(path, &moment, first_row, pixels),
            Way::Spans => spans::band(path, &moment, blocks, first_row, pixels),
            Way::Fill => pixels.fill(0),
        };
        match threads {
            Threads::One => band(0, &mut frame.pixels),
            Threads::All => {
                let bands = frame.pixels.par_chunks_mut(width * ROWS).enumerate().with_max_len(1);
                bands.for_each(|(number, pixels)| band(number * ROWS, pixels));
            }
        }
    }
}
