//! A table: a drawing, its numbers and its rules, read and checked.
//!
//! Refuses to know how light or balls move: it is what the folder says, as plain data.

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

pub use load::{FILES, LIMITS_BYTES, TableSources};
pub use relief::Relief;

use crate::Failure;
use geometry::{DVec2, Shape};
use physics::{Layout, Material, PartId};

/// A table as its folder says it.
#[derive(Clone, Debug)]
pub struct Table {
    /// The folder's name: `spectrum`.
    pub name: String,
    /// What it calls itself: `Spectrum`.
    pub title: String,
    /// Where its files came from, as mistakes name it: `assets/tables/spectrum`.
    pub origin: String,
    /// What its recordings say so that a reader finds its files; empty where the table's name finds them.
    pub folder: String,
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
    /// Reads and checks the table that these files say.
    ///
    /// # Errors
    /// Every mistake in them, one line each: file, line, what was expected.
    pub fn parse(sources: TableSources) -> Result<Table, Vec<Failure>> {
        load::load(sources)
    }

    /// What mistakes call a file of the table.
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
        emitter: Emitter,
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
    pub finish: Finish,
}

/// What of a bulb shines, seen from above; it lies parallel to the floor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Emitter {
    /// A disc.
    Disc {
        /// Its radius, mm; 0 gives hard shadows.
        radius_mm: f64,
    },
    /// A line, every millimetre of it as bright as any other: a neon tube.
    Segment {
        /// From the middle to one end, mm, no shorter than [`Emitter::LEAST_HALF_MM`].
        half_mm: DVec2,
    },
}

impl Emitter {
    /// The shortest half of a line that gives other light than a point, mm.
    pub const LEAST_HALF_MM: f64 = 0.01;
}

/// How a solid's top looks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Finish {
    /// Reflectance, linear red, green, blue, 0 to 1. With `art` it multiplies the art.
    pub albedo: [f32; 3],
    /// Its form.
    pub profile: Profile,
    /// Strength of its highlights: 0 is matt, 1 is polished metal.
    pub gloss: f32,
    /// Takes its colour from the plastics' art where that is opaque.
    pub art: bool,
    /// Light of its own, linear.
    pub emission: [f32; 3],
    /// How much of it there is: 1 is solid, 0 is not there.
    pub opacity: f32,
    /// How much of the light below it comes through, in the colour of its albedo.
    pub translucency: f32,
}

/// A top's form in cross section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Profile {
    /// Flat, with an edge rounded over this width, mm.
    Bevel(f32),
    /// Round all over: a rubber ring, a wire, a dome.
    Dome,
}
