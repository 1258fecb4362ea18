//! What the machine must do, asserted from outside: only the crate's public interface is used.

mod fixture;
mod flippers;
mod machine;
mod mechanisms;
mod rolling;
mod shots;
