//! Values on the command line: each read in its range, or why not.

use crate::storage::picture_file::ENDS;
use std::ffi::OsString;
use std::fmt::Display;
use std::ops::RangeInclusive;
use std::path::{Path, PathBuf};
use std::str::FromStr;

/// A picture's file: PNG is the one format that is written.
pub(super) fn png_file(name: OsString) -> Result<PathBuf, String> {
    let path = PathBuf::from(name);
    match path.extension() {
        None if path.as_os_str().is_empty() || path.as_os_str() == "-" => {
            Err("a picture is written to a file: name a .png file".to_string())
        }
        Some(end) if end.eq_ignore_ascii_case("png") => Ok(path),
        // A device or a pipe is called what it is called; of a folder more is said where it would be written.
        None if path.metadata().is_ok_and(|found| !found.is_file()) => Ok(path),
        _ => Err("pictures are written as PNG: name a .png file".to_string()),
    }
}

/// A folder for the frames of a film, or - for a stream: not the name of one picture or one film.
pub(super) fn film_place(name: OsString) -> Result<PathBuf, String> {
    if name.is_empty() {
        return Err("frames are written into a folder: name one".to_string());
    }
    let path = PathBuf::from(name);
    let end = path.extension().and_then(|end| end.to_str()).unwrap_or_default().to_ascii_lowercase();
    match end.as_str() {
        _ if path.is_dir() => Ok(path),
        "png" => Err("frames are written into a folder: name one (caustic frame writes one picture)".to_string()),
        "y4m" => Err("frames are written into a folder: name one, or write --out - > FILE.y4m".to_string()),
        "gif" | "jpeg" | "jpg" | "mkv" | "mov" | "mp4" | "webm" | "webp" => {
            Err(format!("no .{end} is written: name a folder for PNG files, or send --out - (y4m) on to a program"))
        }
        _ => Ok(path),
    }
}

/// A rendered picture's file: its format is the end of its name.
pub(super) fn picture_file(path: &Path) -> Result<(), String> {
    let end = path.extension().map(|end| end.to_ascii_lowercase());
    match end.as_deref().and_then(|end| end.to_str()) {
        Some(end) if ENDS.contains(&end) => Ok(()),
        _ => Err(format!(
            "--out {} ends with none of .png, .tif, .tiff and .exr, so nobody knows its format; and no such folder is there",
            path.display()
        )),
    }
}

/// A folder: no stream, and not the one that nobody has named.
pub(super) fn folder(name: OsString) -> Result<PathBuf, String> {
    if name == "-" || name.is_empty() {
        Err("files are written into a folder: name one".to_string())
    } else {
        Ok(PathBuf::from(name))
    }
}

/// Seconds, over 0.
pub(super) fn positive_seconds(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(value) if value > 0.0 && value <= 1e6 => Ok(value),
        _ => Err("it must be a number above 0, to 1000000".to_string()),
    }
}

/// Reads a whole number in this range.
pub(super) fn whole<T>(range: RangeInclusive<T>) -> impl Fn(&str) -> Result<T, String> + Clone
where
    T: FromStr + PartialOrd + Display + Clone,
{
    move |text| match text.parse::<T>() {
        Ok(number) if range.contains(&number) => Ok(number),
        _ => Err(format!("it must be a whole number from {} to {}", range.start(), range.end())),
    }
}

/// Threads: 1 to 256.
pub(super) fn threads(text: &str) -> Result<usize, String> {
    whole(1..=256)(text)
}

/// How much larger than the picture: 1 to 4.
pub(super) fn zoom(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(value) if (1.0..=4.0).contains(&value) => Ok(value),
        _ => Err("it must be a number from 1 to 4".to_string()),
    }
}

/// Minutes, over 0.
pub(super) fn minutes(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(value) if value > 0.0 && value <= 1e4 => Ok(value),
        _ => Err("it must be a number above 0, to 10000".to_string()),
    }
}

/// Seconds, 0 or more.
pub(super) fn seconds(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(value) if (0.0..=1e6).contains(&value) => Ok(value),
        _ => Err("it must be a number from 0 to 1000000".to_string()),
    }
}
