//! One tile of the picture: what is seen at its pixels, and what each lamp's light makes of it.
//!
//! The highest top is looked at first, so that nothing is lit that is hidden. Lamps are the outer loop: what stands
//! between a lamp and the tile is found once, and serves the floor and every top in the tile.

use crate::albedo::{Albedo, Art};
use crate::candidates::{Candidates, Cone};
use crate::changes::{Changes, Nearby};
use crate::compose::has_contacts;
use crate::coverage::{Edge, Form};
use crate::falloff::Falloff;
use crate::gaze::Gaze;
use crate::irradiance::{DARKNESS, Light, Normals, Surface, light_floor, light_top};
use crate::lanes::{LANES, Lanes, Path, clamp};
use crate::layer::{TopLayer, UNSEEN};
use crate::memory::TileMemory;
use crate::monte_carlo::Sampling;
use crate::obstruction::{Obstruction, Verdict};
use crate::points::{AREA, Plane, Points, TILE};
use crate::renderer::BLOCK;
use crate::response::{combine, means_of};
use crate::silhouette::Silhouettes;
use crate::surfaces::Surfaces;
use crate::visibility::Intervals;
use crate::{Group, Lamp, Rgb, Scene, ball, filter};
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
    /// The floor's art.
    pub art: &'a Art,
    /// How visibility is found: exactly, or by sampling.
    pub sampling: Option<Sampling>,
}

impl Stage<'_> {
    /// The lamps that shine, by their numbers in the tiles' memory, with their colours.
    pub fn colors(&self) -> impl Iterator<Item = (usize, Rgb)> {
        self.lamps.iter().map(|lit| (lit.number, lit.lamp.color))
    }

    /// The inserts that glow, by their masks' places in memory, with their colours.
    pub fn glows(&self) -> impl Iterator<Item = ((usize, usize), Rgb)> {
        self.scene.glows.iter().map(|glow| (glow.mask.place(), glow.color))
    }
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

/// What a thread needs to make tiles; kept, so that nothing is allocated once it is warm.
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
    /// What else is different.
    nearby: Nearby,
    forms: Vec<usize>,
    between: Obstruction,
    room: Intervals,
    fraction: Plane,
    /// Whether the floor's points are every pixel of the tile.
    pub(crate) whole: bool,
    pub(crate) floor: Points,
    pub(crate) ground: Surface,
    pub(crate) tops: Vec<TopLayer>,
    edge: Edge,
    /// How much of each pixel is floor.
    pub(crate) remaining: Plane,
    /// The art of the floor, where its points are not every pixel; else that is in `ground`.
    pub(crate) art: Light,
    /// And which way it leans.
    pub(crate) normals: Normals,
    pub(crate) printed: Albedo,
    /// The light of one layer, packed.
    pub(crate) packed: Light,
    /// The tile in the light of one lamp.
    pub(crate) picture: Light,
    /// Room to sum up pictures with filters and without.
    sum: Light,
    /// The tile under all lamps, where that is what is made.
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
            nearby: Nearby::default(),
            forms: Vec::new(),
            between: Obstruction::default(),
            room: Intervals::default(),
            fraction: zero,
            whole: true,
            floor: Points::none(),
            ground: Surface::none(),
            tops: Vec::new(),
            edge: Edge::none(),
            remaining: zero,
            art: DARKNESS,
            normals: Normals::level(),
            printed: Albedo::none(),
            packed: DARKNESS,
            picture: DARKNESS,
            sum: DARKNESS,
            out: DARKNESS,
        }
    }

    /// Makes ready for the block of tiles that `place` is in, unless it is `last` and has been entered.
    pub fn enter_block_at(&mut self, stage: &Stage, place: &Place, last: &mut Option<(usize, usize)>) {
        let block = (place.x / BLOCK * BLOCK, place.y / BLOCK * BLOCK);
        if *last != Some(block) {
            *last = Some(block);
            self.enter_block(stage, block.0, block.1, BLOCK);
        }
    }

    /// Makes ready for the tiles of a block of the screen, from (`x`, `y`) on, `side` pixels wide and high.
    fn enter_block(&mut self, stage: &Stage, x: usize, y: usize, side: usize) {
        let view = &stage.scene.view;
        let half = side as f64 * 0.5 * view.mm_per_px;
        let corner = view.origin_mm + DVec2::new(x as f64, y as f64) * view.mm_per_px;
        let middle = corner + DVec2::splat(half);
        self.block = (middle, half * std::f64::consts::SQRT_2);
        self.entered = false;
        self.moved.resize_with(stage.lamps.len(), Candidates::default);
        self.stirred.clear();
        stage.changes.near(self.block.0, self.block.1, stage.moved_tops, &mut self.nearby);
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

    /// Finds what all tiles of the block that are made have in common.
    fn enter(&mut self, stage: &Stage) {
        if self.entered {
            return;
        }
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

    /// Whether the tile may look different from the last picture's; forgets what was seen there and no longer holds.
    pub fn differs(&mut self, stage: &Stage, place: &Place, memory: &mut TileMemory) -> bool {
        let mut differs = self.nearby.reach(place, memory) || stage.changes.everything;
        for &at in &self.stirred {
            let Lit { lamp, number, .. } = &stage.lamps[at];
            let sight = memory.sight(*number);
            // What one group hides stays hidden while that group stands still.
            let hidden = sight.hidden_by.is_some_and(|group| !self.moved[at].group.contains(&group));
            if !sight.holds || hidden || !place.is_reached(lamp) {
                continue;
            }
            let cone = Cone::new(lamp, place.middle_mm, place.radius_mm);
            if self.moved[at].classified_any(stage.path, &cone) {
                sight.holds = false;
                differs = true;
            }
        }
        differs
    }

    /// Makes anew what is not remembered of the tile.
    pub fn remember(&mut self, stage: &Stage, place: &Place, memory: &mut TileMemory) {
        self.enter(stage);
        let mut layers = None;
        if !memory.base.holds {
            let layers = *layers.get_or_insert_with(|| self.recall(stage, place, &mut memory.surfaces));
            self.light_from_everywhere(stage, layers);
            place.repeat_edges(&mut self.picture);
            memory.keep_base(stage.path, &self.picture);
        }
        for index in 0..self.lit.len() {
            let at = self.lit[index];
            let Lit { lamp, lost, number, .. } = &stage.lamps[at];
            let sight = memory.sight(*number);
            sight.holds &= !lost;
            if !sight.holds && place.is_reached(lamp) {
                let layers = *layers.get_or_insert_with(|| self.recall(stage, place, &mut memory.surfaces));
                if self.light(stage, at, place, layers) {
                    place.repeat_edges(&mut self.picture);
                    memory.keep(*number, stage.path, &self.picture);
                } else {
                    memory.keep_dark(*number, self.between.hidden_by.filter(|_| layers == 0));
                }
            }
        }
        for glow in stage.scene.glows.iter().filter(|glow| place.is_touched(glow.mask)) {
            if !memory.glow(glow.mask.place()).holds {
                layers.get_or_insert_with(|| self.recall(stage, place, &mut memory.surfaces));
                self.glow(place, glow.mask);
                place.repeat_edges(&mut self.picture);
                memory.keep_glow(glow.mask.place(), stage.path, &self.picture);
            }
        }
        memory.light(stage.path, stage.colors(), stage.glows());
        if has_contacts(stage, place) {
            self.compose(stage, place, memory, &[]);
            memory.means = means_of(&self.out);
        }
    }

    /// Puts together what a tile whose memory is true shows, with the balls over it, in [`Workspace::out`].
    pub fn compose(&mut self, stage: &Stage, place: &Place, memory: &TileMemory, balls: &[ball::Patch]) {
        let (base, lit) = memory.parts();
        if has_contacts(stage, place) {
            combine(stage.path, base, false, &mut self.out);
            self.shade_contacts(stage, place);
            combine(stage.path, lit, true, &mut self.out);
        } else {
            combine(stage.path, base.chain(lit), false, &mut self.out);
        }
        for ball in balls {
            ball.blend(place.x, place.y, &mut self.out);
        }
    }

    /// Makes the tile under all lamps, with nothing remembered and nothing rounded, in [`Workspace::out`].
    pub fn render(&mut self, stage: &Stage, place: &Place) {
        self.enter(stage);
        let layers = self.recall(stage, place, &mut Surfaces::default());
        self.light_from_everywhere(stage, layers);
        self.out = self.picture;
        self.shade_contacts(stage, place);
        for index in 0..self.lit.len() {
            let at = self.lit[index];
            let lamp = &stage.lamps[at].lamp;
            if place.is_reached(lamp) && self.light(stage, at, place, layers) {
                add(&self.picture, lamp.color, &mut self.out);
            }
        }
        for glow in stage.scene.glows.iter().filter(|glow| place.is_touched(glow.mask)) {
            self.glow(place, glow.mask);
            add(&self.picture, glow.color, &mut self.out);
        }
        place.repeat_edges(&mut self.out);
    }

    /// The tile's surfaces with their art, from memory if that holds; says how many tops there are.
    fn recall(&mut self, stage: &Stage, place: &Place, kept: &mut Surfaces) -> usize {
        if !kept.holds {
            let layers = self.find_surfaces(stage, place);
            self.keep_surfaces(layers, kept);
        }
        let mm_per_px = stage.scene.view.mm_per_px as f32;
        self.whole = kept.whole;
        if !self.whole {
            self.floor.take(&kept.floor, mm_per_px);
        }
        if kept.floor_weight.is_empty() {
            self.remaining = [[1.0; LANES]; TILE];
        } else {
            self.remaining.copy_from_slice(&kept.floor_weight);
        }
        let layers = kept.tops().len();
        if self.tops.len() < layers {
            self.tops.resize_with(layers, TopLayer::new);
        }
        for (patch, layer) in kept.tops().iter().zip(&mut self.tops) {
            patch.unpack(mm_per_px, layer);
        }
        self.read_art(stage, place, layers);
        layers
    }

    fn keep_surfaces(&self, layers: usize, kept: &mut Surfaces) {
        kept.holds = true;
        kept.whole = self.whole;
        kept.floor.clear();
        if !self.whole {
            kept.floor.extend_from_slice(&self.floor.pixel[..self.floor.count]);
        }
        kept.floor_weight.clear();
        if layers > 0 {
            kept.floor_weight.extend_from_slice(&self.remaining);
        }
        kept.keep_tops(&self.tops[..layers]);
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

    /// Puts the tile in the light of one lamp, of the colour white, into [`Workspace::picture`]; says whether there is
    /// any.
    fn light(&mut self, stage: &Stage, at: usize, place: &Place, layers: usize) -> bool {
        self.look_at(stage, at, place);
        let near = &self.near[at];
        let met = filter::met(&stage.scene.filters, |group| near.casts(group));
        if met.as_slice().is_empty() {
            return self.light_past(stage, at, place, layers, &[]);
        }
        let mut lit = false;
        self.sum = DARKNESS;
        filter::each_set(met.as_slice(), |away, part| {
            if part != [0.0; 3] && self.light_past(stage, at, place, layers, away) {
                lit = true;
                add(&self.picture, part, &mut self.sum);
            }
        });
        self.picture = self.sum;
        // What hides the lamp with every filter away is more than one group can be blamed for.
        self.between.hidden_by = None;
        lit
    }

    /// [`Workspace::light`], past everything but some groups.
    fn light_past(&mut self, stage: &Stage, at: usize, place: &Place, layers: usize, away: &[Group]) -> bool {
        let beam = Falloff::new(&stage.lamps[at].lamp, place.middle_mm);
        let mut lit = false;
        if self.whole || self.floor.count > 0 {
            let verdict = self.sees(stage, at, place, None, away);
            if verdict != Verdict::Dark {
                lit = true;
                let fraction = if verdict == Verdict::Lit { &ALL } else { &self.fraction };
                let (points, out) =
                    if self.whole { (stage.whole_tile, &mut self.picture) } else { (&self.floor, &mut self.packed) };
                light_floor(stage.path, points, &self.ground, beam, fraction, stage.scene.floor.gloss, out);
                if !self.whole {
                    self.picture = DARKNESS;
                    scatter(&self.floor, &self.packed, &mut self.picture);
                }
            }
        }
        for layer in 0..layers {
            let verdict = self.sees(stage, at, place, Some(layer), away);
            if verdict == Verdict::Dark {
                continue;
            }
            if !lit {
                lit = true;
                self.picture = DARKNESS;
            }
            let TopLayer { form, points, surface } = &self.tops[layer];
            let finish = &stage.scene.tops[*form].finish;
            let fraction = if verdict == Verdict::Lit { &ALL } else { &self.fraction };
            light_top(stage.path, points, surface, finish, beam, fraction, &mut self.packed);
            scatter(points, &self.packed, &mut self.picture);
        }
        lit
    }

    /// Finds what may stand between a lamp and the tile.
    fn look_at(&mut self, stage: &Stage, at: usize, place: &Place) {
        let Lit { lamp, candidates, .. } = &stage.lamps[at];
        let near = &mut self.near[at];
        if !self.is_near[at] {
            let around = Cone::new(lamp, self.block.0, self.block.1);
            candidates.narrow(stage.path, &around, near, Some((lamp, stage.silhouettes)));
            self.is_near[at] = true;
        }
        near.classify(stage.path, &Cone::new(lamp, place.middle_mm, place.radius_mm));
    }

    /// Finds how much of a lamp that was looked at each point of the floor or of a top sees, past everything but some
    /// groups and the top's own.
    fn sees(&mut self, stage: &Stage, at: usize, place: &Place, layer: Option<usize>, away: &[Group]) -> Verdict {
        let floor = if self.whole { stage.whole_tile } else { &self.floor };
        let mut without = [Group(0); filter::MOST + 1];
        without[..away.len()].copy_from_slice(away);
        let mut count = away.len();
        let points = layer.map_or(floor, |layer| {
            let TopLayer { form, points, .. } = &self.tops[layer];
            without[count] = stage.scene.tops[*form].group;
            count += 1;
            points
        });
        let mut gaze = Gaze {
            stage,
            near: &self.near[at],
            lamp: &stage.lamps[at].lamp,
            middle: place.middle_mm,
            corner: (place.x, place.y),
            between: &mut self.between,
            room: &mut self.room,
            fraction: &mut self.fraction,
        };
        gaze.sees(points, &without[..count])
    }
}

/// Adds a picture in light of a colour.
fn add(picture: &Light, color: Rgb, sum: &mut Light) {
    for ((sum, picture), color) in sum.iter_mut().zip(picture).zip(color) {
        for (sum, line) in sum.iter_mut().zip(picture) {
            for i in 0..LANES {
                sum[i] += line[i] * color;
            }
        }
    }
}

/// Adds the light of packed points to the pixels that they are.
pub(crate) fn scatter(points: &Points, packed: &Light, picture: &mut Light) {
    for (plane, packed) in picture.iter_mut().zip(packed) {
        for (at, &pixel) in points.pixel[..points.count].iter().enumerate() {
            let pixel = usize::from(pixel);
            plane[pixel / LANES][pixel % LANES] += packed[at / LANES][at % LANES];
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
    /// From there to its corners, mm.
    pub radius_mm: f64,
    /// A box around it, mm.
    pub bounds: Bounds,
    /// How many of its columns and rows are in the picture.
    pub inside: (usize, usize),
}

impl Place {
    /// The tile whose upper left pixel is (`x`, `y`).
    pub fn new(scene: &Scene, x: usize, y: usize) -> Place {
        let view = &scene.view;
        let half = TILE as f64 * 0.5;
        let middle_mm = view.origin_mm + (DVec2::new(x as f64, y as f64) + DVec2::splat(half)) * view.mm_per_px;
        let radius_mm = half * std::f64::consts::SQRT_2 * view.mm_per_px;
        let bounds = Bounds::of(middle_mm, middle_mm).grown((half + 1.0) * view.mm_per_px);
        Place { x, y, middle_mm, radius_mm, bounds, inside: (TILE.min(view.width - x), TILE.min(view.height - y)) }
    }

    /// Beyond the picture's edge a tile shows what is at the edge, so that the glare there is the picture's own.
    fn repeat_edges(&self, tile: &mut Light) {
        let (columns, rows) = self.inside;
        if (columns, rows) == (TILE, TILE) {
            return;
        }
        for plane in tile {
            for row in 0..TILE {
                plane[row] = plane[row.min(rows - 1)];
                let last = plane[row][columns - 1];
                plane[row][columns..].fill(last);
            }
        }
    }

    /// Whether a lamp's light may come here.
    fn is_reached(&self, lamp: &Lamp) -> bool {
        let reach = lamp.far_mm() + self.radius_mm + 0.01;
        lamp.center_mm.distance_squared(self.middle_mm) <= reach * reach
    }

    /// Whether a mask covers any of the tile's pixels.
    pub fn is_touched(&self, mask: &crate::Mask) -> bool {
        let (right, bottom) = (mask.x + mask.width, mask.y + mask.height());
        mask.x < self.x + TILE && right > self.x && mask.y < self.y + TILE && bottom > self.y
    }
}

/// All of a lamp, for every point.
static ALL: [Lanes; TILE] = [[1.0; LANES]; TILE];
