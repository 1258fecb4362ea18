//! A scene with more in it, to see how the cost of a picture grows: other numbers of lamps and balls, more posts.
//!
//! What is added stands where chance puts it, in the same places every time.

use super::{Random, SIZE_MM};
use crate::{Ball, Group, Lamp, Occluder, Scene};
use geometry::Shape;

/// The radius of a post, mm.
const POST_MM: f64 = 2.0;

/// The radius of a ball, mm.
const BALL_MM: f64 = 13.5;

/// Leaves the first `count` lamps of the generated table; or adds copies of them, somewhere on it, until there are as
/// many. A scene without lamps stays without.
pub fn with_lamps(scene: &mut Scene, count: usize) {
    let mut random = Random(11);
    let first = scene.lamps.clone();
    let more = first.iter().cycle().map(|lamp| Lamp { center_mm: random.within(SIZE_MM), ..*lamp });
    scene.lamps = first.iter().copied().chain(more).take(count).collect();
}

/// Adds `count` posts of 2 mm to what stands there already.
pub fn with_posts(scene: &mut Scene, count: u16) {
    let mut random = Random(12);
    let post = |at| Occluder { shape: Shape::disc(random.within(SIZE_MM), POST_MM), group: Group(2000 + at) };
    scene.occluders.extend((0..count).map(post));
}

/// Puts `count` balls somewhere, in place of those that are there.
pub fn with_balls(scene: &mut Scene, count: u16) {
    let mut random = Random(13);
    let groups: Vec<Group> = scene.balls.drain(..).map(|ball| ball.group).collect();
    scene.occluders.retain(|occluder| !groups.contains(&occluder.group));
    for at in 0..count {
        let (center_mm, group) = (random.within(SIZE_MM), Group(1000 + at));
        scene.balls.push(Ball { center_mm, radius_mm: BALL_MM, group, rotation: [0.0, 0.0, 0.0, 1.0] });
        scene.occluders.push(Occluder { shape: Shape::disc(center_mm, BALL_MM), group });
    }
}
