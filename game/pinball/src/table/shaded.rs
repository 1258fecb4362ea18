//! Shaded: lamps that stand in something that casts a shadow, so that nothing of their light comes out, and lamps that do not
//! stand in what they are said to stand in.

use super::source::{Diagnostic, Source};
use super::svg::drawing::Drawing;
use super::svg::element_class::ElementClass;
use super::{Lamp, LampKind, Solid, covered};
use geometry::DVec2;
use physics::Part;

/// A lamp whose middle is less outside of a thing may be meant to peep out of it, mm.
const LEAST_OUTSIDE_MM: f64 = 0.5;

/// Warns of each such lamp; `lamps` are those of the drawing, in its order.
pub(super) fn warnings(
    source: &Source,
    drawing: &Drawing,
    parts: &[Part],
    lamps: &[Lamp],
    solids: &[Solid],
) -> Vec<Diagnostic> {
    let drawn = drawing.elements.iter().filter(|one| matches!(one.class, ElementClass::Lamp | ElementClass::Insert));
    let told = |(element, lamp): (&super::svg::element::Element, &Lamp)| {
        let LampKind::Bulb { center_mm, inside, .. } = &lamp.kind else { return None };
        if let Some(id) = element.data.get("inside")
            && let Some(away_mm) = outside(solids, *inside, *center_mm)
        {
            let place = drawing.elements.iter().find(|one| one.name == *id)?;
            let what = format!(
                "{}: it has data-inside=\"{id}\", and stands {away_mm:.0} mm outside of {id} of line {}; draw it in there, or \
                 leave that out",
                lamp.name,
                source.line(place.at)
            );
            return Some(source.diagnostic(element.at, what).into_warning());
        }
        let solid = solids.iter().find(|solid| Some(solid.group) != *inside && holds(solid, *center_mm))?;
        let around = &parts[usize::from(solid.part?.0)].name;
        let named = drawing.elements.iter().find(|one| one.name == *around)?;
        // What covers most of the table is told by itself.
        if covered::lid(named, solid, drawing.page.size_mm).is_some() {
            return None;
        }
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

/// How far a place is outside of all solids of a group and of what they enclose, mm, if it is.
fn outside(solids: &[Solid], group: Option<u16>, place: DVec2) -> Option<f64> {
    let own: Vec<&Solid> = solids.iter().filter(|solid| Some(solid.group) == group).collect();
    let shapes = || own.iter().flat_map(|solid| &solid.shapes_mm);
    let is_on_top = own.iter().any(|solid| solid.has_top_over(place));
    let bounds = shapes().map(geometry::Shape::bounds).reduce(|all, one| all.union(one))?;
    // Lines may enclose it.
    let is_among = shapes().count() > 1 && place.cmpge(bounds.min).all() && place.cmple(bounds.max).all();
    let away_mm = shapes().map(|shape| shape.distance(place).0).fold(f64::INFINITY, f64::min);
    (!is_on_top && !is_among && away_mm >= LEAST_OUTSIDE_MM).then_some(away_mm)
}

/// Whether a place is inside of a solid that casts a shadow.
fn holds(solid: &Solid, place: DVec2) -> bool {
    let is_in_line = || solid.shapes_mm.iter().any(|shape| shape.distance(place).0 < 0.0);
    solid.shadow && solid.part.is_some() && (is_in_line() || solid.has_top_over(place))
}
