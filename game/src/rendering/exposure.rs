//! Exposure: how bright a picture is shown, from its own light.

use tracer::transport::luminance;

/// Of the pixels that have light, so many are darker than the key.
const KEY_RANK: f64 = 0.6;
/// What the key becomes before the tone curve.
const KEY: f64 = 0.16;
/// Less than this part of the brightest pixel is no light: noise and rounding.
const DARK: f64 = 1e-5;

/// The factor that makes a picture's bright parts bright, and does not ask its few brightest pixels, the caustics: those
/// may be hundreds of times brighter.
pub fn automatic(fluence: &[[f64; 3]]) -> f64 {
    let mut lights: Vec<f64> =
        fluence.iter().map(|color| luminance(*color)).filter(|light| light.is_finite()).collect();
    let brightest = lights.iter().copied().fold(0.0, f64::max);
    lights.retain(|light| *light > brightest * DARK);
    if lights.is_empty() {
        return 1.0;
    }
    let rank = ((lights.len() - 1) as f64 * KEY_RANK) as usize;
    let (_, key, _) = lights.select_nth_unstable_by(rank, f64::total_cmp);
    KEY / *key
}
