//! One tile of the picture: what is seen at its pixels, and the light there.
//!
//! The highest top is looked at first, so that nothing is lit that is hidden. Lamps are the outer loop: what stands
//! between a lamp and the tile is found once, and serves the floor and every top in the tile.

use crate::albedo::Albedo;
use crate::candidates::{Candidates, Cone};
use crate::changes::Changes;
use crate::coverage::{Edge, Form};
use crate::gaze::Gaze;
use crate::irradiance::{Beam, DARKNESS, Light, light_floor, light_top};
use crate::lanes::{LANES, Lanes, Path, clamp};
use crate::layer::{TopLayer, UNSEEN};
use crate::memory::{Sight, TileMemory};
use crate::monte_carlo::Sampling;
use crate::obstruction::{Obstruction, Verdict};
use crate::points::{AREA, Plane, Points, TILE};
use crate::silhouette::Silhouettes;
use crate::surfaces::{Surface, Surfaces};
use crate::visibility::Intervals;
use crate::{Lamp, Scene};
use geometry::{Bounds, DVec2};

/// Everything that the tiles of one picture have in common.
pub(crate) struct Stage<'a> {
    pub path: Path,
    pub scene: &'a Scene<'a>,
    pub silhouettes: &'a Silhouettes,
    /// The lamps that shine.
    pub lamps: &'a [Lit],
    /// Where tops have moved since the last picture.
    pub moved_tops: &'a [Bounds],
    /// What else is different from the last picture.
    pub changes: &'a Changes,
    /// The tops' outlines; `None` where there is nothing to see.
    pub forms: &'a [Option<Form>],
    /// Every pixel of a tile.
    pub whole_tile: &'a Points,
    /// How visibility is found: exactly, or by sampling.
    pub sampling: Option<Sampling>,
}

/// A lamp that shines.
pub(crate) struct Lit {
    /// The lamp.
    pub lamp: Lamp,
    /// What may stand in its way.
    pub candidates: Candidates,
    /// What has moved there since it was looked at last.
    pub moved: Candidates,
    /// Whether nothing is remembered of it.
    pub lost: bool,
    /// Its number in the tiles' memory.
    pub number: usize,
}

/// What a thread needs to render tiles; kept, so that nothing is allocated once it is warm.
pub(crate) struct Workspace {
    block: (DVec2, f64),
    /// Whether the block's own lists are made.
    entered: bool,
    near: Vec<Candidates>,
    is_near: Vec<bool>,
    moved: Vec<Candidates>,
    lit: Vec<usize>,
    /// The lamps before which something has moved.
    stirred: Vec<usize>,
    pub(crate) forms: Vec<usize>,
    between: Obstruction,
    room: Intervals,
    fraction: Plane,
    /// Whether the floor's points are every pixel of the tile.
    pub(crate) whole: bool,
    pub(crate) floor: Points,
    pub(crate) floor_light: Light,
    /// The floor's light at every pixel.
    pub(crate) spread: Light,
    pub(crate) tops: Vec<TopLayer>,
    edge: Edge,
    remaining: Plane,
    pub(crate) art: Albedo,
    pub(crate) printed: Albedo,
    /// The tile's radiance, when it is done.
    pub out: Light,
}

impl Workspace {
    /// Nothing yet.
    pub fn new() -> Workspace {
        let zero = [[0.0; LANES]; TILE];
        Workspace {
            block: (DVec2::ZERO, 0.0),
            entered: false,
            near: Vec::new(),
            is_near: Vec::new(),
            moved: Vec::new(),
            lit: Vec::new(),
            stirred: Vec::new(),
            forms: Vec::new(),
            between: Obstruction::default(),
            room: Intervals::default(),
            fraction: zero,
            whole: true,
            floor: Points::none(),
            floor_light: DARKNESS,
            spread: DARKNESS,
            tops: Vec::new(),
            edge: Edge::none(),
            remaining: zero,
            art: Albedo::none(),
            printed: Albedo::none(),
            out: DARKNESS,
        }
    }

    /// Makes ready for the tiles of a block of the screen, from (`x`, `y`) on, `side` pixels wide and high.
    pub fn enter_block(&mut self, stage: &Stage, x: usize, y: usize, side: usize) {
        let view = &stage.scene.view;
        let half = side as f64 * 0.5 * view.mm_per_px;
        let corner = view.origin_mm + DVec2::new(x as f64, y as f64) * view.mm_per_px;
        let middle = corner + DVec2::splat(half);
        self.block = (middle, half * std::f64::consts::SQRT_2);
        self.entered = false;
        self.moved.resize_with(stage.lamps.len(), Candidates::default);
        self.stirred.clear();
        for (at, Lit { lamp, moved, .. }) in stage.lamps.iter().enumerate() {
            if moved.len() == 0 {
                continue;
            }
            let cone = Cone::new(lamp, self.block.0, self.block.1);
            if !cone.beyond(lamp.reach_mm) {
                moved.narrow(stage.path, &cone, &mut self.moved[at], None);
                if self.moved[at].len() > 0 {
                    self.stirred.push(at);
                }
            }
        }
    }

    /// Finds what all tiles of the block that are drawn have in common.
    fn enter(&mut self, stage: &Stage) {
        self.entered = true;
        let (middle, radius) = self.block;
        let half = radius / std::f64::consts::SQRT_2;
        let bounds = Bounds::of(middle, middle).grown(half + 2.0 * stage.scene.view.mm_per_px);
        self.forms.clear();
        let overlaps = |form: &Option<Form>| form.as_ref().is_some_and(|form| form.bounds.overlaps(&bounds));
        self.forms.extend((0..stage.forms.len()).filter(|&at| overlaps(&stage.forms[at])));
        self.near.resize_with(stage.lamps.len(), Candidates::default);
        self.is_near.clear();
        self.is_near.resize(stage.lamps.len(), false);
        self.lit.clear();
        let reaches = |lit: &Lit| !Cone::new(&lit.lamp, middle, radius).beyond(lit.lamp.reach_mm);
        self.lit.extend((0..stage.lamps.len()).filter(|&at| reaches(&stage.lamps[at])));
    }

    /// Whether the tile whose upper left pixel is (`x`, `y`) may look different from the last picture's; forgets what
    /// was seen there and no longer holds.
    pub fn differs(&mut self, stage: &Stage, x: usize, y: usize, memory: &mut TileMemory) -> bool {
        let place = Place::new(stage, x, y);
        if stage.moved_tops.iter().any(|moved| moved.overlaps(&place.bounds)) {
            memory.forget();
        }
        let mm_per_px = stage.scene.view.mm_per_px;
        let radius = TILE as f64 * 0.5 * std::f64::consts::SQRT_2 * mm_per_px;
        let mut differs = false;
        for &at in &self.stirred {
            let Lit { lamp, number, .. } = &stage.lamps[at];
            let cone = Cone::new(lamp, place.middle_mm, radius);
            if !cone.beyond(lamp.reach_mm) && self.moved[at].classified_any(stage.path, &cone) {
                memory.sight(*number).holds = false;
                differs = true;
            }
        }
        differs || stage.changes.reach(&place, mm_per_px, memory)
    }

    /// Renders the tile whose upper left pixel is (`x`, `y`) into `out`.
    pub fn render(&mut self, stage: &Stage, x: usize, y: usize, memory: &mut TileMemory) {
        if !self.entered {
            self.enter(stage);
        }
        let place = Place::new(stage, x, y);
        let layers = if memory.surfaces.holds {
            self.recall_surfaces(stage, &memory.surfaces)
        } else {
            let layers = self.find_surfaces(stage, &place);
            self.keep_surfaces(layers, &mut memory.surfaces);
            layers
        };
        self.light_surfaces(stage, place.middle_mm, layers, (x, y), memory);
        self.compose_floor(stage, x, y, place.middle_mm, layers);
        for layer in (0..layers).rev() {
            self.compose_top(stage, layer);
        }
    }

    fn keep_surfaces(&self, layers: usize, kept: &mut Surfaces) {
        kept.holds = true;
        kept.whole = self.whole;
        kept.floor.clear();
        if !self.whole {
            kept.floor.extend_from_slice(&self.floor.pixel[..self.floor.count]);
        }
        kept.tops.clear();
        kept.tops.extend(self.tops[..layers].iter().map(Surface::new));
    }

    fn recall_surfaces(&mut self, stage: &Stage, kept: &Surfaces) -> usize {
        let mm_per_px = stage.scene.view.mm_per_px as f32;
        self.whole = kept.whole;
        if !self.whole {
            self.floor.take(&kept.floor, mm_per_px);
        }
        if self.tops.len() < kept.tops.len() {
            self.tops.resize_with(kept.tops.len(), TopLayer::new);
        }
        for (surface, layer) in kept.tops.iter().zip(&mut self.tops) {
            surface.unpack(mm_per_px, layer);
        }
        kept.tops.len()
    }

    /// Packs what is seen of every top, the highest first, and of the floor; says how many tops there are.
    fn find_surfaces(&mut self, stage: &Stage, place: &Place) -> usize {
        let mm_per_px = stage.scene.view.mm_per_px;
        let &Place { middle_mm: middle, bounds, .. } = place;
        self.remaining = [[1.0; LANES]; TILE];
        let mut layers = 0;
        for &at in self.forms.iter().rev() {
            let Some(form) = &stage.forms[at] else { continue };
            if !form.bounds.overlaps(&bounds) {
                continue;
            }
            form.measure(stage.path, stage.whole_tile, middle, mm_per_px, &mut self.edge);
            if self.tops.len() == layers {
                self.tops.push(TopLayer::new());
            }
            let layer = &mut self.tops[layers];
            layer.form = at;
            let opacity = clamp(stage.scene.tops[at].finish.opacity, 0.0, 1.0);
            layer.pack(&self.edge, form.bevel_mm(), opacity, mm_per_px as f32, &mut self.remaining);
            layers += usize::from(layer.points.count > 0);
        }
        let hides = |rest: &f32| u32::from(*rest < UNSEEN);
        let hidden = || self.remaining.iter().map(|row| row.iter().map(hides).sum::<u32>()).sum::<u32>();
        self.whole = layers == 0 || hidden() < AREA as u32 / 8;
        if !self.whole {
            self.floor.count = 0;
            for pixel in 0..AREA {
                if self.remaining[pixel / LANES][pixel % LANES] >= UNSEEN {
                    self.floor.push_pixel(pixel, mm_per_px as f32);
                }
            }
            self.floor.pad();
        }
        layers
    }

    fn light_surfaces(
        &mut self,
        stage: &Stage,
        middle: DVec2,
        layers: usize,
        corner: (usize, usize),
        memory: &mut TileMemory,
    ) {
        darken(&mut self.floor_light, if self.whole { TILE } else { self.floor.blocks() });
        for layer in &mut self.tops[..layers] {
            darken(&mut layer.diffuse, layer.points.blocks());
            darken(&mut layer.mirrored, layer.points.blocks());
        }
        let radius = TILE as f64 * 0.5 * std::f64::consts::SQRT_2 * stage.scene.view.mm_per_px;
        for index in 0..self.lit.len() {
            let at = self.lit[index];
            let Lit { lamp, lost, number, .. } = &stage.lamps[at];
            let reach = lamp.far_mm() + radius + 0.01;
            if lamp.center_mm.distance_squared(middle) > reach * reach {
                continue;
            }
            let sight = memory.sight(*number);
            sight.holds &= !lost;
            if !sight.holds || stage.sampling.is_some() {
                self.look(stage, at, &Cone::new(lamp, middle, radius), middle, layers, corner, sight);
            }
            let beam = Beam::new(lamp, middle);
            let fractions = |layer: usize, points: &Points, ones: &'static [Lanes; TILE]| match sight.layers[layer] {
                (Verdict::Dark, _) => None,
                (Verdict::Lit, _) => Some(&ones[..points.blocks()]),
                (Verdict::Mixed, from) => Some(&sight.fractions[from..from + points.blocks()]),
            };
            let floor = if self.whole { stage.whole_tile } else { &self.floor };
            if let Some(fraction) = fractions(0, floor, &ALL) {
                light_floor(stage.path, floor, beam, fraction, &mut self.floor_light);
            }
            for (at, layer) in self.tops[..layers].iter_mut().enumerate() {
                let TopLayer { points, normals, diffuse, mirrored, .. } = layer;
                if let Some(fraction) = fractions(at + 1, points, &ALL) {
                    light_top(stage.path, points, normals, beam, fraction, diffuse, mirrored);
                }
            }
        }
    }

    /// Finds how much of a lamp each point of each layer sees.
    #[allow(clippy::too_many_arguments)]
    fn look(
        &mut self,
        stage: &Stage,
        at: usize,
        cone: &Cone,
        middle: DVec2,
        layers: usize,
        corner: (usize, usize),
        sight: &mut Sight,
    ) {
        let Lit { lamp, candidates, .. } = &stage.lamps[at];
        let near = &mut self.near[at];
        if !self.is_near[at] {
            let around = Cone::new(lamp, self.block.0, self.block.1);
            candidates.narrow(stage.path, &around, near, Some((lamp, stage.silhouettes)));
            self.is_near[at] = true;
        }
        near.classify(stage.path, cone);
        sight.holds = true;
        sight.layers.clear();
        sight.fractions.clear();
        let mut gaze = Gaze {
            stage,
            near,
            lamp,
            middle,
            corner,
            between: &mut self.between,
            room: &mut self.room,
            fraction: &mut self.fraction,
        };
        let floor = (if self.whole { stage.whole_tile } else { &self.floor }, None);
        let tops = self.tops[..layers].iter().map(|top| (&top.points, Some(stage.scene.tops[top.form].group)));
        for (points, without) in std::iter::once(floor).chain(tops) {
            let verdict = if points.count == 0 { Verdict::Dark } else { gaze.sees(points, without) };
            sight.layers.push((verdict, sight.fractions.len()));
            if verdict == Verdict::Mixed {
                sight.fractions.extend_from_slice(&gaze.fraction[..points.blocks()]);
            }
        }
    }
}

/// Where a tile is.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Place {
    /// Its leftmost pixel.
    pub x: usize,
    /// Its topmost pixel.
    pub y: usize,
    /// Its middle on the table, mm.
    pub middle_mm: DVec2,
    /// A box around it, mm.
    pub bounds: Bounds,
}

impl Place {
    /// The tile whose upper left pixel is (`x`, `y`).
    fn new(stage: &Stage, x: usize, y: usize) -> Place {
        let view = &stage.scene.view;
        let half = TILE as f64 * 0.5;
        let middle_mm = view.origin_mm + (DVec2::new(x as f64, y as f64) + DVec2::splat(half)) * view.mm_per_px;
        Place { x, y, middle_mm, bounds: Bounds::of(middle_mm, middle_mm).grown((half + 1.0) * view.mm_per_px) }
    }
}

/// Makes the first blocks of a layer dark.
fn darken(light: &mut Light, blocks: usize) {
    for plane in light {
        plane[..blocks].fill([0.0; LANES]);
    }
}

/// All of a lamp, for every point.
static ALL: Plane = [[1.0; LANES]; TILE];
