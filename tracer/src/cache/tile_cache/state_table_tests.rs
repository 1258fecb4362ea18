//! The state table of docs/tile_cache.md, walked through cell by cell on a real cache.

use super::*;
use crate::{Glow, ItemId, Mask};

const PAGE: &str = include_str!("../../../../docs/tile_cache.md");

const EVENTS: [(&str, Event); 12] = [
    ("view changed", Event::ViewChanged),
    ("art changed", Event::ArtChanged),
    ("top moved", Event::TopMoved),
    ("emission changed", Event::EmissionChanged),
    ("ambient changed", Event::AmbientChanged),
    ("occluder moved", Event::OccluderMoved(MOVED_ROWS)),
    ("lamp lost", Event::LampLost),
    ("lamp colour changed", Event::LampColorChanged),
    ("glow changed", Event::GlowChanged),
    ("reflection changed", Event::ReflectionChanged),
    ("buffer replaced", Event::BufferReplaced),
    ("bloom changed", Event::BloomChanged),
];

const ITEMS: [(&str, CachedItem); 5] = [
    ("G-buffer", CachedItem::GBuffer),
    ("base layer", CachedItem::Base),
    ("lamp layer", CachedItem::LampLayer),
    ("glow layer", CachedItem::GlowLayer),
    ("display", CachedItem::Display),
];

const STATES: [(&str, Validity); 3] =
    [("empty", Validity::Empty), ("stale", Validity::Stale(STALE_ROWS)), ("valid", Validity::Valid)];

const STALE_ROWS: RowMask = 0b0011;
const MOVED_ROWS: RowMask = 0b0110;

/// The lamp that events meet, and one that no event of another lamp meets.
const LAMP: usize = 3;
const OTHER_LAMP: usize = 1;

fn key() -> GlowKey {
    let mask = Mask::default();
    Glow { id: ItemId(7), mask: &mask, color: [1.0; 3] }.key()
}

/// The rows of the page's table whose heading starts with `first`, cell by cell, the heading itself first.
fn table(first: &str) -> Vec<Vec<&'static str>> {
    let cells = |line: &'static str| line.trim_matches('|').split('|').map(str::trim).collect::<Vec<_>>();
    let from_heading = PAGE.lines().skip_while(|line| !line.starts_with(&format!("| {first} |")));
    let mut rows: Vec<_> = from_heading.take_while(|line| line.starts_with('|')).map(cells).collect();
    assert!(rows.len() > 2, "the page has no table of {first}s");
    rows.remove(1);
    rows
}

/// A tile whose items are all in one state.
fn tile(state: Validity) -> TileCache {
    let mut tile = TileCache { display: state, ..TileCache::default() };
    tile.g_buffer.validity = state;
    tile.base.validity = state;
    for lamp in [LAMP, OTHER_LAMP] {
        tile.keep_dark(lamp, None);
        tile.lamp(lamp).validity = state;
        if !state.is_valid() {
            tile.valid.remove(lamp);
        }
    }
    tile.glow_layer(key()).validity = state;
    tile
}

fn state_of(tile: &mut TileCache, item: CachedItem) -> Validity {
    match item {
        CachedItem::GBuffer => tile.g_buffer.validity,
        CachedItem::Base => tile.base(),
        CachedItem::LampLayer => tile.lamp(LAMP).validity,
        CachedItem::GlowLayer => tile.glow(key()),
        CachedItem::Display => tile.display(),
    }
}

fn is_of_one_lamp(event: Event) -> bool {
    matches!(event, Event::OccluderMoved(_) | Event::LampLost)
}

#[test]
fn every_event_leaves_every_item_in_the_state_that_the_page_says() {
    let (events, effects) = (table("event"), table("effect"));
    assert_eq!(events[0][1..6], ITEMS.map(|(name, _)| name));
    assert_eq!(effects[0][1..], STATES.map(|(name, _)| format!("from {name}")));
    assert_eq!(events[1..].iter().map(|row| row[0]).collect::<Vec<_>>(), EVENTS.map(|(name, _)| name));
    let mut transitions = 0;
    for (row, (event_name, event)) in events[1..].iter().zip(EVENTS) {
        for (column, (item_name, item)) in (1..).zip(ITEMS) {
            let effect = effects.iter().find(|effect| effect[0] == row[column]).expect("an effect that the page knows");
            for (at, (state_name, state)) in (1..).zip(STATES) {
                let mut tile = tile(state);
                if is_of_one_lamp(event) {
                    tile.apply_to_lamp(LAMP, event)
                } else {
                    tile.apply(event)
                }
                let found = state_of(&mut tile, item);
                let named = STATES.iter().find(|(name, _)| *name == effect[at]).expect("a state that the page knows");
                let from = format!("{event_name}: {item_name} from {state_name}");
                assert_eq!(std::mem::discriminant(&found), std::mem::discriminant(&named.1), "{from} is {found:?}");
                assert_eq!(tile.valid.contains(LAMP), tile.lamp(LAMP).validity.is_valid(), "{from}");
                transitions += 1;
            }
        }
    }
    assert_eq!(transitions, 12 * 5 * 3);
}

#[test]
fn rows_add_up_until_a_layer_is_made_anew() {
    let mut tile = tile(Validity::Stale(STALE_ROWS));
    tile.apply_to_lamp(LAMP, Event::OccluderMoved(MOVED_ROWS));
    assert_eq!(tile.lamp(LAMP).validity, Validity::Stale(STALE_ROWS | MOVED_ROWS));
    assert_eq!(tile.lamp(OTHER_LAMP).validity, Validity::Stale(STALE_ROWS), "another lamp's layer is left alone");
    tile.keep_dark(LAMP, None);
    assert_eq!(tile.lamp(LAMP).validity, Validity::Valid);
    tile.apply_to_lamp(LAMP, Event::OccluderMoved(0));
    assert_eq!(tile.lamp(LAMP).validity, Validity::Valid, "no row of the tile is out of date");
}
