//! The words of the file format that its reader and its writer share.

/// What every recording begins with.
pub(super) const MAGIC: [u8; 8] = *b"\x89CAUSTIC";
/// The version of the file's form that is written and read.
pub const FORMAT_VERSION: u16 = 1;
/// Ticks between two stored hashes.
pub const CHECKPOINT_TICKS: u64 = 100;
/// Ticks between two flushes to the file.
pub const FLUSH_TICKS: u64 = 1000;
/// Where the seal lies: after magic and version.
pub(super) const SEAL: std::ops::Range<usize> = 10..26;
/// Tag of a chunk of play.
pub(super) const PLAY: u8 = b'P';
/// Tag of the last chunk of a finished recording.
pub(super) const END: u8 = b'E';
/// Tag and length.
pub(super) const CHUNK_HEAD: usize = 3;

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
