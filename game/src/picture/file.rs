//! A picture as a PNG file.

use crate::Failure;
use std::fs::File;
use std::io::{BufWriter, Write};
use std::path::Path;
use tracer::Frame;

/// Writes a picture as a PNG file.
///
/// # Errors
/// If the file cannot be written.
pub fn save_png(frame: &Frame, path: &Path) -> Result<(), Failure> {
    let wrong = |error: String| Failure::new(format!("cannot write {}: {error}", path.display()));
    let file = File::create(path).map_err(|error| wrong(error.to_string()))?;
    let mut file = BufWriter::new(file);
    let mut encoder = png::Encoder::new(&mut file, frame.width as u32, frame.height as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    let mut writer = encoder.write_header().map_err(|error| wrong(error.to_string()))?;
    writer.write_image_data(&frame.to_rgb8()).map_err(|error| wrong(error.to_string()))?;
    writer.finish().map_err(|error| wrong(error.to_string()))?;
    file.flush().map_err(|error| wrong(error.to_string()))
}
