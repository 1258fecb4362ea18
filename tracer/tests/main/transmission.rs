//! Coloured shadows: light through translucent things.

use geometry::rng::SplitMix64;
use geometry::{DVec2, Shape};
use tracer::monte_carlo::{self, Sampling};
use tracer::scenes;
use tracer::{Group, ItemId, Material, Occluder, Radiance, Renderer, Scene, SimdLevel, scalar};

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
        let material = Material::Tinted { transmittance: [0, 1, 2].map(|_| random.unit() as f32) };
        for _ in 0..2 {
            let at = random.point_within(DVec2::splat(SIDE as f64));
            let to = at + DVec2::new(random.uniform(-30.0, 30.0), random.uniform(-30.0, 30.0));
            let shape = Shape::capsule(at, to, random.uniform(0.5, 4.0));
            let id = ItemId(scene.occluders.len() as u32 + 1000);
            scene.occluders.push(Occluder { id, shape, group: Group(200 + number), material });
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
    let (green, amber) = ([0.2, 0.9, 0.1], [1.0, 0.5, 0.25]);
    let glass = |id, shape, group, transmittance| {
        let material = Material::Tinted { transmittance };
        Occluder { id: ItemId(id), shape, group: Group(group), material }
    };
    for (id, shape) in (0..).zip([pane(70.0, 20.0, 90.0), pane(70.0, 70.0, 150.0), pane(72.0, 10.0, 150.0)]) {
        scene.occluders.push(glass(id, shape, 1, green));
    }
    let tinted = anew(&scene).pixel(pixel.0, pixel.1);
    scene.occluders.push(glass(8, pane(90.0, 10.0, 150.0), 2, amber));
    let twice = anew(&scene).pixel(pixel.0, pixel.1);
    scene.occluders.push(Occluder::opaque(ItemId(9), pane(50.0, 10.0, 150.0), Group(3)));
    assert_eq!(anew(&scene).pixel(pixel.0, pixel.1), [0.0; 3], "a wall behind the panes");
    for channel in 0..3 {
        let once = open[channel] * green[channel];
        assert!((tinted[channel] - once).abs() <= 1e-5 * open[channel], "{tinted:?} of {open:?}");
        assert!((twice[channel] - once * amber[channel]).abs() <= 1e-5 * open[channel], "{twice:?} of {open:?}");
    }
}

/// Makes all panes of one material.
fn make_panes(scene: &mut Scene, material: Material) {
    let is_pane = |occluder: &&mut Occluder| occluder.group.0 >= 200;
    scene.occluders.iter_mut().filter(is_pane).for_each(|occluder| occluder.material = material);
}

/// A black pane is a wall, and a clear one is not there.
#[test]
fn the_ends_of_the_scale_are_walls_and_air() {
    let floor = scenes::white(SIDE, SIDE);
    for seed in 0..4 {
        let mut scene = stained(seed, &floor);
        make_panes(&mut scene, Material::Tinted { transmittance: [0.0; 3] });
        let black = anew(&scene);
        make_panes(&mut scene, Material::Tinted { transmittance: [1.0; 3] });
        let clear = anew(&scene);
        make_panes(&mut scene, Material::Opaque);
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
fn tints_agree_with_monte_carlo_and_with_double_precision() {
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

/// A pane that changes its tint, becomes a wall, goes and comes back, and panes in another order: the picture is the one
/// that is made from nothing, also where three panes are in the way.
#[test]
fn panes_that_change_are_seen() {
    let floor = scenes::white(SIDE, SIDE);
    let whole = stained(5, &floor);
    let (mut scene, mut renderer, mut remembered) = (whole.clone(), Renderer::new(), Radiance::default());
    for frame in 0..20 {
        let of_group = |occluder: &&mut Occluder| occluder.group == Group(200 + frame % 3);
        match frame % 5 {
            0 => {
                let material = Material::Tinted { transmittance: [0.1 * f32::from(frame % 7), 0.9, 0.4] };
                scene.occluders.iter_mut().filter(of_group).for_each(|occluder| occluder.material = material);
            }
            1 => scene.occluders.iter_mut().filter(of_group).for_each(|occluder| occluder.material = Material::Opaque),
            2 => scene.occluders.retain(|occluder| occluder.group != Group(200 + frame % 3)),
            3 => scene.occluders.reverse(),
            _ => scene.clone_from(&whole),
        }
        assert_eq!(scene.check(), Ok(()));
        renderer.render(&scene, &mut remembered);
        let mut fresh = Radiance::default();
        Renderer::new().render(&scene, &mut fresh);
        assert!(remembered == fresh, "frame {frame}");
    }
}
