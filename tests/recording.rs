//! Recordings: what was pressed comes back, and no damage goes unnoticed.

#![expect(clippy::disallowed_methods, reason = "the test reads what it has written")]

use game::recording::{CHECKPOINT_TICKS, Checkpoint, Damage, FLUSH_TICKS, Header, Recording, Replay, Writer};
use game::simulation::{Hashes, SIMULATION_VERSION};
use game::storage::{assets, recordings, tables};
use game::table::EmbeddedTable;
use game::{Buttons, Simulation};
use proptest::prelude::*;
use std::io::Cursor;
use std::sync::Arc;
use xxhash_rust::xxh3::xxh3_64;

fn header() -> Header {
    Header { simulation_version: 7, table: "spectrum".into(), folder: String::new(), table_hash: 0x1234, seed: 99 }
}

/// A table that no test here plays on.
fn table() -> EmbeddedTable {
    EmbeddedTable { game: "{\"title\":\"none\"}".into(), look: Some("{}".into()) }
}

/// Some hashes that are different at every tick.
fn hashes(tick: u64) -> Hashes {
    let part = |n: u64| (tick + n).wrapping_mul(0x9e37_79b9_7f4a_7c15).rotate_left(29);
    Hashes { balls: part(1), mechanisms: part(2), rules: part(3), lamps: part(4) }
}

/// What is down at `tick`: a press or a release every `every` ticks.
pub fn pressed(tick: u64, every: u64) -> Buttons {
    Buttons((tick / every).wrapping_mul(11) as u8 & Buttons::ALL.0)
}

fn played(inputs: impl Iterator<Item = Buttons>) -> Writer<Cursor<Vec<u8>>> {
    let mut writer = Writer::new(Cursor::new(Vec::new()), &header(), &table()).unwrap();
    for (tick, buttons) in inputs.enumerate() {
        writer.record(buttons, || hashes(tick as u64 + 1)).unwrap();
    }
    writer
}

/// A finished recording of so many ticks.
pub fn finished(ticks: u64) -> Vec<u8> {
    played((0..ticks).map(|tick| pressed(tick, 130))).finish(4321, hashes(ticks), 5).unwrap().into_inner()
}

proptest! {
    #[test]
    fn every_tick_comes_back(runs in prop::collection::vec((0..=Buttons::ALL.0, 1..400_u64), 0..40)) {
        let inputs: Vec<Buttons> =
            runs.iter().flat_map(|&(down, ticks)| (0..ticks).map(move |_| Buttons(down))).collect();
        let ticks = inputs.len() as u64;
        let bytes = played(inputs.iter().copied()).finish(-3, hashes(ticks), 8).unwrap().into_inner();
        let recording = Recording::parse(&bytes).unwrap();
        prop_assert_eq!(&recording.header, &header());
        prop_assert_eq!(recording.table.as_ref(), Some(&table()));
        prop_assert_eq!(recording.ticks(), ticks);
        prop_assert!(recording.inputs().eq(inputs.iter().copied()));
        prop_assert!((0..ticks).all(|tick| recording.buttons(tick) == inputs[tick as usize]));
        prop_assert_eq!(recording.checkpoints.len() as u64, ticks / CHECKPOINT_TICKS);
        prop_assert!(recording.checkpoints.iter().all(|stored| *stored == Checkpoint::of(stored.tick, hashes(stored.tick))));
        let end = recording.end.unwrap();
        prop_assert_eq!((end.tick, end.score, end.hashes, end.hash), (ticks, -3, hashes(ticks), 8));
    }

    #[test]
    fn noise_is_refused_without_a_panic(noise in prop::collection::vec(any::<u8>(), 0..200), open in any::<bool>()) {
        let mut bytes = finished(0)[..10].to_vec();
        if open {
            bytes.extend([0; 16]);
        }
        bytes.extend(noise);
        prop_assert!(Recording::parse(&bytes).is_err());
    }
}

#[test]
fn every_other_value_of_every_byte_is_noticed() {
    let whole = finished(2 * FLUSH_TICKS + 150);
    assert!(Recording::parse(&whole).is_ok());
    for place in 0..whole.len() {
        for other in 1..=255 {
            let mut bytes = whole.clone();
            bytes[place] ^= other;
            assert!(Recording::parse(&bytes).is_err(), "byte {place} changed by {other:#x}");
        }
    }
}

#[test]
fn the_damaged_bytes_are_named_and_the_whole_ticks_before_them() {
    let mut bytes = finished(2 * FLUSH_TICKS + 150);
    // The last chunk of play lies before the end's 2 + 50 + 8 bytes.
    let place = bytes.len() - 60 - 10;
    bytes[place] ^= 1;
    let Err(Damage::Changed { first, last, ticks, .. }) = Recording::parse(&bytes) else { panic!("not noticed") };
    assert!((first..=last).contains(&place));
    assert_eq!(ticks, 2 * FLUSH_TICKS);
}

#[test]
fn a_finished_recording_that_is_cut_is_refused_at_every_length() {
    let whole = finished(2 * FLUSH_TICKS + 150);
    let full = whole.len() as u64;
    for length in 0..whole.len() {
        let damage = Recording::parse(&whole[..length]).unwrap_err();
        match length {
            0..8 => assert_eq!(damage, Damage::NotARecording),
            8..26 => assert_eq!(damage, Damage::CutInHeader(length as u64)),
            _ => assert_eq!(damage, Damage::CutShort { left: length as u64, whole: full }),
        }
    }
    let longer = [whole, vec![0]].concat();
    assert!(matches!(Recording::parse(&longer), Err(Damage::Changed { what: "after the end", .. })));
}

#[test]
fn a_killed_recording_is_whole_up_to_its_last_flush() {
    let ticks = 3 * FLUSH_TICKS + 700;
    let writer = played((0..ticks).map(|tick| pressed(tick, 130)));
    let flushed = writer.bytes() as usize;
    // The seal of a finished file is still open in the one that was not finished: take the bytes that both share.
    let mut bytes = writer.finish(0, hashes(ticks), 0).unwrap().into_inner();
    bytes[10..26].fill(0);
    bytes.truncate(flushed);
    let killed = Recording::parse(&bytes).unwrap();
    assert_eq!((killed.ticks(), killed.end), (3 * FLUSH_TICKS, None));
    assert!((0..killed.ticks()).all(|tick| killed.buttons(tick) == pressed(tick, 130)));
    // Torn in the middle of a write, it is whole up to the write before.
    for length in 0..flushed {
        match Recording::parse(&bytes[..length]) {
            Ok(torn) => {
                assert!(torn.ticks() < killed.ticks() && torn.ticks().is_multiple_of(FLUSH_TICKS));
                assert_eq!(torn.end, None);
            }
            Err(damage) => assert!(matches!(damage, Damage::NotARecording | Damage::CutInHeader(_))),
        }
    }
}

#[test]
fn another_format_version_is_refused_by_name() {
    let mut bytes = finished(10);
    bytes[8] = 9;
    assert_eq!(Recording::parse(&bytes), Err(Damage::FormatVersion(9)));
    assert!(Damage::FormatVersion(9).to_string().contains("format version 9"));
}

/// A recording of format 1 in which nothing was played and which was not finished.
pub fn format_1(header: &Header) -> Vec<u8> {
    let mut body = header.simulation_version.to_le_bytes().to_vec();
    body.extend([header.table_hash.to_le_bytes(), header.seed.to_le_bytes()].concat());
    body.push(header.table.len() as u8);
    body.extend(header.table.as_bytes());
    body.extend((header.folder.len() as u16).to_le_bytes());
    body.extend(header.folder.as_bytes());
    let front = b"\x89CAUSTIC\x01\x00";
    let check = xxh3_64(&[&front[..], &body].concat()).to_le_bytes();
    [&front[..], &[0; 16], &body, &check].concat()
}

fn refusal(header: &Header) -> String {
    recordings::start(&Recording::parse(&format_1(header)).unwrap()).err().unwrap().to_string()
}

#[test]
fn another_simulation_another_table_and_no_table_are_refused_by_name() {
    let mine = Header { simulation_version: SIMULATION_VERSION, ..header() };
    let other = refusal(&Header { simulation_version: SIMULATION_VERSION + 3, ..mine.clone() });
    assert!(other.contains(&format!("simulation version {}", SIMULATION_VERSION + 3)), "{other}");
    let changed = refusal(&mine);
    assert!(changed.contains("spectrum has changed since"), "{changed}");
    let missing = refusal(&Header { table: "atlantis".into(), ..mine });
    assert!(missing.contains("its table atlantis is not among the built-in ones"), "{missing}");
}

/// The demonstrations were recorded before there was a format 2, and are read for ever.
#[test]
fn recordings_of_format_1_are_read_and_no_damage_in_them_goes_unnoticed() {
    let demo = assets::demos().unwrap().into_iter().find(|path| path.ends_with("bot-4.caustic")).unwrap();
    let whole = std::fs::read(demo).unwrap();
    assert_eq!(whole[8..10], [1, 0]);
    let recording = Recording::parse(&whole).unwrap();
    assert_eq!((recording.header.table.as_str(), &recording.table), ("spectrum", &None));
    for place in 0..whole.len() {
        for other in [1, 0x80] {
            let mut bytes = whole.clone();
            bytes[place] ^= other;
            assert!(Recording::parse(&bytes).is_err(), "byte {place} changed by {other:#x}");
        }
    }
}

/// A recording in which nothing was played agreed with any end.
#[test]
fn the_end_of_a_recording_is_compared_even_if_nothing_was_played() {
    let table = Arc::new(tables::load("spectrum").unwrap());
    let new = || Simulation::new(table.clone(), 5).unwrap();
    let simulation = new();
    let ended = |score: i64, hashes: Hashes, hash: u64| {
        let header = Header::new(&table, 5);
        let writer = Writer::new(Cursor::new(Vec::new()), &header, &EmbeddedTable::of(&table)).unwrap();
        let bytes = writer.finish(score, hashes, hash).unwrap().into_inner();
        let replay = Replay::new(Recording::parse(&bytes).unwrap(), table.clone()).unwrap();
        replay.difference().map(|difference| (difference.tick, difference.fields.clone()))
    };
    let (hashes, hash) = (simulation.hashes(), simulation.hash());
    assert_eq!(ended(0, hashes, hash), None);
    assert_eq!(ended(1, hashes, hash), Some((0, vec!["score"])));
    assert_eq!(ended(0, hashes, hash ^ 1), Some((0, vec!["state"])));
    assert_eq!(ended(0, Hashes { lamps: hashes.lamps ^ 1, ..hashes }, hash), Some((0, vec!["lamps"])));
}

#[test]
fn a_minute_of_busy_play_takes_less_than_ten_kilobytes() {
    // Ten changes of the buttons a second, all through.
    let minute = 60_000;
    let bytes = played((0..minute).map(|tick| pressed(tick, 100))).finish(0, hashes(minute), 0).unwrap().into_inner();
    println!("a minute with ten changes a second: {} bytes", bytes.len());
    assert!(bytes.len() < 10_000);
}
