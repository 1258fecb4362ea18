//! Shapes and texts of the art that a reader of SVG draws otherwise than they are written, or not at all. Of things the same is
//! a mistake, and told elsewhere.

use super::css;
use super::drawing::{is_thing, meant_as_thing};
use super::moved::around;
use super::page::SVG;
use super::path_data;
use crate::table::source::{Diagnostic, Source};
use roxmltree::{Document, Node};
use std::str::FromStr;
use svgtypes::LengthUnit;

/// Pixels of a screen in a millimetre, as CSS has them.
const PIXELS_PER_MM: f64 = 96.0 / 25.4;
/// A length that is off by no more than this part is as it is written.
const MAX_OFF: f64 = 0.02;

/// Lengths that are read of each shape.
fn lengths(element: &str) -> &'static [&'static str] {
    match element {
        "line" => &["x1", "y1", "x2", "y2"],
        "circle" => &["cx", "cy", "r"],
        "ellipse" => &["cx", "cy", "rx", "ry"],
        "rect" => &["x", "y", "width", "height", "rx", "ry"],
        _ => &[],
    }
}

/// Warns of each shape and text of the art that cannot be read; `style_of` knows what is declared for an element.
pub fn warnings<'d>(
    source: &Source,
    document: &Document,
    style_of: impl Fn(Node) -> Option<&'d str>,
) -> Vec<Diagnostic> {
    let art = document
        .descendants()
        .filter(|node| node.tag_name().namespace() == Some(SVG) && !is_thing(*node) && !meant_as_thing(*node));
    let told = art.filter_map(|node| {
        let said = |node: Node, property: &str| {
            let style = style_of(node).or_else(|| node.attribute("style")).unwrap_or("");
            let mut declared = css::style_declarations(style).rev();
            let declared = declared.find(|(name, _)| *name == property).map(|(_, value)| value);
            declared.or_else(|| node.attribute(property)).map(|value| value.trim().to_string())
        };
        Some(source.diagnostic(node.range().start, unread(node, said)?).into_warning())
    });
    told.collect()
}

/// What of an element is not read.
fn unread(node: Node, said: impl Fn(Node, &str) -> Option<String>) -> Option<String> {
    let name = node.tag_name().name();
    match name {
        "path" => {
            let why = path_data::unread(node.attribute("d")?)?;
            Some(format!("of this path: {why}; it is drawn as far as it is read"))
        }
        "polyline" | "polygon" => {
            let text = node.attribute("points")?;
            let words: Vec<&str> = text.split([' ', ',', '\n', '\r', '\t']).filter(|word| !word.is_empty()).collect();
            // Numbers may stand close together: `1-2`.
            let numbers: Result<Vec<f64>, _> = svgtypes::NumberListParser::from(text).collect();
            let is_read = numbers.is_ok_and(|numbers| numbers.len() % 2 == 0);
            (!is_read && !words.is_empty()).then(|| {
                format!("the `points` of this {name} must be pairs of numbers, and they are not: what cannot be read is not drawn")
            })
        }
        "text" | "tspan" => text(node, name, said),
        _ => lengths(name).iter().find_map(|length| wrong_length(node, name, length)),
    }
}

fn wrong_length(node: Node, name: &str, length: &str) -> Option<String> {
    let text = node.attribute(length)?;
    let is_size = matches!(length, "r" | "rx" | "ry" | "width" | "height");
    match svgtypes::Length::from_str(text.trim()) {
        _ if text.trim() == "auto" && matches!(length, "rx" | "ry") => None,
        Ok(read) if read.number < 0.0 && is_size => Some(format!(
            "the {length} of this {name} is {text}, so it is not drawn as it is meant; no size is less than 0"
        )),
        Ok(read) => wrong_unit(node, read).map(|what| format!("the {length} of this {name} is `{text}`: {what}")),
        Err(_) => Some(format!("the {length} of this {name} is `{text}`, which is no number, so it is not read")),
    }
}

/// What a length with a unit comes to where that is another length on the table: SVG takes a millimetre for as many units as a
/// screen has pixels in one.
fn wrong_unit(node: Node, read: svgtypes::Length) -> Option<String> {
    let mm = match read.unit {
        LengthUnit::Mm => 1.0,
        LengthUnit::Cm => 10.0,
        LengthUnit::In => 25.4,
        LengthUnit::Pt => 25.4 / 72.0,
        LengthUnit::Pc => 25.4 / 6.0,
        _ => return None,
    };
    let own = around(node).and_then(|outer| outer.transformed(node.attribute("transform").unwrap_or("")));
    let scale = own.and_then(|own| own.scale()).ok()?;
    let units = read.number * mm * PIXELS_PER_MM;
    let (meant, is) = (read.number * mm, units * scale);
    let is_other = (is - meant).abs() > MAX_OFF * meant.abs();
    is_other.then(|| {
        format!("SVG makes {units:.1} units of that, which are {is:.1} mm here; write a number without a unit")
    })
}

/// What of a text is not read, as `said` of an element and a property.
fn text(node: Node, name: &str, said: impl Fn(Node, &str) -> Option<String>) -> Option<String> {
    let known = ["start", "middle", "end", "inherit", "initial", "unset", "revert"];
    if let Some(anchor) = said(node, "text-anchor").filter(|anchor| !known.contains(&anchor.as_str())) {
        return Some(format!(
            "the text-anchor of this {name} is `{anchor}`, which is not read; write start, middle or end"
        ));
    }
    let is_letters = |child: Node| child.is_text() && child.text().is_some_and(|text| !text.trim().is_empty());
    if !node.children().any(is_letters) {
        return None;
    }
    let size = node.ancestors().find_map(|outer| said(outer, "font-size"))?;
    let is_nothing = svgtypes::Length::from_str(&size).is_ok_and(|size| size.number <= 0.0);
    is_nothing.then(|| format!("the font-size of this {name} is {size}, so nobody sees it; write the letters' size"))
}
