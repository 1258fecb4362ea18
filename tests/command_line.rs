//! The command line as a newcomer meets it: every mistake is one sentence, and nothing is lost by it.

#![expect(clippy::disallowed_methods, reason = "the test reads what it has written")]

use game::recording::{Header, Writer};
use game::simulation::Hashes;
use game::table::EmbeddedTable;
use std::fs;
use std::io::Cursor;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

/// A folder of this test's own.
pub struct Folder(pub PathBuf);

impl Folder {
    pub fn new(name: &str) -> Folder {
        let path = std::env::temp_dir().join(format!("caustic-line-{name}-{}", std::process::id()));
        fs::create_dir_all(&path).expect("a folder");
        Folder(path)
    }

    pub fn path(&self, name: &str) -> String {
        self.0.join(name).to_string_lossy().into_owned()
    }

    /// The names in it.
    pub fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(&self.0).expect("a folder").map(|entry| entry.expect("an entry").file_name());
        let mut names: Vec<String> = entries.map(|name| name.to_string_lossy().into_owned()).collect();
        names.sort();
        names
    }

    /// A short recording.
    pub fn recording(&self) -> String {
        let done = caustic(&["simulate", "--games", "1", "--minutes", "0.02", "--save-all", &self.path("")]);
        assert_eq!(done.status.code(), Some(0), "{}", complaint(&done));
        self.path("game-1.caustic")
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

pub fn program(words: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_caustic"));
    command.args(words).env_remove("DISPLAY").env_remove("WAYLAND_DISPLAY").env_remove("WAYLAND_SOCKET");
    command
}

pub fn caustic(words: &[&str]) -> Output {
    program(words).output().expect("the program runs")
}

pub fn complaint(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// The one sentence of a failure.
pub fn sentence(words: &[&str]) -> String {
    let output = caustic(words);
    let said = complaint(&output);
    assert_eq!(output.status.code(), Some(1), "{words:?}: {said}");
    assert_eq!(said.lines().count(), 1, "{words:?}: {said}");
    assert!(said.starts_with("caustic: ") && !said.contains("os error"), "{words:?}: {said}");
    said
}

#[test]
fn a_wrong_command_line_ends_with_2_and_says_what_is_wrong() {
    for (words, told) in [
        (&["frame", "--out", "x.png", "--size", "63x10"][..], "each side must be from 64 to 16384 pixels"),
        (&["frame", "--out", "x.png", "--size", "16384x16384"], "more than 33 million pixels"),
        (&["frame", "--out", "-"], "name a .png file"),
        (&["frame", "--out", "x.png", "--at", "-1"], "a number from 0 to 1000000"),
        (&["frame", "--out", "x.png", "--table", ""], "a value is required for '--table"),
        (&["dump", "a", "--out", "b", "--from", "3", "--to", "1"], "--from 3 is after --to 1"),
        (
            &["dump", "a", "--out", "b", "--fps", "0"],
            "it must be a whole number from 1 to 1000; caustic dump --help says more",
        ),
        (&["frame", "--out", "x.png", "--zoom", "0.5"], "a number from 1 to 4"),
        (&["play", "--zoom", "NaN"], "a number from 1 to 4"),
        (&["play", "--zoom", "-inf"], "invalid value '-inf' for '--zoom <FACTOR>': it must be a number from 1 to 4"),
        (&["check"], "it needs more words: <NAME|DIR>; caustic check --help says more"),
        (
            &["dump", "a", "--out", "b", "--size", "4000x8000", "--zoom", "4"],
            "--zoom 4 of 4000x8000 pixels is more than",
        ),
        (&["replay", "a", "--light", "bright"], "possible values: half, full, auto"),
        (&["verify", "a", "--threads", "257"], "a whole number from 1 to 256"),
        (&["simulate", "--minutes", "0"], "a number above 0"),
        (&["simulate", "--seed", "-1"], "invalid value '-1' for '--seed"),
        (&["pla"], "there is no command 'pla'"),
        (&["frame", "--out", "x.png", "--size", "-5x10"], "write it as WIDTHxHEIGHT, for example 540x1080"),
        (&["frame", "--out", "x.png", "--samples", "9"], "--samples is for --integrator monte-carlo"),
        (&["frame", "--at", "1e5", "--out", "x.png"], "a table that nobody plays is shown up to 3600 s"),
        (&["frame", "--out", ""], "a picture is written to a file: name a .png file"),
        // An empty folder was the one that the program was started in.
        (&["simulate", "--save-all", ""], "files are written into a folder: name one"),
        (&["simulate", "--save-failures", ""], "files are written into a folder: name one"),
        (&["plot", "--out", ""], "files are written into a folder: name one"),
        (&["dump", "a", "--out", ""], "frames are written into a folder: name one"),
        (&["render", "a.svg", "--out", ""], "a value is required for '--out"),
        (&["render", "a.svg", "b.svg", "--out", "r.png"], "is the name of one picture"),
        (&["render", ""], "a value is required for"),
        (&["optics", ""], "a value is required for"),
        (&["verify", "a", "--salvage", ""], "a value is required for '--salvage"),
        (&["play", "--record", ""], "a value is required for '--record"),
        (&["frame", "--out", "x.jpg"], "pictures are written as PNG: name a .png file"),
        (&["frame"], "it needs more words: --out <FILE.png>"),
        (&["verify", "a", "--salvage", "-"], "--salvage writes a recording, and none to standard output"),
        (&["bench", "nothing"], "invalid value 'nothing'"),
        (&["--fullscren"], "nothing is known of the argument '--fullscren'"),
    ] {
        let output = caustic(words);
        let said = complaint(&output);
        assert_eq!(output.status.code(), Some(2), "{words:?}: {said}");
        assert!(said.contains(told), "{words:?}: {said}");
        assert!(said.starts_with("caustic: ") && said.lines().count() == 1, "{words:?}: {said}");
    }
}

/// A folder that is missing is made by every command that writes a file, not by some only.
#[test]
fn folders_on_the_way_to_a_picture_are_made() {
    let folder = Folder::new("on-the-way");
    let out = folder.path("a/b/x.png");
    let done = caustic(&["frame", "--size", "64x64", "--out", &out]);
    assert_eq!(done.status.code(), Some(0), "{}", complaint(&done));
    assert!(Path::new(&out).is_file());
}

/// Two pixels of a film share a colour, so its sides are even: a size that is not is rounded, and the user is told.
#[test]
fn a_film_of_odd_sides_says_that_it_is_rounded() {
    let folder = Folder::new("odd");
    let film = caustic(&["dump", &folder.recording(), "--out", "-", "--size", "65x66", "--to", "0"]);
    assert_eq!(film.status.code(), Some(0));
    assert!(film.stdout.starts_with(b"YUV4MPEG2 W64 H66 "));
    assert_eq!(complaint(&film), "caustic: the sides of a y4m film are even: 65x66 becomes 64x66\n");
}

#[test]
fn files_that_are_not_there_or_not_files_are_named() {
    let folder = Folder::new("files");
    let (missing, here) = (folder.path("missing/x"), folder.path(""));
    for (words, told) in [
        (&["verify", &folder.path("no")][..], "there is no such file"),
        (&["replay", &here], "it is a folder; name a file"),
        (&["verify", &missing], "there is no such file"),
        (&["frame", "--size", "64x64", "--out", &here], "it is a folder; name a file"),
        (&["check", &here], "has no table.svg, so it is no table"),
    ] {
        let said = sentence(words);
        assert!(said.contains(told) && said.contains(&here), "{words:?}: {said}");
    }
    assert_eq!(folder.names(), [""; 0]);
}

#[test]
fn a_folder_for_results_is_made_before_any_game_is_played() {
    let folder = Folder::new("results");
    fs::write(folder.path("file"), "kept").expect("a file");
    let said = sentence(&["simulate", "--games", "1000000", "--save-all", &folder.path("file")]);
    assert!(said.contains("is a file; name a folder"), "{said}");
    assert_eq!(fs::read_to_string(folder.path("file")).expect("the file"), "kept");
}

#[test]
fn a_recording_is_told_by_its_name_whatever_is_wrong_with_it() {
    let folder = Folder::new("damage");
    let whole = fs::read(folder.recording()).expect("a recording");
    let cut = |length: usize| whole[..length].to_vec();
    let mut changed = whole.clone();
    changed[60] ^= 1;
    let file = folder.path("bad.caustic");
    let cases =
        [(cut(0), "not a Caustic recording"), (cut(whole.len() - 1), "cut short"), (changed, "it is damaged: bytes")];
    for (bytes, told) in cases {
        fs::write(&file, bytes).expect("a file");
        let out = folder.path("out");
        let uses = [
            &["verify", &file][..],
            &["replay", &file],
            &["dump", &file, "--out", &out],
            &["frame", "--replay", &file, "--out", &format!("{out}.png")],
        ];
        for words in uses {
            let said = sentence(words);
            assert!(said.contains(told) && said.contains("bad.caustic: "), "{words:?}: {said}");
        }
    }
    assert_eq!(folder.names(), ["bad.caustic", "game-1.caustic"]);
}

#[test]
fn recordings_of_other_versions_are_told_with_the_version() {
    let folder = Folder::new("versions");
    let file = folder.path("old.caustic");
    let header =
        Header { simulation_version: 999, table: "spectrum".into(), folder: String::new(), table_hash: 0, seed: 1 };
    let table = EmbeddedTable { game: "{}".to_string(), look: None };
    let recording = Writer::new(Cursor::new(Vec::new()), &header, &table).expect("memory");
    let none = Hashes { balls: 0, mechanisms: 0, rules: 0, lamps: 0 };
    let mut bytes = recording.finish(0, none, 0).expect("memory").into_inner();
    fs::write(&file, &bytes).expect("a file");
    let said = sentence(&["verify", &file]);
    assert!(said.contains("old.caustic: it was recorded with simulation version 999"), "{said}");
    bytes[8] = 200;
    fs::write(&file, &bytes).expect("a file");
    let said = sentence(&["replay", &file]);
    assert!(said.contains("old.caustic: it is written in format version 200"), "{said}");
}

#[test]
fn moments_after_the_end_are_refused_with_the_length() {
    let folder = Folder::new("moments");
    let (recording, out) = (folder.recording(), folder.path("out"));
    let said = sentence(&["frame", "--replay", &recording, "--at", "1.3", "--out", &format!("{out}.png")]);
    assert!(said.contains("game-1.caustic is 1.200 s long; give --at less"), "{said}");
    let said = sentence(&["dump", &recording, "--from", "9", "--out", &out]);
    assert!(said.contains("game-1.caustic is 1.200 s long; give --from less"), "{said}");
    assert_eq!(folder.names(), ["game-1.caustic"]);
}

#[test]
fn without_a_display_the_commands_that_need_none_are_named_and_no_recording_is_touched() {
    let folder = Folder::new("display");
    let kept = folder.path("kept.caustic");
    fs::write(&kept, "an old game").expect("a file");
    for words in [&["play", "--record", &kept][..], &["--record", &kept], &["--record", &folder.path("new.caustic")]] {
        let said = sentence(words);
        let told = ["no display", "caustic frame", "caustic dump", "caustic simulate"];
        assert!(told.iter().all(|word| said.contains(word)), "{said}");
    }
    assert_eq!(fs::read_to_string(&kept).expect("the file"), "an old game");
    assert_eq!(folder.names(), ["kept.caustic"]);
}

#[test]
fn a_picture_replaces_another_and_leaves_nothing_beside_it() {
    let folder = Folder::new("picture");
    let out = folder.path("x.png");
    fs::write(&out, "old").expect("a file");
    assert_eq!(caustic(&["frame", "--at", "0", "--size", "64x64", "--out", &out]).status.code(), Some(0));
    assert_eq!(fs::read(&out).expect("a picture")[..4], *b"\x89PNG");
    assert_eq!(folder.names(), ["x.png"]);
}

#[test]
fn nobody_reading_on_is_no_failure() {
    let folder = Folder::new("pipe");
    let recording = folder.recording();
    for words in [
        &["check", "spectrum"][..],
        &["--help"],
        &["verify", &recording],
        &["dump", &recording, "--size", "64x64", "--out", "-"],
    ] {
        let mut child = program(words).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the program runs");
        drop(child.stdout.take());
        let output = child.wait_with_output().expect("it ends");
        assert_eq!((output.status.code(), complaint(&output).as_str()), (Some(0), ""), "{words:?}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_a_sentence_even_for_standard_output() {
    let full = || fs::File::options().write(true).open("/dev/full").expect("a full disk");
    let output = program(&["check", "spectrum"]).stdout(full()).output().expect("the program runs");
    assert_eq!(output.status.code(), Some(1));
    let said = complaint(&output);
    assert_eq!(said, "caustic: cannot write to standard output: the disk is full; make room or choose another place\n");
    for words in [&["--help"][..], &["--version"], &["check", "--help"]] {
        let output = program(words).stdout(full()).output().expect("the program runs");
        let end = (output.status.code(), complaint(&output));
        assert_eq!(end, (Some(1), said.clone()), "{words:?}: it ended as if somebody had read it");
    }
    let said = sentence(&["frame", "--at", "0", "--size", "64x64", "--out", "/dev/full"]);
    assert!(said.contains("cannot write the picture /dev/full: the disk is full"), "{said}");
    let status = program(&["check", "no-such-table"]).stderr(full()).status().expect("the program runs");
    assert_eq!(status.code(), Some(1), "it ends as it should even if it cannot say why");
}

#[test]
fn every_tick_of_games_and_of_their_recordings_comes_to_the_same_line() {
    let folder = Folder::new("digest");
    let words =
        ["simulate", "--games", "2", "--minutes", "0.03", "--again", "--digest", "--save-all", &folder.path("")];
    let last_line = |words: &[&str]| {
        let done = caustic(words);
        assert_eq!(done.status.code(), Some(0), "{}", complaint(&done));
        String::from_utf8_lossy(&done.stdout).lines().last().unwrap_or_default().to_string()
    };
    let played = last_line(&words);
    assert!(played.starts_with("digest") && played.ends_with("of 3600 ticks, games 2"), "{played}");
    let [one, two] = ["game-1.caustic", "game-2.caustic"].map(|name| folder.path(name));
    assert_eq!(last_line(&["verify", &two, &one, "--digest", "--restore-every", "500"]), played);
    assert_ne!(last_line(&["verify", &one, "--digest"]), played);
}

/// A first word that is no text ended in a panic.
#[cfg(unix)]
#[test]
fn words_that_are_no_text_are_a_sentence() {
    use std::os::unix::ffi::OsStrExt;
    for words in [&[&b"\xff"[..]][..], &[b"\xff", b"--help"], &[b"frame", b"\xff"], &[b"--table", b"\xff"]] {
        let words = words.iter().map(|word| std::ffi::OsStr::from_bytes(word));
        let output = Command::new(env!("CARGO_BIN_EXE_caustic")).args(words).output().expect("it runs");
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{said}");
        assert!(said.starts_with("caustic: ") && said.lines().count() == 1 && !said.contains("panicked"), "{said}");
    }
}

/// A picture's file was asked to have a name that is text, which no file system asks for.
#[cfg(unix)]
#[test]
fn a_picture_may_have_a_name_that_is_no_text() {
    use std::os::unix::ffi::OsStrExt;
    let folder = Folder::new("name-that-is-no-text");
    let out = folder.0.join(std::ffi::OsStr::from_bytes(b"a\xffb.png"));
    let mut frame = Command::new(env!("CARGO_BIN_EXE_caustic"));
    let output = frame.args(["frame", "--size", "64x128", "--out"]).arg(&out).output().expect("it runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    assert!(out.is_file());
}
