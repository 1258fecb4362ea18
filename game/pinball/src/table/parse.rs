//! From a folder to a [`Table`], or to every mistake in it.

use super::config::{self, Numbers};
use super::drawing::{self, Drawing, Element};
use super::element_class::ElementClass;
use super::solids::{self, Groups};
use super::source::{self, Mistake, Source};
use super::{Lamp, Relief, Solid, Table, lamps, layers, parts};
use crate::Failure;
use physics::{Layout, Part, PartId};

/// The files of a table.
pub const FILES: [&str; 3] = ["table.svg", "table.toml", "rules.rhai"];
/// The largest of each, bytes.
pub const LIMITS_BYTES: [u64; 3] = [8 << 20, 1 << 20, 1 << 20];

/// Mistakes that are worth reading at once.
const MOST_TOLD: usize = 100;

/// What a table is read from.
#[derive(Clone, Debug)]
pub struct TableSources {
    /// The table's name: `spectrum`.
    pub name: String,
    /// See [`Table::origin`].
    pub origin: String,
    /// See [`Table::folder`].
    pub folder: String,
    /// What each of [`FILES`] holds, or why it cannot be read. Of a file that is larger than [`LIMITS_BYTES`] the first
    /// byte too many is enough.
    pub files: [Result<Vec<u8>, String>; 3],
}

/// The table that these files say, or every mistake in them.
pub(super) fn load(sources: TableSources) -> Result<Table, Vec<Failure>> {
    let TableSources { name, origin, folder, files } = sources;
    let mut mistakes = Vec::new();
    let mut file = 0;
    let [svg, toml, rules] = files.map(|bytes| {
        let path = source::path(&origin, FILES[file]);
        let source = Source::read(path, bytes, LIMITS_BYTES[file]);
        file += 1;
        source.map_err(|mistake| mistakes.push(mistake)).ok()
    });
    let document = svg.as_ref().and_then(|svg| drawing::parse(svg).map_err(|mistake| mistakes.push(mistake)).ok());
    let drawing =
        svg.as_ref().zip(document.as_ref()).map(|(svg, document)| Drawing::read(svg, document, &mut mistakes));
    let ids = drawing.as_ref().map(|drawing| &drawing.ids);
    let toml = toml.unwrap_or_else(|| Source::new(String::new(), String::new()));
    let numbers = &config::read(&toml, ids, &mut mistakes);
    let (Some(svg), Some(document), Some(drawing)) = (&svg, &document, &drawing) else { return Err(told(mistakes)) };
    let build = Build::new(svg, &drawing.elements, numbers, &mut mistakes);
    complete(svg, drawing, &mut mistakes);
    if !mistakes.is_empty() {
        return Err(told(mistakes));
    }
    let printed = layers::split(&svg.text, document);
    let mut table = Table {
        title: numbers.title.clone().unwrap_or_else(|| name.clone()),
        name,
        origin,
        folder,
        layout: Layout {
            size_m: drawing.size_mm * 0.001,
            slope_rad: numbers.slope_deg.to_radians(),
            playfield_friction: numbers.playfield_friction,
            parts: build.parts,
        },
        materials: numbers.materials.iter().map(|(name, material)| (name.clone(), *material)).collect(),
        size_mm: drawing.size_mm,
        lamps: build.lamps,
        solids: build.solids,
        floor_svg: printed.floor,
        tops_svg: printed.tops,
        relief: Relief {
            svg: printed.relief,
            wood_svg: printed.wood,
            tops_wood_svg: printed.tops_wood,
            ..numbers.relief.clone()
        },
        rules: rules.map_or_else(String::new, |rules| rules.text),
        ambient: ambient(numbers),
        hash: 0,
    };
    table.hash = super::hash::of(&table);
    Ok(table)
}

/// The mistakes as sentences, by file and line.
fn told(mut mistakes: Vec<Mistake>) -> Vec<Failure> {
    mistakes.sort();
    mistakes.dedup();
    let mut told: Vec<Failure> =
        mistakes.iter().take(MOST_TOLD).map(|mistake| Failure::new(mistake.to_string())).collect();
    if mistakes.len() > MOST_TOLD {
        told.push(Failure::new(format!("and {} more mistakes", mistakes.len() - MOST_TOLD)));
    }
    told
}

fn ambient(numbers: &Numbers) -> [f32; 3] {
    solids::linear(numbers.ambient).map(|light| light * numbers.ambient_power as f32)
}

/// What every table must have.
fn complete(svg: &Source, drawing: &Drawing, mistakes: &mut Vec<Mistake>) {
    let places = |class| drawing.drawn.iter().filter(move |element| element.0 == class).map(|element| element.1);
    for (class, why) in [
        (ElementClass::Flipper, "a game needs at least one"),
        (ElementClass::Drain, "a ball could never be lost"),
        (ElementClass::Plunger, "no ball could come into play"),
    ] {
        if places(class).next().is_none() {
            mistakes.push(svg.mistake(0, format!("the drawing has no {}: {why}", class.word())));
        }
    }
    for at in places(ElementClass::Plunger).skip(1) {
        mistakes.push(svg.mistake(at, "there is already a plunger; a table has one"));
    }
}

/// The elements, made into what they are.
struct Build {
    parts: Vec<Part>,
    lamps: Vec<Lamp>,
    solids: Vec<Solid>,
}

impl Build {
    fn new(svg: &Source, elements: &[Element], numbers: &Numbers, mistakes: &mut Vec<Mistake>) -> Build {
        let mut build = Build { parts: Vec::new(), lamps: Vec::new(), solids: Vec::new() };
        let mut groups = Groups::default();
        let grouped: Vec<(&Element, u16)> = elements.iter().map(|element| (element, groups.of(element))).collect();
        let group_of = |id: &str| {
            let solid = |element: &Element| element.name == id && element.class.has_finish();
            grouped.iter().find(|(element, _)| solid(element)).map(|&(_, group)| group)
        };
        let mut heights = Vec::new();
        for &(element, group) in &grouped {
            let built = build.element(element, group, numbers, group_of);
            match built {
                Ok(solids) => heights.extend(solids.into_iter().map(|solid| (solids::height(element.class), solid))),
                Err(why) => mistakes.push(svg.mistake(element.at, format!("{}: {why}", element.name))),
            }
        }
        heights.sort_by_key(|&(height, _)| height);
        build.solids = heights.into_iter().map(|(_, solid)| solid).collect();
        build
    }

    fn element(
        &mut self,
        element: &Element,
        group: u16,
        numbers: &Numbers,
        group_of: impl Fn(&str) -> Option<u16>,
    ) -> Result<Vec<Solid>, String> {
        match element.class {
            ElementClass::Lamp | ElementClass::Insert => {
                self.lamps.push(lamps::lamp(element, numbers, group_of)?);
                Ok(Vec::new())
            }
            ElementClass::Plastic => Ok(solids::solid(element, None, group, numbers)?.into_iter().collect()),
            _ => {
                let id = PartId(self.parts.len() as u16);
                let part = Part { name: element.name.clone(), kind: parts::kind(element, numbers)? };
                let solids = match &part.kind {
                    physics::Kind::Ramp(ramp) => solids::above(element, id, ramp, group, numbers)?,
                    _ => solids::solid(element, Some((id, &part)), group, numbers)?.into_iter().collect(),
                };
                self.parts.push(part);
                Ok(solids)
            }
        }
    }
}
