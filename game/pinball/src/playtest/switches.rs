//! The switches' trials: balls are shot at each part from places round it, as a player could shoot them, and one of them
//! must close its switch.

use super::finding::{Finding, FindingKind};
use super::nearest::touchable;
use super::reach::{self, Reach};
use super::{USUAL_BURDEN, burden, put_ball};
use geometry::{DVec2, Segment, Shape};
use physics::{BALL_RADIUS_M, Controls, Event, EventKind, Gate, Kind, Machine, PartId, Ramp, Saucer, Spinner};

/// A ball is shot from no farther, m...
const RANGE_M: f64 = 0.06;
/// ... and, where there is room for that, from no nearer: pressed against a part no ball of a game gets up speed, m.
const RUN_UP_M: f64 = 0.02;
/// How fast balls are shot, m/s: by a slack flipper and by a strong one; twice the part's own threshold if that is more.
const SPEEDS_M_S: [f64; 2] = [1.5, 4.0];
/// How fast balls come into saucers, m/s.
const ROLLING_M_S: [f64; 4] = [0.2, 0.4, 0.8, 0.1];
/// No ball comes exactly over the middle of a saucer, m.
const ASIDE_M: f64 = 0.003;
/// Half of what is aimed at in a ramp that is as wide as a ball, m.
const LEAST_MOUTH_M: f64 = 0.002;
/// Places from which balls are shot.
const MOST_PLACES: usize = 40;
/// A ball has met the part by then, ticks.
const FLIGHT_TICKS: usize = 300;
/// Contact solves that the shots at a part may take.
const MOST_CONTACT_SOLVES: u64 = 400_000;
/// A plate has turned half-way round, and a ball come to rest in a saucer, by then, ticks.
const SLOW_TICKS: usize = 1500;

/// A ball that is shot.
#[derive(Clone, Copy, Debug)]
pub struct Shot {
    /// Where it starts, m.
    pub place: DVec2,
    /// Its velocity, m/s.
    pub velocity: DVec2,
}

impl Shot {
    fn towards(place: DVec2, target: DVec2, speed_m_s: f64) -> Option<Shot> {
        Some(Shot { place, velocity: (target - place).try_normalize()? * speed_m_s })
    }
}

/// Whether there is a trial for the switch of such a part.
pub fn has_trial(kind: &Kind) -> bool {
    let is_other =
        matches!(kind, Kind::Rollover(_) | Kind::Spinner(_) | Kind::Gate(_) | Kind::Saucer(_) | Kind::Ramp(_));
    is_hit(kind).is_some() || is_other
}

/// What is wrong with the switch of this part.
pub fn try_it(machine: &Machine, reach: &Reach, part: PartId, kind: &Kind) -> Option<Finding> {
    closing_shot(machine, reach, part, kind).err()
}

/// A shot that closes the part's switch.
///
/// # Errors
/// What is wrong with the part, if none of them does. What no ball can come to is told as such, and here is none.
pub fn closing_shot(machine: &Machine, reach: &Reach, part: PartId, kind: &Kind) -> Result<Option<Shot>, Finding> {
    let (shots, ticks) = match kind {
        Kind::Rollover(rollover) if reach.roomy_near(rollover.shape, 0.0).next().is_some() => return Ok(None),
        Kind::Rollover(rollover) => (shots_at(reach, &rollover.shape, 0.0, 0.0), FLIGHT_TICKS),
        Kind::Spinner(Spinner { segment, .. }) => (shots_through(reach, segment, None), SLOW_TICKS),
        Kind::Gate(Gate { segment, direction, .. }) => (shots_through(reach, segment, Some(*direction)), SLOW_TICKS),
        Kind::Saucer(saucer) => (shots_into(reach, saucer), SLOW_TICKS),
        Kind::Ramp(ramp) => (shots_onto(reach, ramp), FLIGHT_TICKS),
        _ => {
            let Some(threshold_m_s) = is_hit(kind) else { return Ok(None) };
            // A captive ball lies where it has rolled, not where it is drawn.
            let captives = machine.pose().captives;
            let lying = captives.iter().find(|(own, _)| *own == part);
            let lying = lying.map(|(_, ball)| Shape::disc(ball.center, BALL_RADIUS_M));
            let Some(shape) = lying.or_else(|| touchable(kind).first().copied()) else { return Ok(None) };
            (shots_at(reach, &shape, BALL_RADIUS_M, threshold_m_s), FLIGHT_TICKS)
        }
    };
    let (mut tried, mut contact_solves) = (Vec::new(), 0);
    // On a table with much that moves fewer are shot.
    let stride = burden(machine).div_ceil(USUAL_BURDEN).max(1);
    for shot in shots.into_iter().step_by(stride) {
        match meets(machine, part, shot, ticks, &mut contact_solves) {
            Some(true) => return Ok(Some(shot)),
            Some(false) => tried.push(shot),
            None => {} // something that moves lies there
        }
        if contact_solves > MOST_CONTACT_SOLVES {
            return Ok(None); // it takes too long to see
        }
    }
    let Some(first) = tried.first() else { return Ok(None) };
    Err(Finding { count: tried.len(), ..Finding::of_part(FindingKind::SwitchNeverCloses, part, first.place) })
}

/// The least speed of a hit that closes the switch of such a part, m/s; none of what is not hit.
fn is_hit(kind: &Kind) -> Option<f64> {
    match kind {
        Kind::Bumper(own) => Some(own.threshold_m_s),
        Kind::Slingshot(own) => Some(own.threshold_m_s),
        Kind::Target(own) => Some(own.threshold_m_s),
        Kind::DropTarget(own) => Some(own.threshold_m_s),
        Kind::CaptiveBall(own) => Some(own.threshold_m_s),
        _ => None,
    }
}

/// Whether this shot closes the part's switch, of a ramp whether it comes onto it; unknown where there is no room for its
/// ball.
fn meets(machine: &Machine, part: PartId, shot: Shot, ticks: usize, contact_solves: &mut u64) -> Option<bool> {
    let mut machine = machine.clone();
    if !put_ball(&mut machine, shot.place, shot.velocity) {
        return None;
    }
    let is_ramp = matches!(machine.layout().parts[usize::from(part.0)].kind, Kind::Ramp(_));
    let is_ours = |event: &Event| event.part == Some(part) && event.kind == EventKind::Closed;
    Some((0..ticks).any(|_| {
        machine.tick(Controls::NONE, &[]);
        *contact_solves += machine.contact_solves();
        machine.events().iter().any(is_ours) || is_ramp && machine.balls().iter().any(|ball| ball.above)
    }))
}

/// Some of the places that are no farther from `shape` than `range_m`, those before its middle first.
fn places(reach: &Reach, shape: &Shape, nearest_m: f64, range_m: f64) -> Vec<DVec2> {
    let near = reach.roomy_near(*shape, range_m).filter(|place| shape.distance(*place).0 >= nearest_m);
    let bounds = shape.bounds();
    let middle = (bounds.min + bounds.max) * 0.5;
    let mut near: Vec<DVec2> = near.collect();
    near.sort_by(|one, other| one.distance_squared(middle).total_cmp(&other.distance_squared(middle)));
    let stride = near.len().div_ceil(MOST_PLACES).max(1);
    near.into_iter().step_by(stride).collect()
}

/// Straight at the surface of `shape` and at its middle; `skin_m`: how far the ball's centre stays from it.
fn shots_at(reach: &Reach, shape: &Shape, skin_m: f64, threshold_m_s: f64) -> Vec<Shot> {
    let bounds = shape.bounds();
    let middle = (bounds.min + bounds.max) * 0.5;
    let with_run_up = places(reach, shape, skin_m + RUN_UP_M, skin_m + RANGE_M);
    let places = if with_run_up.is_empty() { places(reach, shape, skin_m, skin_m + RANGE_M) } else { with_run_up };
    let speeds = SPEEDS_M_S.map(|speed| speed.max(2.0 * threshold_m_s));
    let at_place = |place: DVec2| {
        let (distance, normal) = shape.distance(place);
        [place - normal * distance, middle].into_iter().filter_map(move |target| Shot::towards(place, target, 1.0))
    };
    let ways: Vec<Shot> = places.into_iter().flat_map(at_place).collect();
    let faster = |speed: f64| ways.iter().map(move |shot| Shot { velocity: shot.velocity * speed, ..*shot });
    speeds.into_iter().flat_map(faster).collect()
}

/// Below a flap, straight through it: both ways, or only this one.
fn shots_through(reach: &Reach, segment: &Segment, way: Option<DVec2>) -> Vec<Shot> {
    let bar = Shape::capsule(segment.a, segment.b, 0.0);
    let before = places(reach, &bar, BALL_RADIUS_M, BALL_RADIUS_M + RANGE_M).into_iter().filter_map(|place| {
        let to_bar = segment.closest(place) - place;
        let is_beside = !(0.2..=0.8).contains(&segment.parameter(place));
        let is_behind = way.is_some_and(|way| to_bar.dot(way) < 0.0);
        (!is_beside && !is_behind).then_some((place, place + to_bar))
    });
    let before: Vec<(DVec2, DVec2)> = before.collect();
    let at = |speed: f64| before.iter().filter_map(move |(place, target)| Shot::towards(*place, *target, speed));
    SPEEDS_M_S.into_iter().flat_map(at).collect()
}

/// Through the ends of a ramp that lie on the playfield, into it.
fn shots_onto(reach: &Reach, ramp: &Ramp) -> Vec<Shot> {
    let entries = reach::low_ends(ramp).into_iter().flat_map(|(middle, inward)| {
        let aside = inward.perp() * (ramp.half_width_m - BALL_RADIUS_M).max(LEAST_MOUTH_M);
        shots_through(reach, &Segment { a: middle - aside, b: middle + aside }, Some(inward))
    });
    entries.collect()
}

/// Over the saucer, a little beside its middle.
fn shots_into(reach: &Reach, saucer: &Saucer) -> Vec<Shot> {
    let hole = Shape::disc(saucer.circle.center, saucer.circle.radius);
    let places = places(reach, &hole, BALL_RADIUS_M.min(RUN_UP_M), RANGE_M);
    let center = saucer.circle.center;
    let aside = |place: DVec2, side: f64| center + (center - place).normalize_or_zero().perp() * side;
    let at = |speed: f64| {
        let targets = |place: &DVec2| [ASIDE_M, -ASIDE_M].map(|side| (*place, aside(*place, side)));
        let shots = places.iter().flat_map(targets);
        shots.filter_map(move |(place, target)| Shot::towards(place, target, speed)).collect::<Vec<_>>()
    };
    ROLLING_M_S.into_iter().flat_map(at).collect()
}
