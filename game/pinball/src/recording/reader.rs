//! Reads a recording's bytes; believes nothing that no check has confirmed.

use super::format::{self, Bytes, CHECKPOINT_TICKS, END, FORMAT_1, LOOK, PLAY, SEAL, START, TABLE};
use super::{Change, Checkpoint, Damage, End, Header, Recording, packed_text};
use crate::Buttons;
use crate::simulation::Hashes;
use crate::table::EmbeddedTable;
use xxhash_rust::xxh3::Xxh3;

/// The recording in `bytes`.
pub(super) fn parse(bytes: &[u8]) -> Result<Recording, Damage> {
    let version = format::read_version(bytes)?;
    let mut reader = Reader::open(bytes, version, format::read_seal(bytes)?)?;
    while reader.chunk()? {}
    reader.close()
}

/// How many bytes of a damaged recording are sound, and whether its end is among them; `None` if nothing was played in
/// them. Only what its seal says is not believed.
pub(super) fn sound_part(bytes: &[u8]) -> Option<(usize, bool)> {
    let mut reader = Reader::open(bytes, format::read_version(bytes).ok()?, false).ok()?;
    let mut sound = (reader.at(), reader.ended);
    while reader.chunk().is_ok_and(|more| more) {
        sound = (reader.at(), reader.ended);
    }
    (reader.ticks > 0).then_some(sound)
}

/// The game of a recording in which only chunks that do not decide it are damaged: without them, and as far as what comes
/// behind makes sense. Nothing confirms that, for every check is of all bytes before it.
pub(super) fn game(bytes: &[u8]) -> Option<Recording> {
    let version = format::read_version(bytes).ok()?;
    let mut reader = Reader::open(bytes, version, format::read_seal(bytes).unwrap_or(false)).ok()?;
    while reader.game.is_none() {
        reader.chunk().ok().filter(|more| *more)?;
    }
    let mut is_damaged = false;
    while !reader.ended
        && let Some(chunk) = take_chunk(&mut reader.rest, version)
    {
        let confirmed = reader.confirms(&chunk);
        if format::may_be_skipped(chunk.tag) && !confirmed {
            is_damaged = true;
            continue;
        }
        let before = (reader.ticks, reader.changes.len(), reader.checkpoints.len());
        if reader.accept(&chunk).is_err() {
            reader.ticks = before.0;
            reader.changes.truncate(before.1);
            reader.checkpoints.truncate(before.2);
            break;
        }
    }
    reader.sealed = false; // what its end says is taken by now, and nothing more is asked of it
    reader.close().ok().filter(|recording| is_damaged && recording.ticks > 0)
}

/// A file that is being read.
struct Reader<'a> {
    bytes: &'a [u8],
    /// What has not been read.
    rest: Bytes<'a>,
    hasher: Xxh3,
    version: u16,
    sealed: bool,
    ended: bool,
    header: Option<Header>,
    game: Option<String>,
    look: Option<String>,
    changes: Vec<Change>,
    checkpoints: Vec<Checkpoint>,
    end: Option<End>,
    ticks: u64,
}

/// Why a chunk is not taken.
enum Refusal {
    /// It makes no sense.
    Nonsense,
    /// It makes sense to a later program.
    Unknown,
}

impl<'a> Reader<'a> {
    /// Reads what comes before the chunks.
    fn open(bytes: &'a [u8], version: u16, sealed: bool) -> Result<Reader<'a>, Damage> {
        let mut hasher = Xxh3::new();
        hasher.update(&bytes[..SEAL.start]);
        let rest = Bytes(bytes.get(SEAL.end..).ok_or(Damage::CutInHeader(bytes.len() as u64))?);
        let mut reader = Reader {
            bytes,
            rest,
            hasher,
            version,
            sealed,
            ended: false,
            header: None,
            game: None,
            look: None,
            changes: Vec::new(),
            checkpoints: Vec::new(),
            end: None,
            ticks: 0,
        };
        if version == FORMAT_1 {
            reader.header_of_format_1()?;
        }
        Ok(reader)
    }

    fn header_of_format_1(&mut self) -> Result<(), Damage> {
        let before = self.rest.0;
        let header = Header::read_format_1(&mut self.rest);
        self.hasher.update(&before[..before.len() - self.rest.0.len()]);
        let check = self.rest.u64();
        match (header, check) {
            (Some(header), Some(check)) if check == self.hasher.digest() => {
                self.header = Some(header);
                Ok(())
            }
            (Some(_), Some(_)) => Err(self.changed(SEAL.end, self.at() - 1, "the header")),
            _ if self.sealed => Err(self.changed(SEAL.end, self.bytes.len() - 1, "the header")),
            _ => Err(Damage::CutInHeader(self.bytes.len() as u64)),
        }
    }

    /// The byte that is read next.
    fn at(&self) -> usize {
        self.bytes.len() - self.rest.0.len()
    }

    /// Reads the next chunk; whether there may be another.
    fn chunk(&mut self) -> Result<bool, Damage> {
        if self.rest.0.is_empty() {
            return Ok(false);
        }
        let first = self.at();
        let Some(chunk) = take_chunk(&mut self.rest, self.version) else {
            // A file that was never sealed may end in the middle of a write.
            return if self.sealed { Err(self.rest_changed(first)) } else { Ok(false) };
        };
        let confirmed = self.confirms(&chunk) && !self.ended;
        let before = (self.ticks, self.ended);
        let accepted = confirmed.then(|| self.accept(&chunk));
        if !matches!(accepted, Some(Ok(()))) {
            (self.ticks, self.ended) = before; // nothing counts of a chunk that is not taken
        }
        match accepted {
            Some(Ok(())) => Ok(true),
            Some(Err(Refusal::Unknown)) => Err(Damage::UnknownChunk(chunk.tag.into())),
            Some(Err(Refusal::Nonsense)) | None => Err(self.changed(first, self.at() - 1, "a chunk")),
        }
    }

    /// Whether a chunk's check is of it and of all before it.
    fn confirms(&mut self, chunk: &Chunk) -> bool {
        self.hasher.update(chunk.hashed);
        chunk.check == &self.hasher.digest().to_le_bytes()[..chunk.check.len()]
    }

    fn rest_changed(&self, first: usize) -> Damage {
        self.changed(first.min(self.bytes.len() - 1), self.bytes.len() - 1, "a chunk")
    }

    fn changed(&self, first: usize, last: usize, what: &'static str) -> Damage {
        Damage::Changed { first, last, what, ticks: self.ticks }
    }

    /// Adds what a chunk holds to the recording.
    fn accept(&mut self, chunk: &Chunk) -> Result<(), Refusal> {
        let mut payload = Bytes(chunk.payload);
        // A recording begins with its start, once, and no game is played on a table that nobody knows.
        let in_order = match (chunk.tag, self.version) {
            (PLAY | END, FORMAT_1) => true,
            (_, FORMAT_1) => false,
            (START, _) => self.header.is_none(),
            (TABLE, _) => self.header.is_some() && self.game.is_none(),
            (PLAY | END, _) => self.game.is_some(),
            _ => self.header.is_some(),
        };
        let taken = in_order.then_some(()).and_then(|()| match chunk.tag {
            START => Header::read(&mut payload).map(|header| self.header = Some(header)),
            TABLE => packed_text::unpack(payload.rest()).map(|game| self.game = Some(game)),
            LOOK => packed_text::unpack(payload.rest()).map(|look| self.look = Some(look)),
            PLAY => self.play(&mut payload),
            END => self.read_end(&mut payload),
            _ => {
                payload.rest();
                Some(())
            }
        });
        let is_known = matches!(chunk.tag, START | TABLE | LOOK | PLAY | END);
        match taken.filter(|()| payload.0.is_empty()) {
            Some(()) if is_known || format::may_be_skipped(chunk.tag) => Ok(()),
            Some(()) => Err(Refusal::Unknown),
            None => Err(Refusal::Nonsense),
        }
    }

    fn play(&mut self, payload: &mut Bytes) -> Option<()> {
        let start = self.ticks;
        let end = start.checked_add(payload.varint()?)?;
        let mut tick = start;
        for _ in 0..payload.varint()? {
            tick = tick.checked_add(payload.varint()?)?;
            let buttons = Buttons(payload.byte()?);
            (tick < end && Buttons::ALL.contains(buttons)).then_some(())?;
            self.changes.push(Change { tick, buttons });
        }
        let (before, after) = (start / CHECKPOINT_TICKS, end / CHECKPOINT_TICKS);
        for number in before + 1..=after {
            let hashes = [payload.u16()?, payload.u16()?, payload.u16()?, payload.u16()?];
            self.checkpoints.push(Checkpoint { tick: number * CHECKPOINT_TICKS, hashes });
        }
        self.ticks = end;
        Some(())
    }

    fn read_end(&mut self, payload: &mut Bytes) -> Option<()> {
        let tick = payload.varint()?;
        let score = payload.u64()?.cast_signed();
        let [balls, mechanisms, rules, lamps] = [payload.u64()?, payload.u64()?, payload.u64()?, payload.u64()?];
        let end = End { tick, score, hashes: Hashes { balls, mechanisms, rules, lamps }, hash: payload.u64()? };
        (end.tick == self.ticks).then_some(())?;
        self.ended = true;
        // The end of a file that was never sealed is not believed: it was not quite finished.
        self.end = self.sealed.then_some(end);
        Some(())
    }

    fn close(self) -> Result<Recording, Damage> {
        if self.sealed && !self.ended {
            return Err(self.rest_changed(self.bytes.len()));
        }
        let length = self.bytes.len() as u64;
        let header = self.header.ok_or(Damage::CutInHeader(length))?;
        if self.version != FORMAT_1 && self.game.is_none() {
            return Err(Damage::CutInHeader(length));
        }
        let look = self.look;
        let table = self.game.map(|game| EmbeddedTable { game, look });
        let Reader { checkpoints, end, changes, ticks, .. } = self;
        Ok(Recording { header, table, checkpoints, end, changes, ticks })
    }
}

/// A chunk whose check has not been confirmed.
struct Chunk<'a> {
    tag: u8,
    /// Tag, length and payload.
    hashed: &'a [u8],
    payload: &'a [u8],
    /// The first bytes of the hash.
    check: &'a [u8],
}

/// The next chunk; `None`, with nothing taken, if the bytes do not hold a whole one.
fn take_chunk<'a>(rest: &mut Bytes<'a>, version: u16) -> Option<Chunk<'a>> {
    let all = rest.0;
    let mut ahead = Bytes(all);
    let tag = ahead.byte()?;
    let length = if version == FORMAT_1 { usize::from(ahead.u16()?) } else { ahead.varint()?.try_into().ok()? };
    let payload = ahead.take(length)?;
    let hashed = &all[..all.len() - ahead.0.len()];
    let check = match (version, tag) {
        (FORMAT_1, END) => 8,
        (FORMAT_1, _) => 4,
        _ => format::check_bytes(tag),
    };
    let check = ahead.take(check)?;
    rest.0 = ahead.0;
    Some(Chunk { tag, hashed, payload, check })
}
