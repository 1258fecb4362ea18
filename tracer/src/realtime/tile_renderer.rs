//! One tile of the picture: what of its memory does not hold any more is made anew, lamp by lamp, and put together.
//!
//! Lamps are the outer loop: what stands between a lamp and the tile is found once, and serves the floor and every top
//! in the tile.

use crate::cache::cell_means::{CELLS, Means, means_of};
use crate::cache::damage::{Changes, MARGIN_MM, Nearby, is_near};
use crate::cache::g_buffer::Surfaces;
use crate::cache::lamp_layer::{Bare, Part};
use crate::cache::lamp_set::Numbers;
use crate::cache::tile_cache::{Illumination, TileMemory};
use crate::realtime::compose::{has_contacts, shade_contacts};
use crate::realtime::direct_light::{ALL, Lighted, add};
use crate::realtime::schedule::BLOCK;
use crate::shading::albedo_map::{Albedo, Art};
use crate::shading::chrome_ball;
use crate::shading::coverage::{Edge, Form};
use crate::shading::surface::{DARKNESS, Light, Normals, Surface};
use crate::shading::top_layer::TopLayer;
use crate::simd::dispatch::{LANES, Path};
use crate::tile::packed_samples::{Plane, Points, TILE};
use crate::tile::rect::Place;
use crate::visibility::airborne_shadow::Floating;
use crate::visibility::blockers::{Obstruction, Verdict};
use crate::visibility::disc_chain::Silhouettes;
use crate::visibility::fraction::Intervals;
use crate::visibility::potential_occluders::Candidates;
use crate::visibility::shadow_bounds::{ALL_ROWS, Penumbra};
use crate::{Lamp, Rgb, Scene};
use geometry::{Bounds, DVec2};

/// Everything that the tiles of one picture have in common.
pub(crate) struct Stage<'a> {
    pub path: Path,
    pub scene: &'a Scene<'a>,
    pub silhouettes: &'a Silhouettes,
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
    /// The tops' outlines; `None` where there is nothing to see.
    pub forms: &'a [Option<Form>],
    /// Every pixel of a tile.
    pub whole_tile: &'a Points,
    /// The floor's art.
    pub art: &'a Art,
}

impl Stage<'_> {
    /// The inserts that glow, by their masks' places in memory, with their colours.
    pub fn glows(&self) -> impl Iterator<Item = ((usize, usize), Rgb)> + Clone {
        self.scene.glows.iter().map(|glow| (glow.mask.place(), glow.color))
    }
}

/// A lamp that shines.
pub(crate) struct Lit {
    /// The lamp.
    pub lamp: Lamp,
    /// Where its light ends: the middle and the radius of a circle, mm.
    pub circle: (DVec2, f64),
    /// What may stand in its way.
    pub candidates: Candidates,
    /// The balls in the air that may hide it.
    pub floating: Vec<Floating>,
    /// What has moved since it was looked at last.
    pub things: Silhouettes,
    /// Where the shadows of these may fall.
    pub moved: Vec<Penumbra>,
    /// Whether nothing is remembered of it.
    pub lost: bool,
    /// Its number in the tiles' memory.
    pub number: usize,
}

impl Lit {
    /// A lamp of which nothing else is known.
    pub fn new(lamp: &Lamp, number: usize) -> Lit {
        let (candidates, things) = (Candidates::default(), Silhouettes::default());
        let circle = (lamp.center_mm, lamp.far_mm());
        Lit { lamp: *lamp, circle, candidates, floating: Vec::new(), things, moved: Vec::new(), lost: true, number }
    }
}

/// What a thread needs to make tiles; kept, so that nothing is allocated once it is warm.
pub(crate) struct Workspace {
    pub(crate) block: (DVec2, f64),
    /// Whether the block's own lists are made.
    entered: bool,
    pub(crate) near: Vec<Candidates>,
    pub(crate) is_near: Vec<bool>,
    moved: Vec<Vec<Penumbra>>,
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
    pub(crate) between: Obstruction,
    pub(crate) room: Intervals,
    pub(crate) fraction: Plane,
    /// Whether the floor's points are every pixel of the tile.
    pub(crate) whole: bool,
    pub(crate) floor: Points,
    pub(crate) ground: Surface,
    pub(crate) tops: Vec<TopLayer>,
    pub(crate) edge: Edge,
    /// How much of each pixel is floor.
    pub(crate) remaining: Plane,
    /// The art of the floor, where its points are not every pixel; else that is in `ground`.
    pub(crate) art: Light,
    /// And which way it leans.
    pub(crate) normals: Normals,
    pub(crate) printed: Albedo,
    /// The light of one layer, packed.
    pub(crate) packed: Light,
    /// What arrives at the floor's points of one lamp's light, and what shines there.
    pub(crate) arriving: Plane,
    pub(crate) shine: Plane,
    /// The tile in the light of one lamp.
    pub(crate) picture: Light,
    /// Room to sum up pictures with filters and without.
    pub(crate) sum: Light,
    /// What the glare needs of the tile.
    pub means: Means,
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
            reaching: Numbers::default(),
            to_make: Vec::new(),
            parts: Vec::new(),
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
            arriving: zero,
            shine: zero,
            picture: DARKNESS,
            sum: DARKNESS,
            means: [[0.0; CELLS]; 3],
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
        self.moved.resize_with(stage.lamps.len(), Vec::new);
        self.stirred.clear();
        stage.changes.near(self.block.0, self.block.1, stage.moved_tops, &mut self.nearby);
        for (at, Lit { circle, moved, .. }) in stage.lamps.iter().enumerate() {
            if moved.is_empty() || !is_near(circle, middle, self.block.1) {
                continue;
            }
            self.moved[at].clear();
            self.moved[at].extend(moved.iter().filter(|penumbra| penumbra.may_reach(middle, half)));
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
        let overlaps = |form: &Option<Form>| form.as_ref().is_some_and(|form| form.bounds.overlaps(&bounds));
        self.forms.extend((0..stage.forms.len()).filter(|&at| overlaps(&stage.forms[at])));
        self.near.resize_with(stage.lamps.len(), Candidates::default);
        self.is_near.clear();
        self.is_near.resize(stage.lamps.len(), false);
        self.lit.clear();
        let reaches = |lit: &Lit| is_near(&lit.circle, middle, radius + MARGIN_MM);
        self.lit.extend((0..stage.lamps.len()).filter(|&at| reaches(&stage.lamps[at])));
        self.reaching = Numbers::default();
        self.lit.iter().for_each(|&at| self.reaching.insert(stage.lamps[at].number));
    }

    /// Whether the tile may look different from the last picture's; forgets what was seen there and no longer holds.
    pub fn differs(&mut self, stage: &Stage, place: &Place, memory: &mut TileMemory) -> bool {
        let mut differs = self.nearby.reach(place, memory) || stage.changes.everything;
        for &at in &self.stirred {
            let Lit { lamp, number, .. } = &stage.lamps[at];
            let (sight, moved) = (*memory.sight(*number), &self.moved[at]);
            // What one group hides stays hidden while that group stands still.
            let hidden = sight.hidden_by.is_some_and(|group| moved.iter().all(|penumbra| penumbra.group != group));
            if !sight.holds || hidden || !place.is_reached(lamp) {
                continue;
            }
            let reaching = moved.iter().filter(|penumbra| penumbra.may_reach(place.middle_mm, place.half_mm));
            let rows = reaching.fold(0, |rows, penumbra| rows | penumbra.rows(place, stage.scene.view.mm_per_px));
            memory.stir(*number, rows);
            differs |= !sight.is_whole() || rows != 0;
        }
        differs
    }

    /// Makes anew what is not remembered of the tile, and its means, in [`Workspace::means`].
    pub fn remember(&mut self, stage: &Stage, place: &Place, memory: &mut TileMemory) {
        self.enter(stage);
        let mut layers = None;
        if !memory.base.holds {
            let layers = *layers.get_or_insert_with(|| self.recall(stage, place, &mut memory.surfaces));
            if layers == 0 {
                memory.keep_floor_base(stage.path, &self.ground.albedo);
            } else {
                self.light_from_everywhere(stage, layers);
                place.repeat_edges(&mut self.picture.each_mut());
                memory.keep_base(stage.path, &self.picture);
            }
        }
        self.to_make.clear();
        self.to_make.extend(memory.to_make(&self.reaching, stage.lost));
        for index in 0..self.to_make.len() {
            let at = stage.places[self.to_make[index]];
            self.remember_lamp(stage, at, place, memory, &mut layers);
        }
        for glow in stage.scene.glows.iter().filter(|glow| place.is_touched(glow.mask)) {
            if !memory.glow(glow.mask.place()).holds {
                layers.get_or_insert_with(|| self.recall(stage, place, &mut memory.surfaces));
                self.glow(place, glow.mask);
                place.repeat_edges(&mut self.picture.each_mut());
                memory.keep_glow(glow.mask.place(), stage.path, &self.picture);
            }
        }
        let shaded = has_contacts(stage, place);
        let light = Illumination { ambient: stage.scene.ambient, shaded, lamps: stage.colors };
        memory.light(stage.path, &light, stage.glows(), &mut self.parts, &mut self.means);
        if shaded {
            self.compose(stage, place, memory, &[]);
            means_of(stage.path, &self.out, &mut self.means);
        }
    }

    /// Makes anew what is not remembered of the tile in the light of one lamp; `layers`, once the surfaces are recalled,
    /// is how many tops there are.
    fn remember_lamp(
        &mut self,
        stage: &Stage,
        at: usize,
        place: &Place,
        memory: &mut TileMemory,
        layers: &mut Option<usize>,
    ) {
        let &Lit { ref lamp, lost, number, .. } = &stage.lamps[at];
        let sight = memory.sight(number);
        sight.holds &= !lost;
        let mut rows = sight.rows_to_make();
        if !place.is_reached(lamp) {
            return memory.keep_dark(number, None);
        }
        if !place.is_whole() {
            // Beyond the picture's edge rows are repeated.
            rows = ALL_ROWS;
        }
        let layers = *layers.get_or_insert_with(|| self.recall(stage, place, &mut memory.surfaces));
        let mut lighted = self.light(stage, at, place, layers, rows);
        let colors = lighted == Lighted::Colors;
        let another = lighted != Lighted::Dark && memory.is_another(number, colors);
        if another && rows != ALL_ROWS {
            rows = ALL_ROWS;
            lighted = self.light(stage, at, place, layers, rows);
        }
        if colors && (another || !memory.sight(number).gauged) {
            memory.gauge(number, self.gauge(stage, at, place, layers));
        }
        match lighted {
            Lighted::Dark => {
                let alone = memory.surfaces.tops().is_empty();
                memory.keep_dark(number, self.between.hidden_by.filter(|_| alone));
            }
            Lighted::Floor(verdict) => {
                let Workspace { arriving, shine, fraction, ground, .. } = self;
                place.repeat_edges(&mut [&mut *arriving, shine, fraction]);
                let seen = if verdict == Verdict::Lit { &ALL } else { &*fraction };
                let floor = Bare { albedo: &ground.albedo, arriving, shine, seen };
                memory.keep_floor(number, stage.path, &floor, rows);
            }
            Lighted::Colors => {
                place.repeat_edges(&mut self.picture.each_mut());
                memory.keep(number, stage.path, &self.picture, rows);
            }
        }
    }

    /// Puts together what a tile whose memory is true shows, with the balls over it, in [`Workspace::out`].
    pub fn compose(&mut self, stage: &Stage, place: &Place, memory: &TileMemory, balls: &[chrome_ball::Patch]) {
        let paint = stage.art.paint(place.x, place.y);
        let shade = has_contacts(stage, place).then_some(|out: &mut Light| shade_contacts(stage, place, out));
        memory.compose(stage.path, paint, shade, &mut self.out);
        for ball in balls {
            ball.blend(place.x, place.y, &mut self.out);
        }
    }

    /// Makes the tile under all lamps, with nothing remembered and nothing rounded, in [`Workspace::out`].
    pub fn render(&mut self, stage: &Stage, place: &Place) {
        let layers = self.render_unlit(stage, place);
        for index in 0..self.lit.len() {
            let at = self.lit[index];
            let lamp = &stage.lamps[at].lamp;
            if !place.is_reached(lamp) {
                continue;
            }
            match self.light(stage, at, place, layers, ALL_ROWS) {
                Lighted::Dark => continue,
                Lighted::Floor(verdict) => {
                    self.veil(stage.path, verdict, ALL_ROWS);
                    self.picture = DARKNESS;
                    self.paint(stage.path, ALL_ROWS);
                }
                Lighted::Colors => {}
            }
            add(&self.picture, lamp.color, &mut self.out);
        }
        self.render_glows(stage, place);
    }

    /// Makes the tile in the light from everywhere, in [`Workspace::out`]; says how many tops there are.
    pub fn render_unlit(&mut self, stage: &Stage, place: &Place) -> usize {
        self.enter(stage);
        let layers = self.recall(stage, place, &mut Surfaces::default());
        self.light_from_everywhere(stage, layers);
        self.out = self.picture;
        shade_contacts(stage, place, &mut self.out);
        layers
    }

    /// Adds the light of inserts to [`Workspace::out`], which is complete with them.
    pub fn render_glows(&mut self, stage: &Stage, place: &Place) {
        for glow in stage.scene.glows.iter().filter(|glow| place.is_touched(glow.mask)) {
            self.glow(place, glow.mask);
            add(&self.picture, glow.color, &mut self.out);
        }
        place.repeat_edges(&mut self.out.each_mut());
    }
}
