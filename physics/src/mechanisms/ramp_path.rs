//! The way of a ramp or a wire-form: where its floor is, how high, and what stands beside it.
//!
//! Refuses to know which ball is on it.

use crate::BALL_RADIUS_M;
use crate::collision::world::{Obstacle, Role};
use crate::layout::{Leg, Ramp};
use geometry::{Arc, Core, DVec2, Segment, Shape, trig};

/// Half the thickness of the sides.
const SIDE_M: f64 = 0.001;
/// Below a floor that is this high a ball passes.
const CLEAR_M: f64 = 2.0 * BALL_RADIUS_M + 0.002;
/// An end no higher than this opens on the playfield.
const FLUSH_M: f64 = 0.001;
/// How much longer than deep a funnel is.
const FUNNEL: f64 = 5.0;
/// How far its sides go on beyond a joint: what the fastest ball goes in a tick.
const OVERLAP_M: f64 = 0.016;
/// How long the straight end of a funnel is.
const STRAIGHT_M: f64 = 0.005;
/// Ends that are no farther apart than this, and no more different in height, are joined.
const JOINT_M: f64 = 0.005;

#[derive(Clone, Debug)]
pub(crate) struct Track {
    pub part: u16,
    legs: Vec<Leg>,
    /// Arc length at the start of each leg, and at the end of the last, m.
    marks: Vec<f64>,
    /// Height of the floor at each mark, m.
    heights: Vec<f64>,
    half_width: f64,
    /// Kept, because they are asked for in every tick, and an arc's ends cost trigonometry.
    mouths: [Mouth; 2],
    /// Its sides among the plan's obstacles.
    pub sides: std::ops::Range<usize>,
    /// The tracks that its start and its end are joined to.
    pub joined: [Option<u16>; 2],
}

/// Where a ball is on a track.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Spot {
    /// Height of the floor below it, m.
    pub height: f64,
    /// How the floor rises along the way, m/m.
    pub slope: f64,
    /// The unit vector of the way there.
    pub direction: DVec2,
    /// From the middle of the floor, m.
    pub aside: f64,
}

/// One end of a track.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Mouth {
    pub middle: DVec2,
    /// The unit vector out of the track.
    pub out: DVec2,
    pub height: f64,
}

impl Track {
    pub fn new(part: u16, ramp: &Ramp) -> Track {
        let mut marks = vec![0.0];
        ramp.path.iter().for_each(|leg| marks.push(marks[marks.len() - 1] + leg.length()));
        Track {
            part,
            legs: ramp.path.clone(),
            marks,
            heights: ramp.heights_m.clone(),
            half_width: ramp.half_width_m,
            mouths: mouths(&ramp.path, &ramp.heights_m),
            sides: 0..0,
            joined: [None; 2],
        }
    }

    /// The floor below `point`: that of the nearest place of the way.
    ///
    /// Between two heights the floor bends out of the level and back into it, `3 u^2 - 2 u^3`, so that it has no edges.
    pub fn spot(&self, point: DVec2) -> Spot {
        let (mut best, mut aside) = ((0, 0.0), f64::INFINITY);
        for (index, leg) in self.legs.iter().enumerate() {
            let (along, nearest) = leg.nearest(point);
            let distance = nearest.distance(point);
            if distance < aside {
                (best, aside) = ((index, along), distance);
            }
        }
        let (index, along) = best;
        let length = self.marks[index + 1] - self.marks[index];
        let (low, rise) = (self.heights[index], self.heights[index + 1] - self.heights[index]);
        let part = along / length;
        Spot {
            height: low + rise * part * part * (3.0 - 2.0 * part),
            slope: rise * 6.0 * part * (1.0 - part) / length,
            direction: self.legs[index].direction_at(along),
            aside,
        }
    }

    /// Its two ends: the start and the end.
    pub fn mouths(&self) -> &[Mouth; 2] {
        &self.mouths
    }

    /// Whether a ball that goes from `from` to `to` on the playfield rolls in through one of its ends.
    pub fn is_entered(&self, from: DVec2, to: DVec2) -> bool {
        self.mouths().iter().filter(|mouth| mouth.height <= FLUSH_M).any(|mouth| {
            let beyond = |point: DVec2| (point - mouth.middle).dot(mouth.out);
            let aside = (to - mouth.middle).dot(mouth.out.perp()).abs();
            beyond(from) >= 0.0 && beyond(to) < 0.0 && aside < self.half_width
        })
    }

    /// Whether a ball so far aside has come out over the side.
    pub fn is_over_side(&self, aside: f64) -> bool {
        aside > self.half_width + BALL_RADIUS_M
    }

    /// Its sides where balls meet them: above, those that keep a ball on it.
    pub fn sides<'a>(&'a self, ramp: &'a Ramp) -> impl Iterator<Item = Obstacle> + 'a {
        self.legs.iter().flat_map(|leg| self.beside(leg)).map(|shape| self.obstacle(ramp, shape))
    }

    /// Its sides a little way beyond its joints: a ball is on it until the end of the tick in which it goes over.
    pub fn overlaps<'a>(&'a self, ramp: &'a Ramp, tracks: &'a [Track]) -> impl Iterator<Item = Obstacle> + 'a {
        let ends = self.joined.iter().zip(self.mouths()).filter_map(|(other, mouth)| other.map(|other| (other, mouth)));
        let shapes = ends.flat_map(|(other, mouth)| {
            let half = self.half_width.min(tracks[usize::from(other)].half_width) + SIDE_M;
            [-half, half].map(|half| {
                let from = mouth.middle + mouth.out.perp() * half;
                Shape::capsule(from, from + mouth.out * OVERLAP_M, SIDE_M)
            })
        });
        shapes.map(|shape| self.obstacle(ramp, shape))
    }

    /// Where it goes on in a narrower one its sides come together before the joint.
    pub fn funnels<'a>(&'a self, ramp: &'a Ramp, tracks: &'a [Track]) -> impl Iterator<Item = Obstacle> + 'a {
        let ends = self.joined.iter().enumerate().filter_map(|(end, other)| other.map(|other| (end, other)));
        let narrower = ends.map(|(end, other)| (end, tracks[usize::from(other)].half_width));
        let funnels = narrower.filter(|&(_, half)| half < self.half_width).flat_map(|(end, half)| {
            let leg = &self.legs[if end == 0 { 0 } else { self.legs.len() - 1 }];
            let length = leg.length();
            let back = (FUNNEL * (self.half_width - half)).min(length);
            // It ends before the joint, so that a ball that leaves it is in the middle when it gets there.
            let (wide, narrow, joint) = match end {
                0 => (back, STRAIGHT_M.min(back), 0.0),
                _ => (length - back, length - STRAIGHT_M.min(back), length),
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
        funnels.map(|shape| self.obstacle(ramp, shape))
    }

    /// What a ball on the playfield meets of it: its sides where its floor is low, and the ends of the room below it.
    pub fn underside<'a>(&'a self, ramp: &'a Ramp) -> impl Iterator<Item = Obstacle> + 'a {
        let low = self.legs.iter().enumerate().flat_map(|(index, leg)| {
            let (from, to) = (self.heights[index] - CLEAR_M, self.heights[index + 1] - CLEAR_M);
            let cut = leg.length() * crossing(from, to);
            let (part, wall) = match (from < 0.0, to < 0.0) {
                (true, true) => (Some(leg.part(0.0, leg.length())), None),
                (true, false) => (Some(leg.part(0.0, cut)), Some(cut)),
                (false, true) => (Some(leg.part(cut, leg.length())), Some(cut)),
                (false, false) => (None, None),
            };
            let across = wall.map(|along| {
                let (middle, half) = (leg.at(along), leg.direction_at(along).perp() * (self.half_width + SIDE_M));
                Shape::capsule(middle - half, middle + half, SIDE_M)
            });
            let sides: Vec<Shape> = part.iter().flat_map(|leg| self.beside(leg)).collect();
            sides.into_iter().chain(across)
        });
        low.map(|shape| self.obstacle(ramp, shape))
    }

    fn beside(&self, leg: &Leg) -> [Shape; 2] {
        let offset = self.half_width + SIDE_M;
        [-offset, offset].map(|offset| Shape { core: leg.offset(offset), radius: SIDE_M })
    }

    fn obstacle(&self, ramp: &Ramp, shape: Shape) -> Obstacle {
        Obstacle { part: self.part, shape: shape.inflated(BALL_RADIUS_M), material: ramp.material, role: Role::Still }
    }

    /// Joins the ends of tracks that lie on each other.
    pub fn join(tracks: &mut [Track]) {
        let mouths: Vec<[Mouth; 2]> = tracks.iter().map(|track| track.mouths).collect();
        for (index, track) in tracks.iter_mut().enumerate() {
            for end in 0..2 {
                let own = mouths[index][end];
                let near = |mouth: &Mouth| {
                    mouth.middle.distance(own.middle) < JOINT_M
                        && (mouth.height - own.height).abs() < JOINT_M
                        && mouth.out.dot(own.out) < 0.0
                };
                let other = mouths.iter().enumerate().position(|(other, ends)| other != index && ends.iter().any(near));
                track.joined[end] = other.map(|other| other as u16);
            }
        }
    }
}

/// The start and the end of a way whose floor has these heights at its marks.
fn mouths(legs: &[Leg], heights: &[f64]) -> [Mouth; 2] {
    let (first, last) = (&legs[0], &legs[legs.len() - 1]);
    let end = last.length();
    [
        Mouth { middle: first.at(0.0), out: -first.direction_at(0.0), height: heights[0] },
        Mouth { middle: last.at(end), out: last.direction_at(end), height: heights[heights.len() - 1] },
    ]
}

/// Where on its way from `from` to `to`, one of them below 0, the floor goes through 0: 0 to 1.
fn crossing(from: f64, to: f64) -> f64 {
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..50 {
        let part: f64 = 0.5 * (low + high);
        let height = from + (to - from) * part * part * (3.0 - 2.0 * part);
        if (height < 0.0) == (from < 0.0) { low = part } else { high = part }
    }
    low
}

impl Leg {
    /// Its length, m.
    pub fn length(&self) -> f64 {
        match self {
            Leg::Line(line) => line.length(),
            Leg::Turn { arc, .. } => 2.0 * arc.half_angle() * arc.circle().radius,
        }
    }

    /// The place `along` m from its start.
    pub fn at(&self, along: f64) -> DVec2 {
        let part = along / self.length();
        match self {
            Leg::Line(Segment { a, b }) => a.lerp(*b, part),
            Leg::Turn { arc, backwards } => arc.at(if *backwards { 1.0 - part } else { part }),
        }
    }

    /// The unit vector of the way `along` m from its start.
    pub fn direction_at(&self, along: f64) -> DVec2 {
        match self {
            Leg::Line(line) => line.along().normalize(),
            Leg::Turn { arc, backwards } => {
                let onwards = (self.at(along) - arc.circle().center).normalize().perp();
                if *backwards { -onwards } else { onwards }
            }
        }
    }

    /// The nearest place to `point`: how far along, and where.
    fn nearest(&self, point: DVec2) -> (f64, DVec2) {
        match self {
            Leg::Line(line) => (line.parameter(point) * line.length(), line.closest(point)),
            Leg::Turn { arc, backwards } => {
                let nearest = arc.closest(point);
                let from_middle = arc.middle().rotate_back(nearest - arc.circle().center);
                let turned = (trig::angle(from_middle) + arc.half_angle()).clamp(0.0, 2.0 * arc.half_angle());
                let along = turned * arc.circle().radius;
                (if *backwards { self.length() - along } else { along }, nearest)
            }
        }
    }

    /// The line that runs `offset` m beside it: over 0 on the side of `perp` of its way.
    pub fn offset(&self, offset: f64) -> Core {
        match self {
            Leg::Line(Segment { a, b }) => {
                let side = self.direction_at(0.0).perp() * offset;
                Core::Segment(Segment { a: *a + side, b: *b + side })
            }
            Leg::Turn { arc, backwards } => {
                let inwards = if *backwards { -offset } else { offset };
                Core::Arc(arc.with_radius(arc.circle().radius - inwards))
            }
        }
    }

    /// The piece of it between two lengths along.
    fn part(&self, from: f64, to: f64) -> Leg {
        match self {
            Leg::Line(_) => Leg::Line(Segment { a: self.at(from), b: self.at(to) }),
            Leg::Turn { arc, backwards } => {
                let circle = arc.circle();
                let (low, high) = if *backwards { (self.length() - to, self.length() - from) } else { (from, to) };
                let start = trig::angle(arc.middle()) - arc.half_angle() + low / circle.radius;
                Leg::Turn { arc: Arc::new(circle, start, (high - low) / circle.radius), backwards: *backwards }
            }
        }
    }
}

/// Turning back by the angle of a unit vector.
trait RotateBack {
    fn rotate_back(self, vector: DVec2) -> DVec2;
}

impl RotateBack for DVec2 {
    fn rotate_back(self, vector: DVec2) -> DVec2 {
        DVec2::new(self.dot(vector), self.perp_dot(vector))
    }
}
