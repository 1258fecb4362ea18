//! Ids of a drawing: what each of them is.

use super::element_class::ElementClass;
use super::style;
use crate::table::source::Source;
use roxmltree::{Document, Node};
use std::collections::{BTreeMap, BTreeSet};

/// The ids of a drawing's things.
#[derive(Debug, Default)]
pub(in crate::table) struct Ids {
    /// The class of each, and the line that took it.
    things: BTreeMap<String, (ElementClass, usize)>,
    /// Those of things that were refused, and those that were given twice: a mistake in them has been told, and what else
    /// names them is no further one.
    refused: BTreeSet<String>,
    /// Why what has this id is no thing.
    art: BTreeMap<String, String>,
}

impl Ids {
    /// Gives an id to a thing.
    ///
    /// # Errors
    /// If another has it: in which line.
    pub fn take(&mut self, id: &str, class: ElementClass, line: usize) -> Result<(), usize> {
        if let Some(&(_, first)) = self.things.get(id) {
            self.refuse(id);
            return Err(first);
        }
        self.things.insert(id.to_string(), (class, line));
        Ok(())
    }

    /// The thing with this id, or what should have been it, was refused.
    pub fn refuse(&mut self, id: &str) {
        self.refused.insert(id.to_string());
    }

    /// The class of the thing with this id, even of one that could not be read.
    pub fn class(&self, id: &str) -> Option<ElementClass> {
        self.things.get(id).map(|(class, _)| *class)
    }

    /// Every id of a thing.
    pub fn all(&self) -> impl Iterator<Item = &str> {
        self.things.keys().map(String::as_str)
    }

    /// Notes why elements with ids are no things.
    pub fn note_art(&mut self, source: &Source, document: &Document) {
        for node in document.descendants().filter(Node::is_element) {
            let Some(id) = node.attribute("id").filter(|id| !self.things.contains_key(*id)) else { continue };
            let line = |node: Node| source.line(node.range().start);
            let hides = node.ancestors().find(|node| style::own_property(*node, "display") == Some("none"));
            let class = node.attribute("class").unwrap_or("").trim();
            let why = match hides {
                Some(hides) => {
                    format!("line {} of the drawing hides it (`display: none`), so it is not there", line(hides))
                }
                None if node.tag_name().name() == "use" => {
                    format!(
                        "line {} of the drawing is a clone of what is no thing; let its href name a thing",
                        line(node)
                    )
                }
                None if class.is_empty() => {
                    format!(
                        "line {} of the drawing draws it without a class, so it is art; give it a thing's",
                        line(node)
                    )
                }
                None => {
                    format!("line {} of the drawing draws it with the class `{class}`, which makes it art", line(node))
                }
            };
            self.art.entry(id.to_string()).or_insert(why);
        }
    }

    /// Why what has these ids is no thing.
    pub fn art(&self) -> &BTreeMap<String, String> {
        &self.art
    }

    /// Whether a mistake in what has this id has been told.
    pub fn is_refused(&self, id: &str) -> bool {
        self.refused.contains(id)
    }
}
