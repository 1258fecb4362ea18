//! Balls in the air: what is known of their shadows, and what is remembered of them.

use geometry::{DVec2, Shape};
use std::f64::consts::PI;
use tracer::scenes::{self, Props};
use tracer::{
    Ball, DisplayBuffer, Emitter, Floor, Group, Integrator, ItemId, Lamp, Occluder, Radiance, Renderer, Scene,
    SimdLevel, View, scalar,
};

/// 160 x 160 pixels, 1 mm each, all white.
const SIDE: usize = 160;

/// The radius of the ball, mm.
const BALL_MM: f64 = 13.5;

fn lamp(x: f64, y: f64, height_mm: f64, radius_mm: f64) -> Lamp {
    let emitter = Emitter::Disc { radius_mm };
    let (id, center_mm) = (ItemId(0), DVec2::new(x, y));
    Lamp { id, center_mm, emitter, height_mm, reach_mm: 1000.0, color: [1.0; 3], inside: None }
}

fn ball(x: f64, y: f64, height_mm: f64) -> Ball {
    let (id, center_mm, rotation) = (ItemId(0), DVec2::new(x, y), [0.0, 0.0, 0.0, 1.0]);
    Ball { id, center_mm, radius_mm: BALL_MM, height_mm, below: false, group: Group(7), rotation }
}

fn scene(floor: &Floor, lamp: Lamp, ball: Ball) -> Scene<'_> {
    Scene { lamps: vec![lamp], balls: vec![ball], ambient: [0.0; 3], ..scenes::white_view(floor, 1.0) }
}

fn rendered(scene: &Scene) -> Radiance {
    let mut radiance = Radiance::default();
    Renderer::new().render(scene, &mut radiance);
    radiance
}

/// How much of the scene's only lamp the floor sees, by the picture and in double precision.
fn seen(scene: &Scene, radiance: &Radiance, x: usize, y: usize) -> (f64, f64) {
    let point = scene.view.table_from_pixel(x, y);
    let whole = scene.lamps[0].falloff(point);
    let twin = f64::from(scalar::irradiance(scene, point, None)[0]) / whole;
    (f64::from(radiance.pixel(x, y)[0]) / whole, twin)
}

/// Whether the ball itself is drawn on a pixel.
fn is_ball(scene: &Scene, x: usize, y: usize) -> bool {
    scene.view.table_from_pixel(x, y).distance(scene.balls[0].center_mm) < BALL_MM + 1.0
}

fn pixels() -> impl Iterator<Item = (usize, usize)> {
    (0..SIDE * SIDE).map(|at| (at % SIDE, at / SIDE))
}

/// Straight below a point lamp a ball has a round shadow, which ends where a tangent from the lamp meets the floor.
#[test]
fn a_point_lamp_right_above_casts_a_disc() {
    let floor = scenes::white(SIDE, SIDE);
    let scene = scene(&floor, lamp(80.0, 80.0, 150.0, 0.0), ball(80.0, 80.0, 56.5));
    let radiance = rendered(&scene);
    let below = 150.0f64 - (56.5 + BALL_MM);
    let ends = 150.0 * BALL_MM / (below * below - BALL_MM * BALL_MM).sqrt();
    let mut both = [0; 2];
    for (x, y) in pixels().filter(|&(x, y)| !is_ball(&scene, x, y)) {
        let off = scene.view.table_from_pixel(x, y).distance(DVec2::splat(80.0));
        if (off - ends).abs() > 0.01 {
            let expected = f64::from(u8::from(off > ends));
            let (drawn, twin) = seen(&scene, &radiance, x, y);
            assert!((drawn - expected).abs() < 1e-3 && (twin - expected).abs() < 1e-3, "{drawn} {twin} at {x} {y}");
            both[expected as usize] += 1;
        }
    }
    assert!(both[0] > 1000 && both[1] > 1000, "{both:?}");
}

/// The area that two discs have in common, for middles that are `d` apart.
fn lens(r: f64, s: f64, d: f64) -> f64 {
    if d >= r + s {
        return 0.0;
    }
    if d <= (r - s).abs() {
        return PI * r.min(s) * r.min(s);
    }
    let sector = |r: f64, s: f64| r * r * libm::acos((d * d + r * r - s * s) / (2.0 * d * r));
    let kite = ((r + s - d) * (d + r - s) * (d - r + s) * (d + r + s)).sqrt();
    sector(r, s) + sector(s, r) - 0.5 * kite
}

/// From right below it, a ball covers a disc of the lamp's plane: what it hides of a large lamp is the lens of both.
#[test]
fn from_right_below_a_ball_hides_a_lens() {
    let point = DVec2::splat(80.5);
    let floor = scenes::white(SIDE, SIDE);
    for (height, lift, radius) in [(120.0, 40.0, 30.0), (120.0, 40.0, 9.0), (90.0, 20.0, 60.0), (150.0, 3.0, 25.0)] {
        let middle: f64 = lift + BALL_MM;
        let hides = height * BALL_MM / (middle * middle - BALL_MM * BALL_MM).sqrt();
        for step in 0..30 {
            let off = f64::from(step) / 29.0 * (hides + radius) * 1.05;
            let lamp = lamp(80.5 + off * 0.6, 80.5 + off * 0.8, height, radius);
            let expected = 1.0 - lens(radius, hides, off) / (PI * radius * radius);
            let small = scene(&floor, lamp, ball(80.5, 80.5, lift));
            let twin = f64::from(scalar::irradiance(&small, point, None)[0]) / lamp.falloff(point);
            assert!((twin - expected).abs() < 2e-3, "{twin}, not {expected}: {off} off, {lift} high");
        }
    }
}

/// The picture, and double precision: low and high balls, lamps that are points, discs and tubes, below, among and
/// above.
#[test]
fn the_lanes_agree_with_the_sphere() {
    let floor = scenes::white(SIDE, SIDE);
    let discs = [(0.0, 1e-3), (2.0, 2e-3), (6.0, 2e-3), (13.0, 5e-3), (25.0, 0.02)];
    let discs = discs.map(|(radius_mm, most)| (Emitter::Disc { radius_mm }, most));
    let tubes = [DVec2::new(20.0, 0.0), DVec2::new(-7.0, 15.0)].map(|half_mm| (Emitter::Tube { half_mm }, 1e-4));
    let mut shaded = 0;
    for (height, lift) in [(120.0, 50.0), (28.0, 0.2), (28.0, 10.0), (40.0, 20.0), (40.0, 33.0), (60.0, 30.0)] {
        for &(emitter, most) in discs.iter().chain(&tubes) {
            let lamp = Lamp { emitter, ..lamp(40.0, 55.0, height, 0.0) };
            let scene = scene(&floor, lamp, ball(70.0, 80.0, lift));
            let radiance = rendered(&scene);
            for (x, y) in pixels().step_by(7).filter(|&(x, y)| !is_ball(&scene, x, y)) {
                let (drawn, twin) = seen(&scene, &radiance, x, y);
                shaded += u32::from(twin < 0.999);
                assert!((drawn - twin).abs() < most, "{drawn} {twin} at {x} {y}: {emitter:?} {height} {lift}");
            }
        }
    }
    assert!(shaded > 10_000, "{shaded}");
}

/// As it rises past a lamp, a ball hides less and less of it, and then nothing.
#[test]
fn a_shadow_fades_as_the_ball_rises_past_the_lamp() {
    let point = DVec2::new(110.5, 80.5);
    let floor = scenes::white(SIDE, SIDE);
    let share = |lift: f64| {
        let scene = scene(&floor, lamp(60.0, 80.0, 40.0, 6.0), ball(69.0, 80.0, lift));
        f64::from(scalar::irradiance(&scene, point, None)[0]) / scene.lamps[0].falloff(point)
    };
    let shares: Vec<f64> = (10..=420).map(|tenth| share(f64::from(tenth) * 0.1)).collect();
    assert!(shares.windows(2).all(|two| (two[1] - two[0]).abs() < 0.025), "{shares:?}");
    assert!(
        shares.iter().any(|share| *share < 0.01) && shares[400..].iter().all(|share| *share > 0.9999),
        "{shares:?}"
    );
}

/// What is above all lamps is in the way of nothing, and what is no number is not there.
#[test]
fn heights_that_hide_nothing() {
    let floor = scenes::white(SIDE, SIDE);
    let lying = |height_mm: f64| {
        let lit = lamp(40.0, 60.0, 28.0, 6.0);
        let radiance = rendered(&scene(&floor, lit, ball(80.0, 80.0, height_mm)));
        let bare = rendered(&Scene { balls: Vec::new(), ..scene(&floor, lit, ball(80.0, 80.0, 0.0)) });
        pixels().filter(|&(x, y)| radiance.pixel(x, y) != bare.pixel(x, y)).count()
    };
    let on_screen = lying(0.0);
    assert!(on_screen > 500 && lying(10.0) > 2 * on_screen);
    for height_mm in [28.0, 70.0, 1e5, -0.0, -5.0, -1e5, Ball::LEAST_HEIGHT_MM] {
        assert_eq!(lying(height_mm), on_screen, "{height_mm}");
    }
    for height_mm in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e6, -1e300] {
        assert_eq!(lying(height_mm), 0, "{height_mm}");
        let scene = scene(&floor, lamp(40.0, 60.0, 28.0, 6.0), ball(80.0, 80.0, height_mm));
        assert_eq!(scene.check().unwrap_err(), "ball 0 must be at most 100 m high");
    }
}

/// Two occluders are one union, but a wall and a floating ball are a product; and a lamp inside of the ball's own group
/// sees past it.
#[test]
fn a_ball_and_a_wall_are_multiplied() {
    let floor = scenes::white(SIDE, SIDE);
    let mut both = scene(&floor, lamp(40.0, 80.0, 60.0, 8.0), ball(60.0, 84.0, 15.0));
    let wall = Shape::capsule(DVec2::new(90.0, 20.0), DVec2::new(90.0, 80.0), 1.0);
    both.occluders.push(Occluder::opaque(ItemId(0), wall, Group(1)));
    let point = DVec2::new(120.5, 79.5);
    let light = |scene: &Scene| f64::from(scalar::irradiance(scene, point, None)[0]) / scene.lamps[0].falloff(point);
    let by_wall = light(&Scene { balls: Vec::new(), ..both.clone() });
    let by_ball = light(&Scene { occluders: Vec::new(), ..both.clone() });
    assert!((0.1..0.9).contains(&by_wall) && (0.1..0.9).contains(&by_ball), "{by_wall} {by_ball}");
    assert!((light(&both) - by_wall * by_ball).abs() < 1e-6);
    let (drawn, twin) = seen(&both, &rendered(&both), 120, 79);
    assert!((drawn - twin).abs() < 5e-3, "{drawn} {twin}");
    both.lamps[0].inside = Some(Group(7));
    assert!((light(&both) - by_wall).abs() < 1e-6);
}

fn table(view: View, props: &Props) -> Scene<'_> {
    let mut scene = scenes::table(view, props);
    scene.lamps.iter_mut().step_by(2).for_each(|lamp| lamp.height_mm = 90.0);
    scene
}

/// Balls that rise, fly, turn, change places and come down, while lamps flash: what is remembered changes no bit, on any
/// instruction set and any number of threads.
#[test]
fn memory_changes_no_bit() {
    let view = View::fit(150, 300, scenes::SIZE_MM);
    let props = scenes::props(&view);
    for (path, threads) in SimdLevel::available().into_iter().zip([1, 3].into_iter().cycle()) {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        let (mut renderer, mut remembered, mut fresh) = (Renderer::on(path), Radiance::default(), Radiance::default());
        let (mut scene, grounded) = (table(view, &props), table(view, &props));
        for frame in 0..26 {
            match frame {
                1..9 => scenes::lift(&mut scene, &[4.0 * f64::from(frame), 70.0, 1.0]),
                9 => scene.balls.swap(0, 1),
                10 => scene.lamps[3].color = [0.0; 3],
                11..16 => scenes::roll(&mut scene, DVec2::new(9.0, -14.0)),
                16 => scene.lamps[3].color = [0.4, 0.2, 0.7],
                17 => scene.balls[2].rotation = [1.0, 0.0, 0.0, 0.0],
                18 => scene.balls.push(scene.balls[0]),
                19 => drop(scene.balls.remove(0)),
                20 => scene.balls[0].radius_mm = 20.0,
                21 => scene.lamps[0].height_mm = 60.0,
                22 => scene.tops[31].finish.opacity = 0.4,
                23 => (scene.balls, scene.occluders) = (grounded.balls.clone(), grounded.occluders.clone()),
                24 => scenes::lift(&mut scene, &[30.0]),
                _ => {}
            }
            pool.install(|| renderer.render(&scene, &mut remembered));
            Renderer::new().render(&scene, &mut fresh);
            assert!(remembered == fresh, "frame {frame} on {}", path.name());
        }
    }
}

/// What is kept in steps is what is made from nothing.
#[test]
fn kept_and_made_anew_are_the_same_picture() {
    let view = View::fit(150, 300, scenes::SIZE_MM);
    let props = scenes::props(&view);
    let mut scene = table(view, &props);
    scenes::lift(&mut scene, &[40.0, 3.0]);
    let (kept, mut anew) = (rendered(&scene), Radiance::default());
    Renderer::new().render_uncached(&scene, &mut anew);
    for at in 0..150 * 300 {
        let (kept, anew) = (kept.pixel(at % 150, at / 150), anew.pixel(at % 150, at / 150));
        let near = kept.iter().zip(anew).all(|(kept, anew)| (kept - anew).abs() < 2e-3 * anew.max(1.0));
        assert!(near, "{kept:?} {anew:?} at {at}");
    }
}

/// At half the resolution a floating ball has its shadow too, and what was drawn before leaves no trace.
#[test]
fn light_of_half_the_resolution_has_floating_balls() {
    let view = View::fit(150, 300, scenes::SIZE_MM);
    let (props, Props { floor: half, .. }) = (scenes::props(&view), scenes::props(&view.halved()));
    let drawn = |renderer: &mut Renderer, scene: &Scene| {
        let mut display = DisplayBuffer::default();
        let scene = Scene { half_floor: Some(&half), ..scene.clone() };
        renderer.draw(&scene, 1.0, &mut display);
        display.frame().clone()
    };
    let mut renderer = Renderer::with(Integrator::HalfResolution);
    let mut scene = table(view, &props);
    scenes::lift(&mut scene, &[20.0, 20.0, 20.0]);
    for step in 0..4 {
        scenes::roll(&mut scene, DVec2::new(5.0, -8.0));
        let expected = drawn(&mut Renderer::with(Integrator::HalfResolution), &scene);
        assert!(drawn(&mut renderer, &scene) == expected, "step {step}");
        let mut high = scene.clone();
        scenes::lift(&mut high, &[1e4, 1e4, 1e4]);
        let without = drawn(&mut Renderer::with(Integrator::HalfResolution), &high);
        let darker = expected.to_rgb8().iter().zip(without.to_rgb8()).filter(|(a, b)| a.saturating_add(8) < *b).count();
        assert!(darker > 100, "{darker} channels are darker");
    }
}
