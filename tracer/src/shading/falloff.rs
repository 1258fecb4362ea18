//! The falloff of a lamp: the irradiance at points that see all of it, and the direction that it comes from.
//!
//! The inverse square law over the distance in space, times a window that brings it to 0 at the lamp's reach: the
//! square of `1 - (d / reach)^2`. (Real-Time Rendering, 4th ed., section 5.2.2, has the same window with the fourth
//! power of the distance.) [`Lamp::falloff`] is the scalar form in double precision.

use crate::Lamp;
use crate::simd::atan2::angle;
use crate::simd::dispatch::{LANES, Lanes, clamp, max};
use geometry::DVec2;

/// A lamp's emitter and reach, in mm from the middle of one tile.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Falloff {
    x: f32,
    y: f32,
    /// The square of its height, mm^2.
    pub height_square: f32,
    /// One over the square of the reach, 1/mm^2.
    fade: f32,
    /// The unit vector along a tube, and half of its length, mm.
    tube: Option<([f32; 2], f32)>,
}

/// What arrives at one block of samples.
pub(crate) struct IncidentLight {
    /// The vector to the nearest point of the emitter, across, mm.
    pub x: Lanes,
    /// Down the table.
    pub y: Lanes,
    /// The square of its length.
    pub square: Lanes,
    /// Irradiance before colour, visibility and the reference distance, 1/mm^2: see [`Lamp`].
    pub irradiance: Lanes,
}

impl Falloff {
    /// The lamp for a tile round `middle_mm`.
    pub fn new(lamp: &Lamp, middle_mm: DVec2) -> Falloff {
        let from_tile = lamp.center_mm - middle_mm;
        let height = lamp.height_mm();
        let tube = lamp.tube().map(|half| {
            let length = half.length();
            ([(half.x / length) as f32, (half.y / length) as f32], length as f32)
        });
        Falloff {
            x: from_tile.x as f32,
            y: from_tile.y as f32,
            height_square: (height * height) as f32,
            fade: (1.0 / (lamp.reach_mm * lamp.reach_mm)) as f32,
            tube,
        }
    }

    /// What arrives at a block of samples.
    #[inline(always)]
    pub fn incident(&self, x: &Lanes, y: &Lanes) -> IncidentLight {
        let none = [0.0; LANES];
        let mut incident = IncidentLight { x: none, y: none, square: none, irradiance: none };
        match self.tube {
            None => self.point_irradiance(x, y, &mut incident),
            Some((along, half)) => self.tube_irradiance(x, y, along, half, &mut incident),
        }
        incident
    }

    #[inline(always)]
    fn point_irradiance(&self, x: &Lanes, y: &Lanes, incident: &mut IncidentLight) {
        for i in 0..LANES {
            let (ux, uy) = (self.x - x[i], self.y - y[i]);
            let square = ux * ux + uy * uy;
            let window = max(1.0 - square * self.fade, 0.0);
            (incident.x[i], incident.y[i], incident.square[i]) = (ux, uy, square);
            incident.irradiance[i] = window * window / (square + self.height_square);
        }
    }

    /// The mean of the inverse square law over the tube, see [`Lamp::falloff`]:
    /// 1. In the frame of the tube the point is `middle` along and `off` across; q^2 = off^2 + height^2.
    /// 2. The integral of dt / (t^2 + q^2) from middle - half to middle + half is the angle between both ends, seen
    ///    from q off the line, over q.
    /// 3. That angle is atan2(2 half q, q^2 + (middle - half) (middle + half)); the mean is over 2 half.
    #[inline(always)]
    fn tube_irradiance(&self, x: &Lanes, y: &Lanes, along: [f32; 2], half: f32, incident: &mut IncidentLight) {
        for i in 0..LANES {
            let (mx, my) = (self.x - x[i], self.y - y[i]);
            let middle = mx * along[0] + my * along[1];
            let off = my * along[0] - mx * along[1];
            let nearest = middle - clamp(middle, -half, half);
            let square = nearest * nearest + off * off;
            let window = max(1.0 - square * self.fade, 0.0);
            let q_square = off * off + self.height_square;
            let across = 2.0 * half * q_square.sqrt();
            incident.x[i] = along[0] * nearest - along[1] * off;
            incident.y[i] = along[1] * nearest + along[0] * off;
            incident.square[i] = square;
            let seen = angle(q_square + (middle - half) * (middle + half), across);
            incident.irradiance[i] = window * window * seen / across;
        }
    }
}
