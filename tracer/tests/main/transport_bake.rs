//! Baked layers: the light that photons find, lamp by lamp, and none behind walls.

use geometry::rng::SplitMix64;
use geometry::{Bounds, DVec2, Segment, Shape};
use std::sync::atomic::{AtomicU64, Ordering};
use tracer::View;
use tracer::transport::bake::{Bake, BakeOptions, bake};
use tracer::transport::spectrum::{Dispersion, Emission, Weights, glass_named};
use tracer::transport::{
    Body, Corner, Curve, Falloff, LightSource, Material, PhotonPicture, PhotonTracer, Scene, SourceForm, into_gamut,
};

const MATT: Material = Material::Diffuse { reflectance: [0.5; 3] };

fn region(size: f64) -> Bounds {
    Bounds { min: DVec2::ZERO, max: DVec2::splat(size) }
}

fn lamp(x: f64, y: f64, power: f64, falloff: Falloff) -> LightSource {
    let form = SourceForm::Disc { center: DVec2::new(x, y), radius: 3.0 };
    LightSource { form, emission: Emission::EqualEnergy, power, falloff }
}

fn walls(corners: &[(f64, f64)], material: Material) -> Vec<Body> {
    let at = |index: usize| DVec2::new(corners[index % corners.len()].0, corners[index % corners.len()].1);
    let line = |index: usize| Curve::Line(Segment { a: at(index), b: at(index + 1) });
    (0..corners.len()).map(|index| Body::open([line(index)], material)).collect()
}

fn glass_disc(x: f64, y: f64, radius: f64) -> Body {
    let glass = Material::glass(Dispersion::Constant(1.5));
    Body::of_shape(&Shape::disc(DVec2::new(x, y), radius), glass)
}

fn baked(scene: &Scene, options: &BakeOptions) -> Bake {
    bake(scene, &Weights::equal_energy(), options, &|_, _| true).expect("nobody cancels it")
}

/// A circle with walls rho and a lamp in its middle: what comes from the walls is the same everywhere, rho P / (2 R (1 - rho)).
#[test]
fn a_round_room_is_filled_evenly_from_its_walls() {
    let radius = 100.0;
    for rho in [0.3, 0.8] {
        let wall = Material::Diffuse { reflectance: [rho; 3] };
        let room = Body::of_shape(&Shape::disc(DVec2::splat(radius), radius), wall);
        let form = SourceForm::Point(DVec2::splat(radius));
        let source = LightSource { form, emission: Emission::EqualEnergy, power: 50.0, falloff: Falloff::Plane };
        let scene = Scene { bodies: vec![room], sources: vec![source] };
        let options = BakeOptions { bounces: 60, packets: 60_000, ..BakeOptions::over(region(2.0 * radius)) };
        let bake = baked(&scene, &options);
        let expected = rho * 50.0 / (2.0 * radius * (1.0 - rho));
        let mut random = SplitMix64::new(1);
        let (mut sum, mut count) = (0.0, 0);
        for _ in 0..2_000 {
            let point = random.point_within(DVec2::splat(2.0 * radius));
            if point.distance(DVec2::splat(radius)) > radius {
                assert_eq!(bake.fluence(point, &[[1.0; 3]]), [0.0; 3]);
                continue;
            }
            for channel in bake.fluence(point, &[[1.0; 3]]) {
                assert!((channel / expected - 1.0).abs() < 0.1, "{rho} {point}: {channel} {expected}");
                (sum, count) = (sum + channel, count + 1);
            }
        }
        let mean = sum / f64::from(count);
        assert!((mean / expected - 1.0).abs() < 0.005, "{rho}: {mean} {expected}");
    }
}

/// A matt room in colours, with things of matt and of glass and a mirror in it.
fn furnished(falloff: Falloff) -> Scene {
    let mut bodies = walls(
        &[(0.0, 0.0), (200.0, 0.0), (200.0, 200.0), (0.0, 200.0)],
        Material::Diffuse { reflectance: [0.7, 0.5, 0.3] },
    );
    bodies.push(Body::of_shape(&Shape::capsule(DVec2::new(60.0, 130.0), DVec2::new(90.0, 150.0), 7.0), MATT));
    bodies.push(Body::of_shape(&Shape::disc(DVec2::new(150.0, 140.0), 15.0), MATT));
    bodies.push(glass_disc(130.0, 60.0, 18.0));
    let corners = [(30.0, 60.0), (60.0, 70.0), (40.0, 90.0)].map(|(x, y)| Corner::Point(DVec2::new(x, y)));
    let flint = Material::glass(glass_named("N-SF11").expect("it is known"));
    bodies.push(Body::closed(&corners, flint).expect("it has area"));
    let mirror = Curve::Line(Segment { a: DVec2::new(20.0, 150.0), b: DVec2::new(40.0, 180.0) });
    bodies.push(Body::open([mirror], Material::MIRROR));
    let warm = LightSource { emission: Emission::Blackbody { kelvin: 3000.0 }, ..lamp(160.0, 30.0, 60.0, falloff) };
    Scene { bodies, sources: vec![lamp(100.0, 100.0, 100.0, falloff), warm] }
}

const SIDE: usize = 20;

fn view() -> View {
    View { width: SIDE, height: SIDE, origin_mm: DVec2::ZERO, mm_per_px: 10.0 }
}

/// A photon picture, with so many surfaces at most.
fn photons(scene: &Scene, seed: u64, most_surfaces: u32) -> Vec<[f64; 3]> {
    let tracer = PhotonTracer::new(scene, Weights::equal_energy(), seed).with_most_surfaces(most_surfaces);
    let mut picture = PhotonPicture::new(tracer, view());
    picture.expose(PACKETS);
    picture.fluence()
}

const PACKETS: u64 = 400_000;

/// The bake in a pixel's mean.
fn pixels(bake: &Bake) -> Vec<[f64; 3]> {
    const POINTS: usize = 20;
    let mixed = bake.mixed(&vec![[1.0; 3]; bake.layers()]);
    let pixel = |at: usize| {
        let mut sum = [0.0; 3];
        for part in 0..POINTS * POINTS {
            let offset = DVec2::new((part % POINTS) as f64 + 0.5, (part / POINTS) as f64 + 0.5) / POINTS as f64;
            let place = DVec2::new((at % SIDE) as f64, (at / SIDE) as f64) + offset;
            let light = mixed.fluence(place * view().mm_per_px);
            (0..3).for_each(|channel| sum[channel] += light[channel] / (POINTS * POINTS) as f64);
        }
        sum
    };
    (0..SIDE * SIDE).map(pixel).collect()
}

/// The whole light of each pixel, as on a screen: by how many levels of 255 two pictures differ, pixel by pixel at most.
fn levels_apart(direct: &[[f64; 3]], one: &[[f64; 3]], other: &[[f64; 3]], exposure: f64) -> Vec<f32> {
    let screen = |direct: &[f64; 3], indirect: &[f64; 3]| {
        let sum = [0, 1, 2].map(|channel| (direct[channel] + indirect[channel]) * exposure);
        tracer::tone_map::displayed(into_gamut(sum).map(|channel| channel as f32)).map(|channel| 255.0 * channel)
    };
    let pairs = direct.iter().zip(one.iter().zip(other));
    let apart = pairs.map(|(direct, (one, other))| {
        let (one, other) = (screen(direct, one), screen(direct, other));
        (0..3).map(|channel| (one[channel] - other[channel]).abs()).fold(0.0, f32::max)
    });
    apart.collect()
}

/// The exposure at which the middle of all light is a third of full light.
fn exposure(light: &[[f64; 3]]) -> f64 {
    let mut green: Vec<f64> = light.iter().map(|pixel| pixel[1]).collect();
    green.sort_unstable_by(f64::total_cmp);
    0.35 / green[green.len() / 2]
}

/// How a baked frame and one of photons differ on a screen.
struct Difference {
    /// Levels of 255, by pixels.
    apart: Vec<f32>,
    /// Their root mean square, and what of it is the photons' noise, as their halves tell.
    rms: f32,
    noise: f32,
    /// The bake's indirect light over the photons'.
    ratio: f64,
}

fn difference(scene: &Scene, options: &BakeOptions) -> Difference {
    let halves = [1, 2].map(|seed| {
        let (direct, all) = (photons(scene, seed, 1), photons(scene, seed, 1000));
        let indirect = combined(&all, &direct, |all, direct| all - direct);
        (direct, indirect)
    });
    let [(one, a), (other, b)] = &halves;
    let mean = |a, b| 0.5 * (a + b);
    let (direct, indirect) = (combined(one, other, mean), combined(a, b, mean));
    let exposure = exposure(&combined(&direct, &indirect, |a, b| a + b));
    let own = pixels(&baked(scene, options));
    let apart = levels_apart(&direct, &indirect, &own, exposure);
    let noise = levels_apart(&direct, a, b, exposure);
    let rms = |of: &[f32]| (of.iter().map(|of| of * of).sum::<f32>() / of.len() as f32).sqrt();
    let sum = |of: &[[f64; 3]]| of.iter().flatten().sum::<f64>();
    Difference { rms: rms(&apart), noise: 0.5 * rms(&noise), apart, ratio: sum(&own) / sum(&indirect) }
}

const FALLOFFS: [Falloff; 2] = [Falloff::Plane, Falloff::Table { height_mm: 30.0, reach_mm: 500.0 }];

/// Between matt walls a baked frame is that of photons to a level of 255, but for what the photons themselves are off.
#[test]
fn a_baked_frame_between_matt_walls_is_the_one_that_photons_find() {
    for falloff in FALLOFFS {
        let mut scene = furnished(falloff);
        scene.bodies.retain(|body| matches!(body.material, Material::Diffuse { .. }));
        let options = BakeOptions { bounces: 100, packets: 50_000, ..BakeOptions::over(region(200.0)) };
        let Difference { apart, rms, noise, ratio } = difference(&scene, &options);
        let most = apart.into_iter().fold(0.0, f32::max);
        println!("{falloff:?}: rms {rms} with {noise} of noise, most {most}, ratio {ratio}");
        assert!(rms * rms < noise * noise + 0.4 * 0.4, "{falloff:?}: {rms} {noise}");
        assert!(most < 1.0 + 4.0 * noise, "{falloff:?}: {most} {noise}");
        assert!((ratio - 1.0).abs() < 0.004, "{falloff:?}: {ratio}");
    }
}

/// With glass, a prism and a mirror in the room the light is the same in all; caustics, which are finer than cells, are as soft
/// as these.
#[test]
fn a_baked_frame_with_caustics_has_the_light_that_photons_find() {
    for falloff in FALLOFFS {
        let options = BakeOptions { bounces: 100, packets: 50_000, ..BakeOptions::over(region(200.0)) };
        let Difference { rms, noise, ratio, .. } = difference(&furnished(falloff), &options);
        println!("{falloff:?}: rms {rms} with {noise} of noise, ratio {ratio}");
        assert!(rms < 1.5, "{falloff:?}: {rms} {noise}");
        assert!((ratio - 1.0).abs() < 0.008, "{falloff:?}: {ratio}");
    }
}

fn combined(one: &[[f64; 3]], other: &[[f64; 3]], with: impl Fn(f64, f64) -> f64) -> Vec<[f64; 3]> {
    one.iter().zip(other).map(|(one, other)| std::array::from_fn(|at| with(one[at], other[at]))).collect()
}

/// Two rooms with a wall without thickness between, which crosses cells slantwise: there is no light at all in the dark one.
#[test]
fn no_light_goes_through_a_thin_wall() {
    let mut bodies = walls(&[(0.0, 0.0), (200.0, 0.0), (200.0, 200.0), (0.0, 200.0)], MATT);
    let wall = Segment { a: DVec2::new(103.0, 0.0), b: DVec2::new(92.0, 200.0) };
    bodies.push(Body::open([Curve::Line(wall)], MATT));
    bodies.push(glass_disc(70.0, 60.0, 15.0));
    bodies.push(Body::of_shape(&Shape::disc(DVec2::new(160.0, 60.0), 15.0), MATT));
    let scene = Scene { bodies, sources: vec![lamp(40.0, 100.0, 100.0, Falloff::Plane)] };
    let bake = baked(&scene, &BakeOptions { packets: 20_000, ..BakeOptions::over(region(200.0)) });
    let mut random = SplitMix64::new(3);
    let normal = wall.left_normal().expect("it has a length");
    let mut lit = 0;
    for turn in 0..20_000 {
        let mut point = random.point_within(DVec2::splat(200.0));
        if turn % 2 == 0 {
            // Close to the wall, on either side.
            point =
                wall.a + wall.along() * random.unit() + normal * random.uniform(-1.0, 1.0) * [5.0, 1e-3][turn / 2 % 2];
        }
        let light = bake.fluence(point, &[[1.0; 3]]);
        // The normal is on the left of the way from above to below (y down): towards the lamp.
        if (point - wall.a).dot(normal) < 0.0 {
            assert_eq!(light, [0.0; 3], "{point}");
        } else {
            lit += usize::from(light[1] > 0.0);
        }
    }
    assert!(lit > 8_000, "{lit}");
}

fn coarse() -> BakeOptions {
    BakeOptions { cell_mm: 10.0, packets: 2_000, ..BakeOptions::over(region(200.0)) }
}

/// A frame under two lamps is the sum of their layers, and a lamp's layer is that of the scene with this lamp alone.
#[test]
fn light_is_linear_in_the_lamps() {
    let scene = furnished(Falloff::Plane);
    let (both, alone) = (baked(&scene, &coarse()), Scene { sources: vec![scene.sources[0].clone()], ..scene });
    let alone = baked(&alone, &coarse());
    assert_eq!((both.layers(), alone.layers()), (2, 1));
    let (one, other) = ([0.3, 2.0, 0.7], [4.0, 0.25, 1.5]);
    let mixed = both.mixed(&[one, other]);
    let mut random = SplitMix64::new(5);
    for _ in 0..500 {
        let point = random.point_within(DVec2::splat(200.0));
        let [first, second] = [[[1.0; 3], [0.0; 3]], [[0.0; 3], [1.0; 3]]].map(|colors| both.fluence(point, &colors));
        let sum = both.fluence(point, &[one, other]);
        let own = alone.fluence(point, &[[1.0; 3]]);
        for channel in 0..3 {
            let expected = first[channel] * one[channel] + second[channel] * other[channel];
            // A layer's numbers have 24 bits.
            assert!((sum[channel] - expected).abs() <= 1e-6 * expected.abs());
            assert!((mixed.fluence(point)[channel] - expected).abs() <= 1e-6 * expected.abs());
            assert!((own[channel] - first[channel]).abs() <= 1e-6 * own[channel].abs());
        }
    }
}

/// The same bytes on one, two and five threads; and what is read back is what was written.
#[test]
fn a_bake_is_the_same_on_any_number_of_threads_and_after_reading() {
    let scene = furnished(Falloff::Table { height_mm: 30.0, reach_mm: 500.0 });
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| baked(&scene, &coarse()))
    };
    let one = on(1);
    let bytes = one.to_bytes();
    for threads in [2, 5] {
        assert!(on(threads).to_bytes() == bytes, "{threads} threads");
    }
    let weights = Weights::equal_energy();
    let read = Bake::from_bytes(&bytes, &scene, &weights).expect("what was written");
    assert!(read == one && read.to_bytes() == bytes);
    let point = DVec2::new(77.0, 88.0);
    assert_eq!(read.fluence(point, &[[1.0; 3]; 2]), one.fluence(point, &[[1.0; 3]; 2]));
}

/// Whatever byte is another, and wherever the bytes end, is a sentence; so is another version or another scene.
#[test]
fn damaged_bytes_are_a_sentence() {
    let scene = furnished(Falloff::Plane);
    let weights = Weights::equal_energy();
    let bytes = baked(&scene, &BakeOptions { packets: 100, cell_mm: 40.0, ..coarse() }).to_bytes();
    assert!(Bake::from_bytes(&bytes, &scene, &weights).is_ok());
    let mut random = SplitMix64::new(8);
    for _ in 0..200 {
        let mut other = bytes.clone();
        let at = random.below(bytes.len() as u64) as usize;
        other[at] ^= 1 << random.below(8);
        assert!(Bake::from_bytes(&other, &scene, &weights).is_err(), "byte {at}");
        assert!(Bake::from_bytes(&bytes[..at], &scene, &weights).is_err(), "{at} bytes");
    }
    let mut newer = bytes.clone();
    newer[8] += 1;
    let why = Bake::from_bytes(&newer, &scene, &weights).expect_err("another version");
    assert!(why.contains("version"), "{why}");
    let moved = Scene { sources: vec![lamp(100.0, 100.5, 100.0, Falloff::Plane)], ..scene };
    let why = Bake::from_bytes(&bytes, &moved, &weights).expect_err("another scene");
    assert!(why.contains("another scene"), "{why}");
}

/// A bake that is told to stop is none, and does next to nothing more; one that is not tells all that it does.
#[test]
fn a_bake_can_be_cancelled_at_any_time() {
    let scene = furnished(Falloff::Plane);
    let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build().expect("threads");
    let run = |most: u64| {
        let (asked, last) = (AtomicU64::new(0), AtomicU64::new(0));
        let progress = |done: u64, all: u64| {
            assert!(done <= all);
            last.fetch_max(done * 1000 / all, Ordering::Relaxed);
            asked.fetch_add(1, Ordering::Relaxed) < most
        };
        let made = pool.install(|| bake(&scene, &Weights::equal_energy(), &coarse(), &progress));
        (made.is_some(), asked.into_inner(), last.into_inner())
    };
    let (made, all, last) = run(u64::MAX);
    assert!(made && last == 1000);
    for most in 0..all {
        let (made, asked, _) = run(most);
        // The other thread may be asking too.
        assert!(!made && asked <= most + 2, "{most}: {asked}");
    }
}
