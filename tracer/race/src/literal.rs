//! The literal loops, as a textbook has them. Every other method is judged by this one.

use crate::scene::{COLORS, Disc, POWER, Scene, corner};

/// Makes the rows from `first_row` on.
pub(crate) fn render_band(scene: &Scene, first_row: usize, pixels: &mut [u32]) {
    for (row, pixels) in pixels.chunks_mut(scene.width).enumerate() {
        let y = scene.y(first_row + row);
        for (column, pixel) in pixels.iter_mut().enumerate() {
            *pixel = self::pixel(scene, scene.x(column), y);
        }
    }
}

/// One pixel, at (x, y) of the scene.
#[inline(always)]
pub(crate) fn pixel(scene: &Scene, x: f32, y: f32) -> u32 {
    let [red, green, blue] = light(scene, x, y).map(byte);
    red << 16 | green << 8 | blue
}

#[inline(always)]
fn light(scene: &Scene, x: f32, y: f32) -> [f32; 3] {
    let mut sum = [0.0; 3];
    for (lamp, color) in COLORS.iter().enumerate() {
        let (lx, ly) = corner(lamp);
        let (wx, wy) = (lx - x, ly - y);
        let mut lit = true;
        for disc in &scene.discs {
            if hides(disc, x, y, wx, wy) {
                lit = false;
                break;
            }
        }
        if lit {
            let falloff = POWER / (1.0 + wx * wx + wy * wy);
            for channel in 0..3 {
                sum[channel] += color[channel] * falloff;
            }
        }
    }
    sum
}

/// Whether the segment (wx, wy) from a point to a lamp meets a circle, or the point is in it.
#[inline(always)]
pub(crate) fn hides(disc: &Disc, x: f32, y: f32, wx: f32, wy: f32) -> bool {
    let (cx, cy) = (disc.x - x, disc.y - y);
    let along = (wx * cx + wy * cy) / (wx * wx + wy * wy);
    let nearest = along.clamp(0.0, 1.0);
    let (dx, dy) = (cx - wx * nearest, cy - wy * nearest);
    dx * dx + dy * dy < disc.square
}

fn byte(level: f32) -> u32 {
    (level.clamp(0.0, 1.0) * 255.0 + 0.5) as u32
}
