//! A flipper: a rotor with one degree of freedom, a coil, a return spring and two stops.
//!
//! On its way up the coil's plunger, the link, the shaft and the bat turn as one. At the end of the stroke the plunger
//! shuts its magnetic gap and is *home*: it holds like a wall for as long as there is current. The bat goes on through
//! the play of the link's bushing, is caught by a stop behind it and creeps back through the grease. While it rides on a
//! film of that it is light and soft: a ball that meets it then moves the bat alone, against a spring and a damper. The
//! film is squeezed out in some milliseconds; then nothing gives. Nothing else makes a live catch.
//!
//! Refuses to know what a ball is: balls turn it through [`Rotor::push`].

use crate::TICK_S;
use crate::layout::Flipper;
use geometry::{Circle, DVec2, Taper, trig};
use serde::{Deserialize, Serialize};

/// Time constant with which the coil's force builds up: inductance over resistance, and the eddy currents of the iron.
const COIL_RISE_S: f64 = 0.0085;
/// Time constant with which it falls to what the hold winding alone gives.
const COIL_HOLD_S: f64 = 0.020;
/// Time constant with which it dies away through the diode.
const COIL_FALL_S: f64 = 0.003;
/// The end-of-stroke switch leaves only the hold winding in this last part of the stroke; the force takes its
/// time to fall to that, so the plunger is pressed hard while it comes home.
const END_OF_STROKE_RAD: f64 = 5.0 * std::f64::consts::PI / 180.0;
/// Natural frequency of what turns on a rubber stop: it stays in it for a little over a millisecond.
const STOP_RAD_S: f64 = 1300.0;
/// Damping ratio of the stop: it throws the flipper back with 0.3 of its speed.
const STOP_DAMPING: f64 = 0.45;
/// The bat's own part of the moment of inertia; the rest is the plunger's, the link's and the shaft's.
const BAT: f64 = 0.3;
/// How far the bat can go on when the plunger is home.
const PLAY_RAD: f64 = 1.5 * std::f64::consts::PI / 180.0;
/// Natural frequency of the bat on the bushing.
const LINK_RAD_S: f64 = 1000.0;
/// Damping ratio of the bat on the bushing: greased, it creeps.
const LINK_DAMPING: f64 = 2.9;
/// Turning draws grease into the bushing; it is squeezed out again with this time constant.
const SQUEEZE_S: f64 = 0.0035;
/// Until it throws the ball back the rubber gives by what the ball goes in this time.
const BLOW_S: f64 = 0.7e-4;
/// Slower than this and near its stop, the flipper has come to rest.
const REST_RAD_S: f64 = 0.3;
/// How far the lower stop gives when the flipper comes to rest in it, at most.
const REST_RAD: f64 = 2e-3;
/// How little play is left when the bat has come to rest on the plunger.
const REST_PLAY_RAD: f64 = 1e-3;

/// Steps in a tick while a flipper moves near a ball: 32 kHz...
pub(crate) const FINE_STEPS: u32 = 32;
/// ... and while its bat only creeps home, slower than this.
const CREEP_STEPS: u32 = 8;
const CREEP_RAD_S: f64 = 6.0;

/// The numbers of a flipper that never change.
#[derive(Clone, Debug)]
pub(crate) struct Blade {
    pub part: u16,
    pub flipper: Flipper,
    /// kg m^2, of all that turns.
    inertia: f64,
    /// 1 where the stroke goes from x towards y, else -1.
    sense: f64,
    stroke: f64,
    /// How far from the pivot the outline ends.
    pub reach: f64,
    /// Those of play, the most wanted first: exponentials at every step would cost more than all else that a flipper does.
    paces: [Pace; 3],
}

/// How a step is gone through.
#[derive(Clone, Copy, Debug)]
struct Pace {
    /// Of the step, s.
    duration: f64,
    /// Of the rotor's own steps, s...
    own_step: f64,
    /// ... and how many there are.
    count: u32,
    /// What the coil's force keeps in the step, in the order of [`Goal`]...
    keeps: [f64; 3],
    /// ... and in half a step of the rotor's own.
    half_keeps: [f64; 3],
}

impl Pace {
    fn new(duration: f64) -> Pace {
        let count = (duration / OWN_STEP_S).ceil().max(2.0);
        let keeps = |time: f64| [COIL_FALL_S, COIL_RISE_S, COIL_HOLD_S].map(|constant| libm::exp(-time / constant));
        Pace {
            duration,
            own_step: duration / count,
            count: count as u32,
            keeps: keeps(duration),
            half_keeps: keeps(0.5 * duration / count),
        }
    }
}

/// Where the coil's force goes: to nothing, to its most, or to what the hold winding alone gives.
#[derive(Clone, Copy, Debug)]
enum Goal {
    Nothing,
    Most,
    Hold,
}

/// A rotor's own steps are no longer than this, and there are two at least in one of the balls.
const OWN_STEP_S: f64 = TICK_S / 64.0;

/// What a flipper is doing.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Rotor {
    pub angle: f64,
    /// rad/s.
    pub speed: f64,
    /// Torque of the coil, N m.
    coil: f64,
    /// What the speed will have changed by at the end of the step, apart from what balls do to it.
    pub rest_of_step: f64,
    /// The plunger has shut its gap.
    home: bool,
    /// How far the bat has turned in its bushing of late, rad: the film of grease that it rides on.
    film: f64,
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
            paces: [FINE_STEPS, 1, CREEP_STEPS].map(|steps| Pace::new(TICK_S / f64::from(steps))),
        }
    }

    pub fn at_rest(&self) -> Rotor {
        let angle = self.flipper.rest_rad;
        Rotor { angle, speed: 0.0, coil: 0.0, rest_of_step: 0.0, home: false, film: 0.0, seated: true }
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
    #[inline(always)]
    fn along(&self, angle: f64) -> f64 {
        self.sense * (angle - self.flipper.rest_rad)
    }

    /// Torque of coil and spring, positive when it lifts.
    pub fn lift(&self, rotor: &Rotor) -> f64 {
        rotor.coil - self.flipper.spring_torque_n_m
    }

    /// Angular acceleration, positive when it lifts.
    #[inline(always)]
    fn acceleration(&self, rotor: &Rotor) -> f64 {
        let (along, speed) = (self.along(rotor.angle), self.sense * rotor.speed);
        if rotor.home {
            let past = along - self.stroke;
            let link = -past * LINK_RAD_S * LINK_RAD_S - speed * 2.0 * LINK_DAMPING * LINK_RAD_S;
            link - stop(past - PLAY_RAD, speed)
        } else {
            self.lift(rotor) / self.inertia + stop(-along, -speed) - stop(along - self.stroke - PLAY_RAD, speed)
        }
    }

    /// No torque but a ball's changes its speed faster than this at present, rad/s^2.
    pub fn most_acceleration(&self, rotor: &Rotor) -> f64 {
        self.acceleration(rotor).abs().max(self.flipper.coil_torque_n_m / self.inertia)
    }

    /// Whether the flipper is nearer to the end of its stroke than to its rest.
    pub fn is_raised(&self, rotor: &Rotor) -> bool {
        self.along(rotor.angle) > 0.5 * self.stroke
    }

    fn coil_goal(&self, rotor: &Rotor, pressed: bool) -> (Goal, f64) {
        let near_end = self.along(rotor.angle) > self.stroke - END_OF_STROKE_RAD;
        match (pressed, near_end) {
            (false, _) => (Goal::Nothing, 0.0),
            (true, false) => (Goal::Most, self.flipper.coil_torque_n_m),
            (true, true) => (Goal::Hold, self.flipper.hold_torque_n_m),
        }
    }

    /// Lets the coil's force follow its button for a step, and frees the flipper where that lifts it off its stop.
    /// True if the flipper may now move.
    fn energise(&self, rotor: &mut Rotor, pressed: bool, pace: &Pace) -> bool {
        let (goal, torque) = self.coil_goal(rotor, pressed);
        // A force that is where it goes stays there.
        if rotor.coil != torque {
            rotor.coil = torque + (rotor.coil - torque) * pace.keeps[goal as usize];
        }
        rotor.home &= self.is_kept_home(rotor);
        rotor.seated &= self.is_pressed_on_a_stop(rotor);
        !rotor.seated
    }

    fn pace(&self, duration: f64) -> Pace {
        let known = self.paces.iter().find(|pace| pace.duration == duration);
        known.copied().unwrap_or_else(|| Pace::new(duration))
    }

    /// In how many steps a tick is to be cut while the flipper moves near a ball.
    pub fn steps(&self, rotor: &Rotor) -> u32 {
        if rotor.home && !rotor.seated && rotor.speed.abs() < CREEP_RAD_S { CREEP_STEPS } else { FINE_STEPS }
    }

    /// The coil follows its button, and torques act, for `duration`: until its end the flipper goes with its mean speed.
    ///
    /// The stop and the link are stiff, so this goes in finer steps than the balls do.
    pub fn turn(&self, rotor: &mut Rotor, pressed: bool, duration: f64) {
        let (goal, torque) = self.coil_goal(rotor, pressed);
        let pace = self.pace(duration);
        let mut free = *rotor;
        if !self.energise(rotor, pressed, &pace) {
            return;
        }
        (free.home, free.seated) = (rotor.home, false);
        let half = pace.half_keeps[goal as usize];
        for _ in 0..pace.count {
            free.coil = torque + (free.coil - torque) * half;
            self.go_on(&mut free, pace.own_step);
            free.coil = torque + (free.coil - torque) * half;
        }
        rotor.film = if free.home { free.film } else { 0.0 };
        let mean = (free.angle - rotor.angle) / duration;
        rotor.rest_of_step = free.speed - mean;
        rotor.speed = mean;
    }

    /// Whether the flipper moves, or will within `duration`.
    pub fn will_move(&self, rotor: &Rotor, pressed: bool, duration: f64) -> bool {
        !rotor.seated || self.energise(&mut { *rotor }, pressed, &self.pace(duration))
    }

    /// Whether the plunger is pressed home: by its coil, or by the bat that pulls it along.
    #[inline(always)]
    fn is_kept_home(&self, rotor: &Rotor) -> bool {
        self.lift(rotor) > 0.0 || self.sense * rotor.speed > 0.0
    }

    fn is_pressed_on_a_stop(&self, rotor: &Rotor) -> bool {
        rotor.home || (self.along(rotor.angle) <= 0.0 && self.lift(rotor) <= 0.0)
    }

    /// Turns freely for `duration`; where the plunger comes home on the way, from there on as the bat alone.
    #[inline(always)]
    fn go_on(&self, free: &mut Rotor, duration: f64) {
        let after = self.ahead(free, duration);
        let (start, end) = (self.along(free.angle) - self.stroke, self.along(after.angle) - self.stroke);
        let comes_home = !free.home && start < 0.0 && end >= 0.0 && self.is_kept_home(&after);
        if !comes_home {
            *free = after;
            return;
        }
        let way = start / (start - end) * duration;
        let home = Rotor { home: true, film: 0.0, ..self.ahead(free, way) };
        *free = self.ahead(&home, duration - way);
    }

    /// A flipper after `duration` under its own torques, by the midpoint rule.
    ///
    /// In line with all that it calls: a rotor that stays in registers turns in half the time.
    #[inline(always)]
    fn ahead(&self, rotor: &Rotor, duration: f64) -> Rotor {
        let after = |middle: &Rotor, time: f64| Rotor {
            angle: rotor.angle + middle.speed * time,
            speed: rotor.speed + self.sense * self.acceleration(middle) * time,
            // There is none while the plunger is away from home.
            film: if rotor.home { rotor.film + (middle.speed.abs() - middle.film / SQUEEZE_S) * time } else { 0.0 },
            ..*rotor
        };
        after(&after(rotor, 0.5 * duration), duration)
    }

    /// The flipper has turned: its plunger may have come home, and it may have come to rest.
    pub fn settle(&self, rotor: &mut Rotor) {
        rotor.speed += std::mem::take(&mut rotor.rest_of_step);
        let along = self.along(rotor.angle);
        rotor.home |= along >= self.stroke && self.is_kept_home(rotor);
        let there = match rotor.home {
            true => (along - self.stroke).abs().max(rotor.film) < REST_PLAY_RAD,
            false => (0.0..REST_RAD).contains(&-along),
        };
        let slow = rotor.speed.abs() < REST_RAD_S;
        if !rotor.seated && slow && there && self.is_pressed_on_a_stop(rotor) {
            rotor.seated = true;
            rotor.speed = 0.0;
        }
    }

    /// One over the moment of inertia against a push at the lever `arm`, m, that turns it the way of the arm's sign, by
    /// something that comes at `approach`, m/s: 0 where it is rigid.
    ///
    /// A flipper that lies on its lower stop gives way only upwards; one that lies still at the end of its stroke gives
    /// way to nothing: with its gap shut the coil holds far harder than a ball can push. In between, the rubber takes a
    /// little way to throw a ball back. Where the film under the bat is thinner than that, the bat is up against the
    /// plunger before the blow is over: it gives by the part of the blow's work that the film takes.
    pub fn inverse_inertia(&self, rotor: &Rotor, arm: f64, approach: f64) -> f64 {
        if rotor.seated && (rotor.home || arm * self.sense <= 0.0) {
            return 0.0;
        }
        if !rotor.home {
            return 1.0 / self.inertia;
        }
        let (play, blow) = (rotor.film * arm.abs(), approach.max(0.0) * BLOW_S);
        let part = if play < blow { (play / blow) * (play / blow) } else { 1.0 };
        part / (BAT * self.inertia)
    }
}

/// Angular acceleration by a stop into which something has turned by `depth` at `speed`. A stop pushes and never pulls.
#[inline(always)]
fn stop(depth: f64, speed: f64) -> f64 {
    if depth <= 0.0 {
        return 0.0;
    }
    (depth * STOP_RAD_S * STOP_RAD_S + speed * 2.0 * STOP_DAMPING * STOP_RAD_S).max(0.0)
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
