//! What a lamp's light does at points of a tile: how much arrives, and how a tilted surface answers.

use crate::Lamp;
use crate::falloff::Falloff;
use crate::lanes::{LANES, Lanes, clones, max};
use crate::points::{Plane, Points, TILE};
use geometry::DVec2;

/// Three planes of light: red, green, blue.
pub(crate) type Light = [Plane; 3];

/// No light.
pub(crate) const DARKNESS: Light = [[[0.0; LANES]; TILE]; 3];

/// A lamp as the points of one tile see it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Beam {
    falloff: Falloff,
    color: [f32; 3],
}

impl Beam {
    /// The lamp's light for a tile round `middle_mm`.
    pub fn new(lamp: &Lamp, middle_mm: DVec2) -> Beam {
        let reference = Lamp::REFERENCE_MM * Lamp::REFERENCE_MM;
        Beam { falloff: Falloff::new(lamp, middle_mm), color: lamp.color.map(|c| c * reference as f32) }
    }
}

/// How the surface at each point of a layer leans.
#[derive(Clone, Debug)]
pub(crate) struct Normals {
    /// Across.
    pub x: Plane,
    /// Down the table.
    pub y: Plane,
    /// Up.
    pub z: Plane,
}

clones! {
    /// Adds the beam's light on a flat floor, seen as far as `fraction` says.
    pub(crate) fn light_floor(points: &Points, beam: Beam, fraction: &[Lanes], light: &mut Light) = light_floor_lanes;
}

clones! {
    /// Adds the beam's light on a leaning surface: diffuse and mirrored.
    pub(crate) fn light_top(
        points: &Points, normals: &Normals, beam: Beam, fraction: &[Lanes], diffuse: &mut Light, mirrored: &mut Light,
    ) = light_top_lanes;
}

#[inline(always)]
fn light_floor_lanes(points: &Points, beam: Beam, fraction: &[Lanes], light: &mut Light) {
    for block in 0..points.blocks() {
        let (x, y, seen) = (&points.x[block], &points.y[block], &fraction[block]);
        let mut arriving = beam.falloff.arriving(x, y).light;
        for i in 0..LANES {
            arriving[i] *= seen[i];
        }
        for (plane, color) in light.iter_mut().zip(beam.color) {
            for i in 0..LANES {
                plane[block][i] += color * arriving[i];
            }
        }
    }
}

/// How much of the way to a lamp counts as its height above a top: lamps far away are not quite in the horizon, or a
/// lean of one degree would be night.
const LIFT: f32 = 0.3;

#[inline(always)]
fn light_top_lanes(
    points: &Points,
    normals: &Normals,
    beam: Beam,
    fraction: &[Lanes],
    diffuse: &mut Light,
    mirrored: &mut Light,
) {
    for block in 0..points.blocks() {
        let (x, y, seen) = (&points.x[block], &points.y[block], &fraction[block]);
        let (nx, ny, nz) = (&normals.x[block], &normals.y[block], &normals.z[block]);
        let to = beam.falloff.arriving(x, y);
        let (mut matt, mut gloss) = ([0.0; LANES], [0.0; LANES]);
        for i in 0..LANES {
            let (ux, uy, square) = (to.x[i], to.y[i], to.square[i]);
            let arriving = to.light[i] * seen[i];
            let up_square = beam.falloff.height_square + LIFT * square;
            let length = (square + up_square).sqrt();
            let up = up_square.sqrt();
            let across = nx[i] * ux + ny[i] * uy;
            // A flat top answers as the floor does: 1.
            matt[i] = arriving * max(across + nz[i] * up, 0.0) / up;
            // Blinn's half vector towards an eye straight above, to the 32nd.
            let half = max(across + nz[i] * (up + length), 0.0);
            let cosine_square = half * half / (2.0 * length * (length + up));
            let c4 = cosine_square * cosine_square;
            let c8 = c4 * c4;
            let c16 = c8 * c8;
            gloss[i] = arriving * c16 * c16;
        }
        for (channel, color) in beam.color.into_iter().enumerate() {
            for i in 0..LANES {
                diffuse[channel][block][i] += color * matt[i];
                mirrored[channel][block][i] += color * gloss[i];
            }
        }
    }
}
