//! The playfield at one aspect: the assets that it is drawn from, and the renderer that knows what it has drawn of it.

use super::LightResolution;
use super::camera::Camera;
use super::exposure;
use super::size_dependent_assets::SizeDependentAssets;
use crate::scene_builder::SceneBuilder;
use crate::screen::Size;
use crate::simulation::Snapshot;
use crate::{Failure, Table};
use std::sync::Arc;
use tracer::monte_carlo::Sampling;
use tracer::{Integrator, RenderStage, Renderer, Scene};

/// A table, and what a scene of it is built from.
#[derive(Clone)]
pub struct Stage {
    pub table: Arc<Table>,
    pub scene_builder: Arc<SceneBuilder>,
}

impl Stage {
    /// The stage of this table.
    pub fn new(table: Arc<Table>) -> Stage {
        Stage { scene_builder: Arc::new(SceneBuilder::new(&table)), table }
    }
}

/// How the playfield is looked at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aspect {
    /// The frame's size.
    pub size: Size,
    /// How much larger than fits into it the table is drawn.
    pub zoom: f64,
    /// At which resolution light is found.
    pub light: LightResolution,
}

/// The playfield at one aspect.
pub struct Playfield {
    pub aspect: Aspect,
    pub assets: SizeDependentAssets,
    /// The first column and row of the playfield that are shown.
    pub corner: (usize, usize),
    renderer: Renderer,
}

impl Playfield {
    /// A playfield of which nothing has been drawn. What `known` assets have in common with it is not made anew.
    ///
    /// # Errors
    /// If the table's art cannot be rasterized at this size.
    pub fn new(table: &Table, aspect: Aspect, known: Option<SizeDependentAssets>) -> Result<Playfield, Failure> {
        let assets = fitted(table, aspect, known)?;
        Ok(Playfield { aspect, assets, corner: (0, 0), renderer: Renderer::new() })
    }

    /// The same playfield at another aspect.
    ///
    /// # Errors
    /// If the table's art cannot be rasterized at this size.
    pub fn refit(self, table: &Table, aspect: Aspect) -> Result<Playfield, Failure> {
        Ok(Playfield { aspect, assets: fitted(table, aspect, Some(self.assets))?, ..self })
    }

    /// Finds which part of the playfield is shown.
    pub fn aim(&mut self, camera: &mut Camera, snapshot: &Snapshot, table: &Table) {
        let assets = &mut self.assets;
        let rect = assets.placement.table;
        let shown_mm = assets.shown_mm();
        self.corner = assets.corner(camera.follow(snapshot, table.size_mm, shown_mm));
        let (width, height) = (rect.width as usize, rect.height as usize);
        if (width, height) != (assets.view.width, assets.view.height) {
            assets.display_buffer.set_scissor(self.corner.0, self.corner.1, width, height);
        }
    }

    /// Renders the playfield into its display buffer, on the threads of the current pool; calls `done` when there is a
    /// scene, and after each stage. With a `reference`, by that instead of by exact shadows.
    pub fn render(
        &mut self,
        stage: &Stage,
        snapshot: &Snapshot,
        reference: Option<Sampling>,
        done: &mut (dyn FnMut(Option<RenderStage>) + Send),
    ) {
        let assets = &mut self.assets;
        let exposure = exposure::exposure(snapshot.adaptation.light());
        let integrator = match (reference, self.aspect.light) {
            (Some(sampling), _) => Integrator::MonteCarlo(sampling),
            (None, LightResolution::Full) => Integrator::Exact,
            (None, LightResolution::Half) => Integrator::HalfResolution,
        };
        let half_floor = assets.half_floor.as_deref();
        let scene = stage.scene_builder.scene(&stage.table, snapshot, assets.view, &assets.art);
        let scene = Scene { half_floor, ..scene };
        done(None);
        self.renderer.set_integrator(integrator);
        self.renderer.draw_timed(&scene, exposure, &mut assets.display_buffer, &mut |stage| done(Some(stage)));
    }
}

/// The assets of an aspect.
fn fitted(table: &Table, aspect: Aspect, known: Option<SizeDependentAssets>) -> Result<SizeDependentAssets, Failure> {
    let Aspect { size, zoom, light } = aspect;
    let mut assets = match known.filter(|assets| assets.fits(size.width, size.height, zoom)) {
        Some(assets) => assets,
        None => SizeDependentAssets::new(table, size.width, size.height, zoom)?,
    };
    if light == LightResolution::Half {
        assets.rasterize_half(table)?;
    }
    Ok(assets)
}
