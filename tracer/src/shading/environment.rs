//! The environment: what polished surfaces mirror of the room around the machine. An analytic environment map: night, a
//! ceiling, one soft panel overhead, the machine's own display beyond the far end, and the cabinet's walls. It lights
//! nothing.
//!
//! Directions above the horizon are projected on the plane z = 1 (gnomonic projection), where the panel and the display
//! are rectangles with soft edges. All numbers here are art direction: chosen by eye, in linear light and in units of
//! z.

use crate::Rgb;
use crate::simd::dispatch::{clamp, max};

/// The radiance of the ceiling.
const CEILING: Rgb = [0.150, 0.162, 0.205];

/// How bright the ceiling is at the horizon, and how much brighter straight above.
const CEILING_GRADIENT: [f32; 2] = [0.45, 0.9];

/// The radiance of the cabinet's walls, near the horizon.
const WALL: Rgb = [0.022, 0.022, 0.030];

/// The sines of elevation between which the walls give way to the ceiling.
const WALL_ENDS: [f32; 2] = [0.10, 0.42];

/// The sines of elevation between which the light that the walls throw back ends.
const BOUNCE_ENDS: [f32; 2] = [0.0, 0.30];

/// The radiance of the soft panel overhead.
const PANEL: Rgb = [2.10, 2.05, 1.95];

/// Where the panel is: a little towards the far end.
const PANEL_AREA: SoftRectangle = SoftRectangle { center_y: -0.55, full: [0.30, 0.20], none: [0.75, 0.55] };

/// How much of the panel's radiance is in the panel itself and in its glow on the ceiling.
const PANEL_PARTS: [f32; 2] = [0.95, 0.10];

/// How fast the glow ends: it is half as bright where the square of the distance is one over this.
const GLOW_FALLOFF: f32 = 0.9;

/// The radiance of the display beyond the table's far end.
const DISPLAY: Rgb = [1.25, 0.72, 0.26];

/// Where the display is: low over the far end.
const DISPLAY_AREA: SoftRectangle = SoftRectangle { center_y: -2.6, full: [0.9, 0.35], none: [1.7, 0.9] };

/// The least sine of elevation: nothing overhead is seen below it, and the projection stays finite.
pub(crate) const HORIZON: f32 = 0.02;

/// A rectangle in the plane z = 1, centred at x = 0, whose edges fade from half extents `full` to `none`.
struct SoftRectangle {
    center_y: f32,
    full: [f32; 2],
    none: [f32; 2],
}

impl SoftRectangle {
    #[inline(always)]
    fn coverage(&self, x: f32, y: f32) -> f32 {
        (1.0 - smoothstep(x.abs(), self.full[0], self.none[0]))
            * (1.0 - smoothstep((y - self.center_y).abs(), self.full[1], self.none[1]))
    }
}

/// The radiance from a direction (x to the right, y towards the player, z up); below the horizon the walls go on.
/// `bounce` is what the walls throw back of the table's light.
#[inline(always)]
pub(crate) fn radiance(out: [f32; 3], bounce: Rgb) -> Rgb {
    let up = max(out[2], HORIZON);
    let (x, y) = (out[0] / up, out[1] / up);
    let panel = PANEL_AREA.coverage(x, y);
    let panel_y = y - PANEL_AREA.center_y;
    let glow = 1.0 / (1.0 + GLOW_FALLOFF * (x * x + panel_y * panel_y));
    let display = DISPLAY_AREA.coverage(x, y);
    let overhead = if out[2] > HORIZON { 1.0 } else { 0.0 };
    let open = smoothstep(out[2], WALL_ENDS[0], WALL_ENDS[1]);
    let low = 1.0 - smoothstep(out[2], BOUNCE_ENDS[0], BOUNCE_ENDS[1]);
    let light = |channel: usize| {
        let ceiling = CEILING[channel] * (CEILING_GRADIENT[0] + CEILING_GRADIENT[1] * max(out[2], 0.0));
        let room = WALL[channel] + (ceiling - WALL[channel]) * open + bounce[channel] * low;
        let panel = PANEL[channel] * (PANEL_PARTS[0] * panel + PANEL_PARTS[1] * glow * open);
        room + overhead * (panel + DISPLAY[channel] * display)
    };
    [light(0), light(1), light(2)]
}

/// The smoothstep of the shading languages: 0 at `from`, 1 at `to`, level at both ends.
#[inline(always)]
fn smoothstep(v: f32, from: f32, to: f32) -> f32 {
    let t = clamp((v - from) / (to - from), 0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}
