//! A scene with more in it, to see how the cost of a picture grows: other numbers of lamps and balls, more posts.
//!
//! What is added stands where chance puts it, in the same places every time.

use super::SIZE_MM;
use crate::{Ball, Group, ItemId, Lamp, Occluder, Scene};
use geometry::Shape;
use geometry::rng::SplitMix64;

/// The radius of a post, mm.
const POST_MM: f64 = 2.0;

/// The radius of a ball, mm.
const BALL_MM: f64 = 13.5;

/// Leaves the first `count` lamps of the generated table; or adds copies of them, somewhere on it, until there are as
/// many. A scene without lamps stays without.
pub fn with_lamps(scene: &mut Scene, count: usize) {
    let mut random = SplitMix64::new(11);
    let first = scene.lamps.clone();
    let copies = (free_id(first.iter().map(|lamp| lamp.id))..).zip(first.iter().cycle());
    let more = copies.map(|(id, lamp)| Lamp { id: ItemId(id), center_mm: random.point_within(SIZE_MM), ..*lamp });
    scene.lamps = first.iter().copied().chain(more).take(count).collect();
}

/// Adds `count` posts of 2 mm to what stands there already.
pub fn with_posts(scene: &mut Scene, count: u16) {
    let mut random = SplitMix64::new(12);
    let free = free_id(scene.occluders.iter().map(|occluder| occluder.id));
    let post = |at: u16| {
        let shape = Shape::disc(random.point_within(SIZE_MM), POST_MM);
        Occluder::opaque(ItemId(free + u32::from(at)), shape, Group(2000 + at))
    };
    scene.occluders.extend((0..count).map(post));
}

/// Puts `count` balls somewhere, in place of those that are there.
pub fn with_balls(scene: &mut Scene, count: u16) {
    let mut random = SplitMix64::new(13);
    let groups: Vec<Group> = scene.balls.drain(..).map(|ball| ball.group).collect();
    scene.occluders.retain(|occluder| !groups.contains(&occluder.group));
    let free = free_id(scene.occluders.iter().map(|occluder| occluder.id));
    for at in 0..count {
        let (center_mm, group) = (random.point_within(SIZE_MM), Group(1000 + at));
        scene.balls.push(Ball {
            id: ItemId(at.into()),
            center_mm,
            radius_mm: BALL_MM,
            height_mm: 0.0,
            below: false,
            group,
            rotation: [0.0, 0.0, 0.0, 1.0],
        });
        let id = ItemId(free + u32::from(at));
        scene.occluders.push(Occluder::opaque(id, Shape::disc(center_mm, BALL_MM), group));
    }
}

/// Lifts the first balls to heights, mm, and takes away what casts the shadows of those that float.
pub fn lift(scene: &mut Scene, heights_mm: &[f64]) {
    for (ball, &height_mm) in scene.balls.iter_mut().zip(heights_mm) {
        ball.height_mm = height_mm;
    }
    let Scene { balls, occluders, .. } = scene;
    occluders.retain(|occluder| !balls.iter().any(|ball| ball.is_airborne() && ball.group == occluder.group));
}

/// The first number above all ids.
fn free_id(ids: impl Iterator<Item = ItemId>) -> u32 {
    ids.map(|id| id.0 + 1).max().unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::View;
    use crate::scenes;

    #[test]
    fn a_scene_has_as_much_in_it_as_was_asked_for() {
        let view = View::fit(16, 32, SIZE_MM);
        let props = scenes::props(&view);
        let table = scenes::table(view, &props);
        for count in [0, 4, 16, 64] {
            let mut scene = table.clone();
            with_lamps(&mut scene, count);
            let kept = count.min(table.lamps.len());
            assert_eq!((scene.lamps.len(), &scene.lamps[..kept]), (count, &table.lamps[..kept]));
        }
        for count in [0, 3, 12] {
            let mut scene = table.clone();
            with_posts(&mut scene, count);
            assert_eq!(scene.occluders.len(), table.occluders.len() + usize::from(count));
            let mut scene = table.clone();
            with_balls(&mut scene, count);
            assert_eq!(scene.balls.len(), usize::from(count));
            assert_eq!(scene.occluders.len(), table.occluders.len() - table.balls.len() + usize::from(count));
            let shadowed =
                |ball: &Ball| scene.occluders.iter().filter(|occluder| occluder.group == ball.group).count() == 1;
            assert!(scene.balls.iter().all(shadowed), "every ball has its own shadow");
        }
    }
}
