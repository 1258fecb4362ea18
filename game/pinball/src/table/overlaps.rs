//! Overlaps: parts that are drawn in each other, and parts that no ball can come to because something stands in them.
//!
//! Walls may lie in each other and posts in walls, so only what is there for a ball is looked at; and what moves out of the
//! way is in nobody's.

mod drain_gap;
mod plunger;
mod room;
mod strokes;
mod weak_pull;

use super::{FILES, Table};
use crate::Failure;
use geometry::{Circle, Core, DVec2, Shape, Taper, trig};
use physics::{BALL_RADIUS_M, Flipper, Kind};
use std::collections::BTreeSet;

/// Parts that are drawn deeper in each other than this are told, m.
const DEEP_M: f64 = 1e-3;
/// Flippers may brush each other so far, m: the ends of their rubbers give way.
const BRUSH_M: f64 = 5e-3;
/// Parts of one kind are in one place if their middles are no farther apart, m.
const SAME_M: f64 = 1e-3;
/// Angles of a stroke, and discs of a flipper, that are looked at.
const STROKE_STEPS: usize = 12;
const DISCS: usize = 16;

/// What is wrong with where the parts of a table are, by file and line: mistakes, and warnings of what may be meant.
pub(super) fn findings(table: &Table) -> Vec<Failure> {
    let parts: Vec<Placed> = table.layout.parts.iter().enumerate().filter_map(Placed::of).collect();
    let mut found: Vec<(usize, String, bool)> = Vec::new();
    let mut told = BTreeSet::new();
    for (index, later) in parts.iter().enumerate() {
        let first = parts[..index].iter().find_map(|earlier| Some((earlier.part, pair(earlier, later)?)));
        if let Some((earlier, (what, is_warning))) = first {
            told.extend([earlier, later.part]);
            found.push((later.part, format!("{what} {}; draw them apart", called(table, earlier)), is_warning));
        }
    }
    found.extend(strokes::findings(table));
    found.extend(drain_gap::findings(table).into_iter().filter(|(part, ..)| !told.contains(part)));
    found.extend(plunger::findings(table));
    found.extend(weak_pull::findings(table));
    found.extend(room::findings(table).into_iter().filter(|(part, ..)| !told.contains(part)));
    found.sort();
    let failure = |(part, what, is_warning): (usize, String, bool)| {
        let line = table.part_lines.get(part).map_or_else(String::new, |line| format!(":{line}"));
        let sentence = format!("{}{line}: {}: {what}", table.file(FILES[0]), table.layout.parts[part].name);
        if is_warning { Failure::warning(sentence) } else { Failure::new(sentence) }
    };
    found.into_iter().map(failure).collect()
}

/// A part for a sentence: `pop of line 7`.
fn called(table: &Table, part: usize) -> String {
    let line = table.part_lines.get(part).map_or_else(String::new, |line| format!(" of line {line}"));
    format!("{}{line}", table.layout.parts[part].name)
}

/// A part that is there for a ball, and where it is.
struct Placed<'a> {
    part: usize,
    kind: &'a Kind,
    middle: DVec2,
    /// What of it is solid and stays where it is.
    solid: Option<Shape>,
}

impl<'a> Placed<'a> {
    fn of((part, placed): (usize, &'a physics::Part)) -> Option<Placed<'a>> {
        let kind = &placed.kind;
        let solid = solid(kind);
        let middle = match (kind, &solid) {
            (Kind::Gate(gate), _) => (gate.segment.a + gate.segment.b) * 0.5,
            (Kind::Spinner(spinner), _) => (spinner.segment.a + spinner.segment.b) * 0.5,
            (Kind::Saucer(saucer), _) => saucer.circle.center,
            (Kind::Rollover(rollover), _) => middle(&rollover.shape),
            (Kind::Flipper(flipper), _) => flipper.base.center,
            (_, Some(shape)) => middle(shape),
            _ => return None,
        };
        Some(Placed { part, kind, middle, solid })
    }
}

/// What of a part is solid wherever a ball meets it; nothing of walls, and of what turns.
fn solid(kind: &Kind) -> Option<Shape> {
    match kind {
        Kind::Bumper(own) => Some(Shape::disc(own.circle.center, own.circle.radius)),
        Kind::Slingshot(own) => Some(Shape::capsule(own.segment.a, own.segment.b, own.radius_m)),
        Kind::Target(own) => Some(own.shape),
        Kind::DropTarget(own) => Some(own.shape),
        _ => None,
    }
}

fn middle(shape: &Shape) -> DVec2 {
    let bounds = shape.bounds();
    (bounds.min + bounds.max) * 0.5
}

/// What is wrong with where two parts are, and whether it may be meant.
fn pair(one: &Placed, other: &Placed) -> Option<(String, bool)> {
    let lies_in = || Some(("it lies in".to_string(), false));
    if let (Kind::Flipper(a), Kind::Flipper(b)) = (one.kind, other.kind) {
        return flippers(a, b);
    }
    if std::mem::discriminant(one.kind) == std::mem::discriminant(other.kind)
        && one.middle.distance(other.middle) < SAME_M
    {
        // Two switches in one place both close; two solid things are one too many.
        return Some(("it lies in one place with".to_string(), one.solid.is_none()));
    }
    if let (Kind::Saucer(a), Kind::Saucer(b)) = (one.kind, other.kind) {
        return if a.circle.center.distance(b.circle.center) < a.circle.radius.max(b.circle.radius) {
            lies_in()
        } else {
            None
        };
    }
    let is_in = |a: &Placed, b: &Placed| {
        // A rollover is in nobody's way, and bumpers' skirts may overlap.
        let is_free = matches!((a.kind, b.kind), (Kind::Rollover(_), _) | (Kind::Bumper(_), Kind::Bumper(_)));
        b.solid.filter(|_| !is_free).map_or(f64::INFINITY, |solid| solid.distance(a.middle).0)
    };
    for (a, b) in [(one, other), (other, one)] {
        let away = is_in(a, b);
        if matches!(a.kind, Kind::Saucer(_)) && away < BALL_RADIUS_M - DEEP_M && !matches!(b.kind, Kind::DropTarget(_))
        {
            let deep_mm = (BALL_RADIUS_M - away) * 1000.0;
            let what = match a.part == other.part {
                true => format!("a ball in it would lie {deep_mm:.1} mm deep in"),
                false => format!("it stands {deep_mm:.1} mm deep in a ball that lies in"),
            };
            return Some((what, false));
        }
        if away < 0.0 {
            return lies_in();
        }
    }
    None
}

/// Whether flippers lie in each other at rest, or one's stroke crosses the other near its pivot. Tips may cross: there are
/// tables whose flippers are nearer to each other than they are long.
fn flippers(one: &Flipper, other: &Flipper) -> Option<(String, bool)> {
    let reach = |flipper: &Flipper| flipper.length_m + flipper.tip_radius_m.max(flipper.base.radius);
    if one.base.center.distance(other.base.center) > reach(one) + reach(other) {
        return None;
    }
    if depth([one, other], [0.0; 2], DISCS) > BRUSH_M {
        return Some(("it lies in".to_string(), false));
    }
    let along = |step: usize| step as f64 / STROKE_STEPS as f64;
    let steps = (0..=STROKE_STEPS).flat_map(|a| (0..=STROKE_STEPS).map(move |b| [along(a), along(b)]));
    let near_pivots =
        |[a, b]: [f64; 2]| depth([one, other], [a, b], DISCS / 2).max(depth([other, one], [b, a], DISCS / 2));
    let deepest = steps.map(near_pivots).fold(0.0, f64::max);
    (deepest > BRUSH_M).then(|| ("flippers go through each other, and its stroke crosses that of".to_string(), true))
}

/// How deep the first `discs` discs of the second flipper, from its pivot on, are in the first at these parts of their
/// strokes, m.
fn depth([one, other]: [&Flipper; 2], [at, other_at]: [f64; 2], discs: usize) -> f64 {
    let (hull, tip) = (turned(one, at), tip(other, other_at));
    let depths = (0..=discs).map(|disc| {
        let along = disc as f64 / DISCS as f64;
        let center = other.base.center.lerp(tip, along);
        let radius = other.base.radius + (other.tip_radius_m - other.base.radius) * along;
        radius - hull.distance(center).0
    });
    depths.fold(f64::NEG_INFINITY, f64::max)
}

fn turned(flipper: &Flipper, at: f64) -> Shape {
    let b = Circle { center: tip(flipper, at), radius: flipper.tip_radius_m };
    Shape { core: Core::Taper(Taper { a: flipper.base, b }), radius: 0.0 }
}

fn tip(flipper: &Flipper, at: f64) -> DVec2 {
    let angle = flipper.rest_rad + (flipper.up_rad - flipper.rest_rad) * at;
    flipper.base.center + trig::direction(angle) * flipper.length_m
}
