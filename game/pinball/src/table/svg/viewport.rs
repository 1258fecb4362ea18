//! Viewports inside a drawing: how an `<svg>` or a `<symbol>` lays its contents out (SVG 2, 8.2 and 8.6).

use super::style;
use geometry::DVec2;
use roxmltree::Node;
use std::str::FromStr;
use svgtypes::{Align, AspectRatio, ViewBox};

/// The transform of what is in an `<svg>` or a `<symbol>`, as an attribute writes it; `user` is the `<use>` that draws
/// it, whose width and height come before its own.
///
/// # Errors
/// If a length is no plain number.
pub(in crate::table) fn transform(node: Node, user: Option<Node>) -> Result<String, String> {
    let number = |name: &str| node.attribute(name).map_or(Ok(0.0), |text| style::length(node, text, name));
    let [x, y] = if node.has_tag_name((super::page::SVG, "svg")) { [number("x")?, number("y")?] } else { [0.0; 2] };
    let moved = if x == 0.0 && y == 0.0 { String::new() } else { format!("translate({x} {y})") };
    let Some(view_box) = node.attribute("viewBox").and_then(|text| ViewBox::from_str(text).ok()) else {
        return Ok(moved);
    };
    let aspect = node.attribute("preserveAspectRatio").and_then(|text| AspectRatio::from_str(text).ok());
    let size = size(node, user)?;
    Ok(format!("{moved} {}", fitted(view_box, aspect, size)).trim_start().to_string())
}

/// Width and height of a viewport, in the units around it.
fn size(node: Node, user: Option<Node>) -> Result<DVec2, String> {
    let around = around(user.unwrap_or(node))?;
    let side = |name: &str, all: f64| {
        let text = user.and_then(|user| user.attribute(name)).or_else(|| node.attribute(name)).unwrap_or("auto").trim();
        match text.strip_suffix('%') {
            _ if text == "auto" => Ok(all),
            Some(share) => style::length(node, share, name).map(|share| 0.01 * share * all),
            None => style::length(node, text, name),
        }
    };
    Ok(DVec2::new(side("width", around.x)?, side("height", around.y)?))
}

/// Width and height of the viewport around an element, in its inner units.
fn around(node: Node) -> Result<DVec2, String> {
    let Some(outer) = node.ancestors().skip(1).find(|outer| outer.has_tag_name((super::page::SVG, "svg"))) else {
        return Ok(DVec2::ZERO);
    };
    match outer.attribute("viewBox").and_then(|text| ViewBox::from_str(text).ok()) {
        Some(view_box) => Ok(DVec2::new(view_box.w, view_box.h)),
        None => size(outer, None),
    }
}

fn fitted(view_box: ViewBox, aspect: Option<AspectRatio>, size: DVec2) -> String {
    let each = size / DVec2::new(view_box.w, view_box.h);
    let align = aspect.map_or(Align::XMidYMid, |aspect| aspect.align);
    let slice = aspect.is_some_and(|aspect| aspect.slice);
    let one = if slice { each.max_element() } else { each.min_element() };
    let (scale, share) = match align {
        Align::None => (each, DVec2::ZERO),
        Align::XMinYMin => (DVec2::splat(one), DVec2::new(0.0, 0.0)),
        Align::XMidYMin => (DVec2::splat(one), DVec2::new(0.5, 0.0)),
        Align::XMaxYMin => (DVec2::splat(one), DVec2::new(1.0, 0.0)),
        Align::XMinYMid => (DVec2::splat(one), DVec2::new(0.0, 0.5)),
        Align::XMidYMid => (DVec2::splat(one), DVec2::new(0.5, 0.5)),
        Align::XMaxYMid => (DVec2::splat(one), DVec2::new(1.0, 0.5)),
        Align::XMinYMax => (DVec2::splat(one), DVec2::new(0.0, 1.0)),
        Align::XMidYMax => (DVec2::splat(one), DVec2::new(0.5, 1.0)),
        Align::XMaxYMax => (DVec2::splat(one), DVec2::new(1.0, 1.0)),
    };
    let left = (size - DVec2::new(view_box.w, view_box.h) * scale) * share;
    let shift = left - DVec2::new(view_box.x, view_box.y) * scale;
    format!("translate({} {}) scale({} {})", shift.x, shift.y, scale.x, scale.y)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(inner: &str) -> String {
        let svg = format!(r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 500 1000">{inner}</svg>"#);
        let document = roxmltree::Document::parse(&svg).unwrap();
        transform(document.root_element().first_element_child().unwrap(), None).unwrap()
    }

    #[test]
    fn a_view_box_is_fitted_as_the_aspect_ratio_says() {
        assert_eq!(of("<svg/>"), "");
        assert_eq!(of(r#"<svg x="3" y="4"/>"#), "translate(3 4)");
        let wide = |rest: &str| of(&format!(r#"<svg width="100" height="50" viewBox="10 0 10 10" {rest}/>"#));
        assert_eq!(wide(""), "translate(-25 0) scale(5 5)");
        assert_eq!(wide(r#"preserveAspectRatio="xMinYMin""#), "translate(-50 0) scale(5 5)");
        assert_eq!(wide(r#"preserveAspectRatio="xMaxYMax slice""#), "translate(-100 -50) scale(10 10)");
        assert_eq!(wide(r#"preserveAspectRatio="none""#), "translate(-100 0) scale(10 5)");
        assert_eq!(of(r#"<svg viewBox="0 0 250 500"/>"#), "translate(0 0) scale(2 2)");
        assert_eq!(of(r#"<svg width="50%" height="50%" viewBox="0 0 250 500"/>"#), "translate(0 0) scale(1 1)");
    }
}
