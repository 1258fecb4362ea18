//! What the machine must do, asserted from outside: only the crate's public interface is used.

mod accuracy;
mod collision;
mod distances;
mod fixture;
mod flippers;
mod machine;
mod mechanisms;
mod oracle;
mod rolling;
mod shots;
mod strokes;
