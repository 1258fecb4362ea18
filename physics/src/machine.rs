//! The machine in play.

use crate::ball::{Ball, Hold};
use crate::flipper::Blade;
use crate::plan::{Plan, Role};
use crate::state::{Goal, KICKER_READY_TICKS, State};
use crate::sweep::{Motion, Scratch, Sweep};
use crate::works::{Plate, Works};
use crate::{
    BALL_RADIUS_M, Command, Contact, Controls, Event, EventKind, Layout, PartId, Pose, TICK_S, check, plates, save,
    zones,
};
use geometry::DVec2;
use std::sync::Arc;

/// Steps in a tick while a flipper moves near a ball: 32 kHz.
const FINE_STEPS: u32 = 32;
/// What a drop target needs to rise: no ball may come over it so soon.
const RISE_S: f64 = 0.05;
/// A kicker's arm or ring comes this far out of its rubber.
const KICK_REACH_M: f64 = 3e-3;
/// A drop target with more of it above the playfield stands in the ball's way: its top is above the ball's middle.
const STANDING: f64 = 0.55;

/// Everything on the playfield, tick after tick. A clone goes on exactly as the original does, and is cheap: the layout
/// and all that follows from it is shared.
#[derive(Clone, Debug)]
pub struct Machine {
    layout: Arc<Layout>,
    plan: Arc<Plan>,
    pub(crate) state: State,
    works: Works,
    scratch: Scratch,
    starts: Vec<DVec2>,
    events: Vec<Event>,
    contacts: Vec<Contact>,
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
        Ok(Machine {
            layout,
            plan: Arc::new(plan),
            state,
            works,
            scratch: Scratch::default(),
            starts: Vec::new(),
            events: Vec::new(),
            contacts: Vec::new(),
        })
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
        let (acceleration, tilted) = self.state.mechanisms.cabinet.tick(&controls);
        if tilted {
            self.events.push(Event { part: None, kind: EventKind::TiltBob });
        }
        for ticks in &mut self.state.mechanisms.kickers {
            *ticks = (*ticks + 1).min(KICKER_READY_TICKS);
        }
        self.pull_plungers(controls.plunger);
        self.starts.clear();
        self.starts.extend(self.state.balls.iter().map(|ball| ball.center));
        self.move_all(&controls, acceleration);
        self.move_works();
        zones::tick(&self.plan, &mut self.state, &self.starts, &mut self.events);
        self.report_launch();
        self.state.balls.iter_mut().for_each(|ball| ball.end_tick(TICK_S));
    }

    /// Puts a ball on the playfield, for experiments: centre in m, velocity in m/s, spin as in [`crate::BallPose::spin`]. Returns its id.
    pub fn put_ball(&mut self, center: DVec2, velocity_m_s: DVec2, spin_rad_s: [f64; 3]) -> u32 {
        let id = self.state.mechanisms.next_ball;
        self.state.mechanisms.next_ball = id.wrapping_add(1);
        let ball = Ball { velocity: velocity_m_s, spin: spin_rad_s.into(), ..Ball::new(id, center) };
        self.state.balls.push(ball);
        id
    }

    fn obey(&mut self, command: &Command) {
        match *command {
            Command::AddBall => self.state.mechanisms.queue = self.state.mechanisms.queue.saturating_add(1),
            Command::Eject(part) => {
                if let Some(saucer) = self.plan.saucers.iter().position(|&(own, _)| own == part.0) {
                    zones::eject(&self.plan, &mut self.state, saucer, &mut self.events);
                }
            }
            Command::Raise(part) => {
                if let Some(drop) = self.plan.drops.iter().position(|drop| drop.part == part.0) {
                    let drop = &mut self.state.mechanisms.drops[drop];
                    if drop.goal == Goal::Down {
                        drop.goal = Goal::Rise;
                        drop.solid = false;
                        drop.falling = false;
                    }
                }
            }
            Command::BallSearch => self.search(),
            Command::SetFlippers(live) => self.state.mechanisms.flippers_live = live,
            Command::SetKickers(live) => self.state.mechanisms.kickers_live = live,
        }
    }

    /// Fires every coil once, whatever its switch says.
    fn search(&mut self) {
        let plan = Arc::clone(&self.plan);
        for obstacle in &plan.obstacles {
            let Role::Kicker(index) = obstacle.role else { continue };
            self.state.mechanisms.kickers[index] = 0;
            for ball in self.state.balls.iter_mut().filter(|ball| !ball.is_held()) {
                let (distance, normal) = obstacle.shape.distance(ball.center);
                if distance < KICK_REACH_M {
                    ball.velocity += normal * plan.kickers[index].speed_at(ball.center);
                }
            }
        }
        for saucer in 0..plan.saucers.len() {
            zones::eject(&plan, &mut self.state, saucer, &mut self.events);
        }
        plan.drops.iter().for_each(|drop| self.obey(&Command::Raise(PartId(drop.part))));
    }

    /// Puts a waiting ball into the plunger lane, as soon as there is room.
    fn feed(&mut self) {
        let Some((part, plunger)) = self.plan.plungers.first() else { return };
        let room = 2.0 * BALL_RADIUS_M + 1e-3;
        let free = self.state.balls.iter().all(|ball| ball.center.distance(plunger.feed) > room);
        if self.state.mechanisms.queue > 0 && free {
            self.state.mechanisms.queue -= 1;
            self.state.balls.push(Ball::new(self.state.mechanisms.next_ball, plunger.feed));
            self.state.mechanisms.next_ball = self.state.mechanisms.next_ball.wrapping_add(1);
            self.events.push(Event { part: Some(PartId(*part)), kind: EventKind::Fed });
        }
    }

    /// Raises the drop targets that are asked to rise and have no ball over them.
    fn raise(&mut self) {
        let plan = Arc::clone(&self.plan);
        for obstacle in &plan.obstacles {
            let Role::Drop(index) = obstacle.role else { continue };
            let away = |ball: &Ball, time: f64| obstacle.shape.distance(ball.center).0 > ball.velocity.length() * time;
            let clear = self.state.balls.iter().all(|ball| away(ball, 0.0));
            let stays_clear = self.state.balls.iter().all(|ball| away(ball, RISE_S));
            let drop = &mut self.state.mechanisms.drops[index];
            let high = self.works.height(index) > STANDING;
            match drop.goal {
                Goal::Rise if stays_clear => {
                    drop.goal = Goal::Up;
                    self.works.send(index, true);
                }
                // A ball has come over it while it rose: down again, until it has gone.
                Goal::Up if high && !drop.solid && !clear => {
                    drop.goal = Goal::Rise;
                    self.works.send(index, false);
                }
                Goal::Up if high && !drop.solid => {
                    drop.solid = true;
                    self.events.push(Event { part: Some(PartId(obstacle.part)), kind: EventKind::Opened });
                }
                Goal::Down if drop.solid => {
                    if drop.falling {
                        drop.solid = high;
                    } else {
                        drop.falling = true;
                        self.works.send(index, false);
                    }
                }
                _ => {}
            }
        }
    }

    /// Balls push plates and flaps, and rapier moves everything that it owns.
    fn move_works(&mut self) {
        let plan = Arc::clone(&self.plan);
        if !(plan.gates.is_empty() && plan.spinners.is_empty()) {
            for (ball, &start) in self.state.balls.iter_mut().zip(&self.starts) {
                if !ball.is_held() {
                    plates::pass(&plan, &mut self.works, ball, start);
                }
            }
        }
        let events = &mut self.events;
        self.works.tick(|spinner| {
            events.push(Event { part: Some(PartId(plan.spinners[spinner].0)), kind: EventKind::Closed });
        });
    }

    fn pull_plungers(&mut self, held: bool) {
        for ((_, plunger), rod) in self.plan.plungers.iter().zip(&mut self.state.mechanisms.rods) {
            rod.tick(plunger, held);
        }
    }

    fn move_all(&mut self, controls: &Controls, cabinet: DVec2) {
        let plan = Arc::clone(&self.plan);
        let pull = DVec2::new(0.0, plan.floor.gravity) - cabinet;
        let live = self.state.mechanisms.flippers_live;
        let pressed = |left: bool| live && if left { controls.left } else { controls.right };
        let fine = TICK_S / f64::from(FINE_STEPS);
        let (mut moving, mut near) = (false, false);
        for (blade, rotor) in plan.blades.iter().zip(&self.state.mechanisms.rotors) {
            moving |= blade.will_move(rotor, pressed(blade.flipper.left), TICK_S);
            near |= self.state.balls.iter().any(|ball| may_reach(blade, ball));
        }
        let apart = moving && !near;
        if apart {
            for _ in 0..FINE_STEPS {
                self.turn_flippers(&plan, fine, pressed);
                self.state.mechanisms.rotors.iter_mut().for_each(|rotor| rotor.advance(fine));
                self.settle_flippers(&plan);
            }
        }
        let steps = if moving && near { FINE_STEPS } else { 1 };
        let duration = TICK_S / f64::from(steps);
        for _ in 0..steps {
            if !apart {
                self.turn_flippers(&plan, duration, pressed);
            }
            self.step(&plan, pull, duration, !apart);
            if !apart {
                self.settle_flippers(&plan);
            }
        }
    }

    fn turn_flippers(&mut self, plan: &Plan, duration: f64, pressed: impl Fn(bool) -> bool) {
        for (blade, rotor) in plan.blades.iter().zip(&mut self.state.mechanisms.rotors) {
            blade.energise(rotor, pressed(blade.flipper.left), duration);
            blade.accelerate(rotor, duration);
        }
    }

    fn settle_flippers(&mut self, plan: &Plan) {
        for (blade, rotor) in plan.blades.iter().zip(&mut self.state.mechanisms.rotors) {
            blade.settle(rotor);
        }
    }

    fn step(&mut self, plan: &Plan, pull: DVec2, duration: f64, flippers_move: bool) {
        self.scratch.motions.clear();
        for ball in &self.state.balls {
            let sunk = match ball.hold {
                Hold::Sinking(saucer) => zones::bowl(&plan.saucers[saucer].1, ball),
                _ => DVec2::ZERO,
            };
            self.scratch.motions.push(Motion::new(pull + sunk));
        }
        let (events, contacts) = (&mut self.events, &mut self.contacts);
        Sweep { plan, state: &mut self.state, scratch: &mut self.scratch, events, contacts, flippers_move }
            .step(duration);
    }

    fn report_launch(&mut self) {
        for ((part, plunger), rod) in self.plan.plungers.iter().zip(&self.state.mechanisms.rods) {
            let face = rod.face(plunger);
            let shot =
                |ball: &Ball| ball.velocity.dot(plunger.way) > 0.5 * rod.speed && face.distance(ball.center).0 < 2e-3;
            if rod.is_shooting() && rod.pulled <= 0.0 && self.state.balls.iter().any(shot) {
                self.events.push(Event { part: Some(PartId(*part)), kind: EventKind::Launched });
            }
        }
    }

    /// What happened in the last tick, in order.
    pub fn events(&self) -> &[Event] {
        &self.events
    }

    /// The impacts of the last tick, in order.
    pub fn contacts(&self) -> &[Contact] {
        &self.contacts
    }

    /// Where everything is now.
    pub fn pose(&self) -> Pose {
        let (plan, own) = (&self.plan, &self.state.mechanisms);
        let angles = plan.blades.iter().zip(&own.rotors).map(|(blade, rotor)| (PartId(blade.part), rotor.angle));
        let drops = plan.drops.iter().enumerate().map(|(index, d)| (PartId(d.part), self.works.height(index)));
        let plates = |parts: Vec<u16>, plate: fn(usize) -> Plate| {
            let angle = |(index, part)| (PartId(part), self.works.angle(plate(index)));
            parts.into_iter().enumerate().map(angle).collect()
        };
        let kickers = plan.kickers.iter().zip(&own.kickers).map(|(k, &ticks)| (PartId(k.part), kick_pose(ticks)));
        let pulled = plan.plungers.iter().zip(&own.rods).map(|((_, p), rod)| (rod.pulled / p.stroke_m).max(0.0));
        Pose {
            balls: self.state.balls.iter().map(Ball::pose).collect(),
            flippers_rad: angles.collect(),
            drop_targets: drops.collect(),
            spinners_rad: plates(plan.spinners.iter().map(|&(part, _)| part).collect(), Plate::Spinner),
            gates_rad: plates(plan.gates.iter().map(|&(part, _)| part).collect(), Plate::Gate),
            kickers: kickers.collect(),
            plunger: pulled.fold(0.0, f64::max),
            cabinet_m: own.cabinet.place,
        }
    }

    /// How long each ball has hardly moved where nothing should hold it, ticks: in the order of [`Pose::balls`]; 0 for
    /// a ball in a saucer, in the plunger lane or on a raised flipper.
    pub fn stuck_ticks(&self) -> Vec<u32> {
        let excused = |ball: &Ball| ball.is_held() || self.waits_for_plunger(ball) || self.lies_on_flipper(ball);
        let stuck = |ball: &Ball| if excused(ball) { 0 } else { ball.still_ticks };
        self.state.balls.iter().map(stuck).collect()
    }

    fn waits_for_plunger(&self, ball: &Ball) -> bool {
        self.plan.plungers.iter().any(|(_, plunger)| {
            let from_tip = ball.center - plunger.tip;
            let lane = plunger.half_width_m + BALL_RADIUS_M;
            from_tip.dot(plunger.way.perp()).abs() < lane && from_tip.dot(plunger.way) < 8.0 * BALL_RADIUS_M
        })
    }

    fn lies_on_flipper(&self, ball: &Ball) -> bool {
        self.plan.blades.iter().zip(&self.state.mechanisms.rotors).any(|(blade, rotor)| {
            let gap = blade.taper(rotor.angle).distance(ball.center).0 - BALL_RADIUS_M;
            gap < 1e-3 && blade.is_raised(rotor)
        })
    }

    /// How deep a ball lies in anything that stands in its way, m; 0 or less where nothing overlaps.
    pub fn overlap_m(&self) -> f64 {
        let mut deepest = f64::NEG_INFINITY;
        let own = &self.state.mechanisms;
        for (index, ball) in self.state.balls.iter().enumerate() {
            self.plan.obstacle_grid.visit(ball.center, ball.center, |obstacle| {
                let obstacle = &self.plan.obstacles[obstacle];
                let counts = match obstacle.role {
                    Role::Drop(drop) => own.drops[drop].solid,
                    Role::Gate(_) => false,
                    _ => true,
                };
                if counts {
                    deepest = deepest.max(-obstacle.shape.distance(ball.center).0);
                }
            });
            for (blade, rotor) in self.plan.blades.iter().zip(&own.rotors) {
                deepest = deepest.max(BALL_RADIUS_M - blade.taper(rotor.angle).distance(ball.center).0);
            }
            for other in &self.state.balls[index + 1..] {
                deepest = deepest.max(2.0 * BALL_RADIUS_M - ball.center.distance(other.center));
            }
        }
        deepest
    }

    /// How many balls are not on the playfield, or nowhere at all (not a number).
    pub fn escaped(&self) -> usize {
        let on = |ball: &Ball| {
            ball.center.cmpge(DVec2::ZERO).all() && ball.center.cmple(self.plan.size).all() && ball.velocity.is_finite()
        };
        self.state.balls.iter().filter(|ball| !on(ball)).count()
    }

    /// Of everything that can change what happens next.
    pub fn hashes(&self) -> Hashes {
        save::hashes(&self.state, &self.works)
    }

    /// Everything that can change what happens next.
    pub fn save(&self) -> Vec<u8> {
        save::write(&self.layout, &self.state, &self.works)
    }

    /// The machine that [`Machine::save`] wrote, on the same layout.
    ///
    /// # Errors
    /// If the bytes are not what `save` writes for this layout.
    pub fn restore(layout: Arc<Layout>, bytes: &[u8]) -> Result<Machine, Error> {
        let mut machine = Machine::new(layout)?;
        (machine.state, machine.works) = save::read(&machine.layout, &machine.plan, bytes).map_err(Error::Save)?;
        Ok(machine)
    }
}

/// Whether a ball can come to where the flipper may be within the tick.
fn may_reach(blade: &Blade, ball: &Ball) -> bool {
    let reach = blade.reach + BALL_RADIUS_M + 2.0 * ball.velocity.length() * TICK_S + 2e-3;
    !ball.is_held() && ball.center.distance_squared(blade.pivot()) < reach * reach
}

/// How far a kicker is out, `ticks` after it fired: out in 8 ms, back in 40.
fn kick_pose(ticks: u16) -> f64 {
    let ticks = f64::from(ticks);
    if ticks < 8.0 { ticks / 8.0 } else { (1.0 - (ticks - 8.0) / 40.0).max(0.0) }
}
