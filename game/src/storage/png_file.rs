//! Frames as PNG files.

use super::{file_failure, new_file};
use crate::Failure;
use std::io::{self, Write};
use std::path::Path;
use tracer::Frame;

/// Writes a frame as a PNG file. It appears whole or not at all.
///
/// # Errors
/// If the file cannot be written.
pub fn save_png(frame: &Frame, path: &Path) -> Result<(), Failure> {
    new_file::write(path, |file| encode(frame, file)).map_err(|error| file_failure("write the picture", path, &error))
}

/// Whether a picture could be put at `path`: to be asked before it is made.
///
/// # Errors
/// If it could not.
pub fn check_place(path: &Path) -> Result<(), Failure> {
    new_file::check(path).map_err(|error| file_failure("write the picture", path, &error))
}

fn encode(frame: &Frame, file: &mut impl Write) -> io::Result<()> {
    let mut encoder = png::Encoder::new(file, frame.width as u32, frame.height as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    // A fifteenth of the time that the smallest files take, for files that are a little larger.
    encoder.set_compression(png::Compression::Fast);
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    let mut writer = encoder.write_header().map_err(system)?;
    writer.write_image_data(&frame.to_rgb8()).map_err(system)?;
    writer.finish().map_err(system)
}

/// The system's error, where it is one.
fn system(error: png::EncodingError) -> io::Error {
    match error {
        png::EncodingError::IoError(error) => error,
        other => io::Error::other(other.to_string()),
    }
}
