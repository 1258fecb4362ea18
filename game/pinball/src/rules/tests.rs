//! Rules on a small table built in code, told of events that never happened.

pub(crate) mod bench;
mod errors;
mod flow;
mod memory;
mod spectrum;
mod work;
