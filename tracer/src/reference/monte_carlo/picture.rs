//! The Monte Carlo picture: a loop of its own over tiles and lamps, with shadow rays for visibility.
//!
//! Surfaces and what they make of irradiance are the realtime renderer's, so nothing but visibility differs from
//! [`crate::Renderer::render_anew`].

use crate::realtime::direct_light::add;
use crate::realtime::exact_renderer::{ExactRenderer, drawable};
use crate::realtime::tile_renderer::{Lit, Stage, Workspace};
use crate::reference::monte_carlo::Sampling;
use crate::reference::monte_carlo::rays::{Near, Rays};
use crate::scene::validation::CheckScratch;
use crate::shading::falloff::Falloff;
use crate::simd::dispatch::LANES;
use crate::tile::packed_samples::PackedSamples;
use crate::tile::planes::{ALL_ROWS, BLACK, Plane, TILE};
use crate::tile::rect::TileRect;
use crate::visibility::blockers::VisibilityClass;
use crate::{Group, Radiance, Rgb, Scene, SimdLevel};
use geometry::DVec2;
use geometry::rng::Key;

/// Renders `scene` with sampled shadows, on the threads of the current rayon pool: the same bits on any number.
pub(crate) fn render(scene: &Scene, sampling: Sampling, radiance: &mut Radiance) {
    let Some(scene) = &drawable(scene, &mut CheckScratch::default()) else { return radiance.resize(0, 0) };
    let mut renderer = ExactRenderer::on(SimdLevel::best());
    renderer.prepare(scene, false);
    renderer.render_tiles(scene, radiance, |tile, stage, rect| tile.render_sampled(stage, rect, sampling));
    renderer.put_balls_on(scene, radiance);
}

/// The fraction of a lamp that each of some points sees.
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

impl Workspace {
    /// Makes the tile under all lamps, in [`Workspace::out`].
    fn render_sampled(&mut self, stage: &Stage, place: &TileRect, sampling: Sampling) {
        let layers = self.render_unlit(stage, place);
        for lit in stage.lamps.iter().filter(|lit| place.is_reached_by(&lit.lamp)) {
            self.light_sampled(stage, lit, place, layers, sampling);
            add(&self.sum, lit.lamp.color, &mut self.out);
        }
        self.render_glows(stage, place);
    }

    /// Puts the tile in the light of one lamp, of the colour white, into [`Workspace::sum`].
    fn light_sampled(&mut self, stage: &Stage, lit: &Lit, place: &TileRect, layers: usize, sampling: Sampling) {
        self.sum = BLACK;
        let beam = Falloff::new(&lit.lamp, place.middle_mm);
        let view = Look { sampling, stage, lit, place };
        if self.whole || self.floor.count > 0 {
            let points = if self.whole { stage.full_tile } else { &self.floor };
            for (fraction, channels) in view.seen(points, None).planes() {
                self.light_floor(stage, beam, ALL_ROWS);
                self.fraction = *fraction;
                self.veil(stage.simd, VisibilityClass::Partial, ALL_ROWS);
                self.picture = BLACK;
                self.paint(stage.simd, ALL_ROWS);
                add(&self.picture, channels, &mut self.sum);
            }
        }
        for layer in 0..layers {
            let own = stage.tops.top(self.tops[layer].form).group;
            for (fraction, channels) in view.seen(&self.tops[layer].points, Some(own)).planes() {
                self.fraction = *fraction;
                self.picture = BLACK;
                self.light_top(stage, beam, layer, ALL_ROWS, VisibilityClass::Partial);
                add(&self.picture, channels, &mut self.sum);
            }
        }
    }
}

/// One lamp, looked at from one tile.
struct Look<'a> {
    sampling: Sampling,
    stage: &'a Stage<'a>,
    lit: &'a Lit,
    place: &'a TileRect,
}

impl Look<'_> {
    /// The fraction of the lamp that some points see, which are of the group `own`. Points beyond the picture's edge see
    /// nothing: nobody looks at them.
    fn seen(&self, points: &PackedSamples, own: Option<Group>) -> Seen {
        let (scene, lamp) = (self.stage.scene, &self.lit.lamp);
        let of_lamp = Key::new(self.sampling.seed, 0).with_point(lamp.center_mm);
        let mut near = Near::default();
        let mut seen = [[[0.0; LANES]; TILE]; 3];
        let mut tinted = false;
        for point in 0..points.count {
            let pixel = usize::from(points.pixel[point]);
            let (x, y) = (self.place.x + pixel % TILE, self.place.y + pixel / TILE);
            if x >= scene.view.width || y >= scene.view.height {
                continue;
            }
            let (block, lane) = (point / LANES, point % LANES);
            let offset = DVec2::new(f64::from(points.x[block][lane]), f64::from(points.y[block][lane]));
            let key = of_lamp.with((y as u64) << 32 | x as u64);
            let rays = Rays { sampling: self.sampling, key, point: self.place.middle_mm + offset };
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
