//! Coloured shadows: light through translucent things.

use geometry::rng::SplitMix64;
use geometry::{DVec2, Shape};
use tracer::monte_carlo::{self, Sampling};
use tracer::scenes;
use tracer::{Filter, Group, ItemId, Occluder, Radiance, Renderer, Scene, SimdLevel, scalar};

const SIDE: usize = 160;

fn anew(scene: &Scene) -> Radiance {
    let mut radiance = Radiance::default();
    Renderer::new().render_uncached(scene, &mut radiance);
    radiance
}

/// The generated jumbles, some of whose shapes are of coloured glass; shapes that overlap belong to one pane or to two.
fn stained(seed: u64, floor: &tracer::Floor) -> Scene<'_> {
    let mut scene = scenes::mixed_jumble(seed, floor);
    let mut random = SplitMix64::new(seed + 77);
    for number in 0..3 {
        let tint = [0, 1, 2].map(|_| random.unit() as f32);
        scene.filters.push(Filter { group: Group(200 + number), tint });
        for _ in 0..2 {
            let at = random.point_within(DVec2::splat(SIDE as f64));
            let to = at + DVec2::new(random.uniform(-30.0, 30.0), random.uniform(-30.0, 30.0));
            let shape = Shape::capsule(at, to, random.uniform(0.5, 4.0));
            let id = ItemId(scene.occluders.len() as u32 + 1000);
            scene.occluders.push(Occluder::opaque(id, shape, Group(200 + number)));
        }
    }
    scene
}

/// A pane right across the way to the lamp leaves exactly its tint, however many of its pieces overlap there; two panes
/// leave the product.
#[test]
fn a_pane_tints_once_and_two_panes_tint_twice() {
    let floor = scenes::white(SIDE, SIDE);
    let mut scene = scenes::jumble(1, &floor);
    scene.occluders.clear();
    scene.lamps.truncate(1);
    scene.lamps[0].center_mm = DVec2::new(80.5, 20.0);
    scene.lamps[0].reach_mm = 200.0;
    let pixel = (80, 130);
    let open = anew(&scene).pixel(pixel.0, pixel.1);
    let pane = |y: f64, from: f64, to: f64| Shape::capsule(DVec2::new(from, y), DVec2::new(to, y), 1.0);
    let green = Filter { group: Group(1), tint: [0.2, 0.9, 0.1] };
    let amber = Filter { group: Group(2), tint: [1.0, 0.5, 0.25] };
    scene.filters = vec![green, amber];
    for (id, shape) in (0..).zip([pane(70.0, 20.0, 90.0), pane(70.0, 70.0, 150.0), pane(72.0, 10.0, 150.0)]) {
        scene.occluders.push(Occluder::opaque(ItemId(id), shape, green.group));
    }
    let tinted = anew(&scene).pixel(pixel.0, pixel.1);
    scene.occluders.push(Occluder::opaque(ItemId(8), pane(90.0, 10.0, 150.0), amber.group));
    let twice = anew(&scene).pixel(pixel.0, pixel.1);
    scene.occluders.push(Occluder::opaque(ItemId(9), pane(50.0, 10.0, 150.0), Group(3)));
    assert_eq!(anew(&scene).pixel(pixel.0, pixel.1), [0.0; 3], "a wall behind the panes");
    for channel in 0..3 {
        let once = open[channel] * green.tint[channel];
        assert!((tinted[channel] - once).abs() <= 1e-5 * open[channel], "{tinted:?} of {open:?}");
        assert!((twice[channel] - once * amber.tint[channel]).abs() <= 1e-5 * open[channel], "{twice:?} of {open:?}");
    }
}

/// A black filter is a wall, and a clear one is not there.
#[test]
fn the_ends_of_the_scale_are_walls_and_air() {
    let floor = scenes::white(SIDE, SIDE);
    for seed in 0..4 {
        let mut scene = stained(seed, &floor);
        scene.filters.iter_mut().for_each(|filter| filter.tint = [0.0; 3]);
        let black = anew(&scene);
        scene.filters.iter_mut().for_each(|filter| filter.tint = [1.0; 3]);
        let clear = anew(&scene);
        scene.filters.clear();
        let walls = anew(&scene);
        scene.occluders.retain(|occluder| occluder.group.0 < 200);
        let air = anew(&scene);
        for (x, y) in (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| (x, y))) {
            for channel in 0..3 {
                let near = |a: &Radiance, b: &Radiance| (a.pixel(x, y)[channel] - b.pixel(x, y)[channel]).abs() < 1e-5;
                assert!(near(&black, &walls) && near(&clear, &air), "scene {seed} at {x} {y}");
            }
        }
    }
}

/// Rays that are tinted by whatever they meet know nothing of intervals, or of inclusion and exclusion.
#[test]
fn filters_agree_with_monte_carlo_and_with_double_precision() {
    let floor = scenes::white(SIDE, SIDE);
    let (mut coloured, mut count) = (0, 0);
    for seed in 0..6 {
        let scene = stained(seed, &floor);
        let fast = anew(&scene);
        for at in (seed as usize * 7..SIDE * SIDE).step_by(571) {
            let (x, y) = (at % SIDE, at / SIDE);
            let point = scene.view.table_from_pixel(x, y);
            let sampling = Sampling { samples: 1024, seed, stratified: true };
            let sampled = monte_carlo::irradiance(&scene, point, None, sampling);
            let exact = scalar::irradiance(&scene, point, None);
            for channel in 0..3 {
                let (fast, sampled, exact) = (fast.pixel(x, y)[channel], sampled[channel], exact[channel]);
                assert!((fast - exact).abs() <= 1e-3, "{fast}, {exact} in double precision, at {point}, scene {seed}");
                assert!((fast - sampled).abs() <= 4e-3, "{fast}, {sampled} sampled, at {point}, scene {seed}");
            }
            coloured += usize::from(sampled[0] > 1.2 * sampled[1] || sampled[1] > 1.2 * sampled[2]);
            count += 1;
        }
    }
    assert!(coloured * 20 > count, "only {coloured} of {count} points are in a coloured shadow");
}

#[test]
fn coloured_shadows_have_the_same_bits_everywhere() {
    let floor = scenes::white(SIDE, SIDE);
    let scene = stained(3, &floor);
    let expected = anew(&scene);
    for path in SimdLevel::available() {
        let mut radiance = Radiance::default();
        Renderer::on(path).render_uncached(&scene, &mut radiance);
        assert!(radiance == expected, "{}", path.name());
    }
}
