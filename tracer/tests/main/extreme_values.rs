//! Numbers that nobody means: whatever a scene says, a picture is numbers, and it is done in time.

use geometry::rng::SplitMix64;
use geometry::{Arc, Circle, Core, DVec2, Shape, Taper};
use proptest::prelude::*;
use tracer::monte_carlo::{self, Sampling};
use tracer::{
    Ball, Emitter, Finish, Floor, Frame, Glow, Group, ItemId, Lamp, Mask, Occluder, Outline, Profile, Radiance,
    Renderer, Revision, Scene, Top, View, scalar, scenes, tone_map,
};

const SIDE: usize = 40;

/// Numbers that are likely to be in the way of something.
fn number() -> BoxedStrategy<f64> {
    prop_oneof![
        4 => -60.0..100.0f64,
        2 => (0..9u8).prop_map(|at| f64::from(at) * 5.0 + 0.5),
        1 => prop_oneof![Just(0.0), Just(-0.0), Just(1e-300), Just(1e-9), Just(1e6), Just(-1e6), Just(1e12), Just(1e300)],
        1 => prop_oneof![Just(f64::NAN), Just(f64::INFINITY), Just(f64::NEG_INFINITY), Just(f64::MAX), Just(-1.0)],
    ]
    .boxed()
}

fn place() -> BoxedStrategy<DVec2> {
    (number(), number()).prop_map(|(x, y)| DVec2::new(x, y)).boxed()
}

fn shape() -> BoxedStrategy<Shape> {
    let circle = || (place(), number()).prop_map(|(center, radius)| Circle { center, radius });
    prop_oneof![
        (place(), number()).prop_map(|(at, radius)| Shape::disc(at, radius)),
        (place(), place(), number()).prop_map(|(a, b, radius)| Shape::capsule(a, b, radius)),
        (circle(), circle(), number()).prop_map(|(a, b, radius)| Shape { core: Core::Taper(Taper { a, b }), radius }),
        (circle(), number(), number(), number()).prop_map(|(circle, start, sweep, radius)| Shape {
            core: Core::Arc(Arc::new(circle, start, sweep)),
            radius
        }),
    ]
    .boxed()
}

fn lamp() -> impl Strategy<Value = Lamp> {
    let emitter = prop_oneof![
        number().prop_map(|radius_mm| Emitter::Disc { radius_mm }),
        place().prop_map(|half_mm| Emitter::Tube { half_mm }),
    ];
    let color = prop_oneof![5 => Just([1.0, 0.5, 0.2]), 1 => Just([f32::NAN, 1.0, 1.0]), 1 => Just([f32::MAX; 3]), 1 => Just([-1.0, 1.0, 0.0])];
    (place(), emitter, number(), prop_oneof![3 => Just(200.0), 1 => number()], color, prop::option::of(0..4u16))
        .prop_map(|(center_mm, emitter, height_mm, reach_mm, color, inside)| Lamp {
            id: ItemId(0),
            center_mm,
            emitter,
            height_mm,
            reach_mm,
            color,
            inside: inside.map(Group),
        })
}

fn top() -> impl Strategy<Value = Top> {
    let outline =
        prop_oneof![shape().prop_map(Outline::Shape), prop::collection::vec(place(), 0..6).prop_map(Outline::Polygon)];
    let profile = prop_oneof![Just(Profile::Dome), number().prop_map(|width| Profile::Bevel(width as f32))];
    (outline, profile, number(), number(), any::<bool>()).prop_map(|(outline, profile, gloss, opacity, art)| Top {
        id: ItemId(0),
        outline,
        group: Group(2),
        finish: Finish {
            albedo: [0.5; 3],
            profile,
            gloss: gloss as f32,
            art,
            emission: [0.1; 3],
            opacity: opacity as f32,
            translucency: 0.0,
        },
    })
}

fn ball() -> impl Strategy<Value = Ball> {
    let turn = || number().prop_map(|part| part as f32);
    let ball = (place(), number(), number(), [turn(), turn(), turn(), turn()]);
    ball.prop_map(|(center_mm, radius_mm, height_mm, rotation)| Ball {
        id: ItemId(0),
        center_mm,
        radius_mm,
        height_mm,
        below: true,
        group: Group(3),
        rotation,
    })
}

fn scene(floor: &Floor) -> Scene<'_> {
    Scene { ambient: [0.02; 3], ..scenes::white_view(floor, 1.0) }
}

/// Renders, and finds no pixel that is no light.
fn render(scene: &Scene) -> Radiance {
    let mut radiance = Radiance::default();
    Renderer::new().render(scene, &mut radiance);
    for at in 0..radiance.width() * radiance.height() {
        let light = radiance.pixel(at % radiance.width(), at / radiance.width());
        assert!(light.iter().all(|channel| !channel.is_nan() && *channel >= 0.0), "{light:?} at {at}");
    }
    let mut frame = Frame::default();
    tone_map::map(&radiance, 1.0, &mut frame);
    radiance
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, cases: 300, ..ProptestConfig::default() })]

    #[test]
    fn every_scene_gives_numbers(
        lamps in prop::collection::vec(lamp(), 0..4),
        shapes in prop::collection::vec(shape(), 0..8),
        tops in prop::collection::vec(top(), 0..3),
        balls in prop::collection::vec(ball(), 0..2),
    ) {
        let floor = scenes::white(SIDE, SIDE);
        let occluder = |(at, shape): (u16, Shape)| Occluder::opaque(ItemId(at.into()), shape, Group(at % 4));
        let occluders = (0..).zip(shapes).map(occluder).collect();
        let mut scene = Scene { lamps, occluders, tops, balls, ..scene(&floor) };
        (0..).zip(&mut scene.lamps).for_each(|(id, lamp)| lamp.id = ItemId(id));
        (0..).zip(&mut scene.tops).for_each(|(id, top)| top.id = ItemId(id));
        (0..).zip(&mut scene.balls).for_each(|(id, ball)| ball.id = ItemId(id));
        render(&scene);
        for point in [DVec2::splat(20.5), DVec2::new(0.5, 5.5)] {
            let direct = scalar::irradiance(&scene, point, None);
            prop_assert!(direct.iter().all(|channel| !channel.is_nan() && *channel >= 0.0), "{direct:?}");
            let sampling = Sampling { samples: 8, seed: 1, stratified: true };
            let sampled = monte_carlo::irradiance(&scene, point, None, sampling);
            prop_assert!(sampled.iter().all(|channel| !channel.is_nan() && *channel >= 0.0), "{sampled:?}");
        }
    }

    #[test]
    fn every_view_gives_numbers(x in number(), y in number(), mm_per_px in number(), width in 0..50usize, height in 0..50usize) {
        let floor = scenes::white(SIDE, SIDE);
        let jumble = scenes::mixed_jumble(1, &floor);
        render(&Scene { view: View { width, height, origin_mm: DVec2::new(x, y), mm_per_px }, ..jumble });
    }

    #[test]
    fn every_mask_is_taken(x in any::<usize>(), y in any::<usize>(), width in any::<usize>(), length in 0..99usize) {
        let floor = scenes::white(SIDE, SIDE);
        let masks = [(x, y, width), (x % 50, y % 50, width % 50)]
            .map(|(x, y, width)| Mask { revision: Revision::fresh(), x, y, width, coverage: vec![255; length] });
        let glows = (0..).zip(&masks).map(|(id, mask)| Glow { id: ItemId(id), mask, color: [1.0; 3] }).collect();
        render(&Scene { glows, ..scene(&floor) });
    }
}

/// As if it were at the origin: a table with coordinates of a million millimetres.
#[test]
fn a_table_far_from_the_origin_looks_the_same() {
    let floor = scenes::white(160, 160);
    let here = scenes::mixed_jumble(4, &floor);
    let mut there = here.clone();
    let shift = DVec2::new(1e6, -1e6);
    there.view.origin_mm += shift;
    there.lamps.iter_mut().for_each(|lamp| lamp.center_mm += shift);
    let moved = |circle: Circle| Circle { center: circle.center + shift, ..circle };
    for occluder in &mut there.occluders {
        occluder.shape.core = match occluder.shape.core {
            Core::Point(at) => Core::Point(at + shift),
            Core::Segment(line) => Core::Segment(geometry::Segment { a: line.a + shift, b: line.b + shift }),
            Core::Taper(taper) => Core::Taper(Taper { a: moved(taper.a), b: moved(taper.b) }),
            Core::Arc(arc) => {
                let start = geometry::trig::angle(arc.ends()[0] - arc.circle().center);
                Core::Arc(Arc::new(moved(arc.circle()), start, 2.0 * arc.half_angle()))
            }
        };
    }
    let (here, there) = (render(&here), render(&there));
    for at in 0..160 * 160 {
        let (a, b) = (here.pixel(at % 160, at / 160)[0], there.pixel(at % 160, at / 160)[0]);
        assert!((a - b).abs() <= 2e-3, "{a} and {b} at {at}");
    }
}

/// A wall that goes on for kilometres, and a lamp that is larger than the table.
#[test]
fn very_long_walls_and_very_large_lamps_are_right() {
    let floor = scenes::white(SIDE, SIDE);
    let lamp = Lamp {
        id: ItemId(0),
        center_mm: DVec2::new(20.0, -30.0),
        emitter: Emitter::Disc { radius_mm: 5.0 },
        height_mm: 30.0,
        reach_mm: 300.0,
        color: [1.0; 3],
        inside: None,
    };
    let wall = |from: f64| Shape::capsule(DVec2::new(from, -5.0), DVec2::new(3e6, -5.0), 1.0);
    for from in [-3e6, 20.0] {
        let occluders = vec![Occluder::opaque(ItemId(0), wall(from), Group(1))];
        let scene = Scene { lamps: vec![lamp], occluders, ambient: [0.0; 3], ..scene(&floor) };
        compare(&scene);
    }
    for emitter in [Emitter::Disc { radius_mm: 4000.0 }, Emitter::Tube { half_mm: DVec2::new(3000.0, 2000.0) }] {
        let occluders = vec![Occluder::opaque(ItemId(0), Shape::disc(DVec2::new(15.0, 5.0), 4.0), Group(1))];
        let lamps = vec![Lamp { emitter, ..lamp }];
        compare(&Scene { lamps, occluders, ambient: [0.0; 3], ..scene(&floor) });
    }
}

fn compare(scene: &Scene) {
    let radiance = render(scene);
    for at in (0..SIDE * SIDE).step_by(7) {
        let point = scene.view.table_from_pixel(at % SIDE, at / SIDE);
        let expected = scalar::irradiance(scene, point, None)[0];
        let got = radiance.pixel(at % SIDE, at / SIDE)[0];
        assert!((got - expected).abs() <= 0.02, "{got}, in double precision {expected} at {point}");
    }
}

#[test]
fn thousands_of_lamps_add_up() {
    let floor = scenes::white(SIDE, SIDE);
    for (count, reach_mm) in [(5000, 6.0), (2000, 500.0)] {
        let mut random = SplitMix64::new(8);
        let lamp = |id| Lamp {
            id: ItemId(id),
            center_mm: random.point_within(DVec2::splat(SIDE as f64)),
            emitter: Emitter::Disc { radius_mm: 1.0 },
            height_mm: 20.0,
            reach_mm,
            color: [1e-4; 3],
            inside: None,
        };
        let lamps: Vec<Lamp> = (0..count).map(lamp).collect();
        let occluders = vec![Occluder::opaque(ItemId(0), Shape::disc(DVec2::splat(20.0), 3.0), Group(0))];
        let scene = Scene { lamps, occluders, ambient: [0.0; 3], ..scene(&floor) };
        compare(&scene);
    }
}
