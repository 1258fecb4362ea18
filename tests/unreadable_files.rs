//! What is no file, or has no end, in the place of a file: a sentence at once.
//!
//! A pipe that nobody writes to made `check` wait for ever, and a link to `/dev/zero` as a recording filled the memory.
#![cfg(unix)]

use std::fs;
use std::os::unix::fs::symlink;
use std::os::unix::net::UnixListener;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// The three files of a table.
const FILES: [&str; 3] = ["table.svg", "table.toml", "rules.rhai"];

/// What stands in a file's place, and what is said of it.
const PLACES: [(&str, &str); 6] = [
    ("zero", "it is a device and no file; name a file"),
    ("null", "it is a device and no file; name a file"),
    ("pipe", "it is a pipe and no file; name a file"),
    ("socket", "it is a socket and no file; name a file"),
    ("folder", "it is a folder; name a file"),
    ("sparse", "it is larger than "),
];

/// A folder of this test's own with one of each of [`PLACES`] in it.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Folder {
        let folder = Folder(std::env::temp_dir().join(format!("caustic-unread-{name}-{}", std::process::id())));
        fs::create_dir_all(folder.0.join("folder")).expect("a folder");
        symlink("/dev/zero", folder.0.join("zero")).expect("a link");
        symlink("/dev/null", folder.0.join("null")).expect("a link");
        let pipe = Command::new("mkfifo").arg(folder.0.join("pipe")).status().expect("mkfifo runs");
        assert!(pipe.success());
        // Its file stays when it is dropped.
        UnixListener::bind(folder.0.join("socket")).expect("a socket");
        let sparse = fs::File::create(folder.0.join("sparse")).expect("a file");
        sparse.set_len(100 << 30).expect("a sparse file");
        folder
    }

    /// A good table in which `place` stands for `file`.
    fn table(&self, file: &str, place: &str) -> PathBuf {
        let table = self.0.join(format!("{place}-{file}"));
        fs::create_dir_all(&table).expect("a folder");
        let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("../assets/tables/spectrum");
        for other in FILES.into_iter().filter(|other| *other != file) {
            fs::copy(source.join(other), table.join(other)).expect(other);
        }
        symlink(self.0.join(place), table.join(file)).expect("a link");
        table
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// Runs the program with 400 MB of addresses in all, of which most are its code and its stacks.
fn caustic(word: &str, path: &Path) -> Output {
    let script = "ulimit -v 400000; exec \"$0\" \"$@\"";
    let program = Command::new("sh").args(["-c", script, env!("CARGO_BIN_EXE_caustic"), word]).arg(path).output();
    program.expect("the program runs")
}

fn assert_refused(output: &Output, sentence: &str) {
    let complaint = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{complaint}");
    assert!(complaint.contains(sentence) && complaint.lines().count() == 1, "{sentence}: {complaint}");
}

#[test]
fn a_table_of_what_is_no_file_is_refused() {
    let folder = Folder::new("table");
    for (place, sentence) in PLACES {
        for file in FILES {
            let output = caustic("check", &folder.table(file, place));
            assert_refused(&output, &format!("{file}: it cannot be read: {sentence}"));
        }
    }
}

#[test]
fn a_recording_that_is_no_file_is_refused() {
    let folder = Folder::new("recording");
    for (place, sentence) in PLACES {
        let output = caustic("verify", &folder.0.join(place));
        assert_refused(&output, &format!("cannot read the recording {}: {sentence}", folder.0.join(place).display()));
    }
}

/// The kernel's log is a plain file by its own account, and whoever reads it waits for the next message.
#[cfg(target_os = "linux")]
#[test]
fn a_file_that_the_kernel_goes_on_writing_is_refused() {
    let log = Path::new("/proc/kmsg");
    if fs::OpenOptions::new().read(true).open(log).is_err() {
        return eprintln!("the kernel's log is not this user's to read");
    }
    assert_refused(
        &caustic("verify", log),
        "cannot read the recording /proc/kmsg: it has no end, but goes on as the system",
    );
}
