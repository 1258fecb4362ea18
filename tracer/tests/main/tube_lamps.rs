//! Lamps that are lines: known answers, and the fast light against its slow twins.

use geometry::rng::SplitMix64;
use geometry::{Arc, Circle, Core, DVec2, Shape, trig};
use tracer::monte_carlo::{self, Sampling};
use tracer::scenes;
use tracer::{Emitter, Floor, Group, ItemId, Lamp, Occluder, Radiance, Renderer, Scene, SimdLevel, View, scalar};

const SIDE: usize = 96;

/// A tube of 60 mm, 30 mm above the floor, in the upper part of a view of 96 x 96 mm round the origin.
fn lone_tube(floor: &Floor) -> Scene<'_> {
    let lamp = Lamp {
        id: ItemId(0),
        center_mm: DVec2::new(0.0, -30.0),
        emitter: Emitter::Tube { half_mm: DVec2::new(30.0, 0.0) },
        height_mm: 30.0,
        reach_mm: 140.0,
        color: [0.1, 0.2, 0.05],
        inside: None,
    };
    Scene {
        view: View { width: SIDE, height: SIDE, origin_mm: DVec2::splat(-0.5 * SIDE as f64), mm_per_px: 1.0 },
        lamps: vec![lamp],
        ..scenes::white_view(floor, 1.0)
    }
}

fn rendered(scene: &Scene) -> Radiance {
    let mut radiance = Radiance::default();
    Renderer::new().render_uncached(scene, &mut radiance);
    radiance
}

fn cast(scene: &mut Scene, shape: Shape, group: u16) {
    let id = ItemId(scene.occluders.len() as u32);
    scene.occluders.push(Occluder::opaque(id, shape, Group(group)));
}

/// The light of a tube, added up from many short pieces by the midpoint rule.
fn added_up(lamp: &Lamp, half: DVec2, point: DVec2) -> f64 {
    let pieces = 40_000;
    let places = (0..pieces).map(|piece| 2.0 * (f64::from(piece) + 0.5) / f64::from(pieces) - 1.0);
    let square = |place: f64| point.distance_squared(lamp.center_mm + half * place);
    let height_square = lamp.height_mm * lamp.height_mm;
    let sum: f64 = places.map(|place| 1e4 / (square(place) + height_square)).sum();
    let nearest = geometry::Segment { a: lamp.center_mm - half, b: lamp.center_mm + half }.closest(point);
    let rest = (1.0 - point.distance_squared(nearest) / (lamp.reach_mm * lamp.reach_mm)).max(0.0);
    sum / f64::from(pieces) * rest * rest
}

#[test]
fn the_closed_form_is_the_integral() {
    let mut random = SplitMix64::new(3);
    let floor = scenes::white(SIDE, SIDE);
    let mut scene = lone_tube(&floor);
    for _ in 0..40 {
        let half_mm = trig::direction(random.uniform(0.0, 7.0)) * random.uniform(0.02, 90.0);
        let height_mm = random.uniform(1.0, 40.0);
        scene.lamps[0] = Lamp { emitter: Emitter::Tube { half_mm }, height_mm, ..scene.lamps[0] };
        let radiance = rendered(&scene);
        for _ in 0..8 {
            let (x, y) = ((random.unit() * SIDE as f64) as usize, (random.unit() * SIDE as f64) as usize);
            let point = scene.view.table_from_pixel(x, y);
            let expected = added_up(&scene.lamps[0], half_mm, point);
            let exact = scene.lamps[0].falloff(point);
            assert!((exact - expected).abs() <= 1e-6 * expected.max(1e-3), "{exact}, added up {expected}");
            let lanes = f64::from(radiance.pixel(x, y)[1]) / f64::from(scene.lamps[0].color[1]);
            assert!((lanes - exact).abs() <= 4e-6 * exact.max(1.0), "{lanes}, in double precision {exact}");
        }
    }
}

#[test]
fn a_short_segment_is_a_point() {
    let floor = scenes::white(SIDE, SIDE);
    let mut scene = lone_tube(&floor);
    scene.lamps[0].emitter = Emitter::Disc { radius_mm: 0.0 };
    cast(&mut scene, Shape::disc(DVec2::new(3.0, 0.0), 8.0), 1);
    let point = rendered(&scene);
    let mut last = f32::MAX;
    for length in [8.0, 2.0, 0.5, 0.1, 0.0] {
        scene.lamps[0].emitter = Emitter::Tube { half_mm: DVec2::new(length * 0.6, length * 0.8) };
        let tube = rendered(&scene);
        let sum = |radiance: &Radiance| -> f32 {
            (0..SIDE * SIDE)
                .map(|at| (radiance.pixel(at % SIDE, at / SIDE)[1] - point.pixel(at % SIDE, at / SIDE)[1]).abs())
                .sum()
        };
        let difference = sum(&tube) / (SIDE * SIDE) as f32;
        assert!(difference < last || difference == 0.0, "{difference} at {length}, {last} before");
        last = difference;
    }
    assert_eq!(last, 0.0, "a tube of no length is the point itself");
}

/// The wall's edge is on the perpendicular bisector of the tube, and so is the point.
#[test]
fn a_tube_that_is_half_hidden_by_symmetry_gives_half() {
    let floor = scenes::white(SIDE, SIDE);
    let mut scene = lone_tube(&floor);
    for emitter in [DVec2::new(30.0, 0.0), DVec2::new(3.0, 0.0), DVec2::new(0.2, 0.0)] {
        scene.occluders.clear();
        scene.lamps[0].emitter = Emitter::Tube { half_mm: emitter };
        scene.lamps[0].center_mm = DVec2::new(0.5, -30.0);
        let (x, y) = (48, 80);
        let open = rendered(&scene).pixel(x, y);
        cast(&mut scene, Shape::capsule(DVec2::new(2.5, 0.0), DVec2::new(90.0, 0.0), 2.0), 1);
        let half = rendered(&scene).pixel(x, y);
        assert!((half[1] / open[1] - 0.5).abs() < 2e-6, "{} of {}", half[1], open[1]);
    }
}

/// From 45 degrees before one end, a wall hides that half of a tube which gives more of the light: not half of it.
#[test]
fn near_parts_of_a_tube_count_more() {
    let floor = scenes::white(SIDE, SIDE);
    let mut scene = lone_tube(&floor);
    scene.lamps[0].reach_mm = 1e4;
    let (x, y) = (SIDE - 3, 60);
    let point = scene.view.table_from_pixel(x, y);
    let open = f64::from(rendered(&scene).pixel(x, y)[1]);
    let middle = scene.lamps[0].center_mm;
    // The wall's end touches the line from the point to the tube's middle, from the side of the nearer half.
    let way = (middle - point).normalize();
    let touching = point + way * 20.0 + way.perp() * 1.0;
    cast(&mut scene, Shape::capsule(touching, touching + way.perp() * 60.0, 1.0), 1);
    let seen = f64::from(rendered(&scene).pixel(x, y)[1]) / open;
    let halves = [-1.0, 1.0].map(|side| {
        let lamp = Lamp { center_mm: middle + DVec2::X * (15.0 * side), ..scene.lamps[0] };
        added_up(&lamp, DVec2::X * 15.0, point)
    });
    let expected = halves[0] / (halves[0] + halves[1]);
    assert!((seen - expected).abs() < 1e-4 && expected < 0.4, "{seen}, and {expected} expected");
}

#[test]
fn what_stands_behind_a_tube_hides_nothing_and_what_crosses_it_hides_beyond() {
    let floor = scenes::white(SIDE, SIDE);
    let mut scene = lone_tube(&floor);
    let open = rendered(&scene);
    cast(&mut scene, Shape::capsule(DVec2::new(-60.0, -33.0), DVec2::new(60.0, -33.0), 2.5), 1);
    let walled = rendered(&scene);
    for (x, y) in [(10, 60), (48, 70), (90, 30)] {
        assert_eq!(walled.pixel(x, y), open.pixel(x, y), "{x} {y}");
    }
    // A post on the tube's middle: from its line, beyond an end, the farther half is gone and what the post covers.
    scene.occluders.clear();
    scene.view.origin_mm.y = -30.5;
    scene.lamps[0].color = [1.0; 3];
    let (x, y) = (SIDE - 1, 0);
    let point = scene.view.table_from_pixel(x, y);
    assert_eq!(point.y, scene.lamps[0].center_mm.y);
    let middle = scene.lamps[0].center_mm;
    cast(&mut scene, Shape::disc(middle, 4.0), 1);
    let got = f64::from(rendered(&scene).pixel(x, y)[1]);
    let near = Lamp { center_mm: DVec2::new(17.0, -30.0), ..scene.lamps[0] };
    let rest =
        scene.lamps[0].falloff(point) / added_up(&Lamp { reach_mm: 1e9, ..scene.lamps[0] }, DVec2::X * 30.0, point);
    let expected = added_up(&Lamp { reach_mm: 1e9, ..near }, DVec2::X * 13.0, point) * 13.0 / 30.0 * rest;
    assert!((got - expected).abs() < 1e-3 * expected, "{got}, and {expected} expected");
}

/// Every row of the view is on the tube's line or next to it: points on it, before it and beyond its ends.
#[test]
fn points_on_the_line_of_a_tube_agree_with_double_precision() {
    let floor = scenes::white(SIDE, SIDE);
    for (angle, mm_per_px) in [(0.0, 1.0), (0.0, 0.003), (0.6, 0.01)] {
        let mut scene = lone_tube(&floor);
        let along = trig::direction(angle);
        scene.lamps[0].center_mm = DVec2::new(0.5, 0.5);
        scene.lamps[0].emitter = Emitter::Tube { half_mm: along * 20.0 };
        cast(&mut scene, Shape::disc(along * 25.0 + along.perp() * 2.0, 3.0), 1);
        cast(&mut scene, Shape::capsule(along * -8.0 - along.perp() * 9.0, along * -9.0 + along.perp() * 2.0, 0.7), 2);
        let circle = Circle { center: along * 35.0, radius: 6.0 };
        cast(&mut scene, Shape { core: Core::Arc(Arc::new(circle, angle - 1.0, 1.3)), radius: 0.5 }, 3);
        for middle in [-30.0, -10.0, 0.0, 15.0, 30.0, 46.0] {
            let middle = scene.lamps[0].center_mm + along * middle;
            scene.view =
                View { mm_per_px, origin_mm: middle - DVec2::splat(0.5 * SIDE as f64 * mm_per_px), ..scene.view };
            let radiance = rendered(&scene);
            let (mut square, mut most) = (0.0, 0.0f64);
            for at in (0..SIDE * SIDE).step_by(7) {
                let (x, y) = (at % SIDE, at / SIDE);
                let point = scene.view.table_from_pixel(x, y);
                let expected = scalar::irradiance(&scene, point, None)[0];
                let difference = f64::from(radiance.pixel(x, y)[0] - expected);
                square += difference * difference;
                most = most.max(difference.abs());
                assert!(difference.is_finite(), "{point}");
            }
            let rmse = (square / (SIDE * SIDE / 7) as f64).sqrt();
            assert!(rmse <= 1e-3 && most <= 0.02, "{angle} {mm_per_px} {middle}: {rmse}, at most {most}");
        }
    }
}

#[test]
fn the_lanes_agree_with_both_twins() {
    let floor = scenes::white(160, 160);
    let mut radiance = Radiance::default();
    for seed in 0..12 {
        let scene = scenes::mixed_jumble(seed, &floor);
        Renderer::new().render(&scene, &mut radiance);
        let (mut square, mut count) = (0.0, 0);
        for at in (seed as usize..160 * 160).step_by(29) {
            let (x, y) = (at % 160, at / 160);
            let point = scene.view.table_from_pixel(x, y);
            let lanes = radiance.pixel(x, y)[0];
            let exact = scalar::irradiance(&scene, point, None)[0];
            let difference = f64::from(lanes - exact);
            assert!(difference.abs() <= 0.02, "seed {seed} at {point}: {lanes}, in double precision {exact}");
            square += difference * difference;
            count += 1;
            if at % 7 == 0 {
                let sampling = Sampling { samples: 1024, seed, stratified: true };
                let sampled = monte_carlo::irradiance(&scene, point, None, sampling)[0];
                assert!((sampled - exact).abs() <= 0.002, "seed {seed} at {point}: {sampled}, exactly {exact}");
            }
        }
        let rmse = (square / f64::from(count)).sqrt();
        assert!(rmse <= 1e-3, "seed {seed}: {rmse}");
    }
}

#[test]
fn tubes_have_the_same_bits_on_every_path() {
    let floor = scenes::white(160, 160);
    for seed in 0..3 {
        let scene = scenes::mixed_jumble(seed, &floor);
        let mut expected = Radiance::default();
        Renderer::new().render(&scene, &mut expected);
        for path in SimdLevel::available() {
            let mut radiance = Radiance::default();
            Renderer::on(path).render(&scene, &mut radiance);
            assert!(radiance == expected, "seed {seed} on {}", path.name());
        }
    }
}
