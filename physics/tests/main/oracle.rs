//! What a ball does by itself, in steps of a few microseconds: the judge of where and when it hits.
//!
//! Only the laws are the machine's: gravity down the slope, Coulomb friction of the playfield while the ball slides,
//! rolling resistance, the drag of the patch that it rests on. All of it is written anew, and slowly.

use geometry::DVec2;
use glam::DVec3;
use physics::{BALL_RADIUS_M, Layout};

/// Rolling resistance over the force that presses the ball down.
const ROLLING_RESISTANCE: f64 = 2e-4;
/// Radius of the patch that the ball rests on.
const PATCH_M: f64 = 3e-4;
/// Nothing closes in faster than this, m/s: a ball at 15 and a flipper's tip.
const FASTEST_M_S: f64 = 25.0;

/// A ball at a moment.
#[derive(Clone, Copy, Debug)]
pub struct State {
    pub center: DVec2,
    pub velocity: DVec2,
    /// As in [`physics::BallPose::spin`].
    pub spin: DVec3,
}

/// The playfield under it.
#[derive(Clone, Copy, Debug)]
pub struct Field {
    pull: f64,
    press: f64,
    friction: f64,
}

/// A ball's way, step after step.
pub struct Path {
    step_s: f64,
    /// The state at each step's start, and the acceleration in it.
    states: Vec<(State, DVec2)>,
}

impl Field {
    pub fn of(layout: &Layout) -> Field {
        let gravity = 9.81;
        Field {
            pull: gravity * libm::sin(layout.slope_rad),
            press: gravity * libm::cos(layout.slope_rad),
            friction: layout.playfield_friction,
        }
    }

    /// The playfield's friction on the ball over its mass: against its slip, or what keeps it rolling.
    fn grip(&self, state: &State, step: f64) -> DVec2 {
        let slip = state.velocity + BALL_RADIUS_M * DVec2::new(-state.spin.y, state.spin.x);
        let most = self.friction * self.press;
        // What would end the slip within the step: a push of 1 changes it by 1 + 1 / 0.4.
        let ends = -(slip / step + DVec2::new(0.0, self.pull)) / 3.5;
        if ends.length() <= most { ends } else { -slip / slip.length() * most }
    }

    /// Accelerations of the centre and of the spin.
    fn forces(&self, state: &State, step: f64) -> (DVec2, DVec3) {
        let grip = self.grip(state, step);
        let speed = state.velocity.length().max(1e-12);
        let resistance = ROLLING_RESISTANCE * self.press / speed;
        let turn = DVec3::new(grip.y, -grip.x, 0.0) / (0.4 * BALL_RADIUS_M);
        let rolling = DVec3::new(state.spin.x, state.spin.y, 0.0) * resistance;
        let drag = 2.0 / 3.0 * self.friction * self.press * PATCH_M / (0.4 * BALL_RADIUS_M * BALL_RADIUS_M);
        let pivot = drag.min(state.spin.z.abs() / step).copysign(state.spin.z);
        let pull = DVec2::new(0.0, self.pull);
        (pull + grip - state.velocity * resistance, turn - rolling - DVec3::new(0.0, 0.0, pivot))
    }
}

impl State {
    fn after(&self, time: f64, push: DVec2, turn: DVec3) -> State {
        State {
            center: self.center + self.velocity * time + push * (0.5 * time * time),
            velocity: self.velocity + push * time,
            spin: self.spin + turn * time,
        }
    }
}

impl Path {
    /// The way from `start` for `duration`, by the midpoint rule.
    pub fn new(field: &Field, start: State, duration: f64, step_s: f64) -> Path {
        let mut states = Vec::new();
        let mut state = start;
        for _ in 0..=(duration / step_s).ceil() as usize {
            let (push, turn) = field.forces(&state, step_s);
            let middle = state.after(0.5 * step_s, push, turn);
            let sliding = field.friction * field.press - field.grip(&state, step_s).length() < 1e-12;
            let (push, turn) = if sliding { field.forces(&middle, step_s) } else { (push, turn) };
            states.push((state, push));
            state = state.after(step_s, push, turn);
        }
        Path { step_s, states }
    }

    /// The ball at `time`. Its spin is that of the step's start.
    pub fn at(&self, time: f64) -> State {
        let step = ((time / self.step_s) as usize).min(self.states.len() - 1);
        let (state, push) = self.states[step];
        state.after(time - step as f64 * self.step_s, push, DVec3::ZERO)
    }

    /// When `gap`, of a time and the ball's centre then, first is 0: to a picosecond.
    pub fn hit(&self, gap: impl Fn(f64, DVec2) -> f64) -> Option<f64> {
        let open = |time: f64| gap(time, self.at(time).center);
        let end = (self.states.len() - 1) as f64 * self.step_s;
        let mut before = 0.0;
        while before < end {
            let wide = open(before);
            let after = before + self.step_s.max(0.9 * wide / FASTEST_M_S);
            if after <= end && open(after) <= 0.0 {
                return Some(root(open, before, after));
            }
            before = after;
        }
        None
    }
}

/// Where `open` falls through 0 between `before` and `after`.
fn root(open: impl Fn(f64) -> f64, mut before: f64, mut after: f64) -> f64 {
    while after - before > 1e-12 {
        let middle = 0.5 * (before + after);
        if open(middle) > 0.0 {
            before = middle;
        } else {
            after = middle;
        }
    }
    before
}
