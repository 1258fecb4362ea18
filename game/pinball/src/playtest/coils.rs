//! The coils' trials: a ball before each, and what it must do with it.

use super::finding::{Finding, FindingKind};
use super::reach::Reach;
use super::switches::{self, Shot};
use super::{LYING_M_S, THROWN_M, put_ball, wait};
use geometry::{DVec2, Taper, trig};
use physics::{BALL_RADIUS_M, Command, Controls, Flipper, FlipperControl, Kickback, Kind, Machine, PartId, Saucer};

/// Room that is left between a ball and what it is put at, m.
const GAP_M: f64 = 2e-4;
/// A captive ball that is farther from where it is drawn has come out, m.
const CAPTIVE_M: f64 = 0.15;
/// A ball that is thrown is out of the way, or back, by then, ticks.
const THROW_TICKS: usize = 4000;
/// A ball that loses so much of its speed in a tick has met something, m/s.
const BOUNCE_M_S: f64 = 0.1;
/// A ball no farther from a kickback's face is on it again, m.
const FACE_M: f64 = 0.002;
/// A ball that is flipped is this fast, m/s.
const FLIPPED_M_S: f64 = 0.5;
/// Steps of a flipper's stroke, and along it.
const STROKE_STEPS: i32 = 16;

/// Whether there is a trial for such a part.
pub fn has_trial(kind: &Kind) -> bool {
    matches!(kind, Kind::Kickback(_) | Kind::Flipper(_)) || switches::has_trial(kind)
}

/// What is wrong with this part's coil or switch.
pub fn try_it(machine: &Machine, reach: &Reach, part: PartId, kind: &Kind) -> Option<Finding> {
    let machine = machine.clone();
    match kind {
        Kind::Kickback(kickback) => try_kickback(machine, part, kickback),
        Kind::Flipper(flipper) => try_flipper(machine, part, flipper),
        Kind::Saucer(saucer) => {
            let keeps_it = try_saucer(machine.clone(), part, saucer);
            keeps_it.or_else(|| switches::try_it(&machine, reach, part, kind))
        }
        Kind::DropTarget(_) => match switches::closing_shot(&machine, reach, part, kind) {
            Ok(shot) => try_raise(machine, part, shot?),
            Err(finding) => Some(finding),
        },
        _ => switches::try_it(&machine, reach, part, kind),
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
    if !put_ball(&mut machine, center, DVec2::ZERO) {
        return Some(Finding::of_part(FindingKind::DoesNotKick, part, center));
    }
    wait(&mut machine, Controls::NONE, 100);
    machine.tick(Controls::NONE, &[Command::Kick(part)]);
    let throw = watch_throw(&mut machine, kickback, center);
    let kind = match throw {
        _ if throw.farthest_m <= THROWN_M => FindingKind::DoesNotKick,
        _ if throw.falls_back => FindingKind::FallsBack,
        _ => return None,
    };
    Some(Finding::of_part(kind, part, center))
}

/// What a kickback's throw comes to.
struct Throw {
    farthest_m: f64,
    /// The ball is on the face again, and has never come out of its way: so it will be thrown for ever.
    falls_back: bool,
}

/// Follows a ball that is thrown from `start` until it is out of the kickback's way, or on its face again.
fn watch_throw(machine: &mut Machine, kickback: &Kickback, start: DVec2) -> Throw {
    let mut throw = Throw { farthest_m: 0.0, falls_back: false };
    let (mut speed_m_s, mut is_out) = (0.0, false);
    for _ in 0..THROW_TICKS {
        machine.tick(Controls::NONE, &[]);
        let balls = machine.balls();
        let Some(ball) = balls.first() else { return throw };
        throw.farthest_m = throw.farthest_m.max(ball.center.distance(start));
        let from_tip = ball.center - kickback.tip;
        let (along, aside) = (from_tip.dot(kickback.direction), from_tip.dot(kickback.direction.perp()).abs());
        // What comes back from a wall comes back otherwise the next time.
        let (before_m_s, is_flying) = (speed_m_s, along > kickback.stroke_m + BALL_RADIUS_M + FACE_M);
        speed_m_s = ball.velocity.dot(kickback.direction);
        is_out |= is_flying && before_m_s - speed_m_s > BOUNCE_M_S;
        is_out |= aside > kickback.half_width_m + BALL_RADIUS_M || ball.above || ball.held;
        throw.falls_back = !is_out && throw.farthest_m > THROWN_M && along < BALL_RADIUS_M + FACE_M;
        if throw.falls_back || is_out && throw.farthest_m > THROWN_M {
            return throw;
        }
    }
    throw
}

/// A ball on the middle of the flipper is thrown away from it.
fn try_flipper(mut machine: Machine, part: PartId, flipper: &Flipper) -> Option<Finding> {
    let controls = match flipper.control {
        FlipperControl::Left => Controls { left: true, ..Controls::NONE },
        FlipperControl::Right => Controls { right: true, ..Controls::NONE },
        FlipperControl::Rules => return None,
    };
    let along = trig::direction(flipper.rest_rad);
    // A stroke that ends lower than it begins is told without play.
    if trig::direction(flipper.up_rad).y > along.y {
        return None;
    }
    // The side to which the stroke goes.
    let side = along.perp() * (flipper.up_rad - flipper.rest_rad).signum();
    let radius = 0.5 * (flipper.base.radius + flipper.tip_radius_m);
    let room = radius.max(flipper.base.radius) + BALL_RADIUS_M + GAP_M;
    let center = flipper.base.center + along * (0.6 * flipper.length_m) + side * room;
    let free = put_ball(&mut machine, center, DVec2::ZERO);
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

/// A drop target that has fallen stands up again.
fn try_raise(mut machine: Machine, part: PartId, shot: Shot) -> Option<Finding> {
    machine.put_ball(shot.place, shot.velocity, [0.0; 3]);
    wait(&mut machine, Controls::NONE, 1500);
    machine.tick(Controls::NONE, &[Command::Raise(part)]);
    wait(&mut machine, Controls::NONE, 2000);
    let stands = machine.pose().drop_targets.iter().any(|(own, height)| *own == part && *height > 0.9);
    (!stands).then(|| Finding::of_part(FindingKind::DoesNotRise, part, shot.place))
}

/// Flippers whose strokes cross, each pair once.
pub fn crossing_flippers(machine: &Machine) -> Vec<Finding> {
    let parts = machine.layout().parts.iter().enumerate();
    let flippers = parts.filter_map(|(index, part)| match &part.kind {
        Kind::Flipper(flipper) if flipper.control != FlipperControl::Rules => Some((PartId(index as u16), flipper)),
        _ => None,
    });
    let flippers: Vec<(PartId, &Flipper)> = flippers.collect();
    let pairs = flippers.iter().enumerate().flat_map(|(at, one)| flippers[..at].iter().map(move |other| (other, one)));
    let crossings = pairs.filter_map(|((part, one), (_, other))| Some((*part, crossing(one, other)?)));
    crossings.map(|(part, place)| Finding::of_part(FindingKind::FlippersCross, part, place)).collect()
}

/// Where the middle of a flipper that turns comes into another, which lies at an end of its stroke. Tips that only touch are
/// left alone.
fn crossing(one: &Flipper, other: &Flipper) -> Option<DVec2> {
    let along =
        |outline: Taper| (0..=STROKE_STEPS).map(move |step| outline.a.center.lerp(outline.b.center, part(step)));
    let meets = |turning: &Flipper, lying: &Flipper| {
        let ends = [lying.outline(lying.rest_rad), lying.outline(lying.up_rad)];
        let mut places = sweep(turning).into_iter().flat_map(along);
        places.find(|place| ends.iter().any(|outline| outline.distance(*place).0 < 0.0))
    };
    meets(one, other).or_else(|| meets(other, one))
}

/// A flipper's outlines from rest to the end of its stroke.
fn sweep(flipper: &Flipper) -> Vec<Taper> {
    let angle = |step: i32| flipper.rest_rad + (flipper.up_rad - flipper.rest_rad) * part(step);
    (0..=STROKE_STEPS).map(|step| flipper.outline(angle(step))).collect()
}

fn part(step: i32) -> f64 {
    f64::from(step) / f64::from(STROKE_STEPS)
}
