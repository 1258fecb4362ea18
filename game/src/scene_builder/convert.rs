//! From a table's lamps, finishes and colours to those of light.

use crate::table::{self, Table};
use tracer::Rgb;
use tracer::srgb::decode_rgb8;

/// What of a bulb shines.
pub(super) fn emitter(emitter: table::Emitter) -> tracer::Emitter {
    match emitter {
        table::Emitter::Disc { radius_mm } => tracer::Emitter::Disc { radius_mm },
        table::Emitter::Segment { half_mm } => tracer::Emitter::Tube { half_mm },
    }
}

/// How a top looks.
pub(super) fn finish(finish: &table::Finish) -> tracer::Finish {
    let &table::Finish { albedo, profile, gloss, art, emission, emission_power, opacity, translucency } = finish;
    let profile = match profile {
        table::Profile::Bevel(width_mm) => tracer::Profile::Bevel(width_mm),
        table::Profile::Dome => tracer::Profile::Dome,
    };
    let (albedo, emission) = (decode_rgb8(albedo), linear(emission, emission_power));
    tracer::Finish { albedo, profile, gloss, art, emission, opacity, translucency }
}

/// Light from everywhere.
pub(super) fn ambient(table: &Table) -> Rgb {
    linear(table.ambient, table.ambient_power)
}

/// An sRGB colour as linear light, times `power`.
pub(super) fn linear(color: [u8; 3], power: f32) -> Rgb {
    decode_rgb8(color).map(|channel| channel * power)
}
