//! The mechanisms: everything that moves, pulls or switches, each in its own file.

pub(crate) mod cabinet;
pub(crate) mod captive_ball;
pub(crate) mod controls;
pub(crate) mod elevation;
pub(crate) mod flap_contact;
pub(crate) mod flipper;
pub(crate) mod magnet;
pub(crate) mod pose;
pub(crate) mod ramp_path;
pub(crate) mod rigid_mechanisms;
pub(crate) mod rod;
pub(crate) mod state;
pub(crate) mod triggers;
