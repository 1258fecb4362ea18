//! A recording: it is refused, or it is played without harm.
//!
//! Checks and compression would refuse nearly every change, so an input is a recording without them: `resealed` puts
//! them in again.

use super::sample;
use pinball::{Recording, Simulation};
use std::sync::Arc;
use xxhash_rust::xxh3::{Xxh3, xxh3_64};

/// Ticks of a recording that are played.
const TICKS: usize = 40;

/// Reads `bytes` as a recording: as they are if the first is odd, else as chunks without checks.
pub fn run(bytes: &[u8]) {
    let Some((first, rest)) = bytes.split_first() else { return };
    let bytes = if first % 2 == 1 { rest.to_vec() } else { resealed(rest, first % 4 == 2) };
    match Recording::parse(&bytes) {
        Ok(recording) => play(&recording),
        Err(_) => {
            if let Some(sound) = Recording::salvage(&bytes) {
                let recording = Recording::parse(&sound).expect("what is salvaged is sound");
                assert!(recording.ticks() > 0);
                play(&recording);
            }
        }
    }
}

fn play(recording: &Recording) {
    let table = match recording.embedded_table() {
        Ok(Some(table)) => Arc::new(table),
        Ok(None) => return,
        Err(failure) => return sample::assert_told(&[failure]),
    };
    match Simulation::new(table, recording.header.seed) {
        Err(failure) => sample::assert_told(&[failure]),
        Ok(mut simulation) => recording.inputs().take(TICKS).for_each(|buttons| simulation.tick(buttons)),
    }
}

/// A recording of format 2 from chunks without checks, whose tables are plain text: see `docs/recording_format.md`.
fn resealed(mut chunks: &[u8], sealed: bool) -> Vec<u8> {
    let mut file = b"\x89CAUSTIC\x02\x00".to_vec();
    let mut hasher = Xxh3::new();
    hasher.update(&file);
    file.extend([0; 16]);
    while let Some((&tag, rest)) = chunks.split_first() {
        let (length, rest) = varint(rest);
        let (payload, rest) = rest.split_at(length.min(rest.len()));
        chunks = rest;
        let payload = match tag {
            b'T' | b'l' => miniz_oxide::deflate::compress_to_vec_zlib(payload, 1),
            _ => payload.to_vec(),
        };
        let mut chunk = vec![tag];
        let mut left = payload.len();
        while left >= 0x80 {
            chunk.push(left as u8 | 0x80);
            left >>= 7;
        }
        chunk.push(left as u8);
        chunk.extend(payload);
        hasher.update(&chunk);
        file.extend(chunk);
        let check = hasher.digest().to_le_bytes();
        file.extend(&check[..if tag == b'P' { 4 } else { 8 }]);
    }
    if sealed {
        let length = (file.len() as u64).to_le_bytes();
        file[10..18].copy_from_slice(&length);
        file[18..26].copy_from_slice(&xxh3_64(&length).to_le_bytes());
    }
    file
}

/// The number at the beginning, and what follows it.
fn varint(bytes: &[u8]) -> (usize, &[u8]) {
    let mut value = 0;
    for (index, byte) in bytes.iter().enumerate().take(4) {
        value |= usize::from(byte & 0x7f) << (7 * index);
        if byte & 0x80 == 0 {
            return (value, &bytes[index + 1..]);
        }
    }
    (value, &bytes[bytes.len().min(4)..])
}
