//! A table's folder, read and watched.

use super::{FileWatch, limited_read, tables};
use crate::small_table::SVG;
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

/// An empty folder of a test's own, which goes with it.
pub(super) struct Scratch(PathBuf);

impl Scratch {
    pub fn new(name: &str) -> Scratch {
        let dir = std::env::temp_dir().join(format!("caustic-storage-{name}-{}", std::process::id()));
        let _ = std::fs::remove_dir_all(&dir);
        std::fs::create_dir_all(&dir).unwrap();
        Scratch(dir)
    }

    pub fn path(&self) -> &Path {
        &self.0
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Folder {
        let dir = std::env::temp_dir().join(format!("caustic-{name}-{}", std::process::id()));
        std::fs::create_dir_all(&dir).unwrap();
        let folder = Folder(dir);
        folder.write("table.svg", &SVG.replace("{}", ""), 0);
        folder.write("table.toml", "name = \"Small\"", 0);
        folder.write("rules.rhai", "", 0);
        folder
    }

    fn write(&self, file: &str, text: &str, saved_s: u64) {
        let path = self.0.join(file);
        std::fs::write(&path, text).unwrap();
        let saved = SystemTime::UNIX_EPOCH + Duration::from_secs(1_000_000_000 + saved_s);
        std::fs::File::options().write(true).open(path).unwrap().set_modified(saved).unwrap();
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

#[test]
fn a_folder_is_a_table_and_its_missing_files_are_named() {
    let folder = Folder::new("load");
    let table = tables::load(folder.0.to_str().unwrap()).unwrap();
    assert_eq!((table.title.as_str(), Some(table.name.as_str())), ("Small", folder.0.file_name().unwrap().to_str()));
    std::fs::remove_file(folder.0.join("rules.rhai")).unwrap();
    std::fs::write(folder.0.join("table.toml"), b"name = \"a\"\n\xff").unwrap();
    let mistakes: Vec<String> = tables::load_dir(&folder.0).unwrap_err().iter().map(ToString::to_string).collect();
    assert_eq!(mistakes.len(), 2, "{mistakes:?}");
    assert!(mistakes[0].ends_with("rules.rhai: there is no such file, and a table needs it"), "{mistakes:?}");
    assert!(mistakes[1].contains("table.toml:2: this is not UTF-8"), "{mistakes:?}");
    std::fs::write(folder.0.join("table.toml"), "#".repeat(2 << 20)).unwrap();
    let mistakes = tables::load_dir(&folder.0).unwrap_err();
    assert!(mistakes.iter().any(|mistake| mistake.to_string().contains("larger than 1024 kB")), "{mistakes:?}");
}

/// A recording that was a link to `/dev/zero` filled the memory, and the metadata of such a file say that it is empty.
#[test]
fn no_more_of_a_file_is_read_than_the_limit() {
    let folder = Folder::new("limit");
    let path = folder.0.join("rules.rhai");
    std::fs::write(&path, "1234").unwrap();
    assert_eq!(limited_read::read(&path, 4).unwrap(), b"1234");
    let told = limited_read::read(&path, 3).unwrap_err();
    assert_eq!(told.kind(), std::io::ErrorKind::FileTooLarge);
    // The kernel's own files are plain files whose metadata say 0 bytes, whatever is in them.
    #[cfg(target_os = "linux")]
    {
        let own = Path::new("/proc/self/maps");
        assert_eq!(std::fs::metadata(own).unwrap().len(), 0);
        let told = limited_read::read(own, 100).unwrap_err();
        assert_eq!(told.kind(), std::io::ErrorKind::FileTooLarge);
        assert!(limited_read::read(own, 1 << 30).unwrap().len() > 100);
    }
}

#[test]
fn a_watch_tells_what_was_saved_once_and_waits_until_it_is_whole() {
    let folder = Folder::new("watch");
    let mut watch = FileWatch::of_table(&folder.0);
    let mut at = |ms: u64| -> Vec<String> {
        let changed = watch.changed(Duration::from_millis(ms));
        changed.iter().filter_map(|file| Some(file.file_name()?.to_str()?.to_string())).collect()
    };
    assert!(at(1000).is_empty());
    folder.write("rules.rhai", "fn half", 1);
    assert!(at(1100).is_empty(), "it looks only now and then");
    assert!(at(1250).is_empty(), "it may still be being written");
    folder.write("rules.rhai", "fn half() {}", 1);
    folder.write("table.svg", "<svg/>", 1);
    assert!(at(1500).is_empty(), "it was written to since");
    assert_eq!(at(1800), ["table.svg", "rules.rhai"]);
    assert!(at(2100).is_empty(), "it tells once");
    folder.write("table.toml", "name = \"Large\"", 2);
    assert!(at(2400).is_empty());
    assert_eq!(at(2700), ["table.toml"]);
}

/// A drawing that is a loop of links was told as none: "has no table.svg".
#[cfg(unix)]
#[test]
fn a_drawing_that_is_a_loop_of_links_is_told_as_that() {
    let folder = Scratch::new("loop");
    let drawing = folder.path().join("table.svg");
    std::os::unix::fs::symlink(&drawing, &drawing).unwrap();
    let failures = tables::load(&folder.path().display().to_string()).unwrap_err();
    let told = failures.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n");
    let expected = "table.svg: it cannot be read: it is a link that leads to itself; make it lead to a file";
    assert!(told.contains(expected), "{told}");
}
