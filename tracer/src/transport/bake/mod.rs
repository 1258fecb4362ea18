//! Baked layers: the indirect light of a scene that stands still, lamp by lamp, in cells.
//!
//! Light is linear, so a scene under lamps of any colours is the weighted sum of what each lamp does alone. What is baked is all
//! but the straight light of the lamps, which a caller has exactly:
//! 1. Packets of light are traced from each lamp (`packets`). What matt walls send out on their way is counted in short
//!    pieces of the walls (`walls`), with the ways that the light has come (`way_basis`). It is a photon map on the walls
//!    alone (H. W. Jensen, "Global illumination using photon maps", EGWR 1996). Light that mirrors and glass have turned is
//!    counted in the cells that it crosses: caustics.
//! 2. One gather finds what each cell gets from the walls that it sees, for all lamps at once (`gather`).
//! 3. A point takes from the cells around it that it sees (`cells`): no light goes through walls.
//!
//! Sums over packets are whole numbers, and a cell's gather has one order: the same bytes on any number of threads.

mod baking;
mod bytes;
mod cells;
mod cuts;
mod gather;
mod layers;
mod packets;
mod progress;
mod wall_curve;
mod walls;
mod way_basis;

pub use baking::{BakeOptions, bake};
pub use layers::{Bake, MixedBake};
