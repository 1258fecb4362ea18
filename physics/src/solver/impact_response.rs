//! What a hit does: to the ball, to what it hits, and to the switch behind that.
//!
//! Refuses to know when the next hit is.

use crate::BALL_RADIUS_M;
use crate::collision::time_of_impact::{keep_speed, ride};
use crate::collision::world::Role;
use crate::layout::{Material, PartId};
use crate::mechanisms::captive_ball;
use crate::mechanisms::state::Goal;
use crate::part::event::{Contact, Event, EventKind};
use crate::solver::contact_constraint::{BALL_FRICTION, Other, Touch};
use crate::solver::sweep::{SLOW_M_S, Strike, Sweep, Target, bodies};
use geometry::DVec2;

/// Restitution of two balls.
const BALL_MATERIAL: Material = Material { restitution: 0.9, falloff_s_per_m: 0.02, friction: BALL_FRICTION };

impl Sweep<'_> {
    /// The two that meet part, `left` of the step before its end; then what lies on what is found anew.
    pub(crate) fn respond(&mut self, strike: &Strike, left: f64, duration: f64) {
        let plan = self.plan;
        let (part, material, other) = match strike.target {
            Target::Obstacle(index) => {
                let obstacle = &plan.obstacles[index];
                (Some(obstacle.part), obstacle.material, Other::Fixed(DVec2::ZERO))
            }
            Target::Rod(index) => {
                let rod = &self.state.mechanisms.rods[index];
                let restitution = if rod.is_shooting() { 0.0 } else { plan.rod_material.restitution };
                let material = Material { restitution, ..plan.rod_material };
                (Some(plan.slides[index].part), material, Other::Fixed(plan.slides[index].velocity(rod)))
            }
            Target::Flipper(index) => {
                (Some(plan.blades[index].part), plan.blades[index].flipper.material, Other::Flipper(index))
            }
            Target::Ball(index) if self.state.balls[index].is_held() => {
                (None, BALL_MATERIAL, Other::Fixed(DVec2::ZERO))
            }
            Target::Ball(index) => (None, BALL_MATERIAL, Other::Ball(index)),
        };
        let sudden = match other {
            Other::Flipper(index) if self.is_touching(strike.ball, other) => {
                self.turning(index, strike.ball) * duration
            }
            _ => 0.0,
        };
        let ahead = self.ahead(strike, left, duration);
        if let Other::Flipper(index) = other {
            self.state.mechanisms.rotors[index].speed += ahead;
        }
        let mut all = bodies(plan, self.state);
        let center = all.balls[strike.ball].center;
        let mut touch = Touch::new(strike.ball, center, other, strike.normal, material.friction, &all);
        let approach = touch.approach(&all);
        let impact = approach > SLOW_M_S + sudden;
        let mut restitution = if impact { material.restitution_at(approach) } else { 0.0 };
        let ride = match strike.target {
            Target::Obstacle(index) => ride(&plan.obstacles[index], &all.balls[strike.ball], approach),
            _ => None,
        };
        if approach > 0.0 {
            let bounce = restitution * approach;
            match ride {
                Some(chord) if bounce < chord => {
                    restitution = chord / approach;
                    let kept = if approach <= 4.0 * chord { approach } else { bounce };
                    touch.strike(&mut all, restitution);
                    keep_speed(&mut all.balls[strike.ball].velocity, strike.normal, chord, kept);
                }
                _ => {
                    let impulse = touch.strike(&mut all, restitution);
                    if impact {
                        self.report(strike, part, approach, impulse);
                    }
                }
            }
        }
        if let Other::Flipper(index) = other {
            self.state.mechanisms.rotors[index].speed -= ahead;
        }
        match strike.target {
            Target::Obstacle(index) if approach > 0.0 => self.react(index, strike, approach),
            Target::Rod(index) => self.state.mechanisms.rods[index].hit = true,
            Target::Ball(other) => {
                let pair = [&self.state.balls[strike.ball], &self.state.balls[other]];
                captive_ball::meet(plan, pair, approach, self.events);
            }
            _ => {}
        }
        self.go_on(strike, touch, left);
    }

    fn is_touching(&self, ball: usize, other: Other) -> bool {
        self.scratch.touches.iter().any(|touch| touch.ball == ball && touch.other == other)
    }

    fn report(&mut self, strike: &Strike, part: Option<u16>, approach: f64, impulse: DVec2) {
        self.contacts.push(Contact {
            time_s: self.elapsed,
            part: part.map(PartId),
            point: self.state.balls[strike.ball].center - strike.normal * BALL_RADIUS_M,
            normal: strike.normal,
            speed_m_s: approach,
            impulse_n_s: impulse * crate::BALL_MASS_KG,
        });
    }

    /// What a part does when it is hit, beside throwing the ball back.
    fn react(&mut self, index: usize, strike: &Strike, approach: f64) {
        let obstacle = &self.plan.obstacles[index];
        let own = &mut self.state.mechanisms;
        let closed = match obstacle.role {
            Role::Kicker(index) => {
                let kicker = &self.plan.kickers[index];
                let ready = own.kickers_live && own.kickers[index] >= crate::mechanisms::state::KICKER_READY_TICKS;
                let fires = ready && approach >= kicker.threshold;
                if fires {
                    own.kickers[index] = 0;
                    let ball = &mut self.state.balls[strike.ball];
                    ball.velocity += strike.normal * kicker.speed_at(ball.center);
                }
                fires
            }
            Role::Target(index) => approach >= self.plan.targets[index].threshold,
            Role::Drop(index) => {
                let falls = own.drops[index].goal == Goal::Up && approach >= self.plan.drops[index].threshold;
                if falls {
                    own.drops[index].goal = Goal::Down;
                    own.drops[index].falling = false;
                }
                falls
            }
            Role::Still | Role::Gate(_) => false,
        };
        if closed {
            self.events.push(Event { part: Some(PartId(obstacle.part)), kind: EventKind::Closed });
        }
    }
}
