//! Light that is bent and scattered, against answers that are known without tracing a packet.

use geometry::{DVec2, Ray, Shape, trig};
use std::f64::consts::TAU;
use tracer::View;
use tracer::transport::interaction::{Branch, Interaction, interact};
use tracer::transport::spectrum::{Dispersion, Emission, Weights, glass_named};
use tracer::transport::{
    Body, Corner, Falloff, LightSource, Material, PhotonPicture, PhotonTracer, Scene, SourceForm, StartsOn, Surfaces,
};

/// Fraunhofer's lines F, d and C, nm.
const LINES_NM: [f64; 3] = [486.134, 587.562, 656.281];

fn white(form: SourceForm, power: f64) -> LightSource {
    LightSource { form, emission: Emission::EqualEnergy, power, falloff: Falloff::Plane }
}

fn view(width: usize, height: usize, origin_mm: DVec2, mm_per_px: f64) -> View {
    View { width, height, origin_mm, mm_per_px }
}

fn picture<'a>(scene: &'a Scene, view: View, packets: u64) -> PhotonPicture<'a> {
    let mut picture = PhotonPicture::new(PhotonTracer::new(scene, Weights::equal_energy(), 1), view);
    picture.expose(packets);
    picture
}

/// The mean of a picture's green, which equal energy makes 1, over the pixels that `wanted` holds, and of `expected` there.
fn means(picture: &PhotonPicture, view: &View, expected: impl Fn(DVec2) -> Option<f64>) -> (f64, f64) {
    let fluence = picture.fluence();
    let (mut sum, mut known, mut count) = (0.0, 0.0, 0.0);
    for y in 0..view.height {
        for x in 0..view.width {
            if let Some(expected) = expected(view.table_from_pixel(x, y)) {
                sum += fluence[y * view.width + x][1];
                known += expected;
                count += 1.0;
            }
        }
    }
    (sum / count, known / count)
}

/// A disc of `dispersion` round the origin.
fn disc_of(radius: f64, material: Material) -> Body {
    Body::of_shape(&Shape::disc(DVec2::ZERO, radius), material)
}

fn split(surfaces: &Surfaces, ray: &Ray, starts_on: &StartsOn, nm: f64) -> Option<Split> {
    let contacts = surfaces.meet(ray, starts_on)?;
    let mut smooth = |normal: DVec2, _| normal;
    match interact(surfaces, &contacts, ray.direction, nm, &mut smooth) {
        Interaction::Split { reflected, transmitted } => {
            Some(Split { place: contacts.first().place, starts_on: contacts.starts_on(), reflected, transmitted })
        }
        _ => None,
    }
}

struct Split {
    place: DVec2,
    starts_on: StartsOn,
    reflected: Option<Branch>,
    transmitted: Option<Branch>,
}

/// Where a ray at distance `b` from the middle of a disc of radius 1 leaves it after `inside` reflections inside: its direction
/// and the parts of s and p that have come so far.
fn through_drop(surfaces: &Surfaces, b: f64, inside: usize, nm: f64) -> (DVec2, DVec2, [f64; 2]) {
    let mut ray = Ray { origin: DVec2::new(-5.0, b), direction: DVec2::X };
    let mut starts_on = StartsOn::NOTHING;
    let mut power = [1.0; 2];
    for turn in 0..inside + 2 {
        let split = split(surfaces, &ray, &starts_on, nm).expect("the disc is there");
        let branch = if turn == 0 || turn == inside + 1 { split.transmitted } else { split.reflected };
        let branch = branch.expect("light goes on");
        ray = Ray { origin: split.place, direction: branch.direction };
        starts_on = split.starts_on;
        (0..2).for_each(|way| power[way] *= branch.power[way]);
    }
    (ray.origin, ray.direction, power)
}

#[test]
fn a_point_of_light_gives_power_over_circumference() {
    let view = view(60, 40, DVec2::new(-30.0, -20.0), 1.0);
    let scene = Scene { bodies: vec![], sources: vec![white(SourceForm::Point(DVec2::new(0.3, 0.2)), 5.0)] };
    let picture = picture(&scene, view, 200_000);
    for (near, far) in [(3.0, 5.0), (8.0, 12.0), (15.0, 20.0)] {
        let (seen, known) = means(&picture, &view, |at| {
            let distance = at.distance(DVec2::new(0.3, 0.2));
            (near..far).contains(&distance).then(|| 5.0 / (TAU * distance))
        });
        assert!((seen / known - 1.0).abs() < 3e-3, "{near}: {seen} {known}");
    }
    let counts = picture.counts();
    assert_eq!((counts.sent, counts.gone), (200_000, 200_000));
}

/// delta = 2 (asin b - asin b/n); the axis is crossed at b / sin delta: 1.49583, 1.39157, 1.20028 for n = 1.5.
#[test]
fn a_disc_of_glass_bends_a_ray_to_its_place_on_the_axis() {
    let surfaces = Surfaces::new(&[disc_of(1.0, Material::glass(Dispersion::Constant(1.5)))], 1e-9);
    for (b, crossed) in [(0.1, 1.49583), (0.5, 1.39157), (0.8, 1.20028)] {
        let (place, direction, _) = through_drop(&surfaces, b, 0, 550.0);
        let on_axis = place.x - place.y * direction.x / direction.y;
        assert!((on_axis - crossed).abs() < 1e-5, "{b}: {on_axis}");
    }
}

/// The radii of the first and the second rainbow at F, d and C, and the light of the first: (8/9)^2 / 9 of the s polarized light,
/// whatever the index.
#[test]
fn the_rainbow_stands_where_descartes_found_it() {
    let surfaces = Surfaces::new(&[disc_of(1.0, Material::glass(glass_named("water").expect("water")))], 1e-9);
    let deviation = |b: f64, inside: usize, nm: f64| {
        let (_, direction, _) = through_drop(&surfaces, b, inside, nm);
        trig::angle(direction).to_degrees()
    };
    for (inside, radii) in [(1, [41.4294, 42.0195, 42.2949]), (2, [52.0612, 50.9964, 50.5001])] {
        for (nm, radius) in LINES_NM.into_iter().zip(radii) {
            // From the direction from which the light came; the extreme of it over b.
            let seen = (1..9_999).map(|step| {
                let angle = deviation(f64::from(step) * 1e-4, inside, nm);
                if inside == 1 {
                    180.0 - angle.abs()
                } else {
                    180.0 - angle.rem_euclid(360.0).min(360.0 - angle.rem_euclid(360.0))
                }
            });
            let extreme =
                if inside == 1 { seen.fold(0.0, f64::max) } else { seen.skip(8_000).fold(f64::INFINITY, f64::min) };
            assert!((extreme - radius).abs() < 2e-4, "{inside} {nm}: {extreme}");
        }
    }
    for index in [1.2, 1.333, 1.6] {
        let surfaces = Surfaces::new(&[disc_of(1.0, Material::glass(Dispersion::Constant(index)))], 1e-9);
        // cos^2 i = (n^2 - 1) / 3.
        let b = (1.0 - (index * index - 1.0) / 3.0).sqrt();
        let (_, _, power) = through_drop(&surfaces, b, 1, 550.0);
        assert!((power[0] - 64.0 / 729.0).abs() < 1e-9, "{index}: {}", power[0]);
    }
}

/// A 60 degree prism's least deviation.
#[test]
fn a_prism_deviates_least_as_its_glass_says() {
    let corners = [90.0, 210.0, 330.0_f64].map(|angle| Corner::Point(trig::direction(angle.to_radians()) * 10.0));
    for (name, expected) in [
        ("N-BK7", [39.1381, 38.6467, 38.4291]),
        ("N-SF10", [61.6689, 59.5690, 58.7349]),
        ("N-SF11", [69.1789, 66.3426, 65.2403]),
    ] {
        let glass = Material::glass(glass_named(name).expect("it is known"));
        let surfaces = Surfaces::new(&[Body::closed(&corners, glass).expect("it has area")], 1e-9);
        for (nm, least) in LINES_NM.into_iter().zip(expected) {
            let deviation = |degrees: f64| {
                let direction = trig::direction(degrees.to_radians());
                let ray = Ray { origin: DVec2::new(-4.330_127, 2.5) - direction * 20.0, direction };
                let into = split(&surfaces, &ray, &StartsOn::NOTHING, nm)?;
                let inner = Ray { origin: into.place, direction: into.transmitted?.direction };
                let out = split(&surfaces, &inner, &into.starts_on, nm)?;
                Some(direction.angle_to(out.transmitted?.direction).abs().to_degrees())
            };
            let found = (0..80_000).filter_map(|step| deviation(f64::from(step) * 1e-3)).fold(f64::INFINITY, f64::min);
            assert!((found - least).abs() < 2e-4, "{name} {nm}: {found}");
        }
    }
}

/// Parallel light in a mirror circle: at height h = R sin i it crosses the axis R / (2 cos i) before the middle's far side.
#[test]
fn a_mirror_circle_has_its_cusp_at_half_the_radius() {
    let surfaces = Surfaces::new(&[disc_of(1.0, Material::MIRROR)], 1e-9);
    for height in [0.01, 0.3, 0.7_f64] {
        let ray = Ray { origin: DVec2::new(-0.5, height), direction: DVec2::X };
        let split = split(&surfaces, &ray, &StartsOn::NOTHING, 550.0).expect("the mirror is round it");
        let direction = split.reflected.expect("it reflects").direction;
        let on_axis = split.place.x - split.place.y * direction.x / direction.y;
        let expected = 0.5 / (1.0 - height * height).sqrt();
        assert!((on_axis - expected).abs() < 1e-9, "{height}: {on_axis}");
    }
}

/// A matt circle of radius R with a lamp in its middle: P / (2 pi d) and everywhere rho P / (2 R (1 - rho)).
#[test]
fn a_round_matt_room_is_as_bright_as_its_walls_make_it() {
    let (radius, power) = (20.0, 3.0);
    for rho in [0.3, 0.8] {
        let view = view(40, 40, DVec2::splat(-20.0), 1.0);
        let scene = Scene {
            bodies: vec![disc_of(radius, Material::Diffuse { reflectance: [rho; 3] })],
            sources: vec![white(SourceForm::Point(DVec2::ZERO), power)],
        };
        let picture = picture(&scene, view, 400_000);
        let (seen, known) = means(&picture, &view, |at| {
            let distance = at.length();
            let of_walls = rho * power / (2.0 * radius * (1.0 - rho));
            (3.0..18.0).contains(&distance).then(|| power / (TAU * distance) + of_walls)
        });
        assert!((seen / known - 1.0).abs() < 4e-3, "{rho}: {seen} {known}");
        let counts = picture.counts();
        assert_eq!(counts.sent, counts.absorbed + counts.gone + counts.given_up);
        // Of each packet the walls take the part 1 - rho at each of 1 / (1 - rho) meetings, on the average.
        let meetings = counts.segments as f64 / counts.sent as f64;
        assert!((meetings * (1.0 - rho) - 1.0).abs() < 5e-3, "{meetings}");
    }
}

/// In uniform light L a disc of glass has the fluence 2 pi n L within R / n, and beyond it 4 n L asin(R / (n r)).
#[test]
fn uniform_light_is_brighter_within_glass_by_its_index() {
    let (radius, index) = (12.0, 1.5);
    let view = view(60, 60, DVec2::splat(-30.0), 1.0);
    let scene = Scene {
        bodies: vec![
            Body::of_shape(&Shape::disc(DVec2::ZERO, 28.0), Material::Diffuse { reflectance: [0.98; 3] }),
            disc_of(radius, Material::glass(Dispersion::Constant(index))),
        ],
        sources: vec![white(SourceForm::Point(DVec2::new(20.0, 0.0)), 1.0)],
    };
    let picture = picture(&scene, view, 150_000);
    // What is near the lamp is brighter: the ring beyond it is judged on the other side.
    let (open, _) = means(&picture, &view, |at| (at.x < -5.0 && (14.0..26.0).contains(&at.length())).then_some(1.0));
    let (middle, _) = means(&picture, &view, |at| (at.length() < radius / index - 0.8).then_some(1.0));
    assert!((middle / open - index).abs() < 0.02, "{}", middle / open);
    let (rim, known) = means(&picture, &view, |at| {
        let inside = (radius / index + 0.8..radius - 0.8).contains(&at.length());
        inside.then(|| open / TAU * 4.0 * index * libm::asin(radius / (index * at.length())))
    });
    assert!((rim / known - 1.0).abs() < 0.02, "{rim} {known}");
}

/// A lamp at D = 80 before a disc of glass, R = 14, n = 1.5: 0.0559925 of the power meets the disc, and what passes both surfaces
/// without a reflection is 0.0491168, s and p apart.
#[test]
fn glass_passes_of_a_lamp_what_fresnel_says_for_s_and_p_apart() {
    let scene = Scene {
        bodies: vec![disc_of(14.0, Material::glass(Dispersion::Constant(1.5)))],
        sources: vec![white(SourceForm::Point(DVec2::new(-80.0, 0.0)), 1.0)],
    };
    let tracer = PhotonTracer::new(&scene, Weights::equal_energy(), 3);
    let packets = 1_000_000;
    // The pieces of each packet: its first one, within the glass, and so on.
    let (mut met, mut passed, mut before) = (0_u64, 0_u64, Vec::<DVec2>::new());
    tracer.trace(0..packets, |flight, _| {
        if flight.photon.way == 0.0 {
            before.clear();
        }
        before.push(flight.photon.ray.direction);
        let ends = flight.distance.is_infinite();
        met += u64::from(before.len() == 2);
        // Three pieces, and the last one goes away from the lamp: it was not reflected at all.
        passed += u64::from(ends && before.len() == 3 && before[1] != before[0]);
    });
    let part = |count: u64| count as f64 / packets as f64;
    assert!((part(met) - 0.0559925).abs() < 1e-4, "{}", part(met));
    assert!((part(passed) - 0.0491168).abs() < 2e-4, "{}", part(passed));
}

/// The light of a lamp behind a disc of glass by its closed form: every b with psi = asin(b/D) + asin(b/rho) - delta(b) gives
/// P / 2 pi T(b) / |s0 + s - s0 s delta'(b)|.
///
/// `passed` says what passes both surfaces, of what of s and p each one reflects.
fn behind_glass(rho: f64, psi: f64, passed: fn([f64; 2]) -> f64) -> f64 {
    let (lamp, radius, index) = (80.0_f64, 14.0_f64, 1.5_f64);
    let angle = |b: f64| {
        libm::asin(b / lamp) + libm::asin(b / rho) - 2.0 * (libm::asin(b / radius) - libm::asin(b / (index * radius)))
    };
    let light = |b: f64| {
        let cosine = (1.0 - (b / radius).powi(2)).sqrt();
        let (reflected, _) = tracer::transport::fresnel::dielectric(cosine, index).expect("glass is entered");
        let (from, to) = ((lamp * lamp - b * b).sqrt(), (rho * rho - b * b).sqrt());
        let turn = 2.0 * (1.0 / (radius * radius - b * b).sqrt() - 1.0 / ((index * radius).powi(2) - b * b).sqrt());
        passed(reflected) / (TAU * (from + to - from * to * turn).abs())
    };
    let steps = 200_000;
    let at = |step: i32| 14.0 * (f64::from(step) / f64::from(steps) * 2.0 - 1.0) * (1.0 - 1e-12);
    let mut sum = 0.0;
    for step in 0..steps {
        let (mut low, mut high) = (at(step), at(step + 1));
        let is_below = |b: f64| angle(b) < psi;
        if is_below(low) == is_below(high) {
            continue;
        }
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if is_below(low) == is_below(middle) { low = middle } else { high = middle }
        }
        sum += light(0.5 * (low + high));
    }
    sum
}

/// s and p polarized light pass apart.
fn apart([s, p]: [f64; 2]) -> f64 {
    0.5 * ((1.0 - s) * (1.0 - s) + (1.0 - p) * (1.0 - p))
}

/// The closed form has these values, where the mean of s and p is taken at each surface.
#[test]
fn the_closed_form_has_its_published_values() {
    let averaged = |[s, p]: [f64; 2]| (1.0 - 0.5 * (s + p)).powi(2);
    for (rho, psi, light) in
        [(40.0, 0.0, 0.0045297), (100.0, 0.0, 7.2991e-4), (60.0, 0.3, 4.7188e-4), (120.0, -0.5, 1.38701e-4)]
    {
        let found = behind_glass(rho, psi, averaged);
        assert!((found / light - 1.0).abs() < 2e-4, "{rho} {psi}: {found}");
    }
}

/// Pixels behind the disc, on its axis and beside it, outside and inside of the caustic, against the closed form averaged over the
/// pixel.
#[test]
fn the_light_behind_glass_is_that_of_the_closed_form() {
    let scene = Scene {
        bodies: vec![disc_of(
            14.0,
            Material::Dielectric(tracer::transport::Dielectric::clear(Dispersion::Constant(1.5))),
        )],
        sources: vec![white(
            SourceForm::Cone { center: DVec2::new(-80.0, 0.0), axis: DVec2::X, half_angle: 0.18 },
            1.0,
        )],
    };
    for (rho, psi, tolerance) in [(40.0, 0.0, 2e-3), (100.0, 0.0, 4e-3), (60.0, 0.3, 4e-3), (100.0, -0.1_f64, 4e-3)] {
        let place = trig::direction(psi) * rho;
        // One pixel of 1 mm there.
        let view = view(1, 1, place - 0.5, 1.0);
        // Three pieces of a way are before the glass, in it and behind it: what is reflected inside is given up.
        let tracer = PhotonTracer::new(&scene, Weights::equal_energy(), 1).with_most_surfaces(3);
        let mut picture = PhotonPicture::new(tracer, view);
        picture.expose(1_500_000);
        let seen = picture.fluence()[0][1];
        let side = 9;
        let cells = (0..side * side).map(|cell| {
            let offset = DVec2::new(f64::from(cell % side), f64::from(cell / side)) + 0.5;
            let at = place - 0.5 + offset / f64::from(side);
            behind_glass(at.length(), trig::angle(at), apart)
        });
        // The cone has all the power within 0.36 rad of the circle's 2 pi.
        let known = cells.sum::<f64>() / f64::from(side * side) * TAU / 0.36;
        assert!((seen / known - 1.0).abs() < tolerance, "{rho} {psi}: {seen} {known}");
    }
}
