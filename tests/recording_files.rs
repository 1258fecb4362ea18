//! Recordings as files on a player's disk: they play wherever they lie, and nothing is written over or lost by them.

#![expect(clippy::disallowed_methods, reason = "the test reads what it has written")]

use super::command_line::{Folder, caustic, complaint, program, sentence};
use std::fs;
use std::path::{Path, PathBuf};

const FILES: [&str; 3] = ["table.svg", "table.toml", "rules.rhai"];

fn spectrum() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../assets/tables/spectrum")
}

/// A copy of Spectrum in `dir`, a degree flatter, so that it is another table.
fn own_table(dir: &Path) {
    fs::create_dir_all(dir).expect("a folder");
    for file in FILES {
        fs::copy(spectrum().join(file), dir.join(file)).expect(file);
    }
    let toml = fs::read_to_string(dir.join("table.toml")).expect("numbers");
    fs::write(dir.join("table.toml"), toml.replace("slope_deg = 6.5", "slope_deg = 5.5")).expect("numbers");
}

/// Plays a short game on `table` from within `folder`, and returns its recording.
fn play(folder: &Folder, table: &str, results: &str) -> String {
    let words = ["simulate", "--games", "1", "--minutes", "0.02", "--table", table, "--save-all", results];
    let played = program(&words).current_dir(&folder.0).output().expect("the program runs");
    assert_eq!(played.status.code(), Some(0), "{}", complaint(&played));
    folder.path(&format!("{results}/game-1.caustic"))
}

fn verified(recording: &str) -> String {
    let output = program(&["verify", recording]).current_dir("/").output().expect("the program runs");
    assert_eq!(output.status.code(), Some(0), "{}", complaint(&output));
    String::from_utf8_lossy(&output.stdout).into_owned()
}

/// What is complained of when a frame of the recording is drawn, and the frame.
fn frame(folder: &Folder, recording: &str) -> (String, Vec<u8>) {
    let out = folder.path("frame.png");
    let words = ["frame", "--replay", recording, "--at", "1", "--size", "320x640", "--out", &out];
    let drawn = program(&words).current_dir("/").output().expect("the program runs");
    assert_eq!(drawn.status.code(), Some(0), "{}", complaint(&drawn));
    (complaint(&drawn), fs::read(out).expect("a picture"))
}

/// A recording of a table given by a relative path played from one folder only, and a table that was changed, moved or
/// removed took all of its recordings with it.
#[test]
fn a_recording_plays_from_any_folder_without_its_table_and_says_when_the_art_is_not_there() {
    let folder = Folder::new("anywhere");
    own_table(&folder.0.join("mine"));
    let recording = play(&folder, "mine", "r");
    let line = verified(&recording);
    let (said, whole) = frame(&folder, &recording);
    assert_eq!(said, "", "the table is where it was");
    fs::rename(folder.path("mine"), folder.path("r/mine")).expect("it is moved");
    assert_eq!(frame(&folder, &recording), (String::new(), whole.clone()), "it is beside the recording");
    let toml = fs::read_to_string(spectrum().join("table.toml")).expect("numbers");
    fs::write(folder.path("r/mine/table.toml"), toml).expect("numbers");
    assert_eq!(verified(&recording), line, "a changed table is not the one that was played on");
    let (said, without) = frame(&folder, &recording);
    assert!(said.contains("game-1.caustic: it was played on another table: mine has changed since"), "{said}");
    assert!(said.contains("its game is shown without its art") && without != whole, "{said}");
    fs::remove_dir_all(folder.path("r/mine")).expect("it goes");
    assert_eq!(verified(&recording), line);
    let (said, without_table) = frame(&folder, &recording);
    assert!(said.contains("its table mine is not among the built-in ones, not beside the recording"), "{said}");
    assert_eq!(without_table, without, "and the picture is the same as before");
    let out = folder.path("frames");
    let dumped = caustic(&["dump", &recording, "--fps", "1", "--size", "320x640", "--out", &out]);
    assert_eq!(dumped.status.code(), Some(0));
    assert!(complaint(&dumped).contains("shown without its art"), "{}", complaint(&dumped));
    assert_eq!(fs::read(folder.path("frames/000001.png")).expect("a frame"), without);
}

/// A folder that happened to be called like a built-in table hid it, or was taken for it.
#[test]
fn a_folder_called_like_a_built_in_table_is_another_table() {
    let folder = Folder::new("namesake");
    own_table(&folder.0.join("spectrum"));
    let recording = play(&folder, "spectrum", "own");
    verified(&recording);
    assert_eq!(frame(&folder, &recording).0, "", "its own table is found, where it was");
    let demo = fs::canonicalize(spectrum().join("../../demos/bot-4.caustic")).expect("a demo");
    let words = ["frame", "--replay", &demo.to_string_lossy(), "--at", "1", "--size", "64x64", "--out", "demo.png"];
    let drawn = program(&words).current_dir(&folder.0).output().expect("the program runs");
    assert_eq!((drawn.status.code(), complaint(&drawn).as_str()), (Some(0), ""), "the demo's is the built-in one");
}

/// Recordings of format 1 name their table only; what can be said when it is gone is said.
#[test]
fn a_recording_that_carries_no_table_finds_it_beside_itself_or_says_what_became_of_it() {
    let folder = Folder::new("old");
    own_table(&folder.0.join("mine"));
    let table = game::storage::tables::load_dir(&folder.0.join("mine")).expect("a table");
    let header = game::recording::Header { folder: String::new(), ..game::recording::Header::new(&table, 1) };
    let recording = folder.path("old.caustic");
    fs::write(&recording, super::recording::format_1(&header)).expect("a file");
    assert!(verified(&recording).starts_with("unfinished "));
    fs::copy(spectrum().join("table.toml"), folder.path("mine/table.toml")).expect("numbers");
    let said = sentence(&["verify", &recording]);
    assert!(said.contains("old.caustic: it was played on another table: mine has changed since"), "{said}");
    fs::remove_file(folder.path("mine/rules.rhai")).expect("the rules go");
    let said = sentence(&["verify", &recording]);
    assert!(said.contains("old.caustic: the table ") && said.contains("cannot be read"), "{said}");
    fs::remove_dir_all(folder.path("mine")).expect("it goes");
    let said = sentence(&["verify", &recording]);
    assert!(said.contains("old.caustic: its table mine is not among the built-in ones"), "{said}");
}

/// A recording that nobody could have played ended with a made-up score, and was called good.
#[test]
fn an_end_that_was_not_played_is_told() {
    let noplay = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/recordings/made-up-end.caustic");
    let said = sentence(&["verify", &noplay.to_string_lossy()]);
    assert!(said.contains("made-up-end.caustic: differs first at tick 0 (0.0 s) in "), "{said}");
}

/// It was recorded on a table that is nowhere any more: what it carries must do, in every later version.
#[test]
fn a_recording_of_a_lost_table_plays_for_ever() {
    let lost = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/recordings/lost-table.caustic");
    let words = ["verify", "--digest", "--restore-every", "1000", &lost.to_string_lossy()];
    let output = caustic(&words);
    assert_eq!(output.status.code(), Some(0), "{}", complaint(&output));
    let said = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(said.contains("ticks=30000 score=147940 "), "{said}");
    assert!(said.contains("digest     bba2c4a9081d2811 of 30000 ticks"), "{said}");
}

#[test]
fn a_damaged_recording_is_cut_to_its_sound_part_under_a_new_name() {
    let folder = Folder::new("salvage");
    let recording = folder.recording();
    let (bad, out) = (folder.path("bad.caustic"), folder.path("out.caustic"));
    let said = sentence(&["verify", &recording, "--salvage", &out]);
    assert!(said.contains("game-1.caustic: it is not damaged"), "{said}");
    let mut bytes = fs::read(&recording).expect("a recording");
    let length = bytes.len();
    bytes[length - 70] ^= 1;
    fs::write(&bad, &bytes).expect("a file");
    let said = sentence(&["verify", &bad]);
    assert!(said.ends_with("are whole; `caustic verify --salvage OUT` keeps what is sound\n"), "{said}");
    let salvaged = caustic(&["verify", &bad, "--salvage", &out]);
    let said = complaint(&salvaged);
    assert_eq!(salvaged.status.code(), Some(0), "{said}");
    assert!(said.contains("bad.caustic: it is damaged: bytes") && said.contains("the sound part is in"), "{said}");
    let line = String::from_utf8_lossy(&salvaged.stdout).into_owned();
    assert!(line.starts_with("unfinished ") && line.contains("out.caustic ticks=1000 "), "{line}");
    assert_eq!(verified(&out), line);
    let said = sentence(&["verify", &bad, "--salvage", &out]);
    assert!(said.contains("out.caustic: there is already one of that name"), "{said}");
    fs::write(&bad, &bytes[..100]).expect("a file");
    let said = sentence(&["verify", &bad, "--salvage", &folder.path("none")]);
    assert!(said.contains("cut short") && said.contains("no part of the game is sound"), "{said}");
    // Nothing is advised that would not help.
    let advice = sentence(&["verify", &bad]);
    assert!(advice.contains("cut short") && !format!("{said}{advice}").contains("--salvage"), "{said}{advice}");
    assert_eq!(folder.names(), ["bad.caustic", "game-1.caustic", "out.caustic"]);
    let two = caustic(&["verify", &bad, &out, "--salvage", "x"]);
    assert_eq!(two.status.code(), Some(2));
    assert!(complaint(&two).contains("name just one"), "{}", complaint(&two));
}

/// Frames of a short film lay among those of a longer one, and recordings were replaced without a word.
#[test]
fn what_is_there_is_not_written_over_without_being_asked() {
    let folder = Folder::new("overwrite");
    let recording = folder.recording();
    let all = folder.path("");
    let simulate = ["simulate", "--games", "2", "--minutes", "0.02", "--save-all", &all];
    let before = fs::read(&recording).expect("a recording");
    let said = sentence(&simulate);
    assert!(said.contains("game-1.caustic is there already") && said.contains("--overwrite"), "{said}");
    assert_eq!((fs::read(&recording).expect("it"), folder.names()), (before, vec!["game-1.caustic".to_string()]));
    assert_eq!(caustic(&[&simulate[..], &["--overwrite"]].concat()).status.code(), Some(0));
    let frames = folder.path("frames");
    let dump = |more: &[&str]| {
        let words = ["dump", &recording, "--size", "64x64", "--fps", "5", "--out", &frames];
        caustic(&[&words[..], more].concat())
    };
    let first = dump(&[]);
    assert_eq!((first.status.code(), complaint(&first)), (Some(0), String::new()));
    let again = dump(&["--to", "0.4"]);
    assert_eq!(again.status.code(), Some(1));
    assert!(complaint(&again).contains("there are frames in") && complaint(&again).contains("7 of them"));
    let over = dump(&["--to", "0.4", "--overwrite"]);
    assert_eq!(over.status.code(), Some(0));
    assert!(complaint(&over).contains("4 older frames are still in"), "{}", complaint(&over));
    fs::write(folder.path("holiday.png"), "mine").expect("a file");
    let words = ["dump", &recording, "--size", "64x64", "--fps", "1", "--out", &all];
    assert_eq!(caustic(&words).status.code(), Some(0), "other pictures are no frames");
}
