//! Recordings: what was pressed comes back, and no damage goes unnoticed.

use game::Buttons;
use game::recording::{CHECKPOINT_TICKS, Checkpoint, Damage, FLUSH_TICKS, Header, Recording, Writer};
use game::simulation::{Hashes, SIMULATION_VERSION};
use game::storage::recordings;
use proptest::prelude::*;
use std::io::Cursor;

fn header() -> Header {
    Header { simulation_version: 7, table: "spectrum".into(), folder: String::new(), table_hash: 0x1234, seed: 99 }
}

/// Some hashes that are different at every tick.
fn hashes(tick: u64) -> Hashes {
    let part = |n: u64| (tick + n).wrapping_mul(0x9e37_79b9_7f4a_7c15).rotate_left(29);
    Hashes { balls: part(1), mechanisms: part(2), rules: part(3), lamps: part(4) }
}

/// What is down at `tick`: a press or a release every `every` ticks.
fn pressed(tick: u64, every: u64) -> Buttons {
    Buttons((tick / every).wrapping_mul(11) as u8 & Buttons::ALL.0)
}

fn played(inputs: impl Iterator<Item = Buttons>) -> Writer<Cursor<Vec<u8>>> {
    let mut writer = Writer::new(Cursor::new(Vec::new()), &header()).unwrap();
    for (tick, buttons) in inputs.enumerate() {
        writer.record(buttons, || hashes(tick as u64 + 1)).unwrap();
    }
    writer
}

/// A finished recording of so many ticks.
fn finished(ticks: u64) -> Vec<u8> {
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
    // The last chunk of play lies before the end's 3 + 50 + 8 bytes.
    let place = bytes.len() - 61 - 10;
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

fn refusal(header: &Header) -> String {
    let bytes = Writer::new(Cursor::new(Vec::new()), header).unwrap().finish(0, hashes(0), 0).unwrap().into_inner();
    recordings::start(&Recording::parse(&bytes).unwrap()).err().unwrap().to_string()
}

#[test]
fn another_simulation_another_table_and_no_table_are_refused_by_name() {
    let mine = Header { simulation_version: SIMULATION_VERSION, ..header() };
    let other = refusal(&Header { simulation_version: SIMULATION_VERSION + 3, ..mine.clone() });
    assert!(other.contains(&format!("simulation version {}", SIMULATION_VERSION + 3)), "{other}");
    let changed = refusal(&mine);
    assert!(changed.contains("spectrum has changed since"), "{changed}");
    let missing = refusal(&Header { table: "atlantis".into(), ..mine });
    assert!(missing.contains("there is no table called atlantis"), "{missing}");
}

#[test]
fn a_minute_of_busy_play_takes_less_than_ten_kilobytes() {
    // Ten changes of the buttons a second, all through.
    let minute = 60_000;
    let bytes = played((0..minute).map(|tick| pressed(tick, 100))).finish(0, hashes(minute), 0).unwrap().into_inner();
    println!("a minute with ten changes a second: {} bytes", bytes.len());
    assert!(bytes.len() < 10_000);
}
