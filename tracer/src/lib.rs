//! What light does on a flat table.
//!
//! A [`Scene`] is lamps, what casts shadows ([`Occluder`]), what has a visible top ([`Top`], [`Ball`]), the floor's art
//! and a [`View`]. A renderer turns it into linear radiance, and a tone map into the pixels of a [`Frame`]. Direct light
//! is exact: the visible fraction of each lamp is one minus the length of the union of the intervals that the occluders
//! cover of it. A Monte Carlo integrator over the same scene is the reference that it is judged by.
//!
//! Lengths are millimetres; x to the right, y down. This crate refuses to know what a window, a file, a clock, a rule
//! or a rolling ball is.

#![allow(clippy::needless_range_loop, reason = "lanes and channels run in step through several arrays")]

mod albedo;
mod ball;
mod candidates;
mod changes;
mod compose;
mod coverage;
mod dither;
pub mod exact;
mod film;
mod frame;
mod gaze;
mod glare;
mod half;
mod irradiance;
mod lanes;
mod layer;
mod memory;
pub mod monte_carlo;
mod obstruction;
mod points;
mod radiance;
mod renderer;
mod response;
pub mod room;
mod scene;
mod silhouette;
mod surfaces;
pub mod testing;
mod tile;
pub mod tone;
mod upscale;
mod view;
mod visibility;

pub use film::Film;
pub use frame::Frame;
pub use half::HalfRenderer;
pub use lanes::Path;
pub use radiance::Radiance;
pub use renderer::{Renderer, Step};
pub use scene::{Ball, Finish, Floor, Glow, Group, Lamp, Mask, Occluder, Outline, Profile, Rgb, Scene, Top};
pub use view::View;
