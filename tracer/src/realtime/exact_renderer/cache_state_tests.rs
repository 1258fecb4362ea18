//! Every event of docs/tile_cache.md, made to happen by a change of a scene: what it leaves valid, and that the frame has
//! the bits of one that was made from nothing.

use super::*;
use crate::cache::tile_cache::TileCache;
use crate::cache::validity::{CachedItem, Effect, Event, Validity, effect};
use crate::realtime::block_context::BlockContext;
use crate::realtime::schedule::each_tile;
use crate::scene::NO_FLOOR;
use crate::scenes::{white, white_view};
use crate::{Ball, Emitter, Finish, Floor, Glow, Group, ItemId, Lamp, Mask, Occluder, Outline, Profile, Revision, Top};
use geometry::{DVec2, Shape};

/// Pixels along the picture's side, a millimetre each.
const SIDE_PX: usize = 96;

/// Two lamps, a post, a bumper's cap, a glow and a ball in the first tile, and a glow far from it.
fn scene<'a>(floor: &'a Floor, masks: &'a [Mask; 2]) -> Scene<'a> {
    let lamp = |id: u32, x: f64| Lamp {
        id: ItemId(id),
        center_mm: DVec2::new(x, 16.0),
        emitter: Emitter::Disc { radius_mm: 1.0 },
        height_mm: 30.0,
        reach_mm: 200.0,
        color: [0.8, 0.7, 0.6],
        inside: None,
    };
    let finish = Finish {
        albedo: [0.5, 0.6, 0.7],
        profile: Profile::Dome,
        gloss: 0.5,
        art: false,
        emission: [0.0; 3],
        opacity: 1.0,
        translucency: 0.2,
    };
    let ball = Ball {
        id: ItemId(0),
        center_mm: DVec2::new(12.0, 6.0),
        radius_mm: 3.0,
        height_mm: 0.0,
        group: Group(3),
        below: false,
        rotation: [0.0, 0.0, 0.0, 1.0],
    };
    let glow = |(id, mask)| Glow { id: ItemId(id), mask, color: [0.3, 0.2, 0.1] };
    Scene {
        lamps: vec![lamp(0, 14.0), lamp(1, 20.0)],
        occluders: vec![Occluder::opaque(ItemId(0), Shape::disc(POST_CENTER_MM, 2.0), Group(1))],
        tops: vec![Top { id: ItemId(0), outline: disc(8.0), group: Group(2), finish }],
        balls: vec![ball],
        glows: (0..).zip(masks).map(glow).collect(),
        ambient: [0.1; 3],
        ..white_view(floor, 1.0)
    }
}

const POST_CENTER_MM: DVec2 = DVec2::new(10.0, 12.0);

fn disc(x: f64) -> Outline {
    Outline::Shape(Shape::disc(DVec2::new(x, 8.0), 4.0))
}

fn draw(renderer: &mut ExactRenderer, scene: &Scene, exposure: f32, display: &mut DisplayBuffer) {
    renderer.draw_timed(scene, exposure, display, &mut |_| {});
}

fn move_post(scene: &mut Scene, by_mm: f64) {
    scene.occluders[0].shape = Shape::disc(POST_CENTER_MM + DVec2::new(by_mm, 0.0), 2.0);
}

/// The caches of a frame's first band when its events have met them, and before anything is made anew.
fn after_events(renderer: &mut ExactRenderer, scene: &Scene, buffer_is_last: bool) -> Vec<TileCache> {
    assert!(renderer.prepare(scene, buffer_is_last), "the frame is cached");
    renderer.frame.leave_still_balls();
    let frame = renderer.frame.context(renderer.simd, scene);
    let mut block = BlockContext::default();
    let mut caches = renderer.history.bands[0].clone();
    each_tile(scene, 0, caches.iter_mut(), |rect, cache| {
        block.enter(&frame, rect);
        block.apply_damage(&frame, rect, cache);
    });
    caches
}

/// What is left of the items of a tile, of which the first lamp's layer is one.
fn states(cache: &mut TileCache, renderer: &ExactRenderer, scene: &Scene) -> [(CachedItem, Validity); 5] {
    let lamp = renderer.frame.lamps.list[0].slot;
    [
        (CachedItem::GBuffer, cache.g_buffer.validity),
        (CachedItem::Base, cache.base()),
        (CachedItem::LampLayer, cache.lamp(lamp).validity),
        (CachedItem::GlowLayer, cache.glow(scene.glows[0].key())),
        (CachedItem::Display, cache.display()),
    ]
}

fn assert_as_told(event: Event, states: [(CachedItem, Validity); 5]) {
    for (item, found) in states {
        let as_told = match effect(item, event) {
            Effect::Keep => found == Validity::Valid,
            Effect::MarkStale => matches!(found, Validity::Stale(_)),
            Effect::Clear => found == Validity::Empty,
        };
        assert!(as_told, "{event:?} leaves {item:?} {found:?}");
    }
}

fn assert_has_the_bits_of_one_from_nothing(event: Event, scene: &Scene, exposure: f32, display: &DisplayBuffer) {
    let mut from_nothing = DisplayBuffer::default();
    draw(&mut ExactRenderer::on(SimdLevel::best()), scene, exposure, &mut from_nothing);
    assert!(display.frame() == from_nothing.frame(), "{event:?}: the frame has other bits");
}

/// Draws a scene, and again after each of some changes, of which the last makes the event happen; looks at what that leaves
/// of the first tile, and compares the frame with one from nothing. Two renderers do the same: in one the last frame is
/// looked at and not made.
fn check(event: Event, changes: &[&dyn Fn(&mut Scene)], last_exposure: f32) {
    let floor = white(SIDE_PX, SIDE_PX);
    let mask = |at: usize| Mask { revision: Revision::fresh(), x: at, y: at, width: 6, coverage: vec![200; 36] };
    let masks = [mask(2), mask(80)];
    let mut scene = scene(&floor, &masks);
    let (mut renderer, mut display) = (ExactRenderer::on(SimdLevel::best()), DisplayBuffer::default());
    let (mut looker, mut looked) = (ExactRenderer::on(SimdLevel::best()), DisplayBuffer::default());
    let (last, earlier) = changes.split_last().expect("a change");
    let nothing: &dyn Fn(&mut Scene) = &|_| {};
    for change in [nothing].iter().chain(earlier) {
        change(&mut scene);
        draw(&mut renderer, &scene, 1.0, &mut display);
        draw(&mut looker, &scene, 1.0, &mut looked);
    }
    last(&mut scene);
    let mut caches = after_events(&mut looker, &scene, last_exposure == 1.0);
    assert_as_told(event, states(&mut caches[0], &looker, &scene));
    draw(&mut renderer, &scene, last_exposure, &mut display);
    assert_has_the_bits_of_one_from_nothing(event, &scene, last_exposure, &display);
    let made = states(&mut renderer.history.bands[0][0].clone(), &renderer, &scene);
    assert_eq!(made.map(|(_, state)| state), [Validity::Valid; 5], "{event:?}: all is made anew");
}

#[test]
fn a_change_of_a_scene_leaves_valid_what_the_state_table_says() {
    check(Event::ViewChanged, &[&|scene| scene.view.origin_mm.x += 1.0], 1.0);
    check(Event::ArtChanged, &[&|scene| scene.floor = &NO_FLOOR], 1.0);
    check(Event::TopMoved, &[&|scene| scene.tops[0].outline = disc(9.0)], 1.0);
    check(Event::EmissionChanged, &[&|scene| scene.tops[0].finish.emission = [0.2; 3]], 1.0);
    check(Event::AmbientChanged, &[&|scene| scene.ambient = [0.2; 3]], 1.0);
    check(Event::OccluderMoved(0), &[&|scene| move_post(scene, 1.0)], 1.0);
    check(Event::LampColorChanged, &[&|scene| scene.lamps[0].color = [0.4; 3]], 1.0);
    check(Event::GlowChanged, &[&|scene| scene.glows[0].color = [0.9; 3]], 1.0);
    check(Event::ReflectionChanged, &[&|scene| scene.balls[0].center_mm.x += 1.0], 1.0);
    check(Event::BufferReplaced, &[&|_| {}], 2.0);
}

/// A lamp that is dark misses moves; after too many of them its layers are lost when it shines again.
#[test]
fn a_lamp_that_missed_too_many_moves_is_lost() {
    let dark = |scene: &mut Scene| scene.lamps[0].color = [0.0; 3];
    let (left, right) = (|scene: &mut Scene| move_post(scene, -1.0), |scene: &mut Scene| move_post(scene, 1.0));
    let lit = |scene: &mut Scene| scene.lamps[0].color = [0.8; 3];
    let mut changes: Vec<&dyn Fn(&mut Scene)> = vec![&dark];
    (0..120).for_each(|_| changes.extend([&left as &dyn Fn(&mut Scene), &right]));
    changes.push(&lit);
    check(Event::LampLost, &changes, 1.0);
}

/// Bloom reaches farther than what makes it: a tile that nothing else changes in is tone-mapped again. Outside of the
/// scissor rectangle that waits, which is where it can be looked at.
#[test]
fn bloom_from_afar_clears_the_display_alone() {
    let floor = white(SIDE_PX, SIDE_PX);
    let mask = |at: usize| Mask { revision: Revision::fresh(), x: at, y: at, width: 6, coverage: vec![200; 36] };
    let masks = [mask(2), mask(80)];
    let mut scene = scene(&floor, &masks);
    scene.balls.clear();
    let (mut renderer, mut display) = (ExactRenderer::on(SimdLevel::best()), DisplayBuffer::default());
    draw(&mut renderer, &scene, 1.0, &mut display);
    scene.glows[1].color = [90.0; 3];
    display.set_scissor(SIDE_PX - 16, SIDE_PX - 16, 16, 16);
    draw(&mut renderer, &scene, 1.0, &mut display);
    let cache = &renderer.history.bands[0][0];
    assert!(!cache.redrawn, "the glow is far away");
    assert_as_told(Event::BloomChanged, states(&mut cache.clone(), &renderer, &scene));
    display.set_scissor(0, 0, SIDE_PX, SIDE_PX);
    draw(&mut renderer, &scene, 1.0, &mut display);
    assert_has_the_bits_of_one_from_nothing(Event::BloomChanged, &scene, 1.0, &display);
}
