//! Colours and thicknesses as SVG says them: attributes, `style="..."`, and what is inherited.
//!
//! A `<style>` sheet is for art only.

use roxmltree::Node;
use std::str::FromStr;

/// What fills or strokes an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Paint {
    /// Nothing.
    None,
    /// One sRGB colour.
    Color([u8; 3]),
    /// A gradient or a pattern.
    Other,
}

impl Paint {
    /// Something is painted.
    pub fn is_painted(self) -> bool {
        self != Paint::None
    }
}

/// A property of an element itself: its `style` wins over its attribute.
pub(super) fn own_property<'a>(node: Node<'a, '_>, name: &str) -> Option<&'a str> {
    let declared = node.attribute("style").and_then(|style| {
        let declarations = style.split(';').filter_map(|declaration| declaration.split_once(':'));
        declarations.rev().find(|(key, _)| key.trim() == name).map(|(_, value)| value)
    });
    let value = declared.or_else(|| node.attribute(name))?;
    Some(value.trim().trim_end_matches("!important").trim_end())
}

/// A property of an element, or else of the nearest ancestor that has it.
pub(super) fn property<'a>(node: Node<'a, '_>, name: &str) -> Option<&'a str> {
    node.ancestors().find_map(|node| own_property(node, name).filter(|&value| value != "inherit"))
}

/// What fills an element: black when nobody says, as in SVG.
pub(super) fn fill(node: Node) -> Result<Paint, String> {
    property(node, "fill").map_or(Ok(Paint::Color([0; 3])), |text| paint(text, "fill"))
}

/// What strokes an element: nothing when nobody says, as in SVG.
pub(super) fn stroke(node: Node) -> Result<Paint, String> {
    property(node, "stroke").map_or(Ok(Paint::None), |text| paint(text, "stroke"))
}

fn paint(text: &str, name: &str) -> Result<Paint, String> {
    match text {
        "none" | "transparent" => Ok(Paint::None),
        _ if text.starts_with("url(") || text.starts_with("context-") || text == "currentColor" => Ok(Paint::Other),
        _ => color(text).map(Paint::Color).map_err(|why| format!("its {name} {why}")),
    }
}

/// A colour as CSS writes it.
pub(super) fn color(text: &str) -> Result<[u8; 3], String> {
    let color = svgtypes::Color::from_str(text.trim())
        .map_err(|_| format!("`{text}` is not a colour; write it as \"#rrggbb\""))?;
    Ok([color.red, color.green, color.blue])
}

/// The thickness of an element's line in its own units: 1 when nobody says, as in SVG.
pub(super) fn stroke_width(node: Node) -> Result<f64, String> {
    property(node, "stroke-width").map_or(Ok(1.0), |text| length(text, "stroke-width"))
}

/// A length in user units; `px` are user units.
pub(super) fn length(text: &str, name: &str) -> Result<f64, String> {
    let number = text.trim().trim_end_matches("px").trim_end();
    match number.parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        _ => Err(format!("its {name} `{text}` is not a plain number; one unit is one millimetre")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn with_first_shape<T>(svg: &str, look: impl Fn(Node) -> T) -> T {
        let document = roxmltree::Document::parse(svg).unwrap();
        look(document.descendants().find(|node| node.has_tag_name("line")).unwrap())
    }

    #[test]
    fn a_style_wins_over_an_attribute_and_both_over_an_ancestor() {
        let line = r##"<g stroke-width="9" fill="#010203"><line style="stroke: red; stroke-width : 4px" stroke="blue" stroke-width="5"/></g>"##;
        assert_eq!(with_first_shape(line, stroke), Ok(Paint::Color([255, 0, 0])));
        assert_eq!(with_first_shape(line, stroke_width), Ok(4.0));
        assert_eq!(with_first_shape(line, fill), Ok(Paint::Color([1, 2, 3])));
    }

    #[test]
    fn lengths_are_plain_millimetres() {
        assert!(length("3mm", "r").unwrap_err().contains("one unit is one millimetre"));
        assert!(length("nan", "r").is_err() && length("inf", "r").is_err() && length("1e999", "r").is_err());
    }

    #[test]
    fn a_gradient_is_paint_but_no_colour() {
        assert_eq!(paint("url(#glow)", "fill"), Ok(Paint::Other));
        assert_eq!(paint("#f80", "fill"), Ok(Paint::Color([255, 136, 0])));
        assert!(paint("#ff", "fill").is_err());
    }
}
