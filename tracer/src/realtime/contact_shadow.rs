//! Contact shadows: a ball hides a part of the sky from the floor near it, so ambient light is darker there.

use crate::Ball;
use crate::cache::damage::contact_mm;
use crate::realtime::frame_context::FrameContext;
use crate::simd::dispatch::{LANES, max, multiversion};
use crate::tile::packed_samples::PackedSamples;
use crate::tile::planes::{RgbTile, TILE};
use crate::tile::rect::TileRect;

/// Of the sky that a ball hides, how much is dark: what the ball mirrors lights the floor a little.
const DARKNESS: f32 = 0.9;

/// Whether a ball is so near that it darkens the tile.
pub(crate) fn has_contacts(frame: &FrameContext, rect: &TileRect) -> bool {
    frame.scene.balls.iter().any(|ball| touches(ball, rect))
}

/// Darkens `out` where a ball hides the sky: a sphere, seen from the floor, hides the part `(r / s)^2 cos`, s being the
/// distance of its middle.
pub(crate) fn shade_contacts(frame: &FrameContext, rect: &TileRect, out: &mut RgbTile) {
    for ball in frame.scene.balls.iter().filter(|ball| touches(ball, rect)) {
        let from_tile = ball.center_mm - rect.middle_mm;
        let middle = [from_tile.x as f32, from_tile.y as f32, (ball.radius_mm + ball.lift_mm()) as f32];
        shade_contact(frame.simd, frame.full_tile, middle, ball.radius_mm as f32, out);
    }
}

fn touches(ball: &Ball, rect: &TileRect) -> bool {
    let reach = contact_mm(ball) + rect.radius_mm;
    ball.center_mm.distance_squared(rect.middle_mm) < reach * reach
}

multiversion! {
    fn shade_contact(pixels: &PackedSamples, middle: [f32; 3], radius: f32, out: &mut RgbTile) = shade_contact_lanes;
}

#[inline(always)]
fn shade_contact_lanes(pixels: &PackedSamples, [bx, by, bz]: [f32; 3], radius: f32, out: &mut RgbTile) {
    let [red, green, blue] = out;
    for row in 0..TILE {
        for i in 0..LANES {
            let (dx, dy) = (pixels.x[row][i] - bx, pixels.y[row][i] - by);
            let square = max(dx * dx + dy * dy + bz * bz, 1e-6);
            let hidden = radius * radius * bz / (square * square.sqrt());
            let open = 1.0 - DARKNESS * hidden;
            red[row][i] *= open;
            green[row][i] *= open;
            blue[row][i] *= open;
        }
    }
}
