//! How a machine obeys the rules: balls are fed, saucers emptied, targets raised; and the works that go with it.

use crate::BALL_RADIUS_M;
use crate::ball::Ball;
use crate::collision::world::Role;
use crate::layout::PartId;
use crate::machine::Machine;
use crate::mechanisms::controls::Command;
use crate::mechanisms::rod::Slide;
use crate::mechanisms::state::Goal;
use crate::mechanisms::{flap_contact, triggers};
use crate::part::event::{Event, EventKind};
use std::sync::Arc;

/// A kicker's arm or ring comes this far out of its rubber.
const KICK_REACH_M: f64 = 3e-3;
/// What a drop target needs to rise: no ball may come over it so soon.
const RISE_S: f64 = 0.05;
/// A drop target with more of it above the playfield stands in the ball's way: its top is above the ball's middle.
const STANDING: f64 = 0.55;

impl Machine {
    pub(crate) fn obey(&mut self, command: &Command) {
        match *command {
            Command::AddBall => self.state.mechanisms.queue = self.state.mechanisms.queue.saturating_add(1),
            Command::Eject(part) => {
                if let Some(saucer) = self.plan.saucers.iter().position(|&(own, _)| own == part.0) {
                    triggers::eject(&self.plan, &mut self.state, saucer, &mut self.events);
                }
            }
            Command::Raise(part) => {
                if let Some(drop) = self.plan.drops.iter().position(|drop| drop.part == part.0) {
                    let drop = &mut self.state.mechanisms.drops[drop];
                    if drop.goal == Goal::Down {
                        drop.goal = Goal::Rise;
                        drop.solid = false;
                        drop.falling = false;
                    }
                }
            }
            Command::BallSearch => self.search(),
            Command::SetFlippers(live) => self.state.mechanisms.flippers_live = live,
            Command::SetKickers(live) => self.state.mechanisms.kickers_live = live,
            Command::Kick(part) => {
                if self.state.mechanisms.kickers_live {
                    self.shoot(|slide| slide.part == part.0);
                }
            }
            Command::Magnet(part, on) => {
                if let Some(coil) = self.plan.magnets.iter().position(|&(own, _)| own == part.0) {
                    self.state.mechanisms.coils[coil].on = on;
                }
            }
            Command::Divert(part, on) => {
                if let Some(blade) = self.plan.blades.iter().position(|blade| blade.part == part.0) {
                    self.state.mechanisms.diverted[blade] = on;
                }
            }
        }
    }

    /// Fires the coils of these kickbacks.
    fn shoot(&mut self, which: impl Fn(&Slide) -> bool) {
        for (slide, rod) in self.plan.slides.iter().zip(&mut self.state.mechanisms.rods) {
            if which(slide) {
                slide.fire(rod);
            }
        }
    }

    /// Fires every coil once, whatever its switch says.
    fn search(&mut self) {
        let plan = Arc::clone(&self.plan);
        for obstacle in &plan.obstacles {
            let Role::Kicker(index) = obstacle.role else { continue };
            self.state.mechanisms.kickers[index] = 0;
            for ball in self.state.balls.iter_mut().filter(|ball| !ball.is_held()) {
                let (distance, normal) = obstacle.shape.distance(ball.center);
                if distance < KICK_REACH_M {
                    ball.velocity += normal * plan.kickers[index].speed_at(ball.center);
                }
            }
        }
        for saucer in 0..plan.saucers.len() {
            triggers::eject(&plan, &mut self.state, saucer, &mut self.events);
        }
        plan.drops.iter().for_each(|drop| self.obey(&Command::Raise(PartId(drop.part))));
        self.shoot(|_| true);
        self.state.mechanisms.coils.iter_mut().for_each(|coil| coil.on = false);
    }

    /// Puts a waiting ball into the plunger lane, as soon as there is room.
    pub(crate) fn feed(&mut self) {
        let Some((part, plunger)) = self.plan.plungers.first() else { return };
        let room = 2.0 * BALL_RADIUS_M + 1e-3;
        let free = self.state.balls.iter().all(|ball| ball.center.distance(plunger.feed) > room);
        if self.state.mechanisms.queue > 0 && free {
            self.state.mechanisms.queue -= 1;
            self.state.balls.push(Ball::new(self.state.mechanisms.next_ball, plunger.feed));
            self.state.mechanisms.next_ball = self.state.mechanisms.next_ball.wrapping_add(1);
            self.events.push(Event { part: Some(PartId(*part)), kind: EventKind::Fed });
        }
    }

    /// Raises the drop targets that are asked to rise and have no ball over them.
    pub(crate) fn raise(&mut self) {
        let plan = Arc::clone(&self.plan);
        for (index, &obstacle) in plan.drop_obstacles.iter().enumerate() {
            let obstacle = &plan.obstacles[obstacle];
            let away = |ball: &Ball, time: f64| obstacle.shape.distance(ball.center).0 > ball.velocity.length() * time;
            // Asked only where it matters: most targets stand, and nothing is to be done.
            let balls = &self.state.balls;
            let clear = |time: f64| balls.iter().all(|ball| away(ball, time));
            let drop = &mut self.state.mechanisms.drops[index];
            let high = self.works.height(index) > STANDING;
            match drop.goal {
                Goal::Rise if clear(RISE_S) => {
                    drop.goal = Goal::Up;
                    self.works.send(index, true);
                }
                // A ball has come over it while it rose: down again, until it has gone.
                Goal::Up if high && !drop.solid && !clear(0.0) => {
                    drop.goal = Goal::Rise;
                    self.works.send(index, false);
                }
                Goal::Up if high && !drop.solid => {
                    drop.solid = true;
                    self.events.push(Event { part: Some(PartId(obstacle.part)), kind: EventKind::Opened });
                }
                Goal::Down if drop.solid => {
                    if drop.falling {
                        drop.solid = high;
                    } else {
                        drop.falling = true;
                        self.works.send(index, false);
                    }
                }
                _ => {}
            }
        }
    }

    /// Balls push plates and flaps, and rapier moves everything that it owns.
    pub(crate) fn move_works(&mut self) {
        let plan = Arc::clone(&self.plan);
        if !(plan.gates.is_empty() && plan.spinners.is_empty()) {
            for (ball, &start) in self.state.balls.iter_mut().zip(&self.starts) {
                if !ball.is_held() && !ball.is_up() {
                    flap_contact::pass(&plan, &mut self.works, ball, start);
                }
            }
        }
        let events = &mut self.events;
        self.works.tick(|spinner| {
            events.push(Event { part: Some(PartId(plan.spinners[spinner].0)), kind: EventKind::Closed });
        });
    }
}
