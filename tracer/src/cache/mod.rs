//! Cache: what stays from frame to frame. A tile keeps its G-buffer and one layer for each lamp in packed planes; the
//! frame history and the damage say which of them are valid, and weighted sums put a picture together from them.

pub(crate) mod cell_means;
pub(crate) mod damage;
pub(crate) mod frame_history;
pub(crate) mod g_buffer;
pub(crate) mod item_pairing;
pub(crate) mod lamp_layer;
pub(crate) mod lamp_set;
pub(crate) mod packed_planes;
pub(crate) mod tile_cache;
pub(crate) mod top_history;
pub(crate) mod validity;
pub(crate) mod weighted_sum;
