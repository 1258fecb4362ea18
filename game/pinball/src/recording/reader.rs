//! Reads a recording's bytes; believes nothing that no check has confirmed.

use super::format::{Bytes, CHECKPOINT_TICKS, CHUNK_HEAD, END, FORMAT_VERSION, MAGIC, PLAY, SEAL, seal};
use super::{Change, Checkpoint, Damage, End, Header, Recording};
use crate::Buttons;
use crate::simulation::Hashes;
use xxhash_rust::xxh3::Xxh3;

/// The recording in `bytes`.
pub(super) fn parse(bytes: &[u8]) -> Result<Recording, Damage> {
    let sealed = read_seal(bytes)?;
    let mut reader = Reader::open(bytes, sealed)?;
    while reader.chunk()? {}
    reader.close()
}

/// Checks the magic, the version and the seal; whether the file says that it is finished.
fn read_seal(bytes: &[u8]) -> Result<bool, Damage> {
    let mut front = Bytes(bytes);
    if front.array() != Some(MAGIC) {
        return Err(Damage::NotARecording);
    }
    let in_header = Damage::CutInHeader(bytes.len() as u64);
    match front.u16() {
        None => return Err(in_header),
        Some(FORMAT_VERSION) => {}
        Some(version) => return Err(Damage::FormatVersion(version)),
    }
    let found: [u8; SEAL.end - SEAL.start] = front.array().ok_or(in_header)?;
    if found == [0; 16] {
        return Ok(false);
    }
    let whole = Bytes(&found).u64().unwrap_or(0);
    let left = bytes.len() as u64;
    if found != seal(whole) {
        Err(Damage::Changed { first: SEAL.start, last: SEAL.end - 1, what: "the seal", ticks: 0 })
    } else if left < whole {
        Err(Damage::CutShort { left, whole })
    } else if left > whole {
        let (first, last) = (whole as usize, bytes.len() - 1);
        Err(Damage::Changed { first, last, what: "after the end", ticks: 0 })
    } else {
        Ok(true)
    }
}

/// A file that is being read.
struct Reader<'a> {
    bytes: &'a [u8],
    /// What has not been read.
    rest: Bytes<'a>,
    hasher: Xxh3,
    sealed: bool,
    ended: bool,
    recording: Recording,
}

impl<'a> Reader<'a> {
    /// Reads the header.
    fn open(bytes: &'a [u8], sealed: bool) -> Result<Reader<'a>, Damage> {
        let mut rest = Bytes(&bytes[SEAL.end..]);
        let header = Header::read(&mut rest);
        let body = &bytes[SEAL.end..bytes.len() - rest.0.len()];
        let check = rest.u64();
        let mut hasher = Xxh3::new();
        hasher.update(&bytes[..SEAL.start]);
        hasher.update(body);
        match (header, check) {
            (Some(header), Some(check)) if check == hasher.digest() => {
                let recording = Recording { header, checkpoints: vec![], end: None, changes: vec![], ticks: 0 };
                Ok(Reader { bytes, rest, hasher, sealed, ended: false, recording })
            }
            (Some(_), Some(_)) => {
                let last = bytes.len() - rest.0.len() - 1;
                Err(Damage::Changed { first: SEAL.end, last, what: "the header", ticks: 0 })
            }
            _ if sealed => {
                let last = bytes.len() - 1;
                Err(Damage::Changed { first: SEAL.end, last, what: "the header", ticks: 0 })
            }
            _ => Err(Damage::CutInHeader(bytes.len() as u64)),
        }
    }

    /// Reads the next chunk; whether there may be another.
    fn chunk(&mut self) -> Result<bool, Damage> {
        if self.rest.0.is_empty() {
            return Ok(false);
        }
        let first = self.bytes.len() - self.rest.0.len();
        match take_chunk(&mut self.rest) {
            Some(chunk) => {
                let last = self.bytes.len() - self.rest.0.len() - 1;
                let changed = Damage::Changed { first, last, what: "a chunk", ticks: self.recording.ticks };
                self.hasher.update(chunk.hashed);
                let known = chunk.check == self.hasher.digest() & chunk.check_mask && !self.ended;
                if known && self.accept(&chunk).is_some() { Ok(true) } else { Err(changed) }
            }
            // A file that was never sealed may end in the middle of a write.
            None if !self.sealed => Ok(false),
            None => Err(self.rest_changed(first)),
        }
    }

    fn rest_changed(&self, first: usize) -> Damage {
        let first = first.min(self.bytes.len() - 1);
        Damage::Changed { first, last: self.bytes.len() - 1, what: "a chunk", ticks: self.recording.ticks }
    }

    /// Adds what a chunk holds to the recording; `None` if it makes no sense.
    fn accept(&mut self, chunk: &Chunk) -> Option<()> {
        let mut payload = Bytes(chunk.payload);
        match chunk.tag {
            PLAY => read_play(&mut payload, &mut self.recording)?,
            _ => {
                let end = read_end(&mut payload)?;
                (end.tick == self.recording.ticks).then_some(())?;
                self.ended = true;
                // The end of a file that was never sealed is not believed: it was not quite finished.
                self.recording.end = self.sealed.then_some(end);
            }
        }
        payload.0.is_empty().then_some(())
    }

    fn close(self) -> Result<Recording, Damage> {
        if self.sealed && !self.ended {
            return Err(self.rest_changed(self.bytes.len()));
        }
        Ok(self.recording)
    }
}

/// A chunk whose check has not been confirmed.
struct Chunk<'a> {
    tag: u8,
    /// Tag, length and payload.
    hashed: &'a [u8],
    payload: &'a [u8],
    check: u64,
    /// Which bits of the hash the check holds.
    check_mask: u64,
}

/// The next chunk; `None`, with nothing taken, if the bytes do not hold a whole one.
fn take_chunk<'a>(rest: &mut Bytes<'a>) -> Option<Chunk<'a>> {
    let all = rest.0;
    let mut ahead = Bytes(all);
    let tag = ahead.byte()?;
    let length = usize::from(ahead.u16()?);
    let payload = ahead.take(length)?;
    let hashed = all.get(..CHUNK_HEAD + length)?;
    let (check, check_mask) = match tag {
        END => (ahead.u64()?, u64::MAX),
        _ => (u64::from(u32::from_le_bytes(ahead.array()?)), u64::from(u32::MAX)),
    };
    rest.0 = ahead.0;
    Some(Chunk { tag, hashed, payload, check, check_mask })
}

fn read_play(payload: &mut Bytes, recording: &mut Recording) -> Option<()> {
    let start = recording.ticks;
    let end = start.checked_add(payload.varint()?)?;
    let mut tick = start;
    for _ in 0..payload.varint()? {
        tick = tick.checked_add(payload.varint()?)?;
        let buttons = Buttons(payload.byte()?);
        (tick < end && Buttons::ALL.contains(buttons)).then_some(())?;
        recording.changes.push(Change { tick, buttons });
    }
    let (before, after) = (start / CHECKPOINT_TICKS, end / CHECKPOINT_TICKS);
    for number in before + 1..=after {
        let hashes = [payload.u16()?, payload.u16()?, payload.u16()?, payload.u16()?];
        recording.checkpoints.push(Checkpoint { tick: number * CHECKPOINT_TICKS, hashes });
    }
    recording.ticks = end;
    Some(())
}

fn read_end(payload: &mut Bytes) -> Option<End> {
    let tick = payload.varint()?;
    let score = payload.u64()?.cast_signed();
    let [balls, mechanisms, rules, lamps] = [payload.u64()?, payload.u64()?, payload.u64()?, payload.u64()?];
    let hash = payload.u64()?;
    Some(End { tick, score, hashes: Hashes { balls, mechanisms, rules, lamps }, hash })
}
