//! From fluence, signed, to a picture: exposure, then the gamut, once.

use super::Picture;
use super::exposure;
use tracer::transport::into_gamut;
use tracer::{View, srgb};

/// The picture, `stops` brighter than the automatic exposure (each doubles the light), and the factor by which the light was multiplied.
pub fn develop(fluence: &[[f64; 3]], view: &View, stops: f64) -> (Picture, f64) {
    let factor = exposure::automatic(fluence) * libm::exp2(stops);
    (expose(fluence, view, factor), factor)
}

/// The picture, its light multiplied by `factor`.
pub fn expose(fluence: &[[f64; 3]], view: &View, factor: f64) -> Picture {
    let pixels =
        fluence.iter().map(|color| into_gamut(color.map(|channel| channel * factor)).map(|channel| channel as f32));
    Picture { width: view.width, height: view.height, pixels: pixels.collect() }
}

/// Adds what is drawn, in an even light that is `ambient` of full light: pixels premultiplied, in sRGB.
pub fn add_art(picture: &mut Picture, art: &[[u8; 4]], ambient: f64) {
    for (light, [red, green, blue, _]) in picture.pixels.iter_mut().zip(art) {
        let drawn = srgb::decode_rgb8([*red, *green, *blue]);
        (0..3).for_each(|channel| light[channel] += drawn[channel] * ambient as f32);
    }
}
