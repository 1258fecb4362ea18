//! What the ball and the machine do.
//!
//! A [`Layout`] says what stands on the playfield; a [`Machine`] plays it, a thousand ticks a second: [`Controls`] and
//! [`Command`]s go in, [`Event`]s and [`Contact`]s come out, and a [`Pose`] says where everything is. The ball is moved
//! by rays (earliest hit along its path, respond, go on); flippers and diverters are rotors with one degree of freedom,
//! plungers and kickbacks rods with one; spinners, gates and drop targets are rapier bodies.
//!
//! Units are SI. The frame is the drawing's: x to the right, **y down the table, towards the player**, the origin at
//! the playfield's upper left corner. Positive angles turn from x towards y (clockwise on the screen).
//!
//! The rooms, each of which imports from those before it only:
//!
//! | room | what it holds |
//! |---|---|
//! | `part` | id, material, checks of numbers, events |
//! | `ball` | a sphere that rolls and slides on a floor |
//! | `collision` | obstacles, triggers, broad phase, time of impact |
//! | `mechanisms` | every mechanism in its own file; the model and state of a machine |
//! | `layout` | what stands on the playfield, its check, the model that it comes to |
//! | `solver` | a step of the balls: resting contacts, sweep, impact response |
//! | `machine` | a tick; saving; diagnostics |
//!
//! This crate refuses to know what light, a window, a file, a score or a lamp is. It reads no clock, starts no thread
//! and asks no random number.

mod ball;
mod collision;
mod layout;
mod machine;
mod mechanisms;
mod part;
mod solver;

pub use ball::pose::BallPose;
pub use layout::{Layout, Part};
pub use machine::fingerprint::{Fingerprint, fingerprint};
pub use machine::{Error, Hashes, Machine};
pub use mechanisms::controls::Controls;
pub use mechanisms::kind::*;
pub use mechanisms::pose::Pose;
pub use part::PartId;
pub use part::event::{Contact, Event, EventKind};
pub use part::material::Material;

/// Ticks in a second of play.
pub const TICKS_PER_SECOND: u32 = 1000;
/// The length of a tick.
pub const TICK_S: f64 = 1.0 / TICKS_PER_SECOND as f64;
/// A pinball's radius: 27 mm across (1 1/16 in).
pub const BALL_RADIUS_M: f64 = 0.0135;
/// A pinball's mass.
pub const BALL_MASS_KG: f64 = 0.08;
/// Standard gravity.
const GRAVITY_M_S2: f64 = 9.81;
