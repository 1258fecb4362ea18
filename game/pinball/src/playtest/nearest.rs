//! What is nearest to a ball that is told of: of what it touches, or the ramp that it is on.

use geometry::{Core, DVec2, Segment, Shape};
use physics::{BALL_RADIUS_M, FlipperControl, Kind, Layout, PartId, Ramp};

/// Below a ramp's floor that is this high a ball passes, m.
const PASSAGE_M: f64 = 2.0 * BALL_RADIUS_M + 0.002;
/// Steps along a leg of a ramp's path.
const LEG_STEPS: i32 = 64;

/// Between what a ball touches and what it does not, m.
const TOUCH_M: f64 = 0.001;

/// The part whose surface is nearest to a ball at `place_m`, if it is not `but`.
pub fn part(layout: &Layout, place_m: DVec2, but: Option<PartId>) -> Option<PartId> {
    nearest(layout, place_m, but).map(|(part, _)| part)
}

/// Another part that a ball at `place_m` touches.
pub fn touching(layout: &Layout, place_m: DVec2, but: Option<PartId>) -> Option<PartId> {
    nearest(layout, place_m, but).filter(|(_, away)| *away < BALL_RADIUS_M + TOUCH_M).map(|(part, _)| part)
}

fn nearest(layout: &Layout, place_m: DVec2, but: Option<PartId>) -> Option<(PartId, f64)> {
    let distance = |kind: &Kind| match kind {
        Kind::Ramp(ramp) => to_low_part(ramp, place_m),
        _ => touchable(kind).into_iter().map(|shape| shape.distance(place_m).0).min_by(f64::total_cmp),
    };
    let parts = layout.parts.iter().enumerate().map(|(index, part)| (PartId(index as u16), &part.kind));
    let others = parts.filter(|(part, _)| Some(*part) != but);
    let distances = others.filter_map(|(part, kind)| Some((part, distance(kind)?)));
    distances.min_by(|one, other| one.1.total_cmp(&other.1))
}

/// How far a ball on the playfield is from those sides of a ramp that stand there: where its floor is too low to pass below.
fn to_low_part(ramp: &Ramp, place_m: DVec2) -> Option<f64> {
    let legs = ramp.path.iter().zip(ramp.heights_m.windows(2));
    let places = legs.flat_map(|(leg, heights)| {
        (0..=LEG_STEPS).filter_map(move |step| {
            let part = f64::from(step) / f64::from(LEG_STEPS);
            let height = heights[0] + (heights[1] - heights[0]) * part * part * (3.0 - 2.0 * part);
            (height < PASSAGE_M).then(|| leg.at(part * leg.length()))
        })
    });
    places.map(|place| place.distance(place_m) - ramp.half_width_m).min_by(f64::total_cmp)
}

/// The ramp whose middle is nearest to a ball at `place_m`.
pub fn ramp(layout: &Layout, place_m: DVec2) -> Option<PartId> {
    let parts = layout.parts.iter().enumerate();
    let distances = parts.filter_map(|(index, part)| match &part.kind {
        Kind::Ramp(ramp) => {
            let legs = ramp.path.iter().map(|leg| Shape { core: leg.offset(0.0), radius: 0.0 }.distance(place_m).0);
            Some((PartId(index as u16), legs.fold(f64::INFINITY, f64::min)))
        }
        _ => None,
    });
    distances.min_by(|one, other| one.1.total_cmp(&other.1)).map(|(part, _)| part)
}

/// What of a part a ball touches.
pub fn touchable(kind: &Kind) -> Vec<Shape> {
    let bar = |segment: Segment| Shape::capsule(segment.a, segment.b, 0.0);
    let moving = match kind {
        Kind::Spinner(own) => Some(bar(own.segment)),
        Kind::Gate(own) => Some(bar(own.segment)),
        Kind::Kickback(own) => Some(Shape::disc(own.tip, own.half_width_m)),
        Kind::CaptiveBall(own) => Some(Shape::disc(own.center, BALL_RADIUS_M)),
        // A diverter lies as it is drawn until the rules turn it.
        Kind::Flipper(own) if own.control == FlipperControl::Rules => {
            Some(Shape { core: Core::Taper(own.outline(own.rest_rad)), radius: 0.0 })
        }
        _ => None,
    };
    kind.surfaces().into_iter().chain(kind.sensor()).chain(moving).collect()
}
