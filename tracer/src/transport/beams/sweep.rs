//! The sweep over a family: beams that are halved until they hold, through all surfaces.

use super::beam::Piece;
use super::cell::Cell;
use super::corner::Corner;
use super::family::{Family, families};
use crate::View;
use crate::transport::BEAM_BITS;
use crate::transport::spectrum::Weights;
use crate::transport::{
    Contacts, EdgeId, Falloff, Material, Media, Scene, SplatFilm, StartsOn, Surfaces, TOLERANCE_MM,
};
use geometry::DVec2;
use rayon::prelude::*;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};

/// How fine a sweep is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BeamOptions {
    /// Beams of each family to begin with.
    pub beams: u32,
    /// Strata of the wavelengths, if they matter.
    pub wavelengths: u32,
    /// Strata of the width of wide sources.
    pub widths: u32,
    /// Surfaces that a beam meets at most.
    pub most_surfaces: u32,
    /// Of its family's power, what a branch must have to be followed.
    pub least_power: f64,
    /// Straight pieces of beams of one family at most: among many curved glasses beams are halved without end, and photons are
    /// the better way. What is beyond is left out, and [`BeamPicture::is_cut`] says so.
    pub most_pieces: u64,
}

impl Default for BeamOptions {
    fn default() -> BeamOptions {
        BeamOptions {
            beams: 512,
            wavelengths: 32,
            widths: 8,
            most_surfaces: 24,
            least_power: 1e-3,
            most_pieces: u64::MAX,
        }
    }
}

/// No beam is halved that is narrower in u than this: the ray in its middle has all of its light.
const NARROWEST: f64 = 1.0 / (1 << 16) as f64;

/// Where beams of this width in u part because of their width in v, that is divided.
const NARROW_U: f64 = 1.0 / (1 << 12) as f64;

/// How far the middle of a beam may be from where its edges have it, pixels.
const MOST_BEND_PX: f64 = 0.2;

/// How slanted a beam's end may be, pixels.
const MOST_SLANT_PX: f64 = 1.0;

/// Halvings of a beam for its form alone.
const MOST_HALVINGS: u32 = 10;

/// A scene, ready for beams.
pub struct BeamTracer<'a> {
    surfaces: Surfaces,
    families: Vec<(Family<'a>, Media)>,
    /// The power of all sources: the films hold parts of it.
    power: f64,
    options: BeamOptions,
}

/// A beam's picture in the making.
pub struct BeamPicture<'a> {
    tracer: BeamTracer<'a>,
    view: View,
    films: Vec<Mutex<SplatFilm>>,
    /// Tasks that are done.
    done: usize,
    /// Whether a family had more pieces than it may have.
    is_cut: AtomicBool,
}

/// The corners of one edge of a beam: v 0 and v 1.
type Side = [Corner; 2];

/// What a beam met before: which edge, and whether it went through.
#[derive(Clone, Copy)]
struct Met {
    edge: EdgeId,
    through: bool,
}

impl<'a> BeamTracer<'a> {
    /// The tracer of a scene, for a screen whose white is that of `weights`.
    pub fn new(scene: &'a Scene, weights: &Weights, options: BeamOptions) -> BeamTracer<'a> {
        let surfaces = Surfaces::new(&scene.bodies, TOLERANCE_MM);
        let chromatic = scene.bodies.iter().any(|body| body.band.is_some() || is_chromatic(&body.material));
        let of = |source: &'a crate::transport::LightSource| {
            let media = surfaces.media_at(source.form.middle()).into_iter().filter(|body| surfaces.absorbs(*body));
            let media = Media::of(media);
            families(source, weights, chromatic, [options.wavelengths, options.widths])
                .into_iter()
                .map(move |family| (family, media))
        };
        let families = scene.sources.iter().filter(|source| source.power > 0.0).flat_map(of).collect();
        let power = scene.sources.iter().map(|source| source.power).sum();
        BeamTracer { surfaces, families, power, options }
    }

    /// The same with another limit of pieces of one family.
    pub fn with_most_pieces(mut self, most_pieces: u64) -> BeamTracer<'a> {
        self.options.most_pieces = most_pieces;
        self
    }

    /// How many families there are: tasks for [`BeamPicture::expose`].
    pub fn tasks(&self) -> usize {
        self.families.len()
    }

    fn start(&self, family: &Family, media: Media, u: f64, v: [f64; 2]) -> Side {
        v.map(|v| {
            let (ray, nm) = family.ray(u, v);
            Corner { ray, starts_on: StartsOn::NOTHING, nm, power: [0.5; 2], way: 0.0, media }
        })
    }
}

/// Whether light of different wavelengths fares differently.
fn is_chromatic(material: &Material) -> bool {
    let colored = |color: &[f64; 3]| color[0] != color[1] || color[1] != color[2];
    match material {
        Material::Mirror { reflectance, .. } => colored(reflectance),
        Material::Metal { .. } => true,
        Material::Dielectric(glass) => !glass.dispersion.is_constant() || colored(&glass.transmittance_per_mm),
        _ => false,
    }
}

/// One family's sweep onto a film.
struct Sweep<'a, 'b> {
    tracer: &'b BeamTracer<'a>,
    family: &'b Family<'a>,
    media: Media,
    view: &'b View,
    film: &'b mut SplatFilm,
    /// From where on a ray is out of the picture.
    far: f64,
    met: Vec<Met>,
    /// Pieces that may still be looked at.
    pieces_left: u64,
    /// Asked now and then whether to go on.
    goes_on: &'b (dyn Fn() -> bool + Sync),
}

/// From one question to the next whether to go on: pieces, some milliseconds.
const ASKED_EVERY: u64 = 1 << 10;

impl Sweep<'_, '_> {
    /// All beams of these.
    fn run(&mut self, beams: std::ops::Range<u32>) {
        let count = f64::from(self.tracer.options.beams);
        for beam in beams {
            let u = [beam, beam + 1].map(|edge| f64::from(edge) / count);
            self.cell(Cell { u, v: [0.0, 1.0], part: 1.0, halved: 0, is_ray: false });
        }
    }

    /// A cell whose sides are not known yet.
    fn cell(&mut self, cell: Cell) {
        let [a, b] = cell.u.map(|u| self.again(u, cell.v));
        self.between(cell, a, b);
    }

    /// The beam between two sides; where only one is there, up to where it ends.
    fn between(&mut self, cell: Cell, a: Option<Side>, b: Option<Side>) {
        match (a, b) {
            (Some(a), Some(b)) => self.beam(cell, a, b),
            (None, None) => {}
            _ => self.halve(cell, a, b, 0),
        }
    }

    /// Both halves of a cell; `for_form` is 1 where its beam did not hold.
    fn halve(&mut self, cell: Cell, a: Option<Side>, b: Option<Side>, for_form: u32) {
        if cell.width() < NARROW_U && for_form == 0 && !cell.is_line() {
            return cell.across().into_iter().for_each(|cell| self.cell(cell));
        }
        if cell.width() < NARROWEST {
            return self.ray(cell);
        }
        let middle = cell.middle();
        let side = self.again(middle, cell.v);
        let halved = cell.halved + for_form;
        self.between(Cell { u: [cell.u[0], middle], halved, ..cell }, a, side);
        self.between(Cell { u: [middle, cell.u[1]], halved, ..cell }, side, b);
    }

    /// The ray in the middle of a cell, with all of its light.
    fn ray(&mut self, cell: Cell) {
        let v = [0.5 * (cell.v[0] + cell.v[1]); 2];
        if let Some(side) = self.again(cell.middle(), v) {
            self.beam(Cell { v, is_ray: true, ..cell }, side, side);
        }
    }

    /// The side at u after the same surfaces.
    fn again(&self, u: f64, v: [f64; 2]) -> Option<Side> {
        let mut side = self.tracer.start(self.family, self.media, u, v);
        for met in &self.met {
            for corner in &mut side {
                let contacts = self.tracer.surfaces.meet(&corner.ray, &corner.starts_on)?;
                if contacts.first().edge != met.edge {
                    return None;
                }
                *corner = corner.next(&self.tracer.surfaces, &contacts, met.through)?;
            }
        }
        Some(side)
    }

    fn beam(&mut self, cell: Cell, a: Side, b: Side) {
        let Some(left) = self.pieces_left.checked_sub(1) else { return };
        self.pieces_left = left;
        if left % ASKED_EVERY == 0 && !(self.goes_on)() {
            self.pieces_left = 0;
        }
        let corners = [a[0], b[0], a[1], b[1]];
        let contacts = corners.map(|corner| self.tracer.surfaces.meet(&corner.ray, &corner.starts_on));
        let edge = |at: usize| contacts[at].as_ref().map(|contacts| contacts.first().edge);
        if edge(0) != edge(1) || edge(2) != edge(3) {
            return self.halve(cell, Some(a), Some(b), 0);
        }
        if edge(0) != edge(2) {
            return cell.across().into_iter().for_each(|cell| self.cell(cell));
        }
        let distance = |at: usize| contacts[at].as_ref().map_or(self.far, |contacts| contacts.first().distance);
        let ends: [f64; 4] = std::array::from_fn(distance);
        let piece = Piece {
            from: corners.map(|corner| corner.ray.origin),
            to: std::array::from_fn(|at| corners[at].ray.at(ends[at])),
        };
        if !cell.is_ray && cell.halved < MOST_HALVINGS && !self.holds(&cell, &piece, edge(0)) {
            return self.halve(cell, Some(a), Some(b), 1);
        }
        self.splat(&cell, &corners, &piece);
        let [Some(c0), Some(c1), Some(c2), Some(c3)] = &contacts else { return };
        if self.met.len() >= self.tracer.options.most_surfaces as usize {
            return;
        }
        for through in [false, true] {
            let next = |corner: &Corner, contacts: &Contacts| corner.next(&self.tracer.surfaces, contacts, through);
            let side = |one: Option<Corner>, other: Option<Corner>| Some([one?, other?]);
            let a = side(next(&corners[0], c0), next(&corners[2], c2));
            let b = side(next(&corners[1], c1), next(&corners[3], c3));
            let sides = [a, b];
            let strengths = sides.iter().flatten().flatten().map(|corner| corner.power[0] + corner.power[1]);
            if strengths.fold(0.0, f64::max) < self.tracer.options.least_power {
                continue;
            }
            self.met.push(Met { edge: c0.first().edge, through });
            self.between(cell, a, b);
            self.met.pop();
        }
    }

    /// Whether the beam's middle is where its edges have it, and its end is not too slanted.
    fn holds(&self, cell: &Cell, piece: &Piece, edge: Option<EdgeId>) -> bool {
        if !self.touches(piece) {
            return true;
        }
        let px = self.view.mm_per_px;
        let [a, b] = [piece.to[0], piece.to[1]];
        let along = ((a - piece.from[0]) + (b - piece.from[1])).normalize_or_zero();
        if edge.is_some() && (a - b).dot(along).abs() > MOST_SLANT_PX * px {
            return false;
        }
        let Some(middle) = self.again(cell.middle(), cell.v) else { return false };
        let corner = middle[0];
        let contacts = self.tracer.surfaces.meet(&corner.ray, &corner.starts_on);
        if contacts.as_ref().map(|contacts| contacts.first().edge) != edge {
            return false;
        }
        let to = corner.ray.at(contacts.map_or(self.far, |contacts| contacts.first().distance));
        let bend = |middle: DVec2, a: DVec2, b: DVec2| middle.distance((a + b) * 0.5);
        bend(corner.ray.origin, piece.from[0], piece.from[1]).max(bend(to, a, b)) <= MOST_BEND_PX * px
    }

    /// Whether the piece may cross the picture.
    fn touches(&self, piece: &Piece) -> bool {
        let size = DVec2::new(self.view.width as f64, self.view.height as f64) * self.view.mm_per_px;
        let (min, max) = (self.view.origin_mm, self.view.origin_mm + size);
        let all = piece.from.iter().chain(&piece.to);
        let low = all.clone().fold(DVec2::INFINITY, |low, place| low.min(*place));
        let high = all.fold(DVec2::NEG_INFINITY, |high, place| high.max(*place));
        low.cmple(max).all() && high.cmpge(min).all()
    }

    fn splat(&mut self, cell: &Cell, corners: &[Corner; 4], piece: &Piece) {
        if !self.touches(piece) {
            return;
        }
        let part = 0.25 * corners.iter().map(|corner| corner.power[0] + corner.power[1]).sum::<f64>();
        let part = part * cell.width() * cell.part / self.tracer.power;
        let color = self.family.color.map(|channel| channel * part);
        let first = &corners[0];
        let absorption = first.media.absorption_per_mm(&self.tracer.surfaces, first.nm);
        let falloff = self.family.source.falloff;
        let length = piece.from[0].distance(piece.to[0]);
        let piece = piece.on_screen(self.view);
        if absorption == 0.0 && falloff == Falloff::Plane {
            return piece.splat(self.film, |_| color);
        }
        piece.splat(self.film, |gone| {
            let way = gone * length;
            let weight = falloff.weight(first.way + way) * libm::exp(-absorption * way);
            color.map(|channel| channel * weight)
        });
    }
}

/// Parts into which a family is divided, so that all threads have work.
const PARTS: usize = 8;

impl<'a> BeamPicture<'a> {
    /// An empty picture.
    pub fn new(tracer: BeamTracer<'a>, view: View) -> BeamPicture<'a> {
        let films =
            (0..rayon::current_num_threads().max(1)).map(|_| Mutex::new(SplatFilm::new(&view, BEAM_BITS))).collect();
        BeamPicture { tracer, view, films, done: 0, is_cut: AtomicBool::new(false) }
    }

    /// Sweeps up to `families` more; `false` when all are done. Where `goes_on` says no they are left half done, and
    /// [`BeamPicture::is_cut`] says so.
    pub fn expose(&mut self, families: usize, goes_on: &(dyn Fn() -> bool + Sync)) -> bool {
        let last = (self.done + families).min(self.tracer.families.len());
        let beams = self.tracer.options.beams as usize;
        let far = {
            let size = DVec2::new(self.view.width as f64, self.view.height as f64) * self.view.mm_per_px;
            let corners = [self.view.origin_mm, self.view.origin_mm + size];
            let bounds = self.tracer.surfaces.bounds().map_or(corners, |bounds| [bounds.min, bounds.max]);
            let all = [corners[0], corners[1], bounds[0], bounds[1]];
            let sources = self.tracer.families.iter().map(|(family, _)| family.source.form.middle());
            let low = sources.clone().chain(all).fold(DVec2::INFINITY, DVec2::min);
            let high = sources.chain(all).fold(DVec2::NEG_INFINITY, DVec2::max);
            2.0 * low.distance(high)
        };
        (self.done * PARTS..last * PARTS).into_par_iter().for_each(|task| {
            let (family, media) = &self.tracer.families[task / PARTS];
            let own = rayon::current_thread_index().unwrap_or(0) % self.films.len();
            let mut film = self.films[own].lock().unwrap_or_else(std::sync::PoisonError::into_inner);
            let part = |number: usize| (beams * number / PARTS) as u32;
            let (tracer, view, met) = (&self.tracer, &self.view, Vec::new());
            // A part by itself, so that what is left out does not depend on who is first.
            let pieces_left = tracer.options.most_pieces / PARTS as u64;
            let mut sweep =
                Sweep { tracer, family, media: *media, view, film: &mut film, far, met, pieces_left, goes_on };
            sweep.run(part(task % PARTS)..part(task % PARTS + 1));
            if sweep.pieces_left == 0 {
                self.is_cut.store(true, Ordering::Relaxed);
            }
        });
        self.done = last;
        self.done < self.tracer.families.len()
    }

    /// Whether some light is left out: a family had [`BeamOptions::most_pieces`].
    pub fn is_cut(&self) -> bool {
        self.is_cut.load(Ordering::Relaxed)
    }

    /// The fluence in each pixel, row by row, signed.
    pub fn fluence(&self) -> Vec<[f64; 3]> {
        let mut sum = SplatFilm::new(&self.view, BEAM_BITS);
        for film in &self.films {
            sum.add(&film.lock().unwrap_or_else(std::sync::PoisonError::into_inner));
        }
        let scale = self.tracer.power / self.view.mm_per_px;
        let (width, height) = (sum.width(), sum.height());
        (0..width * height).map(|at| sum.pixel(at % width, at / width, scale)).collect()
    }
}
