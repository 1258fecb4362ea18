//! Ramp path: the centre line of a ramp or a wire-form: where its floor is, how high, and what stands beside it.
//!
//! Refuses to know which ball is on it.

use crate::BALL_RADIUS_M;
use crate::collision::obstacle::{Obstacle, ObstacleRole};
use crate::mechanisms::ramp::Ramp;
use crate::mechanisms::ramp_leg::Leg;
use crate::part::PartId;
use crate::part::material::Material;
use geometry::{DVec2, Shape};

/// Half the thickness of the sides.
const SIDE_M: f64 = 0.001;
/// Below a floor that is this high a ball passes, m.
const PASSAGE_M: f64 = 2.0 * BALL_RADIUS_M + 0.002;
/// An end no higher than this opens on the playfield.
const FLUSH_M: f64 = 0.001;
/// How much longer than deep a funnel is.
const FUNNEL_SLENDERNESS: f64 = 5.0;
/// How far the sides go on beyond a joint, m: what the fastest ball goes in a tick.
const OVERLAP_M: f64 = 0.016;
/// How long the straight end of a funnel is, m.
const FUNNEL_STRAIGHT_M: f64 = 0.005;
/// Ends that are no farther apart than this, and no more different in height, are joined.
const JOINT_M: f64 = 0.005;

#[derive(Clone, Debug)]
pub(crate) struct RampPath {
    pub part: PartId,
    legs: Vec<Leg>,
    /// Arc length at the start of each leg, and at the end of the last, m.
    marks: Vec<f64>,
    /// Height of the floor at each mark, m.
    heights: Vec<f64>,
    half_width: f64,
    /// The start and the end: kept, because they are asked for in every tick, and an arc's ends cost trigonometry.
    entrances: [Entrance; 2],
    material: Material,
    /// The ramps that its start and its end are joined to.
    pub joined: [Option<u16>; 2],
}

/// Path sample: the floor below a place.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PathSample {
    /// Height of the floor below it, m.
    pub height: f64,
    /// How the floor rises along the path, m/m.
    pub slope: f64,
    /// The unit vector of the path there.
    pub direction: DVec2,
    /// Lateral distance from the path, m.
    pub lateral: f64,
}

/// Entrance: one end of a ramp.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Entrance {
    pub middle: DVec2,
    /// The unit vector out of the ramp.
    pub out: DVec2,
    pub height: f64,
}

impl RampPath {
    pub fn new(part: PartId, ramp: &Ramp) -> RampPath {
        let mut marks = vec![0.0];
        ramp.path.iter().for_each(|leg| marks.push(marks[marks.len() - 1] + leg.length()));
        RampPath {
            part,
            legs: ramp.path.clone(),
            marks,
            heights: ramp.heights_m.clone(),
            half_width: ramp.half_width_m,
            entrances: entrances_of(&ramp.path, &ramp.heights_m),
            material: ramp.material,
            joined: [None; 2],
        }
    }

    /// The floor below `point`: that of the nearest place of the path.
    ///
    /// Between two heights the floor bends out of the level and back into it, `3 u^2 - 2 u^3`, so that it has no edges.
    pub fn sample(&self, point: DVec2) -> PathSample {
        let (mut best, mut lateral) = ((0, 0.0), f64::INFINITY);
        for (index, leg) in self.legs.iter().enumerate() {
            let (along, nearest) = leg.closest(point);
            let distance = nearest.distance(point);
            if distance < lateral {
                (best, lateral) = ((index, along), distance);
            }
        }
        let (index, along) = best;
        let length = self.marks[index + 1] - self.marks[index];
        let (low, rise) = (self.heights[index], self.heights[index + 1] - self.heights[index]);
        let part = along / length;
        PathSample {
            height: low + rise * part * part * (3.0 - 2.0 * part),
            slope: rise * 6.0 * part * (1.0 - part) / length,
            direction: self.legs[index].direction_at(along),
            lateral,
        }
    }

    /// Its two ends: the start and the end.
    pub fn entrances(&self) -> &[Entrance; 2] {
        &self.entrances
    }

    /// Whether a ball that goes from `from` to `to` on the playfield rolls in through one of its ends.
    pub fn is_entered(&self, from: DVec2, to: DVec2) -> bool {
        self.entrances().iter().filter(|entrance| entrance.height <= FLUSH_M).any(|entrance| {
            let beyond = |point: DVec2| (point - entrance.middle).dot(entrance.out);
            let lateral = (to - entrance.middle).dot(entrance.out.perp()).abs();
            beyond(from) >= 0.0 && beyond(to) < 0.0 && lateral < self.half_width
        })
    }

    /// Whether a ball at this lateral distance has come out over the side.
    pub fn is_over_side(&self, lateral: f64) -> bool {
        lateral > self.half_width + BALL_RADIUS_M
    }

    /// Its sides where balls meet them: above, those that keep a ball on it.
    pub fn sides(&self) -> impl Iterator<Item = Obstacle> {
        self.legs.iter().flat_map(|leg| self.beside(leg)).map(|shape| self.obstacle(shape))
    }

    /// Its sides a little beyond its joints: a ball is on it until the end of the tick in which it goes over.
    pub fn overlaps<'a>(&'a self, ramps: &'a [RampPath]) -> impl Iterator<Item = Obstacle> + 'a {
        let ends = self
            .joined
            .iter()
            .zip(self.entrances())
            .filter_map(|(other, entrance)| other.map(|other| (other, entrance)));
        let shapes = ends.flat_map(|(other, entrance)| {
            let half = self.half_width.min(ramps[usize::from(other)].half_width) + SIDE_M;
            [-half, half].map(|half| {
                let from = entrance.middle + entrance.out.perp() * half;
                Shape::capsule(from, from + entrance.out * OVERLAP_M, SIDE_M)
            })
        });
        shapes.map(|shape| self.obstacle(shape))
    }

    /// Funnels: where it goes on in a narrower ramp its sides come together before the joint.
    pub fn funnels<'a>(&'a self, ramps: &'a [RampPath]) -> impl Iterator<Item = Obstacle> + 'a {
        let ends = self.joined.iter().enumerate().filter_map(|(end, other)| other.map(|other| (end, other)));
        let narrower = ends.map(|(end, other)| (end, ramps[usize::from(other)].half_width));
        let funnels = narrower.filter(|&(_, half)| half < self.half_width).flat_map(|(end, half)| {
            let leg = &self.legs[if end == 0 { 0 } else { self.legs.len() - 1 }];
            let length = leg.length();
            let back = (FUNNEL_SLENDERNESS * (self.half_width - half)).min(length);
            // It ends before the joint, so that a ball that leaves it is in the middle when it gets there.
            let (wide, narrow, joint) = match end {
                0 => (back, FUNNEL_STRAIGHT_M.min(back), 0.0),
                _ => (length - back, length - FUNNEL_STRAIGHT_M.min(back), length),
            };
            let side = |along: f64, half: f64| leg.at(along) + leg.direction_at(along).perp() * half;
            let (wider, narrower) = (self.half_width + SIDE_M, half + SIDE_M);
            let shapes = [-1.0, 1.0].map(|sign| {
                let a = side(wide, sign * wider);
                let (b, c) = (side(narrow, sign * narrower), side(joint, sign * narrower));
                [Shape::capsule(a, b, SIDE_M), Shape::capsule(b, c, SIDE_M)]
            });
            shapes.into_iter().flatten()
        });
        funnels.map(|shape| self.obstacle(shape))
    }

    /// What a ball on the playfield meets of it: its sides where its floor is low, and the ends of the room below it.
    pub fn underside(&self) -> impl Iterator<Item = Obstacle> {
        let low = self.legs.iter().enumerate().flat_map(|(index, leg)| {
            let (from, to) = (self.heights[index] - PASSAGE_M, self.heights[index + 1] - PASSAGE_M);
            let cut = leg.length() * crossing(from, to);
            let (part, wall) = match (from < 0.0, to < 0.0) {
                (true, true) => (Some(leg.piece(0.0, leg.length())), None),
                (true, false) => (Some(leg.piece(0.0, cut)), Some(cut)),
                (false, true) => (Some(leg.piece(cut, leg.length())), Some(cut)),
                (false, false) => (None, None),
            };
            let across = wall.map(|along| {
                let (middle, half) = (leg.at(along), leg.direction_at(along).perp() * (self.half_width + SIDE_M));
                Shape::capsule(middle - half, middle + half, SIDE_M)
            });
            let sides: Vec<Shape> = part.iter().flat_map(|leg| self.beside(leg)).collect();
            sides.into_iter().chain(across)
        });
        low.map(|shape| self.obstacle(shape))
    }

    fn beside(&self, leg: &Leg) -> [Shape; 2] {
        let offset = self.half_width + SIDE_M;
        [-offset, offset].map(|offset| Shape { core: leg.offset(offset), radius: SIDE_M })
    }

    fn obstacle(&self, shape: Shape) -> Obstacle {
        Obstacle::new(self.part, shape, self.material, ObstacleRole::Static)
    }

    /// Joins the ends of ramps that lie on each other.
    pub fn join(ramps: &mut [RampPath]) {
        let entrances: Vec<[Entrance; 2]> = ramps.iter().map(|ramp| ramp.entrances).collect();
        for (index, ramp) in ramps.iter_mut().enumerate() {
            for end in 0..2 {
                let own = entrances[index][end];
                let near = |entrance: &Entrance| {
                    entrance.middle.distance(own.middle) < JOINT_M
                        && (entrance.height - own.height).abs() < JOINT_M
                        && entrance.out.dot(own.out) < 0.0
                };
                let other =
                    entrances.iter().enumerate().position(|(other, ends)| other != index && ends.iter().any(near));
                ramp.joined[end] = other.map(|other| other as u16);
            }
        }
    }
}

/// The start and the end of a path whose floor has these heights at its marks.
fn entrances_of(legs: &[Leg], heights: &[f64]) -> [Entrance; 2] {
    let (first, last) = (&legs[0], &legs[legs.len() - 1]);
    let end = last.length();
    [
        Entrance { middle: first.at(0.0), out: -first.direction_at(0.0), height: heights[0] },
        Entrance { middle: last.at(end), out: last.direction_at(end), height: heights[heights.len() - 1] },
    ]
}

/// Where on its rise from `from` to `to`, one of them below 0, the floor goes through 0: 0 to 1.
fn crossing(from: f64, to: f64) -> f64 {
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..50 {
        let part: f64 = 0.5 * (low + high);
        let height = from + (to - from) * part * part * (3.0 - 2.0 * part);
        if (height < 0.0) == (from < 0.0) { low = part } else { high = part }
    }
    low
}
