//! Shots from everywhere at everything on a table, and what they come to.
//!
//! Nothing comes through unseen: to a ball's centre every wall is 27 mm thick and every flipper 40, and a ball and a flipper
//! together go 21 mm in a tick at most, so what comes through is deep inside at the end of some tick.

use super::friction_cone::{FrictionCone, Frictions};
use crate::bot::BotRng;
use geometry::{DVec2, trig};
use indicatif::ProgressBar;
use physics::{Controls, Flipper, FlipperControl, Kind, Layout, Machine};
use rayon::prelude::*;
use std::f64::consts::TAU;

/// Shots that one seed gives, so that the result is the same on any number of threads.
const LOT: u64 = 500;
/// How long a shot is followed, ticks.
const FOLLOWED: usize = 60;
/// How long a ball wanders for places to shoot from, ticks: at most so long before the first, and on to the last.
const FIRST: f64 = 300.0;
const WANDER: usize = 1500;
/// Ticks from one place to the next, and how far the ball must have come, m: where it lies is one place.
const STRIDE: usize = 20;
const APART_M: f64 = 0.002;
/// A place that is not free is left for another, so often before the shot is given up.
const TRIES: usize = 20;

/// What is shot at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Aim {
    /// From anywhere.
    Everything,
    /// From near a flipper that moves.
    Flippers,
}

/// What shots came to.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Tally {
    /// The balls that were really shot.
    pub shots: u64,
    /// Shots after which a ball was not on the table.
    pub escapes: u64,
    /// Deepest overlap at the end of a tick, m.
    pub deepest_m: f64,
    /// Their impacts.
    pub cone: FrictionCone,
}

impl Tally {
    fn and(self, other: Tally) -> Tally {
        Tally {
            shots: self.shots + other.shots,
            escapes: self.escapes + other.escapes,
            deepest_m: self.deepest_m.max(other.deepest_m),
            cone: self.cone.and(other.cone),
        }
    }
}

/// Shoots `count` balls on the table of the machine `fresh`, as many at once as the pool has threads.
pub fn shoot_all(fresh: &Machine, count: u64, aim: Aim, bar: &ProgressBar) -> Tally {
    let frictions = Frictions::of(fresh.layout());
    let lot = |lot: u64| {
        let mut range = Range::new(fresh, aim, BotRng::new(lot ^ (u64::from(aim == Aim::Flippers) << 40)));
        let shots = LOT.min(count - lot * LOT);
        let tally = (0..shots).fold(Tally::default(), |tally, _| tally.and(range.shoot(&frictions)));
        bar.inc(shots);
        tally
    };
    (0..count.div_ceil(LOT)).into_par_iter().map(lot).reduce(Tally::default, Tally::and)
}

/// Places and moments to shoot from: a few thousand ticks give them for all the shots of a lot.
struct Range<'a> {
    fresh: &'a Machine,
    aim: Aim,
    rng: BotRng,
    hands: Hands,
    /// The machine at each tick of its hands' period.
    phases: Vec<Machine>,
    /// What is left of the last wander.
    places: Vec<DVec2>,
}

/// Both flipper buttons, pressed for `press` of every `period` ticks.
#[derive(Clone, Copy)]
struct Hands {
    period: usize,
    press: usize,
}

impl Hands {
    fn at(self, tick: usize) -> Controls {
        let down = tick % self.period < self.press;
        Controls { left: down, right: down, ..Controls::NONE }
    }
}

impl<'a> Range<'a> {
    fn new(fresh: &'a Machine, aim: Aim, mut rng: BotRng) -> Range<'a> {
        // Where everything is shot at, flippers also rest: they cost the most when they move.
        let (period, press) = match aim {
            Aim::Everything => ((200.0, 1200.0), (2.0, 120.0)),
            Aim::Flippers => ((30.0, 90.0), (2.0, 45.0)),
        };
        let mut ticks = |(low, high)| between(&mut rng, low, high) as usize;
        let hands = Hands { period: ticks(period), press: ticks(press) };
        let mut machine = fresh.clone();
        let phase = |tick| {
            let now = machine.clone();
            machine.tick(hands.at(tick), &[]);
            now
        };
        let phases = (0..hands.period).map(phase).collect();
        Range { fresh, aim, rng, hands, phases, places: Vec::new() }
    }

    /// One ball from a free place at 0.05 to 15 m/s, while both flippers flip.
    fn shoot(&mut self, frictions: &Frictions) -> Tally {
        for _ in 0..TRIES {
            let place = self.place();
            let phase = (self.rng.unit() * self.phases.len() as f64) as usize;
            let mut machine = self.phases[phase].clone();
            let way = trig::direction(between(&mut self.rng, 0.0, TAU));
            let speed = 0.05 * libm::pow(300.0, self.rng.unit());
            let spin = [0.0; 3].map(|_: f64| between(&mut self.rng, -200.0, 200.0));
            machine.put_ball(place, way * speed, spin);
            if machine.penetration_m() <= 0.0 {
                return self.follow(machine, phase, frictions);
            }
        }
        Tally::default()
    }

    fn follow(&self, mut machine: Machine, phase: usize, frictions: &Frictions) -> Tally {
        let mut tally = Tally { shots: 1, ..Tally::default() };
        for tick in phase..phase + FOLLOWED {
            machine.tick(self.hands.at(tick), &[]);
            tally.escapes = tally.escapes.max(machine.escaped() as u64);
            tally.deepest_m = tally.deepest_m.max(machine.penetration_m());
            machine.contacts().iter().for_each(|contact| tally.cone.add(contact, frictions));
        }
        tally
    }

    /// A place to shoot from; when they are used up, new ones are found.
    fn place(&mut self) -> DVec2 {
        while self.places.is_empty() {
            match self.aim {
                Aim::Everything => self.wander(),
                Aim::Flippers => self.surround_flippers(),
            }
        }
        let which = (self.rng.unit() * self.places.len() as f64) as usize;
        self.places.swap_remove(which)
    }

    /// Where a ball comes past that is thrown into play and left to itself: never where no ball can be.
    fn wander(&mut self) {
        let mut machine = self.fresh.clone();
        let way = trig::direction(between(&mut self.rng, 0.0, TAU));
        machine.put_ball(middle(machine.layout()), way * between(&mut self.rng, 1.0, 5.0), [0.0; 3]);
        let first = between(&mut self.rng, 0.0, FIRST) as usize;
        let mut last = DVec2::INFINITY;
        for tick in 0..WANDER {
            machine.tick(Controls::NONE, &[]);
            if tick >= first && (tick - first).is_multiple_of(STRIDE) {
                let Some(ball) = machine.pose().balls.first().copied() else { return };
                if !ball.above && ball.center.distance(last) > APART_M {
                    last = ball.center;
                    self.places.push(last);
                }
            }
        }
    }

    fn surround_flippers(&mut self) {
        for _ in 0..WANDER / STRIDE {
            let place = self.near_flipper();
            self.places.push(place);
        }
    }

    /// A place within a few centimetres of a flipper, on the side that balls come from.
    fn near_flipper(&mut self) -> DVec2 {
        let layout = self.fresh.layout().clone();
        let which = (self.rng.unit() * flippers(&layout).count() as f64) as usize;
        let Some(flipper) = flippers(&layout).nth(which) else { return middle(&layout) };
        let along = trig::direction(flipper.rest_rad) * (flipper.length_m * between(&mut self.rng, 0.2, 1.1));
        flipper.base.center + along
            - DVec2::new(between(&mut self.rng, -0.03, 0.03), between(&mut self.rng, 0.02, 0.09))
    }
}

/// The flippers that buttons move.
fn flippers(layout: &Layout) -> impl Iterator<Item = &Flipper> + Clone {
    layout.parts.iter().filter_map(|part| match &part.kind {
        Kind::Flipper(flipper) if flipper.control != FlipperControl::Rules => Some(flipper),
        _ => None,
    })
}

/// The open field above the flippers.
fn middle(layout: &Layout) -> DVec2 {
    let count = flippers(layout).count().max(1) as f64;
    let pivots = flippers(layout).map(|flipper| flipper.base.center).sum::<DVec2>() / count;
    pivots - DVec2::new(0.0, 0.25 * layout.size_m.y)
}

/// Evenly in [`low`, `high`).
fn between(rng: &mut BotRng, low: f64, high: f64) -> f64 {
    low + (high - low) * rng.unit()
}
