//! The chrome ball, seen from straight above: a mirror with the whole table in it.
//!
//! For each pixel the eye's ray is reflected at the sphere. A reflected ray that goes down meets the floor, which is
//! lit already; a ray that goes up meets the lamps ([`Highlight`]) or the environment ([`environment`]), so that a ball
//! has a bright spot and a rim even where no lamp reaches it. Scratches turn with the ball. The numbers of its look are
//! art direction where no other reason is given.

use crate::film::bloom::{CELL_PX, MipLevel};
use crate::shading::environment;
use crate::simd::dispatch::{SimdLevel, clamp, max};
use crate::tile::planes::{RgbTile, TILE};
use crate::visibility::disc_chain::DiscChains;
use crate::visibility::potential_occluders::PotentialOccluders;
use crate::visibility::scalar;
use crate::visibility::shaft::Shaft;
use crate::visibility::transmission::{self, TintedGroup};
use crate::{Ball, Lamp, Overhang, Rgb, View};
use geometry::DVec2;
use rayon::prelude::*;

/// The reflectance of chrome at normal incidence, a little brighter than the metal's 0.55: a polished ball on a dark
/// table.
const CHROME: Rgb = [0.86, 0.88, 0.90];

/// The radiance of a lamp's mirror image over the lamp's colour: as far beyond white as the tone map still tells apart.
const HIGHLIGHT_GAIN: f32 = 14.0;

/// The least blur of a highlight, pixels: a mirror image smaller than a pixel would flicker as the ball rolls.
const HIGHLIGHT_BLUR_PX: f32 = 1.6;

/// Where a highlight ends: at the square root of this many blurred radii.
const HIGHLIGHT_EXTENT: f32 = 3.0;

/// The least radius of a lamp in a highlight, mm: point lamps are seen too.
const LEAST_LAMP_RADIUS_MM: f32 = 1.0;

/// The outermost normals of the ball: pixels of its edge are shaded just inside it, where the normal still looks up.
const RIM: f64 = 0.995;

/// The radiance of a scratch, which is matt: a part of the irradiance, with ambient light counted so often, and what it
/// has in the dark.
const SCRATCH_DIFFUSE: [f32; 3] = [0.25, 2.0, 0.02];

/// How much of the mirror image a scratch takes away.
const SCRATCH_HIDES: f32 = 0.8;

/// The strength of the rim light, which sets a ball off from a dark floor.
const RIM_LIGHT: f32 = 0.20;

/// The part of the light on the table that the cabinet's walls throw back.
const WALL_BOUNCE: f32 = 0.35;

/// How far a reflected ray runs before the floor has given way to the environment, mm: half a table.
const FLOOR_FADES_MM: f32 = 500.0;

/// How much darker the floor beyond the picture's edge becomes with each mm: black after 20 mm.
const OUTSIDE_FADE_PER_MM: f64 = 0.05;

/// The width of a scratch: pixels, and at least so much of the ball's radius.
const SCRATCH_WIDTH: (f32, f32) = (1.2, 0.05);

/// A lamp as a ball mirrors it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Highlight {
    /// The middle, mm from the ball's middle, and its height above the floor.
    place: [f32; 3],
    radius: f32,
    /// The unit vector along a tube, and half of its length, mm; 0 for a disc.
    along: [f32; 2],
    half: f32,
    color: Rgb,
}

/// How thick a tube that shines looks in a ball, mm.
const TUBE_RADIUS_MM: f32 = 3.0;

impl Highlight {
    /// `lamp`, of which the ball sees `fraction` of each channel.
    pub fn new(lamp: &Lamp, ball: &Ball, fraction: [f64; 3]) -> Highlight {
        let from_ball = lamp.center_mm - ball.center_mm;
        let tube = lamp.tube();
        let half = tube.map_or(0.0, DVec2::length);
        let along = tube.map_or(DVec2::ZERO, |tube| tube / half);
        Highlight {
            place: [from_ball.x as f32, from_ball.y as f32, lamp.height_mm as f32],
            radius: if tube.is_some() { TUBE_RADIUS_MM } else { max(lamp.radius_mm() as f32, LEAST_LAMP_RADIUS_MM) },
            along: [along.x as f32, along.y as f32],
            half: half as f32,
            color: [0, 1, 2].map(|channel: usize| lamp.color[channel] * fraction[channel] as f32),
        }
    }
}

/// Light and coverage of the pixels of a ball.
#[derive(Debug, Default)]
pub(crate) struct BallSprite {
    x: usize,
    y: usize,
    width: usize,
    pixels: Vec<[f32; 4]>,
    /// The lamps that the ball sees.
    highlights: Vec<Highlight>,
    /// What arrives from them at its middle.
    irradiance: Rgb,
    /// What may stand before a lamp, and the parts that it hides: room to work in.
    near: PotentialOccluders,
    /// What hangs above it.
    overhangs: Vec<Overhang>,
    intervals: Vec<(f64, f64)>,
}

/// The lit table below the balls, in the cells of the bloom: a ball shows it so small that they are fine enough.
#[derive(Clone, Copy)]
pub(crate) struct TableImage<'a> {
    pub view: &'a View,
    pub level: &'a MipLevel,
    pub planes: [&'a [f32]; 3],
    pub ambient: Rgb,
    /// What may hang above a ball.
    pub overhangs: &'a [Overhang],
}

impl BallSprite {
    /// Finds which lamps the ball sees, past what may stand before each of them.
    pub fn find_highlights<'a>(
        &mut self,
        simd: SimdLevel,
        ball: &Ball,
        lamps: impl Iterator<Item = (&'a Lamp, &'a PotentialOccluders)>,
        tinted: &[TintedGroup],
        all: &DiscChains,
    ) {
        self.highlights.clear();
        self.irradiance = [0.0; 3];
        for (lamp, potential_occluders) in lamps {
            let falloff = lamp.falloff(ball.center_mm) as f32;
            if falloff <= 0.0 {
                continue;
            }
            potential_occluders.narrow(simd, &Shaft::new(lamp, ball.center_mm, 0.0), &mut self.near, None);
            let met = transmission::on_path(tinted, |group| self.near.group.contains(&group));
            let seen = transmission::transmitted(met.as_slice(), |away| {
                let mut without = [ball.group; transmission::MAX_TINTED + 1];
                without[1..=away.len()].copy_from_slice(away);
                let (without, place) = (&without[..=away.len()], ball.center_mm);
                scalar::visible_fraction_of(all, &self.near, lamp, place, without, &mut self.intervals)
            });
            if seen != [0.0; 3] {
                self.highlights.push(Highlight::new(lamp, ball, seen));
            }
            for channel in 0..3 {
                self.irradiance[channel] += lamp.color[channel] * falloff * seen[channel] as f32;
            }
        }
    }

    /// Renders a ball that mirrors `table` and the lamps that it sees.
    pub fn render(&mut self, ball: &Ball, table: TableImage) {
        let view = table.view;
        let reach = DVec2::splat(ball.radius_mm + view.mm_per_px);
        let size = DVec2::new(view.width as f64, view.height as f64);
        let from = view.screen_from_table(ball.center_mm - reach).clamp(DVec2::ZERO, size);
        let to = view.screen_from_table(ball.center_mm + reach).clamp(DVec2::ZERO, size).ceil();
        self.pixels.clear();
        (self.x, self.y) = (from.x as usize, from.y as usize);
        self.width = (to.x as usize).saturating_sub(self.x);
        let height = (to.y as usize).saturating_sub(self.y);
        if self.width == 0 || height == 0 || ball.radius_mm.is_nan() || ball.radius_mm <= 0.0 {
            self.width = 0;
            return;
        }
        self.pixels.resize(self.width * height, [0.0; 4]);
        self.overhangs.clear();
        self.overhangs.extend(table.overhangs.iter().filter(|overhang| ball.below && overhang.is_near(ball)));
        let overhangs = &self.overhangs;
        let shader = MirrorShader { ball, table, highlights: &self.highlights, irradiance: self.irradiance };
        let (x, y) = (self.x, self.y);
        self.pixels.par_chunks_mut(self.width).with_min_len(4).enumerate().for_each(|(row, pixels)| {
            for (column, pixel) in pixels.iter_mut().enumerate() {
                let point = view.table_from_pixel(x + column, y + row);
                *pixel = shader.pixel(point);
                overhangs.iter().for_each(|overhang| pixel[3] *= overhang.passes_at(point, view.mm_per_px));
            }
        });
    }

    /// Puts the ball on a tile of the picture, given by its upper left pixel.
    pub fn blend(&self, x: usize, y: usize, tile: &mut RgbTile) {
        let height = self.pixels.len().checked_div(self.width).unwrap_or(0);
        for line in self.y.max(y)..(self.y + height).min(y + TILE) {
            for column in self.x.max(x)..(self.x + self.width).min(x + TILE) {
                let pixel = &self.pixels[(line - self.y) * self.width + column - self.x];
                for (plane, light) in tile.iter_mut().zip(pixel) {
                    let out = &mut plane[line - y][column - x];
                    *out += (light - *out) * pixel[3];
                }
            }
        }
    }

    /// The upper left pixels of the tiles that the ball is on.
    pub fn tiles(&self) -> impl Iterator<Item = (usize, usize)> + use<> {
        let height = self.pixels.len().checked_div(self.width).unwrap_or(0);
        let first = |at: usize| at / TILE * TILE;
        let (x, y, right, bottom) = (first(self.x), first(self.y), self.x + self.width, self.y + height);
        let rows = if height == 0 { y..y } else { y..bottom };
        rows.step_by(TILE).flat_map(move |y| (x..right).step_by(TILE).map(move |x| (x, y)))
    }

    /// Puts the ball into the means of the picture's cells: rows of cells without the upper border.
    pub fn blend_means(&self, level: &MipLevel, planes: [&mut [f32]; 3]) {
        for (row, pixels) in self.pixels.chunks(self.width.max(1)).enumerate() {
            let line = (self.y + row) / CELL_PX * level.stride + 1;
            for (column, pixel) in pixels.iter().enumerate() {
                // A pixel is a sixteenth of its cell; pixel after pixel, what is there gives way.
                let part = pixel[3] * (1.0 / (CELL_PX * CELL_PX) as f32);
                let at = line + (self.x + column) / CELL_PX;
                for channel in 0..3 {
                    planes[channel][at] += (pixel[channel] - planes[channel][at]) * part;
                }
            }
        }
    }
}

struct MirrorShader<'a> {
    ball: &'a Ball,
    table: TableImage<'a>,
    highlights: &'a [Highlight],
    irradiance: Rgb,
}

impl MirrorShader<'_> {
    /// Light and coverage at a point of the table.
    fn pixel(&self, point_mm: DVec2) -> [f32; 4] {
        let radius = self.ball.radius_mm;
        let from_middle = point_mm - self.ball.center_mm;
        let distance = from_middle.length();
        let coverage = clamp((0.5 - (distance - radius) / self.table.view.mm_per_px) as f32, 0.0, 1.0);
        if coverage <= 0.0 {
            return [0.0; 4];
        }
        // The pixels of the edge take the light just inside it.
        let on_ball = from_middle * (RIM / (distance / radius).max(RIM) / radius);
        let (nx, ny) = (on_ball.x as f32, on_ball.y as f32);
        let nz = max(1.0 - nx * nx - ny * ny, 0.0).sqrt();
        let normal = [nx, ny, nz];
        // The reflected direction 2 (n . v) n - v, with the eye at v = (0, 0, 1).
        let out = [2.0 * nz * nx, 2.0 * nz * ny, 2.0 * nz * nz - 1.0];
        let mut light = self.reflected(normal, out);
        for highlight in self.highlights {
            self.add_highlight(highlight, normal, out, &mut light);
        }
        let scratch = self.scratches(normal);
        // Fresnel: C. Schlick's approximation (1994) with the third power for the fifth, for a wider rim.
        let grazing = (1.0 - nz) * (1.0 - nz) * (1.0 - nz);
        let mut pixel = [0.0, 0.0, 0.0, coverage];
        for channel in 0..3 {
            let reflectance = CHROME[channel] + (1.0 - CHROME[channel]) * grazing;
            let [direct, ambient, least] = SCRATCH_DIFFUSE;
            let diffuse = direct * (self.irradiance[channel] + ambient * self.table.ambient[channel]) + least;
            let rim = RIM_LIGHT * grazing * (1.0 + self.irradiance[channel]);
            let mirror = light[channel] * reflectance * (1.0 - SCRATCH_HIDES * scratch);
            pixel[channel] = mirror + diffuse * scratch * nz + rim;
        }
        pixel
    }

    /// The radiance from the direction `out`: the floor below or the environment above.
    fn reflected(&self, normal: [f32; 3], out: [f32; 3]) -> Rgb {
        let sky = environment::radiance(out, self.irradiance.map(|light| WALL_BOUNCE * light));
        if out[2] >= -environment::HORIZON {
            return sky;
        }
        let radius = self.ball.radius_mm as f32;
        let height = radius * (1.0 + normal[2]);
        let run = height / -out[2];
        let x = normal[0] * radius + out[0] * run;
        let y = normal[1] * radius + out[1] * run;
        let floor = self.floor(self.ball.center_mm + DVec2::new(f64::from(x), f64::from(y)));
        // Far away, just below the horizon, the floor gives way to the environment.
        let far = clamp(run * (1.0 / FLOOR_FADES_MM), 0.0, 1.0);
        [0, 1, 2].map(|channel| floor[channel] + (sky[channel] - floor[channel]) * far * far)
    }

    /// The radiance of the floor at a point, bilinear between the four nearest cells.
    fn floor(&self, point_mm: DVec2) -> Rgb {
        let TableImage { view, level, planes, .. } = self.table;
        let place = view.screen_from_table(point_mm) * (1.0 / CELL_PX as f64) - DVec2::splat(0.5);
        let (right, bottom) = ((level.width - 1) as f64, (level.height - 1) as f64);
        let outside = (-place.x).max(place.x - right).max(-place.y).max(place.y - bottom).max(0.0);
        let fade = (1.0 - outside * CELL_PX as f64 * view.mm_per_px * OUTSIDE_FADE_PER_MM).max(0.0) as f32;
        let (x, y) = (place.x.clamp(0.0, right), place.y.clamp(0.0, bottom));
        let (left, top) = (x as usize, y as usize);
        let (across, down) = ((x - left as f64) as f32, (y - top as f64) as f32);
        let next_x = (left + 1).min(level.width - 1);
        let next_y = (top + 1).min(level.height - 1);
        [0, 1, 2].map(|channel: usize| {
            let plane = planes[channel];
            let blend = |row: usize| {
                // The plane has a border of one cell.
                let row = (row + 1) * level.stride + 1;
                let (a, b) = (plane[row + left], plane[row + next_x]);
                a + (b - a) * across
            };
            let (above, below) = (blend(top), blend(next_y));
            (above + (below - above) * down) * fade
        })
    }

    /// A lamp's mirror image: a soft disc of the lamp's angular radius, widened to what a pixel sees. A tube's is the
    /// disc round its point that is nearest to the reflected ray.
    ///
    /// 1. (x, y, z): the vector from the point of the sphere to the lamp's centre.
    /// 2. The point of the tube's line nearest to the ray in the direction `out` minimises their distance; with t the
    ///    tube's direction it is ((t . out) (c . out) - c . t) / (1 - (t . out)^2) along t.
    /// 3. sin^2 of the angle between ray and lamp is 1 - (c . out)^2 / c^2; sin^2 of the lamp's radius is r^2 / c^2.
    /// 4. An image widened from r to b is dimmed by r / b. Energy would ask for r^2 / b^2, but small lamps must stay
    ///    seen.
    fn add_highlight(&self, highlight: &Highlight, normal: [f32; 3], out: [f32; 3], light: &mut Rgb) {
        let radius = self.ball.radius_mm as f32;
        let x = highlight.place[0] - normal[0] * radius;
        let y = highlight.place[1] - normal[1] * radius;
        let z = max(highlight.place[2], radius) - radius * (1.0 + normal[2]) + radius;
        let [tx, ty] = highlight.along;
        let turn = tx * out[0] + ty * out[1];
        let nearest =
            (turn * (x * out[0] + y * out[1] + z * out[2]) - (x * tx + y * ty)) / max(1.0 - turn * turn, 1e-6);
        let place = clamp(nearest, -highlight.half, highlight.half);
        let (x, y) = (x + tx * place, y + ty * place);
        let square = max(x * x + y * y + z * z, 1.0);
        let along = x * out[0] + y * out[1] + z * out[2];
        if along <= 0.0 {
            return;
        }
        let off_square = max(1.0 - along * along / square, 0.0);
        let lamp_square = highlight.radius * highlight.radius / square;
        let pixel = HIGHLIGHT_BLUR_PX * self.table.view.mm_per_px as f32 / radius;
        let blurred = lamp_square + pixel * pixel;
        let edge = max(1.0 - off_square / (HIGHLIGHT_EXTENT * blurred), 0.0);
        let strength = HIGHLIGHT_GAIN * edge * edge * edge * (lamp_square / blurred).sqrt();
        for channel in 0..3 {
            light[channel] += highlight.color[channel] * strength;
        }
    }

    /// How scratched the ball is at a normal, 0 to 1: great circles, half circles and a dot in the ball's own frame,
    /// laid out by eye so that some scratch is always in sight.
    fn scratches(&self, normal: [f32; 3]) -> f32 {
        let [x, y, z] = unrotated(self.ball.rotation, normal);
        let (width_px, least) = SCRATCH_WIDTH;
        let width = max(width_px * self.table.view.mm_per_px as f32 / self.ball.radius_mm as f32, least);
        let line = |off: f32| max(1.0 - off.abs() / width, 0.0);
        let ring = line(z) * 0.55;
        let half_ring = if y > 0.0 { line(0.8 * x + 0.6 * z) * 0.4 } else { 0.0 };
        let dot =
            max(1.0 - ((x - 0.8) * (x - 0.8) + (y + 0.2) * (y + 0.2) + (z - 0.57) * (z - 0.57)) * 30.0, 0.0) * 0.5;
        let scuff = if x > -0.2 { line(y - 0.45 * z + 0.5) * 0.3 } else { 0.0 };
        max(max(ring, half_ring), max(dot, scuff))
    }
}

/// `v` in the frame of something that was turned by the unit quaternion `q`.
fn unrotated([qx, qy, qz, qw]: [f32; 4], [x, y, z]: [f32; 3]) -> [f32; 3] {
    let (tx, ty, tz) = (2.0 * (z * qy - y * qz), 2.0 * (x * qz - z * qx), 2.0 * (y * qx - x * qy));
    [x + qw * tx + (tz * qy - ty * qz), y + qw * ty + (tx * qz - tz * qx), z + qw * tz + (ty * qx - tx * qy)]
}
