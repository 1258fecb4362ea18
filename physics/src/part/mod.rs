//! Parts: what every part of a playfield has in common: its id, its material, the checks of its numbers, the events
//! that it sends.
//!
//! The lowest room. Refuses to know any mechanism and any ball.

pub(crate) mod event;
pub(crate) mod material;
pub(crate) mod validation;

use serde::{Deserialize, Serialize};

/// The index of a part in [`crate::Layout::parts`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub struct PartId(pub u16);

/// The numbers of a mechanism, with the part that they describe.
#[derive(Clone, Debug)]
pub(crate) struct Numbered<T> {
    pub part: PartId,
    pub numbers: T,
}

/// The index of a part among the parts of its kind.
pub(crate) fn index_of<T>(part: PartId, all: &[Numbered<T>]) -> Option<usize> {
    all.iter().position(|own| own.part == part)
}
