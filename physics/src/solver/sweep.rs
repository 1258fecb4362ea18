//! The ball's way through a step: from hit to hit, each at its very moment.
//!
//! Between hits everything goes straight: a ball with its mean velocity up to the end of the step, a flipper with its
//! angular velocity. The earliest hit is found (rays against shapes inflated by the ball's radius, a root of the
//! distance for a turning flipper), everything advances to it, the bodies respond, and so on until the step is used up.

use crate::ball::motion::{Motion, hold_back};
use crate::collision::time_of_impact::{STILL_M_S, TOUCH_M, cast, far_apart, is_out_of_reach, meet, meet_flipper};
use crate::collision::world::{Obstacle, Plan, Role, SKIN_M};
use crate::mechanisms::elevation::apart;
use crate::mechanisms::state::State;
use crate::part::event::{Contact, Event};
use crate::solver::clearance::Clear;
use crate::solver::contact_constraint::{Bodies, Other, Touch};
use geometry::{DVec2, Ray};

/// Slower than this a touch is a contact and no impact: nothing bounces.
pub(crate) const SLOW_M_S: f64 = 5e-3;
/// A ball that parts faster than this from what it touches is not held by it.
pub(crate) const PARTING_M_S: f64 = 0.02;
/// Hits that follow each other sooner than this are a jam if there are many in a row: more than in any chain of balls.
const ZENO_S: f64 = 1e-6;
/// A round of the solver that changes no speed by more than this was the last.
pub(crate) const SAME_M_S: f64 = 1e-8;
/// A touch that the ball has left by this much says nothing any more.
const STALE_M: f64 = 2e-4;

/// Room to work in, kept from step to step; it carries nothing over.
#[derive(Clone, Debug, Default)]
pub(crate) struct Scratch {
    pub motions: Vec<Motion>,
    pub touches: Vec<Touch>,
    /// In a tick of many steps the room round each ball at its start...
    pub clear: Vec<Clear>,
    /// ... and where the flippers were then, rad.
    pub angles: Vec<f64>,
    /// The mean velocity of each ball in what is left of a step, while the next strike is looked for.
    means: Vec<DVec2>,
}

/// What a ball is about to hit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Target {
    Obstacle(usize),
    Rod(usize),
    Flipper(usize),
    Ball(usize),
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct Strike {
    /// From now, s.
    pub time: f64,
    pub ball: usize,
    pub target: Target,
    pub normal: DVec2,
}

/// One step of everything that moves by rays.
pub(crate) struct Sweep<'a> {
    pub plan: &'a Plan,
    pub state: &'a mut State,
    pub scratch: &'a mut Scratch,
    pub events: &'a mut Vec<Event>,
    pub contacts: &'a mut Vec<Contact>,
    /// What has passed of the tick, s.
    pub elapsed: f64,
    /// The flippers that have turned already, out of every ball's reach.
    pub alone: &'a [bool],
}

pub(crate) fn bodies<'a>(plan: &'a Plan, state: &'a mut State) -> Bodies<'a> {
    Bodies { balls: &mut state.balls, rotors: &mut state.mechanisms.rotors, blades: &plan.blades }
}

impl Sweep<'_> {
    /// Advances everything by `duration`. `scratch.motions` holds the pull on each ball.
    pub fn step(&mut self, duration: f64) {
        self.settle(duration);
        self.sweep(duration);
        self.end_strokes(duration);
    }

    /// From hit to hit.
    ///
    /// After very many hits (a ball squeezed between moving things) the rest of the step is dropped: everything stands
    /// still for less than a millisecond. A flipper that is in it is jammed and stops, or its coil would go on giving it
    /// speed in a place where time does not pass.
    fn sweep(&mut self, duration: f64) {
        let mut left = duration;
        let most = 16 + 8 * self.state.balls.len();
        let (mut strikes, mut in_a_row) = (0, 0);
        while strikes < most {
            let reach = self.scratch.motions.iter().filter_map(|motion| motion.drive.lasts).fold(left, f64::min);
            let strike = self.first_strike(reach).map(|strike| self.refine(strike, reach));
            let time = strike.map_or(reach, |strike| strike.time);
            self.advance(time);
            left -= time;
            in_a_row = if time < ZENO_S { in_a_row + 1 } else { 0 };
            if let Some(strike) = strike {
                strikes += 1;
                self.respond(&strike, left, duration);
                if in_a_row > 4 + 2 * self.state.balls.len() {
                    self.end_jam(left);
                    in_a_row = 0;
                }
            } else if left <= 0.0 {
                return;
            }
            self.slide_on(left);
        }
        for touch in &self.scratch.touches {
            if let Other::Flipper(index) = touch.other {
                self.state.mechanisms.rotors[index].speed = 0.0;
            }
        }
    }

    pub(crate) fn is_solid(&self, obstacle: &Obstacle, center: DVec2, velocity: DVec2, distance: f64) -> bool {
        match obstacle.role {
            Role::Drop(index) => self.state.mechanisms.drops[index].solid,
            Role::Gate(index) => {
                let gate = &self.plan.gates[index].1;
                let beyond = (center - gate.segment.a).dot(gate.direction) > 0.0;
                beyond && distance > -SKIN_M && velocity.dot(gate.direction) <= 0.0
            }
            _ => true,
        }
    }

    /// A ball's mean velocity over what is `left` of the step.
    pub(crate) fn mean_velocity(&self, ball: usize, left: f64) -> DVec2 {
        if self.state.balls[ball].is_held() {
            return DVec2::ZERO;
        }
        let drive = &self.scratch.motions[ball].drive;
        self.state.balls[ball].velocity + drive.velocity * (0.5 * left) + drive.lead
    }

    fn advance(&mut self, time: f64) {
        self.elapsed += time;
        for index in 0..self.state.balls.len() {
            if self.state.balls[index].is_held() {
                continue;
            }
            let mean = self.mean_velocity(index, time);
            let drive = &mut self.scratch.motions[index].drive;
            let ball = &mut self.state.balls[index];
            ball.center += mean * time;
            ball.velocity += drive.velocity * time;
            ball.spin += drive.spin * time;
            drive.lasts = drive.lasts.map(|lasts| lasts - time);
        }
        for (rotor, _) in self.state.mechanisms.rotors.iter_mut().zip(self.alone).filter(|(_, alone)| !**alone) {
            rotor.advance(time);
        }
        for rod in &mut self.state.mechanisms.rods {
            rod.advance(time);
        }
    }

    /// Drives on the balls whose slide has come to its next part, or to its end.
    fn slide_on(&mut self, left: f64) {
        for ball in 0..self.state.balls.len() {
            if self.scratch.motions[ball].drive.lasts.is_some_and(|time| time <= 0.0) && left > 0.0 {
                self.drive_on(ball, left);
                self.hold_back(left);
            }
        }
    }

    fn first_strike(&mut self, left: f64) -> Option<Strike> {
        let mut means = std::mem::take(&mut self.scratch.means);
        means.clear();
        means.extend((0..self.state.balls.len()).map(|ball| self.mean_velocity(ball, left)));
        let swing = self.swing(left);
        let mut first: Option<Strike> = None;
        for (ball, own) in self.state.balls.iter().enumerate().filter(|(_, ball)| !ball.is_held()) {
            let mut offer = |time: f64, target: Target, normal: DVec2| {
                if time <= left && first.is_none_or(|first| time < first.time) {
                    first = Some(Strike { time, ball, target, normal });
                }
            };
            let (center, velocity) = (own.center, means[ball]);
            let clear = self.clear_of(ball, velocity.length() * left, swing);
            if !clear.still {
                self.strikes_of_obstacles(own.track, center, velocity, left, &mut offer);
            }
            if !clear.moving && !own.is_up() {
                self.strikes_of_machines(center, velocity, left, &mut offer);
            }
            for (other, met) in self.state.balls.iter().enumerate() {
                if other > ball || (other != ball && met.is_held()) {
                    let (away, closing) = (center - met.center, velocity - means[other]);
                    if far_apart(away, closing.length_squared() * left * left) || apart(own, met) {
                        continue;
                    }
                    if let Some((time, normal)) = meet(away, closing) {
                        offer(time, Target::Ball(other), normal);
                    }
                }
            }
        }
        self.scratch.means = means;
        first
    }

    fn strikes_of_obstacles(
        &self,
        track: Option<u16>,
        center: DVec2,
        velocity: DVec2,
        left: f64,
        offer: &mut impl FnMut(f64, Target, DVec2),
    ) {
        let speed = velocity.length();
        if speed < STILL_M_S {
            return;
        }
        let ray = Ray { origin: center, direction: velocity / speed };
        self.plan.near(track, center, center + velocity * left, |index| {
            let obstacle = &self.plan.obstacles[index];
            let (distance, normal) = obstacle.shape.distance(center);
            if distance > speed * left || !self.is_solid(obstacle, center, velocity, distance) {
                return;
            }
            let hit = cast(obstacle, &ray, distance, normal, speed);
            if let Some((way, normal)) = hit {
                offer(way / speed, Target::Obstacle(index), normal);
            }
        });
    }

    fn strikes_of_machines(
        &self,
        center: DVec2,
        velocity: DVec2,
        left: f64,
        offer: &mut impl FnMut(f64, Target, DVec2),
    ) {
        for (index, slide) in self.plan.slides.iter().enumerate() {
            let rod = &self.state.mechanisms.rods[index];
            let (face, closing) = (slide.face(rod), velocity - slide.velocity(rod));
            let (distance, normal) = face.distance(center);
            let speed = closing.length();
            if distance <= speed * left && speed > STILL_M_S {
                if distance <= TOUCH_M {
                    if closing.dot(normal) < -STILL_M_S {
                        offer(0.0, Target::Rod(index), normal);
                    }
                } else if let Some(hit) = face.cast(&Ray { origin: center, direction: closing / speed }) {
                    offer(hit.distance / speed, Target::Rod(index), hit.normal);
                }
            }
        }
        for (index, blade) in self.plan.blades.iter().enumerate() {
            if is_out_of_reach(blade, center, velocity.length() * left) {
                continue;
            }
            let rotor = &self.state.mechanisms.rotors[index];
            if let Some((time, normal)) = meet_flipper(blade, rotor.angle, rotor.speed, center, velocity, left) {
                offer(time, Target::Flipper(index), normal);
            }
        }
    }

    /// After a hit: what the balls now lie on holds them, and the rest of the step begins.
    pub(crate) fn go_on(&mut self, strike: &Strike, touch: Touch, left: f64) {
        let balls = &self.state.balls;
        self.scratch
            .touches
            .retain(|touch| balls[touch.ball].center.distance_squared(touch.center) < STALE_M * STALE_M);
        let rests = touch.approach(&bodies(self.plan, self.state)) > -PARTING_M_S;
        if rests && !self.is_known(&touch) {
            self.scratch.touches.push(touch);
        }
        let mut all = bodies(self.plan, self.state);
        for _ in 0..8 {
            let mut change: f64 = 0.0;
            for touch in &mut self.scratch.touches {
                touch.release();
                change = change.max(touch.separate(&mut all, 0.0));
            }
            if change < SAME_M_S {
                break;
            }
        }
        if left <= 0.0 {
            return;
        }
        self.drive_on(strike.ball, left);
        if let Target::Ball(other) = strike.target {
            self.drive_on(other, left);
        }
        self.hold_back(left);
    }

    /// Takes from the balls' drive what would press them together or into what they lie on before the step ends.
    fn hold_back(&mut self, left: f64) {
        let all = bodies(self.plan, self.state);
        for _ in 0..2 {
            for touch in &self.scratch.touches {
                hold_back(touch, touch.approach(&all) / left, &mut self.scratch.motions);
            }
        }
    }

    fn is_known(&self, touch: &Touch) -> bool {
        let same = |known: &Touch| {
            known.ball == touch.ball && known.other == touch.other && known.normal.dot(touch.normal) > 0.999_999
        };
        self.scratch.touches.iter().any(same)
    }

    fn drive_on(&mut self, ball: usize, left: f64) {
        let motion = &mut self.scratch.motions[ball];
        if !motion.settled && !self.state.balls[ball].is_held() {
            motion.drive = self.state.balls[ball].drive(&motion.floor, motion.pull, left);
        }
    }
}
