//! An embedded table: what a recording carries of the table that it was played on, so that it plays again wherever it
//! is, for as long as there are recordings.
//!
//! What decides the game (all that [`Table::hash`] is of) and how its things look are two texts. Both are JSON: every
//! field has its name and every number all its digits, so a field that comes later is given a default here, and none is
//! renamed or taken away. The drawing is not carried: what its things come to is, and that does not change when a later
//! program reads drawings in another way. Art is not carried either; a blank floor stands in its place.

use super::solid::Solid;
use super::{Emitter, Lamp, LampKind, NormalMapInputs, Table, hash};
use crate::Failure;
use geometry::DVec2;
use physics::Layout;
use serde::{Deserialize, Serialize};
use std::borrow::Cow;

/// The floor where there is no art: a grey on which all light can be seen.
const BLANK_FLOOR: &str = "#7f7f7f";
/// Light from everywhere on a table whose look is not known.
const PLAIN_AMBIENT_POWER: f32 = 0.25;
/// The farthest that anything of a look may lie from the drawing's origin, mm.
const FARTHEST_MM: f64 = 1e5;

/// What a recording carries of its table.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct EmbeddedTable {
    /// What decides the game.
    pub game: String,
    /// How its things look; without it nothing but the balls is drawn.
    pub look: Option<String>,
}

/// What decides the game.
#[derive(Serialize, Deserialize)]
struct Game<'a> {
    title: Cow<'a, str>,
    layout: Cow<'a, Layout>,
    lamps: Vec<LampName<'a>>,
    rules: Cow<'a, str>,
}

/// What rules can know of a lamp.
#[derive(Serialize, Deserialize)]
struct LampName<'a> {
    name: Cow<'a, str>,
    insert: bool,
}

/// How the things of a table look.
#[derive(Serialize, Deserialize)]
struct Look<'a> {
    size_mm: DVec2,
    lamps: Cow<'a, [Lamp]>,
    solids: Cow<'a, [Solid]>,
    ambient: [u8; 3],
    ambient_power: f32,
}

impl EmbeddedTable {
    /// What a recording carries of `table`.
    pub fn of(table: &Table) -> EmbeddedTable {
        let lamps = table.lamps.iter();
        let game = Game {
            title: Cow::Borrowed(&table.title),
            layout: Cow::Borrowed(&table.layout),
            lamps: lamps.map(|lamp| LampName { name: Cow::Borrowed(&lamp.name), insert: is_insert(lamp) }).collect(),
            rules: Cow::Borrowed(&table.rules),
        };
        let look = Look {
            size_mm: table.size_mm,
            lamps: Cow::Borrowed(&table.lamps),
            solids: Cow::Borrowed(&table.solids),
            ambient: table.ambient,
            ambient_power: table.ambient_power,
        };
        EmbeddedTable { game: json(&game), look: Some(json(&look)) }
    }

    /// The table called `name` that is carried, with a blank floor for its art.
    ///
    /// # Errors
    /// If what decides the game cannot be read. A look that cannot be read is left out.
    pub fn table(&self, name: &str) -> Result<Table, Failure> {
        let game: Game = serde_json::from_str(&self.game).map_err(|error| {
            // One line, so its column is a byte.
            let place = error.column();
            Failure::new(format!(
                "the table {name} that it carries is none that this program knows, from byte {place} of its data on: it was \
                 changed by hand, or recorded with a newer Caustic"
            ))
        })?;
        let look = self.look.as_deref().and_then(|look| serde_json::from_str(look).ok());
        let look = look.filter(|look| fits(look, &game)).unwrap_or_else(|| plain_look(&game));
        let mut table = Table {
            name: name.to_string(),
            title: game.title.into_owned(),
            origin: name.to_string(),
            folder: String::new(),
            layout: game.layout.into_owned(),
            part_lines: Vec::new(),
            art_ids: Default::default(),
            materials: Vec::new(),
            size_mm: look.size_mm,
            lamps: look.lamps.into_owned(),
            solids: look.solids.into_owned(),
            floor_svg: blank(look.size_mm, BLANK_FLOOR),
            tops_svg: blank(look.size_mm, "none"),
            normal_map: NormalMapInputs::default(),
            rules: game.rules.into_owned(),
            ambient: look.ambient,
            ambient_power: look.ambient_power,
            warnings: Vec::new(),
            hash: 0,
        };
        table.hash = hash::of(&table);
        Ok(table)
    }
}

/// Plain numbers and names: nothing that JSON could refuse.
fn json(value: &impl Serialize) -> String {
    serde_json::to_string(value).unwrap_or_default()
}

fn is_insert(lamp: &Lamp) -> bool {
    matches!(lamp.kind, LampKind::Insert { .. })
}

/// Art of this size in which nothing is drawn.
fn blank(size_mm: DVec2, fill: &str) -> String {
    let DVec2 { x, y } = size_mm;
    let rect = format!("<rect width=\"{x}\" height=\"{y}\" fill=\"{fill}\"/>");
    format!("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {x} {y}\">{rect}</svg>")
}

/// Whether a look is one of this game's things, and nothing of it lies where nothing can be drawn.
fn fits(look: &Look, game: &Game) -> bool {
    let same = |(lamp, known): (&Lamp, &LampName)| lamp.name == known.name && is_insert(lamp) == known.insert;
    let lamps = look.lamps.len() == game.lamps.len() && look.lamps.iter().zip(&game.lamps).all(same);
    let parts =
        look.solids.iter().flat_map(|solid| solid.part).all(|part| usize::from(part.0) < game.layout.parts.len());
    let near = |point: DVec2| point.abs().max_element() <= FARTHEST_MM;
    let bounds = look.solids.iter().flat_map(|solid| &solid.shapes_mm).map(|shape| shape.bounds());
    let plastics = look.solids.iter().flat_map(|solid| &solid.plastic_mm).flatten();
    let lit = look.lamps.iter().flat_map(|lamp| match &lamp.kind {
        LampKind::Bulb { center_mm, .. } => vec![*center_mm],
        LampKind::Insert { outlines_mm } => outlines_mm.concat(),
    });
    let size = look.size_mm.min_element() > 0.0 && near(look.size_mm);
    let drawn = bounds.flat_map(|bounds| [bounds.min, bounds.max]).chain(plastics.copied()).chain(lit).all(near);
    lamps && parts && size && drawn
}

/// Dark lamps and nothing that casts a shadow.
fn plain_look<'a>(game: &Game) -> Look<'a> {
    let center_mm = game.layout.size_m * 500.0;
    let lamp = |known: &LampName| {
        let emitter = Emitter::Disc { radius_mm: 1.0 };
        let bulb = LampKind::Bulb { center_mm, emitter, height_mm: 1.0, reach_mm: 1.0, inside: None };
        let kind = if known.insert { LampKind::Insert { outlines_mm: Vec::new() } } else { bulb };
        Lamp { name: known.name.to_string(), color: [0; 3], power: 0.0, kind }
    };
    Look {
        size_mm: game.layout.size_m * 1000.0,
        lamps: game.lamps.iter().map(lamp).collect(),
        solids: Cow::Borrowed(&[]),
        ambient: [255; 3],
        ambient_power: PLAIN_AMBIENT_POWER,
    }
}
