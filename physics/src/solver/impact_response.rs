//! Impact response: what an impact does to the ball, to what it hits, and to the switch behind that.
//!
//! Refuses to know when the next impact is.

use crate::ball::Ball;
use crate::collision::obstacle::{Obstacle, ObstacleRole};
use crate::mechanisms::captive_ball;
use crate::part::PartId;
use crate::part::event::{Contact, Event};
use crate::part::material::Material;
use crate::solver::contact_constraint::{ContactBody, ContactConstraint, Touching};
use crate::solver::gap::gap_at;
use crate::solver::impact_candidate::{Collider, ImpactCandidate};
use crate::solver::step::{RESTITUTION_THRESHOLD_M_S, Step, StepTime};
use crate::{BALL_MASS_KG, BALL_RADIUS_M};
use geometry::DVec2;

/// A ball that slides along the inside of a curve does so in chords whose middles are this far from the curve, m.
const SAGITTA_M: f64 = 5e-6;
/// An approach of no more than so many times the chord's own is a slide and no impact: nothing of the speed is lost.
const SLIDE_APPROACH: f64 = 4.0;
/// A firm impact: its approach is so many times what the flipper's speed can differ from its mean by.
const FIRM_IMPACT: f64 = 4.0;

/// What a ball has hit.
struct Struck {
    /// `None` for another ball.
    part: Option<PartId>,
    material: Material,
    body: ContactBody,
}

/// The two that meet part. Returns the contact that the impact leaves.
///
/// 1. A flipper is given the speed that it has at this moment of the step, beside its mean.
/// 2. The speed of approach along the normal decides: below the threshold nothing bounces, above it the material's
///    coefficient of restitution at that speed holds.
/// 3. Normal and tangential impulse act ([`ContactConstraint::solve_impact`]); the ball slides along the inside of a curve.
/// 4. What was hit reacts: it kicks, falls, or its switch closes.
pub(crate) fn respond(step: &mut Step, candidate: &ImpactCandidate, time: StepTime) -> ContactConstraint {
    let struck = struck(step, candidate.collider);
    let growth = approach_growth(step, candidate.ball, struck.body, time.duration);
    let offset = flipper_speed_offset(step, candidate, time);
    push_flipper(step, struck.body, offset);
    let center = step.state.balls[candidate.ball].center;
    let touching = Touching {
        ball: candidate.ball,
        body: struck.body,
        normal: candidate.normal,
        center,
        friction: struck.material.friction,
    };
    let mut constraint = ContactConstraint::new(&touching, &step.bodies());
    let approach = constraint.approach(&step.bodies());
    let is_impact = approach > RESTITUTION_THRESHOLD_M_S + growth;
    let restitution = if is_impact { struck.material.restitution_at(approach) } else { 0.0 };
    if approach > 0.0 {
        match chord_rebound(step, candidate, approach) {
            Some(chord_rebound) if restitution * approach < chord_rebound => {
                let slide = CurveSlide { approach, chord_rebound, bounce: restitution * approach };
                slide_along_curve(step, &mut constraint, slide);
            }
            _ => {
                let impulse = constraint.solve_impact(&mut step.bodies(), restitution);
                if is_impact {
                    record_impact(step, candidate, struck.part, (approach, impulse));
                }
            }
        }
    }
    push_flipper(step, struck.body, -offset);
    react(step, candidate, approach);
    constraint
}

/// How much faster than on the step's mean a flipper turns at the moment of a firm impact, rad/s: the speed goes evenly
/// from its start to its end, and the mean is in the middle.
fn flipper_speed_offset(step: &Step, candidate: &ImpactCandidate, time: StepTime) -> f64 {
    let Collider::Flipper(index) = candidate.collider else { return 0.0 };
    let gain = step.state.mechanisms.flippers[index].speed_correction;
    let offset = gain * (1.0 - 2.0 * time.left / time.duration);
    let closing = gap_at(step, &ImpactCandidate { time: 0.0, ..*candidate }).closing;
    let is_firm = closing > FIRM_IMPACT * (gain * step.model.mechanisms.flippers[index].reach).abs();
    if is_firm { offset } else { 0.0 }
}

fn struck(step: &Step, collider: Collider) -> Struck {
    let (models, states) = (&step.model.mechanisms, &step.state.mechanisms);
    match collider {
        Collider::Obstacle(index) => {
            let Obstacle { part, material, .. } = step.model.collision.obstacles[index];
            Struck { part: Some(part), material, body: ContactBody::Fixed(DVec2::ZERO) }
        }
        Collider::Rod(index) => {
            let (model, rod) = (&models.rods[index], &states.rods[index]);
            let body = ContactBody::Fixed(model.velocity(rod));
            Struck { part: Some(model.part), material: model.material(rod), body }
        }
        Collider::Flipper(index) => {
            let model = &models.flippers[index];
            Struck { part: Some(model.part), material: model.flipper.material, body: ContactBody::Flipper(index) }
        }
        Collider::Ball(index) => {
            let held = step.state.balls[index].is_held();
            let body = if held { ContactBody::Fixed(DVec2::ZERO) } else { ContactBody::Ball(index) };
            Struck { part: None, material: Material::BALL_ON_BALL, body }
        }
    }
}

/// How fast a ball that rests on a turning flipper may come to approach it within the step: that is no impact.
fn approach_growth(step: &Step, ball: usize, body: ContactBody, duration: f64) -> f64 {
    let rests = || step.buffers.constraints.iter().any(|own| own.ball == ball && own.body == body);
    match body {
        ContactBody::Flipper(index) if rests() => {
            let speed = step.state.balls[ball].velocity.length();
            let flipper = &step.state.mechanisms.flippers[index];
            step.model.mechanisms.flippers[index].approach_growth(flipper, speed) * duration
        }
        _ => 0.0,
    }
}

fn push_flipper(step: &mut Step, body: ContactBody, speed: f64) {
    if let ContactBody::Flipper(index) = body {
        step.state.mechanisms.flippers[index].speed += speed;
    }
}

/// The speed away from the inside of a curve with which a ball that is pressed to it goes round in short chords, m/s;
/// `None` where there is no curve to slide along.
///
/// A chord of the circle of radius `R` whose middle is `s` away from it leaves it at the angle `sqrt(2 s / R)`.
fn chord_rebound(step: &Step, candidate: &ImpactCandidate, approach: f64) -> Option<f64> {
    let Collider::Obstacle(index) = candidate.collider else { return None };
    let (obstacle, ball) = (&step.model.collision.obstacles[index], &step.state.balls[candidate.ball]);
    let normal = obstacle.shape.distance(ball.center).1;
    let curve = obstacle.inner_curve(ball.center, normal)?;
    if approach <= 0.0 {
        return None;
    }
    let along = ball.velocity.dot(normal.perp()).abs();
    Some(along * (2.0 * SAGITTA_M / curve.circle().radius).sqrt())
}

/// A slide along the inside of a curve: speeds along the normal, m/s.
struct CurveSlide {
    approach: f64,
    /// Away from the curve, into the next chord.
    chord_rebound: f64,
    /// Away from the curve, if the ball bounced.
    bounce: f64,
}

/// The ball goes into its next chord, with friction; a smooth curve turns it without work.
fn slide_along_curve(step: &mut Step, constraint: &mut ContactConstraint, slide: CurveSlide) {
    let CurveSlide { approach, chord_rebound, bounce } = slide;
    let lossless = if approach <= SLIDE_APPROACH * chord_rebound { approach } else { bounce };
    constraint.solve_impact(&mut step.bodies(), chord_rebound / approach);
    keep_energy(&mut step.state.balls[constraint.ball].velocity, constraint.normal, chord_rebound, lossless);
}

/// Gives back along the wall what a slide along a curve does not lose: the energy of the speed `lossless` along the normal,
/// less that of `rebound`, which is still along the normal.
fn keep_energy(velocity: &mut DVec2, normal: DVec2, rebound: f64, lossless: f64) {
    let along = velocity.dot(normal.perp());
    let speed = (along * along + lossless * lossless - rebound * rebound).max(0.0).sqrt();
    *velocity = normal * rebound + normal.perp() * speed.copysign(along);
}

fn record_impact(
    step: &mut Step,
    candidate: &ImpactCandidate,
    part: Option<PartId>,
    (approach, impulse): (f64, DVec2),
) {
    step.contacts.push(Contact {
        time_s: step.elapsed,
        part,
        point: step.state.balls[candidate.ball].center - candidate.normal * BALL_RADIUS_M,
        normal: candidate.normal,
        speed_m_s: approach,
        impulse_n_s: impulse * BALL_MASS_KG,
        events_before: step.events.len(),
    });
}

/// What was hit does, beside throwing the ball back.
fn react(step: &mut Step, candidate: &ImpactCandidate, approach: f64) {
    match candidate.collider {
        Collider::Obstacle(index) if approach > 0.0 => {
            let obstacle = &step.model.collision.obstacles[index];
            if closes(step, obstacle, candidate, approach) {
                step.events.push(Event::closed(obstacle.part));
            }
        }
        Collider::Rod(index) => step.state.mechanisms.rods[index].hit = true,
        Collider::Ball(other) => {
            let pair: [&Ball; 2] = [&step.state.balls[candidate.ball], &step.state.balls[other]];
            captive_ball::hit(&step.model.mechanisms.captive_balls, pair, approach, step.events);
        }
        _ => {}
    }
}

/// Whether the switch behind an obstacle closes: a kicker fires, a target is hit, a drop target falls.
fn closes(step: &mut Step, obstacle: &Obstacle, candidate: &ImpactCandidate, approach: f64) -> bool {
    let (models, own) = (&step.model.mechanisms, &mut step.state.mechanisms);
    match obstacle.role {
        ObstacleRole::Kicker(index) => {
            let kicker = &models.kickers[index];
            let fires = kicker.hit(&mut own.kicker_ticks[index], own.coils_enabled, approach);
            if fires {
                let ball = &mut step.state.balls[candidate.ball];
                ball.velocity += candidate.normal * kicker.speed_at(ball.center);
            }
            fires
        }
        ObstacleRole::Target(index) => approach >= models.targets[index].threshold,
        ObstacleRole::DropTarget(index) => own.drop_targets[index].hit(&models.drop_targets[index], approach),
        ObstacleRole::Static | ObstacleRole::Gate(_) => false,
    }
}
