//! Plays a recording again, and finds any moment of it quickly.

use super::{CHECKPOINT_TICKS, Checkpoint, Recording, best_score};
use crate::simulation::Hashes;
use crate::timeline::TickSource;
use crate::{Failure, Simulation, Table};
use std::collections::BTreeMap;
use std::fmt;
use std::sync::Arc;

/// Ticks between two states that are kept to come back to.
const KEEP_TICKS: u64 = 5000;

/// A recording that is being played again. States are kept on the way, so going back is quick.
pub struct Replay {
    recording: Recording,
    simulation: Simulation,
    /// States by their number of ticks.
    kept: BTreeMap<u64, Simulation>,
    difference: Option<Difference>,
}

/// Where a replay is not what was recorded.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Difference {
    /// The first stored hash that differs: the number of ticks played.
    pub tick: u64,
    /// What differs: `balls`, `mechanisms`, `rules`, `lamps`, `score`, `state`.
    pub fields: Vec<&'static str>,
}

impl Replay {
    /// A replay that stands at the beginning of a recording that was played on `table`.
    ///
    /// # Errors
    /// As [`Recording::start`].
    pub fn new(recording: Recording, table: Arc<Table>) -> Result<Replay, Failure> {
        let simulation = recording.start(table)?;
        let kept = BTreeMap::from([(0, simulation.clone())]);
        // What ended before its first tick has an end as well.
        let difference = compare(&recording, &simulation, 0);
        Ok(Replay { recording, simulation, kept, difference })
    }

    /// What is played.
    pub fn recording(&self) -> &Recording {
        &self.recording
    }

    /// The state now.
    pub fn simulation(&self) -> &Simulation {
        &self.simulation
    }

    /// Ticks played up to now.
    pub fn tick(&self) -> u64 {
        self.simulation.ticks()
    }

    /// The first difference from what was recorded that has been met so far.
    pub fn difference(&self) -> Option<&Difference> {
        self.difference.as_ref()
    }

    /// Plays one tick; `false`, with nothing done, at the end.
    pub fn step(&mut self) -> bool {
        let before = self.tick();
        if before >= self.recording.ticks() {
            return false;
        }
        self.simulation.tick(self.recording.buttons(before));
        let tick = before + 1;
        if self.difference.is_none() {
            self.difference = compare(&self.recording, &self.simulation, tick);
        }
        if tick.is_multiple_of(KEEP_TICKS) {
            self.kept.entry(tick).or_insert_with(|| self.simulation.clone());
        }
        true
    }

    /// Goes to the moment when `tick` ticks had been played, or to the end if that comes first.
    pub fn seek(&mut self, tick: u64) {
        let nearest = self.kept.range(..=tick).next_back();
        if let Some((&kept, simulation)) = nearest
            && (tick < self.tick() || kept > self.tick())
        {
            self.simulation = simulation.clone();
        }
        while self.tick() < tick && self.step() {}
    }

    /// Saves the simulation and goes on with a new one that is restored from the bytes and from nothing else but the table.
    ///
    /// # Errors
    /// If the simulation refuses what it saved itself.
    pub fn save_and_restore(&mut self) -> Result<(), Failure> {
        let bytes = self.simulation.save();
        self.simulation = self.simulation.restored(&bytes)?;
        Ok(())
    }
}

impl TickSource for Replay {
    fn simulation(&self) -> &Simulation {
        &self.simulation
    }

    fn step(&mut self) -> bool {
        Replay::step(self)
    }
}

/// What differs at this tick from what is stored for it, if anything is.
fn compare(recording: &Recording, simulation: &Simulation, tick: u64) -> Option<Difference> {
    let mut fields = Vec::new();
    if tick.is_multiple_of(CHECKPOINT_TICKS)
        && let Some(number) = (tick / CHECKPOINT_TICKS).checked_sub(1)
        && let Some(stored) = recording.checkpoints.get(number as usize)
    {
        let found = Checkpoint::of(tick, simulation.hashes());
        let names = ["balls", "mechanisms", "rules", "lamps"];
        fields.extend((0..4).filter(|&i| stored.hashes[i] != found.hashes[i]).map(|i| names[i]));
    }
    if fields.is_empty()
        && let Some(end) = recording.end.filter(|end| end.tick == tick)
    {
        fields = different(end.hashes, simulation.hashes());
        if end.score != best_score(simulation) {
            fields.push("score");
        }
        if fields.is_empty() && end.hash != simulation.hash() {
            fields.push("state");
        }
    }
    (!fields.is_empty()).then_some(Difference { tick, fields })
}

fn different(stored: Hashes, found: Hashes) -> Vec<&'static str> {
    let pairs = [
        ("balls", stored.balls == found.balls),
        ("mechanisms", stored.mechanisms == found.mechanisms),
        ("rules", stored.rules == found.rules),
        ("lamps", stored.lamps == found.lamps),
    ];
    pairs.into_iter().filter(|(_, same)| !same).map(|(name, _)| name).collect()
}

impl fmt::Display for Difference {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let seconds = self.tick as f64 / f64::from(physics::TICKS_PER_SECOND);
        write!(formatter, "differs first at tick {} ({seconds:.1} s) in {}", self.tick, self.fields.join(", "))
    }
}
