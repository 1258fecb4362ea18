//! A scene as a picture: its rays with their branches, and its outlines.

use super::OpticsScene;
use super::trace::follow_all;
use geometry::{Bounds, DVec2, trig};
use tracer::View;
use tracer::transport::spectrum::Weights;
use tracer::transport::{Curve, PACKET_BITS, PixelSegment, SplatFilm};

/// Around everything, so much of the larger side stays free.
const MARGIN: f64 = 0.12;
/// Light of an outline over that of a ray of brightness 1.
const OUTLINE: f32 = 0.5;
/// Chords of an arc or a parabola.
const CHORDS: u32 = 256;
/// Curves longer than this many times everything else are endless.
const ENDLESS: f64 = 1e6;

/// The box that a picture of the scene shows; `None` where there is nothing of a size.
pub fn frame(scene: &OpticsScene) -> Option<Bounds> {
    let curves = scene.bodies.iter().flat_map(|body| &body.edges).map(|edge| edge.curve.bounds());
    let finite = curves.filter(|bounds| bounds.size().max_element() < ENDLESS);
    let detectors = scene.detectors.iter().map(|detector| detector.line.bounds());
    let rays = scene.rays.iter().map(|ray| Bounds::of(ray.ray.origin, ray.ray.origin));
    let all = finite.chain(detectors).chain(rays).reduce(Bounds::union)?;
    let side = all.size().max_element();
    (side > 0.0 && side.is_finite()).then(|| all.grown(MARGIN * side))
}

/// The light that all rays leave in each pixel, row by row, signed; of some of them where `is_cancelled` says so.
pub fn fluence(scene: &OpticsScene, view: &View, weights: &Weights, is_cancelled: &dyn Fn() -> bool) -> Vec<[f64; 3]> {
    let mut film = SplatFilm::new(view, PACKET_BITS);
    let diagonal = DVec2::new(view.width as f64, view.height as f64).length() * view.mm_per_px;
    let middle = view.table_from_pixel(view.width / 2, view.height / 2);
    follow_all(scene, is_cancelled, |ray, distance| {
        let power = (ray.power[0] + ray.power[1]) as f32;
        let color = if scene.colors { weights.at(ray.wavelength_nm) } else { [1.0; 3] };
        let distance = distance.min(ray.ray.origin.distance(middle) + diagonal);
        let ends = [ray.ray.origin, ray.ray.at(distance)].map(|end| view.screen_from_table(end));
        film.splat(&PixelSegment { from: ends[0], to: ends[1] }, color.map(|channel| channel * power));
    });
    let brightest = scene.rays.iter().map(|ray| ray.brightness).fold(0.0, f64::max) as f32;
    for edge in scene.bodies.iter().flat_map(|body| &body.edges) {
        let corners: Vec<DVec2> = corners(&edge.curve).map(|at| view.screen_from_table(at)).collect();
        for pair in corners.windows(2) {
            film.splat(&PixelSegment { from: pair[0], to: pair[1] }, [OUTLINE * brightest; 3]);
        }
    }
    let (width, height) = (view.width, view.height);
    (0..width * height).map(|at| film.pixel(at % width, at / width, 1.0)).collect()
}

/// Points along a curve, close enough to be looked at.
fn corners(curve: &Curve) -> Box<dyn Iterator<Item = DVec2>> {
    let parts = (0..=CHORDS).map(|step| 2.0 * f64::from(step) / f64::from(CHORDS) - 1.0);
    match *curve {
        Curve::Line(line) => Box::new([line.a, line.b].into_iter()),
        Curve::Arc(arc) => Box::new(parts.map(move |part| {
            arc.circle().center + trig::rotate(arc.middle(), part * arc.half_angle()) * arc.circle().radius
        })),
        Curve::Parabola(parabola) => Box::new(parts.map(move |part| parabola.at(part * parabola.half))),
    }
}
