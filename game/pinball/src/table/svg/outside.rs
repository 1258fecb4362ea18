//! Outside: things that lie beside the playfield; of very many it is the playfield's size that is wrong.

use super::element::Element;
use super::page::rounded;
use crate::table::source::{Diagnostic, Source};
use geometry::{Bounds, DVec2};
use glam::Vec2Swizzles;

/// How far an element may reach beyond the playfield, mm.
const MARGIN_MM: f64 = 60.0;
/// So many things are told each by itself.
const FEW: usize = 4;

/// What lies outside a playfield of this size.
pub(super) fn mistakes(source: &Source, size_mm: DVec2, elements: &[Element]) -> Vec<Diagnostic> {
    let outside = outside(size_mm, elements);
    let one = |element: &Element| {
        let DVec2 { x, y } = element.outline.bounds().min;
        format!("{}: it lies outside the playfield, near {x:.0} {y:.0}", element.name)
    };
    if outside.len() <= FEW {
        return outside.iter().map(|element| source.diagnostic(element.at, one(element))).collect();
    }
    let what = format!(
        "{} (so do {} more things; the viewBox says that the playfield reaches from 0 0 to {} {} mm)",
        one(outside[0]),
        outside.len() - 1,
        rounded(size_mm.x),
        rounded(size_mm.y)
    );
    vec![source.diagnostic(outside[0].at, what)]
}

/// What is wrong with a playfield that what is drawn on it fits only when it is turned.
pub(super) fn turned(size_mm: DVec2, elements: &[Element]) -> Option<String> {
    let is_turned = outside(size_mm, elements).len() > FEW && outside(size_mm.yx(), elements).is_empty();
    let (width, height) = (rounded(size_mm.x), rounded(size_mm.y));
    is_turned.then(|| {
        format!(
            "the playfield is {width} x {height} mm, and what is drawn on it fits {height} x {width}; are the last two \
             numbers of the viewBox in the wrong order?"
        )
    })
}

fn outside(size_mm: DVec2, elements: &[Element]) -> Vec<&Element> {
    elements.iter().filter(|element| !is_inside(element, size_mm)).collect()
}

/// Whether an element lies on a playfield of this size, or reaches only a little beyond it.
fn is_inside(element: &Element, size_mm: DVec2) -> bool {
    let bounds = element.outline.bounds();
    let playfield = Bounds::of(DVec2::ZERO, size_mm);
    let grown = playfield.grown(MARGIN_MM);
    grown.contains(bounds.min) && grown.contains(bounds.max) && playfield.overlaps(&bounds)
}
