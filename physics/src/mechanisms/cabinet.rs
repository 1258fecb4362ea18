//! Cabinet: it rings on its legs when it is nudged; the tilt bob hangs in it, and the slam switch sits on its door.
//!
//! A push is half a sine wave of 25 ms. It is often said to have a peak of about 0.5 g and to move the cabinet by 3 to
//! 5 mm, but both at once cannot be: a push of peak `a` gives the speed `a * 25 ms * 2 / pi`, and the cabinet goes as far
//! as that over its natural frequency, with 0.5 g 1.3 mm sideways and 2.1 mm forwards. How far it goes is what saves a
//! ball, so that is kept here; 0.5 g is then the cabinet's mean acceleration while it is pushed.

use crate::mechanisms::controls::Controls;
use crate::{GRAVITY_M_S2, TICK_S};
use geometry::DVec2;
use serde::{Deserialize, Serialize};

/// How long a push lasts.
const NUDGE_TICKS: u16 = 25;
/// Peak acceleration of a calm push, sideways and forwards or backwards, m/s^2: the cabinet moves by 3.2 mm.
const NUDGE_M_S2: DVec2 = DVec2::new(13.5, 8.0);
/// Build-up of nudges: a player who pushes again before he stands firm pushes with more of his weight, by so much harder...
const NUDGE_BUILDUP_GAIN: f64 = 1.2;
/// ... fading with this time constant.
const NUDGE_BUILDUP_S: f64 = 0.4;
/// Natural frequency of the cabinet on its legs, sideways and forwards, rad/s: 9.3 and 5.8 Hz.
const RING_RAD_S: DVec2 = DVec2::new(9.3 * std::f64::consts::TAU, 5.8 * std::f64::consts::TAU);
/// Damping ratio of the same.
const RING_DAMPING: DVec2 = DVec2::new(0.052, 0.055);
/// Length of the tilt bob's pendulum, m.
const BOB_LENGTH_M: f64 = 0.10;
/// Its natural frequency, squared, 1/s^2.
const BOB_RAD2_S2: f64 = GRAVITY_M_S2 / BOB_LENGTH_M;
/// Damping rate of the bob's swing, 1/s.
const BOB_DAMPING_PER_S: f64 = 2.0;
/// How far the bob swings before it touches its ring, m.
const BOB_RING_M: f64 = 0.0043;
/// Debounce: a touch so soon after the last touch is the same touch.
const BOB_DEBOUNCE_TICKS: u16 = 300;
/// The slam switch is a weight on a leaf spring that creeps back with this time constant: a leaky integrator of pushes...
const SLAM_S: f64 = 0.4;
/// ... until it closes: at so many times what one calm push does to it. Three pushes, however hasty, come to 5.9 at
/// most; five at even distances within 600 ms come to 6.7 at least. It opens again at half of that.
const SLAM_NUDGES: f64 = 6.3;
/// What one calm push does to it: the mean of half a sine wave, for as long as the push lasts.
const CALM_NUDGE_S: f64 = 2.0 / std::f64::consts::PI * NUDGE_TICKS as f64 * TICK_S;

#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Cabinet {
    /// From where it stands, m.
    pub offset: DVec2,
    pub velocity: DVec2,
    /// The bob from where it hangs, in the cabinet.
    bob: DVec2,
    bob_velocity: DVec2,
    /// For pushes to the right, to the left, forwards and backwards: ticks that the push still lasts.
    pushes: [u16; 4],
    /// How hard each of them is, over a calm one.
    force: [f64; 4],
    /// How many pushes the player has not yet recovered from, fading.
    nudge_buildup: f64,
    /// The buttons in the last tick.
    pressed: [bool; 4],
    /// Debounce: ticks until a touch of the bob counts again.
    bob_debounce: u16,
    /// How far the slam switch is bent, in calm pushes.
    slam_integrator: f64,
    /// The slam switch is closed.
    slammed: bool,
}

/// What a tick of the cabinet does to what stands in it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct CabinetMotion {
    /// The cabinet's acceleration, m/s^2.
    pub acceleration: DVec2,
    /// The bob has touched its ring.
    pub bob: bool,
    /// The slam switch has closed.
    pub slam: bool,
}

impl Default for Cabinet {
    fn default() -> Cabinet {
        Cabinet {
            offset: DVec2::ZERO,
            velocity: DVec2::ZERO,
            bob: DVec2::ZERO,
            bob_velocity: DVec2::ZERO,
            pushes: [0; 4],
            force: [0.0; 4],
            nudge_buildup: 0.0,
            pressed: [false; 4],
            bob_debounce: 0,
            slam_integrator: 0.0,
            slammed: false,
        }
    }
}

impl Cabinet {
    /// One tick.
    pub fn tick(&mut self, controls: &Controls) -> CabinetMotion {
        let pressed = [controls.nudge_left, controls.nudge_right, controls.nudge_up, controls.nudge_down];
        for (index, &now) in pressed.iter().enumerate() {
            if now && !self.pressed[index] {
                self.pushes[index] = NUDGE_TICKS;
                self.force[index] = 1.0 + NUDGE_BUILDUP_GAIN * self.nudge_buildup;
                self.nudge_buildup += 1.0;
            }
        }
        self.nudge_buildup *= 1.0 - TICK_S / NUDGE_BUILDUP_S;
        self.pressed = pressed;
        let push = self.push();
        let stiffness = RING_RAD_S * RING_RAD_S;
        let acceleration = push - self.offset * stiffness - self.velocity * (2.0 * RING_DAMPING * RING_RAD_S);
        self.velocity += acceleration * TICK_S;
        self.offset += self.velocity * TICK_S;
        CabinetMotion { acceleration, bob: self.swing(acceleration), slam: self.bend_slam(push) }
    }

    /// Acceleration by the hands: half a sine wave for each push.
    fn push(&mut self) -> DVec2 {
        let ways = [DVec2::X, DVec2::NEG_X, DVec2::NEG_Y, DVec2::Y];
        let mut sum = DVec2::ZERO;
        for ((left, force), way) in self.pushes.iter_mut().zip(self.force).zip(ways) {
            if *left > 0 {
                let phase = (f64::from(*left) - 0.5) / f64::from(NUDGE_TICKS);
                sum += way * force * NUDGE_M_S2 * libm::sin(phase * std::f64::consts::PI);
                *left -= 1;
            }
        }
        sum
    }

    fn swing(&mut self, acceleration: DVec2) -> bool {
        let pull = -acceleration - self.bob * BOB_RAD2_S2 - self.bob_velocity * BOB_DAMPING_PER_S;
        self.bob_velocity += pull * TICK_S;
        self.bob += self.bob_velocity * TICK_S;
        self.bob_debounce = self.bob_debounce.saturating_sub(1);
        let touches = self.bob.length() > BOB_RING_M;
        let counted = touches && self.bob_debounce == 0;
        if counted {
            self.bob_debounce = BOB_DEBOUNCE_TICKS;
        }
        counted
    }

    /// The slam switch answers to what the hands do, alike in all directions, and not to how the cabinet rings. True
    /// when it closes.
    fn bend_slam(&mut self, push: DVec2) -> bool {
        self.slam_integrator *= 1.0 - TICK_S / SLAM_S;
        self.slam_integrator += (push / NUDGE_M_S2).length() * TICK_S / CALM_NUDGE_S;
        let before = self.slammed;
        self.slammed = self.slam_integrator > if before { 0.5 * SLAM_NUDGES } else { SLAM_NUDGES };
        self.slammed && !before
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_bob_is_a_pendulum_of_ten_centimetres() {
        let mut cabinet = Cabinet { bob: DVec2::X * 1e-3, ..Cabinet::default() };
        let mut turns = Vec::new();
        for tick in 0..3000 {
            let before = cabinet.bob.x;
            cabinet.swing(DVec2::ZERO);
            if before < 0.0 && cabinet.bob.x >= 0.0 {
                turns.push(tick);
            }
        }
        let period_s = f64::from(turns[2] - turns[0]) * 0.5 * TICK_S;
        let wanted_s = std::f64::consts::TAU * (BOB_LENGTH_M / GRAVITY_M_S2).sqrt();
        assert!((period_s / wanted_s - 1.0).abs() < 0.03, "{period_s} s, not {wanted_s} s");
    }
}
