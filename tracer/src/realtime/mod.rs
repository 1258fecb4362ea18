//! The realtime renderer: exact direct light in tiles that remember each lamp, on every core, and the same with the
//! light at half the resolution.

pub(crate) mod compose;
pub(crate) mod direct_light;
pub(crate) mod exact_renderer;
pub(crate) mod g_buffer_fetch;
pub(crate) mod half_resolution;
pub(crate) mod joint_upsampling;
pub(crate) mod schedule;
pub(crate) mod stage_timing;
pub(crate) mod tile_renderer;
