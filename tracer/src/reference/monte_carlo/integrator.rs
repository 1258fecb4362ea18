//! The Monte Carlo picture: a loop of its own over tiles and lamps, with shadow rays for visibility.
//!
//! Surfaces and what they make of irradiance are the realtime renderer's, so nothing but visibility differs from
//! [`crate::Renderer::render_uncached`].

use crate::realtime::direct_light::{LampOnTile, add};
use crate::realtime::exact_renderer::ExactRenderer;
use crate::realtime::frame_context::{ActiveLamp, FrameContext};
use crate::realtime::tile_renderer::TileRenderer;
use crate::reference::monte_carlo::Sampling;
use crate::reference::monte_carlo::rays::{Near, Rays};
use crate::simd::dispatch::LANES;
use crate::tile::packed_samples::PackedSamples;
use crate::tile::planes::{ALL_ROWS, BLACK, Plane, RgbTile, TILE};
use crate::tile::rect::TileRect;
use crate::{Group, Radiance, Rgb, Scene, SimdLevel};
use geometry::DVec2;
use geometry::rng::Key;

/// Renders `scene` with sampled shadows, on the threads of the current rayon pool: the same bits on any number.
pub(crate) fn render(scene: &Scene, sampling: Sampling, radiance: &mut Radiance) {
    let mut renderer = ExactRenderer::on(SimdLevel::best());
    renderer.render_with(scene, radiance, |tile, frame, rect, out| render_sampled(tile, frame, rect, sampling, out));
}

/// The tile under all lamps.
fn render_sampled(
    tile: &mut TileRenderer,
    frame: &FrameContext,
    rect: &TileRect,
    sampling: Sampling,
    out: &mut RgbTile,
) {
    tile.render_unlit(frame, rect, out);
    for lamp in frame.lamps.list.iter().filter(|active| rect.is_reached_by(&active.lamp)) {
        let mut sum = BLACK;
        light_sampled(tile, frame, lamp, rect, sampling, &mut sum);
        add(&sum, lamp.lamp.color, out);
    }
    tile.render_glows(frame, rect, out);
}

/// Adds the tile in the light of one lamp, of the colour white, to `sum`.
fn light_sampled(
    tile: &mut TileRenderer,
    frame: &FrameContext,
    lamp: &ActiveLamp,
    rect: &TileRect,
    sampling: Sampling,
    sum: &mut RgbTile,
) {
    let TileRenderer { g_buffer, light, scratch, .. } = tile;
    let on_tile = LampOnTile::new(frame, lamp, rect, g_buffer);
    let view = Look { sampling, frame, lamp, rect };
    if g_buffer.has_floor() {
        for (fraction, channels) in view.seen(g_buffer.floor_samples(frame), None).planes() {
            on_tile.light_floor(ALL_ROWS, light);
            light.visibility = *fraction;
            on_tile.apply_floor_visibility(ALL_ROWS, light);
            light.radiance = BLACK;
            let floor = [&light.irradiance, &light.specular];
            on_tile.shade_floor(ALL_ROWS, floor, &mut scratch.packed, &mut light.radiance);
            add(&light.radiance, channels, sum);
        }
    }
    for top in g_buffer.tops() {
        let own = frame.tops.top(top.slot).group;
        for (fraction, channels) in view.seen(&top.samples, Some(own)).planes() {
            light.radiance = BLACK;
            on_tile.light_top(top, ALL_ROWS, fraction, &mut scratch.packed, &mut light.radiance);
            add(&light.radiance, channels, sum);
        }
    }
}

/// The fraction of a lamp that each of some samples sees.
#[expect(
    clippy::large_enum_variant,
    reason = "lives on the stack for one surface of one tile; the reference may be slow"
)]
enum Seen {
    /// The same of every channel: nothing tinted is in the way.
    Grey(Plane),
    /// Of each channel.
    Tinted([Plane; 3]),
}

impl Seen {
    /// The planes, each with the channels that it counts for.
    fn planes(&self) -> impl Iterator<Item = (&Plane, Rgb)> {
        let (planes, channels) = match self {
            Seen::Grey(plane) => (std::slice::from_ref(plane), &[[1.0; 3]][..]),
            Seen::Tinted(planes) => (&planes[..], &[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]][..]),
        };
        planes.iter().zip(channels.iter().copied())
    }
}

/// One lamp, looked at from one tile.
struct Look<'a> {
    sampling: Sampling,
    frame: &'a FrameContext<'a>,
    lamp: &'a ActiveLamp,
    rect: &'a TileRect,
}

impl Look<'_> {
    /// The fraction of the lamp that some samples see, which are of the group `own`. Samples beyond the picture's edge see
    /// nothing: nobody looks at them.
    fn seen(&self, samples: &PackedSamples, own: Option<Group>) -> Seen {
        let (scene, lamp) = (self.frame.scene, &self.lamp.lamp);
        let of_lamp = Key::new(self.sampling.seed, 0).with_point(lamp.center_mm);
        let mut near = Near::default();
        let mut seen = [[[0.0; LANES]; TILE]; 3];
        let mut tinted = false;
        for sample in 0..samples.count {
            let pixel = usize::from(samples.pixel[sample]);
            let (x, y) = (self.rect.x + pixel % TILE, self.rect.y + pixel / TILE);
            if x >= scene.view.width || y >= scene.view.height {
                continue;
            }
            let (block, lane) = (sample / LANES, sample % LANES);
            let offset = DVec2::new(f64::from(samples.x[block][lane]), f64::from(samples.y[block][lane]));
            let key = of_lamp.with((y as u64) << 32 | x as u64);
            let rays = Rays { sampling: self.sampling, key, point: self.rect.middle_mm + offset };
            let arriving = rays.arriving(scene, lamp, own, &mut near);
            let open = rays.unoccluded_fraction(&scene.balls, lamp, own) as f32;
            tinted |= !near.panes.is_empty();
            for (plane, light) in seen.iter_mut().zip(arriving.seen) {
                plane[block][lane] = (light / arriving.all) as f32 * open;
            }
        }
        if tinted { Seen::Tinted(seen) } else { Seen::Grey(seen[0]) }
    }
}
