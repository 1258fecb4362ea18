//! One element of the table in a drawing: where it is, how thick and of which colour.

use super::css;
use super::element_class::ElementClass;
use super::outline::Outline;
use super::path_flattening::Curves;
use super::style::{self, Paint};
use super::transform::Transform;
use roxmltree::Node;
use std::collections::BTreeMap;

/// Properties of CSS that place and shape an element.
const PLACES: [&str; 15] = [
    "transform",
    "transform-origin",
    "translate",
    "rotate",
    "scale",
    "x",
    "y",
    "cx",
    "cy",
    "r",
    "rx",
    "ry",
    "width",
    "height",
    "d",
];

/// One element of the table.
#[derive(Clone, Debug)]
pub(in crate::table) struct Element {
    pub class: ElementClass,
    /// Its id, or a name that no id can be.
    pub name: String,
    /// The byte at which its element begins.
    pub at: usize,
    pub outline: Outline,
    /// Of its line, mm.
    pub thickness_mm: f64,
    pub fill: Paint,
    pub stroke: Paint,
    /// Whether its drawing says that it is not to be seen.
    pub is_hidden: bool,
    /// Whether its drawing says that nothing of it is opaque.
    pub is_clear: bool,
    /// The group that it belongs to.
    pub group: Option<String>,
    /// Its `data-` attributes.
    pub data: BTreeMap<String, String>,
}

impl Element {
    /// What an XML element draws with this transform, as a thing of this class and name; its `data-` attributes are still to come.
    pub fn read(node: Node, class: ElementClass, name: &str, transform: Transform) -> Result<Element, String> {
        check_place(node)?;
        let scale = transform.scale()?;
        let thickness_mm = style::stroke_width(node)? * scale;
        if !(0.0..=1000.0).contains(&thickness_mm) {
            return Err(format!("its line is {thickness_mm} mm thick; it must be from 0 to 1000 mm"));
        }
        let group = node.ancestors().find_map(|node| node.attribute("data-group"));
        let is_unlit = |paint: &str| style::property(node, paint).is_some_and(is_nothing);
        let is_unlit = match class {
            ElementClass::Insert => is_unlit("fill-opacity"),
            ElementClass::Lamp => is_unlit(if node.has_tag_name("line") { "stroke-opacity" } else { "fill-opacity" }),
            _ => false,
        };
        Ok(Element {
            class,
            name: name.to_string(),
            at: node.range().start,
            outline: Outline::of(node, transform, scale, Curves::Chords)?,
            thickness_mm,
            fill: style::fill(node)?,
            stroke: style::stroke(node)?,
            is_hidden: matches!(style::property(node, "visibility"), Some("hidden" | "collapse")),
            is_clear: is_unlit
                || node.ancestors().any(|node| style::own_property(node, "opacity").is_some_and(is_nothing)),
            group: group.map(str::to_string),
            data: BTreeMap::new(),
        })
    }

    /// Half of its line's thickness, mm.
    pub fn radius_mm(&self) -> f64 {
        self.thickness_mm * 0.5
    }

    /// The colour that it is drawn in: of its line, or of its inside.
    pub fn color(&self) -> Option<[u8; 3]> {
        [self.stroke, self.fill].into_iter().find_map(|paint| match paint {
            Paint::Color(color) => Some(color),
            _ => None,
        })
    }
}

/// Whether an opacity is none.
fn is_nothing(opacity: &str) -> bool {
    opacity.trim_end_matches('%').parse::<f64>().is_ok_and(|opacity| opacity <= 0.0)
}

/// Whether plain attributes say where and how large an element is, and not its style, which only a browser would follow.
///
/// # Errors
/// If its style, or one around it, says so.
pub(super) fn check_place(node: Node) -> Result<(), String> {
    let inside = node.ancestors().filter(|outer| outer.parent_element().is_some());
    let declared = inside.flat_map(|outer| {
        let style = css::style_declarations(outer.attribute("style").unwrap_or("")).map(|(name, _)| name);
        style.chain(outer.has_attribute("transform-origin").then_some("transform-origin"))
    });
    match declared.into_iter().find(|name| PLACES.contains(name)) {
        Some(property) => {
            Err(format!("its style, or one around it, sets `{property}`; say with plain attributes where it is"))
        }
        None => Ok(()),
    }
}
