//! Material: how a surface throws the ball back and how it rubs.

use serde::{Deserialize, Serialize};

/// Restitution and friction of a surface.
///
/// The coefficient of restitution falls with the speed of the impact, `e(v) = restitution / (1 + falloff v)` at `v` m/s
/// along the normal: a faster impact loses more in the rubber's hysteresis and in the dent of wood or steel (Stronge,
/// Impact Mechanics, 2000, chapter 6; Cross, The bounce of a ball, American Journal of Physics 67, 1999).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Material {
    /// Coefficient of restitution at low speed, in [0, 1].
    pub restitution: f64,
    /// How fast the restitution falls with the speed of the impact, s/m, 0 or more.
    pub falloff_s_per_m: f64,
    /// Coefficient of Coulomb friction, 0 or more.
    pub friction: f64,
}

impl Material {
    /// Two steel balls.
    pub(crate) const BALL_ON_BALL: Material = Material { restitution: 0.9, falloff_s_per_m: 0.02, friction: 0.1 };

    /// Coefficient of restitution of an impact at `speed_m_s` along the normal.
    pub fn restitution_at(&self, speed_m_s: f64) -> f64 {
        self.restitution / (1.0 + self.falloff_s_per_m * speed_m_s)
    }
}
