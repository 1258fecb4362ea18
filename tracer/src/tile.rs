//! One tile of the picture: what is seen at its pixels, and the light there.
//!
//! The highest top is looked at first, so that nothing is lit that is hidden. Lamps are the outer loop: what stands
//! between a lamp and the tile is found once, and serves the floor and every top in the tile.

use crate::albedo::Albedo;
use crate::candidates::{Candidates, Cone};
use crate::coverage::{Edge, Form};
use crate::irradiance::{Beam, DARKNESS, Light, Normals, light_floor, light_top};
use crate::lanes::{LANES, Lanes, Path, clamp, max};
use crate::memory::{Sight, TileMemory};
use crate::monte_carlo::Sampling;
use crate::obstruction::{Obstruction, Verdict};
use crate::points::{AREA, Plane, Points, TILE};
use crate::silhouette::Silhouettes;
use crate::visibility::{Intervals, Source, visible_fraction};
use crate::{Group, Lamp, Scene, monte_carlo};
use geometry::{Bounds, DVec2};

/// Below this much of a pixel, nobody sees it.
const UNSEEN: f32 = 1.0 / 1024.0;

/// Everything that the tiles of one picture have in common.
pub(crate) struct Stage<'a> {
    pub path: Path,
    pub scene: &'a Scene<'a>,
    pub silhouettes: &'a Silhouettes,
    /// The lamps that shine.
    pub lamps: &'a [Lit],
    /// Where tops have moved since the last picture.
    pub moved_tops: &'a [Bounds],
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
    near: Vec<Candidates>,
    is_near: Vec<bool>,
    moved: Vec<Candidates>,
    lit: Vec<usize>,
    pub(crate) forms: Vec<usize>,
    between: Obstruction,
    room: Intervals,
    fraction: Plane,
    /// Whether the floor's points are every pixel of the tile.
    pub(crate) whole: bool,
    pub(crate) floor: Points,
    pub(crate) floor_light: Light,
    pub(crate) tops: Vec<TopLayer>,
    edge: Edge,
    remaining: Plane,
    pub(crate) art: Albedo,
    pub(crate) printed: Albedo,
    /// The tile's radiance, when it is done.
    pub out: Light,
}

/// The part of one top that a tile shows.
pub(crate) struct TopLayer {
    pub form: usize,
    pub points: Points,
    pub coverage: Plane,
    pub normals: Normals,
    pub diffuse: Light,
    pub mirrored: Light,
    /// The art printed on it.
    pub print: Light,
}

impl TopLayer {
    fn new() -> TopLayer {
        let zero = [[0.0; LANES]; TILE];
        TopLayer {
            form: 0,
            points: Points::none(),
            coverage: zero,
            normals: Normals { x: zero, y: zero, z: zero },
            diffuse: DARKNESS,
            mirrored: DARKNESS,
            print: DARKNESS,
        }
    }
}

impl Workspace {
    /// Nothing yet.
    pub fn new() -> Workspace {
        let zero = [[0.0; LANES]; TILE];
        Workspace {
            block: (DVec2::ZERO, 0.0),
            near: Vec::new(),
            is_near: Vec::new(),
            moved: Vec::new(),
            lit: Vec::new(),
            forms: Vec::new(),
            between: Obstruction::default(),
            room: Intervals::default(),
            fraction: zero,
            whole: true,
            floor: Points::none(),
            floor_light: DARKNESS,
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
        let bounds = Bounds::of(middle, middle).grown(half + view.mm_per_px);
        self.forms.clear();
        let overlaps = |form: &Option<Form>| form.as_ref().is_some_and(|form| form.bounds.overlaps(&bounds));
        self.forms.extend((0..stage.forms.len()).filter(|&at| overlaps(&stage.forms[at])));
        self.block = (middle, half * std::f64::consts::SQRT_2);
        self.lit.clear();
        self.near.resize_with(stage.lamps.len(), Candidates::default);
        self.moved.resize_with(stage.lamps.len(), Candidates::default);
        self.is_near.clear();
        self.is_near.resize(stage.lamps.len(), false);
        for (at, Lit { lamp, moved, .. }) in stage.lamps.iter().enumerate() {
            let cone = Cone::new(lamp, middle, half * std::f64::consts::SQRT_2);
            if cone.beyond(lamp.reach_mm) {
                continue;
            }
            self.lit.push(at);
            self.moved[at].clear();
            if moved.len() > 0 {
                moved.narrow(stage.path, &cone, &mut self.moved[at], None);
            }
        }
    }

    /// Renders the tile whose upper left pixel is (`x`, `y`) into `out`.
    pub fn render(&mut self, stage: &Stage, x: usize, y: usize, memory: &mut TileMemory) {
        let view = &stage.scene.view;
        let half = DVec2::splat(TILE as f64 * 0.5);
        let middle = view.origin_mm + (DVec2::new(x as f64, y as f64) + half) * view.mm_per_px;
        let layers = self.find_surfaces(stage, middle);
        self.light_surfaces(stage, middle, layers, (x, y), memory);
        self.compose_floor(stage, x, y, middle);
        for layer in (0..layers).rev() {
            self.compose_top(stage, layer);
        }
    }

    /// Packs what is seen of every top, the highest first, and of the floor; says how many tops there are.
    fn find_surfaces(&mut self, stage: &Stage, middle: DVec2) -> usize {
        let mm_per_px = stage.scene.view.mm_per_px;
        let bounds = Bounds::of(middle, middle).grown((TILE as f64 * 0.5 + 1.0) * mm_per_px);
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
        self.floor_light = DARKNESS;
        for layer in &mut self.tops[..layers] {
            layer.diffuse = DARKNESS;
            layer.mirrored = DARKNESS;
        }
        let half = (TILE as f64 * 0.5 + 1.0) * stage.scene.view.mm_per_px;
        let bounds = Bounds::of(middle, middle).grown(half);
        if stage.moved_tops.iter().any(|moved| moved.overlaps(&bounds)) {
            memory.forget();
        }
        let radius = TILE as f64 * 0.5 * std::f64::consts::SQRT_2 * stage.scene.view.mm_per_px;
        for index in 0..self.lit.len() {
            let at = self.lit[index];
            let Lit { lamp, lost, number, .. } = &stage.lamps[at];
            let cone = Cone::new(lamp, middle, radius);
            if cone.beyond(lamp.reach_mm) {
                continue;
            }
            let sight = memory.sight(*number);
            let moved = &mut self.moved[at];
            sight.holds &= !lost && !moved.classified_any(stage.path, &cone) && stage.sampling.is_none();
            if !sight.holds {
                self.look(stage, at, &cone, middle, layers, corner, sight);
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

impl TopLayer {
    /// Packs the pixels that the outline covers and nothing above hides.
    fn pack(&mut self, edge: &Edge, bevel_mm: f32, opacity: f32, mm_per_px: f32, remaining: &mut Plane) {
        self.points.count = 0;
        let per_mm = 1.0 / mm_per_px;
        for row in 0..TILE {
            for i in 0..LANES {
                let distance = edge.distance[row][i];
                let coverage = clamp(0.5 - distance * per_mm, 0.0, 1.0) * opacity;
                let rest = remaining[row][i];
                if coverage * rest < UNSEEN {
                    continue;
                }
                remaining[row][i] = rest * (1.0 - coverage);
                let at = self.points.count;
                self.points.push_pixel(row * LANES + i, mm_per_px);
                let (block, lane) = (at / LANES, at % LANES);
                // A quarter of a circle: upright at the edge, level at the bevel's inner end.
                let lean = 0.96 * clamp(1.0 + distance / bevel_mm, 0.0, 1.0);
                self.coverage[block][lane] = coverage;
                self.normals.x[block][lane] = edge.away_x[row][i] * lean;
                self.normals.y[block][lane] = edge.away_y[row][i] * lean;
                self.normals.z[block][lane] = max(1.0 - lean * lean, 0.0).sqrt();
            }
        }
        self.points.pad();
    }
}

/// One lamp, looked at from one tile.
struct Gaze<'a, 'b> {
    stage: &'a Stage<'a>,
    near: &'b Candidates,
    lamp: &'a Lamp,
    middle: DVec2,
    corner: (usize, usize),
    between: &'b mut Obstruction,
    room: &'b mut Intervals,
    fraction: &'b mut Plane,
}

impl Gaze<'_, '_> {
    /// Finds how much of the lamp each point sees, past everything but one group.
    fn sees(&mut self, points: &Points, without: Option<Group>) -> Verdict {
        if let Some(sampling) = &self.stage.sampling {
            let at = monte_carlo::Place { middle_mm: self.middle, corner: self.corner };
            let occluders = &self.stage.scene.occluders;
            sampling.visible_fraction(occluders, self.lamp, points, at, without, self.fraction);
            return Verdict::Mixed;
        }
        let verdict = self.between.gather(self.near, self.stage.silhouettes, self.middle, without);
        if verdict == Verdict::Mixed {
            let from_tile = self.lamp.center_mm - self.middle;
            let source =
                Source { x: from_tile.x as f32, y: from_tile.y as f32, radius: self.lamp.radius_mm.max(0.0) as f32 };
            self.room.reserve(self.between.intervals());
            let Gaze { stage, between, room, fraction, .. } = self;
            visible_fraction(stage.path, points.blocks(), &points.x, &points.y, source, between, room, fraction);
        }
        verdict
    }
}

/// All of a lamp, for every point.
static ALL: Plane = [[1.0; LANES]; TILE];
