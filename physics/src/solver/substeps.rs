//! Substeps: how a tick is cut into steps, and which flippers turn apart from the balls.
//!
//! A tick is one step, but where a flipper moves near a ball: there the flipper's bend away from its straight path in a
//! step must stay below what is seen.

use crate::ball::Ball;
use crate::ball::ball_step::BallStep;
use crate::mechanisms;
use crate::mechanisms::flipper_model::{FINE_SUBSTEPS, FlipperModel, FlipperState};
use crate::mechanisms::model::{Model, State};
use crate::solver::clearance;
use crate::solver::step::{self, Step};
use crate::{BALL_RADIUS_M, TICK_S};
use geometry::DVec2;

/// How much faster than at the tick's start a ball and a flipper may become within the tick: another ball, a kicker and
/// the coil may see to that.
const SPEED_MARGIN: f64 = 2.0;
/// What a ball may go beside that in a tick, m: a ball that lies still and is hit at 6 m/s.
const PATH_MARGIN_M: f64 = 6e-3;

/// What a tick starts with.
pub(crate) struct TickInput {
    /// For each flipper whether its coil is on.
    pub coils: Vec<bool>,
    /// Gravity down the slope, less the cabinet's acceleration, m/s^2.
    pub external: DVec2,
    /// Least number of substeps: 1 in play.
    pub min_substeps: u32,
}

/// For each flipper whether it turns apart from the balls.
pub(crate) struct Schedule {
    pub detached: Vec<bool>,
    pub substeps: u32,
}

/// A flipper that moves where no ball can come to turns alone; the others turn in the steps of the balls.
pub(crate) fn schedule(model: &Model, state: &State, input: &TickInput) -> Schedule {
    let flippers = &model.mechanisms.flippers;
    let mut detached = vec![false; flippers.len()];
    let mut substeps = 1;
    for (index, (flipper, own)) in flippers.iter().zip(&state.mechanisms.flippers).enumerate() {
        if flipper.will_move(own, input.coils[index], TICK_S) {
            detached[index] = !state.balls.iter().any(|ball| may_reach(flipper, own, ball));
            substeps = if detached[index] { substeps } else { substeps.max(flipper.substeps(own)) };
        }
    }
    Schedule { detached, substeps: input.min_substeps.max(substeps) }
}

/// Whether a ball can come to where the flipper may be within the tick.
fn may_reach(flipper: &FlipperModel, own: &FlipperState, ball: &Ball) -> bool {
    let path = SPEED_MARGIN * ball.velocity.length() * TICK_S + PATH_MARGIN_M;
    if ball.is_held() || ball.is_up() || flipper.is_out_of_reach(ball.center, path) {
        return false;
    }
    let turn = (SPEED_MARGIN * own.speed.abs() + flipper.max_acceleration(own) * TICK_S) * TICK_S;
    flipper.outline(own.angle).distance(ball.center).0 < BALL_RADIUS_M + path + turn * flipper.reach
}

/// Turns the detached flippers for the whole tick.
pub(crate) fn turn_detached(model: &Model, state: &mut State, input: &TickInput, schedule: &Schedule) {
    let duration = TICK_S / f64::from(FINE_SUBSTEPS);
    for (index, flipper) in model.mechanisms.flippers.iter().enumerate().filter(|&(index, _)| schedule.detached[index])
    {
        let own = &mut state.mechanisms.flippers[index];
        for _ in 0..FINE_SUBSTEPS {
            flipper.drive(own, input.coils[index], duration);
            own.advance(duration);
            flipper.end_step(own);
        }
    }
}

/// Moves balls, rods and the other flippers for a tick.
pub(crate) fn run(step: &mut Step, input: &TickInput, substeps: u32) {
    let duration = TICK_S / f64::from(substeps);
    step.buffers.clearances.clear();
    step.buffers.flipper_angles.clear();
    if substeps > 1 {
        clearance::measure(step);
    }
    for index in 0..substeps {
        for (flipper, model) in step.model.mechanisms.flippers.iter().enumerate() {
            if !step.detached[flipper] {
                model.drive(&mut step.state.mechanisms.flippers[flipper], input.coils[flipper], duration);
            }
        }
        start_ball_steps(step, input.external, duration);
        step.elapsed = f64::from(index) * duration;
        step::advance(step, duration);
    }
}

/// What acts on each ball in this step.
fn start_ball_steps(step: &mut Step, external: DVec2, duration: f64) {
    let (model, ball_steps) = (step.model, &mut step.buffers.ball_steps);
    ball_steps.clear();
    ball_steps.resize(step.state.balls.len(), BallStep::new(external, model.floor));
    for (ball, ball_step) in step.state.balls.iter().zip(ball_steps) {
        mechanisms::apply_forces(model, step.state, ball, duration, ball_step);
    }
}
