//! From two ticks to a finished picture: the one function that the window, a dump and a single frame share.
//!
//! The same moment, size and table give the same bytes on any number of threads, with a window or without.

mod file;
pub mod placement;

pub use file::save_png;

use crate::hud::{Canvas, Chrome, Hud, Rect, Times};
use crate::simulation::Snapshot;
use crate::stage::{self, Printed, Stage};
use crate::{Failure, Table};
use placement::Placement;
use rayon::ThreadPool;
use std::sync::Arc;
use std::time::Instant;
use tracer::monte_carlo::Sampling;
use tracer::{Film, Frame, Renderer, Step, View};

/// The factor from the table's light to the film's; the same for every picture, so that a lamp that goes out makes the
/// table darker.
const EXPOSURE: f32 = 1.0;

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
    stage: Stage,
    hud: Hud,
    frame: Frame,
    renderer: Renderer,
    /// Shadows by chance instead of exact ones: the slow reference.
    reference: Option<Sampling>,
    scenery: Option<Scenery>,
    times: Times,
}

/// What depends on the size.
struct Scenery {
    placement: Placement,
    view: View,
    printed: Printed,
    /// The playfield.
    film: Film,
    /// How far the playfield was moved by a push when it was last drawn, pixels.
    shift: (i32, i32),
}

impl Picture {
    /// Pictures of `table`, traced on the threads of `pool`.
    ///
    /// # Errors
    /// If a font in the program is damaged.
    pub fn new(table: Arc<Table>, pool: ThreadPool) -> Result<Picture, Failure> {
        let (stage, hud, frame) = (Stage::new(&table), Hud::new()?, Frame::default());
        let (renderer, times) = (Renderer::new(), Times::default());
        Ok(Picture { pool, table, stage, hud, frame, renderer, reference: None, scenery: None, times })
    }

    /// The table that is drawn.
    pub fn table(&self) -> &Arc<Table> {
        &self.table
    }

    /// Draws another table, or the same one after its files have changed.
    pub fn set_table(&mut self, table: Arc<Table>) {
        self.stage = Stage::new(&table);
        self.table = table;
        self.scenery = None;
    }

    /// From now on, takes shadows from random points on the lamps: the slow reference.
    pub fn use_reference(&mut self, sampling: Sampling) {
        self.reference = Some(sampling);
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
        let moment = stage::blend(moment.previous, moment.current, moment.alpha);
        self.fit(width.max(1), height.max(1))?;
        if let Some(scenery) = &mut self.scenery {
            let scene = self.stage.scene(&self.table, &moment, scenery.view, &scenery.printed);
            let staged = now();
            let (renderer, film, times) = (&mut self.renderer, &mut scenery.film, &mut self.times);
            times.stage_ms = ms(start, staged);
            let mut last = staged;
            let mut clock = |step: Step| {
                let now = now();
                let time_ms = match step {
                    Step::Prepared => &mut times.prepare_ms,
                    Step::Shaded => &mut times.shadows_ms,
                    Step::Mirrored => &mut times.balls_ms,
                    Step::Glared => &mut times.glare_ms,
                    Step::Developed => &mut times.develop_ms,
                };
                *time_ms = ms(last, now);
                last = now;
            };
            self.pool.install(|| match self.reference {
                Some(sampling) => renderer.draw_monte_carlo(&scene, sampling, EXPOSURE, film),
                None => renderer.draw_watched(&scene, EXPOSURE, film, &mut clock),
            });
        }
        let drawn = now();
        self.compose(&moment, chrome);
        self.times.hud_ms = ms(drawn, now());
        Ok(&self.frame)
    }

    fn fit(&mut self, width: usize, height: usize) -> Result<(), Failure> {
        let fits = |scenery: &Scenery| (scenery.placement.width, scenery.placement.height) == (width, height);
        if self.scenery.as_ref().is_some_and(fits) {
            return Ok(());
        }
        let placement = Placement::new(width, height, self.table.size_mm);
        let view = View::fit(placement.table.width as usize, placement.table.height as usize, self.table.size_mm);
        let printed = Printed::new(&self.table, &view)?;
        // The new art may lie in memory where the old art lay.
        self.renderer.forget();
        self.hud.fit(placement, &mut self.frame);
        self.scenery = Some(Scenery { placement, view, printed, film: Film::default(), shift: (0, 0) });
        Ok(())
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
        self.pool.install(|| well.copy(scenery.film.frame(), place, (0, 0)));
        self.hud.draw_around(&self.table, moment, chrome, &mut self.frame);
        self.hud.draw_over(&self.table, moment, chrome, &mut self.frame);
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
