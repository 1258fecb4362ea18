//! A picture by beams in the making.

use super::film::BeamFilm;
use super::horizon::Horizon;
use super::sweep::Sweep;
use super::tracer::BeamTracer;
use crate::View;
use rayon::prelude::*;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};

/// A beam's picture in the making.
pub struct BeamPicture<'a> {
    tracer: BeamTracer<'a>,
    view: View,
    films: Vec<Mutex<BeamFilm>>,
    /// Tasks that are done.
    done: usize,
    /// Whether a family had more pieces than it may have.
    is_cut: AtomicBool,
}

/// Parts into which a family is divided, so that all threads have work.
const PARTS: usize = 8;

impl<'a> BeamPicture<'a> {
    /// An empty picture.
    pub fn new(tracer: BeamTracer<'a>, view: View) -> BeamPicture<'a> {
        let film = || Mutex::new(BeamFilm::new(view.width, view.height));
        let films = (0..rayon::current_num_threads().max(1)).map(|_| film()).collect();
        BeamPicture { tracer, view, films, done: 0, is_cut: AtomicBool::new(false) }
    }

    /// Sweeps up to `families` more; `false` when all are done. Where `goes_on` says no they are left half done, and
    /// [`BeamPicture::is_cut`] says so.
    pub fn expose(&mut self, families: usize, goes_on: &(dyn Fn() -> bool + Sync)) -> bool {
        let last = self.done.saturating_add(families).min(self.tracer.families.len());
        let beams = self.tracer.options.beams as usize;
        let horizon = Horizon::new(&self.view);
        (self.done * PARTS..last * PARTS).into_par_iter().for_each(|task| {
            let (family, media) = &self.tracer.families[task / PARTS];
            let own = rayon::current_thread_index().unwrap_or(0) % self.films.len();
            let mut film = self.films[own].lock().unwrap_or_else(std::sync::PoisonError::into_inner);
            let part = |number: usize| (beams * number / PARTS) as u32;
            let mut sweep = Sweep {
                tracer: &self.tracer,
                family,
                media: *media,
                view: &self.view,
                film: &mut film,
                horizon,
                met: Vec::new(),
                // A part by itself, so that what is left out does not depend on who is first.
                pieces_left: self.tracer.options.most_pieces / PARTS as u64,
                goes_on,
            };
            if !sweep.run(part(task % PARTS)..part(task % PARTS + 1)) {
                self.is_cut.store(true, Ordering::Relaxed);
            }
        });
        self.done = last;
        self.done < self.tracer.families.len()
    }

    /// The memory of what one thread adds up in, bytes.
    pub fn film_bytes(&self) -> usize {
        BeamFilm::new(self.view.width, self.view.height).bytes()
    }

    /// Whether some light is left out: a family had [`super::BeamOptions::most_pieces`].
    pub fn is_cut(&self) -> bool {
        self.is_cut.load(Ordering::Relaxed)
    }

    /// The fluence in each pixel, row by row, signed.
    pub fn fluence(&self) -> Vec<[f64; 3]> {
        let films: Vec<_> =
            self.films.iter().map(|film| film.lock().unwrap_or_else(std::sync::PoisonError::into_inner)).collect();
        let films: Vec<&BeamFilm> = films.iter().map(|film| &**film).collect();
        let scale = self.tracer.brightest / self.view.mm_per_px;
        BeamFilm::pixels(&films).into_iter().map(|light| light.map(|channel| channel * scale)).collect()
    }
}
