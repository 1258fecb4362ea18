//! Mechanisms: everything that moves, pulls or switches. Each has a file with its numbers, their check, its model and
//! state, and what it does.
//!
//! A closed set: this file is the register that a new mechanism enters itself in, with `kind.rs` (what a part can be and
//! what can be asked of it) and `pose.rs` (how it is seen). Refuses to know how balls move between impacts.

pub(crate) mod cabinet;
pub(crate) mod captive_ball;
pub(crate) mod controls;
pub(crate) mod drain;
pub(crate) mod drop_target;
pub(crate) mod elevation;
pub(crate) mod flap;
pub(crate) mod flap_contact;
pub(crate) mod flipper;
pub(crate) mod flipper_coil;
pub(crate) mod flipper_model;
pub(crate) mod gate;
pub(crate) mod jointed_body;
pub(crate) mod kickback;
pub(crate) mod kicker;
pub(crate) mod kind;
pub(crate) mod magnet;
pub(crate) mod model;
pub(crate) mod plunger;
pub(crate) mod pose;
pub(crate) mod ramp;
pub(crate) mod ramp_leg;
pub(crate) mod ramp_path;
pub(crate) mod rigid_mechanisms;
pub(crate) mod rod;
pub(crate) mod rollover;
pub(crate) mod saucer;
pub(crate) mod spinner;
pub(crate) mod target;
pub(crate) mod triggers;
pub(crate) mod wall;

use crate::ball::Ball;
use crate::ball::ball_step::BallStep;
use crate::mechanisms::cabinet::Cabinet;
use crate::mechanisms::captive_ball::CaptiveBall;
use crate::mechanisms::drop_target::{DropTargetModel, DropTargetState};
use crate::mechanisms::flipper_model::{FlipperModel, FlipperState};
use crate::mechanisms::gate::Gate;
use crate::mechanisms::kicker::KickerModel;
use crate::mechanisms::magnet::{Magnet, MagnetState};
use crate::mechanisms::model::{Model, State};
use crate::mechanisms::plunger::Plunger;
use crate::mechanisms::ramp_path::RampPath;
use crate::mechanisms::rod::{RodModel, RodState};
use crate::mechanisms::saucer::Saucer;
use crate::mechanisms::spinner::Spinner;
use crate::mechanisms::target::TargetModel;
use crate::part::event::Event;
use crate::part::{Numbered, PartId};
use serde::{Deserialize, Serialize};

/// What never changes of each mechanism, by kind.
#[derive(Clone, Debug, Default)]
pub(crate) struct MechanismModels {
    pub flippers: Vec<FlipperModel>,
    pub kickers: Vec<KickerModel>,
    pub targets: Vec<TargetModel>,
    pub drop_targets: Vec<DropTargetModel>,
    pub rollovers: Vec<PartId>,
    pub gates: Vec<Numbered<Gate>>,
    pub spinners: Vec<Numbered<Spinner>>,
    pub saucers: Vec<Numbered<Saucer>>,
    pub plungers: Vec<Numbered<Plunger>>,
    /// The rods of plungers and kickbacks.
    pub rods: Vec<RodModel>,
    pub magnets: Vec<Numbered<Magnet>>,
    pub captive_balls: Vec<Numbered<CaptiveBall>>,
    pub ramps: Vec<RampPath>,
}

/// The state of the mechanisms but for the rigid bodies, of the queue of new balls, and of what is switched on. Saved and
/// hashed in this order.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct MechanismStates {
    pub next_ball: u32,
    /// Balls that wait for a free plunger lane.
    pub queue: u32,
    /// Flippers obey their buttons.
    pub flippers_enabled: bool,
    /// Bumpers, slingshots, kickbacks and magnets work.
    pub coils_enabled: bool,
    pub flippers: Vec<FlipperState>,
    /// For each flipper whether the rules want it turned: only diverters obey.
    pub diverted: Vec<bool>,
    /// Ticks since each kicker fired.
    pub kicker_ticks: Vec<u16>,
    pub drop_targets: Vec<DropTargetState>,
    /// Balls on each rollover.
    pub rollovers: Vec<u16>,
    pub rods: Vec<RodState>,
    pub magnets: Vec<MagnetState>,
    pub cabinet: Cabinet,
}

impl MechanismStates {
    /// Everything at rest, flippers and coils switched off.
    pub fn new(models: &MechanismModels) -> MechanismStates {
        MechanismStates {
            next_ball: 0,
            queue: 0,
            flippers_enabled: false,
            coils_enabled: false,
            flippers: models.flippers.iter().map(FlipperModel::at_rest).collect(),
            diverted: vec![false; models.flippers.len()],
            kicker_ticks: kicker::ready(&models.kickers),
            drop_targets: vec![DropTargetState::standing(); models.drop_targets.len()],
            rollovers: vec![0; models.rollovers.len()],
            rods: vec![RodState::default(); models.rods.len()],
            magnets: vec![MagnetState::default(); models.magnets.len()],
            cabinet: Cabinet::default(),
        }
    }

    /// Whether there are as many of everything as in the models.
    pub fn fit(&self, models: &MechanismModels) -> bool {
        self.flippers.len() == models.flippers.len()
            && self.diverted.len() == models.flippers.len()
            && self.kicker_ticks.len() == models.kickers.len()
            && self.drop_targets.len() == models.drop_targets.len()
            && self.rollovers.len() == models.rollovers.len()
            && self.rods.len() == models.rods.len()
            && self.magnets.len() == models.magnets.len()
    }
}

/// What acts on a ball from afar in a step of `duration`, besides gravity: it goes into the ball's step.
pub(crate) fn apply_forces(model: &Model, state: &State, ball: &Ball, duration: f64, ball_step: &mut BallStep) {
    if let Some(acceleration) = saucer::acceleration(&model.mechanisms.saucers, ball) {
        ball_step.external += acceleration;
    }
    elevation::apply(model, ball, duration, ball_step);
    magnet::apply(model, &state.mechanisms, ball, duration, ball_step);
}

/// After a tick: the switches of mechanisms that look where balls are.
pub(crate) fn emit_switch_events(model: &Model, state: &mut State, events: &mut Vec<Event>) {
    let State { balls, mechanisms } = state;
    rod::emit_switch_events(&model.mechanisms.rods, balls, &mut mechanisms.rods, events);
    magnet::emit_switch_events(model, balls, mechanisms, events);
}

/// Whether a mechanism means to hold this ball where it is: a saucer, the plunger lane, a raised flipper, a magnet.
pub(crate) fn holds(model: &Model, state: &State, ball: &Ball) -> bool {
    let (models, states) = (&model.mechanisms, &state.mechanisms);
    ball.is_held()
        || models.plungers.iter().any(|plunger| plunger.numbers.has_before_it(ball))
        || models.flippers.iter().zip(&states.flippers).any(|(flipper, state)| flipper.carries(state, ball.center))
        || magnet::holds(model, states, ball)
}
