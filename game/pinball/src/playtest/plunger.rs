//! The plunger's trial: a new ball arrives, the rod is pulled and let go, and the ball must come away.

use super::finding::{Finding, FindingKind};
use super::{is_on, wait};
use geometry::DVec2;
use physics::{BALL_RADIUS_M, Command, Controls, EventKind, Kind, Machine, PartId, Plunger, TICKS_PER_SECOND};

/// How far the rod is pulled, one pull after the other: a full shot may come back round a bend, a softer one does not.
const PULLS: [f64; 4] = [1.0, 0.8, 0.6, 0.4];
/// A new ball lies on the rod by then, ticks.
const SETTLE_TICKS: u32 = 1500;
/// A ball that comes back has come back by then, ticks.
const FLIGHT_TICKS: u32 = 8000;
/// A ball that is no farther from the feed, aside or along, has not come away, m.
const LANE_M: f64 = 6.0 * BALL_RADIUS_M;

/// What is wrong with the plunger.
pub fn try_it(machine: &Machine) -> Vec<Finding> {
    let parts = machine.layout().parts.iter().enumerate();
    let plungers = parts.filter_map(|(index, part)| match &part.kind {
        Kind::Plunger(plunger) => Some((PartId(index as u16), plunger)),
        _ => None,
    });
    plungers.filter_map(|(part, plunger)| try_one(machine, part, plunger)).collect()
}

fn try_one(machine: &Machine, part: PartId, plunger: &Plunger) -> Option<Finding> {
    if machine.depth_in_fixed_m(plunger.feed) > 0.0 {
        return Some(Finding::of_part(FindingKind::FeedBlocked, part, plunger.feed));
    }
    let far = |place: &DVec2| place.distance(plunger.feed);
    let mut turned_back = plunger.feed;
    for pull in PULLS {
        let place = shot(machine.clone(), plunger, pull).err()?;
        turned_back = if far(&place) > far(&turned_back) { place } else { turned_back };
    }
    let kind = if plunger.direction.y > 0.0 { FindingKind::PointsDown } else { FindingKind::Unlaunched };
    Some(Finding::of_part(kind, part, turned_back))
}

/// Shoots a ball with this part of a full pull.
///
/// # Errors
/// If it does not come away from the lane: the place farthest from the feed that it has come to, m.
fn shot(mut machine: Machine, plunger: &Plunger, pull: f64) -> Result<(), DVec2> {
    machine.tick(Controls::NONE, &[Command::AddBall]);
    wait(&mut machine, Controls::NONE, SETTLE_TICKS);
    let pull_ticks = (pull * plunger.pull_s * f64::from(TICKS_PER_SECOND)).ceil() as u32;
    wait(&mut machine, Controls { plunger: true, ..Controls::NONE }, pull_ticks);
    let (mut launched, mut farthest) = (false, plunger.feed);
    for _ in 0..FLIGHT_TICKS {
        machine.tick(Controls::NONE, &[]);
        launched |= machine.events().iter().any(|event| event.kind == EventKind::Launched);
        let centers = machine.balls().into_iter().map(|ball| ball.center).filter(|center| is_on(&machine, *center));
        farthest =
            centers.fold(
                farthest,
                |one, other| {
                    if other.distance(plunger.feed) > one.distance(plunger.feed) { other } else { one }
                },
            );
    }
    let is_away = |center: DVec2| center.distance(plunger.feed) > LANE_M;
    if launched && machine.balls().iter().all(|ball| is_away(ball.center)) { Ok(()) } else { Err(farthest) }
}
