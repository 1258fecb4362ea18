//! Simultaneous impacts: balls that are jammed find their common speeds at once.
//!
//! Impact after impact would find them too, but in a narrow wedge it takes thousands, each no time after the last,
//! and time would not go on (Zeno's paradox; Johansson, Egerstedt, Lygeros and Sastry, On the regularization of Zeno
//! hybrid automata, 1999). So all approaches are ended together, without a bounce: each velocity goes to the nearest that
//! its contacts allow, its projection onto their cone (Moreau, Unilateral contact and dry friction in finite freedom
//! dynamics, 1988).

use crate::solver::contact_constraint::{ContactBody, ContactConstraint};
use crate::solver::step::{Step, StepBuffers};
use geometry::DVec2;

/// Rounds between the balls, at most; each is exact for what does not move.
const MAX_ROUNDS: usize = 64;
/// A round that changes no speed by more than this was the last, m/s.
const ROUND_TOLERANCE_M_S: f64 = 1e-10;
/// A speed below this is no approach, m/s.
const ROUNDING_M_S: f64 = 1e-12;

/// A half-plane of velocities: a ball that touches a wall must go along `normal` at `least`, m/s, or faster.
#[derive(Clone, Copy, Debug)]
struct HalfPlane {
    normal: DVec2,
    least: f64,
}

/// Ends every approach in all contacts, without a bounce; the balls' step accelerations for what is `left` of the step
/// go into that at once.
pub(crate) fn solve(step: &mut Step, left: f64) {
    for at in 0..step.buffers.constraints.len() {
        let ContactConstraint { ball, body, .. } = step.buffers.constraints[at];
        accelerate_at_once(step, ball, left);
        if let ContactBody::Ball(other) = body {
            accelerate_at_once(step, other, left);
        }
    }
    let walls: Vec<Vec<HalfPlane>> = (0..step.state.balls.len()).map(|ball| walls_of(step.buffers, ball)).collect();
    let (buffers, mut bodies) = step.split();
    for _ in 0..MAX_ROUNDS {
        buffers.contact_solves += buffers.constraints.len() as u64;
        let mut change: f64 = 0.0;
        let moving = |constraint: &&mut ContactConstraint| !matches!(constraint.body, ContactBody::Fixed(_));
        for constraint in buffers.constraints.iter_mut().filter(moving) {
            constraint.release();
            change = change.max(constraint.solve_normal(&mut bodies, 0.0));
        }
        for (ball, walls) in bodies.balls.iter_mut().zip(&walls) {
            let free = nearest(ball.velocity, walls);
            change = change.max((free - ball.velocity).length());
            ball.velocity = free;
        }
        if change < ROUND_TOLERANCE_M_S {
            break;
        }
    }
}

fn accelerate_at_once(step: &mut Step, ball: usize, left: f64) {
    let ball_step = &mut step.buffers.ball_steps[ball];
    let acceleration = std::mem::take(&mut ball_step.acceleration);
    ball_step.resting = true;
    step.state.balls[ball].velocity += acceleration.linear * left;
    step.state.balls[ball].spin += acceleration.angular * left;
}

fn walls_of(buffers: &StepBuffers, ball: usize) -> Vec<HalfPlane> {
    let own = buffers.constraints.iter().filter(|constraint| constraint.ball == ball);
    let wall = |constraint: &ContactConstraint| match constraint.body {
        ContactBody::Fixed(velocity) => {
            Some(HalfPlane { normal: constraint.normal, least: velocity.dot(constraint.normal) })
        }
        _ => None,
    };
    own.filter_map(wall).collect()
}

/// The velocity nearest to `velocity` that leads into no wall: itself, along a wall, or the corner of two.
fn nearest(velocity: DVec2, walls: &[HalfPlane]) -> DVec2 {
    let is_free = |velocity: DVec2| walls.iter().all(|wall| velocity.dot(wall.normal) >= wall.least - ROUNDING_M_S);
    if is_free(velocity) {
        return velocity;
    }
    let along = |wall: &HalfPlane| velocity + wall.normal * (wall.least - velocity.dot(wall.normal));
    let corner = |a: &HalfPlane, b: &HalfPlane| {
        let turn = a.normal.perp_dot(b.normal);
        let meet = (b.normal.perp() * -a.least + a.normal.perp() * b.least) / turn;
        meet.is_finite().then_some(meet)
    };
    let corners =
        walls.iter().enumerate().flat_map(|(index, a)| walls[..index].iter().filter_map(move |b| corner(a, b)));
    let all = walls.iter().map(along).chain(corners).filter(|velocity| is_free(*velocity));
    all.min_by(|a, b| a.distance_squared(velocity).total_cmp(&b.distance_squared(velocity))).unwrap_or(DVec2::ZERO)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn wall(x: f64, y: f64, least: f64) -> HalfPlane {
        HalfPlane { normal: DVec2::new(x, y).normalize(), least }
    }

    #[test]
    fn a_velocity_is_turned_aside_by_a_wall_and_ended_by_a_corner() {
        let down = DVec2::new(1.0, 2.0);
        let floor = wall(0.0, -1.0, 0.0);
        assert_eq!(nearest(DVec2::new(1.0, -2.0), &[floor]), DVec2::new(1.0, -2.0));
        assert!(nearest(down, &[floor]).distance(DVec2::new(1.0, 0.0)) < 1e-12);
        assert!(nearest(down, &[wall(1.0, -0.1, 0.0), wall(-1.0, -0.1, 0.0)]).length() < 1e-12);
        let moving = [wall(1.0, 0.0, 3.0), wall(0.0, -1.0, -0.5)];
        assert!(nearest(down, &moving).distance(DVec2::new(3.0, 0.5)) < 1e-12);
        let lifted = [wall(1.0, -0.1, 0.0), wall(-1.0, -0.1, 0.2)];
        let up = nearest(down, &lifted);
        assert!(lifted.iter().all(|wall| (up.dot(wall.normal) - wall.least).abs() < 1e-12), "{up}");
    }
}
