//! Screenshots: the frame that is in the window, saved as a file.

use super::Waker;
use crate::Failure;
use crate::storage::{library, save_png};
use std::path::{Path, PathBuf};
use std::thread::{Builder, JoinHandle};
use std::time::SystemTime;
use tracer::Frame;

/// The frame that is being saved, on a thread of its own: the application never waits for a file, but for the one that
/// was not quite written when the window is closed.
#[derive(Default)]
pub struct Screenshot(Option<JoinHandle<String>>);

impl Screenshot {
    /// Begins to save `frame` and wakes the main thread when that is done; nothing while another is being saved.
    ///
    /// # Errors
    /// If the system gives no thread.
    pub fn save(&mut self, frame: &Frame, waker: Waker) -> Result<(), Failure> {
        if self.0.is_some() {
            return Ok(());
        }
        let frame = frame.clone();
        let work = move || {
            let saved = path().and_then(|path| save_png(&frame, &path).map(|()| path));
            waker.wake();
            saved.map_or_else(|failure| failure.to_string(), |path| format!("Saved as {}", path.display()))
        };
        let thread = Builder::new().name("screenshot".to_string()).spawn(work);
        self.0 = Some(thread.map_err(|_| Failure::new("The system gives no thread to save the picture with."))?);
        Ok(())
    }

    /// Where the frame was saved, or why it was not, once that is known.
    pub fn news(&mut self) -> Option<String> {
        self.0.take_if(|thread| thread.is_finished())?.join().ok()
    }
}

impl Drop for Screenshot {
    fn drop(&mut self) {
        if let Some(thread) = self.0.take() {
            // Whoever asked for it sees the file; there is no window any more to tell it in.
            let _ = thread.join();
        }
    }
}

/// A new file in the folder of frames, or beside the recordings where there is no such folder.
#[expect(clippy::disallowed_methods, reason = "a picture is named after the moment that it was taken")]
fn path() -> Result<PathBuf, Failure> {
    let pictures = directories::UserDirs::new().and_then(|dirs| dirs.picture_dir().map(PathBuf::from));
    let data = || directories::ProjectDirs::from("", "", "Caustic").map(|dirs| dirs.data_dir().join("pictures"));
    let folder = pictures.or_else(data).ok_or_else(|| Failure::new("this system names no folder for pictures"))?;
    let wrong = |error| Failure::new(format!("cannot make the folder {}: {error}", folder.display()));
    std::fs::create_dir_all(&folder).map_err(wrong)?;
    let since = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).unwrap_or_default();
    Ok(free_path(&folder, &library::moment(since.as_secs())))
}

/// The picture of a moment, with a number if that name is taken.
fn free_path(folder: &Path, moment: &str) -> PathBuf {
    let numbered = |number: u64| folder.join(format!("Caustic {moment} {number}.png"));
    let first = folder.join(format!("Caustic {moment}.png"));
    std::iter::once(first).chain((2..).map(numbered)).find(|path| !path.exists()).unwrap_or_else(|| numbered(u64::MAX))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_is_named_after_its_moment_and_takes_no_other_pictures_place() {
        let folder = std::env::temp_dir().join(format!("caustic-screenshots-{}", std::process::id()));
        std::fs::create_dir_all(&folder).expect("a folder");
        let names = ["Caustic 2026-11-29 22.46.05.png", "Caustic 2026-11-29 22.46.05 2.png"];
        for name in names {
            let path = free_path(&folder, "2026-11-29 22.46.05");
            assert_eq!(path, folder.join(name));
            std::fs::write(path, "a picture").expect("a file");
        }
        std::fs::remove_dir_all(folder).expect("removed");
    }
}
