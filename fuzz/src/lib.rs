//! What is fuzzed: everything that Caustic reads from files, and tables that nobody would draw.
//!
//! Each module has one function, `run`, that takes any bytes and panics if the world is not as it must be. The targets of
//! `cargo fuzz` call it, and so does a test that goes through the corpora.

pub mod drawing;
pub mod numbers;
pub mod recording;
mod sample;
pub mod script;
pub mod table;
