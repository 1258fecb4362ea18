//! How the left flipper turns when no ball is near, between the ticks as well.

use crate::distances::Outline;
use crate::fixture::*;
use geometry::DVec2;
use physics::*;

/// A flipper's stroke as it is without a ball: its angle at each tick's end, and the tick at which time begins.
pub struct Stroke {
    angles: Vec<f64>,
    pub from: usize,
}

impl Stroke {
    pub fn of(machine: &Machine, controls: Controls) -> Stroke {
        let mut machine = machine.clone();
        let angle = |machine: &Machine| machine.pose().flippers_rad[0].1;
        let mut angles = vec![angle(&machine)];
        for _ in 0..140 {
            machine.tick(controls, &[]);
            angles.push(angle(&machine));
        }
        Stroke { angles, from: 0 }
    }

    /// The angle at `time`, by the polynomial through the `nodes` ticks around it.
    fn polynomial(&self, time: f64, nodes: usize) -> f64 {
        let tick = time / TICK_S + self.from as f64;
        let first = (tick as usize + 1).saturating_sub(nodes / 2);
        let term = |node: usize| {
            let others = (first..first + nodes).filter(|&other| other != node);
            others.fold(self.angles[node], |term, other| term * (tick - other as f64) / (node as f64 - other as f64))
        };
        (first..first + nodes).map(term).sum()
    }

    pub fn at(&self, time: f64) -> f64 {
        self.polynomial(time, 6)
    }

    pub fn turn(&self, time: f64) -> f64 {
        let step = 1e-6;
        (self.at(time + step) - self.at(time - step)) / (2.0 * step)
    }

    /// Whether the flipper moves so evenly that the ticks tell where it is between them: it has left one stop and not
    /// yet come to the other, where the least difference in speed makes another bounce.
    pub fn is_smooth(&self, time: f64) -> bool {
        let tick = (time / TICK_S) as usize + self.from;
        let Flipper { rest_rad, up_rad, .. } = numbers();
        let free = |&angle: &f64| angle > up_rad + 1e-3 && angle < rest_rad - 1e-6;
        let Some(left) = self.angles.iter().position(free) else { return false };
        let is_even = (self.polynomial(time, 6) - self.polynomial(time, 4)).abs() < 3e-6;
        tick >= left + 2 && self.angles[left..tick + 5].iter().all(free) && is_even
    }
}

/// The numbers of the fixture's left flipper.
pub fn numbers() -> Flipper {
    let Kind::Flipper(numbers) = flipper(true).kind else { unreachable!("it is a flipper") };
    numbers
}

pub fn outline_at(angle: f64) -> Outline {
    let Flipper { base, length_m, tip_radius_m, .. } = numbers();
    let tip = base.center + length_m * DVec2::new(libm::cos(angle), libm::sin(angle));
    Outline::Hull { a: base.center, a_radius: base.radius, b: tip, b_radius: tip_radius_m }
}
