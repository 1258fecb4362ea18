//! Scene validation: what a scene may say: sizes that single precision can tell apart and that a table may have, and
//! numbers that are numbers.
//!
//! What says anything else is not drawn: it gives no light, casts no shadow, has no top. [`Scene::check`] says what that
//! would be.
//!
//! What is drawn simpler than it is: occluders are columns that never end, so a lamp's height changes no shadow of theirs.
//! Only a ball that floats ([`Ball::is_airborne`]) has a height, and is a sphere. What is below it is taken to be floor, tops
//! too; itself it is lit, and mirrors, as if it lay on the floor. The part of a lamp that it hides and the part that others
//! hide are multiplied, as if neither knew of the other: where both hide some of it, that is wrong by a quarter of the lamp
//! at the worst. A ball that takes off exchanges the shadow of a column for that of a sphere, which may end.

use crate::scene::id::Item;
use crate::{
    Ball, Emitter, Finish, Glow, Group, ItemId, Lamp, Material, Occluder, Outline, Profile, Rgb, Scene, Top, View,
};
use geometry::{Core, DVec2, Shape, Taper};
use std::collections::{BTreeMap, BTreeSet};
use std::iter::once;

/// The farthest that anything may be from the origin across or down, mm.
pub const FARTHEST_MM: f64 = 1e7;

/// The largest radius, half of a lamp, height or reach, mm.
pub const LARGEST_MM: f64 = 1e5;

/// The brightest colour.
const BRIGHTEST: f32 = 1e9;

/// The most pixels of a view across or down, and in all.
const MOST_PIXELS: (usize, usize) = (1 << 15, 1 << 28);

/// The least and the most millimetres a pixel.
const MM_PER_PX: std::ops::RangeInclusive<f64> = 1e-4..=1e4;

impl Scene<'_> {
    /// Whether all of the scene is drawn.
    ///
    /// # Errors
    /// One sentence about the first thing that is not.
    pub fn check(&self) -> Result<(), String> {
        self.check_in(&mut CheckScratch::default())
    }

    /// [`Scene::check`], with room to work in.
    pub(crate) fn check_in(&self, CheckScratch { ids, tinted }: &mut CheckScratch) -> Result<(), String> {
        fn first<T>(what: &str, things: &[T], wrong: impl Fn(&T) -> Option<&'static str>) -> Option<String> {
            let mut found = things.iter().enumerate().filter_map(|(at, thing)| wrong(thing).map(|why| (at, why)));
            found.next().map(|(at, why)| format!("{what} {at} {why}"))
        }
        let wrong = wrong_with_view(&self.view)
            .map(|why| format!("the view {why}"))
            .or_else(|| first("lamp", &self.lamps, wrong_with_lamp))
            .or_else(|| first("occluder", &self.occluders, wrong_with_occluder))
            .or_else(|| first("top", &self.tops, wrong_with_top))
            .or_else(|| first("ball", &self.balls, wrong_with_ball))
            .or_else(|| first("glow", &self.glows, |glow: &Glow| wrong_with_glow(glow)))
            .or_else(|| wrong_with_color(&self.ambient).map(|why| format!("the ambient light {why}")))
            .or_else(|| repeated("lamp", &self.lamps, ids))
            .or_else(|| repeated("occluder", &self.occluders, ids))
            .or_else(|| repeated("top", &self.tops, ids))
            .or_else(|| repeated("ball", &self.balls, ids))
            .or_else(|| repeated("glow", &self.glows, ids))
            .or_else(|| mixed(&self.occluders, tinted));
        wrong.map_or(Ok(()), Err)
    }

    /// The scene without what is not drawn; the view is as it was.
    pub(crate) fn drawable(&self) -> Self {
        let mut scene = self.clone();
        scene.lamps.retain(|lamp| wrong_with_lamp(lamp).is_none());
        scene.occluders.retain(|occluder| wrong_with_occluder(occluder).is_none());
        scene.tops.retain(|top| wrong_with_top(top).is_none());
        scene.balls.retain(|ball| wrong_with_ball(ball).is_none());
        scene.glows.retain(|glow| wrong_with_glow(glow).is_none());
        if wrong_with_color(&scene.ambient).is_some() {
            scene.ambient = [0.0; 3];
        }
        leave_first(&mut scene.lamps);
        leave_first(&mut scene.occluders);
        leave_first(&mut scene.tops);
        leave_first(&mut scene.balls);
        leave_first(&mut scene.glows);
        let mut materials = BTreeMap::new();
        scene.occluders.retain(|occluder| is_like_its_group(occluder, &mut materials));
        scene
    }
}

/// Room to check a scene in; kept from frame to frame, so that nothing is allocated once it is warm.
#[derive(Clone, Debug, Default)]
pub(crate) struct CheckScratch {
    ids: Vec<ItemId>,
    tinted: Vec<(Group, Rgb)>,
}

/// A sentence about the first occluder that is not of the material of the first one of its group. Most scenes have few
/// groups that are not opaque, so only those are looked up.
fn mixed(occluders: &[Occluder], tinted: &mut Vec<(Group, Rgb)>) -> Option<String> {
    tinted.clear();
    tinted.extend(occluders.iter().filter_map(|occluder| Some((occluder.group, occluder.material.transmittance()?))));
    tinted.sort_unstable_by_key(|tinted| tinted.0);
    let two_tints = tinted.windows(2).any(|two| two[0].0 == two[1].0 && two[0].1 != two[1].1);
    let is_tinted = |group: &Group| tinted.binary_search_by_key(group, |tinted| tinted.0).is_ok();
    let is_opaque = |occluder: &&Occluder| occluder.material.transmittance().is_none();
    let two_materials = || occluders.iter().filter(is_opaque).any(|occluder| is_tinted(&occluder.group));
    if tinted.is_empty() || !two_tints && !two_materials() {
        return None;
    }
    let mut materials = BTreeMap::new();
    let at = occluders.iter().position(|occluder| !is_like_its_group(occluder, &mut materials))?;
    Some(format!("occluder {at} must be of the material of the others of its group"))
}

/// Whether an occluder is of the material of the first one of its group; `materials` are those of the groups so far.
fn is_like_its_group(occluder: &Occluder, materials: &mut BTreeMap<Group, Material>) -> bool {
    *materials.entry(occluder.group).or_insert(occluder.material) == occluder.material
}

/// A sentence about the first item with the id of one before it. Ids that rise need no more than one look at each.
fn repeated<T: Item>(what: &str, items: &[T], ids: &mut Vec<ItemId>) -> Option<String> {
    if items.is_sorted_by(|a, b| a.id() < b.id()) {
        return None;
    }
    ids.clear();
    ids.extend(items.iter().map(Item::id));
    ids.sort_unstable();
    let twice = ids.windows(2).any(|two| two[0] == two[1]);
    let mut seen = BTreeSet::new();
    let at = twice.then(|| items.iter().position(|item| !seen.insert(item.id()))).flatten()?;
    Some(format!("{what} {at} must have an id of its own"))
}

/// Leaves out every item with the id of one before it.
fn leave_first<T: Item>(items: &mut Vec<T>) {
    let mut seen = BTreeSet::new();
    items.retain(|item| seen.insert(item.id()));
}

fn within(value: f64, most: f64) -> bool {
    value.abs() <= most
}

fn is_place(place: DVec2) -> bool {
    within(place.x, FARTHEST_MM) && within(place.y, FARTHEST_MM)
}

pub(crate) fn wrong_with_view(view: &View) -> Option<&'static str> {
    let pixels = view.width.checked_mul(view.height).is_some_and(|pixels| pixels <= MOST_PIXELS.1);
    if !pixels || view.width > MOST_PIXELS.0 || view.height > MOST_PIXELS.0 {
        return Some("has too many pixels; ask for at most 32768 across and down, and 268 million in all");
    }
    let size = DVec2::new(view.width as f64, view.height as f64) * view.mm_per_px;
    let right = MM_PER_PX.contains(&view.mm_per_px) && is_place(view.origin_mm) && is_place(view.origin_mm + size);
    (!right).then_some("must lie within 10 km of the origin, at 0.0001 to 10,000 mm a pixel")
}

pub(crate) fn wrong_with_lamp(lamp: &Lamp) -> Option<&'static str> {
    let size = match lamp.emitter {
        Emitter::Disc { radius_mm } => radius_mm,
        Emitter::Tube { half_mm } => half_mm.length(),
    };
    if !is_place(lamp.center_mm) {
        Some("must be within 10 km of the origin")
    } else if !(within(size, LARGEST_MM) && within(lamp.height_mm, LARGEST_MM)) {
        Some("must be at most 100 m large and high")
    } else if !(lamp.reach_mm > 0.0 && within(lamp.reach_mm, LARGEST_MM)) {
        Some("must reach more than 0 and at most 100 m")
    } else {
        wrong_with_color(&lamp.color)
    }
}

pub(crate) fn wrong_with_shape(shape: &Shape) -> Option<&'static str> {
    let (places, sizes) = match &shape.core {
        Core::Point(center) => ([*center; 2], [0.0; 2]),
        Core::Segment(line) => ([line.a, line.b], [0.0; 2]),
        Core::Taper(Taper { a, b }) => ([a.center, b.center], [a.radius, b.radius]),
        Core::Arc(arc) => {
            // An arc of an angle that is no number has no ends.
            let ends = arc.ends().iter().all(|end| end.is_finite());
            ([arc.circle().center; 2], [arc.circle().radius, if ends { 0.0 } else { f64::NAN }])
        }
    };
    if !places.into_iter().all(is_place) {
        return Some("must be within 10 km of the origin");
    }
    let right = sizes.into_iter().chain(once(shape.radius)).all(|size| within(size, LARGEST_MM));
    (!right).then_some("must have radii of at most 100 m")
}

fn wrong_with_top(top: &Top) -> Option<&'static str> {
    let Finish { profile, gloss, opacity, translucency, albedo, emission, .. } = top.finish;
    let bevel = if let Profile::Bevel(width_mm) = profile { width_mm } else { 0.0 };
    if ![gloss, opacity, translucency, bevel].iter().all(|&number| within(f64::from(number), LARGEST_MM)) {
        return Some("must have a finish of sensible numbers");
    }
    let outline = match &top.outline {
        Outline::Shape(shape) => wrong_with_shape(shape),
        Outline::Polygon(corners) if corners.iter().all(|&corner| is_place(corner)) => None,
        Outline::Polygon(_) => Some("must have its corners within 10 km of the origin"),
    };
    outline.or_else(|| wrong_with_color(&albedo)).or_else(|| wrong_with_color(&emission))
}

fn wrong_with_occluder(occluder: &Occluder) -> Option<&'static str> {
    wrong_with_shape(&occluder.shape).or_else(|| wrong_with_material(&occluder.material))
}

fn wrong_with_material(material: &Material) -> Option<&'static str> {
    let right = match material {
        Material::Opaque => true,
        Material::Tinted { transmittance } => transmittance.iter().all(|channel| (0.0..=1.0).contains(channel)),
    };
    (!right).then_some("must let pass from 0 to 1 of each colour")
}

pub(crate) fn wrong_with_ball(ball: &Ball) -> Option<&'static str> {
    let turns = ball.rotation.iter().all(|&part| within(f64::from(part), 2.0));
    if !within(ball.height_mm, LARGEST_MM) {
        return Some("must be at most 100 m high");
    }
    let right = is_place(ball.center_mm) && ball.radius_mm > 0.0 && within(ball.radius_mm, LARGEST_MM) && turns;
    (!right)
        .then_some("must be within 10 km of the origin, of a radius over 0 and at most 100 m, turned by a quaternion")
}

fn wrong_with_glow(glow: &Glow) -> Option<&'static str> {
    let mask = glow.mask;
    let fits = [mask.x, mask.y, mask.width].iter().all(|&pixels| pixels <= MOST_PIXELS.1);
    if fits { wrong_with_color(&glow.color) } else { Some("must have a mask of at most 268 million pixels") }
}

fn wrong_with_color(color: &Rgb) -> Option<&'static str> {
    let right = color.iter().all(|channel| (0.0..=BRIGHTEST).contains(channel));
    (!right).then_some("must have a colour of numbers from 0 to a billion")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Group, scenes};

    #[test]
    fn what_is_not_drawn_is_said_in_one_sentence() {
        let floor = scenes::white(8, 8);
        let mut scene = scenes::mixed_jumble(1, &floor);
        assert_eq!(scene.check(), Ok(()));
        scene.occluders[3].shape.radius = f64::NAN;
        assert_eq!(scene.check().unwrap_err(), "occluder 3 must have radii of at most 100 m");
        scene.lamps[1].reach_mm = 0.0;
        assert_eq!(scene.check().unwrap_err(), "lamp 1 must reach more than 0 and at most 100 m");
        assert_eq!(scene.drawable().check(), Ok(()));
        for tint in [f32::NAN, -0.1, 1.1] {
            let mut scene = scenes::mixed_jumble(1, &floor);
            scene.occluders[2].material = Material::Tinted { transmittance: [0.5, tint, 0.5] };
            assert_eq!(scene.check().unwrap_err(), "occluder 2 must let pass from 0 to 1 of each colour");
            assert_eq!(scene.drawable().occluders.len(), scene.occluders.len() - 1);
        }
        scene.view.mm_per_px = 0.0;
        assert!(scene.check().unwrap_err().starts_with("the view must lie within 10 km"));
    }

    #[test]
    fn a_group_is_of_one_material() {
        let floor = scenes::white(8, 8);
        let scene = |tints: [f32; 3]| {
            let mut scene = scenes::mixed_jumble(1, &floor);
            for (occluder, tint) in scene.occluders[4..].iter_mut().zip(tints) {
                occluder.group = Group(50);
                occluder.material = match tint {
                    0.0 => Material::Opaque,
                    tint => Material::Tinted { transmittance: [tint; 3] },
                };
            }
            scene
        };
        for (tints, other) in [([0.0, 0.5, 0.5], 5), ([0.5, 0.0, 0.5], 5), ([0.5, 0.5, 0.25], 6), ([0.0, 0.0, 0.5], 6)]
        {
            let scene = scene(tints);
            let expected = format!("occluder {other} must be of the material of the others of its group");
            assert_eq!(scene.check(), Err(expected));
            assert_eq!(scene.drawable().check(), Ok(()));
        }
        for tints in [[0.0; 3], [0.5; 3]] {
            assert_eq!(scene(tints).check(), Ok(()));
        }
    }

    #[test]
    fn an_id_names_one_item_of_a_kind() {
        let view = View::fit(16, 32, scenes::SIZE_MM);
        let props = scenes::props(&view);
        let mut scene = scenes::table(view, &props);
        scene.lamps.reverse();
        scene.tops.rotate_left(3);
        assert_eq!(scene.check(), Ok(()), "ids may come in any order");
        let whole = scene.drawable();
        let refused = |change: &dyn Fn(&mut Scene)| {
            let mut scene = scene.clone();
            change(&mut scene);
            let left = scene.drawable();
            assert_eq!(left.check(), Ok(()));
            let count = |scene: &Scene| scene.lamps.len() + scene.occluders.len() + scene.tops.len();
            let all = |scene: &Scene| count(scene) + scene.balls.len() + scene.glows.len();
            assert_eq!(all(&left) + 1, all(&whole), "one item is left out");
            scene.check().unwrap_err()
        };
        let said = [
            refused(&|scene| scene.lamps[5].id = scene.lamps[2].id),
            refused(&|scene| scene.occluders[7].id = scene.occluders[9].id),
            refused(&|scene| scene.tops[4].id = scene.tops[0].id),
            refused(&|scene| scene.balls[2].id = scene.balls[1].id),
            refused(&|scene| scene.glows[6].id = scene.glows[0].id),
        ];
        let expected = ["lamp 5", "occluder 9", "top 4", "ball 2", "glow 6"];
        assert_eq!(said, expected.map(|item| format!("{item} must have an id of its own")));
    }
}
