//! Trigonometry that gives the same bits on every platform (the `libm` crate instead of the system's).

use glam::DVec2;

/// Sine and cosine of `angle_rad`.
pub fn sin_cos(angle_rad: f64) -> (f64, f64) {
    (libm::sin(angle_rad), libm::cos(angle_rad))
}

/// The unit vector at `angle_rad` from the x axis, turning from x towards y.
pub fn direction(angle_rad: f64) -> DVec2 {
    let (sin, cos) = sin_cos(angle_rad);
    DVec2::new(cos, sin)
}

/// The angle of `vector` from the x axis, in (-pi, pi].
pub fn angle(vector: DVec2) -> f64 {
    libm::atan2(vector.y, vector.x)
}

/// `vector` turned by `angle_rad`.
pub fn rotate(vector: DVec2, angle_rad: f64) -> DVec2 {
    direction(angle_rad).rotate(vector)
}
