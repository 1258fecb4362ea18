//! A recording that is being watched.

use super::contact_trail::ContactTrail;
use super::tick_clock::PlaybackSpeed;
use crate::hud::{ReplayProgress, TrailContact};
use crate::storage::recordings::ShownRecording;
use crate::{Failure, Simulation, Snapshot, Table};
use physics::TICKS_PER_SECOND;
use pinball::timeline::Timeline;
use std::sync::Arc;

/// How far the arrow keys seek, ticks.
pub const SEEK_TICKS: u64 = 5 * TICKS_PER_SECOND as u64;

/// A recording that is being watched.
pub struct ReplaySession {
    recording: ShownRecording,
    timeline: Timeline,
    contact_trail: ContactTrail,
    complaint: Option<String>,
    told: bool,
    /// How fast it runs.
    pub speed: PlaybackSpeed,
    /// It stands still.
    pub paused: bool,
}

impl ReplaySession {
    /// Watches a recording from its beginning.
    pub fn new(recording: ShownRecording) -> ReplaySession {
        ReplaySession {
            timeline: Timeline::new(recording.replay.simulation()),
            recording,
            contact_trail: ContactTrail::default(),
            complaint: None,
            told: false,
            speed: PlaybackSpeed::REAL,
            paused: false,
        }
    }

    /// The table that was played.
    pub fn table(&self) -> &Arc<Table> {
        self.recording.replay.simulation().table()
    }

    /// Plays some ticks; stands still at the end.
    pub fn play(&mut self, ticks: u64) {
        let contact_trail = &mut self.contact_trail;
        let after_tick = |game: &Simulation| contact_trail.add(game.ticks(), game.tick_events());
        let played = self.timeline.play(&mut self.recording.replay, ticks, after_tick);
        self.paused |= played < ticks;
        self.look_for_difference();
    }

    /// Goes some ticks back or on.
    pub fn seek(&mut self, forward: bool) {
        let now = self.recording.replay.tick();
        let target = if forward { now + SEEK_TICKS } else { now.saturating_sub(SEEK_TICKS) };
        self.recording.replay.seek(target);
        self.contact_trail.clear();
        self.show();
    }

    /// Stands still, or goes on; from the end, goes back to the beginning.
    pub fn toggle_pause(&mut self) {
        if self.recording.replay.tick() >= self.recording.replay.recording().ticks() {
            self.recording.replay.seek(0);
            self.contact_trail.clear();
            self.show();
        }
        self.paused = !self.paused;
    }

    fn show(&mut self) {
        self.timeline.reset_to(self.recording.replay.simulation());
        self.look_for_difference();
    }

    fn look_for_difference(&mut self) {
        if let Some(difference) = self.recording.replay.difference().filter(|_| !self.told) {
            let sentence = format!("This replay is not what was recorded: it {difference}.");
            crate::tell(&Failure::new(&sentence));
            self.complaint = Some(sentence);
            self.told = true;
        }
    }

    /// The snapshots of the last two ticks.
    pub fn snapshots(&self) -> (&Arc<Snapshot>, &Arc<Snapshot>) {
        self.timeline.snapshots()
    }

    /// The contact trail, as it is shown now.
    pub fn contact_trail(&self) -> Vec<TrailContact> {
        self.contact_trail.shown(self.timeline.current().tick)
    }

    /// What its pictures have to say all the time.
    pub fn notice(&self) -> Option<String> {
        self.recording.missing_art.clone()
    }

    /// What went wrong since the last call.
    pub fn complaint(&mut self) -> Option<String> {
        self.complaint.take()
    }

    /// How far it is.
    pub fn progress(&self) -> ReplayProgress {
        let seconds = |ticks: u64| ticks as f64 / f64::from(TICKS_PER_SECOND);
        ReplayProgress {
            at_s: seconds(self.recording.replay.tick()),
            length_s: seconds(self.recording.replay.recording().ticks()),
            speed: self.speed.label(),
            paused: self.paused,
        }
    }
}
