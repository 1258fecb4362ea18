//! Pinball physics: what the ball and the machine do.
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
//! | `constants` | the tick, the ball, gravity |
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
mod constants;
mod layout;
mod machine;
mod mechanisms;
mod part;
mod solver;

pub use ball::pose::BallPose;
use constants::GRAVITY_M_S2;
pub use constants::{BALL_MASS_KG, BALL_RADIUS_M, TICK_S, TICKS_PER_SECOND};
pub use layout::{Layout, Part};
pub use machine::fingerprint::{Fingerprint, fingerprint};
pub use machine::{Error, Hashes, Machine};
pub use mechanisms::controls::Controls;
pub use mechanisms::flap::AXLE_TO_EDGE_M;
pub use mechanisms::kind::*;
pub use mechanisms::pose::Pose;
pub use part::PartId;
pub use part::event::{Contact, Event, EventKind, TickEvent};
pub use part::material::Material;
