//! The realtime renderer: exact direct light in tiles that cache each lamp's layer, on every core, and the same with the
//! light at half the resolution.
//!
//! A frame: `prepared_frame`, `passes` (update tiles), `ball_pass`, bloom, `passes` (compose, tone-map). A tile:
//! `block_context`, `g_buffer`, `ambient_light`, `direct_light`, all called by `tile_renderer`.

mod ambient_light;
mod ball_pass;
mod block_context;
mod contact_shadow;
pub(crate) mod direct_light;
pub(crate) mod exact_renderer;
pub(crate) mod frame_context;
pub(crate) mod g_buffer;
pub(crate) mod half_resolution;
mod joint_upsampling;
mod passes;
mod prepared_frame;
mod schedule;
pub(crate) mod stage_timing;
pub(crate) mod tile_renderer;
