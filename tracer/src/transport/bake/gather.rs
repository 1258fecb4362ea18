//! The gather: what a point gets from the walls that it sees, for all lamps at once.
//!
//! A matt wall that sends out M for each millimetre has the radiance M / 2 in every direction, so the fluence is the integral of
//! M / 2 over all directions. Rays are cast in even directions; between two that meet one side of one wall the wall is taken to
//! go on, and its M is the mean over the pieces between. Where they meet different walls, the angle is halved a few times.

use super::walls::{WallPoint, Walls};
use super::way_basis::WayBasis;
use crate::transport::{StartsOn, Surfaces};
use geometry::{DVec2, Ray, trig};
use std::f64::consts::TAU;

/// Directions to begin with.
const DIRECTIONS: usize = 128;

/// How often an angle is halved.
const HALVINGS: u32 = 4;

/// What the walls send out under each lamp.
pub(super) struct WallLight<'a> {
    pub(super) surfaces: &'a Surfaces,
    pub(super) walls: &'a Walls,
    pub(super) ways: Vec<WayBasis>,
    /// By pieces, ways, channels, lamps: power for each millimetre.
    pub(super) sent: Vec<f32>,
}

/// The light at a point in the making.
struct Sum<'a, 'b> {
    light: &'a WallLight<'b>,
    at: DVec2,
    /// By channels, lamps.
    sum: Vec<f32>,
    /// By ways, lamps: what light weighs that comes from the distance at hand.
    weights: Vec<f32>,
}

/// Where a ray ends on a matt wall.
#[derive(Clone, Copy)]
struct Met {
    point: WallPoint,
    distance: f64,
}

impl WallLight<'_> {
    pub(super) fn lamps(&self) -> usize {
        self.ways.len()
    }

    pub(super) fn most_ways(&self) -> usize {
        self.ways.iter().map(WayBasis::count).max().unwrap_or(1)
    }

    /// The fluence at a point by channels and lamps; `turn` (0 to 1) turns the directions.
    pub(super) fn gather(&self, at: DVec2, turn: f64) -> Vec<f32> {
        let weights = vec![0.0; self.most_ways() * self.lamps()];
        let mut sum = Sum { light: self, at, sum: vec![0.0; 3 * self.lamps()], weights };
        let angle = |number: usize| TAU * (number as f64 + turn) / DIRECTIONS as f64;
        let first = sum.cast(angle(0));
        let mut before = first;
        for number in 1..=DIRECTIONS {
            let next = if number == DIRECTIONS { first } else { sum.cast(angle(number)) };
            sum.between([angle(number - 1), angle(number)], [before, next], HALVINGS);
            before = next;
        }
        sum.sum
    }
}

impl Sum<'_, '_> {
    fn cast(&self, angle: f64) -> Option<Met> {
        let ray = Ray { origin: self.at, direction: trig::direction(angle) };
        let contacts = self.light.surfaces.meet(&ray, &StartsOn::NOTHING)?;
        let point = self.light.walls.met(self.light.surfaces, &contacts)?;
        Some(Met { point, distance: contacts.first().distance })
    }

    fn between(&mut self, [from, to]: [f64; 2], ends: [Option<Met>; 2], halvings: u32) {
        let angle = to - from;
        match ends {
            [None, None] => {}
            [Some(a), Some(b)] if a.point.is_with(&b.point) => self.add(&a, &b, angle),
            _ if halvings == 0 => ends.into_iter().flatten().for_each(|met| self.add(&met, &met, 0.5 * angle)),
            [a, b] => {
                let middle = 0.5 * (from + to);
                let met = self.cast(middle);
                self.between([from, middle], [a, met], halvings - 1);
                self.between([middle, to], [met, b], halvings - 1);
            }
        }
    }

    /// Adds the light of a wall between two places that are seen in this angle.
    fn add(&mut self, a: &Met, b: &Met, angle: f64) {
        let lamps = self.light.lamps();
        let distance = 0.5 * (a.distance + b.distance);
        for (number, weights) in self.weights.chunks_exact_mut(lamps).enumerate() {
            for (weight, ways) in weights.iter_mut().zip(&self.light.ways) {
                *weight = (0.5 * angle * ways.weight(number, distance)) as f32;
            }
        }
        let (sent, sum) = (&self.light.sent, &mut self.sum);
        let row = self.weights.len() * 3;
        self.light.walls.between(&a.point, &b.point, |piece, part| {
            let part = part as f32;
            let of_ways = sent[piece * row..(piece + 1) * row].chunks_exact(3 * lamps);
            for (channels, weights) in of_ways.zip(self.weights.chunks_exact(lamps)) {
                for (sums, sent) in sum.chunks_exact_mut(lamps).zip(channels.chunks_exact(lamps)) {
                    let all = sums.iter_mut().zip(sent).zip(weights);
                    all.for_each(|((sum, sent), weight)| *sum += part * weight * sent);
                }
            }
        });
    }
}
