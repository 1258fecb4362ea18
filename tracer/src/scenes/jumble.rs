//! Shapes of every kind, thrown among a few lamps.

use super::white_view;
use crate::{Ball, Emitter, Floor, Group, ItemId, Lamp, Occluder, Scene};
use geometry::rng::SplitMix64;
use geometry::{Arc, Circle, Core, DVec2, Shape, Taper, trig};

/// How many occluders a jumble has.
const SHAPES: u16 = 14;

/// Three disc lamps and occluders of every kind thrown in among them: some overlap, some hold a lamp. It is as large as
/// `floor`, 1 mm a pixel.
pub fn jumble<'a>(seed: u64, floor: &'a Floor) -> Scene<'a> {
    let mut random = SplitMix64::new(seed);
    let size = DVec2::new(floor.width as f64, floor.height as f64);
    let lamps = (0..3).map(|id| Lamp { id: ItemId(id), ..disc(&mut random, size) }).collect();
    let occluders = shapes(&mut random, size);
    Scene { lamps, occluders, ..white_view(floor, 1.0) }
}

/// As [`jumble`], with two tubes beside two discs, one lamp inside a wall, and one in a wall of its own
/// group.
pub fn mixed_jumble<'a>(seed: u64, floor: &'a Floor) -> Scene<'a> {
    let mut random = SplitMix64::new(seed ^ 0x5eed_0f1a);
    let size = DVec2::new(floor.width as f64, floor.height as f64);
    let mut lamps = vec![disc(&mut random, size), disc(&mut random, size), tube(&mut random, size)];
    lamps.push(tube(&mut random, size));
    (0..).zip(&mut lamps).for_each(|(id, lamp)| lamp.id = ItemId(id));
    let mut occluders = shapes(&mut random, size);
    for (lamp, group) in [(0, 100), (2, 101)] {
        let at = lamps[lamp].center_mm;
        let shape = Shape::capsule(at - DVec2::X * 4.0, at + DVec2::X * random.uniform(0.0, 9.0), 3.0);
        occluders.push(Occluder::opaque(ItemId(group.into()), shape, Group(group)));
    }
    lamps[2].inside = Some(Group(101));
    Scene { lamps, occluders, ..white_view(floor, 1.0) }
}

/// As [`mixed_jumble`], with three balls in the air: far below most lamps, among them, and often above some.
pub fn floating_jumble<'a>(seed: u64, floor: &'a Floor) -> Scene<'a> {
    let mut scene = mixed_jumble(seed, floor);
    let mut random = SplitMix64::new(seed ^ 0xf10a_7b41);
    let size = DVec2::new(floor.width as f64, floor.height as f64);
    for (group, most_mm) in [(200, 8.0), (201, 20.0), (202, 40.0)] {
        let (center_mm, radius_mm) = (random.point_within(size), random.uniform(2.0, 13.5));
        let height_mm = random.uniform(0.2, most_mm);
        scene.balls.push(Ball {
            id: ItemId(group.into()),
            center_mm,
            radius_mm,
            height_mm,
            below: false,
            group: Group(group),
            rotation: [0.0, 0.0, 0.0, 1.0],
        });
    }
    scene
}

fn disc(random: &mut SplitMix64, size: DVec2) -> Lamp {
    Lamp {
        id: ItemId(0),
        center_mm: random.point_within(size * 1.2) - size * 0.1,
        emitter: Emitter::Disc { radius_mm: random.uniform(2.0, 9.0) },
        height_mm: random.uniform(20.0, 40.0),
        reach_mm: random.uniform(90.0, 260.0),
        color: [0.1; 3],
        inside: None,
    }
}

/// Every third lies along an axis of the picture, so that points lie on its very line.
fn tube(random: &mut SplitMix64, size: DVec2) -> Lamp {
    let upright = random.unit() < 1.0 / 3.0;
    let angle = if upright { 0.0 } else { random.uniform(0.0, std::f64::consts::TAU) };
    let half_mm = trig::direction(angle) * random.uniform(1.0, 45.0);
    let lamp = disc(random, size);
    let middle = lamp.center_mm;
    let center_mm = if upright { middle.floor() + DVec2::splat(0.5) } else { middle };
    Lamp { center_mm, emitter: Emitter::Tube { half_mm }, ..lamp }
}

fn shapes(random: &mut SplitMix64, size: DVec2) -> Vec<Occluder> {
    (0..SHAPES)
        .map(|group| Occluder::opaque(ItemId(group.into()), any_shape(random, size, group), Group(group)))
        .collect()
}

/// A disc, a capsule, an arc or a taper, by `kind` modulo 4, somewhere in a rectangle from the origin to `size`.
pub fn any_shape(random: &mut SplitMix64, size: DVec2, kind: u16) -> Shape {
    let at = random.point_within(size);
    let angle = random.uniform(0.0, std::f64::consts::TAU);
    let other = at + trig::direction(angle) * random.uniform(5.0, 60.0);
    let radius = random.uniform(0.3, 4.0);
    match kind % 4 {
        0 => Shape::disc(at, random.uniform(0.5, 12.0)),
        1 => Shape::capsule(at, other, radius),
        2 => {
            let circle = Circle { center: at, radius: random.uniform(5.0, 50.0) };
            Shape { core: Core::Arc(Arc::new(circle, angle, random.uniform(0.3, 6.0))), radius }
        }
        _ => {
            let a = Circle { center: at, radius: random.uniform(3.0, 9.0) };
            let b = Circle { center: other, radius: random.uniform(1.0, 5.0) };
            Shape { core: Core::Taper(Taper { a, b }), radius: 0.5 }
        }
    }
}
