//! What lies on what at the start of a step, and the speeds that go with it.
//!
//! A slow ball within a skin of something touches it. Gravity, the playfield's friction and every touch then act
//! together, so that stacks, wedges and a ball on a flipper find their common speeds.

use crate::BALL_RADIUS_M;
use crate::ball::Ball;
use crate::collision::time_of_impact::{far_apart, is_out_of_reach};
use crate::collision::world::SKIN_M;
use crate::mechanisms::elevation::apart;
use crate::solver::contact_constraint::{BALL_FRICTION, Other, Touch};
use crate::solver::sweep::{PARTING_M_S, SAME_M_S, SLOW_M_S, Sweep, bodies};
use geometry::DVec2;

/// Rounds of the solver for balls at rest.
const SETTLE_ROUNDS: usize = 24;
/// How often the settled speeds are checked against where they lead.
const AHEAD_ROUNDS: usize = 4;
/// An error of this speed there does not matter.
const AHEAD_M_S: f64 = 1e-5;
/// How much of an overlap is undone in a step, and how far at most.
const PART_OF_DEPTH: f64 = 0.2;
const MOST_OUT_M: f64 = 1e-4;
/// The sine of an angle by which two ways differ that are the same but for rounding.
const ALONG: f64 = 1e-9;
/// A ball that a flipper pushes is kept at least this far from it.
const NEAR_M: f64 = 1e-6;

impl Sweep<'_> {
    /// How fast the approach of a ball and a turning flipper that roll on each other can grow, m/s^2.
    pub(crate) fn turning(&self, flipper: usize, ball: usize) -> f64 {
        let (rotor, blade) = (&self.state.mechanisms.rotors[flipper], &self.plan.blades[flipper]);
        if rotor.seated {
            return 0.0;
        }
        let arm = blade.reach;
        let torques = blade.most_acceleration(rotor) * arm;
        let (turn, speed) = (rotor.speed.abs(), self.state.balls[ball].velocity.length());
        torques + 2.0 * turn * speed + turn * turn * arm
    }

    /// Balls that lie on something: the step's pull, the playfield and every touch act together.
    pub(crate) fn settle(&mut self, duration: f64) {
        self.scratch.touches.clear();
        let swing = self.swing(0.0);
        for ball in 0..self.state.balls.len() {
            if !self.state.balls[ball].is_held() {
                self.find_touches(ball, duration, swing);
            }
        }
        for touch in &self.scratch.touches {
            self.scratch.motions[touch.ball].settled = true;
            if let Other::Ball(other) = touch.other {
                self.scratch.motions[other].settled = true;
            }
        }
        for (ball, motion) in self.state.balls.iter_mut().zip(&mut self.scratch.motions) {
            if ball.is_held() {
                continue;
            } else if motion.settled {
                motion.start = ball.velocity;
                ball.velocity += motion.pull * duration;
            } else {
                motion.drive = ball.drive(&motion.floor, motion.pull, duration);
            }
        }
        if !self.scratch.touches.is_empty() {
            self.press_together(duration);
            self.ease_in(duration);
        }
    }

    /// A ball that rolls along something gains its speed evenly within the step: its way is that of the mean.
    fn ease_in(&mut self, duration: f64) {
        for (ball, motion) in self.state.balls.iter_mut().zip(&mut self.scratch.motions) {
            if motion.settled && !ball.is_held() {
                motion.drive.velocity = (ball.velocity - motion.start) / duration;
            }
        }
        for touch in &self.scratch.touches {
            let still = match touch.other {
                Other::Fixed(velocity) => velocity == DVec2::ZERO,
                Other::Flipper(index) => self.state.mechanisms.rotors[index].seated,
                Other::Ball(other) => {
                    self.scratch.motions[other].drive.velocity = DVec2::ZERO;
                    false
                }
            };
            let gain = &mut self.scratch.motions[touch.ball].drive.velocity;
            *gain = if still { gain.project_onto_normalized(touch.normal.perp()) } else { DVec2::ZERO };
        }
        for touch in &self.scratch.touches {
            let gain = &mut self.scratch.motions[touch.ball].drive.velocity;
            if gain.dot(touch.normal).abs() > ALONG * gain.length() {
                *gain = DVec2::ZERO; // there is no way along the walls of a corner
            }
        }
        for (ball, motion) in
            self.state.balls.iter_mut().zip(&self.scratch.motions).filter(|(_, motion)| motion.settled)
        {
            ball.velocity -= motion.drive.velocity * duration;
        }
    }

    /// Sequential impulses with accumulation (Catto, Iterative Dynamics with Temporal Coherence, 2005).
    fn press_together(&mut self, duration: f64) {
        for _ in 0..AHEAD_ROUNDS {
            self.settle_rounds(duration);
            if !self.look_ahead(duration) {
                break;
            }
        }
        let bodies = bodies(self.plan, self.state);
        for (ball, motion) in bodies.balls.iter_mut().zip(&self.scratch.motions) {
            if motion.settled && !ball.is_held() {
                ball.resist(&motion.floor, duration);
            }
        }
    }

    fn settle_rounds(&mut self, duration: f64) {
        let mut bodies = bodies(self.plan, self.state);
        for _ in 0..SETTLE_ROUNDS {
            let mut change: f64 = 0.0;
            for (ball, motion) in bodies.balls.iter_mut().zip(&mut self.scratch.motions) {
                if motion.settled && !ball.is_held() {
                    let most = motion.floor.friction * motion.floor.press * duration;
                    let wanted = (motion.rubbed - ball.floor_slip() * (2.0 / 7.0)).clamp_length_max(most);
                    ball.push_floor(wanted - motion.rubbed);
                    motion.rubbed = wanted;
                }
            }
            for touch in &mut self.scratch.touches {
                change = change.max(touch.separate(&mut bodies, touch.goal).abs());
                touch.grip(&mut bodies);
            }
            if change < SAME_M_S {
                break;
            }
        }
    }

    /// The flippers get the speed that they have at the step's end, and what they push takes its part of it.
    pub(crate) fn end_strokes(&mut self, duration: f64) {
        let plan = self.plan;
        for (index, blade) in plan.blades.iter().enumerate().filter(|(index, _)| !self.alone[*index]) {
            blade.settle(&mut self.state.mechanisms.rotors[index]);
        }
        for at in 0..self.scratch.touches.len() {
            let Touch { ball, other, friction, .. } = self.scratch.touches[at];
            let Other::Flipper(index) = other else { continue };
            let (blade, center) = (&plan.blades[index], self.state.balls[ball].center);
            let (distance, normal) = blade.taper(self.state.mechanisms.rotors[index].angle).distance(center);
            let most = SLOW_M_S + self.turning(index, ball) * duration;
            let mut all = bodies(plan, self.state);
            let mut touch = Touch::new(ball, center, other, normal, friction, &all);
            if distance - BALL_RADIUS_M <= SKIN_M && touch.approach(&all) <= most {
                touch.strike(&mut all, 0.0);
            }
        }
    }

    /// A flipper that turns bends away from the straight way of the ball that it pushes. So the two must part with just
    /// the speed that leaves them as near at the step's end as they are at its start. True if that changes anything.
    fn look_ahead(&mut self, duration: f64) -> bool {
        let mut changed = false;
        for touch in &mut self.scratch.touches {
            let Other::Flipper(index) = touch.other else { continue };
            let (rotor, blade) = (&self.state.mechanisms.rotors[index], &self.plan.blades[index]);
            if rotor.speed == 0.0 {
                continue;
            }
            let ball = &self.state.balls[touch.ball];
            let now = blade.taper(rotor.angle).distance(ball.center).0 - BALL_RADIUS_M;
            let outline = blade.taper(rotor.angle + rotor.speed * duration);
            let then = outline.distance(ball.center + ball.velocity * duration).0 - BALL_RADIUS_M;
            let wanted = if now < NEAR_M { now + 0.2 * (NEAR_M - now) } else { now };
            let missing = (wanted - then) / duration;
            if missing > AHEAD_M_S {
                touch.goal += missing;
                changed = true;
            }
        }
        changed
    }

    fn find_touches(&mut self, ball: usize, duration: f64, swing: f64) {
        let clear = self.clear_of(ball, SKIN_M, swing);
        let mut out = DVec2::ZERO;
        if !clear.still {
            self.touch_obstacles(ball, &mut out);
        }
        if !clear.moving && !self.state.balls[ball].is_up() {
            self.touch_rods(ball, &mut out);
            self.touch_flippers(ball, duration, &mut out);
        }
        self.touch_balls(ball, &mut out);
        self.state.balls[ball].center += out;
    }

    fn touch_obstacles(&mut self, ball: usize, out: &mut DVec2) {
        let Ball { center, velocity, track, .. } = self.state.balls[ball];
        let mut found: [(usize, DVec2); 4] = [(usize::MAX, DVec2::ZERO); 4];
        let mut count = 0;
        self.plan.near(track, center, center, |index: usize| {
            let obstacle = &self.plan.obstacles[index];
            let (distance, normal) = obstacle.shape.distance(center);
            let known = found[..count].iter().any(|&(other, _)| other == index);
            let near = distance <= SKIN_M && count < found.len() && !known;
            if near && self.is_solid(obstacle, center, velocity, distance) {
                found[count] = (index, normal);
                count += 1;
                *out += way_out(distance, normal);
            }
        });
        for &(index, normal) in &found[..count] {
            let friction = self.plan.obstacles[index].material.friction;
            self.add_touch(ball, center, Other::Fixed(DVec2::ZERO), normal, friction, 0.0);
        }
    }

    fn touch_rods(&mut self, ball: usize, out: &mut DVec2) {
        let center = self.state.balls[ball].center;
        for (rod, slide) in self.plan.slides.iter().enumerate() {
            let rod = &self.state.mechanisms.rods[rod];
            let (distance, normal) = slide.face(rod).distance(center);
            if distance <= SKIN_M {
                *out += way_out(distance, normal);
                let sudden = if rod.is_shooting() { f64::INFINITY } else { 0.0 };
                self.add_touch(ball, center, Other::Fixed(slide.velocity(rod)), normal, 0.2, sudden);
            }
        }
    }

    fn touch_flippers(&mut self, ball: usize, duration: f64, out: &mut DVec2) {
        let Ball { center, velocity, .. } = self.state.balls[ball];
        for (index, blade) in self.plan.blades.iter().enumerate() {
            if is_out_of_reach(blade, center, SKIN_M) {
                continue;
            }
            let rotor = self.state.mechanisms.rotors[index];
            let (distance, normal) = blade.taper(rotor.angle).distance(center);
            if distance - BALL_RADIUS_M <= SKIN_M {
                *out += way_out(distance - BALL_RADIUS_M, normal);
                let sudden = self.turning(index, ball) * duration;
                // What presses them together turns with the flipper: on the mean it is as in the middle of the step.
                let (middle, half) = (center + velocity * (0.5 * duration), rotor.angle + rotor.speed * 0.5 * duration);
                let normal = blade.taper(half).distance(middle).1;
                self.add_touch(ball, middle, Other::Flipper(index), normal, blade.flipper.material.friction, sudden);
            }
        }
    }

    fn touch_balls(&mut self, ball: usize, out: &mut DVec2) {
        let center = self.state.balls[ball].center;
        for other in 0..self.state.balls.len() {
            let away = center - self.state.balls[other].center;
            if other == ball || far_apart(away, 0.0) || apart(&self.state.balls[ball], &self.state.balls[other]) {
                continue;
            }
            let held = self.state.balls[other].is_held();
            *out += way_out(0.5 * (away.length() - 2.0 * BALL_RADIUS_M), away.try_normalize().unwrap_or(DVec2::Y));
            if other < ball && !held {
                continue;
            }
            if away.length() - 2.0 * BALL_RADIUS_M <= SKIN_M {
                let what = if held { Other::Fixed(DVec2::ZERO) } else { Other::Ball(other) };
                self.add_touch(ball, center, what, away.try_normalize().unwrap_or(DVec2::Y), BALL_FRICTION, 0.0);
            }
        }
    }

    fn add_touch(&mut self, ball: usize, center: DVec2, other: Other, normal: DVec2, friction: f64, sudden: f64) {
        let clings = |ball: &Ball| ball.loose_ticks == 0;
        let both = match other {
            Other::Ball(other) => clings(&self.state.balls[ball]) && clings(&self.state.balls[other]),
            _ => clings(&self.state.balls[ball]),
        };
        let friction = if both { friction } else { 0.0 };
        let bodies = bodies(self.plan, self.state);
        let touch = Touch::new(ball, center, other, normal, friction, &bodies);
        let approach = touch.approach(&bodies);
        if approach > -PARTING_M_S && approach <= SLOW_M_S + sudden {
            self.scratch.touches.push(touch);
        }
    }
}

/// How far a ball that is `distance` (below 0) deep in something is moved out of it in a step: gently, without speed.
fn way_out(distance: f64, normal: DVec2) -> DVec2 {
    if distance < -NEAR_M { normal * (-PART_OF_DEPTH * distance).min(MOST_OUT_M) } else { DVec2::ZERO }
}
