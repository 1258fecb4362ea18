//! The frame composer: from two snapshots to a finished frame. The window, `caustic dump` and `caustic frame` share it.
//!
//! A frame is the playfield, which `tracer` lights, in its place, with the head-up display (HUD) around and over it.
//! The same snapshots, size and table give the same bytes on any number of threads, with a window or without.

mod camera;
mod dynamic_resolution;
mod exposure;
mod interpolation;
mod playfield;
mod preparation;
mod size_dependent_assets;

pub use dynamic_resolution::DynamicResolution;
pub use interpolation::Interpolation;

use crate::hud::{FrameTimes, Hud, UiState};
use crate::screen::{Canvas, Rect, Size};
use crate::simulation::Snapshot;
use crate::{Failure, Table};
use camera::Camera;
use playfield::{Aspect, Playfield, Stage};
use preparation::{Moment, Preparation};
use rayon::ThreadPool;
use std::sync::Arc;
use std::time::Instant;
use tracer::monte_carlo::Sampling;
use tracer::{Frame, RenderStage};

/// At which resolution the lamps' light is found.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum LightResolution {
    /// At the frame's own.
    #[default]
    Full,
    /// At half of it.
    Half,
}

/// The playfield, the HUD, and everything else that is kept from one frame to the next.
pub struct FrameComposer {
    pool: ThreadPool,
    stage: Stage,
    hud: Hud,
    frame: Frame,
    light: LightResolution,
    zoom: f64,
    camera: Camera,
    /// The zoom that the camera was last aimed at.
    aimed_zoom: f64,
    /// Monte Carlo shadows instead of exact ones: the slow reference.
    reference: Option<Sampling>,
    playfield: Option<Playfield>,
    /// Another aspect is prepared beside the frames, which go on with the one that is there.
    prepares_beside: bool,
    preparation: Option<Preparation>,
    /// What could not be prepared, and is not tried again.
    refused: Option<Aspect>,
    times: FrameTimes,
}

impl FrameComposer {
    /// A composer of frames of `table`, traced on the threads of `pool`.
    ///
    /// # Errors
    /// If a font in the program is damaged.
    pub fn new(table: Arc<Table>, pool: ThreadPool) -> Result<FrameComposer, Failure> {
        Ok(FrameComposer {
            pool,
            stage: Stage::new(table),
            hud: Hud::new()?,
            frame: Frame::default(),
            light: LightResolution::Full,
            zoom: 1.0,
            camera: Camera::default(),
            aimed_zoom: 1.0,
            reference: None,
            playfield: None,
            prepares_beside: false,
            preparation: None,
            refused: None,
            times: FrameTimes::default(),
        })
    }

    /// The table that is drawn.
    pub fn table(&self) -> &Arc<Table> {
        &self.stage.table
    }

    /// Draws another table, or the same one after its files have changed.
    pub fn set_table(&mut self, table: Arc<Table>) {
        self.stage = Stage::new(table);
        (self.playfield, self.preparation, self.refused) = (None, None, None);
    }

    /// From now on, takes shadows from random points on the lamps: the slow reference.
    pub fn use_reference(&mut self, sampling: Sampling) {
        self.reference = Some(sampling);
    }

    /// From now on, no frame waits for another size, zoom or resolution of light: it is prepared on a thread of its own,
    /// and until it is ready, frames are as they were (of the old size). Which frame is the first of the new ones
    /// depends on the machine; without this call every frame is as it was asked for.
    pub fn prepare_beside(&mut self) {
        self.prepares_beside = true;
    }

    /// Whether frames are not yet as they were asked for.
    pub fn is_preparing(&self) -> bool {
        self.preparation.is_some()
    }

    /// From now on, finds the lamps' light at this resolution.
    pub fn set_light_resolution(&mut self, light: LightResolution) {
        self.light = light;
    }

    /// The resolution at which the last frame's light was found.
    pub fn drawn_light(&self) -> Option<LightResolution> {
        self.playfield.as_ref().map(|playfield| playfield.aspect.light)
    }

    /// From now on, shows the table this many times (1 to 4) as large as fits into the frame, around the ball.
    pub fn set_zoom(&mut self, zoom: f64) {
        self.zoom = zoom;
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
        let size = Size { width: size.width.max(1), height: size.height.max(1) };
        let aspect = Aspect { size, zoom: self.zoom, light: self.light };
        if self.prepares_beside && self.playfield.is_some() {
            self.prepare(aspect, &snapshot)?;
        } else {
            self.fit(aspect)?;
        }
        self.aim(&snapshot);
        self.render(&snapshot, start);
        let rendered = now();
        self.compose(&snapshot, ui_state);
        self.times.hud_ms = ms(rendered, now());
        Ok(&self.frame)
    }

    /// Makes what the aspect needs and is not there.
    fn fit(&mut self, aspect: Aspect) -> Result<(), Failure> {
        if self.playfield.as_ref().is_some_and(|playfield| playfield.aspect == aspect) {
            return Ok(());
        }
        let table = &self.stage.table;
        let playfield = match self.playfield.take() {
            Some(playfield) => playfield.refit(table, aspect)?,
            None => Playfield::new(table, aspect, None)?,
        };
        self.show(playfield);
        Ok(())
    }

    /// Takes what has been prepared, or begins to prepare what is asked for.
    fn prepare(&mut self, aspect: Aspect, snapshot: &Snapshot) -> Result<(), Failure> {
        let Some(preparation) = self.preparation.take() else { return self.begin(aspect, snapshot) };
        match preparation.take() {
            Some(Ok(prepared)) if prepared.aspect == aspect => {
                if let Some(old) = self.show(prepared) {
                    preparation.retire(old);
                }
            }
            // What is no longer asked for is not shown; the next frame begins with what is.
            Some(Ok(_)) => {}
            Some(Err(failure)) => {
                self.refused = Some(preparation.aspect());
                return Err(failure);
            }
            None => {
                preparation.follow(self.moment(preparation.aspect(), snapshot));
                self.preparation = Some(preparation);
            }
        }
        Ok(())
    }

    /// Begins to prepare an aspect, if it is another one.
    fn begin(&mut self, aspect: Aspect, snapshot: &Snapshot) -> Result<(), Failure> {
        let Some(playfield) = &self.playfield else { return Ok(()) };
        if playfield.aspect != aspect && self.refused != Some(aspect) {
            let (known, moment) = (playfield.assets.undrawn(), self.moment(aspect, snapshot));
            self.preparation = Some(Preparation::begin(self.stage.clone(), aspect, known, moment)?);
        }
        Ok(())
    }

    /// What a playfield of this aspect draws to be as warm as the one that is drawn.
    fn moment(&self, aspect: Aspect, snapshot: &Snapshot) -> Moment {
        let stays = self.playfield.as_ref().is_some_and(|playfield| playfield.aspect.zoom == aspect.zoom);
        let camera = if stays { self.camera.clone() } else { Camera::default() };
        Moment { snapshot: snapshot.clone(), camera }
    }

    /// From now on draws this playfield; gives the one before.
    fn show(&mut self, playfield: Playfield) -> Option<Playfield> {
        let placement = playfield.assets.placement;
        self.hud.fit(placement, &mut self.frame);
        // What a push has uncovered around the old one is covered again.
        self.hud.restore(&mut self.frame, placement.well);
        self.playfield.replace(playfield)
    }

    /// Finds which part of the playfield is shown: at another zoom, the camera goes to the ball at once.
    fn aim(&mut self, snapshot: &Snapshot) {
        let Some(playfield) = &mut self.playfield else { return };
        if self.aimed_zoom != playfield.aspect.zoom {
            self.aimed_zoom = playfield.aspect.zoom;
            self.camera.reset();
        }
        playfield.aim(&mut self.camera, snapshot, &self.stage.table);
    }

    /// Renders the playfield into its display buffer.
    fn render(&mut self, snapshot: &Snapshot, start: Instant) {
        let Some(playfield) = &mut self.playfield else { return };
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
        let (stage, reference) = (&self.stage, self.reference);
        self.pool.install(|| playfield.render(stage, snapshot, reference, &mut clock));
    }

    /// Puts the playfield into its well, and the HUD around and over it.
    fn compose(&mut self, snapshot: &Snapshot, ui_state: &UiState) {
        let Some(Playfield { assets, corner, .. }) = &mut self.playfield else { return };
        let push = snapshot.pose.cabinet_m * 1000.0 / assets.view.mm_per_px;
        let shift = (push.x.round() as i32, push.y.round() as i32);
        if shift != assets.shift {
            self.hud.restore(&mut self.frame, assets.placement.well);
            assets.shift = shift;
        }
        let rect: Rect = assets.placement.table.moved(shift.0, shift.1);
        let mut canvas = Canvas::new(&mut self.frame);
        let mut well = canvas.within(assets.placement.well);
        let first = (corner.0 as i32, corner.1 as i32);
        self.pool.install(|| well.copy(assets.display_buffer.frame(), rect, first));
        let screen_from_table = assets.screen_from_table(*corner);
        let table = &self.stage.table;
        self.hud.draw_around(table, snapshot, ui_state, &mut self.frame);
        self.hud.draw_over(table, snapshot, ui_state, screen_from_table, &mut self.frame);
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
