//! Visibility: which fraction of a lamp a point sees past all occluders, exactly. Occluders become chains of discs;
//! shafts between a lamp and a tile sort them out; the intervals that the rest covers of the lamp are united. Tinted
//! and airborne balls are factors on that fraction. Every fast path has a scalar twin in double precision.

pub(crate) mod airborne_shadow;
pub(crate) mod blockers;
pub(crate) mod covered_interval;
pub(crate) mod disc_chain;
pub(crate) mod fraction;
pub(crate) mod interval_union;
pub(crate) mod potential_occluders;
pub(crate) mod projected_emitter;
pub(crate) mod query;
pub mod scalar;
pub(crate) mod shadow_bounds;
pub(crate) mod shaft;
pub(crate) mod sphere_shadow;
pub(crate) mod transmission;
