//! A tile: 16 x 16 pixels of the screen that are lit together. Its planes, where it is, and the packed samples of it that
//! some surface needs light at.

pub(crate) mod packed_samples;
pub(crate) mod planes;
pub(crate) mod rect;
