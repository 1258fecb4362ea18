//! The plunger: a rod that is pulled slowly and shoots forward.

use crate::{BALL_RADIUS_M, Plunger, TICK_S};
use geometry::{DVec2, Shape};
use serde::{Deserialize, Serialize};

/// How fast a rod that has shot goes back to its place, m/s.
const RETURN_M_S: f64 = 0.3;

#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct Rod {
    /// How far the rod is pulled back, m; below 0 after a shot.
    pub pulled: f64,
    /// Speed of the tip forwards, m/s.
    pub speed: f64,
    /// Speed at which a shot ends, m/s; 0 when no shot is on.
    shot: f64,
}

impl Rod {
    /// One tick of the hand and the spring: sets the tip's speed.
    pub fn tick(&mut self, plunger: &Plunger, held: bool) {
        if held {
            self.shot = 0.0;
            let pull = plunger.stroke_m / plunger.pull_s;
            self.speed = -pull.min((plunger.stroke_m - self.pulled).max(0.0) / TICK_S);
        } else if self.shot > 0.0 && self.pulled <= 0.0 {
            self.shot = 0.0;
            self.speed = 0.0;
        } else if self.shot > 0.0 {
            // The same acceleration for every pull would give the square root of it: a spring's is linear in it.
            let rate = plunger.full_speed_m_s / plunger.stroke_m;
            self.speed += rate * rate * self.pulled * TICK_S;
            if self.pulled <= self.speed * TICK_S {
                self.speed = self.shot;
            }
        } else if self.pulled > 0.0 {
            self.shot = plunger.full_speed_m_s * self.pulled / plunger.stroke_m;
            self.speed = 0.0;
        } else {
            self.speed = -RETURN_M_S.min(-self.pulled / TICK_S);
        }
    }

    /// True in the tick after which the rod has given all its speed.
    pub fn is_shooting(&self) -> bool {
        self.shot > 0.0
    }

    pub fn advance(&mut self, duration: f64) {
        self.pulled -= self.speed * duration;
    }

    pub fn velocity(&self, plunger: &Plunger) -> DVec2 {
        plunger.way * self.speed
    }

    /// The places of the ball's centre where it touches the tip's face.
    pub fn face(&self, plunger: &Plunger) -> Shape {
        let middle = plunger.tip - plunger.way * self.pulled;
        let half = plunger.way.perp() * plunger.half_width_m;
        Shape::capsule(middle - half, middle + half, BALL_RADIUS_M)
    }
}
