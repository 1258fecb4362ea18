//! Where everything is: what a picture, a bot or a debug overlay needs to know.

use crate::layout::PartId;
use geometry::DVec2;

/// Where everything that moves is at the end of a tick.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Pose {
    /// The balls in play, in the order in which they came; a ball that a saucer holds is among them.
    pub balls: Vec<BallPose>,
    /// The captive balls, which are not in play.
    pub captives: Vec<(PartId, BallPose)>,
    /// The way that each flipper and each diverter points, rad.
    pub flippers_rad: Vec<(PartId, f64)>,
    /// Torque of each flipper's coil less that of its spring, N m: positive lifts it.
    pub flipper_torques_n_m: Vec<(PartId, f64)>,
    /// How far up each drop target stands: 1 is up, 0 is flush with the playfield.
    pub drop_targets: Vec<(PartId, f64)>,
    /// The angle of each spinner's plate from hanging, rad.
    pub spinners_rad: Vec<(PartId, f64)>,
    /// The angle of each gate's flap from closed, rad, 0 or more.
    pub gates_rad: Vec<(PartId, f64)>,
    /// How far each bumper's ring is pulled down and each slingshot's arm and kickback's rod is out, 0 to 1.
    pub kickers: Vec<(PartId, f64)>,
    /// Whether each magnet pulls.
    pub magnets: Vec<(PartId, bool)>,
    /// How far the plunger is pulled, 0 to 1.
    pub plunger: f64,
    /// How far the cabinet has moved from where it stands, m.
    pub cabinet_m: DVec2,
}

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
