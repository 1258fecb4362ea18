//! The warm renderer, which caches what it has drawn, so that the next frame costs only what has changed; and one picture
//! from nothing.

use crate::film::tone_map;
use crate::realtime::exact_renderer::ExactRenderer;
use crate::realtime::half_resolution::HalfRenderer;
use crate::{DisplayBuffer, Integrator, Radiance, RenderStage, Scene, SimdLevel, monte_carlo};

/// Renders scenes by an [`Integrator`]. Keep one from frame to frame: it allocates only when a scene has more in it than
/// before.
pub struct Renderer {
    simd: SimdLevel,
    integrator: Integrator,
    exact: ExactRenderer,
    /// Made when it is asked for first.
    half: Option<Box<HalfRenderer>>,
    /// The light of sampled pictures that are to be tone-mapped.
    radiance: Radiance,
}

impl Default for Renderer {
    fn default() -> Renderer {
        Renderer::new()
    }
}

impl Renderer {
    /// An exact renderer for this machine's best instruction set.
    pub fn new() -> Renderer {
        Renderer::on(SimdLevel::best())
    }

    /// An exact renderer on a chosen instruction set: the same bits on each.
    pub fn on(simd: SimdLevel) -> Renderer {
        let (integrator, exact) = (Integrator::Exact, ExactRenderer::on(simd));
        Renderer { simd, integrator, exact, half: None, radiance: Radiance::default() }
    }

    /// A renderer by an integrator, for this machine's best instruction set.
    pub fn with(integrator: Integrator) -> Renderer {
        let mut renderer = Renderer::new();
        renderer.set_integrator(integrator);
        renderer
    }

    /// From now on, renders by this integrator. What is cached of frames by others is kept.
    pub fn set_integrator(&mut self, integrator: Integrator) {
        self.integrator = integrator;
    }

    /// Renders `scene`, on the threads of the current rayon pool: the same bits on any number. What [`Scene::check`]
    /// refuses is not drawn; of a view that it refuses there is no picture.
    pub fn render(&mut self, scene: &Scene, radiance: &mut Radiance) {
        match self.integrator {
            Integrator::Exact => self.exact.render(scene, radiance),
            Integrator::HalfResolution => self.half().render(scene, radiance),
            Integrator::MonteCarlo(sampling) => monte_carlo::render(scene, sampling, radiance),
        }
    }

    /// Renders `scene` and tone-maps it ([`crate::tone_map::map`]) in one go: the same pixels, several times as fast, since
    /// no tile leaves the cache in between. Tiles that still show what they should are left as they are.
    pub fn draw(&mut self, scene: &Scene, exposure: f32, display: &mut DisplayBuffer) {
        self.draw_timed(scene, exposure, display, &mut |_| {});
    }

    /// [`Renderer::draw`] for somebody with a clock: calls `done` after each step of a realtime integrator.
    pub fn draw_timed(
        &mut self,
        scene: &Scene,
        exposure: f32,
        display: &mut DisplayBuffer,
        done: &mut (dyn FnMut(RenderStage) + Send),
    ) {
        match self.integrator {
            Integrator::Exact => self.exact.draw_timed(scene, exposure, display, done),
            Integrator::HalfResolution => self.half().draw_timed(scene, exposure, display, done),
            Integrator::MonteCarlo(sampling) => {
                monte_carlo::render(scene, sampling, &mut self.radiance);
                display.resize(self.radiance.width(), self.radiance.height());
                tone_map::map_on(self.simd, &self.radiance, exposure, &mut display.frame);
                display.source = None;
            }
        }
    }

    /// Renders `scene` exactly, with nothing cached and nothing quantized: the slow twin of
    /// [`Renderer::render`].
    pub fn render_uncached(&mut self, scene: &Scene, radiance: &mut Radiance) {
        self.exact.render_uncached(scene, radiance);
    }

    /// Makes every tile anew in the next frame, with the same bits.
    ///
    /// No frame needs it: what changes is known by ids and revisions. It is there to measure what a frame from nothing
    /// costs.
    pub fn invalidate(&mut self) {
        self.exact.invalidate();
        self.half.iter_mut().for_each(|half| half.invalidate());
    }

    fn half(&mut self) -> &mut HalfRenderer {
        self.half.get_or_insert_with(|| Box::new(HalfRenderer::on(self.simd)))
    }
}

/// Renders a scene once, on the threads of the current rayon pool: the same bits on any number. What [`Scene::check`]
/// refuses is not drawn; of a view that it refuses there is no picture.
///
/// Nothing is kept, so nothing is rounded to be kept: this is the slow twin of [`Renderer::render`].
pub fn render(scene: &Scene, integrator: Integrator, radiance: &mut Radiance) {
    let mut renderer = Renderer::with(integrator);
    match integrator {
        Integrator::Exact => renderer.render_uncached(scene, radiance),
        Integrator::HalfResolution | Integrator::MonteCarlo(_) => renderer.render(scene, radiance),
    }
}
