//! Room: whether a ball can touch a part, or lie over it, with all that stands round it.
//!
//! A place is tried every millimetre or so, and what stands is as large as it is drawn, so what is told is so: a ball that
//! touches the part anywhere would be inside something else.

use super::{called, solid};
use crate::table::Table;
use geometry::{Core, DVec2, Segment, Shape, trig};
use physics::{BALL_RADIUS_M, Kind};
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// From one place to the next along a line, m, and how many there are at most.
const STEP_M: f64 = 1e-3;
const MAX_STEPS: usize = 200;
/// Directions in which a round end is touched.
const DIRECTIONS: usize = 24;
/// A ball may be drawn so deep in what stands: roundings, m.
const ROUNDED_M: f64 = 1e-5;
/// A ball that passes over a switch may be squeezed by so much, m: a lane that is a little too narrow is another mistake.
const SQUEEZED_M: f64 = 5e-4;

/// How a ball meets a part.
enum Meeting {
    /// It touches it with its rim.
    Touch(Shape),
    /// Its centre comes into it.
    Over(Shape),
}

/// The parts that no ball can come to: which, why, and whether it may be meant.
pub(super) fn findings(table: &Table) -> Vec<(usize, String, bool)> {
    let standing: Vec<(usize, Shape)> = table
        .layout
        .parts
        .iter()
        .enumerate()
        .flat_map(|(part, own)| {
            let shapes = match &own.kind {
                Kind::Wall(wall) => wall.shapes.clone(),
                // It falls, and leaves its place to a ball.
                Kind::DropTarget(_) => Vec::new(),
                kind => solid(kind).into_iter().collect(),
            };
            shapes.into_iter().map(move |shape| (part, shape))
        })
        .collect();
    let parts = table.layout.parts.iter().enumerate();
    parts.filter_map(|(part, own)| of_part(table, part, &meeting(&own.kind)?, &standing)).collect()
}

fn meeting(kind: &Kind) -> Option<Meeting> {
    let line = |segment: &Segment| Shape::capsule(segment.a, segment.b, 0.0);
    match kind {
        Kind::Rollover(own) => Some(Meeting::Over(own.shape)),
        Kind::Saucer(own) => Some(Meeting::Over(Shape::disc(own.circle.center, 0.0))),
        Kind::Gate(own) => Some(Meeting::Over(line(&own.segment))),
        Kind::Spinner(own) => Some(Meeting::Over(line(&own.segment))),
        kind => solid(kind).map(Meeting::Touch),
    }
}

fn of_part(
    table: &Table,
    part: usize,
    meeting: &Meeting,
    standing: &[(usize, Shape)],
) -> Option<(usize, String, bool)> {
    let (Meeting::Touch(shape) | Meeting::Over(shape)) = meeting;
    let reach = shape.bounds().grown(2.0 * BALL_RADIUS_M + STEP_M);
    let near: Vec<&(usize, Shape)> =
        standing.iter().filter(|(other, shape)| *other != part && shape.bounds().overlaps(&reach)).collect();
    if near.is_empty() {
        return None;
    }
    let (places, deepest) = match meeting {
        Meeting::Touch(shape) => (round(shape, shape.radius + BALL_RADIUS_M), ROUNDED_M),
        Meeting::Over(shape) => (within(shape), SQUEEZED_M),
    };
    let size = table.layout.size_m;
    let on_table = |place: &&DVec2| place.cmpge(DVec2::ZERO).all() && place.cmple(size).all();
    let mut blocking: BTreeMap<usize, usize> = BTreeMap::new();
    let mut only_touched = false;
    for place in places.iter().filter(on_table) {
        let depth = |shape: &Shape| BALL_RADIUS_M - shape.distance(*place).0;
        let (other, deep) = near
            .iter()
            .map(|(other, shape)| (*other, depth(shape)))
            .max_by(|one, other| one.1.total_cmp(&other.1))
            .unwrap_or((0, f64::NEG_INFINITY));
        let is_touched_too = matches!(meeting, Meeting::Touch(_)) && deep > -ROUNDED_M;
        if deep <= deepest && !is_touched_too {
            return None;
        }
        only_touched |= deep <= deepest;
        *blocking.entry(other).or_default() += 1;
    }
    let (other, _) = blocking.into_iter().max_by_key(|(other, count)| (*count, std::cmp::Reverse(*other)))?;
    let other = called(table, other);
    let what = match meeting {
        Meeting::Touch(_) if only_touched => {
            format!("a ball touches {other} wherever it touches it; draw it before that, not in it")
        }
        Meeting::Touch(_) => format!("no ball can touch it: {other} is in the way on all sides; draw it before that"),
        Meeting::Over(_) => format!("no ball has room over it: {other} is in the way; a ball is 27 mm wide"),
    };
    Some((part, what, only_touched))
}

/// Places at this distance from the core of a shape, all round it.
fn round(shape: &Shape, distance: f64) -> Vec<DVec2> {
    let circle = |center: DVec2| {
        (0..DIRECTIONS).map(move |step| center + trig::direction(step as f64 * TAU / DIRECTIONS as f64) * distance)
    };
    match &shape.core {
        Core::Segment(line) => {
            let aside = line.left_normal().unwrap_or(DVec2::X) * distance;
            let sides = along(line).flat_map(|place| [place + aside, place - aside]);
            sides.chain(circle(line.a)).chain(circle(line.b)).collect()
        }
        _ => circle((shape.bounds().min + shape.bounds().max) * 0.5).collect(),
    }
}

/// Places in a shape: on its core, half way out and at its edge.
fn within(shape: &Shape) -> Vec<DVec2> {
    let middle = match &shape.core {
        Core::Segment(line) => along(line).collect(),
        _ => vec![(shape.bounds().min + shape.bounds().max) * 0.5],
    };
    if shape.radius == 0.0 {
        return middle;
    }
    let rings = [0.5, 0.99].into_iter().flat_map(|share| round(shape, shape.radius * share));
    middle.into_iter().chain(rings).collect()
}

/// Places on a line, from end to end.
fn along(line: &Segment) -> impl Iterator<Item = DVec2> {
    let steps = ((line.length() / STEP_M) as usize).clamp(1, MAX_STEPS);
    let Segment { a, b } = *line;
    (0..=steps).map(move |step| a.lerp(b, step as f64 / steps as f64))
}
