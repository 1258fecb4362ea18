//! A table: a drawing, its numbers and its rules, read and checked.
//!
//! Refuses to know how light or balls move: it is what the folder says, as plain data.

pub mod art;
mod class;
mod drawing;
mod hash;
mod lamps;
mod load;
mod numbers;
mod outline;
mod parts;
mod path;
mod pen;
mod place;
mod relief;
mod rim;
mod solids;
mod source;
mod split;
mod style;
#[cfg(test)]
pub(crate) mod tests;
mod watch;

pub use relief::Relief;
pub use watch::Watch;

use geometry::{DVec2, Shape};
use physics::{Layout, Material, PartId};
use std::path::PathBuf;

/// A table as its folder says it.
#[derive(Clone, Debug)]
pub struct Table {
    /// The folder's name: `spectrum`.
    pub name: String,
    /// What it calls itself: `Spectrum`.
    pub title: String,
    /// The folder.
    pub dir: PathBuf,
    /// What stands on the playfield, in SI units, for the physics.
    pub layout: Layout,
    /// What its things can be made of, by name.
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
    pub relief: Relief,
    /// The rules' text.
    pub rules: String,
    /// Light from everywhere: linear, red, green, blue.
    pub ambient: [f32; 3],
    /// Of all that a game depends on (layout, rules, the lamps' names), and of nothing that only changes the picture.
    pub hash: u64,
}

impl Table {
    /// Reads and checks the table called `name`, or the one in the folder `name`.
    ///
    /// # Errors
    /// Every mistake in its files, one line each: file, line, what was expected.
    pub fn load(name: &str) -> Result<Table, Vec<crate::Failure>> {
        let dir = crate::assets::table_dir(name).map_err(|failure| vec![failure])?;
        Table::load_dir(&dir)
    }

    /// Reads and checks the table in the folder `dir`.
    ///
    /// # Errors
    /// As [`Table::load`].
    pub fn load_dir(dir: &std::path::Path) -> Result<Table, Vec<crate::Failure>> {
        let table = load::load(dir)?;
        art::check(&table).map_err(|failure| vec![failure])?;
        Ok(table)
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

/// A lamp or a lit insert.
#[derive(Clone, Debug, PartialEq)]
pub struct Lamp {
    /// Its id in the drawing.
    pub name: String,
    /// Its fill, sRGB: the colour it has unless the rules give it another.
    pub color: [u8; 3],
    /// Brightness when fully on, relative to the others.
    pub power: f64,
    /// What it is.
    pub kind: LampKind,
}

/// What a lamp is.
#[derive(Clone, Debug, PartialEq)]
pub enum LampKind {
    /// A disc or a line above the floor that lights the table and casts shadows.
    Bulb {
        /// The middle, mm.
        center_mm: DVec2,
        /// What of it shines.
        emitter: tracer::Emitter,
        /// The height above the floor, mm.
        height_mm: f64,
        /// Where its light ends, mm.
        reach_mm: f64,
        /// The solid group that it stands inside of (a bumper's lamp).
        inside: Option<u16>,
    },
    /// A window in the floor, lit from below: these closed outlines, mm.
    Insert {
        /// Closed polygons, filled by the even-odd rule.
        outlines_mm: Vec<Vec<DVec2>>,
    },
}

/// A drawn thing that casts a shadow, has a top, or both.
#[derive(Clone, Debug, PartialEq)]
pub struct Solid {
    /// The part that moves it or is hit with it, if any.
    pub part: Option<PartId>,
    /// Solids with the same group do not shade each other's tops.
    pub group: u16,
    /// What casts its shadow, mm, as drawn (a flipper at rest, a drop target up).
    pub shapes_mm: Vec<Shape>,
    /// A plastic's closed outline, mm, where it is not the shapes themselves.
    pub plastic_mm: Option<Vec<DVec2>>,
    /// Casts a shadow.
    pub shadow: bool,
    /// How its top looks.
    pub finish: tracer::Finish,
}
