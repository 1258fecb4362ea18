//! Solver: a step of the balls, from impact to impact.
//!
//! Read it in the order of the calls: `substeps.rs` cuts the tick (`clearance.rs` measures for it), `step.rs` is a step.
//! - Its start: `resting_contacts.rs`, on `contact_detection.rs` and `contact_constraint.rs`.
//! - Its middle: `sweep.rs`, from impact to impact: `near_balls.rs`, `impact_candidate.rs`, `refinement.rs` (on `gap.rs`),
//!   `impact_response.rs`, `continuation.rs` (on `constraint_projection.rs`), `simultaneous_impacts.rs`.
//! - Its end: `flipper_contact.rs`, which also looks ahead for the start.

pub(crate) mod clearance;
pub(crate) mod constraint_projection;
pub(crate) mod contact_constraint;
pub(crate) mod contact_detection;
pub(crate) mod continuation;
pub(crate) mod flipper_contact;
pub(crate) mod gap;
pub(crate) mod impact_candidate;
pub(crate) mod impact_response;
pub(crate) mod near_balls;
pub(crate) mod refinement;
pub(crate) mod resting_contacts;
pub(crate) mod simultaneous_impacts;
pub(crate) mod step;
pub(crate) mod substeps;
pub(crate) mod sweep;
