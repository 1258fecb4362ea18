//! Exposure adaptation: the light that an eye at the table has adapted to, which pictures are exposed for.
//!
//! It is state that follows the lamps tick by tick, so it is kept and saved where they are: a picture of a recording is the
//! same after a seek, and everywhere, since all is integers. It changes nothing in a game and is no part of a hash. What a
//! picture makes of it, the exposure, is found where pictures are made.

use super::LampController;
use crate::Table;
use crate::table::{Lamp, LampKind};
use geometry::DVec2;
use serde::{Deserialize, Serialize};

/// Ticks between two looks.
pub const ADAPTATION_TICKS: u64 = 10;
/// Time in which an eye closes all but 1/e of its way to more light, ms.
const BRIGHTER_MS: i64 = 400;
/// Time in which it closes all but 1/e of its way to less light, ms.
const DARKER_MS: i64 = 1200;
/// The unit of light that is usual: [`ExposureAdaptation::light`] is 1 there.
const USUAL: i64 = 1_000_000;
/// How much of all lamps at once, each in its own colour, is usual on a table in play.
const USUAL_PART: f64 = 0.5;

/// A bulb gives its power at this distance, mm: the falloff is `power * reference^2 / (d^2 + height^2)`, and ends at its
/// reach.
pub const REFERENCE_MM: f64 = 100.0;

/// The light that an eye has adapted to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct ExposureAdaptation {
    light: i64,
}

impl Default for ExposureAdaptation {
    fn default() -> ExposureAdaptation {
        ExposureAdaptation { light: USUAL }
    }
}

impl ExposureAdaptation {
    /// The light that it has adapted to, in parts of what is usual.
    pub fn light(self) -> f32 {
        self.light as f32 / USUAL as f32
    }

    /// [`ADAPTATION_TICKS`] later, while lamps give `light` (as [`LampBrightness`] tells it).
    fn adapt(&mut self, light: i64) {
        let gap = light - self.light;
        let time = if gap > 0 { BRIGHTER_MS } else { DARKER_MS };
        let step = gap * ADAPTATION_TICKS as i64 / time;
        // What is left of its way when it is too near for a step is seen by nobody.
        self.light = if step == 0 { light } else { self.light + step };
    }
}

/// How much each lamp of a table is of all light: what adaptation has to know of it.
#[derive(Clone, Debug)]
pub struct LampBrightness {
    /// What each lamp gives at its brightest in white, in [`USUAL`]s.
    lamps: Vec<i64>,
}

impl LampBrightness {
    /// What there is to see on `table`.
    pub fn new(table: &Table) -> LampBrightness {
        let mean_light: Vec<f64> = table.lamps.iter().map(|lamp| mean_light(lamp, table.size_mm)).collect();
        let own = mean_light
            .iter()
            .zip(&table.lamps)
            .map(|(mean_light, lamp)| mean_light * luminance(lamp.color) as f64 / 65_025.0);
        let usual = USUAL_PART * own.sum::<f64>();
        let lamp = |mean_light: &f64| if usual > 0.0 { (mean_light / usual * USUAL as f64) as i64 } else { 0 };
        LampBrightness { lamps: mean_light.iter().map(lamp).collect() }
    }

    /// Shows it to an eye for [`ADAPTATION_TICKS`], as the lamps are now.
    pub fn show(&self, lamps: &LampController, table: &Table, now: u64, adaptation: &mut ExposureAdaptation) {
        if self.lamps.is_empty() {
            return;
        }
        let lights = lamps.each_light(table, now);
        let light = lights.zip(&self.lamps).map(|(light, mean_light)| {
            let mean_light = *mean_light * i64::from(light.level) / 1000;
            mean_light * i64::from(luminance(light.color)) / 65_025
        });
        adaptation.adapt(light.sum());
    }
}

/// How bright a colour (sRGB) is, 0 to 255 squared: the square is near enough to the transfer curve.
fn luminance([r, g, b]: [u8; 3]) -> u32 {
    let square = |channel: u8| u32::from(channel) * u32::from(channel);
    (54 * square(r) + 183 * square(g) + 19 * square(b)) / 256
}

/// The light of a lamp at its brightest, as a mean over a playfield of `size_mm` on which nothing stands.
pub fn mean_light(lamp: &Lamp, size_mm: DVec2) -> f64 {
    let area = size_mm.x * size_mm.y;
    let part = match &lamp.kind {
        LampKind::Bulb { height_mm, reach_mm, .. } => {
            // The integral over the plane of a bulb's falloff, power reference^2 / (r^2 + height^2) (1 - r^2 / reach^2)^2, with u = r^2, a = height^2, b = reach^2:
            // pi reference^2 times that of (1 - u / b)^2 / (u + a) from 0 to b.
            let (a, b) = ((height_mm * height_mm).max(1.0), reach_mm * reach_mm);
            let ratio = a / b;
            let c = 1.0 + ratio;
            let integral = c * c * libm::log(1.0 + b / a) - 2.0 * c + 0.5 + ratio;
            std::f64::consts::PI * REFERENCE_MM * REFERENCE_MM * integral / area
        }
        LampKind::Insert { outlines_mm } => {
            outlines_mm.iter().map(|outline| covered(outline)).sum::<f64>().abs() / area
        }
    };
    let mean_light = lamp.power * part;
    if mean_light.is_finite() { mean_light.max(0.0) } else { 0.0 }
}

/// The area of a polygon, mm^2, negative if it goes the other way round.
fn covered(outline: &[DVec2]) -> f64 {
    let next = outline.iter().cycle().skip(1);
    outline.iter().zip(next).map(|(a, b)| a.perp_dot(*b)).sum::<f64>() * 0.5
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_gets_used_to_light_faster_than_to_darkness_and_ends_there() {
        let after = |from: i64, to: i64, ms: u64| {
            let mut adaptation = ExposureAdaptation { light: from };
            (0..ms / ADAPTATION_TICKS).for_each(|_| adaptation.adapt(to));
            adaptation.light
        };
        let up = after(0, 1_000_000, 400);
        assert!((600_000..660_000).contains(&up), "{up}");
        let down = after(1_000_000, 0, 1200);
        assert!((340_000..400_000).contains(&down), "{down}");
        assert_eq!(after(123, 4_567_891, 20_000), 4_567_891);
        assert_eq!(after(4_567_891, 123, 60_000), 123);
    }

    #[test]
    fn the_area_of_a_square_is_its_side_squared() {
        let square = [DVec2::ZERO, DVec2::new(3.0, 0.0), DVec2::splat(3.0), DVec2::new(0.0, 3.0)];
        assert_eq!(covered(&square), 9.0);
    }
}
