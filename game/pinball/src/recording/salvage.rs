//! Salvage: what of a damaged recording is sound, and what of it play confirms.

use super::{CHECKPOINT_TICKS, Recording, Replay, Writer, format, reader};
use crate::simulation::Hashes;
use crate::{Failure, Table};
use std::io::{self, Cursor};
use std::sync::Arc;

impl Recording {
    /// A damaged recording cut to its sound part: a recording of its own, with the end of the game if that is sound;
    /// `None` if nothing was played in what is sound.
    pub fn salvage(bytes: &[u8]) -> Option<Vec<u8>> {
        let (length, ended) = reader::sound_part(bytes)?;
        let mut sound = bytes[..length].to_vec();
        sound[format::SEAL].copy_from_slice(&if ended { format::seal(length as u64) } else { [0; 16] });
        Some(sound)
    }

    /// A recording of which only a chunk that does not decide the game is damaged, such as the look, without that chunk. No check
    /// behind it can confirm anything, for each is of its bytes too: see [`Recording::confirmed_by_play`].
    pub fn salvage_game(bytes: &[u8]) -> Option<Recording> {
        reader::game(bytes)
    }

    /// As much of it as its own hashes confirm when it is played, with its end if that comes out too; `None` if that is
    /// nothing.
    ///
    /// # Errors
    /// As [`Recording::start`].
    pub fn confirmed_by_play(self, table: Arc<Table>) -> Result<Option<Recording>, Failure> {
        let mut replay = Replay::new(self, table)?;
        while replay.difference().is_none() && replay.step() {}
        let mut recording = replay.recording().clone();
        let last = match replay.difference() {
            None if recording.end.is_some() => return Ok(Some(recording)),
            None => recording.ticks,
            Some(difference) => difference.tick.saturating_sub(1),
        };
        recording.cut(last / CHECKPOINT_TICKS * CHECKPOINT_TICKS);
        Ok((recording.ticks > 0).then_some(recording))
    }

    /// Leaves out all but the first ticks.
    fn cut(&mut self, ticks: u64) {
        self.ticks = ticks;
        self.end = None;
        self.changes.retain(|change| change.tick < ticks);
        self.checkpoints.retain(|checkpoint| checkpoint.tick <= ticks);
    }

    /// The bytes of it, written anew; none for format 1, which carries no table.
    ///
    /// # Errors
    /// If its table is too large to be carried.
    pub fn to_bytes(&self) -> io::Result<Vec<u8>> {
        let Some(table) = &self.table else { return Ok(Vec::new()) };
        let mut writer = Writer::new(Cursor::new(Vec::new()), &self.header, table)?;
        for (tick, buttons) in (1..).zip(self.inputs()) {
            let hashes = || {
                let stored = self.checkpoints.get((tick / CHECKPOINT_TICKS) as usize - 1);
                let [balls, mechanisms, rules, lamps] = stored.map_or([0; 4], |stored| stored.hashes).map(u64::from);
                Hashes { balls, mechanisms, rules, lamps }
            };
            writer.record(buttons, hashes)?;
        }
        match self.end {
            Some(end) => writer.finish(end.score, end.hashes, end.hash).map(Cursor::into_inner),
            None => {
                writer.flush()?;
                Ok(std::mem::take(writer.get_mut().get_mut()))
            }
        }
    }
}
