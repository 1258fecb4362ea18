//! A step of the balls: the sweep from impact to impact, contact constraints, impact response.

pub(crate) mod clearance;
pub(crate) mod contact_constraint;
pub(crate) mod impact_response;
pub(crate) mod refinement;
pub(crate) mod resting_contacts;
pub(crate) mod simultaneous_impacts;
pub(crate) mod sweep;
