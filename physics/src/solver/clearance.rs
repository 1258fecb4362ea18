//! Room round a ball: how far away everything but other balls is at least, so that nothing is asked again at every step.

use crate::ball::Ball;
use crate::collision::world::Plan;
use crate::mechanisms::state::Mechanisms;
use crate::solver::sweep::Sweep;
use crate::{BALL_RADIUS_M, TICK_S};
use geometry::DVec2;

/// How far is looked, m: a ball hardly goes farther in a tick.
const LOOK_M: f64 = 0.01;
/// Far above rounding and above what counts as touching, far below anything else, m.
const ROUNDING_M: f64 = 1e-7;

/// Where a ball was at the start of a tick, and the room that it had there.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Clear {
    center: DVec2,
    /// No obstacle is nearer to touching than this, m.
    still: f64,
    /// No rod comes nearer in the tick, and no flipper was nearer, m.
    moving: f64,
}

/// What a ball is known to be clear of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct ClearOf {
    /// All that stands still.
    pub still: bool,
    /// Rods and flippers.
    pub moving: bool,
}

impl Clear {
    /// The room round a ball, looked for up to [`LOOK_M`].
    pub fn around(plan: &Plan, own: &Mechanisms, ball: &Ball) -> Clear {
        let slides = plan.slides.iter().zip(&own.rods);
        let rods = slides.map(|(slide, rod)| slide.face(rod).distance(ball.center).0 - rod.speed.abs() * TICK_S);
        Clear {
            center: ball.center,
            still: room_of_obstacles(plan, ball, LOOK_M).min(LOOK_M),
            moving: rods.fold(LOOK_M, f64::min).min(room_of_flippers(plan, own, ball)),
        }
    }

    /// What is not within `reach` of touching a ball that is at `center` now, when no flipper has moved or will move by
    /// more than `swing`, m.
    pub fn of(&self, center: DVec2, reach: f64, swing: f64) -> ClearOf {
        let moved = center.distance_squared(self.center);
        let holds = |room: f64| room > 0.0 && moved < room * room;
        let still = self.still - reach - ROUNDING_M;
        ClearOf { still: holds(still), moving: holds(self.moving - reach - swing - ROUNDING_M) }
    }
}

/// How far the nearest obstacle is from touching a ball, if that is up to `look`.
fn room_of_obstacles(plan: &Plan, ball: &Ball, look: f64) -> f64 {
    let mut room = f64::INFINITY;
    plan.near(ball.track, ball.center - look, ball.center + look, |index| {
        room = room.min(plan.obstacles[index].shape.distance(ball.center).0);
    });
    room
}

/// How far the nearest flipper is from touching a ball; only roughly, and never too far, where that is far.
fn room_of_flippers(plan: &Plan, own: &Mechanisms, ball: &Ball) -> f64 {
    let flippers = plan.blades.iter().zip(&own.rotors).map(|(blade, rotor)| {
        let least = ball.center.distance(blade.pivot()) - blade.reach;
        let away =
            if least < LOOK_M + BALL_RADIUS_M { blade.taper(rotor.angle).distance(ball.center).0 } else { least };
        away - BALL_RADIUS_M
    });
    flippers.fold(f64::INFINITY, f64::min)
}

impl Sweep<'_> {
    /// Looks for the room round every ball, for all the steps of a tick.
    pub(crate) fn look_around(&mut self) {
        let (plan, own) = (self.plan, &self.state.mechanisms);
        self.scratch.clear.extend(self.state.balls.iter().map(|ball| Clear::around(plan, own, ball)));
        self.scratch.angles.extend(own.rotors.iter().map(|rotor| rotor.angle));
    }

    /// How far any flipper's outline has moved since the room was looked for, or will have in a further `time`, m.
    pub(crate) fn swing(&self, time: f64) -> f64 {
        let rotors = self.state.mechanisms.rotors.iter().zip(&self.scratch.angles);
        let turns = rotors.map(|(rotor, start)| (rotor.angle - start).abs() + rotor.speed.abs() * time);
        turns.zip(&self.plan.blades).map(|(turn, blade)| turn * blade.reach).fold(0.0, f64::max)
    }

    /// What a ball is known to be farther from touching than `reach`, for flippers that `swing`.
    pub(crate) fn clear_of(&self, ball: usize, reach: f64, swing: f64) -> ClearOf {
        let own = &self.state.balls[ball];
        let nothing = ClearOf { still: false, moving: false };
        let clear = self.scratch.clear.get(ball).map_or(nothing, |clear| clear.of(own.center, reach, swing));
        debug_assert!(self.is_so(own, reach, clear), "the slow twin finds something at {}", own.center);
        clear
    }

    /// The slow twin of [`Clear`]: whether everything that a ball is said to be clear of is farther than `reach`.
    fn is_so(&self, ball: &Ball, reach: f64, clear: ClearOf) -> bool {
        let (plan, own) = (self.plan, &self.state.mechanisms);
        let mut slides = plan.slides.iter().zip(&own.rods);
        let rods = slides.all(|(slide, rod)| slide.face(rod).distance(ball.center).0 > reach);
        (!clear.still || room_of_obstacles(plan, ball, reach) > reach)
            && (!clear.moving || (rods && room_of_flippers(plan, own, ball) > reach))
    }
}
