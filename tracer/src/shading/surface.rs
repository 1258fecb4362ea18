//! Surface shading: what a lamp's light does at samples of a tile: how much arrives, and what a surface sends on to an
//! eye straight above.

use crate::shading::environment;
use crate::shading::falloff::{Falloff, IncidentLight};
use crate::simd::dispatch::{LANES, Lanes, clamp, max, multiversion, set_bits};
use crate::tile::packed_samples::PackedSamples;
use crate::tile::planes::{BLACK, Plane, RgbTile, TILE};
use crate::{Finish, Lamp};

/// How the surface at each sample of a layer leans.
#[derive(Clone, Debug)]
pub(crate) struct Normals {
    /// Across.
    pub x: Plane,
    /// Down the table.
    pub y: Plane,
    /// Up.
    pub z: Plane,
}

impl Normals {
    /// Straight up.
    pub fn flat() -> Normals {
        let zero = [[0.0; LANES]; TILE];
        Normals { x: zero, y: zero, z: [[1.0; LANES]; TILE] }
    }
}

/// What a layer is at its samples.
#[derive(Clone, Debug)]
pub(crate) struct Surface {
    /// How much of a pixel each sample is.
    pub weight: Plane,
    /// Reflectance, linear; a top's is multiplied by that of its finish.
    pub albedo: RgbTile,
    /// Which way it leans.
    pub normals: Normals,
    /// Whether it leans anywhere.
    pub has_normals: bool,
}

impl Surface {
    /// Nothing.
    pub fn none() -> Surface {
        let zero = [[0.0; LANES]; TILE];
        Surface { weight: zero, albedo: BLACK, normals: Normals::flat(), has_normals: false }
    }
}

multiversion! {
    /// What arrives of the lamp's light at those blocks of the floor's samples whose bits are set, and what shines there
    /// in the light's own colour, if nothing is in the way; `gloss` is 0 to 1.
    pub(crate) fn floor_irradiance(
        samples: &PackedSamples, blocks: u16, floor: &Surface, falloff: Falloff, gloss: f32, irradiance: &mut Plane,
        specular: &mut Plane,
    ) = floor_irradiance_lanes;
}

multiversion! {
    /// Takes away what is not seen, at those blocks whose bits are set.
    pub(crate) fn apply_visibility(blocks: u16, fraction: &Plane, irradiance: &mut Plane, specular: &mut Plane) = apply_visibility_lanes;
}

multiversion! {
    /// The floor's picture, of what arrives and of what shines, at those blocks of its samples whose bits are set.
    pub(crate) fn shade_floor(
        blocks: u16, albedo: &RgbTile, irradiance: &Plane, specular: &Plane, out: &mut RgbTile,
    ) = shade_floor_lanes;
}

multiversion! {
    /// A top's picture in the lamp's light, at those blocks of its samples whose bits are set.
    pub(crate) fn shade_top(
        samples: &PackedSamples, blocks: u16, top: &Surface, finish: &Finish, falloff: Falloff, fraction: &[Lanes], out: &mut RgbTile,
    ) = shade_top_lanes;
}

/// What brings a lamp's light to its colour at the reference distance.
const REFERENCE_SQUARE_MM2: f32 = (Lamp::REFERENCE_MM * Lamp::REFERENCE_MM) as f32;

/// Lifts lamps for the shading of normals: height^2 is height_mm^2 + HEIGHT_LIFT distance^2. Art direction: at the true
/// elevation of a lamp half a table away, a slope of one degree would be black.
const HEIGHT_LIFT: f32 = 0.3;

/// The part of its diffuse reflection that a top of gloss 1 loses to its specular one: art direction.
const GLOSS_DARKENS: f32 = 0.4;

/// The specular strength of a top of gloss 1: art direction, a highlight that outshines the art under it.
const TOP_SPECULAR: f32 = 2.5;

/// The colour of a clear coat's highlight on a top of gloss 0: white, at this reflectance. From there to gloss 1 it
/// goes over to the albedo, as a metal's does: art direction, after the dielectric and metal of the trade's shading
/// models (Real-Time Rendering, 4th ed., section 9.5.2).
const COAT_REFLECTANCE: f32 = 0.3;

/// The part of light from below that comes through white ink once instead of twice: art direction.
const INK_TRANSMITS: f32 = 0.3;

/// The BRDF of a surface with a normal, in the direction of an eye straight above.
struct BrdfResponse {
    /// The Lambert cosine over that of a flat surface: 1 for a flat one.
    diffuse: f32,
    /// The cosine of the angle between normal and half vector (J. Blinn, 1977), squared.
    cosine_square: f32,
}

/// The response to a lamp in the direction l, with the eye in the direction v = (0, 0, 1) and the normal n:
/// 1. l is (ux, uy, up) / length, where up is the lifted height.
/// 2. Lambert: n . l over the l.z of a flat surface is (n.x ux + n.y uy + n.z up) / up.
/// 3. The half vector h (J. Blinn, "Models of light reflection for computer synthesized pictures", 1977) is the
///    direction of l + v, so of (ux, uy, up + length), whose squared length is 2 length (length + up).
/// 4. (n . h)^2 is the square of n . (ux, uy, up + length) over that: no square root.
#[inline(always)]
fn brdf_response(incident: &IncidentLight, i: usize, height_square: f32, [nx, ny, nz]: [f32; 3]) -> BrdfResponse {
    let (ux, uy, square) = (incident.x[i], incident.y[i], incident.square[i]);
    let up_square = height_square + HEIGHT_LIFT * square;
    let length = (square + up_square).sqrt();
    let up = up_square.sqrt();
    let across = nx * ux + ny * uy;
    let half = max(across + nz * (up + length), 0.0);
    BrdfResponse {
        diffuse: max(across + nz * up, 0.0) / up,
        cosine_square: half * half / (2.0 * length * (length + up)),
    }
}

/// The 16th power: with a squared cosine, a Blinn exponent of 32.
#[inline(always)]
fn power_16(x: f32) -> f32 {
    let x2 = x * x;
    let x4 = x2 * x2;
    let x8 = x4 * x4;
    x8 * x8
}

/// The specular strength of a floor of gloss 1 at the centre of a highlight: art direction.
const COAT_STRENGTH: f32 = 1.6;

/// Below this (n . h)^2 the floor has no highlight. With x = (n . h)^2, x^32 (a Blinn exponent of 64) has the slope 32
/// at x = 1, and so has the sixth power of a line that reaches 0 here: as narrow, but it ends, so most tiles have none.
const COAT_END_COSINE_SQUARE: f32 = 1.0 - 6.0 / 32.0;

#[inline(always)]
fn floor_irradiance_lanes(
    samples: &PackedSamples,
    blocks: u16,
    floor: &Surface,
    falloff: Falloff,
    gloss: f32,
    irradiance: &mut Plane,
    specular: &mut Plane,
) {
    let has_normals = floor.has_normals || gloss > 0.0;
    let coat = COAT_STRENGTH * clamp(gloss, 0.0, 1.0);
    for block in set_bits(blocks) {
        let (x, y) = (&samples.x[block], &samples.y[block]);
        let (nx, ny, nz) = (&floor.normals.x[block], &floor.normals.y[block], &floor.normals.z[block]);
        let weight = &floor.weight[block];
        let (diffuse, specular) = (&mut irradiance[block], &mut specular[block]);
        let incident = falloff.incident(x, y);
        for i in 0..LANES {
            diffuse[i] = weight[i] * (REFERENCE_SQUARE_MM2 * incident.irradiance[i]);
        }
        if has_normals {
            for i in 0..LANES {
                let response = brdf_response(&incident, i, falloff.height_square, [nx[i], ny[i], nz[i]]);
                // The lobe of the lacquer: see COAT_END_COSINE_SQUARE.
                let near =
                    max(response.cosine_square - COAT_END_COSINE_SQUARE, 0.0) * (1.0 / (1.0 - COAT_END_COSINE_SQUARE));
                let lobe = near * near * near;
                specular[i] = coat * diffuse[i] * (lobe * lobe);
                diffuse[i] *= response.diffuse;
            }
        } else {
            *specular = [0.0; LANES];
        }
    }
}

#[inline(always)]
fn apply_visibility_lanes(blocks: u16, fraction: &Plane, irradiance: &mut Plane, specular: &mut Plane) {
    for block in set_bits(blocks) {
        let (seen, irradiance, specular) = (&fraction[block], &mut irradiance[block], &mut specular[block]);
        for i in 0..LANES {
            (irradiance[i], specular[i]) = (irradiance[i] * seen[i], specular[i] * seen[i]);
        }
    }
}

#[inline(always)]
fn shade_floor_lanes(blocks: u16, albedo: &RgbTile, irradiance: &Plane, specular: &Plane, out: &mut RgbTile) {
    for (out, albedo) in out.iter_mut().zip(albedo) {
        for block in set_bits(blocks) {
            for i in 0..LANES {
                out[block][i] = albedo[block][i] * irradiance[block][i] + specular[block][i];
            }
        }
    }
}

#[inline(always)]
fn shade_top_lanes(
    samples: &PackedSamples,
    blocks: u16,
    top: &Surface,
    finish: &Finish,
    falloff: Falloff,
    fraction: &[Lanes],
    out: &mut RgbTile,
) {
    let gloss = clamp(finish.gloss, 0.0, 1.0);
    let through = clamp(finish.translucency, 0.0, 1.0);
    for block in set_bits(blocks) {
        let (x, y, seen) = (&samples.x[block], &samples.y[block], &fraction[block]);
        let (nx, ny, nz) = (&top.normals.x[block], &top.normals.y[block], &top.normals.z[block]);
        let weight = &top.weight[block];
        let (mut above, mut specular, mut below) = ([0.0; LANES], [0.0; LANES], [0.0; LANES]);
        let incident = falloff.incident(x, y);
        for i in 0..LANES {
            let irradiance = weight[i] * (REFERENCE_SQUARE_MM2 * incident.irradiance[i] * seen[i]);
            let response = brdf_response(&incident, i, falloff.height_square, [nx[i], ny[i], nz[i]]);
            above[i] = (1.0 - through) * (1.0 - GLOSS_DARKENS * gloss) * irradiance * response.diffuse;
            specular[i] = TOP_SPECULAR * gloss * irradiance * power_16(response.cosine_square);
            below[i] = through * irradiance;
        }
        for (channel, out) in out.iter_mut().enumerate() {
            let (own, art) = (finish.albedo[channel], &top.albedo[channel][block]);
            for i in 0..LANES {
                let albedo = own * art[i];
                // Polished metal mirrors in its own colour and scatters little; anything else has a white coat.
                let tint = COAT_REFLECTANCE + (albedo - COAT_REFLECTANCE) * gloss;
                // Light from below passes the ink, light from above meets it and comes back through it.
                let ink = albedo * (INK_TRANSMITS + (1.0 - INK_TRANSMITS) * albedo);
                out[block][i] = albedo * above[i] + tint * specular[i] + ink * below[i];
            }
        }
    }
}

multiversion! {
    /// The floor's picture in the light from everywhere.
    pub(crate) fn shade_floor_ambient(blocks: usize, floor: &Surface, ambient: [f32; 3], out: &mut RgbTile)
        = shade_floor_ambient_lanes;
}

#[inline(always)]
fn shade_floor_ambient_lanes(blocks: usize, floor: &Surface, ambient: [f32; 3], out: &mut RgbTile) {
    for channel in 0..3 {
        for block in 0..blocks {
            for i in 0..LANES {
                out[channel][block][i] = floor.weight[block][i] * (floor.albedo[channel][block][i] * ambient[channel]);
            }
        }
    }
}

multiversion! {
    /// A top's picture in the light from everywhere, with the light of its own.
    pub(crate) fn shade_top_ambient(blocks: usize, top: &Surface, finish: &Finish, ambient: [f32; 3], out: &mut RgbTile)
        = shade_top_ambient_lanes;
}

#[inline(always)]
fn shade_top_ambient_lanes(blocks: usize, top: &Surface, finish: &Finish, ambient: [f32; 3], out: &mut RgbTile) {
    let gloss = clamp(finish.gloss, 0.0, 1.0);
    // The environment is lit as the table is: without ambient light there is nothing to be mirrored.
    let mirrors = ambient.map(|ambient| ENVIRONMENT_GAIN * gloss * gloss * ambient);
    for block in 0..blocks {
        let (nx, ny, nz) = (&top.normals.x[block], &top.normals.y[block], &top.normals.z[block]);
        let weight = &top.weight[block];
        let mut room = [[0.0; LANES]; 3];
        for i in 0..LANES {
            let up = 2.0 * nz[i];
            let [red, green, blue] = environment::radiance([up * nx[i], up * ny[i], up * nz[i] - 1.0], [0.0; 3]);
            (room[0][i], room[1][i], room[2][i]) = (mirrors[0] * red, mirrors[1] * green, mirrors[2] * blue);
        }
        for channel in 0..3 {
            let (own, emission) = (finish.albedo[channel], finish.emission[channel]);
            let scattered = (1.0 - GLOSS_DARKENS * gloss) * own * ambient[channel];
            let (art, room) = (&top.albedo[channel][block], &room[channel]);
            for i in 0..LANES {
                let tint = COAT_REFLECTANCE + (own * art[i] - COAT_REFLECTANCE) * gloss;
                // Hemispherical ambient light: a surface that leans sees less of the ceiling.
                let light = art[i] * (scattered * (0.5 + 0.5 * nz[i]) + emission) + tint * room[i];
                out[channel][block][i] = weight[i] * light;
            }
        }
    }
}

/// The radiance of the environment in polished tops, per ambient light: art direction.
const ENVIRONMENT_GAIN: f32 = 4.0;
