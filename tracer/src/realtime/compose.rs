//! The tile's pictures that no lamp above the floor makes: light from everywhere, light of its own, inserts that glow.

use crate::cache::damage::contact_mm;
use crate::realtime::direct_light::scatter;
use crate::realtime::tile_renderer::{Stage, Workspace};
use crate::shading::albedo_map;
use crate::shading::surface::{shade_floor_ambient, shade_top_ambient};
use crate::shading::top_layer::TopLayer;
use crate::simd::dispatch::{LANES, max, multiversion};
use crate::tile::packed_samples::PackedSamples;
use crate::tile::planes::{ALL_ROWS, BLACK, RgbTile, TILE};
use crate::tile::rect::TileRect;
use crate::{Ball, Mask};

impl Workspace {
    /// Reads the art of the floor, and how it leans, for the surfaces that were recalled.
    pub(crate) fn read_art(&mut self, stage: &Stage, rect: &TileRect) {
        let &TileRect { x, y, .. } = rect;
        // What a few points need is read whole, and then packed.
        let art = if self.whole { &mut self.ground.albedo } else { &mut self.art };
        stage.art.read(stage.simd, x, y, art);
        let normals = if self.whole { &mut self.ground.normals } else { &mut self.normals };
        self.ground.has_normals = stage.art.read_normals(stage.simd, x, y, normals);
        self.pack_floor();
    }

    /// Reads what is printed on tops that were found.
    pub(crate) fn read_prints(&mut self, stage: &Stage, rect: &TileRect, layers: usize) {
        let (scene, floor) = (stage.scene, stage.scene.floor);
        let (width, height) = rect.visible_px;
        let has_art = |layer: &TopLayer| floor.fits(scene) && stage.tops.top(layer.form).finish.art;
        if self.tops[..layers].iter().any(has_art) {
            albedo_map::read(stage.simd, &floor.tops, floor.width, rect.x, rect.y, width, height, &mut self.printed);
            self.printed.clamp_to_edge(width, height);
        }
        for layer in &mut self.tops[..layers] {
            layer.printed = false;
            if has_art(layer) {
                layer.pack_print(&self.printed);
            }
        }
    }

    /// Packs the floor's art, weight and normals at its points.
    fn pack_floor(&mut self) {
        let ground = &mut self.ground;
        if self.whole {
            ground.weight.copy_from_slice(&self.remaining);
        } else {
            for (at, &pixel) in self.floor.pixel[..self.floor.count].iter().enumerate() {
                let (row, i) = (usize::from(pixel) / LANES, usize::from(pixel) % LANES);
                let (block, lane) = (at / LANES, at % LANES);
                ground.weight[block][lane] = self.remaining[row][i];
                for (packed, art) in ground.albedo.iter_mut().zip(&self.art) {
                    packed[block][lane] = art[row][i];
                }
                if ground.has_normals {
                    ground.normals.x[block][lane] = self.normals.x[row][i];
                    ground.normals.y[block][lane] = self.normals.y[row][i];
                    ground.normals.z[block][lane] = self.normals.z[row][i];
                }
            }
        }
        if !ground.has_normals {
            let blocks = if self.whole { TILE } else { self.floor.blocks() };
            for plane in [&mut ground.normals.x, &mut ground.normals.y] {
                plane[..blocks].fill([0.0; LANES]);
            }
            ground.normals.z[..blocks].fill([1.0; LANES]);
        }
    }

    /// Puts the tile in the light from everywhere, with the light of tops of their own, into [`Workspace::picture`].
    pub(crate) fn light_from_everywhere(&mut self, stage: &Stage, layers: usize) {
        let (simd, ambient) = (stage.simd, stage.scene.ambient);
        if self.whole {
            shade_floor_ambient(simd, TILE, &self.ground, ambient, &mut self.picture);
        } else {
            self.picture = BLACK;
            shade_floor_ambient(simd, self.floor.blocks(), &self.ground, ambient, &mut self.packed);
            scatter(&self.floor, ALL_ROWS, &self.packed, &mut self.picture);
        }
        for TopLayer { form, points, surface, .. } in &self.tops[..layers] {
            let finish = &stage.tops.top(*form).finish;
            shade_top_ambient(simd, points.blocks(), surface, finish, ambient, &mut self.packed);
            scatter(points, ALL_ROWS, &self.packed, &mut self.picture);
        }
    }

    /// Puts the light of an insert, of the colour white, through the art that is printed on it, into
    /// [`Workspace::picture`].
    pub(crate) fn glow(&mut self, rect: &TileRect, mask: &Mask) {
        self.picture = BLACK;
        let floor = if self.whole { &self.ground.albedo } else { &self.art };
        let &TileRect { x, y, .. } = rect;
        let columns = mask.x.max(x)..(mask.x + mask.width).min(x + TILE);
        let lines = mask.y.max(y)..(mask.y + mask.height()).min(y + TILE);
        for line in lines {
            for column in columns.clone() {
                let coverage = mask.coverage[(line - mask.y) * mask.width + column - mask.x];
                if coverage == 0 {
                    continue;
                }
                let (row, i) = (line - y, column - x);
                let art = [0, 1, 2].map(|channel: usize| floor[channel][row][i]);
                let luminance = 0.2126 * art[0] + 0.7152 * art[1] + 0.0722 * art[2];
                let strength = f32::from(coverage) * (1.0 / 255.0) * self.remaining[row][i];
                for channel in 0..3 {
                    let through = 0.15 + 0.45 * luminance + 0.4 * art[channel];
                    self.picture[channel][row][i] = strength * through;
                }
            }
        }
    }
}

/// Darkens `out` where a ball hides the sky: a sphere, seen from the floor, hides the part `(r / s)^2 cos`, s being the
/// distance of its middle.
pub(crate) fn shade_contacts(stage: &Stage, rect: &TileRect, out: &mut RgbTile) {
    for ball in stage.scene.balls.iter().filter(|ball| touches(ball, rect)) {
        let from_tile = ball.center_mm - rect.middle_mm;
        shade_contact(
            stage.simd,
            stage.full_tile,
            [from_tile.x as f32, from_tile.y as f32, (ball.radius_mm + ball.lift_mm()) as f32],
            ball.radius_mm as f32,
            out,
        );
    }
}

multiversion! {
    fn shade_contact(pixels: &PackedSamples, middle: [f32; 3], radius: f32, out: &mut RgbTile) = shade_contact_lanes;
}

#[inline(always)]
fn shade_contact_lanes(pixels: &PackedSamples, [bx, by, bz]: [f32; 3], radius: f32, out: &mut RgbTile) {
    let [red, green, blue] = out;
    for row in 0..TILE {
        for i in 0..LANES {
            let (dx, dy) = (pixels.x[row][i] - bx, pixels.y[row][i] - by);
            let square = max(dx * dx + dy * dy + bz * bz, 1e-6);
            let hidden = radius * radius * bz / (square * square.sqrt());
            let open = 1.0 - 0.9 * hidden;
            red[row][i] *= open;
            green[row][i] *= open;
            blue[row][i] *= open;
        }
    }
}

/// Whether any ball stands so near that it darkens the tile.
pub(crate) fn has_contacts(stage: &Stage, rect: &TileRect) -> bool {
    stage.scene.balls.iter().any(|ball| touches(ball, rect))
}

fn touches(ball: &Ball, rect: &TileRect) -> bool {
    let reach = contact_mm(ball) + rect.radius_mm;
    ball.center_mm.distance_squared(rect.middle_mm) < reach * reach
}
