//! Pose of a ball: what a picture or a bot needs to know of it.

use crate::ball::Ball;
use geometry::DVec2;

/// One ball.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BallPose {
    /// Which ball: counts up as balls are fed, and down from the largest number for captive balls.
    pub id: u32,
    /// Its centre, m.
    pub center: DVec2,
    /// Its velocity, m/s.
    pub velocity: DVec2,
    /// Its angular velocity, rad/s: about x, y and the vertical (up, out of the playfield).
    pub spin: [f64; 3],
    /// How it has turned since it came: a unit quaternion x, y, z, w.
    pub rotation: [f64; 4],
    /// It is held by a saucer.
    pub held: bool,
    /// Height of its lowest point above the playfield, m.
    pub height_m: f64,
    /// It is on a ramp or a wire-form, or still high above the playfield: nothing that stands there is in its way.
    pub above: bool,
}

impl Ball {
    pub fn pose(&self) -> BallPose {
        BallPose {
            id: self.id,
            center: self.center,
            velocity: self.velocity,
            spin: self.spin.to_array(),
            rotation: self.rotation.to_array(),
            held: self.is_held(),
            height_m: self.height,
            above: self.is_up(),
        }
    }
}
