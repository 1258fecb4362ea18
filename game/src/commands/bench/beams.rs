//! Beams: what a sweep of more and more of them takes, and how long photons take until their picture is as good.
//!
//! Three subjects under one lamp: a ball of glass, a lens, a hollow mirror. A picture is judged against one of many photons; what
//! that one is off itself, its two halves tell, and is taken from all figures.

use super::Row;
use super::clock::{quantile, time_ms};
use super::levels::{Difference, apart, levels};
use crate::Failure;
use crate::commands::parallel;
use crate::screen::Size;
use geometry::{Arc, Circle, DVec2, Shape};
use std::f64::consts::PI;
use tracer::View;
use tracer::transport::beams::{BeamOptions, BeamPicture, BeamTracer};
use tracer::transport::spectrum::{Dispersion, Emission, Weights};
use tracer::transport::{
    Body, Corner, Curve, Falloff, LightSource, Material, PhotonPicture, PhotonTracer, Scene, SourceForm,
};

/// The size that times are quoted at: a millimetre of the scene a pixel.
const SIZE: Size = Size { width: 540, height: 1080 };

/// The side of the pictures that are compared, pixels of a millimetre.
const SIDE: usize = 300;

/// Beams of the lamp to begin with.
const BEAMS: [u32; 3] = [32, 256, 2048];

/// Sweeps that are timed, after one to warm up.
const ROUNDS: usize = 15;

/// Packets of each half of the picture that is taken for right, and of the one whose error is told.
const CONVERGED: u64 = 1 << 22;
const PACKETS: u64 = 1 << 17;

/// Pixels nearer to the lamp than this are not compared: light rises there within a pixel.
const NEAR_LAMP_MM: f64 = 20.0;

/// Where the lamp is, and where the thing before it.
const LAMP: DVec2 = DVec2::new(30.0, 150.0);
const THING: DVec2 = DVec2::new(110.0, 150.0);

/// Times sweeps of three subjects, and compares them with photons.
///
/// # Errors
/// If the system gives no threads.
pub fn rows(size: Option<Size>, threads: Option<usize>) -> Result<Vec<Row>, Failure> {
    let pool = parallel::pool(threads)?;
    let threads = pool.current_num_threads();
    let of = |(name, body): (&'static str, Body)| {
        let scene = scene(body);
        let mut rows = timed(name, &scene, size.unwrap_or(SIZE));
        rows.extend(compared(name, &scene));
        rows
    };
    let rows = pool.install(|| subjects().into_iter().flat_map(of).collect::<Vec<Row>>());
    Ok(rows.into_iter().map(|row| Row { bench: "beams", threads, ..row }).collect())
}

fn subjects() -> [(&'static str, Body); 3] {
    let glass = Material::glass(Dispersion::Constant(1.5));
    let ball = Body::of_shape(&Shape::disc(THING, 14.0), glass);
    let at = |x: f64, y: f64| THING + DVec2::new(x, y);
    let lens = [
        Corner::Point(at(0.0, -20.0)),
        Corner::Through(at(6.0, 0.0)),
        Corner::Point(at(0.0, 20.0)),
        Corner::Through(at(-6.0, 0.0)),
    ];
    let lens = Body::closed(&lens, glass).expect("a lens has area");
    let hollow = Arc::new(Circle { center: THING, radius: 80.0 }, -0.5 * PI, PI);
    let mirror = Body::open([Curve::Arc(hollow)], Material::MIRROR);
    [("glass ball", ball), ("lens", lens), ("hollow mirror", mirror)]
}

fn scene(body: Body) -> Scene {
    let form = SourceForm::Disc { center: LAMP, radius: 3.0 };
    let source = LightSource { form, emission: Emission::EqualEnergy, power: 60.0, falloff: Falloff::Plane };
    Scene { bodies: vec![body], sources: vec![source] }
}

fn picture(scene: &Scene, view: View, beams: u32) -> BeamPicture<'_> {
    let options = BeamOptions { beams, ..BeamOptions::default() };
    BeamPicture::new(BeamTracer::new(scene, &Weights::equal_energy(), options), view)
}

/// The whole way from a scene to the light of each pixel.
fn swept(scene: &Scene, view: View, beams: u32) -> Vec<[f64; 3]> {
    let mut picture = picture(scene, view, beams);
    while picture.expose(usize::MAX, &|| true) {}
    picture.fluence()
}

/// How long sweeps take, and how often a memset of their film would fit in. All take turns.
fn timed(name: &str, scene: &Scene, size: Size) -> Vec<Row> {
    let view = View { width: size.width, height: size.height, origin_mm: DVec2::ZERO, mm_per_px: 1.0 };
    let mut film = vec![0_u8; picture(scene, view, 1).film_bytes()];
    let mut times_ms = vec![Vec::new(); BEAMS.len() + 1];
    for round in 0..=ROUNDS {
        for (at, times_ms) in times_ms.iter_mut().enumerate() {
            let ms = match BEAMS.get(at) {
                Some(beams) => time_ms(|| drop(std::hint::black_box(swept(scene, view, *beams)))),
                None => time_ms(|| std::hint::black_box(&mut film).fill(round as u8)),
            };
            if round > 0 {
                times_ms.push(ms);
            }
        }
    }
    let median: Vec<f64> = times_ms.iter_mut().map(|times_ms| quantile(times_ms, 0.5)).collect();
    let row = |(beams, ms): (&u32, &f64)| Row {
        variant: format!("{name}, {beams} beams"),
        size: Some(format!("{}x{}", size.width, size.height)),
        ms: *ms,
        times_memset: Some(ms / median[BEAMS.len()]),
        ..Row::default()
    };
    BEAMS.iter().zip(&median).map(row).collect()
}

/// How far sweeps are from converged photons, and how long photons would take to come as near.
fn compared(name: &str, scene: &Scene) -> Vec<Row> {
    let view = View { width: SIDE, height: SIDE, origin_mm: DVec2::ZERO, mm_per_px: 1.0 };
    let photons = |packets: u64, seed: u64| {
        let tracer = PhotonTracer::new(scene, Weights::equal_energy(), seed);
        let mut picture = PhotonPicture::new(tracer, view);
        picture.expose(packets);
        picture.fluence()
    };
    let screen = |light: &[[f64; 3]]| {
        let levels = levels(light).into_iter().enumerate();
        let far = |pixel: usize| view.table_from_pixel(pixel % SIDE, pixel / SIDE).distance(LAMP) > NEAR_LAMP_MM;
        levels.filter(|(pixel, _)| far(*pixel)).map(|(_, level)| level).collect::<Vec<_>>()
    };
    let [a, b] = [1, 2].map(|seed| photons(CONVERGED, seed));
    let mean: Vec<[f64; 3]> = a.iter().zip(&b).map(|(a, b)| [0, 1, 2].map(|of| 0.5 * (a[of] + b[of]))).collect();
    let (right, noise) = (screen(&mean), 0.5 * apart(&screen(&a), &screen(&b)).rms);
    // The mean's own error is in every difference from it.
    let error = |difference: Difference| (difference.rms * difference.rms - noise * noise).max(0.0).sqrt();
    let mut few = Vec::new();
    let few_ms = time_ms(|| few = photons(PACKETS, 3));
    let few = error(apart(&screen(&few), &right));
    let row = |beams: u32| {
        let mut light = swept(scene, view, beams);
        let mut times_ms: Vec<f64> = (0..ROUNDS).map(|_| time_ms(|| light = swept(scene, view, beams))).collect();
        let ms = quantile(&mut times_ms, 0.5);
        let difference = apart(&screen(&light), &right);
        let off = error(difference);
        // The error of photons falls with the root of their number. Below a fifth of the noise nobody can tell.
        let told = off.max(0.2 * noise);
        let photons_ms = few_ms * (few / told) * (few / told);
        Row {
            variant: format!("{name}, {beams} beams, rms {off:.2} levels (noise {noise:.2})"),
            size: Some(format!("{SIDE}x{SIDE}")),
            ms,
            times_photons: Some(photons_ms / ms),
            most_levels_off: Some(difference.most),
            pixels_off: Some(difference.pixels),
            ..Row::default()
        }
    };
    BEAMS.map(row).into()
}
