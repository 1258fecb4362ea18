//! Film: linear radiance, its bloom, and the tone map that makes the pixels of a frame of it. It knows nothing of
//! lamps, of shadows or of how the radiance was found.

pub(crate) mod bloom;
pub(crate) mod blue_noise;
pub(crate) mod display_buffer;
pub(crate) mod frame;
pub(crate) mod frame_id;
pub(crate) mod radiance;
pub mod srgb;
pub mod tone_map;
