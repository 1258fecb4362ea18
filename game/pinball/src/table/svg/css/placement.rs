//! Placement by CSS: where a `style` or a sheet puts art, how large it makes it and how it writes its letters. A browser obeys
//! it, and the art's rasteriser reads attributes only. Of things it is a mistake, and told elsewhere.

use super::declarations::Declaration;
use super::grammar;
use crate::table::source::{Diagnostic, Source};
use crate::table::svg::drawing::is_thing;
use roxmltree::Node;
use std::collections::BTreeMap;
use std::str::FromStr;
use svgtypes::{Transform, TransformListParser, TransformListToken};

/// Shapes that a property of CSS places or shapes, as their attribute of the same name does.
const GEOMETRY: [(&str, &[&str]); 9] = [
    ("x", &["rect", "use", "svg", "image"]),
    ("y", &["rect", "use", "svg", "image"]),
    ("width", &["rect", "svg", "image"]),
    ("height", &["rect", "svg", "image"]),
    ("cx", &["circle", "ellipse"]),
    ("cy", &["circle", "ellipse"]),
    ("r", &["circle"]),
    ("rx", &["rect", "ellipse"]),
    ("ry", &["rect", "ellipse"]),
];
/// Values that change nothing.
const IDLE: [&str; 14] = [
    "none",
    "auto",
    "normal",
    "inherit",
    "initial",
    "unset",
    "revert",
    "revert-layer",
    "0",
    "1",
    "100%",
    "0px",
    "0deg",
    "view-box",
];

/// Declarations that are not obeyed: by the sheet's line, or else by where the element begins, and by property and value.
#[derive(Debug, Default)]
pub(super) struct Placements {
    found: BTreeMap<(Option<usize>, usize, String, String), Found>,
}

/// The first element that a declaration is for.
#[derive(Debug)]
struct Found {
    element: String,
    at: usize,
    instead: String,
}

impl Placements {
    /// Looks at what is declared for an element.
    pub fn look(&mut self, node: Node, declared: &[Declaration]) {
        if is_thing(node) || node.parent_element().is_none() {
            return;
        }
        let said = |name: &str| declared.iter().any(|one| one.name == name && !is_idle(&one.value));
        // What is no value at all is told as that.
        let is_value = |one: &&Declaration| !is_idle(&one.value) && grammar::mistake(&one.name, &one.value).is_none();
        for one in declared.iter().filter(is_value) {
            // A turn about the middle is told as the turn.
            let Some(instead) = instead(node, one, said("transform")) else { continue };
            // Of what is around things each of them tells it.
            if node.descendants().any(is_thing) {
                continue;
            }
            let (at, element) = (node.range().start, node.tag_name().name().to_string());
            let key =
                (one.sheet_line, if one.sheet_line.is_some() { 0 } else { at }, one.name.clone(), one.value.clone());
            self.found.entry(key).or_insert(Found { element, at, instead });
        }
    }

    /// Warns of each.
    pub fn warnings(&self, source: &Source) -> Vec<Diagnostic> {
        let told = self.found.iter().map(|((sheet_line, _, name, value), Found { element, at, instead })| {
            let own = source.line(*at);
            let whose = match sheet_line {
                Some(_) => format!("this sheet says `{name}: {value}` of the {element} of line {own}"),
                None => format!("the style of this {element} says `{name}: {value}`"),
            };
            let what = format!("{whose}: a browser obeys that, and a table's picture does not; {instead}");
            source.diagnostic_in_line(sheet_line.unwrap_or(own), what).into_warning()
        });
        told.collect()
    }
}

fn is_idle(value: &str) -> bool {
    IDLE.contains(&value.trim().to_ascii_lowercase().as_str())
}

/// What to write instead of a declaration that is not obeyed, if it is one.
fn instead(node: Node, Declaration { name, value, .. }: &Declaration, is_transformed: bool) -> Option<String> {
    let element = node.tag_name().name();
    if GEOMETRY.iter().any(|(own, elements)| own == name && elements.contains(&element)) {
        let number = value.trim_end_matches(|unit: char| unit.is_ascii_alphabetic());
        let same =
            node.attribute(name.as_str()).and_then(|text| text.trim().trim_end_matches("px").parse::<f64>().ok());
        let plain = number
            .parse::<f64>()
            .ok()
            .filter(|_| number == value || value.eq_ignore_ascii_case(&format!("{number}px")));
        if plain.is_some() && same == plain {
            return None;
        }
        let number = plain.map_or("NUMBER", |_| number);
        return Some(format!("write the attribute {name}=\"{number}\""));
    }
    let turned =
        "write what it does into the attribute `transform`, as translate(x y), rotate(degrees x y) and scale(factor)";
    match &**name {
        "d" if element == "path" => Some("write it into the attribute `d`".to_string()),
        "transform" if !is_read_alike(value) => Some(match attribute(value) {
            Some(attribute) if !is_turned_elsewhere(node) => format!("write the attribute transform=\"{attribute}\""),
            _ => turned.to_string(),
        }),
        "transform-box" if !is_transformed && node.has_attribute("transform") => Some(turned.to_string()),
        "transform-origin" if !is_transformed && node.has_attribute("transform") => {
            svgtypes::TransformOrigin::from_str(value).is_err().then(|| turned.to_string())
        }
        "rotate" | "translate" | "scale" => Some(turned.to_string()),
        "offset" | "offset-path" | "motion-path" | "perspective" | "zoom" => {
            Some("leave it out, and draw the art where and as large as it is to be".to_string())
        }
        "text-transform" => Some("write the letters themselves as they are to be seen".to_string()),
        _ => None,
    }
}

/// Whether a style of the element says what its transform turns about.
fn is_turned_elsewhere(node: Node) -> bool {
    node.attribute("style").is_some_and(|style| style.contains("transform-origin") || style.contains("transform-box"))
}

/// Whether a browser and the rasteriser find the same transform in a style: neither has units, and nothing needs one.
fn is_read_alike(value: &str) -> bool {
    let needs_unit = |token| match token {
        TransformListToken::Translate { tx, ty } => tx != 0.0 || ty != 0.0,
        TransformListToken::Rotate { angle }
        | TransformListToken::SkewX { angle }
        | TransformListToken::SkewY { angle } => angle != 0.0,
        TransformListToken::Matrix { .. } | TransformListToken::Scale { .. } => false,
    };
    Transform::from_str(value).is_ok() && TransformListParser::from(value).flatten().all(|token| !needs_unit(token))
}

/// The same transform as an attribute has it, if it only has to lose its units.
fn attribute(value: &str) -> Option<String> {
    let plain = value.to_ascii_lowercase().replace("px", "").replace("deg", "").replace("translatex", "translate");
    Transform::from_str(&plain).is_ok().then_some(plain)
}
