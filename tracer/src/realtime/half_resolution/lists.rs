//! The scenes of the half renderer's images: copies of parts of the caller's scene, in lists that are kept from frame to
//! frame, so that nothing is allocated once they are long enough.

use crate::{Ball, Glow, Lamp, Occluder, Outline, Overhang, Scene, Top};
use std::mem::take;

/// The lists of a scene.
#[derive(Default)]
pub(super) struct Lists {
    lamps: Vec<Lamp>,
    occluders: Vec<Occluder>,
    overhangs: Vec<Overhang>,
    tops: Vec<Top>,
    balls: Vec<Ball>,
    /// Empty between pictures.
    glows: Vec<Glow<'static>>,
}

impl Lists {
    /// A scene of the surfaces of another, and of what shines from them, in the dark. It has these lists.
    pub fn surfaces_of<'a>(&mut self, scene: &Scene<'a>) -> Scene<'a> {
        let (mut tops, mut glows) = (take(&mut self.tops), emptied(take(&mut self.glows)));
        copy_tops(&scene.tops, &mut tops);
        glows.extend_from_slice(&scene.glows);
        let mut part = Scene {
            view: scene.view,
            lamps: take(&mut self.lamps),
            occluders: take(&mut self.occluders),
            overhangs: take(&mut self.overhangs),
            tops,
            balls: take(&mut self.balls),
            glows,
            floor: scene.floor,
            half_floor: None,
            ambient: [0.0; 3],
        };
        part.lamps.clear();
        part.occluders.clear();
        part.overhangs.clear();
        part.balls.clear();
        part
    }

    /// Takes the lists of a scene.
    pub fn of(scene: Scene) -> Lists {
        let Scene { lamps, occluders, overhangs, tops, balls, glows, .. } = scene;
        Lists { lamps, occluders, overhangs, tops, balls, glows: emptied(glows) }
    }
}

/// Adds to a scene of surfaces what lights them and what is in the way.
pub(super) fn add_lamps<'a>(scene: &Scene<'a>, part: &mut Scene<'a>) {
    part.lamps.extend_from_slice(&scene.lamps);
    part.occluders.extend_from_slice(&scene.occluders);
    part.overhangs.extend_from_slice(&scene.overhangs);
    part.balls.extend_from_slice(&scene.balls);
    part.ambient = scene.ambient;
}

/// Makes `copies` the same as `tops`: an outline that is there already is not copied again.
fn copy_tops(tops: &[Top], copies: &mut Vec<Top>) {
    copies.truncate(tops.len());
    for (copy, top) in copies.iter_mut().zip(tops) {
        match (&mut copy.outline, &top.outline) {
            (Outline::Polygon(copy), Outline::Polygon(corners)) => copy.clone_from(corners),
            (copy, outline) => copy.clone_from(outline),
        }
        (copy.id, copy.group, copy.finish) = (top.id, top.group, top.finish);
    }
    let known = copies.len();
    copies.extend_from_slice(&tops[known..]);
}

/// An empty list in the place of another one, whatever that one's items borrowed.
fn emptied<'a>(mut list: Vec<Glow<'_>>) -> Vec<Glow<'a>> {
    list.clear();
    // Collected in place: the standard library keeps the memory where items are of one size.
    list.into_iter().map_while(|_| None).collect()
}
