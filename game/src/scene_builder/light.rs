//! From a table's colours, lamps and finishes to those of light.

use crate::table;
use tracer::Rgb;

/// The linear light of an sRGB colour, each channel 0 to 1 (IEC 61966-2-1).
pub fn linear(srgb: [u8; 3]) -> Rgb {
    srgb.map(linear_channel)
}

/// The linear light of one sRGB channel, 0 to 1.
pub fn linear_channel(value: u8) -> f32 {
    let encoded = f32::from(value) / 255.0;
    if encoded <= 0.04045 { encoded / 12.92 } else { libm::powf((encoded + 0.055) / 1.055, 2.4) }
}

/// What of a bulb shines.
pub(super) fn emitter(emitter: table::Emitter) -> tracer::Emitter {
    match emitter {
        table::Emitter::Disc { radius_mm } => tracer::Emitter::Disc { radius_mm },
        table::Emitter::Segment { half_mm } => tracer::Emitter::Segment { half_mm },
    }
}

/// How a top looks.
pub(super) fn finish(finish: table::Finish) -> tracer::Finish {
    let table::Finish { albedo, profile, gloss, art, emission, opacity, translucency } = finish;
    let profile = match profile {
        table::Profile::Bevel(width_mm) => tracer::Profile::Bevel(width_mm),
        table::Profile::Dome => tracer::Profile::Dome,
    };
    tracer::Finish { albedo, profile, gloss, art, emission, opacity, translucency }
}
