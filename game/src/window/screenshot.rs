//! Saves the picture that is in the window.

use crate::Failure;
use crate::picture::save_png;
use std::path::PathBuf;
use std::sync::mpsc::Sender;
use std::time::SystemTime;
use tracer::Frame;

/// Saves `frame` on a thread of its own, sends a sentence that says where, and calls `wake`; `false` if the system
/// gives no thread.
pub fn save(frame: Frame, news: Sender<String>, wake: impl FnOnce() + Send + 'static) -> bool {
    let save = move || {
        let saved = path().and_then(|path| save_png(&frame, &path).map(|()| path));
        let text = saved.map_or_else(|failure| failure.to_string(), |path| format!("Saved as {}", path.display()));
        // When the window is closed meanwhile, nobody reads it.
        let _ = news.send(text);
        wake();
    };
    std::thread::Builder::new().name("screenshot".to_string()).spawn(save).is_ok()
}

/// A new file in the folder of pictures, or beside the recordings where there is no such folder.
#[expect(clippy::disallowed_methods, reason = "a picture is named after the moment that it was taken")]
fn path() -> Result<PathBuf, Failure> {
    let pictures = directories::UserDirs::new().and_then(|dirs| dirs.picture_dir().map(PathBuf::from));
    let data = || directories::ProjectDirs::from("", "", "Caustic").map(|dirs| dirs.data_dir().join("pictures"));
    let folder = pictures.or_else(data).ok_or_else(|| Failure::new("this system names no folder for pictures"))?;
    let wrong = |error| Failure::new(format!("cannot make the folder {}: {error}", folder.display()));
    std::fs::create_dir_all(&folder).map_err(wrong)?;
    let since = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).unwrap_or_default();
    Ok(folder.join(format!("caustic-{}-{:03}.png", since.as_secs(), since.subsec_millis())))
}
