//! Step acceleration: how velocity and spin of a free ball change in a step, by gravity, sliding friction and rolling
//! resistance.
//!
//! The sweep needs a straight path with an even acceleration, so the step's whole change is computed first and then
//! spread evenly over the step.

use crate::BALL_RADIUS_M;
use crate::ball::floor::Floor;
use crate::ball::{Ball, SPHERE_INERTIA};
use geometry::DVec2;
use glam::DVec3;

/// Coefficient of rolling resistance, deceleration over normal load: hard steel on lacquer.
const ROLLING_RESISTANCE: f64 = 2e-4;
/// Radius of the contact patch that the ball rests on, m; its friction slows the spin about the vertical.
const PATCH_RADIUS_M: f64 = 3e-4;
/// A slide that ends within the step goes on in pieces of this part of what is left of it: the direction of friction
/// turns faster and faster towards the end.
const SLIDE_PIECE: f64 = 0.3;
/// What is left of a slide is gone through at once when it is this part of the step.
const SLIDE_LAST_PIECE: f64 = 0.05;
/// A ball that would slide for no longer than this rolls, s: far above rounding, far below a step.
const MIN_SLIDE_S: f64 = 1e-9;
/// The end of a slide is looked for when friction can end it within so many steps; before that it only costs time.
const SLIDE_HORIZON_STEPS: f64 = 20.0;
/// Speed of the trembling of a ball that the hum has shaken loose, m/s. Dry friction under fast vibration (dither) acts
/// as a viscous one: below this speed the rolling resistance grows with the speed, so that no ball balances on a post.
const DITHER_M_S: f64 = 5e-4;

/// How velocity and spin change, per second.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct StepAcceleration {
    /// m/s^2.
    pub linear: DVec2,
    /// rad/s^2.
    pub angular: DVec3,
    /// Mean-velocity correction: how much faster than with an even acceleration the ball is on the mean of the step,
    /// because friction turns as the slip turns, m/s.
    pub mean_velocity_correction: DVec2,
    /// For how many seconds this holds, where that is less than asked for: friction turns quickly at a slide's end.
    pub valid_for: Option<f64>,
}

impl Ball {
    /// How the ball goes on for `duration` with nothing in its way, under an external acceleration, m/s^2.
    ///
    /// 1. The end of a slide is found, and the step cut there ([`Ball::sliding_time`]).
    /// 2. Half of the rolling resistance, then all else, then the other half: Strang's splitting, whose error is of the
    ///    third order (On the construction and comparison of difference schemes, SIAM J. Numer. Anal. 5, 1968).
    /// 3. In between, gravity, and Coulomb friction `mu N` against the slip. Friction never does more than end the slip:
    ///    the impulse that ends a slip `s` of a sphere is `-s I / (I + m r^2)`, 2/7 of it. A ball that rolls so keeps
    ///    rolling, and 5/7 of the external acceleration is left of itself.
    /// 4. The change is divided by the time.
    pub fn step_acceleration(&self, floor: &Floor, external: DVec2, duration: f64) -> StepAcceleration {
        let valid_for = self.sliding_time(floor, external, duration);
        let ends = valid_for.is_some_and(|time| time < SLIDE_LAST_PIECE * duration);
        let valid_for =
            valid_for.map(|time| if ends { time } else { SLIDE_PIECE * time }).filter(|&time| time < duration);
        let duration = valid_for.unwrap_or(duration);
        let mut after = *self;
        after.apply_rolling_resistance(floor, 0.5 * duration);
        after.velocity += external * duration;
        let slip = after.floor_slip();
        let sticking = slip * (-SPHERE_INERTIA / (1.0 + SPHERE_INERTIA));
        let cone = floor.friction * floor.normal_load * duration;
        let (impulse, mean_velocity_correction) = if ends || sticking.length_squared() <= cone * cone {
            (sticking, DVec2::ZERO)
        } else {
            let (mean, turn) = self.slip_directions(floor, external, duration);
            // An acceleration that turns evenly by `turn` in the step is ahead of its mean by `turn / 12` of the step.
            (mean * -cone, turn * (cone / 12.0))
        };
        after.apply_floor_impulse(impulse);
        after.apply_rolling_resistance(floor, 0.5 * duration);
        let (linear, angular) = ((after.velocity - self.velocity) / duration, (after.spin - self.spin) / duration);
        StepAcceleration { linear, angular, mean_velocity_correction, valid_for }
    }

    /// The mean of the unit vectors in which a sliding ball slips in the next `duration`, and by how much they change
    /// (by the fourth-order rule of Runge and Kutta): gravity turns the slip, and friction turns with it.
    fn slip_directions(&self, floor: &Floor, external: DVec2, duration: f64) -> (DVec2, DVec2) {
        let slip = self.floor_slip();
        let direction = |gained: DVec2| (slip + gained).normalize_or_zero();
        let gain = |direction: DVec2, time: f64| (external - direction * floor.slip_deceleration()) * time;
        let first = direction(DVec2::ZERO);
        let second = direction(gain(first, 0.5 * duration));
        let third = direction(gain(second, 0.5 * duration));
        let fourth = direction(gain(third, duration));
        ((first + (second + third) * 2.0 + fourth) / 6.0, fourth - first)
    }

    /// In what time friction ends the slip, if it does; only told where that is not many times `duration`.
    ///
    /// On the mean of the slide friction points along the whole slip that is lost, `s + a t`, and takes `k t` of it:
    /// `|s + a t| = k t`, a quadratic `(k^2 - a^2) t^2 - 2 (s.a) t - s^2 = 0`, of which the positive root is wanted.
    #[inline(always)]
    fn sliding_time(&self, floor: &Floor, external: DVec2, duration: f64) -> Option<f64> {
        let slip = self.floor_slip();
        if slip.length() > SLIDE_HORIZON_STEPS * floor.slip_deceleration() * duration {
            return None;
        }
        let (loss, own) = (floor.slip_deceleration(), external.length_squared());
        let (half, end) = (slip.dot(external), slip.length_squared());
        let discriminant = half * half + (loss * loss - own) * end;
        let time = (half + discriminant.max(0.0).sqrt()) / (loss * loss - own);
        (loss * loss > own && time > MIN_SLIDE_S).then_some(time)
    }

    /// Rolling resistance, and the drag of the contact patch on the spin about the vertical.
    ///
    /// The patch is a disc under even pressure: its friction torque is `2/3 mu N r_patch`.
    ///
    /// In line, or [`Ball::step_acceleration`] copies a whole ball for the little of it that changes.
    #[inline(always)]
    pub fn apply_rolling_resistance(&mut self, floor: &Floor, duration: f64) {
        let speed = self.velocity.length();
        let mut resistance = ROLLING_RESISTANCE * floor.normal_load;
        if self.dither_ticks > 0 {
            resistance *= (speed / DITHER_M_S).min(1.0);
        }
        if floor.drag > 0.0 {
            // What drags at the turning of the ball leaves a ball alone that slides without turning.
            resistance += floor.drag * (self.spin.truncate().length() * BALL_RADIUS_M / speed).min(1.0);
        }
        let loss = resistance * duration;
        let keep = if speed > loss { 1.0 - loss / speed } else { 0.0 };
        self.velocity *= keep;
        self.spin.x *= keep;
        self.spin.y *= keep;
        let drag = floor.friction * floor.normal_load * PATCH_RADIUS_M
            / (1.5 * SPHERE_INERTIA * BALL_RADIUS_M * BALL_RADIUS_M);
        self.spin.z -= self.spin.z.signum() * (drag * duration).min(self.spin.z.abs());
    }
}
