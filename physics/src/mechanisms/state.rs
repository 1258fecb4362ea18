//! Everything that can change what happens next, as plain data.

use crate::ball::Ball;
use crate::collision::world::Plan;
use crate::mechanisms::cabinet::Cabinet;
use crate::mechanisms::captive_ball;
use crate::mechanisms::flipper::Rotor;
use crate::mechanisms::magnet::Coil;
use crate::mechanisms::rod::Rod;
use serde::{Deserialize, Serialize};

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct State {
    /// Captive balls first, then the balls in play in the order in which they came.
    pub balls: Vec<Ball>,
    pub mechanisms: Mechanisms,
}

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Mechanisms {
    pub next_ball: u32,
    /// Balls that wait for a free plunger lane.
    pub queue: u32,
    pub flippers_live: bool,
    pub kickers_live: bool,
    pub rotors: Vec<Rotor>,
    /// For each rotor whether the rules want it turned: only diverters obey.
    pub diverted: Vec<bool>,
    /// Ticks since each kicker fired.
    pub kickers: Vec<u16>,
    pub drops: Vec<Drop>,
    /// Balls on each rollover.
    pub rollovers: Vec<u16>,
    pub rods: Vec<Rod>,
    pub coils: Vec<Coil>,
    pub cabinet: Cabinet,
}

/// A drop target, apart from where it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct Drop {
    /// It stands in the ball's way.
    pub solid: bool,
    /// It has left its ledge.
    pub falling: bool,
    pub goal: Goal,
}

/// What a drop target is to do.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) enum Goal {
    Up,
    Down,
    /// Rise as soon as no ball is in its way.
    Rise,
}

/// A kicker that has not fired for this long is ready.
pub(crate) const KICKER_READY_TICKS: u16 = 60;

impl State {
    pub fn new(plan: &Plan) -> State {
        let mechanisms = Mechanisms {
            next_ball: 0,
            queue: 0,
            flippers_live: false,
            kickers_live: false,
            rotors: plan.blades.iter().map(|blade| blade.at_rest()).collect(),
            diverted: vec![false; plan.blades.len()],
            kickers: vec![KICKER_READY_TICKS; plan.kickers.len()],
            drops: vec![Drop { solid: true, falling: false, goal: Goal::Up }; plan.drops.len()],
            rollovers: vec![0; plan.rollovers.len()],
            rods: vec![Rod::default(); plan.slides.len()],
            coils: vec![Coil::default(); plan.magnets.len()],
            cabinet: Cabinet::default(),
        };
        State { balls: captive_ball::balls(plan).collect(), mechanisms }
    }

    /// Whether the state has as many of everything as the layout.
    pub fn fits(&self, plan: &Plan) -> bool {
        let own = &self.mechanisms;
        let captives = self.balls.iter().filter_map(Ball::captive);
        captives.eq(0..plan.captives.len())
            && own.rotors.len() == plan.blades.len()
            && own.diverted.len() == plan.blades.len()
            && own.kickers.len() == plan.kickers.len()
            && own.drops.len() == plan.drops.len()
            && own.rollovers.len() == plan.rollovers.len()
            && own.rods.len() == plan.slides.len()
            && own.coils.len() == plan.magnets.len()
    }
}
