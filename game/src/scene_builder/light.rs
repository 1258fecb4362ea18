//! From a table's lamps and finishes to those of light.

use crate::table;

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
