//! Shapes and the rays that meet them.
//!
//! Every surface of a table is a *core* (a point, a segment, an arc, a taper) plus a *radius*. Light meets it at
//! core + radius; the ball is a disc, so its centre is a point that meets the same surface at core + radius + ball
//! radius ([`Shape::inflated`]). One vocabulary serves both, so the wall that casts a shadow is the wall that the ball
//! hits.
//!
//! Everything here is plain `f64` arithmetic with `+ - * / sqrt`, and [`trig`] for the rest: the same bits on every
//! machine. Lengths have no unit of their own; a result has the unit of what went in. This crate refuses to know what
//! a lamp, a ball, a table or a file is.

mod arc;
mod bounds;
mod circle;
mod ray;
pub mod rng;
mod segment;
mod shape;
mod taper;
pub mod trig;

pub use arc::Arc;
pub use bounds::Bounds;
pub use circle::Circle;
pub use glam::DVec2;
pub use ray::{Hit, Ray};
pub use segment::Segment;
pub use shape::{Core, Shape};
pub use taper::Taper;
