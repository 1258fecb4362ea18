//! Cache: what stays from frame to frame. A tile keeps its G-buffer and one layer for each lamp in packed planes; the
//! frame history and the damage say which events have met it, one state table what these leave valid, and a weighted sum
//! of the layers is the tile.

pub(crate) mod cached_g_buffer;
pub(crate) mod cell_means;
pub(crate) mod damage;
pub(crate) mod frame_history;
pub(crate) mod item_pairing;
pub(crate) mod lamp_layer;
pub(crate) mod lamp_set;
pub(crate) mod packed_planes;
pub(crate) mod tile_cache;
pub(crate) mod top_history;
pub(crate) mod validity;
pub(crate) mod weighted_sum;
