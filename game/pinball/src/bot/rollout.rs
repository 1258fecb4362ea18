//! Rollout: one possible future: a copy of the machine, played on without the rules.

use super::flipper_zones::FlipperZones;
use super::shot_value::ShotValues;
use crate::Buttons;
use crate::simulation::controls;
use physics::{EventKind, Kind, Machine};

/// Ticks between two evaluations of where the balls are.
const EVALUATION_PERIOD_TICKS: u64 = 10;

/// Contact solves that a rollout may take. A ball that is jammed behind a flipper takes hundreds in each tick: what becomes
/// of it is not worth minutes.
const MAX_CONTACT_SOLVES: u64 = 20_000;

/// A possible future. A clone can be played on in another way.
#[derive(Clone)]
pub(super) struct Rollout<'a> {
    machine: Machine,
    zones: &'a FlipperZones,
    shot_values: &'a ShotValues,
    held: Buttons,
    /// Contact solves that it has taken.
    contact_solves: u64,
    /// The tick that has been reached.
    pub tick: u64,
    /// What has been hit, in the bot's own opinion.
    pub gained: f64,
    /// Balls that are gone, or that nothing can save any more.
    pub lost: usize,
    /// A ball came to lie on a raised flipper.
    pub cradled: bool,
    /// A saucer has caught a ball.
    pub caught: bool,
}

/// What it costs to lose a ball.
const LOSS: f64 = 60.0;
/// What it is worth to have a ball under control.
const CONTROL: f64 = 15.0;
/// What it costs when a ball comes down between the flippers.
const GAP: f64 = 25.0;

impl<'a> Rollout<'a> {
    /// The present.
    pub fn now(
        machine: &Machine,
        held: Buttons,
        tick: u64,
        zones: &'a FlipperZones,
        shot_values: &'a ShotValues,
    ) -> Rollout<'a> {
        let machine = machine.clone();
        Rollout {
            machine,
            zones,
            shot_values,
            held,
            contact_solves: 0,
            tick,
            gained: 0.0,
            lost: 0,
            cradled: false,
            caught: false,
        }
    }

    /// Presses or lets go.
    pub fn set(&mut self, buttons: Buttons, down: bool) {
        self.held = self.held.with(buttons, down);
    }

    /// Plays on for so many ticks, or until `enough`, which is asked now and then. Of a rollout that has taken too much
    /// the rest stays unknown.
    pub fn play(&mut self, ticks: u64, mut enough: impl FnMut(&Rollout) -> bool) {
        let end = self.tick + ticks;
        while self.tick < end {
            if self.contact_solves > MAX_CONTACT_SOLVES {
                self.tick = end;
                return;
            }
            self.play_tick();
            if self.tick.is_multiple_of(EVALUATION_PERIOD_TICKS) {
                self.evaluate();
                if enough(self) {
                    return;
                }
            }
        }
    }

    /// Where the balls are that can still be played.
    pub fn balls(&self) -> Vec<physics::BallPose> {
        let mut balls = self.machine.balls();
        balls.retain(|ball| !ball.held && !self.zones.in_lane(ball));
        balls
    }

    /// Where the flippers are.
    pub fn zones(&self) -> &'a FlipperZones {
        self.zones
    }

    /// Counts the balls that nothing can save any more, at the end of a rollout.
    pub fn mark_lost(&mut self) {
        self.lost += self.balls().iter().filter(|ball| self.zones.lost(ball.center)).count();
    }

    /// Whether it is clear what becomes of every ball: gone, in reach of a flipper, or on its way up.
    pub fn settled(&self) -> bool {
        let clear = |ball: &physics::BallPose| {
            self.zones.lost(ball.center)
                || self.zones.in_reach(ball.center).is_some()
                || self.zones.arrives_in(ball).is_none()
        };
        self.lost > 0 || self.balls().iter().all(clear)
    }

    /// How good it is to be here.
    pub fn value(&self) -> f64 {
        let control = if self.cradled { CONTROL } else { 0.0 };
        let gap = self.balls().iter().filter(|ball| self.falls_into_gap(ball)).count() as f64;
        self.gained + control - LOSS * self.lost as f64 - GAP * gap
    }

    fn play_tick(&mut self) {
        self.machine.tick(controls(self.held), &[]);
        self.contact_solves += self.machine.contact_solves();
        self.tick += 1;
        for event in self.machine.events().iter().filter(|event| event.kind == EventKind::Closed) {
            let Some(part) = event.part else { continue };
            self.gained += self.shot_values.of(part, self.tick);
            match self.machine.layout().parts.get(usize::from(part.0)).map(|part| &part.kind) {
                Some(Kind::Drain(_)) => self.lost += 1,
                Some(Kind::Saucer(_)) => self.caught = true,
                _ => {}
            }
        }
    }

    fn evaluate(&mut self) {
        let balls = self.balls();
        self.cradled = balls.iter().any(|ball| {
            let side = |left| if left { Buttons::LEFT } else { Buttons::RIGHT };
            self.zones.cradle(ball).is_some_and(|flipper| self.held.contains(side(flipper.left)))
        });
    }

    /// A ball that comes down between the flippers, if nothing is in its way.
    fn falls_into_gap(&self, ball: &physics::BallPose) -> bool {
        let below_m = self.zones.line_m - ball.center.y;
        if ball.velocity.y < 0.1 || below_m > 0.3 * ball.velocity.y {
            return false;
        }
        let x = ball.center.x + ball.velocity.x * (below_m / ball.velocity.y).max(0.0);
        let tips = |left: bool| {
            let side = self.zones.flippers.iter().filter(move |flipper| flipper.left == left);
            side.map(|flipper| flipper.tip.x)
        };
        let left = tips(true).fold(f64::MIN, f64::max);
        let right = tips(false).fold(f64::MAX, f64::min);
        (left..right).contains(&x)
    }
}
