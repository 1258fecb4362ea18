//! Check: whether a layout's numbers can be at all.

use crate::BALL_RADIUS_M;
use crate::layout::{Layout, Part};
use crate::mechanisms::kind::Kind;
use crate::part::PartId;
use crate::part::validation::{self, Checked};
use geometry::Shape;

/// The largest playfield, m.
const MAX_SIZE_M: f64 = 10.0;
/// The steepest playfield, rad: nearly upright.
const MAX_SLOPE_RAD: f64 = 1.5;
/// How deep a captive ball may be drawn into a wall, m: it moves out of it.
const MAX_CAPTIVE_DEPTH_M: f64 = 0.2e-3;
/// Surfaces that a part that is no wall has, at most.
const SURFACES_PER_PART: usize = 2;

/// The first part that cannot be, and what is wrong with it.
pub(crate) fn layout(layout: &Layout) -> Result<(), (PartId, String)> {
    let fail = |index: usize, text: String| (PartId(index as u16), text);
    if layout.parts.len() > usize::from(u16::MAX) {
        return Err(fail(0, format!("a layout may have {} parts and this has more", u16::MAX)));
    }
    playfield(layout).map_err(|text| fail(0, text))?;
    let mut shapes = 0;
    for (index, part) in layout.parts.iter().enumerate() {
        part.kind.check().map_err(|text| fail(index, text))?;
        shapes += if let Kind::Wall(wall) = &part.kind { wall.shapes.len() } else { SURFACES_PER_PART };
        if shapes > usize::from(u16::MAX) {
            return Err(fail(index, format!("a layout may have {} surfaces and this has more", u16::MAX)));
        }
    }
    let mut parts = layout.parts.iter().enumerate();
    parts.try_for_each(|(index, part)| captive_room(layout, part).map_err(|text| fail(index, text)))
}

fn playfield(layout: &Layout) -> Checked {
    validation::point("the playfield's size", layout.size_m)?;
    validation::positive("the playfield's width", layout.size_m.x)?;
    validation::positive("the playfield's height", layout.size_m.y)?;
    validation::at_most("the playfield's size", layout.size_m.max_element(), MAX_SIZE_M)?;
    validation::finite("the slope", layout.slope_rad)?;
    validation::at_most("the slope", layout.slope_rad.abs(), MAX_SLOPE_RAD)?;
    validation::not_negative("the playfield's friction", layout.playfield_friction)
}

/// A captive ball must have room where it is drawn.
fn captive_room(layout: &Layout, part: &Part) -> Checked {
    let Kind::CaptiveBall(captive) = &part.kind else { return Ok(()) };
    let depth = |shape: &Shape| BALL_RADIUS_M - shape.distance(captive.center).0;
    for other in &layout.parts {
        let Kind::Wall(wall) = &other.kind else { continue };
        if let Some(deep) = wall.shapes.iter().map(depth).find(|&deep| deep > MAX_CAPTIVE_DEPTH_M) {
            return Err(format!("it lies {:.1} mm deep in \"{}\"; a ball must have room", deep * 1000.0, other.name));
        }
    }
    Ok(())
}
