//! The frame composer: from two snapshots to a finished frame. The window, `caustic dump` and `caustic frame` share it.
//!
//! A frame is the playfield, which `tracer` lights, in its place, with the head-up display (HUD) around and over it.
//! The same snapshots, size and table give the same bytes on any number of threads, with a window or without.

mod camera;
mod dynamic_resolution;
mod exposure;
mod interpolation;
mod size_dependent_assets;

pub use dynamic_resolution::DynamicResolution;
pub use interpolation::Interpolation;

use crate::hud::{FrameTimes, Hud, UiState};
use crate::scene_builder::SceneBuilder;
use crate::screen::{Canvas, Rect, Size};
use crate::simulation::Snapshot;
use crate::{Failure, Table};
use camera::Camera;
use rayon::ThreadPool;
use size_dependent_assets::SizeDependentAssets;
use std::sync::Arc;
use std::time::Instant;
use tracer::monte_carlo::Sampling;
use tracer::{Frame, Integrator, RenderStage, Renderer, Scene};

/// At which resolution the lamps' light is found.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum LightResolution {
    /// At the frame's own.
    #[default]
    Full,
    /// At half of it.
    Half,
}

/// The renderers, the HUD, and everything else that is kept from one frame to the next.
pub struct FrameComposer {
    pool: ThreadPool,
    table: Arc<Table>,
    scene_builder: SceneBuilder,
    hud: Hud,
    frame: Frame,
    renderer: Renderer,
    light: LightResolution,
    zoom: f64,
    camera: Camera,
    /// The first column and row of the playfield that are shown.
    corner: (usize, usize),
    /// Monte Carlo shadows instead of exact ones: the slow reference.
    reference: Option<Sampling>,
    assets: Option<SizeDependentAssets>,
    times: FrameTimes,
}

impl FrameComposer {
    /// A composer of frames of `table`, traced on the threads of `pool`.
    ///
    /// # Errors
    /// If a font in the program is damaged.
    pub fn new(table: Arc<Table>, pool: ThreadPool) -> Result<FrameComposer, Failure> {
        let (scene_builder, hud, frame) = (SceneBuilder::new(&table), Hud::new()?, Frame::default());
        Ok(FrameComposer {
            pool,
            table,
            scene_builder,
            hud,
            frame,
            renderer: Renderer::new(),
            light: LightResolution::Full,
            zoom: 1.0,
            camera: Camera::default(),
            corner: (0, 0),
            reference: None,
            assets: None,
            times: FrameTimes::default(),
        })
    }

    /// The table that is drawn.
    pub fn table(&self) -> &Arc<Table> {
        &self.table
    }

    /// Draws another table, or the same one after its files have changed.
    pub fn set_table(&mut self, table: Arc<Table>) {
        self.scene_builder = SceneBuilder::new(&table);
        self.table = table;
        self.assets = None;
    }

    /// From now on, takes shadows from random points on the lamps: the slow reference.
    pub fn use_reference(&mut self, sampling: Sampling) {
        self.reference = Some(sampling);
    }

    /// From now on, finds the lamps' light at this resolution.
    pub fn set_light_resolution(&mut self, light: LightResolution) {
        self.light = light;
    }

    /// From now on, shows the table this many times (1 to 4) as large as fits into the frame, around the ball.
    pub fn set_zoom(&mut self, zoom: f64) {
        if self.zoom != zoom {
            self.zoom = zoom;
            self.camera.reset();
        }
    }

    /// What the last frame cost.
    pub fn times(&self) -> FrameTimes {
        self.times
    }

    /// The frame between two snapshots, of this size (a pixel or more each way).
    ///
    /// # Errors
    /// If the table's art cannot be rasterized at this size.
    pub fn draw(&mut self, interpolation: Interpolation, size: Size, ui_state: &UiState) -> Result<&Frame, Failure> {
        let start = now();
        let snapshot = interpolation.snapshot();
        self.fit(size.width.max(1), size.height.max(1))?;
        self.aim(&snapshot);
        self.render(&snapshot, start);
        let rendered = now();
        self.compose(&snapshot, ui_state);
        self.times.hud_ms = ms(rendered, now());
        Ok(&self.frame)
    }

    /// Makes the size-dependent assets anew if the size or the zoom has changed.
    fn fit(&mut self, width: usize, height: usize) -> Result<(), Failure> {
        if !self.assets.as_ref().is_some_and(|assets| assets.fits(width, height, self.zoom)) {
            let assets = SizeDependentAssets::new(&self.table, width, height, self.zoom)?;
            self.hud.fit(assets.placement, &mut self.frame);
            self.assets = Some(assets);
        }
        match (&mut self.assets, self.light) {
            (Some(assets), LightResolution::Half) => assets.rasterize_half(&self.table),
            _ => Ok(()),
        }
    }

    /// Finds which part of the playfield is shown.
    fn aim(&mut self, snapshot: &Snapshot) {
        let Some(assets) = &mut self.assets else { return };
        let rect = assets.placement.table;
        let shown_mm = assets.shown_mm();
        self.corner = assets.corner(self.camera.follow(snapshot, self.table.size_mm, shown_mm));
        let (width, height) = (rect.width as usize, rect.height as usize);
        if (width, height) != (assets.view.width, assets.view.height) {
            assets.display_buffer.set_scissor(self.corner.0, self.corner.1, width, height);
        }
    }

    /// Renders the playfield into its display buffer.
    fn render(&mut self, snapshot: &Snapshot, start: Instant) {
        let Some(assets) = &mut self.assets else { return };
        let exposure = exposure::exposure(snapshot.adaptation.light());
        let integrator = match (self.reference, self.light) {
            (Some(sampling), _) => Integrator::MonteCarlo(sampling),
            (None, LightResolution::Full) => Integrator::Exact,
            (None, LightResolution::Half) => Integrator::HalfResolution,
        };
        let times = &mut self.times;
        let mut last = start;
        let mut clock = |step: Option<RenderStage>| {
            let now = now();
            let time_ms = match step {
                None => &mut times.scene_ms,
                Some(RenderStage::Prepared) => &mut times.prepare_ms,
                Some(RenderStage::Shaded) => &mut times.shadows_ms,
                Some(RenderStage::BallsRendered) => &mut times.balls_ms,
                Some(RenderStage::Bloomed) => &mut times.bloom_ms,
                Some(RenderStage::ToneMapped) => &mut times.tone_map_ms,
            };
            *time_ms = ms(last, now);
            last = now;
        };
        let half_floor = assets.half_floor.as_deref();
        let scene = self.scene_builder.scene(&self.table, snapshot, assets.view, &assets.art);
        let scene = Scene { half_floor, ..scene };
        clock(None);
        self.renderer.set_integrator(integrator);
        let (renderer, display) = (&mut self.renderer, &mut assets.display_buffer);
        self.pool.install(|| renderer.draw_timed(&scene, exposure, display, &mut |step| clock(Some(step))));
    }

    /// Puts the playfield into its well, and the HUD around and over it.
    fn compose(&mut self, snapshot: &Snapshot, ui_state: &UiState) {
        let Some(assets) = &mut self.assets else { return };
        let push = snapshot.pose.cabinet_m * 1000.0 / assets.view.mm_per_px;
        let shift = (push.x.round() as i32, push.y.round() as i32);
        if shift != assets.shift {
            self.hud.restore(&mut self.frame, assets.placement.well);
            assets.shift = shift;
        }
        let rect: Rect = assets.placement.table.moved(shift.0, shift.1);
        let mut canvas = Canvas::new(&mut self.frame);
        let mut well = canvas.within(assets.placement.well);
        let corner = (self.corner.0 as i32, self.corner.1 as i32);
        self.pool.install(|| well.copy(assets.display_buffer.frame(), rect, corner));
        let screen_from_table = assets.screen_from_table(self.corner);
        self.hud.draw_around(&self.table, snapshot, ui_state, &mut self.frame);
        self.hud.draw_over(&self.table, snapshot, ui_state, screen_from_table, &mut self.frame);
    }
}

#[expect(
    clippy::disallowed_methods,
    reason = "tells what a frame costs; nothing that is drawn or played depends on it"
)]
fn now() -> Instant {
    Instant::now()
}

fn ms(from: Instant, to: Instant) -> f64 {
    to.duration_since(from).as_secs_f64() * 1000.0
}
