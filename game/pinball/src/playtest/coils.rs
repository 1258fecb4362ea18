//! The coils' and switches' trials: a ball before each, and what it must do with it.

use super::finding::{Finding, FindingKind};
use super::reach::Reach;
use super::{THROWN_M, farthest, wait};
use geometry::{DVec2, Shape, trig};
use physics::{
    BALL_RADIUS_M, Bumper, Command, Controls, EventKind, Flipper, FlipperControl, Kickback, Kind, Machine, PartId,
    Saucer, Slingshot,
};

/// Room that is left between a ball and what it is put at, m.
const GAP_M: f64 = 2e-4;
/// How fast a ball is shot at a switch, m/s; twice the part's own threshold if that is more.
const SHOT_M_S: f64 = 1.5;
/// A ball is shot from no farther, m.
const SHOT_RANGE_M: f64 = 0.06;
/// A captive ball that is farther from where it is drawn has come out, m.
const CAPTIVE_M: f64 = 0.15;
/// A ball that lies is no faster, m/s.
const LYING_M_S: f64 = 0.01;
/// A ball that is flipped is this fast, m/s.
const FLIPPED_M_S: f64 = 0.5;

/// Whether there is a trial for such a part.
pub fn has_trial(kind: &Kind) -> bool {
    matches!(
        kind,
        Kind::Saucer(_)
            | Kind::Kickback(_)
            | Kind::Flipper(_)
            | Kind::Bumper(_)
            | Kind::Slingshot(_)
            | Kind::DropTarget(_)
    )
}

/// What is wrong with this part's coil or switch.
pub fn try_it(machine: &Machine, reach: &Reach, part: PartId, kind: &Kind) -> Option<Finding> {
    let machine = machine.clone();
    match kind {
        Kind::Saucer(saucer) => try_saucer(machine, part, saucer),
        Kind::Kickback(kickback) => try_kickback(machine, part, kickback),
        Kind::Flipper(flipper) => try_flipper(machine, part, flipper),
        Kind::Bumper(Bumper { threshold_m_s, .. }) | Kind::Slingshot(Slingshot { threshold_m_s, .. }) => {
            shoot_at(machine, reach, part, kind.surfaces().first()?, *threshold_m_s)
        }
        Kind::DropTarget(target) => {
            let hit = shoot_at(machine.clone(), reach, part, &target.shape, target.threshold_m_s);
            hit.or_else(|| try_raise(machine, reach, part, &target.shape, target.threshold_m_s))
        }
        _ => None,
    }
}

/// Captive balls that do not stay where they are when the machine is pushed.
pub fn loose_captives(machine: &Machine) -> Vec<Finding> {
    let mut machine = machine.clone();
    let push = Controls { nudge_up: true, ..Controls::NONE };
    (0..20).for_each(|_| machine.tick(push, &[]));
    wait(&mut machine, Controls::NONE, 2000);
    let captives = machine.pose().captives;
    let parts = machine.layout().parts.iter().enumerate();
    let drawn = parts.filter_map(|(index, part)| match &part.kind {
        Kind::CaptiveBall(captive) => Some((PartId(index as u16), captive.center)),
        _ => None,
    });
    let is_loose = |part: PartId, center: DVec2| {
        let own = captives.iter().find(|(captive, _)| *captive == part);
        own.is_none_or(|(_, ball)| ball.center.distance(center) > CAPTIVE_M)
    };
    let loose = drawn.filter(|&(part, center)| is_loose(part, center));
    loose.map(|(part, center)| Finding::of_part(FindingKind::ComesOut, part, center)).collect()
}

/// A ball in the saucer is thrown out, and must not come back by itself.
fn try_saucer(mut machine: Machine, part: PartId, saucer: &Saucer) -> Option<Finding> {
    let center = saucer.circle.center;
    machine.put_ball(center, DVec2::ZERO, [0.0; 3]);
    wait(&mut machine, Controls::NONE, 500);
    machine.tick(Controls::NONE, &[Command::Eject(part)]);
    wait(&mut machine, Controls::NONE, 3000);
    // One that never came out is not caught a second time, and lies there.
    let lies = |ball: &physics::BallPose| ball.held || ball.velocity.length() < LYING_M_S;
    let is_in = |ball: physics::BallPose| lies(&ball) && ball.center.distance(center) < saucer.circle.radius;
    machine.balls().into_iter().any(is_in).then(|| Finding::of_part(FindingKind::KeepsItsBall, part, center))
}

/// A ball on the kickback's face is thrown.
fn try_kickback(mut machine: Machine, part: PartId, kickback: &Kickback) -> Option<Finding> {
    let center = kickback.tip + kickback.direction * (BALL_RADIUS_M + GAP_M);
    machine.put_ball(center, DVec2::ZERO, [0.0; 3]);
    if machine.penetration_m() > 0.0 {
        return Some(Finding::of_part(FindingKind::DoesNotKick, part, center));
    }
    wait(&mut machine, Controls::NONE, 100);
    machine.tick(Controls::NONE, &[Command::Kick(part)]);
    let thrown = farthest(&mut machine, Controls::NONE, center, 1000) > THROWN_M;
    (!thrown).then(|| Finding::of_part(FindingKind::DoesNotKick, part, center))
}

/// A ball on the middle of the flipper is thrown away from it.
fn try_flipper(mut machine: Machine, part: PartId, flipper: &Flipper) -> Option<Finding> {
    let controls = match flipper.control {
        FlipperControl::Left => Controls { left: true, ..Controls::NONE },
        FlipperControl::Right => Controls { right: true, ..Controls::NONE },
        FlipperControl::Rules => return None,
    };
    let along = trig::direction(flipper.rest_rad);
    // The side to which the stroke goes.
    let side = along.perp() * (flipper.up_rad - flipper.rest_rad).signum();
    let radius = 0.5 * (flipper.base.radius + flipper.tip_radius_m);
    let room = radius.max(flipper.base.radius) + BALL_RADIUS_M + GAP_M;
    let center = flipper.base.center + along * (0.6 * flipper.length_m) + side * room;
    machine.put_ball(center, DVec2::ZERO, [0.0; 3]);
    let free = machine.penetration_m() <= 0.0;
    let flipped = free && {
        let strike = |machine: &mut Machine| {
            machine.tick(controls, &[]);
            // A stroke that goes down the table throws nothing that lies on the flipper.
            machine.balls().iter().any(|ball| ball.velocity.length() > FLIPPED_M_S && side.y < 0.0)
        };
        (0..150).any(|_| strike(&mut machine))
    };
    (!flipped).then(|| Finding::of_part(FindingKind::DoesNotFlip, part, center))
}

/// A ball that is shot at the part closes its switch.
fn shoot_at(mut machine: Machine, reach: &Reach, part: PartId, shape: &Shape, threshold_m_s: f64) -> Option<Finding> {
    // What no ball can come to is told as such.
    let (place, distance) = reach.nearest(shape, SHOT_RANGE_M)?;
    let closed = is_hit(&mut machine, part, (place, distance), shape, threshold_m_s);
    (!closed).then(|| Finding::of_part(FindingKind::SwitchNeverCloses, part, place))
}

/// Shoots a ball from the place to the nearest of the part's surface; whether its switch closes.
fn is_hit(machine: &mut Machine, part: PartId, from: (DVec2, f64), shape: &Shape, threshold_m_s: f64) -> bool {
    let (place, normal) = (from.0, shape.distance(from.0).1);
    let speed = SHOT_M_S.max(2.0 * threshold_m_s);
    machine.put_ball(place, -normal * speed, [0.0; 3]);
    let is_ours = |event: &physics::Event| event.part == Some(part) && event.kind == EventKind::Closed;
    (0..500).any(|_| {
        machine.tick(Controls::NONE, &[]);
        machine.events().iter().any(is_ours)
    })
}

/// A drop target that has fallen stands up again.
fn try_raise(mut machine: Machine, reach: &Reach, part: PartId, shape: &Shape, threshold_m_s: f64) -> Option<Finding> {
    let from = reach.nearest(shape, SHOT_RANGE_M)?;
    is_hit(&mut machine, part, from, shape, threshold_m_s);
    wait(&mut machine, Controls::NONE, 1000);
    machine.tick(Controls::NONE, &[Command::Raise(part)]);
    wait(&mut machine, Controls::NONE, 2000);
    let stands = machine.pose().drop_targets.iter().any(|(own, height)| *own == part && *height > 0.9);
    (!stands).then(|| Finding::of_part(FindingKind::DoesNotRise, part, from.0))
}
