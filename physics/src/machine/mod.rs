//! The machine in play.

pub(crate) mod command;
pub(crate) mod diagnostics;
pub(crate) mod fingerprint;
pub(crate) mod save;

use crate::ball::motion::Motion;
use crate::ball::{Ball, Hold};
use crate::collision::time_of_impact::is_out_of_reach;
use crate::collision::world::Plan;
use crate::layout::{FlipperControl, Layout, PartId, check};
use crate::machine::fingerprint::fingerprint;
use crate::mechanisms::controls::{Command, Controls};
use crate::mechanisms::flipper::{Blade, FINE_STEPS, Rotor};
use crate::mechanisms::rigid_mechanisms::Works;
use crate::mechanisms::state::{KICKER_READY_TICKS, State};
use crate::mechanisms::{elevation, magnet, rod, triggers};
use crate::part::event::{Contact, Event, EventKind};
use crate::solver::sweep::{Scratch, Sweep};
use crate::{BALL_RADIUS_M, TICK_S};
use geometry::DVec2;
use std::sync::Arc;

/// Everything on the playfield, tick after tick. A clone goes on exactly as the original does, and is cheap: the layout
/// and all that follows from it is shared.
#[derive(Clone, Debug)]
pub struct Machine {
    layout: Arc<Layout>,
    /// Of the layout, as saved bytes name it.
    fingerprint: u64,
    pub(crate) plan: Arc<Plan>,
    pub(crate) state: State,
    pub(crate) works: Works,
    scratch: Scratch,
    pub(crate) starts: Vec<DVec2>,
    pub(crate) events: Vec<Event>,
    contacts: Vec<Contact>,
    /// Least number of steps in a tick: 1 in play.
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
        check::layout(&layout)?;
        let plan = Plan::new(&layout);
        let state = State::new(&plan);
        let works = Works::new(&plan);
        let fingerprint = fingerprint(&*layout);
        Ok(Machine::assemble(layout, fingerprint, Arc::new(plan), state, works))
    }

    fn assemble(layout: Arc<Layout>, fingerprint: u64, plan: Arc<Plan>, state: State, works: Works) -> Machine {
        Machine {
            layout,
            fingerprint,
            plan,
            state,
            works,
            scratch: Scratch::default(),
            starts: Vec::new(),
            events: Vec::new(),
            contacts: Vec::new(),
            substeps: 1,
        }
    }

    /// The slow twin of a machine in play, for experiments: its balls and flippers take at least `substeps` steps in a
    /// tick (1 in play; near a moving flipper there are more in any case). Its clones are as slow; what is restored from
    /// its bytes is not.
    pub fn substepped(self, substeps: u32) -> Machine {
        Machine { substeps: substeps.max(1), ..self }
    }

    /// What stands on the playfield.
    pub fn layout(&self) -> &Arc<Layout> {
        &self.layout
    }

    /// One millisecond. Commands are obeyed first, in their order.
    pub fn tick(&mut self, controls: Controls, commands: &[Command]) {
        self.events.clear();
        self.contacts.clear();
        commands.iter().for_each(|command| self.obey(command));
        self.feed();
        self.raise();
        let shake = self.state.mechanisms.cabinet.tick(&controls);
        let felt = [(shake.bob, EventKind::TiltBob), (shake.slam, EventKind::Slam)];
        self.events.extend(felt.into_iter().filter(|felt| felt.0).map(|(_, kind)| Event { part: None, kind }));
        for ticks in &mut self.state.mechanisms.kickers {
            *ticks = (*ticks + 1).min(KICKER_READY_TICKS);
        }
        self.pull_rods(controls.plunger);
        self.starts.clear();
        self.starts.extend(self.state.balls.iter().map(|ball| ball.center));
        self.move_all(&controls, shake.acceleration);
        self.move_works();
        elevation::tick(&self.plan, &mut self.state, &self.starts, TICK_S, &mut self.events);
        triggers::tick(&self.plan, &mut self.state, &self.starts, &mut self.events);
        let State { balls, mechanisms } = &mut self.state;
        rod::report(&self.plan.slides, balls, &mut mechanisms.rods, &mut self.events);
        magnet::report(&self.plan, balls, mechanisms, &mut self.events);
        self.state.balls.iter_mut().for_each(|ball| ball.end_tick(TICK_S));
    }

    /// Puts a ball on the playfield, for experiments: centre in m, velocity in m/s, spin as in [`crate::mechanisms::pose::BallPose::spin`]. Returns its id.
    pub fn put_ball(&mut self, center: DVec2, velocity_m_s: DVec2, spin_rad_s: [f64; 3]) -> u32 {
        let id = self.state.mechanisms.next_ball;
        self.state.mechanisms.next_ball = id.wrapping_add(1);
        let ball = Ball { velocity: velocity_m_s, spin: spin_rad_s.into(), ..Ball::new(id, center) };
        self.state.balls.push(ball);
        id
    }

    fn pull_rods(&mut self, held: bool) {
        for (slide, rod) in self.plan.slides.iter().zip(&mut self.state.mechanisms.rods) {
            slide.tick(rod, held);
        }
    }

    /// For each rotor whether its coil is on.
    fn pressed(&self, controls: &Controls) -> Vec<bool> {
        let own = &self.state.mechanisms;
        let pressed = |(blade, &diverted): (&Blade, &bool)| match blade.flipper.control {
            FlipperControl::Left => own.flippers_live && controls.left,
            FlipperControl::Right => own.flippers_live && controls.right,
            FlipperControl::Rules => diverted,
        };
        self.plan.blades.iter().zip(&own.diverted).map(pressed).collect()
    }

    fn move_all(&mut self, controls: &Controls, cabinet: DVec2) {
        let plan = Arc::clone(&self.plan);
        let pull = DVec2::new(0.0, plan.floor.gravity) - cabinet;
        let pressed = self.pressed(controls);
        // A flipper that moves where no ball can come to turns alone; the others turn in the steps of the balls.
        let mut alone = vec![false; plan.blades.len()];
        let mut steps = 1;
        for (index, (blade, rotor)) in plan.blades.iter().zip(&self.state.mechanisms.rotors).enumerate() {
            if blade.will_move(rotor, pressed[index], TICK_S) {
                alone[index] = !self.state.balls.iter().any(|ball| may_reach(blade, rotor, ball));
                steps = if alone[index] { steps } else { steps.max(blade.steps(rotor)) };
            }
        }
        for (index, blade) in plan.blades.iter().enumerate().filter(|&(index, _)| alone[index]) {
            let rotor = &mut self.state.mechanisms.rotors[index];
            for _ in 0..FINE_STEPS {
                blade.turn(rotor, pressed[index], TICK_S / f64::from(FINE_STEPS));
                rotor.advance(TICK_S / f64::from(FINE_STEPS));
                blade.settle(rotor);
            }
        }
        let steps = self.substeps.max(steps);
        let duration = TICK_S / f64::from(steps);
        self.scratch.clear.clear();
        self.scratch.angles.clear();
        if steps > 1 {
            self.sweep(&plan, 0.0, &alone).look_around();
        }
        for step in 0..steps {
            for (index, blade) in plan.blades.iter().enumerate().filter(|&(index, _)| !alone[index]) {
                blade.turn(&mut self.state.mechanisms.rotors[index], pressed[index], duration);
            }
            self.step(&plan, pull, f64::from(step) * duration, duration, &alone);
        }
    }

    fn step(&mut self, plan: &Plan, pull: DVec2, elapsed: f64, duration: f64, alone: &[bool]) {
        self.scratch.motions.clear();
        self.scratch.motions.resize(self.state.balls.len(), Motion::new(pull, plan.floor));
        for (ball, motion) in self.state.balls.iter().zip(&mut self.scratch.motions) {
            if let Hold::Sinking(saucer) = ball.hold {
                motion.pull += triggers::bowl(&plan.saucers[saucer].1, ball);
            }
            elevation::act(plan, ball, duration, motion);
            magnet::act(plan, &self.state.mechanisms, ball, duration, motion);
        }
        self.sweep(plan, elapsed, alone).step(duration);
    }

    fn sweep<'a>(&'a mut self, plan: &'a Plan, elapsed: f64, alone: &'a [bool]) -> Sweep<'a> {
        let (events, contacts) = (&mut self.events, &mut self.contacts);
        Sweep { plan, state: &mut self.state, scratch: &mut self.scratch, events, contacts, elapsed, alone }
    }

    /// What happened in the last tick, in order.
    pub fn events(&self) -> &[Event] {
        &self.events
    }

    /// The impacts of the last tick, in order.
    pub fn contacts(&self) -> &[Contact] {
        &self.contacts
    }

    /// Of everything that can change what happens next.
    pub fn hashes(&self) -> Hashes {
        save::hashes(&self.state, &self.works)
    }

    /// Everything that can change what happens next.
    pub fn save(&self) -> Vec<u8> {
        save::write(self.fingerprint, &self.state, &self.works)
    }

    /// The machine that [`Machine::save`] wrote, on the same layout.
    ///
    /// # Errors
    /// If the bytes are not what `save` writes for this layout.
    pub fn restore(layout: Arc<Layout>, bytes: &[u8]) -> Result<Machine, Error> {
        Machine::new(layout)?.restored(bytes)
    }

    /// As [`Machine::restore`], on this one's layout: much faster, because what follows from the layout is shared.
    /// Nothing else of this machine is in the other.
    ///
    /// # Errors
    /// If the bytes are not what `save` writes for this layout.
    pub fn restored(&self, bytes: &[u8]) -> Result<Machine, Error> {
        let (state, works) = save::read(self.fingerprint, &self.plan, bytes).map_err(Error::Save)?;
        Ok(Machine::assemble(Arc::clone(&self.layout), self.fingerprint, Arc::clone(&self.plan), state, works))
    }
}

/// Whether a ball can come to where the flipper may be within the tick, both being a good deal faster than they are:
/// another ball, a kicker and the coil may see to that.
fn may_reach(blade: &Blade, rotor: &Rotor, ball: &Ball) -> bool {
    let travel = 2.0 * ball.velocity.length() * TICK_S + 6e-3;
    if ball.is_held() || ball.is_up() || is_out_of_reach(blade, ball.center, travel) {
        return false;
    }
    let turn = (2.0 * rotor.speed.abs() + blade.most_acceleration(rotor) * TICK_S) * TICK_S;
    blade.taper(rotor.angle).distance(ball.center).0 < BALL_RADIUS_M + travel + turn * blade.reach
}
