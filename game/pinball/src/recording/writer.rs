//! Writes a recording while it is played.

use super::format::{
    CHECKPOINT_TICKS, END, FLUSH_TICKS, FORMAT_VERSION, LOOK, MAGIC, PLAY, SEAL, START, TABLE, check_bytes, put_varint,
    seal,
};
use super::{Checkpoint, End, Header, packed_text};
use crate::Buttons;
use crate::simulation::Hashes;
use crate::table::EmbeddedTable;
use std::io::{self, Seek, SeekFrom, Write};
use xxhash_rust::xxh3::Xxh3;

/// A recording that is being written. Every [`FLUSH_TICKS`] ticks one chunk is written in one piece and flushed; what has
/// been written is never touched again, but for the seal at the very end.
pub struct Writer<W> {
    out: W,
    hasher: Xxh3,
    length: u64,
    ticks: u64,
    down: Buttons,
    pending: Pending,
}

/// What has been played since the last flush.
#[derive(Default)]
struct Pending {
    ticks: u64,
    changes: u64,
    /// The tick of the last change, counted from the chunk's first.
    last_change: u64,
    encoded_changes: Vec<u8>,
    encoded_hashes: Vec<u8>,
}

impl<W: Write + Seek> Writer<W> {
    /// Begins a recording at the beginning of `out`, of a game on the table that it will carry.
    ///
    /// # Errors
    /// If `out` cannot be written, or the table is too large to be carried.
    pub fn new(mut out: W, header: &Header, table: &EmbeddedTable) -> io::Result<Writer<W>> {
        let mut front = MAGIC.to_vec();
        front.extend(FORMAT_VERSION.to_le_bytes());
        let mut hasher = Xxh3::new();
        hasher.update(&front);
        front.resize(SEAL.end, 0);
        out.write_all(&front)?;
        let length = front.len() as u64;
        let mut writer = Writer { out, hasher, length, ticks: 0, down: Buttons::NONE, pending: Pending::default() };
        writer.chunk(START, &header.payload())?;
        writer.chunk(TABLE, &packed(&table.game)?)?;
        if let Some(look) = &table.look {
            writer.chunk(LOOK, &packed(look)?)?;
        }
        Ok(writer)
    }

    /// Ticks recorded so far.
    pub fn ticks(&self) -> u64 {
        self.ticks
    }

    /// Bytes written so far.
    pub fn bytes(&self) -> u64 {
        self.length
    }

    /// Where it is written to.
    pub fn get_ref(&self) -> &W {
        &self.out
    }

    /// Where it is written to.
    pub fn get_mut(&mut self) -> &mut W {
        &mut self.out
    }

    /// Records one tick: what was down in it, and (asked only when it is a checkpoint) the hashes after it.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn record(&mut self, buttons: Buttons, hashes: impl FnOnce() -> Hashes) -> io::Result<()> {
        let pending = &mut self.pending;
        if buttons != self.down {
            put_varint(&mut pending.encoded_changes, pending.ticks - pending.last_change);
            pending.encoded_changes.push(buttons.0);
            pending.changes += 1;
            pending.last_change = pending.ticks;
            self.down = buttons;
        }
        pending.ticks += 1;
        self.ticks += 1;
        if self.ticks.is_multiple_of(CHECKPOINT_TICKS) {
            for hash in Checkpoint::of(self.ticks, hashes()).hashes {
                pending.encoded_hashes.extend(hash.to_le_bytes());
            }
        }
        if pending.ticks == FLUSH_TICKS { self.flush() } else { Ok(()) }
    }

    /// Writes what has been played since the last flush.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn flush(&mut self) -> io::Result<()> {
        let pending = std::mem::take(&mut self.pending);
        if pending.ticks == 0 {
            return Ok(());
        }
        let mut payload = Vec::new();
        put_varint(&mut payload, pending.ticks);
        put_varint(&mut payload, pending.changes);
        payload.extend(pending.encoded_changes);
        payload.extend(pending.encoded_hashes);
        self.chunk(PLAY, &payload)
    }

    /// Writes the rest, the end and the seal, and gives the file back.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn finish(mut self, score: i64, hashes: Hashes, hash: u64) -> io::Result<W> {
        self.flush()?;
        let End { tick, score, hashes, hash } = End { tick: self.ticks, score, hashes, hash };
        let mut payload = Vec::new();
        put_varint(&mut payload, tick);
        payload.extend(score.to_le_bytes());
        for part in [hashes.balls, hashes.mechanisms, hashes.rules, hashes.lamps, hash] {
            payload.extend(part.to_le_bytes());
        }
        self.chunk(END, &payload)?;
        self.out.seek(SeekFrom::Start(SEAL.start as u64))?;
        self.out.write_all(&seal(self.length))?;
        self.out.flush()?;
        Ok(self.out)
    }

    fn chunk(&mut self, tag: u8, payload: &[u8]) -> io::Result<()> {
        let mut bytes = vec![tag];
        put_varint(&mut bytes, payload.len() as u64);
        bytes.extend(payload);
        self.hasher.update(&bytes);
        bytes.extend(&self.hasher.digest().to_le_bytes()[..check_bytes(tag)]);
        self.out.write_all(&bytes)?;
        self.out.flush()?;
        self.length += bytes.len() as u64;
        Ok(())
    }
}

fn packed(text: &str) -> io::Result<Vec<u8>> {
    let too_large = || {
        let most = packed_text::MAX_BYTES >> 20;
        io::Error::other(format!("its table takes more than {most} MB, the most that a recording carries"))
    };
    packed_text::pack(text).ok_or_else(too_large)
}
