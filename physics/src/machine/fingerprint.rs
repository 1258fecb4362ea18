//! A hash of plain data, the same on every machine.

use postcard::ser_flavors::Flavor;
use serde::Serialize;
use xxhash_rust::xxh3::{Xxh3, xxh3_64};

/// Most of what is hashed in a tick is shorter: it is hashed in one piece.
const ROOM: usize = 2048;

/// The XXH3 hash of the bytes that postcard makes of `value`, without keeping them: it is taken of every tick. Two values
/// of one type have the same hash only if they are the same, but for one chance in 2^64.
pub fn fingerprint(value: &impl Serialize) -> u64 {
    let mut bytes = Fingerprint::default();
    bytes.add(value);
    bytes.finish()
}

/// Bytes on their way into a hash: for values one after the other, as [`fingerprint`] for one.
pub struct Fingerprint {
    room: [u8; ROOM],
    filled: usize,
    /// What did not fit.
    before: Option<Box<Xxh3>>,
}

impl Default for Fingerprint {
    fn default() -> Fingerprint {
        Fingerprint { room: [0; ROOM], filled: 0, before: None }
    }
}

impl Fingerprint {
    /// The bytes of the next value.
    pub fn add(&mut self, value: &impl Serialize) {
        // Nothing that is hashed can fail to be written; if it did, two states would only look alike.
        let _ = postcard::serialize_with_flavor(value, self);
    }

    /// The next value as bytes.
    #[inline]
    pub fn add_bytes(&mut self, bytes: &[u8]) {
        if bytes.len() > ROOM - self.filled {
            self.spill();
        }
        if bytes.len() > ROOM {
            self.before.get_or_insert_default().update(bytes);
            return;
        }
        let room = &mut self.room[self.filled..self.filled + bytes.len()];
        // Most pieces are numbers of a few bytes: a call of memcpy for each would take longer than the hash.
        match bytes.len() {
            1 => room[0] = bytes[0],
            2..4 => ends::<2>(room, bytes),
            4..8 => ends::<4>(room, bytes),
            8..16 => ends::<8>(room, bytes),
            _ => room.copy_from_slice(bytes),
        }
        self.filled += bytes.len();
    }

    fn spill(&mut self) {
        self.before.get_or_insert_default().update(&self.room[..self.filled]);
        self.filled = 0;
    }

    /// The hash of all bytes so far.
    pub fn finish(self) -> u64 {
        let last = &self.room[..self.filled];
        match self.before {
            None => xxh3_64(last),
            Some(mut before) => {
                before.update(last);
                before.digest()
            }
        }
    }
}

impl Flavor for &mut Fingerprint {
    type Output = ();

    #[inline]
    fn try_push(&mut self, byte: u8) -> postcard::Result<()> {
        if self.filled == ROOM {
            self.spill();
        }
        self.room[self.filled] = byte;
        self.filled += 1;
        Ok(())
    }

    #[inline]
    fn try_extend(&mut self, bytes: &[u8]) -> postcard::Result<()> {
        self.add_bytes(bytes);
        Ok(())
    }

    fn finalize(self) -> postcard::Result<()> {
        Ok(())
    }
}

/// Copies `N` to `2 N` bytes: their first `N` and their last `N`.
#[inline]
fn ends<const N: usize>(to: &mut [u8], from: &[u8]) {
    if let (Some(to), Some(from)) = (to.first_chunk_mut::<N>(), from.first_chunk::<N>()) {
        *to = *from;
    }
    if let (Some(to), Some(from)) = (to.last_chunk_mut::<N>(), from.last_chunk::<N>()) {
        *to = *from;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_the_hash_of_all_bytes_whatever_their_number() {
        for length in [0, 1, 3, 17, 240, 4000, ROOM - 2, ROOM - 1, ROOM, ROOM + 1, 3 * ROOM, 3 * ROOM + 7] {
            let small: Vec<u64> = (0..length as u64).map(|index| index * index).collect();
            let text: String = ('a'..='z').cycle().take(length).collect();
            for value in [(&small, &text), (&small, &String::from("y"))] {
                let bytes = postcard::to_stdvec(&value).unwrap();
                assert_eq!(fingerprint(&value), xxh3_64(&bytes), "{length}");
                let mut parts = Fingerprint::default();
                parts.add(value.0);
                parts.add_bytes(&postcard::to_stdvec(value.1).unwrap());
                assert_eq!(parts.finish(), xxh3_64(&bytes), "{length} in parts");
            }
        }
    }
}
