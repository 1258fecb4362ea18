//! The room that the machine stands in, as polished things mirror it: night, a ceiling, one soft panel overhead, the
//! machine's own display at the far end, and its walls. Nothing on the table is lit by it.

use crate::Rgb;
use crate::simd::dispatch::{clamp, max};

/// The ceiling.
const CEILING: Rgb = [0.150, 0.162, 0.205];

/// The cabinet's walls, near the horizon.
const WALL: Rgb = [0.022, 0.022, 0.030];

/// The soft panel overhead.
const PANEL: Rgb = [2.10, 2.05, 1.95];

/// The display beyond the table's far end.
const DISPLAY: Rgb = [1.25, 0.72, 0.26];

/// What is seen in a direction (x to the right, y towards the player, z up); below the horizon the walls go on. `bounce`
/// is what the walls throw back of the table's light.
#[inline(always)]
pub(crate) fn radiance(out: [f32; 3], bounce: Rgb) -> Rgb {
    let up = max(out[2], 0.02);
    let (x, y) = (out[0] / up, out[1] / up);
    let panel = (1.0 - soft(x.abs(), 0.30, 0.75)) * (1.0 - soft((y + 0.55).abs(), 0.20, 0.55));
    let glow = 1.0 / (1.0 + 0.9 * (x * x + (y + 0.55) * (y + 0.55)));
    let display = (1.0 - soft((x).abs(), 0.9, 1.7)) * (1.0 - soft((y + 2.6).abs(), 0.35, 0.9));
    let visible = if out[2] > 0.02 { 1.0 } else { 0.0 };
    let open = soft(out[2], 0.10, 0.42);
    let low = 1.0 - soft(out[2], 0.0, 0.30);
    let light = |channel: usize| {
        let ceiling = CEILING[channel] * (0.45 + 0.9 * max(out[2], 0.0));
        let room = WALL[channel] + (ceiling - WALL[channel]) * open + bounce[channel] * low;
        room + visible * (PANEL[channel] * (0.95 * panel + 0.10 * glow * open) + DISPLAY[channel] * display)
    };
    [light(0), light(1), light(2)]
}

/// From 0 at `from` to 1 at `to`, smooth at both ends.
#[inline(always)]
fn soft(v: f32, from: f32, to: f32) -> f32 {
    let t = clamp((v - from) / (to - from), 0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}
