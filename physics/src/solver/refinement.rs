//! Refinement of the time of impact, once it is known what hits what: where both are then, and how fast.
//!
//! Refuses to know what happens then.

use crate::BALL_RADIUS_M;
use crate::solver::impact_candidate::{Collider, ImpactCandidate};
use crate::solver::step::{RESTITUTION_THRESHOLD_M_S, Step, StepTime};
use geometry::DVec2;

/// Farther than this from where it seemed to be, m, an impact was no impact on the straight path either. The true path
/// bends away by `a t^2 / 8`: in a tick a quarter of a micron at the 2 m/s^2 of gravity and friction, this at 16 m/s^2.
const MAX_BEND_M: f64 = 2e-6;
/// Steps of Newton's method: the gap is so straight in time that the second only mends rounding.
const NEWTON_STEPS: usize = 2;
/// A firm impact: its approach is so many times what the flipper's speed can differ from its mean by.
const FIRM_IMPACT: f64 = 4.0;

/// How two bodies are to each other.
#[derive(Clone, Copy, Debug)]
struct Gap {
    /// m.
    distance: f64,
    /// From the collider to the ball.
    normal: DVec2,
    /// Speed of approach along the normal, m/s.
    closing: f64,
}

/// The candidate at its true time of impact.
///
/// It was found on a straight path with the mean velocity of what is left of the step. The true path bends, so at that
/// time a gap is left; Newton's method closes it, `t += gap / closing`.
pub(crate) fn refine(step: &Step, mut candidate: ImpactCandidate, reach: f64) -> ImpactCandidate {
    for _ in 0..NEWTON_STEPS {
        if candidate.time <= 0.0 {
            break;
        }
        let gap = gap_at(step, &candidate);
        if gap.closing <= RESTITUTION_THRESHOLD_M_S || gap.distance.abs() > MAX_BEND_M {
            break;
        }
        candidate.time = (candidate.time + gap.distance / gap.closing).clamp(0.0, reach);
        candidate.normal = gap.normal;
    }
    candidate
}

/// Distance, normal and speed of approach of the two that meet, at the candidate's time.
fn gap_at(step: &Step, candidate: &ImpactCandidate) -> Gap {
    let time = candidate.time;
    let place = |ball: usize| step.state.balls[ball].center + step.mean_velocity(ball, time) * time;
    let velocity_of = |ball: usize| 2.0 * step.mean_velocity(ball, time) - step.mean_velocity(ball, 0.0);
    let (center, velocity) = (place(candidate.ball), velocity_of(candidate.ball));
    let (models, states) = (&step.model.mechanisms, &step.state.mechanisms);
    match candidate.collider {
        Collider::Obstacle(index) => {
            let (distance, normal) = step.model.collision.obstacles[index].shape.distance(center);
            Gap { distance, normal, closing: -velocity.dot(normal) }
        }
        Collider::Rod(index) => {
            let (rod, model) = (&states.rods[index], &models.rods[index]);
            let moved = model.velocity(rod);
            let (distance, normal) = model.face(rod).distance(center - moved * time);
            Gap { distance, normal, closing: (moved - velocity).dot(normal) }
        }
        Collider::Flipper(index) => {
            let (flipper, model) = (&states.flippers[index], &models.flippers[index]);
            let (distance, normal) = model.outline(flipper.angle + flipper.speed * time).distance(center);
            let lever = center - normal * BALL_RADIUS_M - model.pivot();
            let closing = (flipper.velocity_at(lever) - velocity).dot(normal);
            Gap { distance: distance - BALL_RADIUS_M, normal, closing }
        }
        Collider::Ball(other) => {
            let offset = center - place(other);
            let normal = offset.try_normalize().unwrap_or(candidate.normal);
            let closing = (velocity_of(other) - velocity).dot(normal);
            Gap { distance: offset.length() - 2.0 * BALL_RADIUS_M, normal, closing }
        }
    }
}

/// How much faster than on the step's mean a flipper turns at the moment of a firm impact, rad/s: the speed goes evenly
/// from its start to its end, and the mean is in the middle.
pub(crate) fn flipper_speed_offset(step: &Step, candidate: &ImpactCandidate, time: StepTime) -> f64 {
    let Collider::Flipper(index) = candidate.collider else { return 0.0 };
    let gain = step.state.mechanisms.flippers[index].speed_correction;
    let offset = gain * (1.0 - 2.0 * time.left / time.duration);
    let closing = gap_at(step, &ImpactCandidate { time: 0.0, ..*candidate }).closing;
    let is_firm = closing > FIRM_IMPACT * (gain * step.model.mechanisms.flippers[index].reach).abs();
    if is_firm { offset } else { 0.0 }
}
