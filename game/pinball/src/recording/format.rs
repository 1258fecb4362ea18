//! The words of the file format that its readers and its writer share.

use super::Damage;
use super::damage::BEHIND;

/// What every recording begins with.
pub(super) const MAGIC: [u8; 8] = *b"\x89CAUSTIC";
/// The version of the format that is written.
pub const FORMAT_VERSION: u16 = 2;
/// The version of the format that came before, which is read for ever.
pub(super) const FORMAT_1: u16 = 1;
/// Ticks between two stored hashes.
pub const CHECKPOINT_TICKS: u64 = 100;
/// Ticks between two flushes to the file.
pub const FLUSH_TICKS: u64 = 1000;
/// Where the seal lies: after magic and version.
pub(super) const SEAL: std::ops::Range<usize> = 10..26;
/// Tag of the first chunk: what the simulation was started with.
pub(super) const START: u8 = b'S';
/// Tag of the chunk of what decides the game on the table.
pub(super) const TABLE: u8 = b'T';
/// Tag of the chunk of how the table looks, which may be skipped.
pub(super) const LOOK: u8 = b'l';
/// Tag of a chunk of play.
pub(super) const PLAY: u8 = b'P';
/// Tag of the last chunk of a finished recording.
pub(super) const END: u8 = b'E';

/// Whether a reader that does not know a chunk's tag may go on without it.
pub(super) fn may_be_skipped(tag: u8) -> bool {
    tag.is_ascii_lowercase()
}

/// Bytes of the check behind a chunk of format 2: a chunk of play comes every second and has a short one.
pub(super) fn check_bytes(tag: u8) -> usize {
    if tag == PLAY { 4 } else { 8 }
}

/// The version of the format that a file is written in.
pub(super) fn read_version(bytes: &[u8]) -> Result<u16, Damage> {
    let mut front = Bytes(bytes);
    if front.array() != Some(MAGIC) {
        return Err(Damage::NotARecording);
    }
    match front.u16() {
        None => Err(Damage::CutInHeader(bytes.len() as u64)),
        Some(version @ (FORMAT_1 | FORMAT_VERSION)) => Ok(version),
        Some(version) => Err(Damage::FormatVersion(version)),
    }
}

/// Whether a file's seal says that it is finished.
pub(super) fn read_seal(bytes: &[u8]) -> Result<bool, Damage> {
    let in_header = Damage::CutInHeader(bytes.len() as u64);
    let found: [u8; SEAL.end - SEAL.start] = bytes.get(SEAL).and_then(|seal| seal.try_into().ok()).ok_or(in_header)?;
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
        Err(Damage::Changed { first, last, what: BEHIND, ticks: 0 })
    } else {
        Ok(true)
    }
}

/// The seal of a finished file of this many bytes.
pub(super) fn seal(length: u64) -> [u8; 16] {
    let mut seal = [0; 16];
    seal[..8].copy_from_slice(&length.to_le_bytes());
    let check = xxhash_rust::xxh3::xxh3_64(&seal[..8]);
    seal[8..].copy_from_slice(&check.to_le_bytes());
    seal
}

/// Appends a number, seven bits a byte, the lowest first (LEB128).
pub(super) fn put_varint(bytes: &mut Vec<u8>, mut number: u64) {
    while number >= 0x80 {
        bytes.push(number as u8 | 0x80);
        number >>= 7;
    }
    bytes.push(number as u8);
}

/// Takes bytes from the front of a slice; everything is `None` once they run out.
pub(super) struct Bytes<'a>(pub &'a [u8]);

impl<'a> Bytes<'a> {
    /// The next `count` bytes.
    pub fn take(&mut self, count: usize) -> Option<&'a [u8]> {
        let (taken, rest) = self.0.split_at_checked(count)?;
        self.0 = rest;
        Some(taken)
    }

    /// All that is left.
    pub fn rest(&mut self) -> &'a [u8] {
        std::mem::take(&mut self.0)
    }

    /// The next `N` bytes.
    pub fn array<const N: usize>(&mut self) -> Option<[u8; N]> {
        self.take(N)?.try_into().ok()
    }

    /// The next byte.
    pub fn byte(&mut self) -> Option<u8> {
        self.array().map(|[byte]| byte)
    }

    /// The next two bytes' number.
    pub fn u16(&mut self) -> Option<u16> {
        self.array().map(u16::from_le_bytes)
    }

    /// The next eight bytes' number.
    pub fn u64(&mut self) -> Option<u64> {
        self.array().map(u64::from_le_bytes)
    }

    /// The next number that [`put_varint`] wrote.
    pub fn varint(&mut self) -> Option<u64> {
        let mut number = 0_u64;
        for shift in (0..64).step_by(7) {
            let byte = self.byte()?;
            let bits = u64::from(byte & 0x7f);
            if (bits << shift) >> shift != bits {
                return None;
            }
            number |= bits << shift;
            if byte & 0x80 == 0 {
                return Some(number);
            }
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn varints_come_back_and_small_ones_are_short() {
        for (number, length) in [(0, 1), (127, 1), (128, 2), (16_383, 2), (16_384, 3), (u64::MAX, 10)] {
            let mut bytes = Vec::new();
            put_varint(&mut bytes, number);
            assert_eq!(bytes.len(), length);
            assert_eq!(Bytes(&bytes).varint(), Some(number));
            assert_eq!(Bytes(&bytes[..length - 1]).varint(), None);
        }
        assert_eq!(Bytes(&[0xff; 9]).varint(), None);
        assert_eq!(Bytes(&[0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0x02]).varint(), None, "65 bits");
    }
}
