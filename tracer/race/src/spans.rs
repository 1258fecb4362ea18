//! Spans: a row of pixels is cut where shadows begin and end, and each span is shaded as a whole.

use crate::column_terms::ColumnTerms;
use crate::scene::Scene;
use crate::shadow_edges::{ShadowEdges, SortedEdges};
use crate::span_shading::{RowTerms, shade_span};
use tracer::simd::dispatch::multiversion;

/// The bits of all four lamps.
const ALL: usize = 0b1111;

multiversion! {
    /// Makes the rows from `first_row` on.
    pub(crate) fn render_band(scene: &Scene, blocks: &[ColumnTerms], first_row: usize, pixels: &mut [u32]) = render_band_lanes;
}

#[inline(always)]
fn render_band_lanes(scene: &Scene, blocks: &[ColumnTerms], first_row: usize, pixels: &mut [u32]) {
    let shadows = ShadowEdges::new(scene);
    for row in 0..pixels.len() / scene.width {
        let y = scene.y(first_row + row);
        let edges = SortedEdges::new(&shadows.on_row(scene, y));
        let pixels = &mut pixels[row * scene.width..];
        let row = RowTerms::new(y);
        // How many shadows of each lamp cover the span, the lamps that reach it, and where it begins.
        let (mut shades, mut lit, mut start) = ([0u8; 4], ALL, 0);
        for (column, lamp, ends) in edges.iter() {
            shades[lamp] = if ends { shades[lamp] - 1 } else { shades[lamp] + 1 };
            let now = if shades[lamp] == 0 { lit | 1 << lamp } else { lit & !(1 << lamp) };
            if now != lit {
                shade_span(lit, &row, blocks, start, column, pixels);
                (lit, start) = (now, column);
            }
        }
        shade_span(lit, &row, blocks, start, scene.width, pixels);
    }
}
