//! What light must do, asserted from outside: only the crate's public interface is used.
//!
//! One binary, since every binary is linked on its own; `allocation` alone counts its process's allocations.

#![allow(clippy::duplicate_mod, reason = "the examples that are tested share the module that writes their pictures")]

mod agreement;
mod airborne_balls;
mod direct_light;
mod examples;
mod extreme_values;
mod flip;
mod half_resolution;
mod overhangs;
mod quality;
mod tile_cache;
mod transmission;
mod transport_agreement;
mod transport_bake;
mod transport_beams;
mod transport_contract;
mod transport_cup;
mod transport_known_answers;
mod tube_lamps;
