//! The gather: what a point gets from the walls that it sees, for all lamps at once.
//!
//! A matt wall that sends out M for each millimetre has the radiance M / 2 in every direction, so the fluence is the integral of
//! M / 2 over all directions. Rays are cast in even directions; between two that meet one side of one wall the wall is taken to
//! go on, and its M is the mean over the pieces between. Where they meet different walls, the angle is halved a few times.

use super::walls::{WallPoint, Walls};
use super::way_basis::{WAYS, WayBasis, WayWeights};
use crate::transport::{Falloff, LightSource, StartsOn, Surfaces};
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
    /// One for each falloff that there is.
    falloffs: Vec<WayWeights>,
    /// By lamps: which.
    falloff_of: Vec<usize>,
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

/// A ray, and what it meets.
#[derive(Clone, Copy)]
struct Cast {
    direction: DVec2,
    met: Option<Met>,
}

/// Where a ray ends on a matt wall.
#[derive(Clone, Copy)]
struct Met {
    point: WallPoint,
    distance: f64,
}

impl<'a> WallLight<'a> {
    /// Dark walls.
    pub(super) fn new(surfaces: &'a Surfaces, walls: &'a Walls, sources: &[LightSource]) -> WallLight<'a> {
        let mut known: Vec<Falloff> = Vec::new();
        let number = |source: &LightSource| {
            known.iter().position(|falloff| *falloff == source.falloff).unwrap_or_else(|| {
                known.push(source.falloff);
                known.len() - 1
            })
        };
        let falloff_of = sources.iter().map(number).collect();
        let falloffs = known.iter().map(|falloff| WayWeights::new(&WayBasis::new(*falloff))).collect();
        let ways = sources.iter().map(|source| WayBasis::new(source.falloff)).collect();
        let mut light = WallLight { surfaces, walls, ways, falloffs, falloff_of, sent: Vec::new() };
        light.sent = vec![0.0; walls.pieces() * light.most_ways() * 3 * light.lamps()];
        light
    }

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
        let step = trig::direction(TAU / DIRECTIONS as f64);
        let first = sum.cast(trig::direction(TAU * turn / DIRECTIONS as f64));
        let mut before = first;
        for number in 1..=DIRECTIONS {
            let next = if number == DIRECTIONS { first } else { sum.cast(step.rotate(before.direction).normalize()) };
            sum.between(TAU / DIRECTIONS as f64, [before, next], HALVINGS);
            before = next;
        }
        sum.sum
    }
}

impl Sum<'_, '_> {
    fn cast(&self, direction: DVec2) -> Cast {
        let ray = Ray { origin: self.at, direction };
        let met = self.light.surfaces.meet(&ray, &StartsOn::NOTHING).and_then(|contacts| {
            let point = self.light.walls.met(self.light.surfaces, &contacts)?;
            Some(Met { point, distance: contacts.first().distance })
        });
        Cast { direction, met }
    }

    fn between(&mut self, angle: f64, ends: [Cast; 2], halvings: u32) {
        match ends.map(|end| end.met) {
            [None, None] => {}
            [Some(a), Some(b)] if a.point.is_with(&b.point) => self.add(&a, &b, angle),
            met if halvings == 0 => met.into_iter().flatten().for_each(|met| self.add(&met, &met, 0.5 * angle)),
            _ => {
                let middle = self.cast((ends[0].direction + ends[1].direction).normalize());
                self.between(0.5 * angle, [ends[0], middle], halvings - 1);
                self.between(0.5 * angle, [middle, ends[1]], halvings - 1);
            }
        }
    }

    /// Adds the light of a wall between two places that are seen in this angle.
    fn add(&mut self, a: &Met, b: &Met, angle: f64) {
        let lamps = self.light.lamps();
        let distance = 0.5 * (a.distance + b.distance);
        for (falloff, table) in self.light.falloffs.iter().enumerate() {
            let of_ways: [f32; WAYS] = table.at(distance);
            let own = self.light.falloff_of.iter().enumerate().filter(|(_, of)| **of == falloff);
            for (lamp, _) in own {
                let column = self.weights[lamp..].iter_mut().step_by(lamps);
                column.zip(of_ways).for_each(|(weight, of_way)| *weight = 0.5 * angle as f32 * of_way);
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
