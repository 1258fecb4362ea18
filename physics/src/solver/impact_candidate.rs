//! Impact candidate: the earliest time of impact in what is left of a step, over all balls and all that they can hit.

use crate::collision::time_of_impact::{
    Impact, MIN_APPROACH_M_S, StraightPath, TOUCH_M, TurningOutline, are_far_apart, ball_time_of_impact, cast,
    turning_time_of_impact,
};
use crate::solver::clearance;
use crate::solver::step::Step;
use geometry::{DVec2, Ray};

/// What a ball is about to hit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Collider {
    Obstacle(usize),
    Rod(usize),
    Flipper(usize),
    Ball(usize),
}

/// An impact that comes first unless another comes before it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ImpactCandidate {
    /// From now, s.
    pub time: f64,
    pub ball: usize,
    pub collider: Collider,
    /// The unit normal from the collider to the ball.
    pub normal: DVec2,
}

/// The first impact in what is `left` of the step.
pub(crate) fn first(step: &mut Step, left: f64) -> Option<ImpactCandidate> {
    let mut means = std::mem::take(&mut step.buffers.mean_velocities);
    means.clear();
    means.extend((0..step.state.balls.len()).map(|ball| step.mean_velocity(ball, left)));
    let near = step.buffers.near_balls.hold(&step.state.balls, &means, left);
    let first = first_on_paths(step, &means, left, near);
    debug_assert!(!near || first == first_on_paths(step, &means, left, false), "the slow twin finds another impact");
    step.buffers.mean_velocities = means;
    first
}

/// `near` says that only the balls near each other are to be asked, not every pair.
fn first_on_paths(step: &Step, means: &[DVec2], left: f64, near: bool) -> Option<ImpactCandidate> {
    let travel = clearance::flipper_travel(step, left);
    let mut first: Option<ImpactCandidate> = None;
    for (ball, own) in step.state.balls.iter().enumerate().filter(|(_, ball)| !ball.is_held()) {
        let mut offer = |time: f64, collider: Collider, normal: DVec2| {
            if time <= left && first.is_none_or(|first| time < first.time) {
                first = Some(ImpactCandidate { time, ball, collider, normal });
            }
        };
        let path = StraightPath { center: own.center, velocity: means[ball], duration: left };
        let clear = clearance::clear_of(step, ball, path.velocity.length() * left, travel);
        if !clear.obstacles {
            offer_obstacles(step, own.ramp, &path, &mut offer);
        }
        if !clear.mechanisms && !own.is_up() {
            offer_rods(step, &path, &mut offer);
            offer_flippers(step, &path, &mut offer);
        }
        let mut meet = |other| offer_ball(step, (ball, &path), (other, means[other]), &mut offer);
        if near {
            step.buffers.near_balls.of(ball).for_each(&mut meet);
        } else {
            (0..means.len()).for_each(&mut meet);
        }
    }
    first
}

/// Each pair of balls meets once, from the ball that comes first, or from the one that is not held.
fn offer_ball(
    step: &Step,
    (ball, path): (usize, &StraightPath),
    (other, mean): (usize, DVec2),
    offer: &mut impl FnMut(f64, Collider, DVec2),
) {
    let (own, met) = (&step.state.balls[ball], &step.state.balls[other]);
    if other < ball && !met.is_held() || other == ball {
        return;
    }
    let (offset, velocity) = (path.center - met.center, path.velocity - mean);
    if are_far_apart(offset, velocity.length_squared() * path.duration * path.duration) || own.passes(met) {
        return;
    }
    if let Some(Impact { time, normal }) = ball_time_of_impact(offset, velocity) {
        offer(time, Collider::Ball(other), normal);
    }
}

fn offer_obstacles(step: &Step, ramp: Option<u16>, path: &StraightPath, offer: &mut impl FnMut(f64, Collider, DVec2)) {
    let &StraightPath { center, velocity, duration } = path;
    let speed = velocity.length();
    if speed < MIN_APPROACH_M_S {
        return;
    }
    let ray = Ray { origin: center, direction: velocity / speed };
    step.model.collision.visit_obstacles(ramp, center, center + velocity * duration, |index| {
        let obstacle = &step.model.collision.obstacles[index];
        let (distance, normal) = obstacle.shape.distance(center);
        if distance > speed * duration || !step.state.is_solid(step.model, obstacle, path, distance) {
            return;
        }
        if let Some((along, normal)) = cast(obstacle, &ray, distance, normal, speed) {
            offer(along / speed, Collider::Obstacle(index), normal);
        }
    });
}

/// A rod goes along its own line without turning, so in its frame the ball meets a face that stands still.
fn offer_rods(step: &Step, path: &StraightPath, offer: &mut impl FnMut(f64, Collider, DVec2)) {
    let &StraightPath { center, velocity, duration } = path;
    for (index, model) in step.model.mechanisms.rods.iter().enumerate() {
        let rod = &step.state.mechanisms.rods[index];
        let (face, closing) = (model.face(rod), velocity - model.velocity(rod));
        let (distance, normal) = face.distance(center);
        let speed = closing.length();
        if distance <= speed * duration && speed > MIN_APPROACH_M_S {
            if distance <= TOUCH_M {
                if closing.dot(normal) < -MIN_APPROACH_M_S {
                    offer(0.0, Collider::Rod(index), normal);
                }
            } else if let Some(hit) = face.cast(&Ray { origin: center, direction: closing / speed }) {
                offer(hit.distance / speed, Collider::Rod(index), hit.normal);
            }
        }
    }
}

fn offer_flippers(step: &Step, path: &StraightPath, offer: &mut impl FnMut(f64, Collider, DVec2)) {
    for (index, model) in step.model.mechanisms.flippers.iter().enumerate() {
        if model.is_out_of_reach(path.center, path.velocity.length() * path.duration) {
            continue;
        }
        let own = &step.state.mechanisms.flippers[index];
        let turning = TurningOutline {
            pivot: model.pivot(),
            outline: |angle| model.outline(angle),
            angle: own.angle,
            angular_velocity: own.speed,
        };
        if let Some(Impact { time, normal }) = turning_time_of_impact(&turning, path) {
            offer(time, Collider::Flipper(index), normal);
        }
    }
}
