//! Clearance cache: how far away everything but other balls is at least from each ball, so that nothing is asked again
//! at every substep.

use crate::ball::Ball;
use crate::mechanisms::model::{Model, State};
use crate::solver::step::Step;
use crate::{BALL_RADIUS_M, TICK_S};
use geometry::DVec2;

/// How far is looked, m: a ball hardly goes farther in a tick.
const HORIZON_M: f64 = 0.01;
/// Far above rounding and above what counts as touching, far below anything else, m.
const CLEARANCE_ROUNDING_M: f64 = 1e-7;

/// Where a ball was at the start of a tick, and the clearance that it had there.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Clearance {
    center: DVec2,
    /// No obstacle is nearer to touching than this, m.
    obstacles: f64,
    /// No rod comes nearer in the tick, and no flipper was nearer, m.
    mechanisms: f64,
}

/// What a ball is known to be clear of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct ClearOf {
    /// All obstacles.
    pub obstacles: bool,
    /// Rods and flippers.
    pub mechanisms: bool,
}

impl Clearance {
    /// The clearance of a ball, looked for up to [`HORIZON_M`].
    fn of_ball(model: &Model, state: &State, ball: &Ball) -> Clearance {
        let rods = model.mechanisms.rods.iter().zip(&state.mechanisms.rods);
        let rods = rods.map(|(model, rod)| model.face(rod).distance(ball.center).0 - rod.speed.abs() * TICK_S);
        Clearance {
            center: ball.center,
            obstacles: obstacle_distance(model, ball, HORIZON_M).min(HORIZON_M),
            mechanisms: rods.fold(HORIZON_M, f64::min).min(flipper_distance(model, state, ball)),
        }
    }

    /// What is not within `reach` of touching a ball that is at `center` now, when no flipper has moved or will move by
    /// more than `travel`, m.
    fn clear_of(&self, center: DVec2, reach: f64, travel: f64) -> ClearOf {
        let moved = center.distance_squared(self.center);
        let holds = |room: f64| room > 0.0 && moved < room * room;
        let obstacles = self.obstacles - reach - CLEARANCE_ROUNDING_M;
        let mechanisms = self.mechanisms - reach - travel - CLEARANCE_ROUNDING_M;
        ClearOf { obstacles: holds(obstacles), mechanisms: holds(mechanisms) }
    }
}

/// How far the nearest obstacle is from touching a ball, if that is up to `horizon`.
fn obstacle_distance(model: &Model, ball: &Ball, horizon: f64) -> f64 {
    let mut nearest = f64::INFINITY;
    model.collision.visit_obstacles(ball.ramp, ball.center - horizon, ball.center + horizon, |index| {
        nearest = nearest.min(model.collision.obstacles[index].shape.distance(ball.center).0);
    });
    nearest
}

/// How far the nearest flipper is from touching a ball; only roughly, and never too far, where that is far.
fn flipper_distance(model: &Model, state: &State, ball: &Ball) -> f64 {
    let flippers = model.mechanisms.flippers.iter().zip(&state.mechanisms.flippers).map(|(model, flipper)| {
        let least = ball.center.distance(model.pivot()) - model.reach;
        let near = least < HORIZON_M + BALL_RADIUS_M;
        let distance = if near { model.outline(flipper.angle).distance(ball.center).0 } else { least };
        distance - BALL_RADIUS_M
    });
    flippers.fold(f64::INFINITY, f64::min)
}

/// Measures the clearance of every ball, for all the substeps of a tick.
pub(crate) fn measure(step: &mut Step) {
    let (model, state) = (step.model, &*step.state);
    step.buffers.clearances.extend(state.balls.iter().map(|ball| Clearance::of_ball(model, state, ball)));
    step.buffers.flipper_angles.extend(state.mechanisms.flippers.iter().map(|flipper| flipper.angle));
}

/// How far any flipper's outline has moved since the clearances were measured, or will have in a further `time`, m.
pub(crate) fn flipper_travel(step: &Step, time: f64) -> f64 {
    let flippers = step.state.mechanisms.flippers.iter().zip(&step.buffers.flipper_angles);
    let turns = flippers.map(|(flipper, start)| (flipper.angle - start).abs() + flipper.speed.abs() * time);
    turns.zip(&step.model.mechanisms.flippers).map(|(turn, model)| turn * model.reach).fold(0.0, f64::max)
}

/// What a ball is known to be farther from touching than `reach`, for flippers that `travel`.
pub(crate) fn clear_of(step: &Step, ball: usize, reach: f64, travel: f64) -> ClearOf {
    let own = &step.state.balls[ball];
    let nothing = ClearOf { obstacles: false, mechanisms: false };
    let clearance = step.buffers.clearances.get(ball);
    let clear = clearance.map_or(nothing, |clearance| clearance.clear_of(own.center, reach, travel));
    debug_assert!(is_clear(step, own, reach, clear), "the slow twin finds something at {}", own.center);
    clear
}

/// The slow twin of [`Clearance`]: whether everything that a ball is said to be clear of is farther than `reach`.
fn is_clear(step: &Step, ball: &Ball, reach: f64, clear: ClearOf) -> bool {
    let (model, state) = (step.model, &*step.state);
    let mut rods = model.mechanisms.rods.iter().zip(&state.mechanisms.rods);
    let rods = rods.all(|(model, rod)| model.face(rod).distance(ball.center).0 > reach);
    (!clear.obstacles || obstacle_distance(model, ball, reach) > reach)
        && (!clear.mechanisms || (rods && flipper_distance(model, state, ball) > reach))
}
