//! Polished segments, circles and glass, thrown into a matt room: what light meets in a scene of transport.

use crate::transport::spectrum::{Dispersion, Emission, glass_named, metal_named};
use crate::transport::{Body, Curve, Dielectric, Falloff, LightSource, Material, Scene, SourceForm};
use geometry::rng::SplitMix64;
use geometry::{DVec2, Segment, Shape, trig};
use std::f64::consts::TAU;

/// The size of the room, mm.
pub const OPTICAL_JUMBLE_MM: DVec2 = DVec2::new(540.0, 1080.0);

/// A matt room with `count` segments, circles and pieces of glass in it, a third of each, of every material that there is, and
/// with three lamps. What is thrown may overlap, as glass in glass does.
pub fn optical_jumble(count: usize, seed: u64) -> Scene {
    let mut random = SplitMix64::new(seed);
    let size = OPTICAL_JUMBLE_MM;
    let corners = [DVec2::ZERO, DVec2::new(size.x, 0.0), size, DVec2::new(0.0, size.y)];
    let wall = |side: usize| Curve::Line(Segment { a: corners[side], b: corners[(side + 1) % 4] });
    let matt = Material::Diffuse { reflectance: [0.8, 0.75, 0.7] };
    let mut bodies = vec![Body::open((0..4).map(wall), matt)];
    for number in 0..count {
        let at = random.point_within(size);
        bodies.push(match number % 3 {
            0 => segment(at, &mut random),
            1 => Body::of_shape(&Shape::disc(at, random.uniform(4.0, 14.0)), opaque(&mut random)),
            _ => piece_of_glass(at, &mut random),
        });
    }
    let source = |form, emission| LightSource { form, emission, power: 100.0, falloff: Falloff::Plane };
    let [a, b, c] = [DVec2::new(0.3, 0.2), DVec2::new(0.7, 0.5), DVec2::new(0.4, 0.8)].map(|place| place * size);
    let sources = vec![
        source(SourceForm::Disc { center: a, radius: 6.0 }, Emission::Blackbody { kelvin: 4000.0 }),
        source(SourceForm::Tube(Segment { a: b, b: b + DVec2::new(60.0, 20.0) }), Emission::Color([0.2, 0.5, 1.0])),
        source(SourceForm::Point(c), Emission::EqualEnergy),
    ];
    Scene { bodies, sources }
}

fn segment(at: DVec2, random: &mut SplitMix64) -> Body {
    let to = at + trig::direction(random.uniform(0.0, TAU)) * random.uniform(20.0, 60.0);
    let material = match random.below(4) {
        0 => Material::MIRROR,
        1 => Material::Mirror { reflectance: [0.9, 0.8, 0.6], roughness: 0.0 },
        2 => Material::BeamSplitter { transmittance: 0.5 },
        _ => Material::Diffuse { reflectance: [0.6; 3] },
    };
    Body::open([Curve::Line(Segment { a: at, b: to })], material)
}

fn opaque(random: &mut SplitMix64) -> Material {
    match random.below(4) {
        0 => Material::Mirror { reflectance: [0.9; 3], roughness: 0.0 },
        1 => Material::Metal { metal: metal_named("copper").expect("it is known"), roughness: 0.0 },
        2 => Material::Diffuse { reflectance: [0.2, 0.6, 0.9] },
        _ => Material::Absorber,
    }
}

fn piece_of_glass(at: DVec2, random: &mut SplitMix64) -> Body {
    let clear = Dielectric::clear(match random.below(4) {
        0 => glass_named("N-SF11").expect("it is known"),
        1 => glass_named("water").expect("it is known"),
        _ => Dispersion::Constant(1.5),
    });
    let transmittance_per_mm = if random.below(8) == 0 { [0.99, 0.97, 0.95] } else { [1.0; 3] };
    let material = Material::Dielectric(Dielectric { transmittance_per_mm, ..clear });
    let shape = match random.below(2) {
        0 => Shape::disc(at, random.uniform(6.0, 16.0)),
        _ => Shape::capsule(at, at + trig::direction(random.uniform(0.0, TAU)) * 24.0, random.uniform(3.0, 8.0)),
    };
    Body::of_shape(&shape, material)
}
