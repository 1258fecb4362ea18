//! The chunks of a recording of format 2, and the table that it carries.

use super::recording::{finished, pressed};
use game::recording::{Damage, FLUSH_TICKS, Recorder, Recording, Replay};
use game::storage::tables;
use game::table::EmbeddedTable;
use game::{Buttons, Simulation};
use std::io::Cursor;
use std::sync::Arc;
use xxhash_rust::xxh3::{Xxh3, xxh3_64};

/// A recording of format 2 as `docs/recording_format.md` says it: the tag and the payload of each chunk.
fn chunks(bytes: &[u8]) -> Vec<(u8, Vec<u8>)> {
    let (mut chunks, mut at) = (Vec::new(), 26);
    while at < bytes.len() {
        let (tag, mut length, mut shift) = (bytes[at], 0, 0);
        loop {
            at += 1;
            length |= usize::from(bytes[at] & 0x7f) << shift;
            shift += 7;
            if bytes[at] < 0x80 {
                break;
            }
        }
        chunks.push((tag, bytes[at + 1..at + 1 + length].to_vec()));
        at += 1 + length + if tag == b'P' { 4 } else { 8 };
    }
    chunks
}

/// The finished recording of these chunks.
fn sealed(chunks: &[(u8, Vec<u8>)]) -> Vec<u8> {
    let mut bytes = b"\x89CAUSTIC\x02\x00".to_vec();
    let mut hasher = Xxh3::new();
    hasher.update(&bytes);
    bytes.extend([0; 16]);
    for (tag, payload) in chunks {
        let mut chunk = vec![*tag];
        let mut length = payload.len();
        while length >= 0x80 {
            chunk.push(length as u8 | 0x80);
            length >>= 7;
        }
        chunk.push(length as u8);
        chunk.extend(payload);
        hasher.update(&chunk);
        bytes.extend(chunk);
        bytes.extend(&hasher.digest().to_le_bytes()[..if *tag == b'P' { 4 } else { 8 }]);
    }
    let length = (bytes.len() as u64).to_le_bytes();
    bytes[10..18].copy_from_slice(&length);
    bytes[18..26].copy_from_slice(&xxh3_64(&length).to_le_bytes());
    bytes
}

#[test]
fn an_unknown_chunk_is_skipped_if_its_tag_is_small_and_refused_by_name_if_it_is_not() {
    let whole = finished(1500);
    let known = chunks(&whole);
    assert_eq!(known.iter().map(|(tag, _)| *tag as char).collect::<String>(), "STlPPE");
    assert_eq!(sealed(&known), whole);
    let with = |at: usize, tag: u8| {
        let mut more = known.clone();
        more.insert(at, (tag, vec![7; 300]));
        Recording::parse(&sealed(&more))
    };
    for at in 1..6 {
        assert_eq!(with(at, b'x'), Recording::parse(&whole), "before chunk {at}");
        assert_eq!(with(at, b'O'), Err(Damage::UnknownChunk('O')), "before chunk {at}");
    }
    assert!(matches!(with(0, b'x'), Err(Damage::Changed { .. })), "nothing comes before the start");
    assert!(matches!(with(6, b'x'), Err(Damage::Changed { .. })), "nothing comes after the end");
    let told = Damage::UnknownChunk('O').to_string();
    assert!(told.contains("chunk `O`") && told.contains("newer Caustic"), "{told}");
}

#[test]
fn chunks_in_another_order_or_without_sense_are_refused() {
    let known = chunks(&finished(1500));
    type Change<'a> = &'a dyn Fn(&mut Vec<(u8, Vec<u8>)>);
    let changed = |change: Change| {
        let mut chunks = known.clone();
        change(&mut chunks);
        Recording::parse(&sealed(&chunks)).is_err()
    };
    assert!(!changed(&|_| {}));
    assert!(!changed(&|chunks| _ = chunks.remove(2)), "how the table looks may be missing");
    for twice in [0, 1, 5] {
        assert!(changed(&|chunks| chunks.insert(twice, chunks[twice].clone())), "{twice} twice");
        assert!(changed(&|chunks| _ = chunks.remove(twice)), "without {twice}");
    }
    assert!(changed(&|chunks| chunks.swap(1, 3)), "play before the table");
    assert!(changed(&|chunks| chunks[0].1.push(0)), "a byte too many");
    assert!(changed(&|chunks| _ = chunks[0].1.pop()), "a byte too few");
    assert!(changed(&|chunks| chunks[1].1 = b"{}".to_vec()), "a table that is not packed");
}

/// A bad sector in the middle of a long game lost all of it.
#[test]
fn a_damaged_recording_is_cut_to_its_sound_part() {
    let whole = finished(3 * FLUSH_TICKS + 150);
    assert_eq!(Recording::salvage(&whole).as_deref(), Some(&whole[..]), "what is whole stays whole");
    let mut lengths = std::collections::BTreeSet::new();
    for place in 0..whole.len() {
        let mut bytes = whole.clone();
        bytes[place] ^= 0x10;
        let Some(sound) = Recording::salvage(&bytes) else { continue };
        let recording = Recording::parse(&sound).unwrap();
        assert!((0..recording.ticks()).all(|tick| recording.buttons(tick) == pressed(tick, 130)), "byte {place}");
        assert_eq!(recording.end.is_some(), (10..26).contains(&place), "only the seal can be made anew");
        lengths.insert(recording.ticks());
    }
    assert_eq!(lengths, [1000, 2000, 3000, 3150].into());
    for length in 0..whole.len() {
        let ticks = Recording::salvage(&whole[..length]).map(|sound| Recording::parse(&sound).unwrap().ticks());
        assert!(ticks.is_none_or(|ticks| ticks == 3150 || ticks.is_multiple_of(FLUSH_TICKS)), "cut at {length}");
    }
    let longer = [&whole[..], b"rubbish"].concat();
    assert_eq!(Recording::salvage(&longer), Some(whole));
}

/// One bit in the chunk of how the table looks, which does not decide the game, lost all of it.
#[test]
fn a_game_whose_look_is_damaged_is_kept_as_far_as_play_confirms_it() {
    let table = Arc::new(tables::load("spectrum").unwrap());
    let mut simulation = Simulation::new(table.clone(), 7).unwrap();
    let mut recorder = Recorder::new(Cursor::new(Vec::new()), &simulation, 7).unwrap();
    for tick in 0..2450 {
        simulation.tick(pressed(tick, 130));
        recorder.record(&simulation, pressed(tick, 130)).unwrap();
    }
    let whole = recorder.finish(&simulation).unwrap().into_inner();
    let at = |tag: u8| {
        let before: Vec<_> = chunks(&whole).into_iter().take_while(|chunk| chunk.0 != tag).collect();
        sealed(&before).len() + 40
    };
    let salvaged = |places: &[usize]| {
        let mut bytes = whole.clone();
        places.iter().for_each(|place| bytes[*place] ^= 1);
        assert_eq!(Recording::salvage(&bytes), None, "no check confirms any of it");
        let game = Recording::salvage_game(&bytes)?.confirmed_by_play(table.clone()).unwrap()?;
        let again = Recording::parse(&game.to_bytes().unwrap()).unwrap();
        assert_eq!(again, game);
        assert_eq!(again.table.as_ref().unwrap().look, None);
        assert!((0..game.ticks()).all(|tick| game.buttons(tick) == pressed(tick, 130)));
        Some((game.ticks(), game.end.is_some()))
    };
    assert_eq!(salvaged(&[at(b'l')]), Some((2450, true)));
    let in_the_second_second = at(b'P') + 110;
    let (ticks, ended) = salvaged(&[at(b'l'), in_the_second_second]).unwrap();
    assert!(ticks < 2450 && ticks.is_multiple_of(100) && !ended, "{ticks}");
    assert_eq!(Recording::salvage_game(&whole), None, "nothing of it is damaged");
}

/// The ticks of a chunk that was refused counted, and its end too: what was salvaged had no ticks, or a seal without an end.
#[test]
fn nothing_counts_of_a_chunk_that_is_refused() {
    let known = chunks(&finished(1500));
    let with_a_byte_too_many = |tag: u8, all: bool| {
        let mut chunks = known.clone();
        let own = chunks.iter_mut().filter(|chunk| chunk.0 == tag);
        own.take(if all { usize::MAX } else { 1 }).for_each(|chunk| chunk.1.push(0));
        sealed(&chunks)
    };
    assert_eq!(Recording::salvage(&with_a_byte_too_many(b'P', true)), None);
    let sound = Recording::salvage(&with_a_byte_too_many(b'E', false)).unwrap();
    let recording = Recording::parse(&sound).unwrap();
    assert_eq!((recording.ticks(), recording.end.is_some()), (1500, false));
}

#[test]
fn a_recording_carries_its_table_to_the_last_bit_and_plays_without_any_file() {
    let table = Arc::new(tables::load("spectrum").unwrap());
    let mut simulation = Simulation::new(table.clone(), 5).unwrap();
    let mut recorder = Recorder::new(Cursor::new(Vec::new()), &simulation, 5).unwrap();
    for tick in 0..4000 {
        let buttons = if tick / 700 % 2 == 0 { Buttons::PLUNGER } else { pressed(tick, 90) };
        simulation.tick(buttons);
        recorder.record(&simulation, buttons).unwrap();
    }
    let bytes = recorder.finish(&simulation).unwrap().into_inner();
    let recording = Recording::parse(&bytes).unwrap();
    let carried = recording.embedded_table().unwrap().unwrap();
    assert_eq!((carried.hash, &carried.title, &carried.name), (table.hash, &table.title, &table.name));
    assert_eq!((&carried.layout, &carried.rules), (&table.layout, &table.rules));
    assert_eq!((&carried.lamps, &carried.solids), (&table.lamps, &table.solids));
    assert_eq!((carried.size_mm, carried.ambient), (table.size_mm, table.ambient));
    assert_eq!(carried.ambient_power, table.ambient_power);
    let mut replay = Replay::new(recording, Arc::new(carried)).unwrap();
    while replay.step() {}
    assert_eq!((replay.difference(), replay.simulation().hash()), (None, simulation.hash()));
    println!("the table takes {} bytes of a recording", game::recording::table_bytes(&table));
}

/// What a table looks like may be missing or of another table; its game is played all the same.
#[test]
fn a_look_that_does_not_fit_is_left_out() {
    let table = tables::load("spectrum").unwrap();
    let own = EmbeddedTable::of(&table);
    let far = own.look.as_ref().map(|look| look.replacen("\"center_mm\":[", "\"center_mm\":[1e9", 1));
    for look in [None, Some("{}".to_string()), far] {
        let carried = EmbeddedTable { look, ..own.clone() }.table("spectrum").unwrap();
        assert_eq!((carried.hash, carried.solids.len(), carried.lamps.len()), (table.hash, 0, table.lamps.len()));
        game::art::check(&carried).unwrap();
    }
    let broken = EmbeddedTable { game: "{}".into(), look: None }.table("mine").unwrap_err().to_string();
    assert!(
        broken.starts_with("the table mine that it carries is none that this program knows, from byte 2 of"),
        "{broken}"
    );
}

/// Where the numbers of a JSON text are.
fn numbers(json: &str) -> Vec<std::ops::Range<usize>> {
    let bytes = json.as_bytes();
    let in_number = |at: usize| at < bytes.len() && (bytes[at].is_ascii_digit() || b"+-.eE".contains(&bytes[at]));
    let starts = (1..bytes.len()).filter(|&at| b":[,".contains(&bytes[at - 1]) && in_number(at) && bytes[at] != b'e');
    starts.map(|start| start..(start..).find(|&at| !in_number(at)).unwrap_or(bytes.len())).collect()
}

/// A recording is a file like any other: whoever writes one by hand writes a table without any drawing.
#[test]
fn a_carried_table_with_any_number_changed_is_refused_or_played() {
    let own = EmbeddedTable::of(&tables::load("spectrum").unwrap());
    let places = numbers(&own.game);
    assert!(places.len() > 500, "{} numbers", places.len());
    let others = ["0", "-1", "1e-300", "1e300", "-1e6", "65536", "null", "0.5"];
    let (mut refused, mut played) = (0, 0);
    for case in 0..160 {
        let place = places[case * 7919 % places.len()].clone();
        let mut game = own.game.clone();
        game.replace_range(place.clone(), others[case % others.len()]);
        let table = EmbeddedTable { game, look: own.look.clone() }.table("spectrum").map(Arc::new);
        match table.and_then(|table| Simulation::new(table, 1)) {
            Err(_) => refused += 1,
            Ok(mut simulation) => {
                (0..400).for_each(|tick| simulation.tick(pressed(tick, 60)));
                played += 1;
            }
        }
    }
    println!("{refused} refused, {played} played");
    assert!(refused > 20 && played > 20, "{refused} refused, {played} played");
}
