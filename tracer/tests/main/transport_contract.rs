//! What holds of light transport whatever the scene is: nothing is lost, lamp and eye may change places, white things and glass
//! like air change nothing, and there is an end.

use geometry::{DVec2, Segment, Shape};
use tracer::View;
use tracer::scenes::{OPTICAL_JUMBLE_MM, optical_jumble};
use tracer::transport::spectrum::{Dispersion, Emission, Weights, metal_named};
use tracer::transport::{
    Band, Body, Corner, Counts, Curve, Dielectric, Falloff, LightSource, Material, PhotonPicture, PhotonTracer, Scene,
    SourceForm,
};

fn lamp(form: SourceForm) -> LightSource {
    LightSource { form, emission: Emission::EqualEnergy, power: 1.0, falloff: Falloff::Plane }
}

fn disc(x: f64, y: f64, radius: f64, material: Material) -> Body {
    Body::of_shape(&Shape::disc(DVec2::new(x, y), radius), material)
}

fn glass(index: f64) -> Material {
    Material::glass(Dispersion::Constant(index))
}

fn line(from: [f64; 2], to: [f64; 2], material: Material) -> Body {
    let [a, b] = [from, to].map(DVec2::from_array);
    Body::open([Curve::Line(Segment { a, b })], material)
}

fn fluence(scene: &Scene, view: View, packets: u64) -> (Vec<[f64; 3]>, Counts) {
    let mut picture = PhotonPicture::new(PhotonTracer::new(scene, Weights::equal_energy(), 1), view);
    picture.expose(packets);
    (picture.fluence(), *picture.counts())
}

fn traced(scene: &Scene, packets: u64, most_surfaces: u32) -> Counts {
    let tracer = PhotonTracer::new(scene, Weights::equal_energy(), 1).with_most_surfaces(most_surfaces);
    tracer.trace(0..packets, |_, _| {})
}

/// Every packet is absorbed, gone or given up, and has on all of its way the power with which it left: with every material that
/// there is, rough ones, absorbing ones and ones that act on some wavelengths, and with a bound that is met.
#[test]
fn what_is_sent_is_absorbed_or_gone_or_given_up() {
    let mut scene = optical_jumble(60, 5);
    // Without the room some of it is gone.
    scene.bodies.remove(0);
    let metal = metal_named("gold").expect("it is known");
    let stained = Dielectric {
        transmittance_per_mm: [0.9, 0.95, 0.99],
        roughness: 0.1,
        ..Dielectric::clear(Dispersion::Constant(1.4))
    };
    let band = Band { middle_nm: 550.0, half_nm: 40.0, inverted: false };
    scene.bodies.extend([
        disc(270.0, 540.0, 30.0, Material::Dielectric(stained)),
        disc(200.0, 300.0, 20.0, Material::Metal { metal, roughness: 0.2 }),
        line([10.0, 500.0], [200.0, 520.0], Material::IdealLens { focal_length: 80.0 }),
        line([300.0, 500.0], [500.0, 450.0], Material::IdealMirror { focal_length: -60.0 }),
        disc(400.0, 800.0, 25.0, Material::MIRROR).in_band(band),
    ]);
    let mut powers: Vec<f64> = Vec::new();
    let tracer = PhotonTracer::new(&scene, Weights::equal_energy(), 1).with_most_surfaces(6);
    let (mut start, mut way) = (0.0, f64::INFINITY);
    let counts = tracer.trace(0..20_000, |flight, _| {
        let power = flight.photon.total_power();
        // A packet goes on where it was, and another one does not.
        if flight.photon.way != way {
            start = power;
            powers.push(power);
        }
        way = flight.photon.way + flight.distance;
        assert!((power / start - 1.0).abs() < 1e-12, "{power} {start}");
    });
    assert_eq!(counts.sent, counts.absorbed + counts.gone + counts.given_up);
    assert_eq!((counts.sent, powers.len()), (20_000, 20_000));
    assert!(counts.absorbed > 1_000 && counts.gone > 1_000 && counts.given_up > 100, "{counts:?}");
}

/// The mean of the green over one square pixel round a point.
fn at(bodies: &[Body], from: DVec2, to: DVec2) -> f64 {
    let scene = Scene { bodies: bodies.to_vec(), sources: vec![lamp(SourceForm::Point(from))] };
    let side = 6.0;
    let view = View { width: 1, height: 1, origin_mm: to - side * 0.5, mm_per_px: side };
    fluence(&scene, view, 300_000).0[0][1]
}

/// Lamp and eye may change places: the fluence times the index at the lamp stays. Between, there are glass, mirrors, a splitter and
/// matt walls; one of the two points may lie in glass.
#[test]
fn lamp_and_eye_may_change_places() {
    let bodies = [
        disc(0.0, 0.0, 150.0, Material::Diffuse { reflectance: [0.5; 3] }),
        disc(-50.0, 0.0, 22.0, glass(1.5)),
        disc(10.0, 35.0, 14.0, glass(1.8)),
        line([-10.0, -60.0], [60.0, -50.0], Material::MIRROR),
        line([-20.0, -30.0], [10.0, 20.0], Material::BeamSplitter { transmittance: 0.4 }),
    ];
    let (in_glass, open) = (DVec2::new(-45.0, 8.0), DVec2::new(60.0, 10.0));
    let (left, right) = (DVec2::new(-90.0, -20.0), DVec2::new(50.0, 60.0));
    for (a, b, [index_a, index_b]) in [(in_glass, open, [1.5, 1.0]), (left, right, [1.0, 1.0])] {
        let (there, back) = (at(&bodies, a, b) * index_a, at(&bodies, b, a) * index_b);
        // Some 4,000 packets in each pixel: 1.6 % of noise each.
        assert!((there / back - 1.0).abs() < 0.06, "{there} {back}");
    }
}

/// In a closed matt room of the reflectance rho each packet ends at the walls, so pi P / ((1 - rho) perimeter) is the fluence
/// everywhere but near the lamp, whatever white things are in it; within glass it is that times the index, within R / n.
#[test]
fn white_things_in_a_white_room_are_not_seen() {
    let (rho, radius) = (0.97, 60.0);
    let scene = Scene {
        bodies: vec![
            disc(0.0, 0.0, radius, Material::Diffuse { reflectance: [rho; 3] }),
            disc(-25.0, 10.0, 10.0, Material::Diffuse { reflectance: [1.0; 3] }),
            disc(5.0, 30.0, 9.0, Material::MIRROR),
            disc(-10.0, -25.0, 12.0, glass(1.5)),
        ],
        sources: vec![lamp(SourceForm::Point(DVec2::new(40.0, -20.0)))],
    };
    let view = View { width: 60, height: 60, origin_mm: DVec2::splat(-60.0), mm_per_px: 2.0 };
    let (fluence, counts) = fluence(&scene, view, 40_000);
    assert_eq!(counts.sent, counts.absorbed);
    let expected = 1.0 / (2.0 * radius * (1.0 - rho));
    let mean = |wanted: &dyn Fn(DVec2) -> bool| {
        let pixels = (0..60 * 60).filter(|pixel| wanted(view.table_from_pixel(pixel % 60, pixel / 60)));
        let (sum, count) = pixels.fold((0.0, 0.0), |(sum, count), pixel| (sum + fluence[pixel][1], count + 1.0));
        sum / count
    };
    let things = [(-25.0, 10.0, 12.0), (5.0, 30.0, 11.0), (-10.0, -25.0, 14.0)];
    let open = mean(&|at| {
        let is_free = things.iter().all(|(x, y, radius)| at.distance(DVec2::new(*x, *y)) > *radius);
        is_free && at.length() < 55.0 && at.distance(DVec2::new(40.0, -20.0)) > 50.0
    });
    // What has met no wall yet is the part 1 - rho of all, and not even.
    assert!((open / expected - 1.0).abs() < 1.0 - rho, "{open} {expected}");
    let inside = mean(&|at| at.distance(DVec2::new(-10.0, -25.0)) < 12.0 / 1.5 - 1.5);
    assert!((inside / (1.5 * expected) - 1.0).abs() < 2.0 * (1.0 - rho), "{inside} {expected}");
}

/// Glass of index 1 vanishes: where nothing is left to chance the pictures are the same but for the rounding.
#[test]
fn glass_like_air_is_not_there() {
    let view = View { width: 30, height: 30, origin_mm: DVec2::splat(-60.0), mm_per_px: 4.0 };
    let room = || vec![disc(0.0, 0.0, 90.0, Material::Absorber), line([-50.0, -20.0], [-30.0, 40.0], Material::MIRROR)];
    let picture = |bodies: Vec<Body>| {
        let scene = Scene { bodies, sources: vec![lamp(SourceForm::Point(DVec2::new(20.0, 30.0)))] };
        fluence(&scene, view, 20_000).0
    };
    let capsule = Shape::capsule(DVec2::new(-20.0, -10.0), DVec2::new(15.0, 0.0), 9.0);
    let like_air = [disc(0.0, 0.0, 17.0, glass(1.0)), Body::of_shape(&capsule, glass(1.0))];
    let (empty, with_glass) = (picture(room()), picture(room().into_iter().chain(like_air).collect()));
    let brightest = empty.iter().map(|pixel| pixel[1]).fold(0.0, f64::max);
    for (a, b) in empty.iter().zip(&with_glass) {
        assert!((0..3).all(|of| (a[of] - b[of]).abs() < 1e-6 * brightest), "{a:?} {b:?}");
    }
    assert!(brightest > 0.0);
}

/// Light that total reflection keeps for ever in a square of glass is given up at the bound, and counted.
#[test]
fn what_a_bound_takes_is_counted() {
    let corners = [(-10.0, -10.0), (10.0, -10.0), (10.0, 10.0), (-10.0, 10.0)];
    let square = Body::closed(&corners.map(|(x, y)| Corner::Point(DVec2::new(x, y))), glass(1.5)).expect("it has area");
    // At 45 degrees to all four sides, beyond 41.8.
    let line = Segment { a: DVec2::new(-2.0, -1.0), b: DVec2::new(1.0, 2.0) };
    let scene = Scene { bodies: vec![square], sources: vec![lamp(SourceForm::Beam { line, half_angle: 0.02 })] };
    let counts = traced(&scene, 500, 200);
    assert_eq!(counts, Counts { sent: 500, given_up: 500, segments: 500 * 200, ..Counts::default() });
}

/// Glasses that touch along an edge, at a corner and at a point, and the same one twice; shapes of no size; lamps on a surface, on a
/// corner and in the wall; scenes with nothing in them.
#[test]
fn degenerate_scenes_have_an_answer() {
    let at = DVec2::new(5.0, 5.0);
    let square = |x: f64| {
        let corners = [(x, 0.0), (x + 10.0, 0.0), (x + 10.0, 10.0), (x, 10.0)];
        Body::closed(&corners.map(|(x, y)| Corner::Point(DVec2::new(x, y))), glass(1.5)).expect("it has area")
    };
    let sizeless = |material: Material| {
        vec![
            disc(5.0, 5.0, 0.0, material),
            line([5.0, 5.0], [5.0, 5.0], material),
            Body::of_shape(&Shape::capsule(at, at, 0.0), material),
            Body::of_shape(&Shape::capsule(at, at, 3.0), material),
        ]
    };
    let scenes = [
        vec![],
        vec![
            square(0.0),
            square(10.0),
            square(0.0),
            disc(25.0, 5.0, 5.0, glass(1.7)),
            disc(15.0, 15.0, 5.0, glass(1.2)),
        ],
        sizeless(glass(1.5)),
        sizeless(Material::MIRROR),
        sizeless(Material::Diffuse { reflectance: [1.0; 3] }),
        vec![disc(5.0, 5.0, 5.0, Material::Diffuse { reflectance: [0.9; 3] }), square(0.0)],
    ];
    let lamps = [
        SourceForm::Point(DVec2::new(0.0, 5.0)),
        SourceForm::Point(DVec2::new(10.0, 10.0)),
        SourceForm::Point(at),
        SourceForm::Disc { center: DVec2::new(10.0, 5.0), radius: 2.0 },
        SourceForm::Tube(Segment { a: DVec2::new(10.0, 0.0), b: DVec2::new(10.0, 10.0) }),
        SourceForm::Beam { line: Segment { a: DVec2::new(0.0, 10.0), b: DVec2::new(10.0, 10.0) }, half_angle: 0.0 },
    ];
    for (number, bodies) in scenes.into_iter().enumerate() {
        for form in lamps {
            let scene = Scene { bodies: bodies.clone(), sources: vec![lamp(form)] };
            let view = View { width: 8, height: 8, origin_mm: DVec2::splat(-5.0), mm_per_px: 4.0 };
            let (fluence, counts) = fluence(&scene, view, 500);
            assert_eq!(counts.sent, counts.absorbed + counts.gone + counts.given_up, "{number} {form:?}");
            assert!(fluence.iter().flatten().all(|channel| channel.is_finite()), "{number} {form:?}");
        }
    }
    assert_eq!(traced(&Scene::default(), 100, 10), Counts::default());
}

/// A hundred thousand things: a packet asks few of them, and all are accounted for.
#[test]
fn a_hundred_thousand_things_are_no_hang() {
    let mut scene = optical_jumble(100_000, 1);
    let small = |body: &Body| matches!(body.material, Material::Dielectric(_) | Material::Mirror { .. });
    assert!(scene.bodies.iter().filter(|body| small(body)).count() > 40_000);
    scene.sources.push(lamp(SourceForm::Disc { center: OPTICAL_JUMBLE_MM * 0.5, radius: 1.0 }));
    let counts = traced(&scene, 300, 1_000);
    assert_eq!((counts.sent, counts.absorbed + counts.gone + counts.given_up), (300, 300));
    assert!(counts.segments > 1_000, "{counts:?}");
}
