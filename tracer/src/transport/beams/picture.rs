//! A picture by beams in the making.

use super::family::Lays;
use super::film::BeamFilm;
use super::horizon::Horizon;
use super::sweep::{GIVEN_UP_UNIT, Sweep};
use super::tracer::BeamTracer;
use crate::View;
use crate::transport::luminance;
use rayon::prelude::*;
use std::rc::Rc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Mutex, PoisonError};

/// A beam's picture in the making.
pub struct BeamPicture<'a> {
    tracer: BeamTracer<'a>,
    view: View,
    /// What each thread adds up in.
    films: Vec<Mutex<BeamFilm>>,
    /// In each pixel, of the families that are done, row by row.
    light: Vec<[f64; 3]>,
    /// Families that are done.
    done: usize,
    /// Whether a family had more pieces than it may have.
    is_cut: AtomicBool,
    /// Of each family's light what had met the most surfaces, in units of [`GIVEN_UP_UNIT`].
    given_up: Vec<AtomicU64>,
}

/// Parts into which a family is divided, so that all threads have work.
const PARTS: usize = 8;

impl<'a> BeamPicture<'a> {
    /// An empty picture.
    pub fn new(tracer: BeamTracer<'a>, view: View) -> BeamPicture<'a> {
        let film = || Mutex::new(BeamFilm::new(view.width, view.height));
        let films = (0..rayon::current_num_threads().max(1)).map(|_| film()).collect();
        let light = vec![[0.0; 3]; view.width * view.height];
        let given_up = tracer.families.iter().map(|_| AtomicU64::new(0)).collect();
        BeamPicture { tracer, view, films, light, done: 0, is_cut: AtomicBool::new(false), given_up }
    }

    /// Sweeps `families` more, and those that have the last one's colour; `false` when all are done. Where `goes_on` says no they
    /// are left half done, and [`BeamPicture::is_cut`] says so.
    pub fn expose(&mut self, families: usize, goes_on: &(dyn Fn() -> bool + Sync)) -> bool {
        let last = self.done.saturating_add(families).min(self.tracer.families.len());
        while self.done < last {
            let color = self.tracer.families[self.done].0.color;
            let alike = self.tracer.families[self.done..].iter().take_while(|(family, _)| family.color == color);
            let (from, to) = (self.done, self.done + alike.count());
            // Families of one colour share the films.
            let most = self.tracer.families[from..to].iter().map(|(family, _)| family.source.falloff.most()).sum();
            (from * PARTS..to * PARTS).into_par_iter().for_each(|task| self.sweep(task, most, goes_on));
            self.develop(color.map(|channel| channel * most));
            self.done = to;
        }
        self.done < self.tracer.families.len()
    }

    /// One part of a family, onto the film of this thread.
    fn sweep(&self, task: usize, most: f64, goes_on: &(dyn Fn() -> bool + Sync)) {
        let beams = self.tracer.options.beams as usize;
        let (family, media) = &self.tracer.families[task / PARTS];
        let own = rayon::current_thread_index().unwrap_or(0) % self.films.len();
        let mut film = self.films[own].lock().unwrap_or_else(PoisonError::into_inner);
        let part = |number: usize| (beams * number / PARTS) as u32;
        let mut sweep = Sweep {
            tracer: &self.tracer,
            family,
            media: *media,
            view: &self.view,
            film: &mut film,
            most,
            horizon: Horizon::new(&self.view),
            met: Rc::default(),
            pending: Vec::new(),
            // A part by itself, so that what is left out does not depend on who is first.
            pieces_left: self.tracer.options.most_pieces / PARTS as u64,
            work: 0,
            given_up: 0,
            goes_on,
        };
        if !sweep.run(part(task % PARTS)..part(task % PARTS + 1)) {
            self.is_cut.store(true, Ordering::Relaxed);
        }
        self.given_up[task / PARTS].fetch_add(sweep.given_up, Ordering::Relaxed);
    }

    /// Takes the light from all films into the pixels.
    fn develop(&mut self, color: [f64; 3]) {
        let mut films: Vec<&mut BeamFilm> =
            self.films.iter_mut().map(|film| film.get_mut().unwrap_or_else(PoisonError::into_inner)).collect();
        let seen: Vec<&BeamFilm> = films.iter().map(|film| &**film).collect();
        BeamFilm::develop(&seen, color, &mut self.light);
        films.par_iter_mut().for_each(|film| film.clear());
    }

    /// Families that are done.
    pub fn done(&self) -> usize {
        self.done
    }

    /// The memory of what one thread adds up in, bytes.
    pub fn film_bytes(&self) -> usize {
        BeamFilm::new(self.view.width, self.view.height).bytes()
    }

    /// Whether some light is left out: a family had [`super::BeamOptions::most_pieces`].
    pub fn is_cut(&self) -> bool {
        self.is_cut.load(Ordering::Relaxed)
    }

    /// The part of all light that was given up because it had met [`super::BeamOptions::most_surfaces`].
    pub fn given_up(&self) -> f64 {
        let (mut lost, mut sent) = (0.0, 0.0);
        for ((family, _), given_up) in self.tracer.families.iter().zip(&self.given_up) {
            if family.lays != Lays::BeforeSurfaces {
                let power = luminance(family.color.map(f64::abs));
                sent += power;
                lost += power * given_up.load(Ordering::Relaxed) as f64 * GIVEN_UP_UNIT;
            }
        }
        if sent > 0.0 { lost / sent } else { 0.0 }
    }

    /// The fluence in each pixel, row by row, signed.
    pub fn fluence(&self) -> Vec<[f64; 3]> {
        self.light.iter().map(|light| light.map(|channel| channel / self.view.mm_per_px)).collect()
    }
}
