//! Ray-traced light: what light does on a flat table.
//!
//! A [`Scene`] is lamps, what casts shadows ([`Occluder`]), what has a visible top ([`Top`], [`Ball`]), the floor's art
//! and a [`View`]. An [`Integrator`] turns it into linear [`Radiance`]: [`render`] does so once, a [`Renderer`] from frame to
//! frame, where it costs only what has changed. A tone map makes the pixels of a [`Frame`]. Direct light is exact: the
//! visible fraction of each lamp is one minus the length of the union of the intervals that the occluders cover of it. A
//! Monte Carlo integrator over the same scene is the reference that it is judged by.
//!
//! Lengths are millimetres; x to the right, y down. This crate refuses to know what a window, a file, a clock, a rule
//! or a rolling ball is.

#![allow(clippy::needless_range_loop, reason = "lanes and channels run in step through several arrays")]

mod cache;
mod film;
mod integrator;
mod realtime;
mod reference;
mod renderer;
mod scene;
pub mod scenes;
mod shading;
pub mod simd;
mod tile;
pub mod transport;
mod visibility;

pub use film::display_buffer::DisplayBuffer;
pub use film::frame::Frame;
pub use film::radiance::Radiance;
pub use film::srgb;
pub use film::tone_map;
pub use integrator::Integrator;
pub use realtime::stage_timing::RenderStage;
pub use reference::{flip, literal_photons, monte_carlo, quality};
pub use renderer::{Renderer, render};
pub use scene::id::{ItemId, Revision};
pub use scene::lamp::{Emitter, Lamp};
pub use scene::material::Material;
pub use scene::overhang::Overhang;
pub use scene::validation;
pub use scene::view::View;
pub use scene::{Ball, Finish, Floor, Glow, Group, Mask, Occluder, Outline, Profile, Rgb, Scene, Top};
pub use simd::dispatch::SimdLevel;
pub use visibility::scalar;
