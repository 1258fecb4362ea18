//! Rendered pictures as files: PNG and TIFF for eyes, EXR for programs; each says how it was made.

use super::{file_failure, new_file};
use crate::Failure;
use std::io::{self, Cursor, Write};
use std::path::Path;
use tracer::{Frame, tone_map};

/// The formats, by the end of a file's name.
pub const ENDS: [&str; 4] = ["png", "tif", "tiff", "exr"];

/// What a picture's file says of it: keys and values.
pub type Metadata = [(&'static str, String)];

/// Linear light, row by row.
#[derive(Clone, Copy, Debug)]
pub struct LinearPicture<'a> {
    /// Pixels across.
    pub width: usize,
    /// Red, green and blue of each, in linear sRGB.
    pub pixels: &'a [[f32; 3]],
}

/// Writes a picture in the format that the file's name ends with. It appears whole or not at all.
///
/// # Errors
/// If the file cannot be written.
pub fn save(picture: LinearPicture, metadata: &Metadata, path: &Path) -> Result<(), Failure> {
    let end = path.extension().map(|end| end.to_ascii_lowercase());
    let bytes = match end.as_deref().and_then(|end| end.to_str()) {
        Some("exr") => exr(picture, metadata),
        Some("tif" | "tiff") => tiff(picture, metadata),
        _ => png(&tone_map::map_pixels(picture.pixels, picture.width, 1.0), metadata),
    };
    bytes
        .and_then(|bytes| new_file::write(path, |file| file.write_all(&bytes)))
        .map_err(|error| file_failure("write the picture", path, &error))
}

fn other(error: impl std::fmt::Display) -> io::Error {
    io::Error::other(error.to_string())
}

/// One text of all keys and values.
fn description(metadata: &Metadata) -> String {
    metadata.iter().map(|(key, value)| format!("{key}: {value}")).collect::<Vec<_>>().join("; ")
}

fn png(frame: &Frame, metadata: &Metadata) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, frame.width as u32, frame.height as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    for (key, value) in metadata {
        encoder.add_itxt_chunk((*key).to_string(), value.clone()).map_err(other)?;
    }
    let mut writer = encoder.write_header().map_err(other)?;
    writer.write_image_data(&frame.to_rgb8()).map_err(other)?;
    writer.finish().map_err(other)?;
    Ok(bytes)
}

/// Baseline TIFF of eight bits, as the PNG.
fn tiff(picture: LinearPicture, metadata: &Metadata) -> io::Result<Vec<u8>> {
    use ::tiff::encoder::{TiffEncoder, colortype::RGB8};
    use ::tiff::tags::Tag;
    let frame = tone_map::map_pixels(picture.pixels, picture.width, 1.0);
    let mut bytes = Cursor::new(Vec::new());
    let mut encoder = TiffEncoder::new(&mut bytes).map_err(other)?;
    let mut image = encoder.new_image::<RGB8>(frame.width as u32, frame.height as u32).map_err(other)?;
    let text = description(metadata);
    image.encoder().write_tag(Tag::ImageDescription, text.as_str()).map_err(other)?;
    image.encoder().write_tag(Tag::Software, "Caustic").map_err(other)?;
    image.write_data(&frame.to_rgb8()).map_err(other)?;
    Ok(bytes.into_inner())
}

/// OpenEXR: 32 bit floats, linear, exposed and not tone-mapped.
fn exr(picture: LinearPicture, metadata: &Metadata) -> io::Result<Vec<u8>> {
    use ::exr::prelude::*;
    let LinearPicture { width, pixels } = picture;
    let height = pixels.len() / width.max(1);
    let channels = SpecificChannels::rgb(|Vec2(x, y)| {
        let [red, green, blue] = pixels[y * width + x];
        (red, green, blue)
    });
    let mut attributes = LayerAttributes::named("caustic");
    attributes.software_name = Some(Text::from("Caustic"));
    // One text, since attributes of names of our own would be written in the order of a hash, another in each run.
    attributes.comments = Text::new_or_none(description(metadata));
    // Uncompressed and in one order: the same bytes on any number of threads.
    let encoding = Encoding {
        compression: Compression::Uncompressed,
        blocks: Blocks::ScanLines,
        line_order: LineOrder::Increasing,
    };
    let layer = Layer::new((width, height), attributes, encoding, channels);
    let mut bytes = Cursor::new(Vec::new());
    Image::from_layer(layer).write().non_parallel().to_buffered(&mut bytes).map_err(other)?;
    Ok(bytes.into_inner())
}
