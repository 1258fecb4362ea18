//! Solver: a step of the balls, from impact to impact.
//!
//! Read it downwards: `substeps.rs` cuts the tick, `step.rs` is a step, `resting_contacts.rs` its start, `sweep.rs` its
//! middle (`impact_candidate.rs`, `refinement.rs`, `impact_response.rs`, `continuation.rs`), `flipper_contact.rs` its end.

pub(crate) mod clearance;
pub(crate) mod constraint_projection;
pub(crate) mod contact_constraint;
pub(crate) mod contact_detection;
pub(crate) mod continuation;
pub(crate) mod flipper_contact;
pub(crate) mod impact_candidate;
pub(crate) mod impact_response;
pub(crate) mod refinement;
pub(crate) mod resting_contacts;
pub(crate) mod simultaneous_impacts;
pub(crate) mod step;
pub(crate) mod substeps;
pub(crate) mod sweep;
