//! Plan search: what to do with the flippers: a few plans are tried in rollouts, and the best is taken.

use super::input_queue::ButtonChange;
use super::rollout::Rollout;
use crate::Buttons;
use physics::BallPose;
use std::cmp::Ordering;

/// Ticks that a flipper is held up in a stroke.
const STROKE_TICKS: u64 = 130;
/// Ticks between two moments at which a stroke is tried.
const TRY_TICKS: u64 = 9;
/// Moments that are tried for each flipper at first, while the ball is coming.
const TRIES: usize = 6;
/// Moments that are tried at first when the ball lies still and there is time to aim.
const AIMED_TRIES: usize = 12;
/// Moments whose neighbours are tried, too.
const SECOND_LOOKS: usize = 2;
/// Most moments that are remembered in one decision.
const MOMENTS: usize = 90;
/// How long the ball's way to the flippers and over them is followed.
const APPROACH_TICKS: u64 = 650;
/// How much longer a ball that comes near no flipper on its way down is followed, until it is settled what becomes of it.
const SETTLE_TICKS: u64 = 900;
/// How long a stroke's result is followed.
const RESULT_TICKS: u64 = 520;
/// How long it is followed to see whether a ball comes to rest on a raised flipper.
const TRAP_TICKS: u64 = 900;
/// Ticks that are followed after something was hit, to see where the ball goes.
const AFTER_HIT_TICKS: u64 = 120;

/// What was decided.
pub(super) struct Plan {
    /// What the hands do.
    pub moves: Vec<ButtonChange>,
    /// How good the bot thinks it is.
    pub value: f64,
}

/// The best plan that begins at `start`, the earliest moment at which the hands can obey. `may_hold`: waiting with a raised
/// flipper is a plan.
pub(super) fn best(start: &Rollout, may_hold: bool) -> Plan {
    let mut plans = Vec::new();
    let (release, branches) = release(start);
    plans.push(release);
    plans.extend(strokes(start, &branches, if may_hold { TRIES } else { AIMED_TRIES }));
    if may_hold {
        plans.extend([Buttons::LEFT, Buttons::RIGHT].map(|side| hold(start, side)));
    }
    let nothing = Plan { moves: Vec::new(), value: f64::MIN };
    plans.into_iter().fold(nothing, |best, plan| if plan.value > best.value { plan } else { best })
}

/// The best push of the cabinet that saves a ball that is lost otherwise, if any does.
pub(super) fn best_nudge(start: &Rollout) -> Option<Plan> {
    let pushes = [Buttons::NUDGE_LEFT, Buttons::NUDGE_RIGHT, Buttons::NUDGE_UP, Buttons::NUDGE_DOWN];
    let plans = pushes.into_iter().flat_map(|push| [0, 50, 110].map(|wait| nudge(start, push, wait)));
    plans.filter(|plan| plan.value > 0.0).reduce(|best, plan| if plan.value > best.value { plan } else { best })
}

/// The flippers' two buttons.
const BOTH: Buttons = Buttons(Buttons::LEFT.0 | Buttons::RIGHT.0);

/// Lets go of both flippers; also gives the moments on the way at which a stroke would meet a ball.
fn release<'a>(start: &Rollout<'a>) -> (Plan, Vec<(Buttons, Rollout<'a>)>) {
    let mut rollout = start.clone();
    rollout.set(BOTH, false);
    let mut branches = Vec::new();
    while rollout.tick < start.tick + APPROACH_TICKS && rollout.lost == 0 && branches.len() < MOMENTS {
        let balls = rollout.balls();
        for side in sides_in_reach(&rollout, &balls) {
            branches.push((side, rollout.clone()));
        }
        if !branches.is_empty() && balls.iter().all(|ball| leaves(&rollout, ball)) {
            break;
        }
        rollout.play(TRY_TICKS, |_| false);
    }
    if branches.is_empty() {
        rollout.play(SETTLE_TICKS, |rollout| rollout.settled());
    }
    rollout.mark_lost();
    let moves = vec![ButtonChange { tick: start.tick, buttons: BOTH, down: false }];
    (Plan { moves, value: rollout.value() }, branches)
}

/// The sides whose flippers could strike a ball now.
fn sides_in_reach(rollout: &Rollout, balls: &[BallPose]) -> impl Iterator<Item = Buttons> {
    let reach = |left| {
        let mut flippers = rollout.zones().flippers.iter().filter(move |flipper| flipper.left == left);
        flippers.any(|flipper| balls.iter().any(|ball| flipper.reaches(ball.center)))
    };
    let sides = [(Buttons::LEFT, reach(true)), (Buttons::RIGHT, reach(false))];
    sides.into_iter().filter(|(_, reached)| *reached).map(|(side, _)| side)
}

/// A ball that goes up again and is out of reach.
fn leaves(rollout: &Rollout, ball: &BallPose) -> bool {
    ball.velocity.y < -0.3 && rollout.zones().in_reach(ball.center).is_none()
}

/// The most promising strokes at these moments.
fn strokes(start: &Rollout, branches: &[(Buttons, Rollout)], tries: usize) -> Vec<Plan> {
    let mut plans = Vec::new();
    for side in [Buttons::LEFT, Buttons::RIGHT] {
        let moments: Vec<&Rollout> =
            branches.iter().filter(|(of, _)| *of == side).map(|(_, rollout)| rollout).collect();
        let step = moments.len().div_ceil(tries).max(1);
        let mut values: Vec<Option<f64>> = vec![None; moments.len()];
        for index in (0..moments.len()).step_by(step) {
            values[index] = Some(stroke_value(moments[index], side));
        }
        let mut tried: Vec<usize> = (0..moments.len()).step_by(step).collect();
        tried.sort_by(|a, b| values[*b].partial_cmp(&values[*a]).unwrap_or(Ordering::Equal));
        for index in tried.into_iter().take(SECOND_LOOKS) {
            let value = steady_value(&moments, &mut values, index, side);
            plans.push(Plan { moves: stroke(start.tick, moments[index].tick, side), value });
        }
    }
    plans
}

/// What a stroke at this moment is worth to a hand that is not exact: its neighbours count, too.
fn steady_value(moments: &[&Rollout], values: &mut [Option<f64>], index: usize, side: Buttons) -> f64 {
    let mut value = |at: Option<usize>| {
        let at = at.filter(|at| *at < moments.len())?;
        Some(*values[at].get_or_insert_with(|| stroke_value(moments[at], side)))
    };
    let own = value(Some(index)).unwrap_or(0.0);
    // Beyond the first or the last moment a stroke misses the ball.
    let beyond = own - 5.0;
    let early = value(index.checked_sub(1)).unwrap_or(beyond);
    let late = value(Some(index + 1)).unwrap_or(beyond);
    0.5 * own + 0.25 * (early + late)
}

/// What comes of a stroke that begins here.
fn stroke_value(moment: &Rollout, side: Buttons) -> f64 {
    let mut rollout = moment.clone();
    rollout.set(side, true);
    rollout.play(STROKE_TICKS, |rollout| rollout.lost > 0);
    rollout.set(side, false);
    let mut enough_at = None;
    rollout.play(RESULT_TICKS, |rollout| {
        if rollout.gained > 0.0 && enough_at.is_none() {
            enough_at = Some(rollout.tick + AFTER_HIT_TICKS);
        }
        rollout.lost > 0 || rollout.caught || enough_at.is_some_and(|tick| rollout.tick >= tick)
    });
    rollout.mark_lost();
    rollout.value()
}

/// Lets go of both flippers at `from`, strikes with one at `at`, and lets go again.
fn stroke(from: u64, at: u64, side: Buttons) -> Vec<ButtonChange> {
    vec![
        ButtonChange { tick: from, buttons: BOTH, down: false },
        ButtonChange { tick: at, buttons: side, down: true },
        ButtonChange { tick: at + STROKE_TICKS, buttons: side, down: false },
    ]
}

/// Holds one flipper up, to trap the ball.
fn hold(start: &Rollout, side: Buttons) -> Plan {
    let mut rollout = start.clone();
    rollout.set(BOTH, false);
    rollout.set(side, true);
    rollout.play(TRAP_TICKS, |rollout| rollout.lost > 0 || rollout.cradled || rollout.caught);
    rollout.mark_lost();
    let other = Buttons(BOTH.0 & !side.0);
    let moves = vec![
        ButtonChange { tick: start.tick, buttons: other, down: false },
        ButtonChange { tick: start.tick, buttons: side, down: true },
    ];
    Plan { moves, value: rollout.value() }
}

/// Pushes the cabinet after `wait` ticks.
fn nudge(start: &Rollout, push: Buttons, wait: u64) -> Plan {
    const PUSH_TICKS: u64 = 40;
    let mut rollout = start.clone();
    rollout.play(wait, |_| false);
    let at = rollout.tick;
    rollout.set(push, true);
    rollout.play(PUSH_TICKS, |_| false);
    rollout.set(push, false);
    rollout.play(TRAP_TICKS + SETTLE_TICKS, |rollout| rollout.settled());
    rollout.mark_lost();
    let value = if rollout.lost > 0 { -1.0 } else { 1.0 + rollout.value() };
    let moves = vec![
        ButtonChange { tick: at, buttons: push, down: true },
        ButtonChange { tick: at + PUSH_TICKS, buttons: push, down: false },
    ];
    Plan { moves, value }
}
