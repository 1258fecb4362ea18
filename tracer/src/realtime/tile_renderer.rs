//! One tile of the picture: what of its memory does not hold any more is made anew, lamp by lamp, and put together.
//!
//! Lamps are the outer loop: what stands between a lamp and the tile is found once, and serves the floor and every top
//! in the tile.

use crate::cache::cell_means::{CELLS_PER_TILE, Means, means_of};
use crate::cache::damage::{Changes, DAMAGE_MARGIN_MM, Nearby, is_near};
use crate::cache::g_buffer::Surfaces;
use crate::cache::lamp_layer::{Bare, Part};
use crate::cache::lamp_set::Numbers;
use crate::cache::tile_cache::{Illumination, TileMemory};
use crate::cache::top_history::TopHistory;
use crate::realtime::compose::{has_contacts, shade_contacts};
use crate::realtime::direct_light::{Lighted, add};
use crate::realtime::schedule::BLOCK;
use crate::scene::GlowKey;
use crate::shading::albedo_map::{Albedo, AlbedoMap};
use crate::shading::chrome_ball;
use crate::shading::coverage::SignedDistance;
use crate::shading::surface::{Normals, Surface};
use crate::shading::top_layer::TopLayer;
use crate::simd::dispatch::{LANES, SimdLevel};
use crate::tile::packed_samples::PackedSamples;
use crate::tile::planes::{ALL_ROWS, BLACK, FULLY_VISIBLE, Plane, RgbTile, TILE};
use crate::tile::rect::TileRect;
use crate::visibility::airborne_shadow::AirborneShadow;
use crate::visibility::blockers::{Blockers, VisibilityClass};
use crate::visibility::disc_chain::DiscChains;
use crate::visibility::fraction::IntervalScratch;
use crate::visibility::potential_occluders::PotentialOccluders;
use crate::visibility::shadow_bounds::ShadowBounds;
use crate::visibility::transmission::TintedGroup;
use crate::{Lamp, Rgb, Scene};
use geometry::{Bounds, DVec2};

/// Everything that the tiles of one picture have in common.
pub(crate) struct Stage<'a> {
    pub simd: SimdLevel,
    pub scene: &'a Scene<'a>,
    pub disc_chains: &'a DiscChains,
    /// The lamps that shine.
    pub lamps: &'a [Lit],
    /// The light of each lamp that is remembered, and its place among those that shine, by its number.
    pub colors: &'a [Rgb],
    pub places: &'a [usize],
    /// The lamps of which nothing is remembered.
    pub lost: &'a Numbers,
    /// Where tops have moved since the last picture.
    pub moved_tops: &'a [Bounds],
    /// What else is different from the last picture.
    pub changes: &'a Changes,
    /// The groups that light passes, tinted.
    pub tinted: &'a [TintedGroup],
    /// The tops and their outlines.
    pub tops: &'a TopHistory,
    /// Every pixel of a tile.
    pub full_tile: &'a PackedSamples,
    /// The floor's art.
    pub art: &'a AlbedoMap,
}

impl Stage<'_> {
    /// The inserts that glow, with their colours.
    pub fn glows(&self) -> impl Iterator<Item = (GlowKey, Rgb)> + Clone {
        self.scene.glows.iter().map(|glow| (glow.key(), glow.color))
    }
}

/// A lamp that shines.
pub(crate) struct Lit {
    /// The lamp.
    pub lamp: Lamp,
    /// Where its light ends: the middle and the radius of a circle, mm.
    pub circle: (DVec2, f64),
    /// What may stand in its way.
    pub potential_occluders: PotentialOccluders,
    /// The balls in the air that may hide it.
    pub airborne: Vec<AirborneShadow>,
    /// What has moved since it was looked at last.
    pub things: DiscChains,
    /// Where the shadows of these may fall.
    pub moved: Vec<ShadowBounds>,
    /// Whether nothing is remembered of it.
    pub lost: bool,
    /// Its number in the tiles' memory.
    pub number: usize,
}

impl Lit {
    /// A lamp of which nothing else is known.
    pub fn new(lamp: &Lamp, number: usize) -> Lit {
        let (potential_occluders, things) = (PotentialOccluders::default(), DiscChains::default());
        let circle = (lamp.center_mm, lamp.far_mm());
        Lit {
            lamp: *lamp,
            circle,
            potential_occluders,
            airborne: Vec::new(),
            things,
            moved: Vec::new(),
            lost: true,
            number,
        }
    }
}

/// What a thread needs to make tiles; kept, so that nothing is allocated once it is warm.
pub(crate) struct Workspace {
    pub(crate) block: (DVec2, f64),
    /// Whether the block's own lists are made.
    entered: bool,
    pub(crate) near: Vec<PotentialOccluders>,
    pub(crate) is_near: Vec<bool>,
    moved: Vec<Vec<ShadowBounds>>,
    /// The lamps that reach the block: their places in the list, and their numbers.
    lit: Vec<usize>,
    reaching: Numbers,
    /// Those that have to be looked at from a tile.
    to_make: Vec<usize>,
    /// What a tile is put together of.
    parts: Vec<Part>,
    /// The lamps before which something has moved.
    stirred: Vec<usize>,
    /// What else is different.
    nearby: Nearby,
    pub(crate) forms: Vec<usize>,
    pub(crate) blockers: Blockers,
    pub(crate) intervals: IntervalScratch,
    pub(crate) fraction: Plane,
    /// Whether the floor's points are every pixel of the tile.
    pub(crate) whole: bool,
    pub(crate) floor: PackedSamples,
    pub(crate) ground: Surface,
    pub(crate) tops: Vec<TopLayer>,
    pub(crate) edge: SignedDistance,
    /// How much of each pixel is floor.
    pub(crate) remaining: Plane,
    /// The art of the floor, where its points are not every pixel; else that is in `ground`.
    pub(crate) art: RgbTile,
    /// And which way it leans.
    pub(crate) normals: Normals,
    pub(crate) printed: Albedo,
    /// The light of one layer, packed.
    pub(crate) packed: RgbTile,
    /// What arrives at the floor's points of one lamp's light, and what shines there.
    pub(crate) irradiance: Plane,
    pub(crate) specular: Plane,
    /// The tile in the light of one lamp.
    pub(crate) picture: RgbTile,
    /// Room to sum up pictures with tinted groups and without.
    pub(crate) sum: RgbTile,
    /// What the bloom needs of the tile.
    pub means: Means,
    /// The tile under all lamps, where that is what is made.
    pub out: RgbTile,
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
            reaching: Numbers::default(),
            to_make: Vec::new(),
            parts: Vec::new(),
            stirred: Vec::new(),
            nearby: Nearby::default(),
            forms: Vec::new(),
            blockers: Blockers::default(),
            intervals: IntervalScratch::default(),
            fraction: zero,
            whole: true,
            floor: PackedSamples::none(),
            ground: Surface::none(),
            tops: Vec::new(),
            edge: SignedDistance::none(),
            remaining: zero,
            art: BLACK,
            normals: Normals::flat(),
            printed: Albedo::none(),
            packed: BLACK,
            irradiance: zero,
            specular: zero,
            picture: BLACK,
            sum: BLACK,
            means: [[0.0; CELLS_PER_TILE]; 3],
            out: BLACK,
        }
    }

    /// Makes ready for the block of tiles that `rect` is in, unless it is `last` and has been entered.
    pub fn enter_block_at(&mut self, stage: &Stage, rect: &TileRect, last: &mut Option<(usize, usize)>) {
        let block = (rect.x / BLOCK * BLOCK, rect.y / BLOCK * BLOCK);
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
        // Never shorter: other renderers share the thread, and what they have grown is not given back.
        self.moved.resize_with(stage.lamps.len().max(self.moved.len()), Vec::new);
        self.stirred.clear();
        stage.changes.near(self.block.0, self.block.1, stage.moved_tops, &mut self.nearby);
        for (at, Lit { circle, moved, .. }) in stage.lamps.iter().enumerate() {
            if moved.is_empty() || !is_near(circle, middle, self.block.1) {
                continue;
            }
            self.moved[at].clear();
            self.moved[at].extend(moved.iter().filter(|bounds| bounds.may_reach(middle, half)));
            if !self.moved[at].is_empty() {
                self.stirred.push(at);
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
        let overlaps = |&slot: &usize| stage.tops.outline(slot).is_some_and(|outline| outline.bounds.overlaps(&bounds));
        self.forms.extend(stage.tops.order().iter().copied().filter(overlaps));
        self.near.resize_with(stage.lamps.len().max(self.near.len()), PotentialOccluders::default);
        self.is_near.clear();
        self.is_near.resize(stage.lamps.len(), false);
        self.lit.clear();
        let reaches = |lit: &Lit| is_near(&lit.circle, middle, radius + DAMAGE_MARGIN_MM);
        self.lit.extend((0..stage.lamps.len()).filter(|&at| reaches(&stage.lamps[at])));
        self.reaching = Numbers::default();
        self.lit.iter().for_each(|&at| self.reaching.insert(stage.lamps[at].number));
    }

    /// Whether the tile may look different from the last picture's; forgets what was seen there and no longer holds.
    pub fn differs(&mut self, stage: &Stage, rect: &TileRect, memory: &mut TileMemory) -> bool {
        let mut differs = self.nearby.reach(rect, memory) || stage.changes.everything;
        for &at in &self.stirred {
            let Lit { lamp, number, .. } = &stage.lamps[at];
            let (sight, moved) = (*memory.sight(*number), &self.moved[at]);
            // What one group hides stays hidden while that group stands still.
            let hidden = sight.hidden_by.is_some_and(|group| moved.iter().all(|bounds| bounds.group != group));
            if !sight.holds || hidden || !rect.is_reached_by(lamp) {
                continue;
            }
            let reaching = moved.iter().filter(|bounds| bounds.may_reach(rect.middle_mm, rect.half_mm));
            let rows = reaching.fold(0, |rows, bounds| rows | bounds.rows(rect, stage.scene.view.mm_per_px));
            memory.stir(*number, rows);
            differs |= !sight.is_whole() || rows != 0;
        }
        differs
    }

    /// Makes anew what is not remembered of the tile, and its means, in [`Workspace::means`].
    pub fn remember(&mut self, stage: &Stage, rect: &TileRect, memory: &mut TileMemory) {
        self.enter(stage);
        let mut layers = None;
        if !memory.base.holds {
            let layers = *layers.get_or_insert_with(|| self.recall(stage, rect, &mut memory.surfaces));
            if layers == 0 {
                memory.keep_floor_base(stage.simd, &self.ground.albedo);
            } else {
                self.light_from_everywhere(stage, layers);
                rect.clamp_to_edge(&mut self.picture.each_mut());
                memory.keep_base(stage.simd, &self.picture);
            }
        }
        self.to_make.clear();
        self.to_make.extend(memory.to_make(&self.reaching, stage.lost));
        for index in 0..self.to_make.len() {
            let at = stage.places[self.to_make[index]];
            self.remember_lamp(stage, at, rect, memory, &mut layers);
        }
        for glow in stage.scene.glows.iter().filter(|glow| rect.overlaps_mask(glow.mask)) {
            if !memory.glow(glow.key()).holds {
                layers.get_or_insert_with(|| self.recall(stage, rect, &mut memory.surfaces));
                self.glow(rect, glow.mask);
                rect.clamp_to_edge(&mut self.picture.each_mut());
                memory.keep_glow(glow.key(), stage.simd, &self.picture);
            }
        }
        let shaded = has_contacts(stage, rect);
        let light = Illumination { ambient: stage.scene.ambient, shaded, lamps: stage.colors };
        memory.light(stage.simd, &light, stage.glows(), &mut self.parts, &mut self.means);
        if shaded {
            self.compose(stage, rect, memory, &[]);
            means_of(stage.simd, &self.out, &mut self.means);
        }
    }

    /// Makes anew what is not remembered of the tile in the light of one lamp; `layers`, once the surfaces are recalled,
    /// is how many tops there are.
    fn remember_lamp(
        &mut self,
        stage: &Stage,
        at: usize,
        rect: &TileRect,
        memory: &mut TileMemory,
        layers: &mut Option<usize>,
    ) {
        let &Lit { ref lamp, lost, number, .. } = &stage.lamps[at];
        let sight = memory.sight(number);
        sight.holds &= !lost;
        let mut rows = sight.rows_to_make();
        if !rect.is_reached_by(lamp) {
            return memory.keep_dark(number, None);
        }
        if !rect.is_unclipped() {
            // Beyond the picture's edge rows are repeated.
            rows = ALL_ROWS;
        }
        let layers = *layers.get_or_insert_with(|| self.recall(stage, rect, &mut memory.surfaces));
        let mut lighted = self.light(stage, at, rect, layers, rows);
        let colors = lighted == Lighted::Colors;
        let another = lighted != Lighted::Dark && memory.is_another(number, colors);
        if another && rows != ALL_ROWS {
            rows = ALL_ROWS;
            lighted = self.light(stage, at, rect, layers, rows);
        }
        if colors && (another || !memory.sight(number).gauged) {
            memory.gauge(number, self.gauge(stage, at, rect, layers));
        }
        match lighted {
            Lighted::Dark => {
                let alone = memory.surfaces.tops().is_empty();
                memory.keep_dark(number, self.blockers.hidden_by.filter(|_| alone));
            }
            Lighted::Floor(verdict) => {
                let Workspace { irradiance, specular, fraction, ground, .. } = self;
                rect.clamp_to_edge(&mut [&mut *irradiance, specular, fraction]);
                let seen = if verdict == VisibilityClass::Lit { &FULLY_VISIBLE } else { &*fraction };
                let floor = Bare { albedo: &ground.albedo, irradiance, specular, seen };
                memory.keep_floor(number, stage.simd, &floor, rows);
            }
            Lighted::Colors => {
                rect.clamp_to_edge(&mut self.picture.each_mut());
                memory.keep(number, stage.simd, &self.picture, rows);
            }
        }
    }

    /// Puts together what a tile whose memory is true shows, with the balls over it, in [`Workspace::out`].
    pub fn compose(&mut self, stage: &Stage, rect: &TileRect, memory: &TileMemory, balls: &[chrome_ball::BallSprite]) {
        let paint = stage.art.tile(rect.x, rect.y);
        let shade = has_contacts(stage, rect).then_some(|out: &mut RgbTile| shade_contacts(stage, rect, out));
        memory.compose(stage.simd, paint, shade, &mut self.out);
        for ball in balls {
            ball.blend(rect.x, rect.y, &mut self.out);
        }
    }

    /// Makes the tile under all lamps, with nothing remembered and nothing rounded, in [`Workspace::out`].
    pub fn render(&mut self, stage: &Stage, rect: &TileRect) {
        let layers = self.render_unlit(stage, rect);
        for index in 0..self.lit.len() {
            let at = self.lit[index];
            let lamp = &stage.lamps[at].lamp;
            if !rect.is_reached_by(lamp) {
                continue;
            }
            match self.light(stage, at, rect, layers, ALL_ROWS) {
                Lighted::Dark => continue,
                Lighted::Floor(verdict) => {
                    self.veil(stage.simd, verdict, ALL_ROWS);
                    self.picture = BLACK;
                    self.paint(stage.simd, ALL_ROWS);
                }
                Lighted::Colors => {}
            }
            add(&self.picture, lamp.color, &mut self.out);
        }
        self.render_glows(stage, rect);
    }

    /// Makes the tile in the light from everywhere, in [`Workspace::out`]; says how many tops there are.
    pub fn render_unlit(&mut self, stage: &Stage, rect: &TileRect) -> usize {
        self.enter(stage);
        let layers = self.recall(stage, rect, &mut Surfaces::default());
        self.light_from_everywhere(stage, layers);
        self.out = self.picture;
        shade_contacts(stage, rect, &mut self.out);
        layers
    }

    /// Adds the light of inserts to [`Workspace::out`], which is complete with them.
    pub fn render_glows(&mut self, stage: &Stage, rect: &TileRect) {
        for glow in stage.scene.glows.iter().filter(|glow| rect.overlaps_mask(glow.mask)) {
            self.glow(rect, glow.mask);
            add(&self.picture, glow.color, &mut self.out);
        }
        rect.clamp_to_edge(&mut self.out.each_mut());
    }
}
