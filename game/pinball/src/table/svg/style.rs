//! Colours and thicknesses as SVG says them: attributes, `style="..."`, and what is inherited.
//!
//! Refuses to know sheets: they are written out before.

use super::{color, css, page};
use roxmltree::Node;

/// What fills or strokes an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::table) enum Paint {
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
pub(in crate::table) fn own_property<'a>(node: Node<'a, '_>, name: &str) -> Option<&'a str> {
    let style = node.attribute("style").unwrap_or("");
    let declared = css::style_declarations(style).rev().find(|(key, _)| *key == name).map(|(_, value)| value);
    declared.or_else(|| node.attribute(name)).map(str::trim)
}

/// A property of an element, or else of the nearest ancestor that has it.
pub(in crate::table) fn property<'a>(node: Node<'a, '_>, name: &str) -> Option<&'a str> {
    node.ancestors().find_map(|node| own_property(node, name).filter(|&value| value != "inherit"))
}

/// What fills an element: black when nobody says, as in SVG.
pub(in crate::table) fn fill(node: Node) -> Result<Paint, String> {
    property(node, "fill").map_or(Ok(Paint::Color([0; 3])), |text| paint(node, text, "fill"))
}

/// What strokes an element: nothing when nobody says, as in SVG.
pub(in crate::table) fn stroke(node: Node) -> Result<Paint, String> {
    property(node, "stroke").map_or(Ok(Paint::None), |text| paint(node, text, "stroke"))
}

fn paint(node: Node, text: &str, name: &str) -> Result<Paint, String> {
    let text = if text == "currentColor" { property(node, "color").unwrap_or("black") } else { text };
    match text {
        "none" | "transparent" => Ok(Paint::None),
        _ if text.starts_with("url(") || text.starts_with("context-") => Ok(Paint::Other),
        _ => color(text).map(Paint::Color).map_err(|why| format!("its {name} {why}")),
    }
}

/// A colour as CSS writes it.
pub(in crate::table) fn color(text: &str) -> Result<[u8; 3], String> {
    let color = color::parse(text).ok_or_else(|| format!("`{text}` is not a colour; write it as \"#rrggbb\""))?;
    let [red, green, blue, _] = color;
    Ok([red, green, blue])
}

/// The thickness of an element's line in its own units: 1 when nobody says, as in SVG.
pub(in crate::table) fn stroke_width(node: Node) -> Result<f64, String> {
    property(node, "stroke-width").map_or(Ok(1.0), |text| length(node, text, "stroke-width"))
}

/// A length of an element in user units; `px` are user units.
pub(in crate::table) fn length(node: Node, text: &str, name: &str) -> Result<f64, String> {
    let text = text.trim();
    let start = text.len().saturating_sub(2);
    let pixels = text.get(start..).is_some_and(|unit| unit.eq_ignore_ascii_case("px"));
    let number = if pixels { text[..start].trim_end() } else { text };
    match number.parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        _ => Err(format!("its {name} `{text}` is not a plain number; {}", page::unit(node))),
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
        let of = |svg: &str, text: &str| with_first_shape(svg, |line| length(line, text, "r"));
        let (plain, wide) = (
            "<g><line/></g>",
            format!(
                "<svg xmlns=\"{}\" width=\"50mm\" viewBox=\"0 0 200 400\"><g xmlns=\"\"><line/></g></svg>",
                page::SVG
            ),
        );
        assert!(of(plain, "3mm").unwrap_err().ends_with("`3mm` is not a plain number; one unit is one millimetre"));
        assert!(of(&wide, "3mm").unwrap_err().ends_with("; a unit of this drawing is 0.25 mm"));
        assert!(of(plain, "nan").is_err() && of(plain, "inf").is_err() && of(plain, "1e999").is_err());
    }

    #[test]
    fn a_gradient_is_paint_but_no_colour() {
        let filled =
            |fill: &str| with_first_shape(&format!(r##"<g color="#123"><line fill="{fill}"/></g>"##), super::fill);
        assert_eq!(filled("url(#glow)"), Ok(Paint::Other));
        assert_eq!(filled("#f80"), Ok(Paint::Color([255, 136, 0])));
        assert_eq!(filled("currentColor"), Ok(Paint::Color([0x11, 0x22, 0x33])));
        assert!(filled("#ff").is_err());
    }
}
