//! A tile in the light of one lamp: what stands between them, how much of the lamp each point sees, and what its surfaces
//! make of that.

use crate::cone::Cone;
use crate::falloff::Falloff;
use crate::gaze::Gaze;
use crate::irradiance::{DARKNESS, Light, light_floor, light_top, paint_floor};
use crate::lanes::{LANES, Lanes, Path};
use crate::layer::TopLayer;
use crate::obstruction::Verdict;
use crate::place::Place;
use crate::points::{Points, TILE};
use crate::tile::{Lit, Stage, Workspace};
use crate::{Group, Rgb, filter};

/// What a lamp lights of a tile.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Lighted {
    /// Nothing.
    Dark,
    /// Bare floor, and nothing of its light is tinted.
    Floor,
    /// Anything.
    Colors,
}

impl Workspace {
    /// Puts the tile in the light of one lamp, of the colour white, into [`Workspace::picture`], or if it is all floor,
    /// into [`Workspace::arriving`] and [`Workspace::shine`].
    pub(crate) fn light(&mut self, stage: &Stage, at: usize, place: &Place, layers: usize) -> Lighted {
        self.look_at(stage, at, place);
        let near = &self.near[at];
        let met = filter::met(&stage.scene.filters, |group| near.casts(group));
        if met.as_slice().is_empty() {
            if layers == 0 {
                let lit = self.light_floor_past(stage, at, place, &[]);
                return if lit { Lighted::Floor } else { Lighted::Dark };
            }
            let lit = self.light_past(stage, at, place, layers, &[]);
            return if lit { Lighted::Colors } else { Lighted::Dark };
        }
        let mut lit = false;
        self.sum = DARKNESS;
        filter::each_set(met.as_slice(), |away, part| {
            if part != [0.0; 3] && self.light_past(stage, at, place, layers, away) {
                lit = true;
                add(&self.picture, part, &mut self.sum);
            }
        });
        self.picture = self.sum;
        // What hides the lamp with every filter away is more than one group can be blamed for.
        self.between.hidden_by = None;
        if lit { Lighted::Colors } else { Lighted::Dark }
    }

    /// Puts the floor in a lamp's light, past everything but some groups, into [`Workspace::arriving`] and
    /// [`Workspace::shine`]; says whether there is any.
    fn light_floor_past(&mut self, stage: &Stage, at: usize, place: &Place, away: &[Group]) -> bool {
        let verdict = self.sees(stage, at, place, None, away);
        if verdict == Verdict::Dark {
            return false;
        }
        let beam = Falloff::new(&stage.lamps[at].lamp, place.middle_mm);
        let points = if self.whole { stage.whole_tile } else { &self.floor };
        let fraction = if verdict == Verdict::Lit { &ALL } else { &self.fraction };
        let (arriving, shine) = (&mut self.arriving, &mut self.shine);
        light_floor(stage.path, points, &self.ground, beam, fraction, stage.scene.floor.gloss, arriving, shine);
        true
    }

    /// Puts the whole floor's picture, of what arrives and of what shines, into [`Workspace::picture`].
    pub(crate) fn paint(&mut self, path: Path) {
        paint_floor(path, TILE, &self.ground.albedo, &self.arriving, &self.shine, &mut self.picture);
    }

    /// [`Workspace::light`], past everything but some groups.
    fn light_past(&mut self, stage: &Stage, at: usize, place: &Place, layers: usize, away: &[Group]) -> bool {
        let beam = Falloff::new(&stage.lamps[at].lamp, place.middle_mm);
        let mut lit = false;
        if (self.whole || self.floor.count > 0) && self.light_floor_past(stage, at, place, away) {
            lit = true;
            if self.whole {
                self.paint(stage.path);
            } else {
                let (blocks, albedo) = (self.floor.blocks(), &self.ground.albedo);
                paint_floor(stage.path, blocks, albedo, &self.arriving, &self.shine, &mut self.packed);
                self.picture = DARKNESS;
                scatter(&self.floor, &self.packed, &mut self.picture);
            }
        }
        for layer in 0..layers {
            let verdict = self.sees(stage, at, place, Some(layer), away);
            if verdict == Verdict::Dark {
                continue;
            }
            if !lit {
                lit = true;
                self.picture = DARKNESS;
            }
            let TopLayer { form, points, surface } = &self.tops[layer];
            let finish = &stage.scene.tops[*form].finish;
            let fraction = if verdict == Verdict::Lit { &ALL } else { &self.fraction };
            light_top(stage.path, points, surface, finish, beam, fraction, &mut self.packed);
            scatter(points, &self.packed, &mut self.picture);
        }
        lit
    }

    /// Finds what may stand between a lamp and the tile.
    fn look_at(&mut self, stage: &Stage, at: usize, place: &Place) {
        let Lit { lamp, candidates, .. } = &stage.lamps[at];
        let near = &mut self.near[at];
        if !self.is_near[at] {
            let around = Cone::new(lamp, self.block.0, self.block.1);
            candidates.narrow(stage.path, &around, near, Some((lamp, stage.silhouettes)));
            self.is_near[at] = true;
        }
        near.classify(stage.path, &Cone::new(lamp, place.middle_mm, place.radius_mm));
    }

    /// Finds how much of a lamp that was looked at each point of the floor or of a top sees, past everything but some
    /// groups and the top's own.
    fn sees(&mut self, stage: &Stage, at: usize, place: &Place, layer: Option<usize>, away: &[Group]) -> Verdict {
        let floor = if self.whole { stage.whole_tile } else { &self.floor };
        let mut without = [Group(0); filter::MOST + 1];
        without[..away.len()].copy_from_slice(away);
        let mut count = away.len();
        let points = layer.map_or(floor, |layer| {
            let TopLayer { form, points, .. } = &self.tops[layer];
            without[count] = stage.scene.tops[*form].group;
            count += 1;
            points
        });
        let mut gaze = Gaze {
            stage,
            near: &self.near[at],
            lamp: &stage.lamps[at].lamp,
            middle: place.middle_mm,
            corner: (place.x, place.y),
            between: &mut self.between,
            room: &mut self.room,
            fraction: &mut self.fraction,
        };
        gaze.sees(points, &without[..count])
    }
}

/// Adds a picture in light of a colour.
pub(crate) fn add(picture: &Light, color: Rgb, sum: &mut Light) {
    for ((sum, picture), color) in sum.iter_mut().zip(picture).zip(color) {
        for (sum, line) in sum.iter_mut().zip(picture) {
            for i in 0..LANES {
                sum[i] += line[i] * color;
            }
        }
    }
}

/// Adds the light of packed points to the pixels that they are.
pub(crate) fn scatter(points: &Points, packed: &Light, picture: &mut Light) {
    for (plane, packed) in picture.iter_mut().zip(packed) {
        for (at, &pixel) in points.pixel[..points.count].iter().enumerate() {
            let pixel = usize::from(pixel);
            plane[pixel / LANES][pixel % LANES] += packed[at / LANES][at % LANES];
        }
    }
}

/// All of a lamp, for every point.
static ALL: [Lanes; TILE] = [[1.0; LANES]; TILE];
