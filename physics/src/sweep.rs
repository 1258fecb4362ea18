//! The ball's way through a step: from hit to hit, each at its very moment.
//!
//! Between hits everything goes straight: a ball with its mean velocity up to the end of the step, a flipper with its
//! angular velocity. The earliest hit is found (rays against shapes inflated by the ball's radius, a root of the
//! distance for a turning flipper), everything advances to it, the bodies respond, and so on until the step is used up.

use crate::ball::Drive;
use crate::flipper::Blade;
use crate::plan::{Obstacle, Plan, Role, SKIN_M};
use crate::state::{Goal, State};
use crate::touch::{BALL_FRICTION, Bodies, Other, Touch};
use crate::{BALL_RADIUS_M, Contact, Event, EventKind, Material, PartId};
use geometry::{Core, DVec2, Ray};

/// Slower than this a touch is a contact and no impact: nothing bounces.
const SLOW_M_S: f64 = 5e-3;
/// A ball that parts faster than this from what it touches is not held by it.
const PARTING_M_S: f64 = 0.02;
/// A ball this near to a turning flipper has hit it.
const HIT_M: f64 = 1e-8;
/// Nearer than this is touching: far above rounding, far below anything else.
const TOUCH_M: f64 = 1e-9;
/// An approach slower than this is none.
const STILL_M_S: f64 = 1e-9;
/// Restitution of two balls.
const BALL_MATERIAL: Material = Material { restitution: 0.9, falloff_s_per_m: 0.02, friction: BALL_FRICTION };
/// A touch that the ball has left by this much says nothing any more.
const STALE_M: f64 = 2e-4;
/// A ball that rides round the inside of a curve does so in chords this far from it.
const CHORD_M: f64 = 5e-6;
/// Rounds of the solver for balls at rest.
const SETTLE_ROUNDS: usize = 24;
/// How often the settled speeds are checked against where they lead.
const AHEAD_ROUNDS: usize = 4;
/// An error of this speed there does not matter.
const AHEAD_M_S: f64 = 1e-5;
/// A ball that a flipper pushes is kept at least this far from it.
const NEAR_M: f64 = 1e-6;
/// A round that changes no velocity by more than this was the last.
const SETTLED_M_S: f64 = 1e-8;

/// How a ball moves in what is left of a step.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Motion {
    drive: Drive,
    /// Gravity and everything else that acts from afar, m/s^2.
    pull: DVec2,
    /// The step's pull is in its velocity already.
    settled: bool,
}

impl Motion {
    /// Of a ball that `pull` acts on, m/s^2.
    pub fn new(pull: DVec2) -> Motion {
        Motion { pull, ..Motion::default() }
    }
}

/// Room to work in, kept from step to step; it carries nothing over.
#[derive(Clone, Debug, Default)]
pub(crate) struct Scratch {
    pub motions: Vec<Motion>,
    touches: Vec<Touch>,
}

/// What a ball is about to hit.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Target {
    Obstacle(usize),
    Rod(usize),
    Flipper(usize),
    Ball(usize),
}

#[derive(Clone, Copy, Debug)]
struct Strike {
    time: f64,
    ball: usize,
    target: Target,
    normal: DVec2,
}

/// One step of everything that moves by rays.
pub(crate) struct Sweep<'a> {
    pub plan: &'a Plan,
    pub state: &'a mut State,
    pub scratch: &'a mut Scratch,
    pub events: &'a mut Vec<Event>,
    pub contacts: &'a mut Vec<Contact>,
    /// Flippers move in this step; else they have done so already, out of every ball's reach.
    pub flippers_move: bool,
}

fn bodies<'a>(plan: &'a Plan, state: &'a mut State) -> Bodies<'a> {
    Bodies { balls: &mut state.balls, rotors: &mut state.mechanisms.rotors, blades: &plan.blades }
}

impl Sweep<'_> {
    /// Advances everything by `duration`. `scratch.motions` holds the pull on each ball.
    ///
    /// After very many hits (a ball squeezed between moving things) the rest of the step is dropped: everything stands
    /// still for less than a millisecond. A flipper that is in it is jammed and stops, or its coil would go on giving it
    /// speed in a place where time does not pass.
    pub fn step(&mut self, duration: f64) {
        self.settle(duration);
        let mut left = duration;
        let most = 16 + 8 * self.state.balls.len();
        for _ in 0..most {
            let Some(strike) = self.first_strike(left) else {
                self.advance(left, left);
                return;
            };
            self.advance(strike.time, left);
            left -= strike.time;
            self.respond(&strike, left, duration);
        }
        for touch in &self.scratch.touches {
            if let Other::Flipper(index) = touch.other {
                self.state.mechanisms.rotors[index].speed = 0.0;
            }
        }
    }

    fn is_solid(&self, obstacle: &Obstacle, center: DVec2, velocity: DVec2, distance: f64) -> bool {
        match obstacle.role {
            Role::Drop(index) => self.state.mechanisms.drops[index].solid,
            Role::Gate(index) => {
                let gate = &self.plan.gates[index].1;
                let beyond = (center - gate.segment.a).dot(gate.way) > 0.0;
                beyond && distance > -SKIN_M && velocity.dot(gate.way) <= 0.0
            }
            _ => true,
        }
    }

    /// How fast the approach of a ball and a turning flipper that roll on each other can grow, m/s^2.
    fn turning(&self, flipper: usize, ball: usize) -> f64 {
        let (rotor, blade) = (&self.state.mechanisms.rotors[flipper], &self.plan.blades[flipper]);
        if rotor.seated {
            return 0.0;
        }
        let arm = blade.reach;
        let coil = blade.flipper.coil_torque_n_m / blade.inertia * arm;
        let (turn, speed) = (rotor.speed.abs(), self.state.balls[ball].velocity.length());
        coil + 2.0 * turn * speed + turn * turn * arm
    }

    /// Balls that lie on something: the step's pull, the playfield and every touch act together.
    fn settle(&mut self, duration: f64) {
        self.scratch.touches.clear();
        for ball in 0..self.state.balls.len() {
            if !self.state.balls[ball].is_held() {
                self.find_touches(ball, duration);
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
                ball.velocity += motion.pull * duration;
            } else {
                motion.drive = ball.drive(&self.plan.floor, motion.pull, duration);
            }
        }
        if !self.scratch.touches.is_empty() {
            self.press_together(duration);
        }
    }

    /// Sequential impulses with accumulation (Catto, Iterative Dynamics with Temporal Coherence, 2005).
    fn press_together(&mut self, duration: f64) {
        let floor = &self.plan.floor;
        let most = floor.friction * floor.press * duration;
        let mut rubbed = vec![DVec2::ZERO; self.state.balls.len()];
        for _ in 0..AHEAD_ROUNDS {
            self.settle_rounds(most, &mut rubbed);
            if !self.look_ahead(duration) {
                break;
            }
        }
        let bodies = bodies(self.plan, self.state);
        for (ball, motion) in bodies.balls.iter_mut().zip(&self.scratch.motions) {
            if motion.settled && !ball.is_held() {
                ball.resist(floor, duration);
            }
        }
    }

    fn settle_rounds(&mut self, most: f64, rubbed: &mut [DVec2]) {
        let mut bodies = bodies(self.plan, self.state);
        for _ in 0..SETTLE_ROUNDS {
            let mut change: f64 = 0.0;
            for (index, motion) in self.scratch.motions.iter().enumerate() {
                if motion.settled && !bodies.balls[index].is_held() {
                    let ball = &mut bodies.balls[index];
                    let wanted = (rubbed[index] - ball.floor_slip() * (2.0 / 7.0)).clamp_length_max(most);
                    ball.push_floor(wanted - rubbed[index]);
                    rubbed[index] = wanted;
                }
            }
            for touch in &mut self.scratch.touches {
                change = change.max(touch.separate(&mut bodies, touch.goal).abs());
                touch.grip(&mut bodies);
            }
            if change < SETTLED_M_S {
                break;
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

    fn find_touches(&mut self, ball: usize, duration: f64) {
        let center = self.state.balls[ball].center;
        let velocity = self.state.balls[ball].velocity;
        let mut found: [(usize, DVec2); 4] = [(usize::MAX, DVec2::ZERO); 4];
        let mut count = 0;
        self.plan.obstacle_grid.visit(center, center, |index| {
            let obstacle = &self.plan.obstacles[index];
            let (distance, normal) = obstacle.shape.distance(center);
            let known = found[..count].iter().any(|&(other, _)| other == index);
            let near = distance <= SKIN_M && count < found.len() && !known;
            if near && self.is_solid(obstacle, center, velocity, distance) {
                found[count] = (index, normal);
                count += 1;
            }
        });
        for &(index, normal) in &found[..count] {
            let friction = self.plan.obstacles[index].material.friction;
            self.add_touch(ball, Other::Fixed(DVec2::ZERO), normal, friction, 0.0);
        }
        for (rod, (_, plunger)) in self.plan.plungers.iter().enumerate() {
            let rod = &self.state.mechanisms.rods[rod];
            let (distance, normal) = rod.face(plunger).distance(center);
            if distance <= SKIN_M {
                let sudden = if rod.is_shooting() { f64::INFINITY } else { 0.0 };
                self.add_touch(ball, Other::Fixed(rod.velocity(plunger)), normal, 0.2, sudden);
            }
        }
        for (index, blade) in self.plan.blades.iter().enumerate() {
            if is_out_of_reach(blade, center, SKIN_M) {
                continue;
            }
            let angle = self.state.mechanisms.rotors[index].angle;
            let (distance, normal) = blade.taper(angle).distance(center);
            if distance - BALL_RADIUS_M <= SKIN_M {
                let sudden = self.turning(index, ball) * duration;
                self.add_touch(ball, Other::Flipper(index), normal, blade.flipper.material.friction, sudden);
            }
        }
        for other in 0..self.state.balls.len() {
            let held = self.state.balls[other].is_held();
            if other == ball || (other < ball && !held) {
                continue;
            }
            let away = center - self.state.balls[other].center;
            if away.length() - 2.0 * BALL_RADIUS_M <= SKIN_M {
                let what = if held { Other::Fixed(DVec2::ZERO) } else { Other::Ball(other) };
                self.add_touch(ball, what, away.try_normalize().unwrap_or(DVec2::Y), BALL_FRICTION, 0.0);
            }
        }
    }

    fn add_touch(&mut self, ball: usize, other: Other, normal: DVec2, friction: f64, sudden: f64) {
        let bodies = bodies(self.plan, self.state);
        let touch = Touch::new(ball, other, normal, friction, &bodies);
        let approach = touch.approach(&bodies);
        if approach > -PARTING_M_S && approach <= SLOW_M_S + sudden {
            self.scratch.touches.push(touch);
        }
    }

    /// A ball's mean velocity over what is `left` of the step.
    fn mean_velocity(&self, ball: usize, left: f64) -> DVec2 {
        if self.state.balls[ball].is_held() {
            return DVec2::ZERO;
        }
        self.state.balls[ball].velocity + self.scratch.motions[ball].drive.velocity * (0.5 * left)
    }

    fn advance(&mut self, time: f64, left: f64) {
        for index in 0..self.state.balls.len() {
            if self.state.balls[index].is_held() {
                continue;
            }
            let mean = self.mean_velocity(index, left);
            let drive = self.scratch.motions[index].drive;
            let ball = &mut self.state.balls[index];
            ball.center += mean * time;
            ball.velocity += drive.velocity * time;
            ball.spin += drive.spin * time;
        }
        if self.flippers_move {
            self.state.mechanisms.rotors.iter_mut().for_each(|rotor| rotor.advance(time));
        }
        for rod in &mut self.state.mechanisms.rods {
            rod.advance(time);
        }
    }

    fn first_strike(&self, left: f64) -> Option<Strike> {
        let mut first: Option<Strike> = None;
        for ball in 0..self.state.balls.len() {
            if self.state.balls[ball].is_held() {
                continue;
            }
            let mut offer = |time: f64, target: Target, normal: DVec2| {
                if time <= left && first.is_none_or(|first| time < first.time) {
                    first = Some(Strike { time, ball, target, normal });
                }
            };
            let center = self.state.balls[ball].center;
            let velocity = self.mean_velocity(ball, left);
            self.strikes_of_obstacles(center, velocity, left, &mut offer);
            self.strikes_of_machines(center, velocity, left, &mut offer);
            for other in 0..self.state.balls.len() {
                if other > ball || (other != ball && self.state.balls[other].is_held()) {
                    let away = center - self.state.balls[other].center;
                    let closing = velocity - self.mean_velocity(other, left);
                    if let Some((time, normal)) = meet(away, closing) {
                        offer(time, Target::Ball(other), normal);
                    }
                }
            }
        }
        first
    }

    fn strikes_of_obstacles(
        &self,
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
        self.plan.obstacle_grid.visit(center, center + velocity * left, |index| {
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
        for (index, (_, plunger)) in self.plan.plungers.iter().enumerate() {
            let rod = &self.state.mechanisms.rods[index];
            let (face, closing) = (rod.face(plunger), velocity - rod.velocity(plunger));
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

    fn respond(&mut self, strike: &Strike, left: f64, duration: f64) {
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
                (Some(plan.plungers[index].0), material, Other::Fixed(rod.velocity(&plan.plungers[index].1)))
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
        let mut all = bodies(plan, self.state);
        let mut touch = Touch::new(strike.ball, other, strike.normal, material.friction, &all);
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
        if approach > 0.0
            && let Target::Obstacle(index) = strike.target
        {
            self.react(index, strike, approach);
        }
        self.go_on(strike, touch, left);
    }

    fn is_touching(&self, ball: usize, other: Other) -> bool {
        self.scratch.touches.iter().any(|touch| touch.ball == ball && touch.other == other)
    }

    fn report(&mut self, strike: &Strike, part: Option<u16>, approach: f64, impulse: DVec2) {
        self.contacts.push(Contact {
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
                let ready = own.kickers_live && own.kickers[index] >= crate::state::KICKER_READY_TICKS;
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

    /// After a hit: what the balls now lie on holds them, and the rest of the step begins.
    fn go_on(&mut self, strike: &Strike, touch: Touch, left: f64) {
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
            if change < SETTLED_M_S {
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
        for _ in 0..2 {
            for touch in &self.scratch.touches {
                hold_back(touch, &mut self.scratch.motions);
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
            motion.drive = self.state.balls[ball].drive(&self.plan.floor, motion.pull, left);
        }
    }
}

/// Takes from the balls' drive what would push them into what they touch.
fn hold_back(touch: &Touch, motions: &mut [Motion]) {
    match touch.other {
        Other::Ball(other) => {
            let into = (motions[touch.ball].drive.velocity - motions[other].drive.velocity).dot(touch.normal);
            if into < 0.0 {
                motions[touch.ball].drive.velocity -= touch.normal * (0.5 * into);
                motions[other].drive.velocity += touch.normal * (0.5 * into);
            }
        }
        _ => {
            let drive = &mut motions[touch.ball].drive.velocity;
            *drive -= touch.normal * drive.dot(touch.normal).min(0.0);
        }
    }
}

/// Where a ray from outside first meets an obstacle that is `distance` away: how far, and the normal.
///
/// A ball that touches already is not cast: rounding may have put it a hair inside, from where nothing is entered.
fn cast(obstacle: &Obstacle, ray: &Ray, distance: f64, normal: DVec2, speed: f64) -> Option<(f64, DVec2)> {
    if distance > TOUCH_M {
        return obstacle.shape.cast(ray).map(|hit| (hit.distance, hit.normal));
    }
    if ray.direction.dot(normal) * speed < -STILL_M_S {
        return Some((0.0, normal));
    }
    // Along the inside of a curve the way leads back to it.
    let Core::Arc(arc) = &obstacle.shape.core else { return None };
    let radius = arc.circle().radius - obstacle.shape.radius;
    if radius <= 0.0 || (arc.circle().center - ray.origin).dot(normal) <= 0.0 {
        return None;
    }
    let hit = arc.with_radius(radius).cast_from_inside(ray)?;
    (hit.distance > 0.0 && hit.normal.dot(ray.direction) < 0.0).then_some((hit.distance, hit.normal))
}

/// The speed away from the inside of a curve with which a ball that is pressed to it rides round in short chords;
/// `None` where there is no curve to ride.
fn ride(obstacle: &Obstacle, ball: &crate::ball::Ball, approach: f64) -> Option<f64> {
    let Core::Arc(arc) = &obstacle.shape.core else { return None };
    let radius = arc.circle().radius - obstacle.shape.radius;
    let inward = arc.circle().center - ball.center;
    let normal = obstacle.shape.distance(ball.center).1;
    if radius <= 0.0 || inward.dot(normal) <= 0.0 || approach <= 0.0 {
        return None;
    }
    let along = ball.velocity.dot(normal.perp()).abs();
    Some(along * (2.0 * CHORD_M / radius).sqrt())
}

/// Gives back along the wall what a ride round a curve does not lose: a smooth curve turns the ball without work.
fn keep_speed(velocity: &mut DVec2, normal: DVec2, away: f64, kept: f64) {
    let along = velocity.dot(normal.perp());
    let speed = (along * along + kept * kept - away * away).max(0.0).sqrt();
    *velocity = normal * away + normal.perp() * speed.copysign(along);
}

fn is_out_of_reach(blade: &Blade, center: DVec2, travel: f64) -> bool {
    let reach = blade.reach + BALL_RADIUS_M + travel;
    center.distance_squared(blade.pivot()) > reach * reach
}

/// When two balls meet, `away` from each other and moving at `velocity` against each other, and the normal.
fn meet(away: DVec2, velocity: DVec2) -> Option<(f64, DVec2)> {
    let touching = 2.0 * BALL_RADIUS_M;
    let distance = away.length();
    let closing = -away.dot(velocity);
    if closing <= STILL_M_S * distance {
        return None;
    }
    if distance - touching <= TOUCH_M {
        return Some((0.0, away.try_normalize().unwrap_or(DVec2::Y)));
    }
    let gap = (distance - touching) * (distance + touching);
    let square = closing * closing - velocity.length_squared() * gap;
    if square < 0.0 {
        return None;
    }
    let time = gap / (closing + square.sqrt());
    Some((time, (away + velocity * time).try_normalize()?))
}

/// When a ball meets a turning flipper, and the normal.
///
/// Conservative advancement in the flipper's frame: there the flipper is convex and stands still, so the distance falls
/// no faster than along the present normal, but for what the turning frame bends the ball's way (Coriolis and
/// centrifugal), which is bounded. Each step goes as far as the ball cannot have arrived.
fn meet_flipper(
    blade: &Blade,
    angle: f64,
    turn: f64,
    center: DVec2,
    velocity: DVec2,
    left: f64,
) -> Option<(f64, DVec2)> {
    let farthest = center.distance(blade.pivot()) + velocity.length() * left;
    let bend = turn.abs() * (2.0 * velocity.length() + turn.abs() * farthest);
    let mut time = 0.0;
    for _ in 0..64 {
        let place = center + velocity * time;
        let (distance, normal) = blade.taper(angle + turn * time).distance(place);
        let gap = distance - BALL_RADIUS_M;
        let lever = place - blade.pivot();
        let opening = (velocity - lever.perp() * turn).dot(normal);
        if gap <= HIT_M && opening < -STILL_M_S {
            return Some((time, normal));
        }
        let least = if gap <= HIT_M { left / 8.0 } else { 0.0 };
        time += safe_time(gap.max(0.0), opening, bend)?.max(least);
        if time > left {
            return None;
        }
    }
    None
}

/// The first time at which `gap + opening t - bend t^2 / 2` can be 0; `None` if never.
fn safe_time(gap: f64, opening: f64, bend: f64) -> Option<f64> {
    if bend <= 0.0 {
        return (opening < 0.0).then(|| gap / -opening);
    }
    let root = (opening * opening + 2.0 * bend * gap).sqrt();
    if opening >= 0.0 { Some((opening + root) / bend) } else { Some(2.0 * gap / (root - opening)) }
}
