//! What a lamp's light does at points of a tile: how much arrives, and how a tilted surface answers.

use crate::Lamp;
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
    x: f32,
    y: f32,
    height_square: f32,
    /// One over the square of the reach.
    fade: f32,
    color: [f32; 3],
}

impl Beam {
    /// The lamp's light for a tile round `middle_mm`.
    pub fn new(lamp: &Lamp, middle_mm: DVec2) -> Beam {
        let from_tile = lamp.center_mm - middle_mm;
        let height = lamp.height_mm.abs().max(Lamp::LEAST_HEIGHT_MM);
        let reference = Lamp::REFERENCE_MM * Lamp::REFERENCE_MM;
        Beam {
            x: from_tile.x as f32,
            y: from_tile.y as f32,
            height_square: (height * height) as f32,
            fade: (1.0 / (lamp.reach_mm * lamp.reach_mm)) as f32,
            color: lamp.color.map(|c| c * reference as f32),
        }
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

/// Irradiance before colour and visibility: see [`Lamp`].
#[inline(always)]
fn falloff(square: f32, beam: &Beam) -> f32 {
    let rest = max(1.0 - square * beam.fade, 0.0);
    rest * rest / (square + beam.height_square)
}

#[inline(always)]
fn light_floor_lanes(points: &Points, beam: Beam, fraction: &[Lanes], light: &mut Light) {
    for block in 0..points.blocks() {
        let (x, y, seen) = (&points.x[block], &points.y[block], &fraction[block]);
        let mut arriving = [0.0; LANES];
        for i in 0..LANES {
            let (ux, uy) = (beam.x - x[i], beam.y - y[i]);
            arriving[i] = falloff(ux * ux + uy * uy, &beam) * seen[i];
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
        let (mut matt, mut gloss) = ([0.0; LANES], [0.0; LANES]);
        for i in 0..LANES {
            let (ux, uy) = (beam.x - x[i], beam.y - y[i]);
            let square = ux * ux + uy * uy;
            let arriving = falloff(square, &beam) * seen[i];
            let up_square = beam.height_square + LIFT * square;
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
