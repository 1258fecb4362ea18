//! Lanes: how an inner loop is compiled for every instruction set of a processor, and arithmetic that gives the same
//! bits on each. It knows nothing of light.

pub(crate) mod atan2;
pub mod dispatch;
