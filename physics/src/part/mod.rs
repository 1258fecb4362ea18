//! What every part has in common.

pub(crate) mod event;
