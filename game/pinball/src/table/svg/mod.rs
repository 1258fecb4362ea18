//! SVG: a drawing's text, read as a browser reads it, down to shapes, looks and places.
//!
//! Refuses to know what a thing on a table does.

mod amount;
mod art_shapes;
mod biarc;
mod class_typo;
mod clones;
mod color;
pub(super) mod css;
pub(super) mod drawing;
pub(super) mod drawn_shapes;
pub(super) mod element;
pub(super) mod element_class;
pub(super) mod half_place;
mod hidden;
pub(super) mod ids;
pub(super) mod layers;
mod moved;
mod oddities;
pub(super) mod outline;
pub(super) mod outline_offset;
mod outside;
mod page;
mod paint_servers;
mod path_data;
pub(super) mod path_flattening;
mod references;
mod shape_typo;
mod sheet_values;
pub(super) mod style;
mod text_edit;
mod transform;
mod viewport;
pub(super) mod written_out;
pub(super) mod xml;
mod xml_mistake;
