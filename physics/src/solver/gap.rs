//! Gap: distance, normal and speed of approach of a ball and what it is about to hit, at a time within the step.
//!
//! Refuses to know what is done about it.

use crate::BALL_RADIUS_M;
use crate::solver::impact_candidate::{Collider, ImpactCandidate};
use crate::solver::step::Step;
use geometry::DVec2;

/// The gap between a ball and a collider at a time.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Gap {
    /// Distance, m; below 0 where the two overlap.
    pub distance: f64,
    /// From the collider to the ball.
    pub normal: DVec2,
    /// Speed of approach along the normal, m/s.
    pub closing: f64,
}

/// Distance, normal and speed of approach of the two that meet, at the candidate's time.
pub(crate) fn gap_at(step: &Step, candidate: &ImpactCandidate) -> Gap {
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
