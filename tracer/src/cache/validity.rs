//! Validity: what of a cached item may still be used, and what each event leaves of it.
//!
//! [`effect`] is the state table of docs/tile_cache.md, and the only place that decides what an event invalidates: a
//! test compares the two, cell by cell. Only a pass that makes an item anew makes it valid.

use crate::tile::planes::RowMask;

/// What of a cached item may be used.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Validity {
    /// Nothing of it.
    #[default]
    Empty,
    /// All but these rows, of which there is one at least.
    Stale(RowMask),
    /// All of it: made anew it would have the same bits.
    Valid,
}

/// What a tile keeps from frame to frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum CachedItem {
    /// Which surfaces are seen.
    GBuffer,
    /// The tile in ambient light, with the emission of tops.
    Base,
    /// The tile in the light of one lamp.
    LampLayer,
    /// The tile in the light of one glow.
    GlowLayer,
    /// The tile's pixels in the display buffer.
    Display,
}

/// What may happen between two frames, as one tile meets it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Event {
    /// The view is another.
    ViewChanged,
    /// The floor's art is another.
    ArtChanged,
    /// A top came, went or moved in the tile.
    TopMoved,
    /// A top in the tile has another emission.
    EmissionChanged,
    /// The ambient light is another.
    AmbientChanged,
    /// An occluder or a ball in the air moved before the lamp; its shadow may fall, or have fallen, on these rows.
    OccluderMoved(RowMask),
    /// What moved before the lamp while it was dark is not known any more, or the lamp is new.
    LampLost,
    /// The lamp has another colour.
    LampColorChanged,
    /// A glow has another colour, or came or went.
    GlowChanged,
    /// A ball is or was here, and the ball or something that it may mirror is another.
    ReflectionChanged,
    /// The buffer holds something else than this renderer's last frame.
    BufferReplaced,
    /// The bloom over the tile is another.
    BloomChanged,
}

/// What an event does to an item.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Effect {
    /// Nothing.
    Keep,
    /// The event's rows are out of date.
    MarkStale,
    /// Nothing of the item may be used any more.
    Clear,
}

/// The state table.
pub(crate) const fn effect(item: CachedItem, event: Event) -> Effect {
    match (event, item) {
        (Event::ViewChanged | Event::ArtChanged | Event::TopMoved, _) => Effect::Clear,
        (_, CachedItem::Display) => Effect::Clear,
        (Event::EmissionChanged | Event::AmbientChanged, CachedItem::Base) => Effect::Clear,
        (Event::OccluderMoved(_), CachedItem::LampLayer) => Effect::MarkStale,
        (Event::LampLost, CachedItem::LampLayer) => Effect::Clear,
        _ => Effect::Keep,
    }
}

impl Event {
    /// The rows that it touches, if not the whole tile.
    const fn rows(self) -> RowMask {
        match self {
            Event::OccluderMoved(rows) => rows,
            _ => RowMask::MAX,
        }
    }
}

impl Validity {
    /// Whether all of the item may be used.
    pub fn is_valid(self) -> bool {
        self == Validity::Valid
    }

    /// Whether nothing of it may be used.
    pub fn is_empty(self) -> bool {
        self == Validity::Empty
    }

    /// What an event leaves of an item.
    #[must_use]
    pub fn after(self, item: CachedItem, event: Event) -> Validity {
        match (effect(item, event), self) {
            (Effect::Keep, state) => state,
            (Effect::Clear, _) | (Effect::MarkStale, Validity::Empty) => Validity::Empty,
            (Effect::MarkStale, Validity::Stale(rows)) => Validity::Stale(rows | event.rows()),
            (Effect::MarkStale, Validity::Valid) if event.rows() == 0 => Validity::Valid,
            (Effect::MarkStale, Validity::Valid) => Validity::Stale(event.rows()),
        }
    }
}
