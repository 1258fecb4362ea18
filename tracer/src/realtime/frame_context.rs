//! The frame context: everything that the tiles of one frame have in common.

use crate::cache::damage::Damage;
use crate::cache::top_history::TopHistory;
use crate::scene::GlowKey;
use crate::shading::albedo_map::AlbedoMap;
use crate::simd::dispatch::SimdLevel;
use crate::tile::packed_samples::PackedSamples;
use crate::visibility::airborne_shadow::AirborneShadow;
use crate::visibility::disc_chain::DiscChains;
use crate::visibility::potential_occluders::PotentialOccluders;
use crate::visibility::shadow_bounds::ShadowBounds;
use crate::visibility::transmission::TintedGroup;
use crate::{Lamp, Rgb, Scene};
use geometry::{Bounds, DVec2};

/// A scene with what was prepared for it: what a pass over tiles reads.
#[derive(Clone, Copy)]
pub(crate) struct FrameContext<'a> {
    pub scene: &'a Scene<'a>,
    pub simd: SimdLevel,
    pub disc_chains: &'a DiscChains,
    /// The groups that light passes, tinted.
    pub tinted: &'a [TintedGroup],
    pub lamps: &'a ActiveLamps,
    pub tops: &'a TopHistory,
    /// Where tops came, went or moved.
    pub moved_tops: &'a [Bounds],
    pub damage: &'a Damage,
    /// The samples of a tile of which every pixel is floor.
    pub full_tile: &'a PackedSamples,
    pub albedo: &'a AlbedoMap,
}

impl FrameContext<'_> {
    /// The glows, with their colours.
    pub fn glows(&self) -> impl Iterator<Item = (GlowKey, Rgb)> + Clone {
        self.scene.glows.iter().map(|glow| (glow.key(), glow.color))
    }
}

/// The lamps of a frame that shine.
#[derive(Default)]
pub(crate) struct ActiveLamps {
    /// In the scene's order.
    pub list: Vec<ActiveLamp>,
    /// By the lamps' slots: the colour of each, black for those that do not shine.
    pub colors: Vec<Rgb>,
    /// By the lamps' slots: the place of each in `list`.
    pub places: Vec<usize>,
}

/// A lamp that shines.
pub(crate) struct ActiveLamp {
    pub lamp: Lamp,
    /// The slot by which the tile caches know it.
    pub slot: usize,
    /// Where its light ends: the middle and the radius of a circle, mm.
    pub circle: (DVec2, f64),
    /// What may stand in its way.
    pub occluders: PotentialOccluders,
    /// The balls in the air that may hide it.
    pub airborne: Vec<AirborneShadow>,
    /// What has moved since the tiles' layers of it were made, where it was and where it is.
    pub moved: DiscChains,
    /// Where the shadows of that, and of balls in the air that moved, may fall.
    pub moved_shadows: Vec<ShadowBounds>,
    /// Whether no tile's layer of it may be used.
    pub lost: bool,
}

impl ActiveLamp {
    /// A lamp of which nothing else is known.
    pub fn new(lamp: &Lamp, slot: usize) -> ActiveLamp {
        ActiveLamp {
            lamp: *lamp,
            slot,
            circle: (lamp.center_mm, lamp.far_mm()),
            occluders: PotentialOccluders::default(),
            airborne: Vec::new(),
            moved: DiscChains::default(),
            moved_shadows: Vec::new(),
            lost: true,
        }
    }
}
