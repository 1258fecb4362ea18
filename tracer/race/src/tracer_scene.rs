//! The race as a scene of the tracer: the same circles, and a small disc lamp in each corner.

use crate::scene::{COLORS, POWER};
use crate::{SIDE, circles};
use geometry::{DVec2, Shape};
use tracer::scenes::white_view;
use tracer::{Emitter, Floor, Group, ItemId, Lamp, Occluder, Scene};

/// Millimetres in one unit of the race.
const MM_PER_UNIT: f64 = 100.0;

/// The lamps' radius, mm: enough for a penumbra that can be seen.
const LAMP_RADIUS_MM: f64 = 4.0;

/// How far the lamps are from the walls, mm.
const INSET_MM: f64 = 6.0;

/// The scene after `seconds`, in as many pixels as `floor` has.
pub fn tracer_scene<'a>(seconds: f64, floor: &'a Floor) -> Scene<'a> {
    let side = SIDE * MM_PER_UNIT;
    let corner = |at: usize| DVec2::new((at % 2) as f64, (at / 2) as f64) * (side - 2.0 * INSET_MM);
    let lamp = |(at, color): (usize, [f32; 3])| Lamp {
        id: ItemId(at as u32),
        center_mm: corner(at) + DVec2::splat(INSET_MM),
        emitter: Emitter::Disc { radius_mm: LAMP_RADIUS_MM },
        height_mm: 100.0,
        reach_mm: 1500.0,
        color: color.map(|channel| POWER * channel),
        inside: None,
    };
    let disc = |(group, circle): (u16, geometry::Circle)| {
        let shape = Shape::disc(circle.center * MM_PER_UNIT, circle.radius * MM_PER_UNIT);
        Occluder::opaque(ItemId(group.into()), shape, Group(group))
    };
    Scene {
        lamps: COLORS.into_iter().enumerate().map(lamp).collect(),
        occluders: (0..).zip(circles(seconds)).map(disc).collect(),
        ..white_view(floor, side / floor.width.max(1) as f64)
    }
}
