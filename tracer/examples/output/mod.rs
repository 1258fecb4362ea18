//! Where an example writes its picture.

use std::error::Error;
use std::fs::File;
use std::io::BufWriter;
use std::path::PathBuf;
use tracer::Frame;

/// Writes a frame to the path that the command line names, or to `name` in the workspace's target folder.
pub fn save(frame: &Frame, name: &str) -> Result<(), Box<dyn Error>> {
    let default = || PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../target").join(name);
    let path = std::env::args_os().nth(1).map_or_else(default, PathBuf::from);
    let file = BufWriter::new(File::create(&path)?);
    let mut encoder = png::Encoder::new(file, frame.width as u32, frame.height as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.write_header()?.write_image_data(&frame.to_rgb8())?;
    println!("{}", path.display());
    Ok(())
}
