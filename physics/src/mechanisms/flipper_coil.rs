//! Flipper coil: its torque follows a goal with a time constant, so over a step it decays by an exponential.

use crate::TICK_S;

/// Time constant of the coil's rise: inductance over resistance, and the eddy currents of the iron.
const COIL_RISE_S: f64 = 0.0085;
/// Time constant of the fall from the full coil to the hold winding alone.
const COIL_HOLD_S: f64 = 0.020;
/// Time constant of the coil's decay through its diode.
const COIL_FALL_S: f64 = 0.003;

/// A substep is no longer than this, and a step of the balls has two at least.
const MAX_SUBSTEP_S: f64 = TICK_S / 64.0;

/// Where the coil's torque goes: to nothing, to its most, or to what the hold winding alone gives.
#[derive(Clone, Copy, Debug)]
pub(crate) enum CoilGoal {
    Nothing,
    Most,
    Hold,
}

/// How the coil's torque decays in a step of this duration.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CoilStep {
    /// Of the step, s.
    pub duration: f64,
    /// Of a substep, s.
    pub substep: f64,
    pub substeps: u32,
    /// Part of the torque's distance from its goal that is left after the step, in the order of [`CoilGoal`]...
    decay: [f64; 3],
    /// ... and after half a substep.
    half_decay: [f64; 3],
}

impl CoilStep {
    pub fn new(duration: f64) -> CoilStep {
        let count = (duration / MAX_SUBSTEP_S).ceil().max(2.0);
        let decay = |time: f64| [COIL_FALL_S, COIL_RISE_S, COIL_HOLD_S].map(|constant| libm::exp(-time / constant));
        CoilStep {
            duration,
            substep: duration / count,
            substeps: count as u32,
            decay: decay(duration),
            half_decay: decay(0.5 * duration / count),
        }
    }

    /// Part of the torque's distance from `goal` that is left after the step.
    #[inline(always)]
    pub fn decay(&self, goal: CoilGoal) -> f64 {
        self.decay[goal as usize]
    }

    /// Part of the torque's distance from `goal` that is left after half a substep.
    #[inline(always)]
    pub fn half_decay(&self, goal: CoilGoal) -> f64 {
        self.half_decay[goal as usize]
    }
}
