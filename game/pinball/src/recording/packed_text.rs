//! Packed texts: what a recording carries of its table, as a zlib stream (RFC 1950) that can be read in any language.

use miniz_oxide::deflate::compress_to_vec_zlib;
use miniz_oxide::inflate::decompress_to_vec_zlib_with_limit;

/// The longest text that is packed or unpacked, bytes: a table of 65,535 surfaces has room in it, and a few bytes that
/// unpack to more than a machine has are refused.
pub(super) const MAX_BYTES: usize = 32 << 20;

/// How hard it is tried to make it small, of 10.
const LEVEL: u8 = 8;

/// The text as bytes; `None` if it is longer than [`MAX_BYTES`].
pub(super) fn pack(text: &str) -> Option<Vec<u8>> {
    (text.len() <= MAX_BYTES).then(|| compress_to_vec_zlib(text.as_bytes(), LEVEL))
}

/// What [`pack`] packed; `None` if it is anything else.
pub(super) fn unpack(bytes: &[u8]) -> Option<String> {
    String::from_utf8(decompress_to_vec_zlib_with_limit(bytes, MAX_BYTES).ok()?).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_come_back_and_nothing_longer_than_the_limit_does() {
        for text in ["", "{\"a\":0.1}", &"wall ".repeat(10_000)] {
            let packed = pack(text).unwrap();
            assert_eq!(unpack(&packed).as_deref(), Some(text));
            assert_eq!(unpack(&packed[..packed.len() - 1]), None);
        }
        let longest = " ".repeat(MAX_BYTES);
        assert!(unpack(&pack(&longest).unwrap()).is_some_and(|text| text.len() == MAX_BYTES));
        assert_eq!(pack(&(longest + " ")), None);
        // 40 kB that would come to more than the limit.
        let bomb = compress_to_vec_zlib(&vec![b' '; MAX_BYTES + 1], LEVEL);
        assert!(bomb.len() < 100_000);
        assert_eq!(unpack(&bomb), None);
    }
}
