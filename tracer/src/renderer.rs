//! From a scene to the light that leaves it: prepares what all tiles share, renders the tiles on every core, then the
//! balls that mirror them, then the glare.

use crate::ball::{Glint, Patch, Table};
use crate::candidates::Candidates;
use crate::changes::Changes;
use crate::coverage::Form;
use crate::glare::Source;
use crate::lanes::Path;
use crate::memory::{Past, TileMemory};
use crate::monte_carlo::Sampling;
use crate::points::{Points, TILE};
use crate::silhouette::Silhouettes;
use crate::tile::{Lit, Stage, Workspace};
use crate::{Radiance, Scene, Top, exact, limits};
use rayon::prelude::*;
use std::cell::RefCell;
use std::sync::atomic::{AtomicU64, Ordering};

/// Pixels along the side of a block of tiles, which share what is found out about their neighbourhood.
const BLOCK: usize = 2 * TILE;

/// Renders scenes. Keep one from frame to frame: it allocates only when a scene has more in it than before.
pub struct Renderer {
    path: Path,
    silhouettes: Silhouettes,
    moved: Silhouettes,
    past: Past,
    changes: Changes,
    /// Its own number, and that of its last picture.
    picture: (u64, u64),
    lamps: Vec<Lit>,
    tops: Vec<Top>,
    forms: Vec<Option<Form>>,
    whole_tile: (f64, Points),
    glints: Vec<Glint>,
    patches: Vec<Patch>,
}

/// How many renderers there have been: a picture knows by it who drew it.
static RENDERERS: AtomicU64 = AtomicU64::new(0);

thread_local! {
    static WORKSPACE: RefCell<Workspace> = RefCell::new(Workspace::new());
}

impl Default for Renderer {
    fn default() -> Renderer {
        Renderer::new()
    }
}

impl Renderer {
    /// A renderer for this machine's best instruction set.
    pub fn new() -> Renderer {
        Renderer::on(Path::best())
    }

    /// A renderer on a chosen instruction set: the same bits on each.
    pub fn on(path: Path) -> Renderer {
        Renderer {
            path,
            silhouettes: Silhouettes::default(),
            moved: Silhouettes::default(),
            past: Past::default(),
            changes: Changes::default(),
            picture: (RENDERERS.fetch_add(1, Ordering::Relaxed), 0),
            lamps: Vec::new(),
            tops: Vec::new(),
            forms: Vec::new(),
            whole_tile: (0.0, Points::none()),
            glints: Vec::new(),
            patches: Vec::new(),
        }
    }

    /// Renders `scene` with exact shadows, on the threads of the current rayon pool: the same bits on any number.
    /// What [`Scene::check`] refuses is not drawn; of a view that it refuses there is no picture.
    pub fn render(&mut self, scene: &Scene, radiance: &mut Radiance) {
        self.render_with(scene, None, radiance);
    }

    /// Renders `scene` with sampled shadows: the slow reference. Nothing but the visible fraction of the lamps differs.
    pub fn render_monte_carlo(&mut self, scene: &Scene, sampling: Sampling, radiance: &mut Radiance) {
        self.render_with(scene, Some(sampling), radiance);
    }

    /// Forgets what earlier pictures showed: the next one is found anew from nothing, with the same bits.
    ///
    /// Art and masks are known by where they are in memory. Whoever prints others in the place of those that were drawn
    /// has to call this.
    pub fn forget(&mut self) {
        self.past = Past::default();
        self.picture.1 += 1;
    }

    fn render_with(&mut self, scene: &Scene, sampling: Option<Sampling>, radiance: &mut Radiance) {
        if scene.check().is_err() {
            if limits::wrong_with_view(&scene.view).is_some() {
                return radiance.resize(0, 0);
            }
            return self.draw(&scene.drawable(), sampling, radiance);
        }
        self.draw(scene, sampling, radiance);
    }

    fn draw(&mut self, scene: &Scene, sampling: Option<Sampling>, radiance: &mut Radiance) {
        radiance.resize(scene.view.width, scene.view.height);
        if scene.view.width == 0 || scene.view.height == 0 {
            return;
        }
        self.prepare(scene);
        self.changes.everything |= radiance.drawn != Some(self.picture) || sampling.is_some();
        let stage = Stage {
            path: self.path,
            scene,
            silhouettes: &self.silhouettes,
            lamps: &self.lamps,
            moved_tops: &self.past.moved_tops,
            changes: &self.changes,
            forms: &self.forms,
            whole_tile: &self.whole_tile.1,
            sampling,
        };
        render_tiles(&stage, &mut self.past.bands, radiance);
        self.lamps.iter().for_each(|lit| self.past.looked_at(lit.number));
        self.render_balls(scene, radiance);
        let (width, height, stride) = (radiance.width(), radiance.height(), radiance.stride());
        let tile = |row: usize, column: usize| {
            &self.past.bands[row / (BLOCK / TILE)][row % (BLOCK / TILE) * (stride / TILE) + column]
        };
        if self.past.bands.iter().flatten().any(|tile| tile.fresh) {
            let source = Source { planes: &radiance.planes, stride, width, height };
            radiance.glare.gather(self.path, source, |row, column| tile(row, column).fresh);
        }
        self.picture.1 += 1;
        radiance.drawn = Some(self.picture);
        if sampling.is_some() {
            self.forget();
        }
    }

    fn prepare(&mut self, scene: &Scene) {
        self.silhouettes.set(&scene.occluders);
        let bands = scene.view.height.div_ceil(BLOCK);
        let tiles = scene.view.width.div_ceil(TILE) * (BLOCK / TILE);
        self.past.turn_page(&scene.view, &scene.occluders, bands, tiles);
        let mut count = 0;
        for lamp in scene.lamps.iter().filter(|lamp| lamp.shines()) {
            if self.lamps.len() == count {
                let none = Candidates::default;
                self.lamps.push(Lit { lamp: *lamp, candidates: none(), moved: none(), lost: true, number: 0 });
            }
            let lit = &mut self.lamps[count];
            lit.lamp = *lamp;
            lit.candidates.set(lamp, &self.silhouettes);
            lit.number = self.past.number(lamp);
            let known = &self.past.known[lit.number];
            lit.lost = known.lost;
            self.moved.set(&known.moved);
            lit.moved.set(lamp, &self.moved);
            count += 1;
        }
        self.lamps.truncate(count);
        self.prepare_tops(&scene.tops);
        self.changes.turn_page(scene, |lamp| self.past.number(lamp));
        self.lamps.iter().filter(|lit| lit.lost).for_each(|lit| self.changes.flash(&lit.lamp));
        if self.whole_tile.0 != scene.view.mm_per_px {
            self.whole_tile = (scene.view.mm_per_px, Points::whole_tile(scene.view.mm_per_px));
        }
    }

    /// Most tops are where they were in the last frame.
    fn prepare_tops(&mut self, tops: &[Top]) {
        let moved = &mut self.past.moved_tops;
        moved.clear();
        moved.extend(self.forms.iter().skip(tops.len()).flatten().map(|form| form.bounds));
        self.tops.truncate(tops.len());
        self.forms.truncate(tops.len());
        self.changes.tops.clear();
        for (at, top) in tops.iter().enumerate() {
            if self.tops.len() == at {
                self.tops.push(top.clone());
                self.forms.push(Form::new(top));
                moved.extend(self.forms[at].iter().map(|form| form.bounds));
            } else if stands(&self.tops[at], top) {
                if self.tops[at].finish != top.finish {
                    self.changes.tops.extend(self.forms[at].iter().map(|form| form.bounds));
                    self.tops[at].finish = top.finish;
                }
            } else {
                moved.extend(self.forms[at].iter().map(|form| form.bounds));
                self.tops[at].clone_from(top);
                self.forms[at] = Form::new(top);
                moved.extend(self.forms[at].iter().map(|form| form.bounds));
            }
        }
        self.changes.tops.extend_from_slice(moved);
    }

    fn render_balls(&mut self, scene: &Scene, radiance: &mut Radiance) {
        self.patches.resize_with(scene.balls.len(), Patch::default);
        for (ball, patch) in scene.balls.iter().zip(&mut self.patches) {
            self.glints.clear();
            let mut arriving = [0.0; 3];
            for Lit { lamp, candidates, .. } in &self.lamps {
                let falloff = lamp.falloff(ball.center_mm) as f32;
                if falloff <= 0.0 {
                    continue;
                }
                let seen =
                    exact::visible_fraction_of(&self.silhouettes, candidates, lamp, ball.center_mm, Some(ball.group));
                if seen > 0.0 {
                    self.glints.push(Glint::new(lamp, ball, seen as f32));
                }
                for channel in 0..3 {
                    arriving[channel] += lamp.color[channel] * falloff * seen as f32;
                }
            }
            let table = Table {
                view: &scene.view,
                planes: &radiance.planes,
                stride: radiance.stride(),
                ambient: scene.ambient,
            };
            patch.render(ball, table, &self.glints, arriving);
        }
        let stride = radiance.stride();
        for patch in &self.patches {
            patch.blend(&mut radiance.planes, stride);
        }
    }
}

/// Whether a top covers what it covered, and leans as it leant; its colours may be others.
fn stands(old: &Top, new: &Top) -> bool {
    let (a, b) = (&old.finish, &new.finish);
    old.outline == new.outline && old.group == new.group && (a.profile, a.opacity) == (b.profile, b.opacity)
}

fn render_tiles(stage: &Stage, memory: &mut [Vec<TileMemory>], radiance: &mut Radiance) {
    let stride = radiance.stride();
    let height = radiance.height();
    let [red, green, blue] = &mut radiance.planes;
    let band = stride * BLOCK;
    let bands = red.par_chunks_mut(band).zip(green.par_chunks_mut(band)).zip(blue.par_chunks_mut(band)).zip(memory);
    bands.enumerate().for_each(|(at, (((red, green), blue), memory))| {
        WORKSPACE.with_borrow_mut(|workspace| {
            render_band(stage, workspace, at * BLOCK, height, stride, [red, green, blue], memory);
        });
    });
}

fn render_band(
    stage: &Stage,
    workspace: &mut Workspace,
    top: usize,
    height: usize,
    stride: usize,
    mut planes: [&mut [f32]; 3],
    memory: &mut [TileMemory],
) {
    let bottom = (top + BLOCK).min(height);
    for left in (0..stage.scene.view.width).step_by(BLOCK) {
        workspace.enter_block(stage, left, top, BLOCK);
        for y in (top..bottom).step_by(TILE) {
            for x in (left..stride.min(left + BLOCK)).step_by(TILE) {
                let memory = &mut memory[(y - top) / TILE * (stride / TILE) + x / TILE];
                memory.fresh = workspace.differs(stage, x, y, memory);
                if !memory.fresh {
                    continue;
                }
                workspace.render(stage, x, y, memory);
                for (plane, tile) in planes.iter_mut().zip(&workspace.out) {
                    for (row, line) in tile.iter().enumerate().take(bottom - y) {
                        plane[(y - top + row) * stride + x..][..TILE].copy_from_slice(line);
                    }
                }
            }
        }
    }
}
