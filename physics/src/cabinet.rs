//! The cabinet: it rings on its legs when it is pushed, and the tilt bob hangs in it.

use crate::{Controls, TICK_S};
use geometry::DVec2;
use serde::{Deserialize, Serialize};

/// How long a push lasts.
const PUSH_TICKS: u16 = 25;
/// Peak acceleration of a calm push, sideways and forwards, m/s^2: the cabinet moves by 3.2 mm.
const PUSH_M_S2: DVec2 = DVec2::new(13.5, 8.0);
/// A player who pushes again before he stands firm pushes with more of his weight: by so much harder...
const HASTE: f64 = 1.2;
/// ... fading with this time constant.
const HASTE_S: f64 = 0.4;
/// Natural frequency of the cabinet on its legs, sideways and forwards, rad/s: 9.3 and 5.8 Hz.
const RING_RAD_S: DVec2 = DVec2::new(9.3 * std::f64::consts::TAU, 5.8 * std::f64::consts::TAU);
/// Damping ratio of the same.
const RING_DAMPING: DVec2 = DVec2::new(0.052, 0.055);
/// Natural frequency of a pendulum 0.10 m long, squared, 1/s^2.
const BOB_RAD2_S2: f64 = 9.81 / 0.10;
/// Damping rate of the bob's swing, 1/s.
const BOB_DAMPING_PER_S: f64 = 2.0;
/// How far the bob swings before it touches its ring, m.
const RING_M: f64 = 0.0043;
/// A touch so soon after the last one is the same one.
const TOUCH_TICKS: u16 = 300;

#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Cabinet {
    /// From where it stands, m.
    pub place: DVec2,
    pub velocity: DVec2,
    /// The bob from where it hangs, in the cabinet.
    bob: DVec2,
    bob_velocity: DVec2,
    /// For pushes to the right, to the left and forwards: ticks that the push still lasts.
    pushes: [u16; 3],
    /// How hard each of them is, over a calm one.
    force: [f64; 3],
    /// How many pushes the player has not yet recovered from.
    haste: f64,
    /// The buttons in the last tick.
    pressed: [bool; 3],
    /// Ticks until a touch of the bob counts again.
    deaf: u16,
}

impl Default for Cabinet {
    fn default() -> Cabinet {
        Cabinet {
            place: DVec2::ZERO,
            velocity: DVec2::ZERO,
            bob: DVec2::ZERO,
            bob_velocity: DVec2::ZERO,
            pushes: [0; 3],
            force: [0.0; 3],
            haste: 0.0,
            pressed: [false; 3],
            deaf: 0,
        }
    }
}

impl Cabinet {
    /// One tick. Returns the cabinet's acceleration, and whether the bob touched its ring.
    pub fn tick(&mut self, controls: &Controls) -> (DVec2, bool) {
        let pressed = [controls.nudge_left, controls.nudge_right, controls.nudge_up];
        for (index, &now) in pressed.iter().enumerate() {
            if now && !self.pressed[index] {
                self.pushes[index] = PUSH_TICKS;
                self.force[index] = 1.0 + HASTE * self.haste;
                self.haste += 1.0;
            }
        }
        self.haste *= 1.0 - TICK_S / HASTE_S;
        self.pressed = pressed;
        let push = self.push();
        let stiffness = RING_RAD_S * RING_RAD_S;
        let acceleration = push - self.place * stiffness - self.velocity * (2.0 * RING_DAMPING * RING_RAD_S);
        self.velocity += acceleration * TICK_S;
        self.place += self.velocity * TICK_S;
        (acceleration, self.swing(acceleration))
    }

    /// Acceleration by the hands: half a sine wave for each push.
    fn push(&mut self) -> DVec2 {
        let ways = [DVec2::X, DVec2::NEG_X, DVec2::NEG_Y];
        let mut sum = DVec2::ZERO;
        for ((left, force), way) in self.pushes.iter_mut().zip(self.force).zip(ways) {
            if *left > 0 {
                let phase = (f64::from(*left) - 0.5) / f64::from(PUSH_TICKS);
                sum += way * force * PUSH_M_S2 * libm::sin(phase * std::f64::consts::PI);
                *left -= 1;
            }
        }
        sum
    }

    fn swing(&mut self, acceleration: DVec2) -> bool {
        let pull = -acceleration - self.bob * BOB_RAD2_S2 - self.bob_velocity * BOB_DAMPING_PER_S;
        self.bob_velocity += pull * TICK_S;
        self.bob += self.bob_velocity * TICK_S;
        self.deaf = self.deaf.saturating_sub(1);
        let touches = self.bob.length() > RING_M;
        let counted = touches && self.deaf == 0;
        if counted {
            self.deaf = TOUCH_TICKS;
        }
        counted
    }
}
