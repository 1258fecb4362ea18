//! From elements to lamps.

use super::config::Config;
use super::lamp::{Emitter, Lamp, LampKind};
use super::svg::element::Element;
use super::svg::element_class::ElementClass;
use super::svg::style::Paint;
use geometry::{Circle, DVec2};

/// The largest radius of a lamp and the longest half of a tube, mm: what is larger is no part of a table.
const MAX_LAMP_MM: f64 = 1000.0;

/// The lamp that an element is; `group_of` knows the group of the element with an id.
pub(super) fn lamp(element: &Element, config: &Config, group_of: impl Fn(&str) -> Option<u16>) -> Result<Lamp, String> {
    let number = |key| config.number(element.class, &element.name, key);
    let kind = match element.class {
        ElementClass::Lamp => {
            let inside = match element.data.get("inside") {
                Some(id) => Some(group_of(id).ok_or_else(|| format!("data-inside: no solid has the id `{id}`"))?),
                None => None,
            };
            let (center_mm, emitter) = form(element)?;
            let (height_mm, reach_mm) = (number("height_mm"), number("reach_mm"));
            LampKind::Bulb { center_mm, emitter, height_mm, reach_mm, inside }
        }
        _ => {
            let outlines_mm = element.outline.polygons().ok_or("an insert is drawn as closed outlines")?;
            LampKind::Insert { outlines_mm }
        }
    };
    Ok(Lamp { name: element.name.clone(), color: color(element)?, power: number("power"), kind })
}

/// The middle of a lamp, and what of it shines: a circle is a bulb, a line a tube.
fn form(element: &Element) -> Result<(DVec2, Emitter), String> {
    if let Some(Circle { center, radius }) = element.outline.circle() {
        return within("the radius", radius).map(|radius_mm| (center, Emitter::Disc { radius_mm }));
    }
    let line = element.outline.line().ok_or("a lamp is drawn as a circle (a bulb) or as one straight line (a tube)")?;
    let half_mm = line.along() * 0.5;
    let half_length = half_mm.length();
    if half_length < Emitter::LEAST_HALF_MM {
        return Err(format!("its line is {} mm long; draw a lamp as small as that as a circle", 2.0 * half_length));
    }
    within("half its length", half_length).map(|_| ((line.a + line.b) * 0.5, Emitter::Segment { half_mm }))
}

fn within(what: &str, size_mm: f64) -> Result<f64, String> {
    if size_mm <= MAX_LAMP_MM {
        Ok(size_mm)
    } else {
        Err(format!("{what} of a lamp must be at most {MAX_LAMP_MM} mm, and it is {size_mm:?} mm"))
    }
}

/// The colour of a lamp's light.
///
/// # Errors
/// If it is not one colour.
pub(super) fn color(element: &Element) -> Result<[u8; 3], String> {
    let word = light_word(element);
    match if word == "stroke" { element.stroke } else { element.fill } {
        Paint::Color(color) => Ok(color),
        _ => {
            let what = element.class.with_article();
            Err(format!("the {word} of {what} is its light; give it one colour, \"#rrggbb\""))
        }
    }
}

/// What says it: a tube shines in the colour of its line, everything else in that of its fill.
pub(super) fn light_word(element: &Element) -> &'static str {
    let is_tube = element.class == ElementClass::Lamp && element.outline.line().is_some();
    if is_tube { "stroke" } else { "fill" }
}
