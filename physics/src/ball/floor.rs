//! Floor contact: what the surface that carries a ball does to it.

use crate::ball::SPHERE_INERTIA;

/// The floor below a ball: the playfield, or the floor of a ramp.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Floor {
    /// Gravity's part down the slope, m/s^2.
    pub slope_gravity: f64,
    /// Normal load: what presses the ball on the floor, over its mass, m/s^2.
    pub normal_load: f64,
    /// Coefficient of friction.
    pub friction: f64,
    /// Deceleration of a ball that rolls, beside its rolling resistance, m/s^2.
    pub drag: f64,
}

impl Floor {
    /// How fast friction takes the slip of a sliding ball, m/s^2.
    ///
    /// Friction `mu N` slows the centre by `mu N / m` and turns the ball, whose lowest point so loses `mu N r^2 / I`
    /// more: `mu N / m (1 + m r^2 / I)`, 7/2 of the friction for a solid sphere (Routh, Dynamics of a System of Rigid
    /// Bodies, 1905: sphere on a rough plane).
    pub fn slip_deceleration(&self) -> f64 {
        self.friction * self.normal_load * (1.0 + SPHERE_INERTIA) / SPHERE_INERTIA
    }
}
