//! A ball that is let go where one can come to: whether it comes away by itself, and stays on the playfield.

use super::finding::{Finding, FindingKind};
use super::{THROWN_M, USUAL_BURDEN, burden, farthest, is_on, put_ball, wait};
use geometry::DVec2;
use physics::{BALL_RADIUS_M, BallPose, Command, Controls, FlipperControl, Kind, Machine};

/// A ball that has lain still for so long is stuck, ticks.
const STUCK_TICKS: u32 = 3000;
/// So often the ball search fires every coil. A ball that hops out over a switch and falls back starts it anew: it would never
/// give the ball up.
const SEARCHES: usize = 3;
/// By then the slowest has drained or is held by what may hold it.
const MOST_TICKS: usize = 20_000;
/// Contact solves that it may take until then.
const MOST_CONTACT_SOLVES: u64 = 400_000;
/// Contact solves that it may take while it lies still: up to 300 in a tick where nothing else touches.
const MOST_LYING_SOLVES: u64 = 1_000_000;
/// Ticks between two looks.
const LOOK_TICKS: usize = 50;
/// A ball no farther from a flipper lies on it: the player throws it when he likes, m.
const FLIPPER_RANGE_M: f64 = 0.001;
/// The player tries so often to throw it.
const STROKES: usize = 3;
/// How long the buttons are held, and then not held, ticks.
const STROKE_TICKS: u32 = 300;
/// A ball no farther from a kickback's face waits for it, m.
const KICKBACK_RANGE_M: f64 = 0.002;

/// What becomes of the ball, if it is worth telling.
pub fn let_go(machine: &Machine, place_m: DVec2) -> Option<Finding> {
    let mut machine = machine.clone();
    if !put_ball(&mut machine, place_m, DVec2::ZERO) {
        return None; // a flipper or a drop target lies there
    }
    let layout = machine.layout().clone();
    let mut freed = None;
    for search in 0..=SEARCHES {
        let ball = match watch(&mut machine) {
            Fate::LiesStill(ball) => ball,
            Fate::Gone => return freed,
            Fate::Lost => return Some(Finding::near(FindingKind::NotANumber, &layout, place_m, false)),
            Fate::Escaped(ball) => return Some(Finding::near(FindingKind::Escaped, &layout, ball.center, ball.above)),
        };
        if search == SEARCHES {
            return Some(Finding::near(FindingKind::Stuck, &layout, ball.center, ball.above));
        }
        freed.get_or_insert(Finding::near(FindingKind::FreedBySearch, &layout, ball.center, ball.above));
        machine.tick(Controls::NONE, &[Command::BallSearch]);
        wait(&mut machine, Controls::NONE, STUCK_TICKS);
    }
    freed
}

/// What becomes of a ball.
enum Fate {
    /// It has drained, is held by what may hold it, or is watched no longer.
    Gone,
    LiesStill(BallPose),
    Escaped(BallPose),
    /// Where it is cannot be told.
    Lost,
}

/// Plays until the ball has lain still for long.
fn watch(machine: &mut Machine) -> Fate {
    let (mut solves, mut lying_solves) = (0, 0);
    // On a table with much that moves a ball is watched for a shorter time.
    for tick in 0..MOST_TICKS * USUAL_BURDEN / burden(machine).max(USUAL_BURDEN) {
        machine.tick(Controls::NONE, &[]);
        let lies = machine.stuck_ticks().iter().any(|&ticks| ticks > 0);
        *(if lies { &mut lying_solves } else { &mut solves }) += machine.contact_solves();
        if solves > MOST_CONTACT_SOLVES || lying_solves > MOST_LYING_SOLVES {
            return Fate::Gone; // it takes too long to see what becomes of it
        }
        if tick % LOOK_TICKS != 0 {
            continue;
        }
        let balls = machine.balls();
        let Some(&ball) = balls.first() else { return Fate::Gone };
        if !(ball.center.is_finite() && ball.velocity.is_finite()) {
            return Fate::Lost;
        }
        if !is_on(machine, ball.center) {
            return Fate::Escaped(ball);
        }
        if machine.stuck_ticks().iter().all(|&ticks| ticks < STUCK_TICKS) {
            continue;
        }
        let waits = waits_for_kickback(machine, ball.center) || is_thrown_by_flipper(machine, ball.center);
        return if waits { Fate::Gone } else { Fate::LiesStill(ball) };
    }
    Fate::Gone
}

/// Whether the ball lies on a flipper that has a button, and the player can throw it from there: in a pocket behind the
/// flipper's base he cannot.
fn is_thrown_by_flipper(machine: &Machine, center: DVec2) -> bool {
    if !lies_on_flipper(machine, center) {
        return false;
    }
    let mut machine = machine.clone();
    let both = Controls { left: true, right: true, ..Controls::NONE };
    let strokes = [both, Controls::NONE].into_iter().cycle().take(2 * STROKES);
    strokes.into_iter().any(|controls| farthest(&mut machine, controls, center, STROKE_TICKS) > THROWN_M)
}

/// Whether the ball lies on a flipper that has a button.
fn lies_on_flipper(machine: &Machine, center: DVec2) -> bool {
    machine.pose().flippers_rad.iter().any(|&(part, angle_rad)| {
        match &machine.layout().parts[usize::from(part.0)].kind {
            Kind::Flipper(own) if own.control != FlipperControl::Rules => {
                own.outline(angle_rad).distance(center).0 < BALL_RADIUS_M + FLIPPER_RANGE_M
            }
            _ => false,
        }
    })
}

/// Whether the ball lies on a kickback, which throws it when the rules say so.
fn waits_for_kickback(machine: &Machine, center: DVec2) -> bool {
    machine.layout().parts.iter().any(|part| match &part.kind {
        Kind::Kickback(own) => {
            let from_tip = center - own.tip;
            let along = from_tip.dot(own.direction);
            let aside = from_tip.dot(own.direction.perp()).abs();
            along < BALL_RADIUS_M + KICKBACK_RANGE_M && along > 0.0 && aside < own.half_width_m + BALL_RADIUS_M
        }
        _ => false,
    })
}
