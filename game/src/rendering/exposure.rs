//! Exposure: how bright a picture is shown, from its own light.

use tracer::transport::luminance;

/// What the light becomes, before the tone curve, of which half of all light is darker.
const KEY: f64 = 0.35;

/// The factor by which a picture's light is multiplied: half of all its light falls into pixels that are darker than the key.
/// Black pixels do not count, however many there are, and the few that are hundreds of times brighter, caustics, count as
/// what they hold.
pub fn automatic(fluence: &[[f64; 3]]) -> f64 {
    let lights = fluence.iter().map(|color| luminance(*color)).filter(|light| light.is_finite() && *light > 0.0);
    let mut lights: Vec<f64> = lights.collect();
    lights.sort_unstable_by(f64::total_cmp);
    let half = 0.5 * lights.iter().sum::<f64>();
    let mut below = 0.0;
    let key = lights.iter().find(|light| {
        below += **light;
        below >= half
    });
    key.map_or(1.0, |key| KEY / key)
}
