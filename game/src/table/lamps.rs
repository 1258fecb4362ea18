//! Lamps above the floor and lit windows in it.

use super::class::Class;
use super::drawing::Thing;
use super::numbers::Numbers;
use super::style::Paint;
use super::{Lamp, LampKind};

/// The lamp that a thing is; `group_of` knows the group of the thing with an id.
pub(super) fn lamp(thing: &Thing, numbers: &Numbers, group_of: impl Fn(&str) -> Option<u16>) -> Result<Lamp, String> {
    let Paint::Color(color) = thing.fill else {
        return Err(format!("the fill of a {} is its light; give it one colour, \"#rrggbb\"", thing.class.word()));
    };
    let number = |key| numbers.number(thing.class, &thing.name, key);
    let kind = match thing.class {
        Class::Lamp => {
            let circle = thing.outline.circle().ok_or("a lamp is drawn as a circle")?;
            let inside = match thing.data.get("inside") {
                Some(id) => Some(group_of(id).ok_or_else(|| format!("data-inside: no solid has the id `{id}`"))?),
                None => None,
            };
            LampKind::Bulb {
                center_mm: circle.center,
                radius_mm: circle.radius,
                height_mm: number("height_mm"),
                reach_mm: number("reach_mm"),
                inside,
            }
        }
        _ => {
            let outlines_mm = thing.outline.polygons().ok_or("an insert is drawn as closed outlines")?;
            LampKind::Insert { outlines_mm }
        }
    };
    Ok(Lamp { name: thing.name.clone(), color, power: number("power"), kind })
}
