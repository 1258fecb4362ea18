//! A flipper: a rotor with one degree of freedom, a coil, a return spring and two stops.
//!
//! Refuses to know what a ball is: balls turn it through [`Rotor::push`].

use crate::Flipper;
use geometry::{Circle, DVec2, Taper, trig};
use serde::{Deserialize, Serialize};

/// Time constant with which the coil's force builds up: inductance over resistance, and the eddy currents of the iron.
const COIL_RISE_S: f64 = 0.0085;
/// Time constant with which it falls to what the hold winding alone gives.
const COIL_HOLD_S: f64 = 0.020;
/// Time constant with which it dies away through the diode.
const COIL_FALL_S: f64 = 0.003;
/// The end-of-stroke switch leaves only the hold winding in this last part of the stroke; the force takes its
/// time to fall to that, so the flipper is pressed hard while it bounces on its stop.
const END_OF_STROKE_RAD: f64 = 5.0 * std::f64::consts::PI / 180.0;
/// Natural frequency of the flipper on its rubber stop: it stays in it for a little over a millisecond.
const STOP_RAD_S: f64 = 1300.0;
/// Damping ratio of the stop: it throws the flipper back with 0.3 of its speed.
const STOP_DAMPING: f64 = 0.45;
/// Slower than this and near its stop, the flipper has come to rest.
const REST_RAD_S: f64 = 0.3;
/// How far the stop gives when the flipper comes to rest in it, at most.
const REST_RAD: f64 = 2e-3;

/// The numbers of a flipper that never change.
#[derive(Clone, Debug)]
pub(crate) struct Blade {
    pub part: u16,
    pub flipper: Flipper,
    /// kg m^2.
    pub inertia: f64,
    /// 1 where the stroke goes from x towards y, else -1.
    sense: f64,
    stroke: f64,
    /// How far from the pivot the outline ends.
    pub reach: f64,
}

/// Steps of the rotor's own in one step of the balls.
const STOP_STEPS: u32 = 2;

/// What a flipper is doing.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Rotor {
    pub angle: f64,
    /// rad/s.
    pub speed: f64,
    /// Torque of the coil, N m.
    coil: f64,
    /// What the speed will have changed by at the end of the step, apart from what balls do to it.
    rest_of_step: f64,
    /// It lies on a stop and is pressed on it: nothing that a ball can do turns it into the stop.
    pub seated: bool,
}

impl Blade {
    pub fn new(part: u16, flipper: &Flipper) -> Blade {
        let end = flipper.length_m + flipper.tip_radius_m;
        let sweep = flipper.up_rad - flipper.rest_rad;
        Blade {
            part,
            inertia: flipper.mass_kg * end * end / 3.0,
            sense: 1.0_f64.copysign(sweep),
            stroke: sweep.abs(),
            reach: end.max(flipper.base.radius),
            flipper: flipper.clone(),
        }
    }

    pub fn at_rest(&self) -> Rotor {
        Rotor { angle: self.flipper.rest_rad, speed: 0.0, coil: 0.0, rest_of_step: 0.0, seated: true }
    }

    /// The outline at `angle`.
    pub fn taper(&self, angle: f64) -> Taper {
        let Flipper { base, length_m, tip_radius_m, .. } = self.flipper;
        let tip = Circle { center: base.center + trig::direction(angle) * length_m, radius: tip_radius_m };
        Taper { a: base, b: tip }
    }

    pub fn pivot(&self) -> DVec2 {
        self.flipper.base.center
    }

    /// How far along its stroke a flipper at `angle` is, rad: 0 at rest, `stroke` when up.
    fn along(&self, angle: f64) -> f64 {
        self.sense * (angle - self.flipper.rest_rad)
    }

    /// Torque of coil and spring, positive when it lifts.
    fn lift(&self, rotor: &Rotor) -> f64 {
        rotor.coil - self.flipper.spring_torque_n_m
    }

    /// Torque of the stops, positive when it lifts. A stop pushes and never pulls.
    fn stop(&self, rotor: &Rotor) -> f64 {
        let (along, speed) = (self.along(rotor.angle), self.sense * rotor.speed);
        let stiffness = self.inertia * STOP_RAD_S * STOP_RAD_S;
        let damping = self.inertia * 2.0 * STOP_DAMPING * STOP_RAD_S;
        if along < 0.0 {
            (-along * stiffness - speed * damping).max(0.0)
        } else if along > self.stroke {
            ((self.stroke - along) * stiffness - speed * damping).min(0.0)
        } else {
            0.0
        }
    }

    /// Whether the flipper is nearer to the end of its stroke than to its rest.
    pub fn is_raised(&self, rotor: &Rotor) -> bool {
        self.along(rotor.angle) > 0.5 * self.stroke
    }

    /// Lets the coil's force follow its button for `duration`, and frees the flipper where that lifts it off its stop.
    /// True if the flipper may now move.
    pub fn energise(&self, rotor: &mut Rotor, pressed: bool, duration: f64) -> bool {
        let near_end = self.along(rotor.angle) > self.stroke - END_OF_STROKE_RAD;
        let (goal, time_constant) = match (pressed, near_end) {
            (false, _) => (0.0, COIL_FALL_S),
            (true, false) => (self.flipper.coil_torque_n_m, COIL_RISE_S),
            (true, true) => (self.flipper.hold_torque_n_m, COIL_HOLD_S),
        };
        rotor.coil = goal + (rotor.coil - goal) * libm::exp(-duration / time_constant);
        rotor.seated &= self.is_pressed_on_a_stop(rotor);
        !rotor.seated
    }

    /// Whether the flipper moves, or will within `duration`.
    pub fn will_move(&self, rotor: &Rotor, pressed: bool, duration: f64) -> bool {
        !rotor.seated || self.energise(&mut { *rotor }, pressed, duration)
    }

    fn is_pressed_on_a_stop(&self, rotor: &Rotor) -> bool {
        let (along, lift) = (self.along(rotor.angle), self.lift(rotor));
        (along <= 0.0 && lift <= 0.0) || (along >= self.stroke && lift >= 0.0)
    }

    /// Torques act for `duration`: until its end the flipper goes with its mean speed.
    ///
    /// The stop is stiff, so this goes in finer steps than the balls do.
    pub fn accelerate(&self, rotor: &mut Rotor, duration: f64) {
        if rotor.seated {
            return;
        }
        let fine = duration / f64::from(STOP_STEPS);
        let mut free = *rotor;
        for _ in 0..STOP_STEPS {
            let torque = self.lift(&free) + self.stop(&free);
            free.speed += self.sense * torque / self.inertia * fine;
            free.angle += free.speed * fine;
        }
        let mean = (free.angle - rotor.angle) / duration;
        rotor.rest_of_step = free.speed - mean;
        rotor.speed = mean;
    }

    /// The flipper has turned: it may have come to rest on a stop.
    pub fn settle(&self, rotor: &mut Rotor) {
        rotor.speed += std::mem::take(&mut rotor.rest_of_step);
        let along = self.along(rotor.angle);
        let depth = (-along).max(along - self.stroke);
        let slow = rotor.speed.abs() < REST_RAD_S && (0.0..REST_RAD).contains(&depth);
        if !rotor.seated && slow && self.is_pressed_on_a_stop(rotor) {
            rotor.seated = true;
            rotor.speed = 0.0;
        }
    }

    /// One over the moment of inertia against a push that turns it the way of `turn`'s sign: 0 where it is rigid.
    ///
    /// A flipper that lies on its lower stop gives way only upwards; one that the coil holds up gives way to nothing:
    /// with its gap closed the coil holds far harder than a ball can push.
    pub fn inverse_inertia(&self, rotor: &Rotor, turn: f64) -> f64 {
        let lifted_off = self.along(rotor.angle) <= 0.0 && turn * self.sense > 0.0;
        if rotor.seated && !lifted_off { 0.0 } else { 1.0 / self.inertia }
    }
}

impl Rotor {
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
