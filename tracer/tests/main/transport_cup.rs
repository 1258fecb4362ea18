//! A closed mirror keeps its light.

use geometry::{DVec2, Shape};
use tracer::transport::spectrum::{Emission, Weights};
use tracer::transport::{Body, Falloff, LightSource, Material, PhotonTracer, Scene, SourceForm};

/// A lamp near the rim of a round mirror: its light goes round in chords that hardly meet the rim, and none may slip through.
#[test]
fn no_light_leaves_a_closed_mirror() {
    let center = DVec2::splat(270.0);
    let cup = Body::of_shape(&Shape::disc(center, 240.0), Material::Mirror { reflectance: [0.9; 3], roughness: 0.0 });
    for form in [
        SourceForm::Disc { center: DVec2::new(270.0, 506.0), radius: 1.5 },
        SourceForm::Disc { center: DVec2::new(270.0, 508.0), radius: 2.0 },
        SourceForm::Point(DVec2::new(270.0, 509.999_999)),
    ] {
        let lamp = LightSource { form, emission: Emission::EqualEnergy, power: 1.0, falloff: Falloff::Plane };
        let scene = Scene { bodies: vec![cup.clone()], sources: vec![lamp] };
        let tracer = PhotonTracer::new(&scene, Weights::equal_energy(), 0);
        let counts = tracer.trace(0..200_000, |_, _| {});
        assert_eq!((counts.gone, counts.given_up), (0, 0), "{form:?}: {counts:?}");
        assert_eq!(counts.absorbed, counts.sent);
    }
}
