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
mod angle;
mod ball;
mod bands;
mod candidates;
mod changes;
mod compose;
mod cone;
mod coverage;
mod dither;
pub mod exact;
mod falloff;
mod film;
mod filter;
pub mod flip;
mod floating;
mod frame;
mod gaze;
mod gist;
mod glare;
mod half;
mod irradiance;
mod lamp;
pub mod lanes;
mod layer;
mod lighting;
pub mod limits;
mod memory;
pub mod monte_carlo;
mod numbers;
mod obstruction;
mod pair;
mod past;
mod penumbra;
mod place;
mod points;
pub mod quality;
mod radiance;
mod recall;
mod renderer;
mod response;
mod scene;
mod sight;
mod silhouette;
mod source;
mod sphere;
mod step;
mod surfaces;
mod surroundings;
pub mod testing;
mod tile;
pub mod tone;
mod union;
mod upscale;
mod veil;
mod view;
mod visibility;
mod wedge;

pub use film::Film;
pub use frame::Frame;
pub use half::HalfRenderer;
pub use lamp::{Emitter, Lamp};
pub use lanes::Path;
pub use radiance::Radiance;
pub use renderer::Renderer;
pub use scene::{Ball, Filter, Finish, Floor, Glow, Group, Mask, Occluder, Outline, Profile, Rgb, Scene, Top};
pub use step::Step;
pub use veil::Veil;
pub use view::View;
