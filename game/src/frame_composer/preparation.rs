//! Preparation: the playfield at another aspect, made ready on a thread of its own while the one that is there is drawn.
//!
//! Rasterizing art takes a large part of a second, and so may the first frame of a renderer that has drawn nothing yet.
//! Both are done here: the new playfield draws a snapshot from nothing, and then catches up with the newest ones. It is
//! as warm as the one whose place it takes. A frame does not depend on what was drawn before it, so what is seen of the
//! change is the new aspect and nothing else.

use super::camera::Camera;
use super::playfield::{Aspect, Playfield, Stage};
use super::size_dependent_assets::SizeDependentAssets;
use crate::Failure;
use crate::simulation::Snapshot;
use std::sync::mpsc::{Receiver, Sender, TryRecvError, channel};
use std::sync::{Arc, Mutex, PoisonError};

/// How often a new playfield catches up: the first time with a second of play, then with what little that has taken.
const CATCH_UPS: usize = 3;

/// A playfield on its way.
pub struct Preparation {
    aspect: Aspect,
    newest: Arc<Mutex<Moment>>,
    prepared: Receiver<Result<Playfield, Failure>>,
    retired: Sender<Playfield>,
}

/// What the last frame was drawn of.
#[derive(Clone)]
pub struct Moment {
    /// What happened.
    pub snapshot: Snapshot,
    /// What followed it.
    pub camera: Camera,
}

impl Preparation {
    /// Begins to prepare `aspect`; what it has in common with the `known` assets is not made anew.
    ///
    /// # Errors
    /// If the system gives no thread.
    pub fn begin(
        stage: Stage,
        aspect: Aspect,
        known: SizeDependentAssets,
        moment: Moment,
    ) -> Result<Preparation, Failure> {
        let newest = Arc::new(Mutex::new(moment));
        let (outbox, prepared) = channel();
        let (retired, old) = channel::<Playfield>();
        let moments = newest.clone();
        let work = move || {
            // Whoever is no longer waited for has nothing to give.
            if outbox.send(prepare(&stage, aspect, known, &moments)).is_ok() {
                // The one whose place it takes is given back to the system here: that takes longer than a frame may.
                drop(old.recv());
            }
        };
        let thread = std::thread::Builder::new().name("preparation".to_string()).spawn(work);
        thread.map_err(|error| Failure::new(format!("cannot start a thread: {error}; close some programs")))?;
        Ok(Preparation { aspect, newest, prepared, retired })
    }

    /// What is being prepared.
    pub fn aspect(&self) -> Aspect {
        self.aspect
    }

    /// A frame of this moment is about to be drawn.
    pub fn follow(&self, moment: Moment) {
        *self.newest.lock().unwrap_or_else(PoisonError::into_inner) = moment;
    }

    /// The playfield, or why there is none, once it is ready.
    pub fn take(&self) -> Option<Result<Playfield, Failure>> {
        match self.prepared.try_recv() {
            Ok(prepared) => Some(prepared),
            Err(TryRecvError::Empty) => None,
            Err(TryRecvError::Disconnected) => Some(Err(Failure::new("the table could not be drawn at this size"))),
        }
    }

    /// Takes the playfield that is drawn no longer off the painter's hands.
    pub fn retire(self, old: Playfield) {
        // If the thread has ended, it is given back to the system here.
        let _ = self.retired.send(old);
    }
}

fn prepare(
    stage: &Stage,
    aspect: Aspect,
    known: SizeDependentAssets,
    newest: &Mutex<Moment>,
) -> Result<Playfield, Failure> {
    let mut playfield = Playfield::new(&stage.table, aspect, Some(known))?;
    // One thread: the others are play's.
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build();
    let pool = pool.map_err(|error| Failure::new(format!("cannot start a thread: {error}; close some programs")))?;
    for _ in 0..=CATCH_UPS {
        let mut moment = newest.lock().unwrap_or_else(PoisonError::into_inner).clone();
        playfield.aim(&mut moment.camera, &moment.snapshot, &stage.table);
        pool.install(|| playfield.render(stage, &moment.snapshot, None, &mut |_| {}));
    }
    Ok(playfield)
}
