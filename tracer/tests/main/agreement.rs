//! The fast light against its slow twins, on scenes that a program makes up.

use geometry::{DVec2, Shape};
use tracer::monte_carlo::{self, Sampling};
use tracer::scenes;
use tracer::{DisplayBuffer, Floor, Integrator, Radiance, Renderer, Scene, View, scalar};

/// 160 x 160 pixels, 1 mm each, all white.
const SIDE: usize = 160;

fn white() -> Floor {
    scenes::white(SIDE, SIDE)
}

#[derive(Default)]
struct Difference {
    square: f64,
    most: f64,
    place: DVec2,
    count: usize,
}

impl Difference {
    fn add(&mut self, difference: f64, place: DVec2) {
        self.square += difference * difference;
        self.count += 1;
        if difference.is_nan() || difference.abs() > self.most {
            (self.most, self.place) = (difference.abs(), place);
        }
    }

    fn rmse(&self) -> f64 {
        (self.square / self.count as f64).sqrt()
    }
}

/// The gate for light that is about 1 where a lamp is near.
fn assert_small(difference: &Difference, what: &str) {
    let Difference { most, place, .. } = *difference;
    assert!(difference.rmse() <= 1e-3, "{what}: root mean square {}", difference.rmse());
    assert!(most <= 0.02, "{what}: {most} at {place}");
}

#[test]
fn the_lanes_agree_with_monte_carlo() {
    let floor = white();
    let (mut renderer, mut radiance) = (Renderer::new(), Radiance::default());
    for seed in 0..10 {
        let scene = scenes::jumble(seed, &floor);
        renderer.render(&scene, &mut radiance);
        let mut difference = Difference::default();
        for at in (seed as usize..SIDE * SIDE).step_by(211) {
            let (x, y) = (at % SIDE, at / SIDE);
            let point = scene.view.table_from_pixel(x, y);
            let sampling = Sampling { samples: 1024, seed, stratified: true };
            let expected = monte_carlo::irradiance(&scene, point, None, sampling)[0];
            difference.add(f64::from(radiance.pixel(x, y)[0] - expected), point);
        }
        assert_small(&difference, &format!("scene {seed}"));
    }
}

#[test]
fn the_lanes_agree_with_double_precision() {
    let floor = white();
    let (mut renderer, mut radiance) = (Renderer::new(), Radiance::default());
    for seed in 10..20 {
        let scene = scenes::jumble(seed, &floor);
        renderer.render(&scene, &mut radiance);
        let mut difference = Difference::default();
        for at in (0..SIDE * SIDE).step_by(13) {
            let (x, y) = (at % SIDE, at / SIDE);
            let point = scene.view.table_from_pixel(x, y);
            let expected = scalar::irradiance(&scene, point, None)[0];
            difference.add(f64::from(radiance.pixel(x, y)[0] - expected), point);
        }
        assert_small(&difference, &format!("scene {seed}"));
    }
}

/// The hard case: a sketch of this method was wrong by a quarter of a lamp where a point touches an occluder. The view
/// is so narrow here that most of its pixels are within a millimetre of an outline, many of them within 0.1 mm.
#[test]
fn points_that_touch_an_occluder_are_right_too() {
    let floor = white();
    let (mut renderer, mut radiance) = (Renderer::new(), Radiance::default());
    for seed in 0..8 {
        let mut scene = scenes::jumble(seed, &floor);
        let shape = scene.occluders[seed as usize].shape;
        let (_, away) = shape.distance(DVec2::splat(80.0));
        let inside = DVec2::splat(80.0) - away * shape.distance(DVec2::splat(80.0)).0;
        scene.view.mm_per_px = 0.02;
        scene.view.origin_mm = inside - DVec2::splat(1.6);
        renderer.render(&scene, &mut radiance);
        let mut difference = Difference::default();
        for at in (0..SIDE * SIDE).step_by(307) {
            let (x, y) = (at % SIDE, at / SIDE);
            let point = scene.view.table_from_pixel(x, y);
            let sampling = Sampling { samples: 1024, seed, stratified: true };
            let expected = monte_carlo::irradiance(&scene, point, None, sampling)[0];
            difference.add(f64::from(radiance.pixel(x, y)[0] - expected), point);
        }
        assert_small(&difference, &format!("scene {seed} at {inside}"));
    }
}

/// A renderer that remembers earlier pictures, against one that does not, while things move, flash and vanish.
#[test]
fn memory_changes_no_bit() {
    let floor = white();
    let mut scene = scenes::jumble(3, &floor);
    let (mut renderer, mut remembered, mut fresh) = (Renderer::new(), Radiance::default(), Radiance::default());
    for frame in 0..12 {
        let moving = &mut scene.occluders[4].shape;
        *moving = Shape::disc(DVec2::new(20.0 + 9.0 * f64::from(frame), 70.0), 6.0);
        scene.lamps[1].color = [0.1 * f32::from(u8::from(frame % 4 < 2)); 3];
        if frame == 5 {
            scene.occluders.pop();
        }
        if frame == 8 {
            scene.lamps.swap(0, 2);
        }
        renderer.render(&scene, &mut remembered);
        Renderer::new().render(&scene, &mut fresh);
        assert!(remembered == fresh, "frame {frame}");
    }
}

/// The same for all that can be seen of a table: balls, tops that move or only change colour, glows, light from
/// everywhere, lamps that come, go and change places; and for a picture that another renderer has drawn over.
#[test]
fn what_did_not_change_is_left_as_it_was() {
    let view = View::fit(150, 300, scenes::SIZE_MM);
    let (props, others) = (scenes::props(&view), scenes::props(&view));
    let mut scene = scenes::table(view, &props);
    let (mut renderer, mut remembered, mut fresh) = (Renderer::new(), Radiance::default(), Radiance::default());
    for frame in 0..24 {
        match frame {
            2..6 => scenes::roll(&mut scene, DVec2::new(9.0, -14.0)),
            6 => scene.lamps[3].color = [0.3, 0.0, 0.1],
            7 => scene.lamps.swap(1, 9),
            8 => drop(scene.lamps.remove(2)),
            9 => scene.tops[30].finish.emission = [0.4, 0.2, 0.0],
            10 => scene.tops[31].finish.opacity = 0.4,
            11 => drop(scene.tops.remove(12)),
            12 => scene.glows[2].color = [0.0; 3],
            13 => drop(scene.glows.remove(0)),
            14 => drop(scene.balls.pop()),
            15 => scene.ambient = [0.1; 3],
            16 => scene.floor = &others.floor,
            17 => scene.view.origin_mm.x += 3.0,
            18 => Renderer::new().render(&scenes::table(view, &props), &mut remembered),
            19 => renderer.invalidate(),
            20 => scene.balls[0].rotation = [1.0, 0.0, 0.0, 0.0],
            21 => {
                let sampling = Sampling { samples: 1, seed: 0, stratified: true };
                tracer::render(&scene, Integrator::MonteCarlo(sampling), &mut remembered);
            }
            22 => remembered = Radiance::default(),
            _ => {}
        }
        renderer.render(&scene, &mut remembered);
        Renderer::new().render(&scene, &mut fresh);
        assert!(remembered == fresh, "frame {frame}");
    }
}

/// One scene, every integrator: the mean of all channels is the same to a fiftieth of it (art is printed anew at half the
/// resolution), and no more than one channel in fifty differs by more than a tenth of the brightest light of the exact
/// picture.
#[test]
fn every_integrator_finds_the_same_light() {
    let view = View::fit(150, 300, scenes::SIZE_MM);
    let (props, half) = (scenes::props(&view), scenes::props(&view.halved()).floor);
    let scene = Scene { half_floor: Some(&half), ..scenes::table(view, &props) };
    let rendered = |integrator| {
        let mut radiance = Radiance::default();
        tracer::render(&scene, integrator, &mut radiance);
        let pixels = (0..view.height).flat_map(|y| (0..view.width).map(move |x| (x, y)));
        pixels.flat_map(|(x, y)| radiance.pixel(x, y)).collect::<Vec<f32>>()
    };
    let mean = |channels: &[f32]| channels.iter().sum::<f32>() / channels.len() as f32;
    let exact = rendered(Integrator::Exact);
    let brightest = exact.iter().copied().fold(0.0, f32::max);
    let sampling = Sampling { samples: 16, seed: 3, stratified: true };
    for integrator in [Integrator::HalfResolution, Integrator::MonteCarlo(sampling)] {
        let other = rendered(integrator);
        let (expected, found) = (mean(&exact), mean(&other));
        assert!((found / expected - 1.0).abs() < 0.02, "{integrator:?}: {found}, exactly {expected}");
        let far = exact.iter().zip(&other).filter(|(a, b)| (*a - *b).abs() > 0.1 * brightest).count();
        assert!(far * 50 < exact.len(), "{integrator:?}: {far} of {} channels", exact.len());
    }
}

/// A renderer that goes from one integrator to another and back draws what one draws that never did anything else.
#[test]
fn integrators_leave_each_other_alone() {
    let view = View::fit(75, 150, scenes::SIZE_MM);
    let (props, half) = (scenes::props(&view), scenes::props(&view.halved()).floor);
    let mut scene = Scene { half_floor: Some(&half), ..scenes::table(view, &props) };
    let sampling = Sampling { samples: 2, seed: 0, stratified: true };
    let integrators = [Integrator::Exact, Integrator::HalfResolution, Integrator::MonteCarlo(sampling)];
    let (mut renderer, mut radiance) = (Renderer::new(), Radiance::default());
    let (mut display, mut alone) = (DisplayBuffer::default(), DisplayBuffer::default());
    for frame in 0..12 {
        scenes::roll(&mut scene, DVec2::new(3.0, -5.0));
        scene.lamps[frame].color = [0.2; 3];
        let integrator = integrators[frame * 5 / 4 % 3];
        renderer.set_integrator(integrator);
        renderer.render(&scene, &mut radiance);
        renderer.draw(&scene, 1.0, &mut display);
        let mut expected = Radiance::default();
        Renderer::with(integrator).render(&scene, &mut expected);
        Renderer::with(integrator).draw(&scene, 1.0, &mut alone);
        assert!(radiance == expected && display.frame() == alone.frame(), "frame {frame}, {integrator:?}");
    }
}
