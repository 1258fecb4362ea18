//! A table: a drawing, its numbers and its rules, read and checked.
//!
//! Refuses to know how light or balls move: it is what the folder says, as plain data.

mod captives;
mod config;
mod consequences;
mod covered;
mod embedded;
mod file_kind;
mod hash;
mod lamp;
mod lamps;
mod normal_map;
mod overlaps;
mod parse;
mod parts;
mod shaded;
mod solid;
mod solids;
mod source;
mod svg;
#[cfg(test)]
pub(crate) mod tests;
mod unseen;

pub use embedded::EmbeddedTable;
pub use lamp::{Emitter, Lamp, LampKind};
pub use normal_map::NormalMapInputs;
pub use parse::{FILES, LIMITS_BYTES, TableSources};
pub use solid::{Finish, Profile, Solid};
pub use source::text;
pub use svg::css::style_declarations;
pub use svg::drawn_shapes::{DrawnLine, DrawnOutline, DrawnPiece, DrawnShape, DrawnShapes};
pub use svg::element_class::LIGHT_BENDING_WORDS;

use crate::Failure;
use geometry::DVec2;
use physics::{Layout, Material, PartId};
use std::collections::BTreeMap;

/// A table as its folder says it.
#[derive(Clone, Debug)]
pub struct Table {
    /// The folder's name: `spectrum`.
    pub name: String,
    /// What it calls itself: `Spectrum`.
    pub title: String,
    /// Where its files came from, as diagnostics name it: `assets/tables/spectrum`.
    pub origin: String,
    /// What its recordings say so that a reader finds its files; empty where the table's name finds them.
    pub folder: String,
    /// What stands on the playfield, in SI units, for the physics.
    pub layout: Layout,
    /// The line of each part in the drawing, from 1; none where the table comes from a recording.
    pub part_lines: Vec<usize>,
    /// Why what has this id in the drawing is no thing: it is hidden, or has no class. None where the table comes from a
    /// recording.
    pub art_ids: BTreeMap<String, String>,
    /// What its elements can be made of, by name.
    pub materials: Vec<(String, Material)>,
    /// Width and height of the playfield, mm.
    pub size_mm: DVec2,
    /// The lamps, in the drawing's order; rules and snapshots name them by this index.
    pub lamps: Vec<Lamp>,
    /// What casts shadows and has a visible top: one for each drawn solid, from the lowest to the highest.
    pub solids: Vec<Solid>,
    /// The floor's art: the drawing without its shapes and its plastics, as SVG text.
    pub floor_svg: String,
    /// The plastics' art: what lies above the ball, as SVG text.
    pub tops_svg: String,
    /// What is raised, engraved, grained and scratched.
    pub normal_map: NormalMapInputs,
    /// The rules' text.
    pub rules: String,
    /// Light from everywhere, sRGB.
    pub ambient: [u8; 3],
    /// What that light is multiplied by.
    pub ambient_power: f32,
    /// What is odd in its files and yet no mistake, by file and line.
    pub warnings: Vec<Failure>,
    /// Of all that a game depends on (layout, rules, the lamps' names), and of nothing that only changes the picture.
    pub hash: u64,
}

impl Table {
    /// Reads and checks the table that these files say.
    ///
    /// # Errors
    /// Every diagnostic in them, one line each: file, line, what was expected.
    pub fn parse(sources: TableSources) -> Result<Table, Vec<Failure>> {
        parse::parse(sources)
    }

    /// What is wrong with where its parts are, though each by itself is right: parts in each other, and parts that no ball
    /// can come to for what stands there.
    pub fn overlaps(&self) -> Vec<Failure> {
        overlaps::findings(self)
    }

    /// What diagnostics call a file of the table.
    pub fn file(&self, name: &str) -> String {
        source::path(&self.origin, name)
    }

    /// The part with this id in the drawing.
    pub fn part(&self, name: &str) -> Option<PartId> {
        let index = self.layout.parts.iter().position(|part| part.name == name)?;
        Some(PartId(index as u16))
    }

    /// The index of the lamp with this id in the drawing.
    pub fn lamp(&self, name: &str) -> Option<usize> {
        self.lamps.iter().position(|lamp| lamp.name == name)
    }
}
