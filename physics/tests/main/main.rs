//! What the machine must do, asserted from outside: only the crate's public interface is used.

mod cabinet;
mod captive;
mod diverter;
mod fixture;
mod flippers;
mod kickback;
mod machine;
mod magnet;
mod material;
mod mechanisms;
mod ramp;
mod rest;
mod rolling;
mod shots;
