//! Photons and paths find the same light, wherever both can: they share the interaction with a surface and nothing else.

use geometry::rng::SplitMix64;
use geometry::{DVec2, Segment, Shape};
use tracer::View;
use tracer::transport::beams::{BeamOptions, BeamPicture, BeamTracer};
use tracer::transport::spectrum::{Dispersion, Emission, Weights, glass_named, metal_named};
use tracer::transport::{
    Body, Curve, Dielectric, Falloff, LightSource, Material, PathPicture, PathTracer, PhotonPicture, PhotonTracer,
    Scene, SourceForm,
};

const SIDE: usize = 12;
const SCENES: u64 = 20;

fn view() -> View {
    View { width: SIDE, height: SIDE, origin_mm: DVec2::ZERO, mm_per_px: 10.0 }
}

/// A closed matt room with things in it.
fn scene(seed: u64) -> Scene {
    let mut random = SplitMix64::new(seed);
    let room = [(0.0, 0.0), (120.0, 0.0), (120.0, 120.0), (0.0, 120.0)].map(|(x, y)| DVec2::new(x, y));
    let mut bodies: Vec<Body> = (0..4)
        .map(|side| {
            let line = Curve::Line(Segment { a: room[side], b: room[(side + 1) % 4] });
            Body::open([line], Material::Diffuse { reflectance: [0.7, 0.5, 0.3] })
        })
        .collect();
    let glass = |random: &mut SplitMix64| {
        let clear = Dielectric::clear(match random.below(3) {
            0 => Dispersion::Constant(1.6),
            1 => glass_named("N-SF11").expect("it is known"),
            _ => glass_named("water").expect("it is known"),
        });
        let transmittance_per_mm = if random.below(2) == 0 { [1.0; 3] } else { [0.99, 0.97, 0.95] };
        let roughness = if random.below(3) == 0 { 0.2 } else { 0.0 };
        Material::Dielectric(Dielectric { transmittance_per_mm, roughness, ..clear })
    };
    for place in [(35.0, 35.0), (85.0, 35.0), (35.0, 85.0), (85.0, 85.0)] {
        let at = DVec2::new(place.0, place.1) + random.point_within(DVec2::splat(8.0)) - 4.0;
        let end = at + random.point_within(DVec2::splat(24.0)) - 12.0;
        bodies.push(match random.below(6) {
            0 => Body::of_shape(&Shape::disc(at, 12.0), glass(&mut random)),
            1 => Body::of_shape(&Shape::capsule(at, end, 6.0), glass(&mut random)),
            2 => {
                Body::of_shape(&Shape::disc(at, 9.0), Material::Mirror { reflectance: [0.9, 0.8, 0.5], roughness: 0.3 })
            }
            3 => {
                let metal = metal_named("copper").expect("it is known");
                Body::of_shape(&Shape::capsule(at, end, 2.0), Material::Metal { metal, roughness: 0.0 })
            }
            4 => Body::open([Curve::Line(Segment { a: at, b: end })], Material::BeamSplitter { transmittance: 0.4 }),
            _ => Body::of_shape(&Shape::disc(at, 10.0), Material::Diffuse { reflectance: [0.2, 0.6, 0.9] }),
        });
    }
    let falloff =
        if seed.is_multiple_of(3) { Falloff::Table { height_mm: 30.0, reach_mm: 600.0 } } else { Falloff::Plane };
    let source = |form, emission, power| LightSource { form, emission, power, falloff };
    let disc = SourceForm::Disc { center: DVec2::new(60.0, 60.0), radius: 5.0 };
    let tube = SourceForm::Tube(Segment { a: DVec2::new(50.0, 15.0), b: DVec2::new(75.0, 14.0) });
    let sources = vec![
        source(disc, Emission::Blackbody { kelvin: 4000.0 }, 100.0),
        source(tube, Emission::Color([0.2, 0.5, 1.0]), 80.0),
    ];
    Scene { bodies, sources }
}

/// In every pixel away from the tube, in all three channels, over twenty scenes: the difference is that of the noise, which two
/// halves of each picture tell.
#[test]
fn photons_and_paths_find_the_same_light() {
    let mut relative = 0.0;
    for seed in 0..SCENES {
        let scene = scene(seed);
        let photons = |seed: u64| {
            let mut picture = PhotonPicture::new(PhotonTracer::new(&scene, Weights::equal_energy(), seed), view());
            picture.expose(60_000);
            picture.fluence()
        };
        let paths = |seed: u64| {
            let mut picture = PathPicture::new(PathTracer::new(&scene, Weights::equal_energy(), seed), view(), 16);
            (0..12).for_each(|_| picture.expose());
            picture.fluence()
        };
        let (one, two) = ([photons(1), photons(2)], [paths(3), paths(4)]);
        let (mut apart, mut noise, mut bias, mut sum) = (0.0, 0.0, 0.0, 0.0);
        for pixel in 0..SIDE * SIDE {
            for channel in 0..3 {
                let of = |pictures: &[Vec<[f64; 3]>; 2]| {
                    let [a, b] = [0, 1].map(|half| pictures[half][pixel][channel]);
                    (0.5 * (a + b), 0.25 * (a - b) * (a - b))
                };
                let ((a, a_noise), (b, b_noise)) = (of(&one), of(&two));
                apart += (a - b) * (a - b);
                noise += a_noise + b_noise;
                bias += a - b;
                sum += a + b;
            }
        }
        assert!(apart < 2.0 * noise, "scene {seed}: {apart} against {noise} of noise");
        relative += bias / (0.5 * sum) / SCENES as f64;
    }
    // Of one scene the whole differs by a hundredth, since a photon's way crosses many pixels.
    assert!(relative.abs() < 0.004, "{relative}");
}

/// Photons, paths and beams add up to the same bits on one thread and on three.
#[test]
fn pictures_are_the_same_on_any_number_of_threads() {
    let scene = scene(1);
    let pictures = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| {
            let weights = Weights::equal_energy();
            let mut photons = PhotonPicture::new(PhotonTracer::new(&scene, weights.clone(), 1), view());
            photons.expose(20_000);
            let mut paths = PathPicture::new(PathTracer::new(&scene, weights.clone(), 1), view(), 4);
            paths.expose();
            let options =
                BeamOptions { beams: 32, wavelengths: 4, widths: 2, most_surfaces: 4, ..BeamOptions::default() };
            let mut beams = BeamPicture::new(BeamTracer::new(&scene, &weights, options), view());
            while beams.expose(3, &|| true) {}
            [photons.fluence(), paths.fluence(), beams.fluence()]
        })
    };
    let [one, three] = [pictures(1), pictures(3)];
    assert_eq!(one, three);
    assert!(one.iter().all(|picture| picture.iter().any(|pixel| pixel[1] > 0.0)));
}
