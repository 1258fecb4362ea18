//! From two ticks to a finished picture: the one function that the window, a dump and a single frame share.
//!
//! The same moment, size and table give the same bytes on any number of threads, with a window or without.

mod camera;
mod dynamic_resolution;
mod exposure;
mod png_file;
mod size_dependent_assets;

pub use dynamic_resolution::Quality;
pub use png_file::save_png;

use crate::hud::{Chrome, Hud, Times};
use crate::scene_builder::{self, SceneBuilder};
use crate::screen::{Canvas, Rect};
use crate::simulation::Snapshot;
use crate::{Failure, Table};
use camera::Camera;
use rayon::ThreadPool;
use size_dependent_assets::Scenery;
use std::sync::Arc;
use std::time::Instant;
use tracer::monte_carlo::Sampling;
use tracer::{Frame, HalfRenderer, RenderStage, Renderer};

/// At which resolution the lamps' light is found.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Light {
    /// At the picture's own.
    #[default]
    Full,
    /// At half of it.
    Half,
}

/// The moment between two ticks.
#[derive(Clone, Copy)]
pub struct Moment<'a> {
    /// The earlier tick.
    pub previous: &'a Snapshot,
    /// The later tick.
    pub current: &'a Snapshot,
    /// How far from the earlier to the later, 0 to 1.
    pub alpha: f64,
}

impl<'a> Moment<'a> {
    /// A tick itself.
    pub fn at(snapshot: &'a Snapshot) -> Moment<'a> {
        Moment { previous: snapshot, current: snapshot, alpha: 1.0 }
    }
}

/// Everything that is kept from one picture to the next.
pub struct Picture {
    pool: ThreadPool,
    table: Arc<Table>,
    scene_builder: SceneBuilder,
    hud: Hud,
    frame: Frame,
    renderer: Renderer,
    half: HalfRenderer,
    light: Light,
    zoom: f64,
    camera: Camera,
    /// The first column and row of the playfield that are shown.
    corner: (usize, usize),
    /// Shadows by chance instead of exact ones: the slow reference.
    reference: Option<Sampling>,
    scenery: Option<Scenery>,
    times: Times,
}

impl Picture {
    /// Pictures of `table`, traced on the threads of `pool`.
    ///
    /// # Errors
    /// If a font in the program is damaged.
    pub fn new(table: Arc<Table>, pool: ThreadPool) -> Result<Picture, Failure> {
        let (scene_builder, hud, frame) = (SceneBuilder::new(&table), Hud::new()?, Frame::default());
        Ok(Picture {
            pool,
            table,
            scene_builder,
            hud,
            frame,
            renderer: Renderer::new(),
            half: HalfRenderer::new(),
            light: Light::Full,
            zoom: 1.0,
            camera: Camera::default(),
            corner: (0, 0),
            reference: None,
            scenery: None,
            times: Times::default(),
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
        self.scenery = None;
    }

    /// From now on, takes shadows from random points on the lamps: the slow reference.
    pub fn use_reference(&mut self, sampling: Sampling) {
        self.reference = Some(sampling);
    }

    /// From now on, finds light at this resolution.
    pub fn set_light(&mut self, light: Light) {
        self.light = light;
    }

    /// From now on, shows the table this many times (1 to 4) as large as fits into the picture, around the ball.
    pub fn set_zoom(&mut self, zoom: f64) {
        if self.zoom != zoom {
            self.zoom = zoom;
            self.camera.rest();
        }
    }

    /// What the last picture cost.
    pub fn times(&self) -> Times {
        self.times
    }

    /// The picture of a moment, `width` x `height` pixels (1 or more each).
    ///
    /// # Errors
    /// If the table's art cannot be printed at this size.
    pub fn draw(&mut self, moment: Moment, width: usize, height: usize, chrome: &Chrome) -> Result<&Frame, Failure> {
        let start = now();
        let moment = scene_builder::blend(moment.previous, moment.current, moment.alpha);
        self.fit(width.max(1), height.max(1))?;
        self.aim(&moment);
        self.render(&moment, start);
        let drawn = now();
        self.compose(&moment, chrome);
        self.times.hud_ms = ms(drawn, now());
        Ok(&self.frame)
    }

    fn fit(&mut self, width: usize, height: usize) -> Result<(), Failure> {
        if !self.scenery.as_ref().is_some_and(|scenery| scenery.fits(width, height, self.zoom)) {
            let scenery = Scenery::new(&self.table, width, height, self.zoom)?;
            self.hud.fit(scenery.placement, &mut self.frame);
            self.scenery = Some(scenery);
        }
        match (&mut self.scenery, self.light) {
            (Some(scenery), Light::Half) => scenery.print_half(&self.table),
            _ => Ok(()),
        }
    }

    /// Finds which part of the playfield is shown.
    fn aim(&mut self, moment: &Snapshot) {
        let Some(scenery) = &mut self.scenery else { return };
        let rect = scenery.placement.table;
        let shown_mm = scenery.shown_mm();
        self.corner = scenery.corner(self.camera.follow(moment, self.table.size_mm, shown_mm));
        let (width, height) = (rect.width as usize, rect.height as usize);
        if (width, height) != (scenery.view.width, scenery.view.height) {
            scenery.film.look_at(self.corner.0, self.corner.1, width, height);
        }
    }

    /// The playfield, on its film.
    fn render(&mut self, moment: &Snapshot, start: Instant) {
        let Some(scenery) = &mut self.scenery else { return };
        let exposure = exposure::exposure(moment.eye.light());
        let (view, light) = (scenery.view, if self.reference.is_some() { Light::Full } else { self.light });
        let times = &mut self.times;
        let mut last = start;
        let mut clock = |step: Option<RenderStage>| {
            let now = now();
            let time_ms = match step {
                None => &mut times.stage_ms,
                Some(RenderStage::Prepared) => &mut times.prepare_ms,
                Some(RenderStage::Shaded) => &mut times.shadows_ms,
                Some(RenderStage::Mirrored) => &mut times.balls_ms,
                Some(RenderStage::Glared) => &mut times.glare_ms,
                Some(RenderStage::Developed) => &mut times.develop_ms,
            };
            *time_ms = ms(last, now);
            last = now;
        };
        if light == Light::Half
            && let Some((floor, printed, film)) = scenery.half()
        {
            let scene = self.scene_builder.scene(&self.table, moment, view, printed);
            clock(None);
            let half = &mut self.half;
            self.pool.install(|| half.draw_watched(&scene, floor, exposure, film, &mut |step| clock(Some(step))));
            return;
        }
        let scene = self.scene_builder.scene(&self.table, moment, view, &scenery.printed);
        clock(None);
        let (renderer, film, reference) = (&mut self.renderer, &mut scenery.film, self.reference);
        self.pool.install(|| match reference {
            Some(sampling) => renderer.draw_monte_carlo(&scene, sampling, exposure, film),
            None => renderer.draw_watched(&scene, exposure, film, &mut |step| clock(Some(step))),
        });
    }

    /// The playfield in its well, and the display around and over it.
    fn compose(&mut self, moment: &Snapshot, chrome: &Chrome) {
        let Some(scenery) = &mut self.scenery else { return };
        let push = moment.pose.cabinet_m * 1000.0 / scenery.view.mm_per_px;
        let shift = (push.x.round() as i32, push.y.round() as i32);
        if shift != scenery.shift {
            self.hud.restore(&mut self.frame, scenery.placement.well);
            scenery.shift = shift;
        }
        let place: Rect = scenery.placement.table.moved(shift.0, shift.1);
        let mut canvas = Canvas::new(&mut self.frame);
        let mut well = canvas.within(scenery.placement.well);
        let corner = (self.corner.0 as i32, self.corner.1 as i32);
        self.pool.install(|| well.copy(scenery.film.frame(), place, corner));
        let lens = scenery.lens(self.corner);
        self.hud.draw_around(&self.table, moment, chrome, &mut self.frame);
        self.hud.draw_over(&self.table, moment, chrome, lens, &mut self.frame);
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
