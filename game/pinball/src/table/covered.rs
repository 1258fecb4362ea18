//! Covered: inserts that lie wholly under what lets nothing through, or in each other's place, and walls that were filled by
//! mistake and cover the table.

use super::source::{Diagnostic, Source};
use super::svg::drawing::Drawing;
use super::svg::element::Element;
use super::svg::element_class::ElementClass;
use super::svg::outline::Outline;
use super::{Finish, Solid};
use geometry::DVec2;
use physics::Part;

/// A wall that is filled over more than this part of the playfield is filled by mistake.
const LEAST_LID: f64 = 0.5;
/// What peeps out of a wall by no more than this is no light that anybody sees, mm.
const MAX_RIM_MM: f64 = 1.2;
/// Outlines that are nowhere farther from each other than this are one and the same, mm.
const SAME_MM: f64 = 0.5;

/// Warns of lids, and of inserts that nobody sees.
pub(super) fn warnings(source: &Source, drawing: &Drawing, parts: &[Part], solids: &[Solid]) -> Vec<Diagnostic> {
    let tops: Vec<(&Element, &Solid)> =
        solids.iter().filter_map(|solid| Some((element(solid, drawing, parts)?, solid))).collect();
    let lids = tops.iter().filter_map(|(element, solid)| {
        let percent = 100.0 * lid(element, solid, drawing.page.size_mm)?;
        let what = format!(
            "{}: it is filled, so its top lies over {percent:.0} % of the playfield and hides what is there; write \
             fill=\"none\"",
            element.name
        );
        Some(source.diagnostic(element.at, what))
    });
    let inserts: Vec<&Element> = drawing.elements.iter().filter(|one| one.class == ElementClass::Insert).collect();
    let hidden = inserts.iter().filter_map(|insert| {
        let hides = |(top, solid): &&(&Element, &Solid)| {
            hides(top, &solid.finish)
                && lid(top, solid, drawing.page.size_mm).is_none()
                && covers(solid, &insert.outline)
        };
        let (top, _) = tops.iter().find(hides)?;
        let what = format!(
            "{}: it lies wholly under {} of line {}, so nobody sees it; draw it beside that",
            insert.name,
            top.name,
            source.line(top.at)
        );
        Some(source.diagnostic(insert.at, what))
    });
    let twice = inserts.iter().enumerate().filter_map(|(index, insert)| {
        let first = inserts[..index].iter().find(|first| is_same(&first.outline, &insert.outline))?;
        let what = format!(
            "{}: it lies exactly where {} of line {} does, so both look like one; move it, or take one of them out",
            insert.name,
            first.name,
            source.line(first.at)
        );
        Some(source.diagnostic(insert.at, what))
    });
    lids.chain(hidden).chain(twice).map(Diagnostic::into_warning).collect()
}

/// The element that a solid is drawn as.
fn element<'d>(solid: &Solid, drawing: &'d Drawing, parts: &[Part]) -> Option<&'d Element> {
    let name = solid.part.map(|part| &parts[usize::from(part.0)].name);
    drawing.elements.iter().find(|element| match name {
        Some(name) => element.name == *name,
        None => element.class == ElementClass::Plastic && is_drawn_as(solid, &element.outline),
    })
}

/// Whether a plastic has this outline.
fn is_drawn_as(solid: &Solid, outline: &Outline) -> bool {
    match (outline, &solid.plastic_mm) {
        (Outline::Circle(circle), None) => solid.shapes_mm == [geometry::Shape::disc(circle.center, circle.radius)],
        (Outline::Subpaths(subpaths), Some(top)) => subpaths.first().is_some_and(|subpath| subpath.polygon == *top),
        _ => false,
    }
}

/// The part of the playfield that is under what stands there and was filled, if that is most of it.
pub(super) fn lid(element: &Element, solid: &Solid, size_mm: DVec2) -> Option<f64> {
    let top = solid.plastic_mm.as_ref().filter(|_| element.class.is_static())?;
    let next = top.iter().cycle().skip(1);
    let twice: f64 = top.iter().zip(next).map(|(a, b)| a.perp_dot(*b)).sum();
    let part = twice.abs() * 0.5 / (size_mm.x * size_mm.y);
    (part > LEAST_LID).then(|| part.min(1.0))
}

/// Whether what lies under this is never seen: it does not move, stands on the floor or lies above it, and is opaque.
fn hides(element: &Element, finish: &Finish) -> bool {
    let moves = matches!(
        element.class,
        ElementClass::Flipper
            | ElementClass::Diverter
            | ElementClass::DropTarget
            | ElementClass::Gate
            | ElementClass::Spinner
    );
    !moves && !element.class.is_elevated() && finish.opacity >= 1.0 && finish.translucency <= 0.0
}

/// Whether all of an outline lies under a solid.
fn covers(solid: &Solid, outline: &Outline) -> bool {
    let is_under = |place: DVec2| {
        solid.shapes_mm.iter().any(|shape| shape.distance(place).0 <= MAX_RIM_MM) || solid.has_top_over(place)
    };
    let Some(polygons) = outline.polygons() else { return false };
    let bounds = outline.bounds();
    let middle = (bounds.min + bounds.max) * 0.5;
    let is_mostly_under = bounds.size().min_element() > 2.0 * MAX_RIM_MM;
    is_mostly_under
        && is_under(middle)
        && polygons.iter().all(|polygon| {
            let next = polygon.iter().cycle().skip(1);
            polygon.iter().zip(next).all(|(a, b)| is_under(*a) && is_under((*a + *b) * 0.5))
        })
}

/// Whether two outlines are one and the same.
fn is_same(one: &Outline, other: &Outline) -> bool {
    let (Some(one), Some(other)) = (one.polygons(), other.polygons()) else { return false };
    let near = |a: &DVec2, b: &DVec2| a.distance(*b) <= SAME_MM;
    let same = |a: &Vec<DVec2>, b: &Vec<DVec2>| a.len() == b.len() && a.iter().zip(b).all(|(a, b)| near(a, b));
    one.len() == other.len() && one.iter().zip(&other).all(|(a, b)| same(a, b))
}
