//! A tile in the light that no lamp above the floor gives: ambient light, emission, and glows.

use crate::Mask;
use crate::realtime::frame_context::FrameContext;
use crate::realtime::g_buffer::GBuffer;
use crate::shading::surface::{shade_floor_ambient, shade_top_ambient};
use crate::shading::top_layer::TopLayer;
use crate::tile::planes::{ALL_ROWS, BLACK, RgbTile, TILE};
use crate::tile::rect::TileRect;

/// The tile in ambient light, with the emission of its tops; `packed` is scratch.
pub(crate) fn shade_ambient(frame: &FrameContext, g_buffer: &GBuffer, packed: &mut RgbTile, out: &mut RgbTile) {
    let (simd, ambient) = (frame.simd, frame.scene.ambient);
    match g_buffer.packed_floor() {
        None => shade_floor_ambient(simd, TILE, &g_buffer.floor, ambient, out),
        Some(samples) => {
            *out = BLACK;
            shade_floor_ambient(simd, samples.blocks(), &g_buffer.floor, ambient, packed);
            samples.scatter(ALL_ROWS, packed, out);
        }
    }
    for TopLayer { slot, samples, surface, .. } in g_buffer.tops() {
        let finish = &frame.tops.top(*slot).finish;
        shade_top_ambient(simd, samples.blocks(), surface, finish, ambient, packed);
        samples.scatter(ALL_ROWS, packed, out);
    }
}

/// What of a glow's light passes the ink on it whatever the ink's colour.
const WHITE_SHARE: f32 = 0.15;

/// What passes in proportion to the ink's luminance.
const LUMINANCE_SHARE: f32 = 0.45;

/// What passes in the ink's own colour.
const ALBEDO_SHARE: f32 = 0.4;

/// Luminance of linear sRGB (ITU-R BT.709).
const LUMINANCE: [f32; 3] = [0.2126, 0.7152, 0.0722];

/// The tile in the light of one glow, of the colour white, that shines from below through the floor's albedo.
pub(crate) fn shade_glow(g_buffer: &GBuffer, rect: &TileRect, mask: &Mask, out: &mut RgbTile) {
    *out = BLACK;
    let albedo = g_buffer.floor_albedo();
    let &TileRect { x, y, .. } = rect;
    let columns = mask.x.max(x)..(mask.x + mask.width).min(x + TILE);
    let lines = mask.y.max(y)..(mask.y + mask.height()).min(y + TILE);
    for line in lines {
        for column in columns.clone() {
            let coverage = mask.coverage[(line - mask.y) * mask.width + column - mask.x];
            if coverage == 0 {
                continue;
            }
            let (row, i) = (line - y, column - x);
            let ink = [0, 1, 2].map(|channel: usize| albedo[channel][row][i]);
            let luminance = LUMINANCE[0] * ink[0] + LUMINANCE[1] * ink[1] + LUMINANCE[2] * ink[2];
            let strength = f32::from(coverage) * (1.0 / 255.0) * g_buffer.floor_weight[row][i];
            for channel in 0..3 {
                let through = WHITE_SHARE + LUMINANCE_SHARE * luminance + ALBEDO_SHARE * ink[channel];
                out[channel][row][i] = strength * through;
            }
        }
    }
}
