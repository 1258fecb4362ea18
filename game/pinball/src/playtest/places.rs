//! Places where balls are let go: where one may lie, and the same number of others whatever else stands on the table.

use super::nearest::touchable;
use super::reach::Reach;
use super::wedges;
use geometry::{Core, DVec2, Shape};
use physics::{BALL_RADIUS_M, Kind, Machine};

/// Of all places no more than one in so many is a pit, no more than one in so many is beside what moves, and no more than one
/// in so many is a wedge.
const SHARE: usize = 4;
/// A ball that is let go beside a part is no farther from it, m.
const BESIDE_M: f64 = 0.003;
/// Places beside a part that are farther apart are two, m.
const APART_M: f64 = 0.01;

/// At most `most` places that a ball can come to.
pub fn places(machine: &Machine, reach: &Reach, most: usize) -> Vec<DVec2> {
    let some = |places: Vec<DVec2>| {
        let stride = places.len().div_ceil((most / SHARE).max(1)).max(1);
        places.into_iter().step_by(stride).collect::<Vec<_>>()
    };
    let beside = machine.layout().parts.iter().flat_map(|part| beside(reach, &part.kind));
    let flaps: Vec<Shape> = machine.layout().parts.iter().flat_map(|part| flaps(&part.kind)).collect();
    let is_free = |place: &DVec2| flaps.iter().all(|flap| flap.distance(*place).0 >= BALL_RADIUS_M);
    let mut all = some(reach.pits().into_iter().filter(is_free).collect());
    all.extend(some(beside.collect()));
    all.extend(some(wedges::places(machine, reach)));
    let left = most.saturating_sub(all.len());
    all.extend(reach.spread_places().into_iter().filter(is_free).take(left));
    all
}

/// The flap of a gate: below it no ball comes to rest.
fn flaps(kind: &Kind) -> Vec<Shape> {
    if matches!(kind, Kind::Gate(_)) { touchable(kind) } else { Vec::new() }
}

/// Places above a part that moves, and may hold a ball which what stands still would not.
fn beside(reach: &Reach, kind: &Kind) -> Vec<DVec2> {
    let shapes = match kind {
        Kind::Flipper(own) => vec![Shape { core: Core::Taper(own.outline(own.rest_rad)), radius: 0.0 }],
        Kind::Gate(_) | Kind::DropTarget(_) => touchable(kind),
        _ => Vec::new(),
    };
    let mut found: Vec<DVec2> = Vec::new();
    for shape in shapes {
        let near = reach.roomy_near(shape, BALL_RADIUS_M + BESIDE_M);
        let lies_on = |place: &DVec2| {
            let (distance, normal) = shape.distance(*place);
            distance >= BALL_RADIUS_M && normal.y < 0.0
        };
        for place in near.filter(lies_on) {
            if found.iter().all(|other| other.distance(place) > APART_M) {
                found.push(place);
            }
        }
    }
    found
}
