//! Shaded: lamps that stand in something that casts a shadow, so that nothing of their light comes out.

use super::source::{Diagnostic, Source};
use super::svg::drawing::Drawing;
use super::svg::element_class::ElementClass;
use super::{Lamp, LampKind, Solid};
use geometry::DVec2;
use physics::Part;

/// Warns of each such lamp; `lamps` are those of the drawing, in its order.
pub(super) fn warnings(
    source: &Source,
    drawing: &Drawing,
    parts: &[Part],
    lamps: &[Lamp],
    solids: &[Solid],
) -> Vec<Diagnostic> {
    let drawn = drawing.elements.iter().filter(|one| matches!(one.class, ElementClass::Lamp | ElementClass::Insert));
    let told = |(element, lamp): (&super::svg::drawing::Element, &Lamp)| {
        let LampKind::Bulb { center_mm, inside, .. } = &lamp.kind else { return None };
        let solid = solids.iter().find(|solid| Some(solid.group) != *inside && holds(solid, *center_mm))?;
        let around = &parts[usize::from(solid.part?.0)].name;
        let named = drawing.elements.iter().find(|one| one.name == *around)?;
        let what = format!(
            "{}: it stands in {around} of line {}, which lets none of its light out; draw it beside that, or write \
             data-inside=\"{around}\"",
            lamp.name,
            source.line(named.at)
        );
        Some(source.diagnostic(element.at, what).into_warning())
    };
    drawn.zip(lamps).filter_map(told).collect()
}

/// Whether a place is inside of a solid that casts a shadow.
fn holds(solid: &Solid, place: DVec2) -> bool {
    let is_in_line = || solid.shapes_mm.iter().any(|shape| shape.distance(place).0 < 0.0);
    solid.shadow
        && solid.part.is_some()
        && (is_in_line() || solid.plastic_mm.as_ref().is_some_and(|top| contains(top, place)))
}

/// Whether a polygon holds a place, by the rule of even and odd.
fn contains(polygon: &[DVec2], place: DVec2) -> bool {
    let next = polygon.iter().cycle().skip(1);
    let crossed = polygon.iter().zip(next).filter(|(a, b)| {
        let is_beside = (a.y > place.y) != (b.y > place.y);
        is_beside && place.x < a.x + (b.x - a.x) * (place.y - a.y) / (b.y - a.y)
    });
    crossed.count() % 2 == 1
}
