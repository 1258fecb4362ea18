//! Flipper model: a rotor with one degree of freedom, a coil, a return spring and two stops.
//!
//! The equation of motion is `I w' = coil - spring + stops`, with a torque of the coil that follows its goal with a time
//! constant. It is stiff (stops and link ring at 1000 rad/s and more), so a step of the balls is gone through in
//! substeps, each by Strang's splitting: half of the coil's decay, which is exact (an exponential integrator: Hochbruck
//! and Ostermann, Acta Numerica 19, 2010), the midpoint rule for the rest, the other half of the decay.
//!
//! On its way up the coil's plunger, the link, the shaft and the bat turn as one. At the end of the stroke the plunger
//! shuts its air gap and is *home*: it holds like a wall for as long as there is current. The bat goes on through
//! the play of the link's bushing, is caught by a stop behind it and creeps back through the grease. While it rides on a
//! film of that it is light and soft: a ball that meets it then moves the bat alone, against a spring and a damper. The
//! film is squeezed out in some milliseconds; then nothing gives. Nothing else makes a live catch.
//!
//! Refuses to know what a ball is: balls turn it through [`FlipperState::push`].

use crate::mechanisms::flipper::{Flipper, FlipperControl};
use crate::mechanisms::flipper_coil::{CoilGoal, CoilStep};
use crate::part::PartId;
use crate::{BALL_RADIUS_M, TICK_S};
use geometry::{DVec2, Taper};
use serde::{Deserialize, Serialize};

/// The end-of-stroke switch leaves only the hold winding in this last part of the stroke; the force takes its
/// time to fall to that, so the plunger is pressed hard while it comes home.
const END_OF_STROKE_RAD: f64 = 5.0 * std::f64::consts::PI / 180.0;
/// Natural frequency of the flipper on a rubber stop: it stays in the stop for a little over a millisecond.
const STOP_RAD_S: f64 = 1300.0;
/// Damping ratio of the stop: it throws the flipper back with 0.3 of its speed.
const STOP_DAMPING: f64 = 0.45;
/// The bat's share of the moment of inertia; the rest is the plunger's, the link's and the shaft's.
const BAT_INERTIA_SHARE: f64 = 0.3;
/// Play of the link: how far the bat can go on when the plunger is home.
const LINK_PLAY_RAD: f64 = 1.5 * std::f64::consts::PI / 180.0;
/// Natural frequency of the bat on the bushing.
const LINK_RAD_S: f64 = 1000.0;
/// Damping ratio of the bat on the bushing: greased, it creeps.
const LINK_DAMPING: f64 = 2.9;
/// Time constant with which the film of grease that turning draws into the bushing is squeezed out again.
const FILM_DECAY_S: f64 = 0.0035;
/// The bat's rubber gives by what the ball goes in this time before it throws the ball back.
const RUBBER_CONTACT_S: f64 = 0.7e-4;
/// A flipper slower than this near its stop has come to rest, rad/s.
const REST_RAD_S: f64 = 0.3;
/// How far the lower stop gives when the flipper comes to rest in it, at most.
const REST_RAD: f64 = 2e-3;
/// How little play is left when the bat has come to rest on the plunger.
const REST_FILM_RAD: f64 = 1e-3;

/// A ball no farther from a raised bat than this is cradled, m.
const CRADLE_GAP_M: f64 = 1e-3;

/// Substeps of a tick while a flipper moves near a ball: 32 kHz...
pub(crate) const FINE_SUBSTEPS: u32 = 32;
/// ... and while its bat only creeps home...
const CREEP_SUBSTEPS: u32 = 8;
/// ... slower than this, rad/s.
const CREEP_RAD_S: f64 = 6.0;

/// A flipper's numbers and what follows from them; nothing of it changes.
#[derive(Clone, Debug)]
pub(crate) struct FlipperModel {
    pub part: PartId,
    pub flipper: Flipper,
    /// kg m^2, of all that turns.
    inertia: f64,
    /// 1 where the stroke goes from x towards y, else -1.
    sense: f64,
    stroke: f64,
    /// How far from the pivot the outline ends.
    pub reach: f64,
    /// The decay coefficients of the steps of play, the most wanted first: exponentials at every step would cost more than
    /// all else that a flipper does.
    coil_steps: [CoilStep; 3],
}

/// Flipper state.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct FlipperState {
    pub angle: f64,
    /// rad/s.
    pub speed: f64,
    /// Torque of the coil, N m.
    coil: f64,
    /// The end's speed less the mean speed of the step, rad/s: what the speed will change by at the step's end, apart from
    /// what balls do to it.
    pub speed_correction: f64,
    /// The plunger has shut its gap.
    plunger_home: bool,
    /// How far the bat has turned in its bushing of late, rad: the film of grease that it rides on.
    film: f64,
    /// It lies on a stop and is pressed on it: nothing that a ball can do turns it into the stop.
    pub seated: bool,
}

impl FlipperModel {
    pub fn new(part: PartId, flipper: &Flipper) -> FlipperModel {
        let end = flipper.length_m + flipper.tip_radius_m;
        let sweep = flipper.up_rad - flipper.rest_rad;
        FlipperModel {
            part,
            inertia: flipper.mass_kg * end * end / 3.0,
            sense: 1.0_f64.copysign(sweep),
            stroke: sweep.abs(),
            reach: end.max(flipper.base.radius),
            flipper: flipper.clone(),
            coil_steps: [FINE_SUBSTEPS, 1, CREEP_SUBSTEPS].map(|steps| CoilStep::new(TICK_S / f64::from(steps))),
        }
    }

    pub fn at_rest(&self) -> FlipperState {
        let angle = self.flipper.rest_rad;
        FlipperState {
            angle,
            speed: 0.0,
            coil: 0.0,
            speed_correction: 0.0,
            plunger_home: false,
            film: 0.0,
            seated: true,
        }
    }

    /// The outline at `angle`.
    pub fn outline(&self, angle: f64) -> Taper {
        self.flipper.outline(angle)
    }

    pub fn pivot(&self) -> DVec2 {
        self.flipper.base.center
    }

    /// Whether a ball's centre cannot come to the flipper, whatever its angle, on a path of this length: roughly, and
    /// without a root.
    pub fn is_out_of_reach(&self, center: DVec2, path: f64) -> bool {
        let reach = self.reach + BALL_RADIUS_M + path;
        center.distance_squared(self.pivot()) > reach * reach
    }

    /// How far along its stroke a flipper at `angle` is, rad: 0 at rest, `stroke` when up.
    #[inline(always)]
    fn along(&self, angle: f64) -> f64 {
        self.sense * (angle - self.flipper.rest_rad)
    }

    /// Torque of coil and spring, positive when it lifts.
    pub fn lift(&self, state: &FlipperState) -> f64 {
        state.coil - self.flipper.spring_torque_n_m
    }

    /// Angular acceleration, positive when it lifts.
    #[inline(always)]
    fn acceleration(&self, state: &FlipperState) -> f64 {
        let (along, speed) = (self.along(state.angle), self.sense * state.speed);
        if state.plunger_home {
            let past = along - self.stroke;
            let link = -past * LINK_RAD_S * LINK_RAD_S - speed * 2.0 * LINK_DAMPING * LINK_RAD_S;
            link - stop(past - LINK_PLAY_RAD, speed)
        } else {
            self.lift(state) / self.inertia + stop(-along, -speed) - stop(along - self.stroke - LINK_PLAY_RAD, speed)
        }
    }

    /// Bound of the angular acceleration: no torque but a ball's changes the speed faster at present, rad/s^2.
    pub fn max_acceleration(&self, state: &FlipperState) -> f64 {
        self.acceleration(state).abs().max(self.flipper.coil_torque_n_m / self.inertia)
    }

    /// How fast the approach of a ball of this speed and the flipper that it rolls on can grow, m/s^2: by torques, by
    /// Coriolis and by centrifugal acceleration.
    pub fn approach_growth(&self, state: &FlipperState, ball_m_s: f64) -> f64 {
        if state.seated {
            return 0.0;
        }
        let torques = self.max_acceleration(state) * self.reach;
        let turn = state.speed.abs();
        torques + 2.0 * turn * ball_m_s + turn * turn * self.reach
    }

    /// Whether the flipper is nearer to the end of its stroke than to its rest.
    pub fn is_raised(&self, state: &FlipperState) -> bool {
        self.along(state.angle) > 0.5 * self.stroke
    }

    /// Whether it holds a ball whose centre is at `center` on its raised bat: a cradle, and no diverter.
    pub fn carries(&self, state: &FlipperState, center: DVec2) -> bool {
        let gap = self.outline(state.angle).distance(center).0 - BALL_RADIUS_M;
        gap < CRADLE_GAP_M && self.is_raised(state) && self.flipper.control != FlipperControl::Rules
    }

    fn coil_goal(&self, state: &FlipperState, pressed: bool) -> (CoilGoal, f64) {
        let near_end = self.along(state.angle) > self.stroke - END_OF_STROKE_RAD;
        match (pressed, near_end) {
            (false, _) => (CoilGoal::Nothing, 0.0),
            (true, false) => (CoilGoal::Most, self.flipper.coil_torque_n_m),
            (true, true) => (CoilGoal::Hold, self.flipper.hold_torque_n_m),
        }
    }

    /// Lets the coil's torque follow its button for a step, and frees the flipper where that lifts it off its stop.
    /// True if the flipper may now move.
    fn energise(&self, state: &mut FlipperState, pressed: bool, coil_step: &CoilStep) -> bool {
        let (goal, torque) = self.coil_goal(state, pressed);
        // A torque that is where it goes stays there.
        if state.coil != torque {
            state.coil = torque + (state.coil - torque) * coil_step.decay(goal);
        }
        state.plunger_home &= self.is_plunger_held_home(state);
        state.seated &= self.is_pressed_on_stop(state);
        !state.seated
    }

    fn coil_step(&self, duration: f64) -> CoilStep {
        let known = self.coil_steps.iter().find(|coil_step| coil_step.duration == duration);
        known.copied().unwrap_or_else(|| CoilStep::new(duration))
    }

    /// Substeps that a tick needs while the flipper moves near a ball.
    pub fn substeps(&self, state: &FlipperState) -> u32 {
        if state.plunger_home && !state.seated && state.speed.abs() < CREEP_RAD_S {
            CREEP_SUBSTEPS
        } else {
            FINE_SUBSTEPS
        }
    }

    /// The coil follows its button, and torques act, for `duration`: until its end the flipper goes with its mean speed.
    ///
    /// The stop and the link are stiff, so this goes in finer steps than the balls do.
    pub fn drive(&self, state: &mut FlipperState, pressed: bool, duration: f64) {
        let (goal, torque) = self.coil_goal(state, pressed);
        let coil_step = self.coil_step(duration);
        let mut free = *state;
        if !self.energise(state, pressed, &coil_step) {
            return;
        }
        (free.plunger_home, free.seated) = (state.plunger_home, false);
        let half = coil_step.half_decay(goal);
        for _ in 0..coil_step.substeps {
            free.coil = torque + (free.coil - torque) * half;
            self.advance_freely(&mut free, coil_step.substep);
            free.coil = torque + (free.coil - torque) * half;
        }
        state.film = if free.plunger_home { free.film } else { 0.0 };
        let mean = (free.angle - state.angle) / duration;
        state.speed_correction = free.speed - mean;
        state.speed = mean;
    }

    /// Whether the flipper moves, or will within `duration`.
    pub fn will_move(&self, state: &FlipperState, pressed: bool, duration: f64) -> bool {
        !state.seated || self.energise(&mut { *state }, pressed, &self.coil_step(duration))
    }

    /// Whether the plunger is pressed home: by its coil, or by the bat that pulls it along.
    #[inline(always)]
    fn is_plunger_held_home(&self, state: &FlipperState) -> bool {
        self.lift(state) > 0.0 || self.sense * state.speed > 0.0
    }

    fn is_pressed_on_stop(&self, state: &FlipperState) -> bool {
        state.plunger_home || (self.along(state.angle) <= 0.0 && self.lift(state) <= 0.0)
    }

    /// Turns freely for `duration`; where the plunger comes home on the way, from there on as the bat alone.
    #[inline(always)]
    fn advance_freely(&self, free: &mut FlipperState, duration: f64) {
        let after = self.midpoint_step(free, duration);
        let (start, end) = (self.along(free.angle) - self.stroke, self.along(after.angle) - self.stroke);
        let closes = !free.plunger_home && start < 0.0 && end >= 0.0 && self.is_plunger_held_home(&after);
        if !closes {
            *free = after;
            return;
        }
        let until = start / (start - end) * duration;
        let at_home = FlipperState { plunger_home: true, film: 0.0, ..self.midpoint_step(free, until) };
        *free = self.midpoint_step(&at_home, duration - until);
    }

    /// A flipper after `duration` under its own torques, by the midpoint rule (Hairer, Lubich and Wanner, Geometric
    /// Numerical Integration, 2006, II.1).
    ///
    /// In line with all that it calls: a state that stays in registers turns in half the time.
    #[inline(always)]
    fn midpoint_step(&self, state: &FlipperState, duration: f64) -> FlipperState {
        let after = |middle: &FlipperState, time: f64| FlipperState {
            angle: state.angle + middle.speed * time,
            speed: state.speed + self.sense * self.acceleration(middle) * time,
            // There is none while the plunger is away from home.
            film: if state.plunger_home {
                state.film + (middle.speed.abs() - middle.film / FILM_DECAY_S) * time
            } else {
                0.0
            },
            ..*state
        };
        after(&after(state, 0.5 * duration), duration)
    }

    /// The flipper has turned: its plunger may have come home, and it may have come to rest.
    pub fn end_step(&self, state: &mut FlipperState) {
        state.speed += std::mem::take(&mut state.speed_correction);
        let along = self.along(state.angle);
        state.plunger_home |= along >= self.stroke && self.is_plunger_held_home(state);
        let there = match state.plunger_home {
            true => (along - self.stroke).abs().max(state.film) < REST_FILM_RAD,
            false => (0.0..REST_RAD).contains(&-along),
        };
        let slow = state.speed.abs() < REST_RAD_S;
        if !state.seated && slow && there && self.is_pressed_on_stop(state) {
            state.seated = true;
            state.speed = 0.0;
        }
    }

    /// One over the moment of inertia against a push at the lever `arm`, m, that turns the flipper in the sense of the
    /// arm's sign, by a ball that comes at `approach`, m/s: 0 where the flipper is rigid.
    ///
    /// - A flipper on its lower stop yields only upwards.
    /// - A flipper that lies still at the end of its stroke does not yield: with its gap shut the coil holds far harder
    ///   than a ball can push.
    /// - Between its stops it yields with all its inertia.
    /// - While the bat rides on its film, the bat alone yields. The rubber takes a little way to throw a ball back; where
    ///   the film is thinner than that way, the bat is up against the plunger before the impact is over. Then it yields
    ///   by the part of the impact's work that the film takes, and a spring's work goes with the square of its way.
    pub fn inverse_inertia(&self, state: &FlipperState, arm: f64, approach: f64) -> f64 {
        if state.seated && (state.plunger_home || arm * self.sense <= 0.0) {
            return 0.0;
        }
        if !state.plunger_home {
            return 1.0 / self.inertia;
        }
        let (play, blow) = (state.film * arm.abs(), approach.max(0.0) * RUBBER_CONTACT_S);
        let part = if play < blow { (play / blow) * (play / blow) } else { 1.0 };
        part / (BAT_INERTIA_SHARE * self.inertia)
    }
}

/// Angular acceleration by a stop, a damped spring, into which the flipper has turned by `depth` at `speed`:
/// `w^2 depth + 2 D w speed`. A stop pushes and never pulls.
#[inline(always)]
fn stop(depth: f64, speed: f64) -> f64 {
    if depth <= 0.0 {
        return 0.0;
    }
    (depth * STOP_RAD_S * STOP_RAD_S + speed * 2.0 * STOP_DAMPING * STOP_RAD_S).max(0.0)
}

impl FlipperState {
    /// Gives the flipper `speed` more, rad/s, which frees it from its stop.
    pub fn push(&mut self, speed: f64) {
        if speed != 0.0 {
            self.speed += speed;
            self.seated = false;
        }
    }

    /// Turns on for `duration`.
    pub fn advance(&mut self, duration: f64) {
        self.angle += self.speed * duration;
    }

    /// Velocity of the flipper's material at `lever` from its pivot.
    pub fn velocity_at(&self, lever: DVec2) -> DVec2 {
        lever.perp() * self.speed
    }
}
