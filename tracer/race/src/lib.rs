//! The shadow race: a well-known exercise in fast 2D shadows, solved in several ways and to the same picture.
//!
//! The scene is 5 x 5 with a point lamp in each corner and three moving circles of radius 1 that never overlap. A
//! pixel's light is `0.9 / (1 + d^2)` from each lamp that no circle hides, each lamp in its own colour. [`Method`]
//! names the ways to render it, from literal loops to spans of pixels. Each of them sums red, green and blue as floats
//! and then rounds them to a 32-bit pixel, and none keeps anything from the frame before.
//!
//! The race shares the crate `tracer`'s frames and its SIMD dispatch, and none of its light. [`tracer_scene`] gives the
//! same scene to the tracer, with lamps of a size.

#![allow(clippy::needless_range_loop, reason = "lanes and channels run in step through several arrays")]

mod column_terms;
mod literal;
mod scene;
mod shadow_edges;
mod simd;
mod span_shading;
mod spans;
mod tracer_scene;

pub use scene::{SIDE, circles};
pub use tracer_scene::tracer_scene;

use column_terms::ColumnTerms;
use rayon::prelude::*;
use scene::Scene;
use tracer::{Frame, SimdLevel};

/// Rows that one task renders when all threads work.
const ROWS: usize = 24;

/// The ways to render the scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// For each pixel, for each lamp, for each circle: does it hide the lamp?
    Literal,
    /// The same question, asked for 16 pixels at a time.
    Simd,
    /// A circle's shadow on a row of pixels is one interval, so nothing is asked pixel by pixel.
    Spans,
    /// Sets the same bytes to zero and computes nothing: the lower bound.
    Memset,
}

impl Method {
    /// Every method, the slowest first.
    pub const ALL: [Method; 4] = [Method::Literal, Method::Simd, Method::Spans, Method::Memset];

    /// A name for tables.
    pub fn name(self) -> &'static str {
        match self {
            Method::Literal => "literal loops",
            Method::Simd => "SIMD, 16 pixels at a time",
            Method::Spans => "spans on each scanline",
            Method::Memset => "memset of the same bytes",
        }
    }
}

/// Who renders.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Threads {
    /// The calling thread.
    One,
    /// All of the current rayon pool.
    All,
}

/// Renders the scene. Keep one: it allocates only when a frame is wider than all before.
#[derive(Clone, Debug)]
pub struct RaceRenderer {
    level: SimdLevel,
    columns: Vec<ColumnTerms>,
}

impl Default for RaceRenderer {
    fn default() -> RaceRenderer {
        RaceRenderer::on(SimdLevel::best())
    }
}

impl RaceRenderer {
    /// A renderer that uses this instruction set; the bits do not depend on it.
    pub fn on(level: SimdLevel) -> RaceRenderer {
        RaceRenderer { level, columns: Vec::new() }
    }

    /// Renders the scene after `seconds`, as wide and as high as `frame` is.
    pub fn render(&mut self, method: Method, threads: Threads, seconds: f64, frame: &mut Frame) {
        let (width, height) = (frame.width, frame.height);
        frame.pixels.resize(width * height, 0);
        if width == 0 || height == 0 {
            return;
        }
        let scene = Scene::new(seconds, width, height);
        if method == Method::Spans {
            column_terms::fill(&mut self.columns, &scene);
        }
        let (level, columns) = (self.level, &self.columns);
        let band = |first_row: usize, pixels: &mut [u32]| match method {
            Method::Literal => literal::render_band(&scene, first_row, pixels),
            Method::Simd => simd::render_band(level, &scene, first_row, pixels),
            Method::Spans => spans::render_band(level, &scene, columns, first_row, pixels),
            Method::Memset => pixels.fill(0),
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
