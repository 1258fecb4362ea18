//! What stands on the playfield: plain data, in SI units.

pub(crate) mod check;

use geometry::{Arc, Circle, DVec2, Segment, Shape};
use serde::{Deserialize, Serialize};

/// The index of a part in [`Layout::parts`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub struct PartId(pub u16);

/// Everything that the ball can meet.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Layout {
    /// Width and height of the playfield, m.
    pub size_m: DVec2,
    /// The playfield's slope towards the player, rad.
    pub slope_rad: f64,
    /// Coefficient of friction between ball and playfield.
    pub playfield_friction: f64,
    /// The parts; a [`PartId`] is an index into this.
    pub parts: Vec<Part>,
}

/// One named thing on the playfield.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Part {
    /// Its id in the drawing.
    pub name: String,
    /// What it is.
    pub kind: Kind,
}

/// How a surface throws the ball back: `restitution / (1 + falloff * v)` at `v` m/s along the normal.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Material {
    /// Coefficient of restitution at low speed, in [0, 1].
    pub restitution: f64,
    /// How fast the restitution falls with the speed of the impact, s/m, 0 or more.
    pub falloff_s_per_m: f64,
    /// Coefficient of Coulomb friction, 0 or more.
    pub friction: f64,
}

impl Material {
    /// Coefficient of restitution of an impact at `speed_m_s` along the normal.
    pub fn restitution_at(&self, speed_m_s: f64) -> f64 {
        self.restitution / (1.0 + self.falloff_s_per_m * speed_m_s)
    }
}

/// What a part is.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Kind {
    /// Anything that only stands there: walls, guides, posts, rubbers.
    Wall(Wall),
    /// A flipper, or a diverter: a flap that the rules turn as a flipper's button turns a flipper.
    Flipper(Flipper),
    /// A pop bumper.
    Bumper(Bumper),
    /// The kicking rubber of a slingshot.
    Slingshot(Slingshot),
    /// A standup target.
    Target(Target),
    /// A target that falls below the playfield when it is hit hard enough.
    DropTarget(DropTarget),
    /// A switch under a ball that rolls over it.
    Rollover(Rollover),
    /// A ramp or a wire-form: a way above the playfield.
    Ramp(Ramp),
    /// A flap that lets the ball through one way.
    Gate(Gate),
    /// A plate on a horizontal axle that turns as the ball passes below it.
    Spinner(Spinner),
    /// A hole that holds a ball until it is thrown out.
    Saucer(Saucer),
    /// Where a ball leaves the playfield.
    Drain(Drain),
    /// The spring rod that shoots the ball, and the place where new balls arrive.
    Plunger(Plunger),
    /// A rod that the rules shoot out across a lane.
    Kickback(Kickback),
    /// An electromagnet below the playfield.
    Magnet(Magnet),
    /// A ball that the walls round it keep in its place.
    CaptiveBall(CaptiveBall),
}

/// Anything that only stands there.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Wall {
    /// Its surfaces.
    pub shapes: Vec<Shape>,
    /// What they are made of.
    pub material: Material,
}

/// What turns a flipper up.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum FlipperControl {
    /// The left button, while flippers are live.
    Left,
    /// The right button, while flippers are live.
    Right,
    /// [`crate::Command::Divert`], whatever the buttons do and whether flippers are live or not: a diverter.
    Rules,
}

/// A flipper: the hull of two discs that turns round the first. A diverter is one with equal discs.
///
/// Numbers that give a real one's strokes (up in 19 to 26 ms, back at rest in 85 to 100 ms, tip at 5 to 6.5 m/s) for
/// base 11.6 mm, tip 7 mm, `length_m` 60.5 mm and a stroke of 51 degrees: coil 3.3, hold 1.4, spring 0.32 N m, 0.30 kg.
/// For another length keep torque over moment of inertia.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Flipper {
    /// The disc at the pivot.
    pub base: Circle,
    /// From the pivot to the centre of the tip's disc, m.
    pub length_m: f64,
    /// Radius of the tip's disc, m.
    pub tip_radius_m: f64,
    /// The way it points at rest, rad (y down: positive is clockwise on the screen).
    pub rest_rad: f64,
    /// The way it points at the end of its stroke.
    pub up_rad: f64,
    /// What turns it up.
    pub control: FlipperControl,
    /// Its rubber.
    pub material: Material,
    /// Torque of the full coil, N m.
    pub coil_torque_n_m: f64,
    /// Torque of the held coil, N m.
    pub hold_torque_n_m: f64,
    /// Torque of the return spring, N m.
    pub spring_torque_n_m: f64,
    /// Mass, kg; its moment of inertia is m L^2 / 3 with L from pivot to the end of the tip.
    pub mass_kg: f64,
}

/// A pop bumper.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Bumper {
    /// Its skirt, where the ball meets it.
    pub circle: Circle,
    /// What the skirt is made of.
    pub material: Material,
    /// Speed that it adds outwards, m/s.
    pub kick_m_s: f64,
    /// Slowest approach that closes its switch, m/s.
    pub threshold_m_s: f64,
}

/// The kicking rubber of a slingshot.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Slingshot {
    /// The rubber between its posts.
    pub segment: Segment,
    /// The rubber's radius, m.
    pub radius_m: f64,
    /// The rubber.
    pub material: Material,
    /// Speed that it adds at its middle, m/s, falling as 1 - x^2 to its ends.
    pub kick_m_s: f64,
    /// Slowest approach that closes its switch, m/s.
    pub threshold_m_s: f64,
}

/// A standup target.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Target {
    /// Its face.
    pub shape: Shape,
    /// What the face is made of.
    pub material: Material,
    /// Slowest approach that closes its switch, m/s.
    pub threshold_m_s: f64,
}

/// A target that falls.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct DropTarget {
    /// Its face while it stands.
    pub shape: Shape,
    /// What the face is made of.
    pub material: Material,
    /// Slowest approach that knocks it off its ledge, m/s.
    pub threshold_m_s: f64,
}

/// A switch under the ball.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Rollover {
    /// The switch is closed while a ball's centre is in this shape.
    pub shape: Shape,
}

/// A way above the playfield, with sides. A ball that rolls in at an end that lies on the playfield is on it, and meets
/// its sides and what else is on it, and nothing that stands below. It leaves at the ends: onto the playfield, onto another
/// way that begins there, or falling. Where the floor is too low for a ball to pass below, its sides stand on the
/// playfield.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Ramp {
    /// The middle of its floor, from one end to the other: each leg begins where the last one ends.
    pub path: Vec<Leg>,
    /// Height of the floor above the playfield at the start of each leg and at the end of the last, m: one more than
    /// legs. In between it bends smoothly.
    pub heights_m: Vec<f64>,
    /// Half of the width between its sides, m: more than the ball's radius.
    pub half_width_m: f64,
    /// What its sides are made of.
    pub material: Material,
}

/// A piece of a way.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Leg {
    /// Straight on, from `a` to `b`.
    Line(Segment),
    /// Round a circle: from the arc's first end to its second, or backwards.
    Turn {
        /// The arc.
        arc: Arc,
        /// From its second end to its first.
        backwards: bool,
    },
}

/// A one-way flap across a lane.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Gate {
    /// The flap seen from above.
    pub segment: Segment,
    /// The unit vector of the way that the ball may pass, straight through the flap.
    pub direction: DVec2,
    /// What it throws back the other way.
    pub material: Material,
}

/// A plate on an axle across a lane; the ball passes both ways.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Spinner {
    /// The axle seen from above.
    pub segment: Segment,
    /// How fast it loses its turning, 1/s.
    pub damping_per_s: f64,
}

/// A hole that holds a ball.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Saucer {
    /// The hole: a slow ball whose centre comes over it falls in.
    pub circle: Circle,
    /// Fastest ball that it catches, m/s.
    pub capture_m_s: f64,
    /// Velocity that it throws the ball out with, m/s.
    pub eject_m_s: DVec2,
}

/// Where a ball leaves the playfield.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Drain {
    /// A ball is gone when its centre is in this shape.
    pub shape: Shape,
}

/// The spring rod that shoots the ball.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Plunger {
    /// Where a new ball's centre is put, m: in the lane, above the rod's tip.
    pub feed: DVec2,
    /// The rod's tip at rest, m: the middle of the face that the ball lies on.
    pub tip: DVec2,
    /// Half the width of the tip's face, m.
    pub half_width_m: f64,
    /// The unit vector of the shot.
    pub direction: DVec2,
    /// How far the rod can be pulled, m.
    pub stroke_m: f64,
    /// Time to pull it all the way, s.
    pub pull_s: f64,
    /// Speed of the ball after a full pull, m/s; it is linear in the pull.
    pub full_speed_m_s: f64,
}

/// A coil-fired rod whose face lies across a lane. It shoots out when the rules say so, and goes back by its spring.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Kickback {
    /// The rod's tip at rest, m: the middle of its face.
    pub tip: DVec2,
    /// Half the width of the face, m.
    pub half_width_m: f64,
    /// The unit vector of the shot.
    pub direction: DVec2,
    /// How far the rod comes out, m.
    pub stroke_m: f64,
    /// Speed of the rod when it is out, and of the ball that it has pushed, m/s.
    pub speed_m_s: f64,
}

/// An electromagnet below the playfield that pulls balls to its middle while the rules have it switched on.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Magnet {
    /// Its middle, and how far it reaches.
    pub circle: Circle,
    /// The most that it pulls along the playfield, m/s^2: at 0.45 of its reach. A real one holds a ball against ten
    /// times the slope and more.
    pub pull_m_s2: f64,
}

/// A steel ball that is not in play: the walls round it keep it in its place.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CaptiveBall {
    /// Where its centre is at first, m.
    pub center: DVec2,
    /// Slowest approach of a ball in play that closes its switch, m/s.
    pub threshold_m_s: f64,
}
