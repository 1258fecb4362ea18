//! Machine: everything on the playfield, tick after tick.

pub(crate) mod diagnostics;
pub(crate) mod fingerprint;
pub(crate) mod save;

use crate::ball::Ball;
use crate::layout::{Layout, build, check};
use crate::machine::fingerprint::fingerprint;
use crate::mechanisms::controls::Controls;
use crate::mechanisms::kind::Command;
use crate::mechanisms::model::{Model, State};
use crate::mechanisms::rigid_mechanisms::RigidMechanisms;
use crate::mechanisms::{self, drop_target, elevation, flap_contact, flipper, kicker, plunger, rod, triggers};
use crate::part::PartId;
use crate::part::event::{self, Contact, Event, EventKind, TickEvent};
use crate::solver::step::{Step, StepBuffers};
use crate::solver::substeps::{self, TickInput};
use geometry::DVec2;
use std::sync::Arc;

/// Everything on the playfield, tick after tick. A clone goes on exactly as the original does, and is cheap: the layout
/// and all that follows from it is shared.
#[derive(Clone, Debug)]
pub struct Machine {
    layout: Arc<Layout>,
    /// Of the layout, as saved bytes name it.
    fingerprint: u64,
    model: Arc<Model>,
    state: State,
    rigid: RigidMechanisms,
    buffers: StepBuffers,
    /// Where the balls were at the tick's start.
    starts: Vec<DVec2>,
    events: Vec<Event>,
    contacts: Vec<Contact>,
    /// Least number of substeps in a tick: 1 in play.
    substeps: u32,
}

/// Why a layout or saved bytes cannot be played.
#[derive(Clone, Debug, PartialEq)]
pub enum Error {
    /// A part of the layout has a number that cannot be: which part, and what is wrong, as one sentence.
    Layout(PartId, String),
    /// Saved bytes that this machine did not write.
    Save(String),
}

/// The parts of a machine's state, hashed one by one so that a difference can be named.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Hashes {
    /// Places, velocities and spins of the balls.
    pub balls: u64,
    /// Flippers, plunger, kickers, cabinet and all rapier bodies.
    pub mechanisms: u64,
}

impl Machine {
    /// A machine with no ball on it, flippers and kickers dead.
    ///
    /// # Errors
    /// If a part's numbers cannot be.
    pub fn new(layout: Arc<Layout>) -> Result<Machine, Error> {
        check::layout(&layout).map_err(|(part, text)| Error::Layout(part, text))?;
        let model = build::model(&layout);
        let state = State::new(&model);
        let rigid = RigidMechanisms::new(&model.mechanisms);
        let fingerprint = fingerprint(&*layout);
        Ok(Machine::assemble(layout, fingerprint, Arc::new(model), state, rigid))
    }

    fn assemble(
        layout: Arc<Layout>,
        fingerprint: u64,
        model: Arc<Model>,
        state: State,
        rigid: RigidMechanisms,
    ) -> Machine {
        Machine {
            layout,
            fingerprint,
            model,
            state,
            rigid,
            buffers: StepBuffers::default(),
            starts: Vec::new(),
            events: Vec::new(),
            contacts: Vec::new(),
            substeps: 1,
        }
    }

    /// The slow twin of a machine in play, for experiments: its balls and flippers take at least so many substeps in a
    /// tick (1 in play; near a moving flipper there are more in any case). Its clones are as slow; what is restored from
    /// its bytes is not.
    pub fn substepped(self, substeps: u32) -> Machine {
        Machine { substeps: substeps.max(1), ..self }
    }

    /// What stands on the playfield.
    pub fn layout(&self) -> &Arc<Layout> {
        &self.layout
    }

    /// One millisecond: commands are obeyed in their order, the cabinet is pushed, balls and flippers move from impact to
    /// impact, then everything that looks where balls have come to.
    pub fn tick(&mut self, controls: Controls, commands: &[Command]) {
        self.events.clear();
        self.contacts.clear();
        self.buffers.contact_solves = 0;
        commands.iter().for_each(|command| command.execute(&self.model, &mut self.state, &mut self.events));
        plunger::feed(&self.model, &mut self.state, &mut self.events);
        drop_target::tick(&self.model, &mut self.state, &mut self.rigid, &mut self.events);
        let shaken = self.push_cabinet(&controls);
        kicker::tick(&mut self.state.mechanisms.kicker_ticks);
        rod::tick(&self.model.mechanisms.rods, &mut self.state.mechanisms.rods, controls.plunger);
        self.starts.clear();
        self.starts.extend(self.state.balls.iter().map(|ball| ball.center));
        self.move_balls(&controls, shaken);
        self.move_rigid_mechanisms();
        elevation::tick(&self.model, &mut self.state, &self.starts, &mut self.events);
        triggers::tick(&self.model, &mut self.state, &self.starts, &mut self.events);
        mechanisms::emit_switch_events(&self.model, &mut self.state, &mut self.events);
        self.state.balls.iter_mut().for_each(Ball::end_tick);
    }

    /// Puts a ball on the playfield, for experiments: centre in m, velocity in m/s, spin as in [`crate::BallPose::spin`].
    /// Returns its id.
    pub fn put_ball(&mut self, center: DVec2, velocity_m_s: DVec2, spin_rad_s: [f64; 3]) -> u32 {
        let id = self.state.mechanisms.next_ball;
        self.state.mechanisms.next_ball = id.wrapping_add(1);
        let ball = Ball { velocity: velocity_m_s, spin: spin_rad_s.into(), ..Ball::new(id, center) };
        self.state.balls.push(ball);
        id
    }

    /// Puts a ball in play to another place on the playfield, at rest, for experiments.
    pub fn move_ball(&mut self, id: u32, center: DVec2) {
        let is_it = |ball: &&mut Ball| ball.id == id && ball.captive().is_none();
        if let Some(ball) = self.state.balls.iter_mut().find(is_it) {
            *ball = Ball::new(id, center);
        }
    }

    /// Returns the cabinet's acceleration, m/s^2.
    fn push_cabinet(&mut self, controls: &Controls) -> DVec2 {
        let motion = self.state.mechanisms.cabinet.tick(controls);
        let felt = [(motion.bob, EventKind::TiltBob), (motion.slam, EventKind::Slam)];
        self.events.extend(felt.into_iter().filter(|felt| felt.0).map(|(_, kind)| Event { part: None, kind }));
        motion.acceleration
    }

    /// Balls, flippers and rods, in as many substeps as the flippers need.
    fn move_balls(&mut self, controls: &Controls, cabinet: DVec2) {
        let model = &*self.model;
        let input = TickInput {
            coils: flipper::coils(&model.mechanisms, &self.state.mechanisms, controls),
            external: DVec2::new(0.0, model.floor.slope_gravity) - cabinet,
            min_substeps: self.substeps,
        };
        let schedule = substeps::schedule(model, &self.state, &input);
        substeps::turn_detached(model, &mut self.state, &input, &schedule);
        let mut step = Step {
            model,
            state: &mut self.state,
            buffers: &mut self.buffers,
            events: &mut self.events,
            contacts: &mut self.contacts,
            elapsed: 0.0,
            detached: &schedule.detached,
        };
        substeps::run(&mut step, &input, schedule.substeps);
    }

    /// Balls push flaps, and rapier moves everything that it owns.
    fn move_rigid_mechanisms(&mut self) {
        flap_contact::tick(&self.model, &mut self.rigid, &mut self.state.balls, &self.starts);
        let (spinners, events) = (&self.model.mechanisms.spinners, &mut self.events);
        self.rigid.tick(|spinner| events.push(Event::closed(spinners[spinner].part)));
    }

    /// What happened in the last tick, in order.
    pub fn events(&self) -> &[Event] {
        &self.events
    }

    /// The impacts of the last tick, in order.
    pub fn contacts(&self) -> &[Contact] {
        &self.contacts
    }

    /// Events and contacts of the last tick as one stream, in order.
    pub fn tick_events(&self) -> impl Iterator<Item = TickEvent> {
        event::stream(&self.events, &self.contacts)
    }

    /// Hashes of the full state: of everything that can change what happens next.
    pub fn hashes(&self) -> Hashes {
        save::hashes(&self.state, &self.rigid)
    }

    /// The full state as bytes: everything that can change what happens next.
    pub fn save(&self) -> Vec<u8> {
        save::write(self.fingerprint, &self.state, &self.rigid)
    }

    /// The machine that [`Machine::save`] wrote, on the same layout.
    ///
    /// # Errors
    /// If the bytes are not what `save` writes for this layout.
    pub fn restore(layout: Arc<Layout>, bytes: &[u8]) -> Result<Machine, Error> {
        Machine::new(layout)?.restored(bytes)
    }

    /// As [`Machine::restore`], on this machine's layout: much faster, because what follows from the layout is shared.
    /// Nothing else of this machine is in the other.
    ///
    /// # Errors
    /// If the bytes are not what `save` writes for this layout.
    pub fn restored(&self, bytes: &[u8]) -> Result<Machine, Error> {
        let (state, rigid) = save::read(self.fingerprint, &self.model, bytes).map_err(Error::Save)?;
        Ok(Machine::assemble(Arc::clone(&self.layout), self.fingerprint, Arc::clone(&self.model), state, rigid))
    }
}
