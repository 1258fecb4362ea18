//! What the machine must do, asserted from outside: only the crate's public interface is used.

mod accuracy;
mod cabinet;
mod captive;
mod collision;
mod distances;
mod diverter;
mod energy;
mod examples;
mod fixture;
mod flippers;
mod kickback;
mod machine;
mod magnet;
mod material;
mod mechanisms;
mod oracle;
mod ramp;
mod rest;
mod rolling;
mod shots;
mod strokes;
mod wedge;
