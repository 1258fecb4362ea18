//! What the eye sees of a tile whose light is found: the floor with its glowing inserts, and the tops over it.

use crate::albedo::{self, Albedo};
use crate::changes::CONTACT_RADII;
use crate::irradiance::Light;
use crate::lanes::{LANES, clamp, clones, max};
use crate::layer::TopLayer;
use crate::points::{Plane, TILE};
use crate::tile::{Stage, Workspace};
use crate::{Finish, Rgb, Scene};
use geometry::DVec2;

impl Workspace {
    /// Puts the lit floor into `out`.
    pub(crate) fn compose_floor(&mut self, stage: &Stage, x: usize, y: usize, middle: DVec2, layers: usize) {
        let scene = stage.scene;
        let (width, height) = (scene.view.width.min(x + TILE) - x, scene.view.height.min(y + TILE) - y);
        let floor = scene.floor;
        if floor.fits(scene) {
            albedo::read_opaque(stage.path, &floor.floor, floor.width, x, y, width, height, &mut self.art);
            if self.tops[..layers].iter().any(|top| scene.tops[top.form].finish.art) {
                albedo::read(stage.path, &floor.tops, floor.width, x, y, width, height, &mut self.printed);
            }
        } else {
            self.art.color = [[[0.5; LANES]; TILE]; 3];
            self.printed.alpha = [[0.0; LANES]; TILE];
        }
        if !self.whole {
            for (spread, light) in self.spread.iter_mut().zip(&self.floor_light) {
                *spread = [[0.0; LANES]; TILE];
                for (point, &pixel) in self.floor.pixel[..self.floor.count].iter().enumerate() {
                    let pixel = usize::from(pixel);
                    spread[pixel / LANES][pixel % LANES] = light[point / LANES][point % LANES];
                }
            }
        }
        let light = if self.whole { &self.floor_light } else { &self.spread };
        reflect(stage.path, &self.art.color, light, scene.ambient, &mut self.out);
        self.add_contact_shadows(stage, middle);
        self.add_glows(scene, x, y);
    }

    /// Darkens the floor where a ball hides the sky: a sphere that rests on it, seen from the floor, hides the part
    /// `(r / s)^2 cos`, s being the distance of its middle.
    fn add_contact_shadows(&mut self, stage: &Stage, middle: DVec2) {
        for ball in &stage.scene.balls {
            let from_tile = ball.center_mm - middle;
            let reach = ball.radius_mm * CONTACT_RADII + TILE as f64 * stage.scene.view.mm_per_px;
            let near = from_tile.length_squared() < reach * reach;
            if !near {
                continue;
            }
            let (bx, by, radius) = (from_tile.x as f32, from_tile.y as f32, ball.radius_mm as f32);
            for row in 0..TILE {
                for i in 0..LANES {
                    let (dx, dy) = (stage.whole_tile.x[row][i] - bx, stage.whole_tile.y[row][i] - by);
                    let square = max(dx * dx + dy * dy + radius * radius, 1e-6);
                    let hidden = radius * radius * radius / (square * square.sqrt());
                    let open = 1.0 - 0.9 * hidden;
                    for plane in &mut self.out {
                        plane[row][i] *= open;
                    }
                }
            }
        }
    }

    /// Adds the inserts that glow, as light through the art that is printed on them.
    fn add_glows(&mut self, scene: &Scene, x: usize, y: usize) {
        for glow in &scene.glows {
            let mask = glow.mask;
            let columns = mask.x.max(x)..(mask.x + mask.width).min(x + TILE);
            let lines = mask.y.max(y)..(mask.y + mask.height()).min(y + TILE);
            for line in lines {
                for column in columns.clone() {
                    let coverage = mask.coverage[(line - mask.y) * mask.width + column - mask.x];
                    if coverage == 0 {
                        continue;
                    }
                    let (row, i) = (line - y, column - x);
                    let art = [0, 1, 2].map(|channel: usize| self.art.color[channel][row][i]);
                    let luminance = 0.2126 * art[0] + 0.7152 * art[1] + 0.0722 * art[2];
                    let strength = f32::from(coverage) * (1.0 / 255.0);
                    for channel in 0..3 {
                        let through = 0.15 + 0.45 * luminance + 0.4 * art[channel];
                        self.out[channel][row][i] += glow.color[channel] * strength * through;
                    }
                }
            }
        }
    }

    /// Puts a top over what is in `out`.
    pub(crate) fn compose_top(&mut self, stage: &Stage, layer: usize) {
        let layer = &mut self.tops[layer];
        let finish = &stage.scene.tops[layer.form].finish;
        if finish.art {
            layer.take_print(&self.printed);
        }
        let TopLayer { points, normals, diffuse, mirrored, print, .. } = layer;
        let print = finish.art.then_some(&*print);
        shine(stage.path, points.blocks(), finish, stage.scene.ambient, &normals.z, print, mirrored, diffuse);
        for point in 0..points.count {
            let (block, lane) = (point / LANES, point % LANES);
            let pixel = usize::from(points.pixel[point]);
            let (row, i) = (pixel / LANES, pixel % LANES);
            let coverage = layer.coverage[block][lane];
            for channel in 0..3 {
                let out = &mut self.out[channel][row][i];
                *out += (layer.diffuse[channel][block][lane] - *out) * coverage;
            }
        }
    }
}

clones! {
    /// What the floor sends on of the light that arrives and of the light from everywhere.
    fn reflect(albedo: &Light, light: &Light, ambient: Rgb, out: &mut Light) = reflect_lanes;
}

#[inline(always)]
fn reflect_lanes(albedo: &Light, light: &Light, ambient: Rgb, out: &mut Light) {
    for channel in 0..3 {
        for row in 0..TILE {
            for i in 0..LANES {
                out[channel][row][i] = albedo[channel][row][i] * (light[channel][row][i] + ambient[channel]);
            }
        }
    }
}

clones! {
    /// What a top sends on, in place of the diffuse light that arrives.
    fn shine(
        blocks: usize, finish: &Finish, ambient: Rgb, up: &Plane, print: Option<&Light>, mirrored: &Light,
        diffuse: &mut Light,
    ) = shine_lanes;
}

#[inline(always)]
fn shine_lanes(
    blocks: usize,
    finish: &Finish,
    ambient: Rgb,
    up: &Plane,
    print: Option<&Light>,
    mirrored: &Light,
    diffuse: &mut Light,
) {
    let gloss = clamp(finish.gloss, 0.0, 1.0);
    for channel in 0..3 {
        let (albedo, emission, ambient) = (finish.albedo[channel], finish.emission[channel], ambient[channel]);
        for block in 0..blocks {
            let art = print.map_or([1.0; LANES], |print| print[channel][block]);
            let (up, mirrored, light) = (&up[block], &mirrored[channel][block], &mut diffuse[channel][block]);
            for i in 0..LANES {
                let albedo = albedo * art[i];
                // Polished metal mirrors in its own colour and scatters little; anything else has a white coat.
                let tint = 0.3 + (albedo - 0.3) * gloss;
                let scattered = albedo * (1.0 - 0.4 * gloss) * (light[i] + ambient * (0.5 + 0.5 * up[i]));
                light[i] = scattered + 2.5 * gloss * tint * mirrored[i] + emission * art[i];
            }
        }
    }
}

impl TopLayer {
    /// Packs the art at the layer's points: white where nothing is printed.
    fn take_print(&mut self, printed: &Albedo) {
        for point in 0..self.points.count {
            let pixel = usize::from(self.points.pixel[point]);
            let (row, i) = (pixel / LANES, pixel % LANES);
            let alpha = printed.alpha[row][i];
            for (print, color) in self.print.iter_mut().zip(&printed.color) {
                print[point / LANES][point % LANES] = 1.0 + (color[row][i] - 1.0) * alpha;
            }
        }
    }
}
