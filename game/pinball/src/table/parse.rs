//! Parses a table's files to a [`Table`], or to every diagnostic of them.

use super::config::{self, Config};
use super::solids::{self, ShadowGroups};
use super::source::{self, Diagnostic, Source, failures};
use super::svg::drawing::Drawing;
use super::svg::element::Element;
use super::svg::element_class::ElementClass;
use super::svg::half_place;
use super::svg::layers;
use super::svg::written_out::{self, WrittenOut};
use super::svg::xml;
use super::{
    Lamp, NormalMapInputs, Solid, Table, captives, consequences, covered, file_kind, lamps, parts, shaded, unseen,
};
use crate::Failure;
use physics::{Layout, Part, PartId};

/// The files of a table.
pub const FILES: [&str; 3] = ["table.svg", "table.toml", "rules.rhai"];
/// The largest of each, bytes.
pub const LIMITS_BYTES: [u64; 3] = [8 << 20, 1 << 20, 1 << 20];

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

/// The table that these files say, or every diagnostic in them.
pub(super) fn parse(sources: TableSources) -> Result<Table, Vec<Failure>> {
    let TableSources { name, origin, folder, files } = sources;
    let mut diagnostics = Vec::new();
    let mut file = 0;
    let [svg, toml, rules] = files.map(|bytes| {
        let path = source::path(&origin, FILES[file]);
        let source = Source::read(path, bytes, LIMITS_BYTES[file]);
        let source = source.and_then(|source| file_kind::mistaken(&source, file).map_or(Ok(source), Err));
        file += 1;
        source.map_err(|diagnostic| diagnostics.push(diagnostic)).ok()
    });
    let written = svg.and_then(|svg| written_out::write_out(svg, &mut diagnostics));
    let document = written
        .as_ref()
        .and_then(|written| xml::parse(&written.source).map_err(|diagnostic| diagnostics.push(diagnostic)).ok());
    let drawing = written
        .as_ref()
        .zip(document.as_ref())
        .and_then(|(written, document)| Drawing::read(written, document, &mut diagnostics));
    let ids = drawing.as_ref().map(|drawing| &drawing.ids);
    // Without its numbers a drawing has mistakes that it does not have.
    let Some(toml) = toml else { return Err(failures(diagnostics)) };
    let config = &config::parse(&toml, ids, &mut diagnostics);
    let (Some(WrittenOut { source: svg, .. }), Some(document), Some(drawing)) = (&written, &document, &drawing) else {
        return Err(failures(diagnostics));
    };
    // What cannot be built without names that could not be read is no further mistake.
    let mut of_names = Vec::new();
    let converted = Converted::new(svg, drawing, config, if config.is_cut { &mut of_names } else { &mut diagnostics });
    check_required(svg, drawing, &mut diagnostics);
    diagnostics.extend(config::torque_mistakes(&toml, config, &drawing.elements));
    let has_mistakes = diagnostics.iter().any(|diagnostic| !diagnostic.is_warning());
    diagnostics.extend(unseen::warnings(svg, &drawing.elements, has_mistakes));
    if !has_mistakes {
        diagnostics.extend(half_place::warnings(svg, document, &drawing.elements));
        diagnostics.extend(config::idle_warnings(&toml, config, &drawing.elements));
        diagnostics.extend(covered::warnings(svg, drawing, &converted.parts, &converted.solids));
        diagnostics.extend(shaded::warnings(svg, drawing, &converted.parts, &converted.lamps, &converted.solids));
    }
    let warnings = failures(consequences::joined(diagnostics));
    if warnings.iter().any(|failure| !failure.is_warning()) {
        return Err(warnings);
    }
    let printed = layers::split_layers(&svg.text, document, drawing.page.mm_per_unit);
    let mut table = Table {
        title: config.title.clone().unwrap_or_else(|| name.clone()),
        name,
        origin,
        folder,
        layout: Layout {
            size_m: drawing.page.size_mm * 0.001,
            slope_rad: config.slope_deg.to_radians(),
            playfield_friction: config.playfield_friction,
            parts: converted.parts,
        },
        part_lines: converted.part_lines,
        art_ids: drawing.ids.art().clone(),
        materials: config.materials.iter().map(|(name, material)| (name.clone(), *material)).collect(),
        size_mm: drawing.page.size_mm,
        lamps: converted.lamps,
        solids: converted.solids,
        floor_svg: printed.floor,
        tops_svg: printed.tops,
        normal_map: NormalMapInputs {
            height_svg: printed.height,
            wood_svg: printed.wood,
            tops_wood_svg: printed.tops_wood,
            ..config.normal_map.clone()
        },
        rules: rules.map_or_else(String::new, |rules| without_mark(rules.text)),
        ambient: config.ambient,
        ambient_power: config.ambient_power as f32,
        warnings,
        hash: 0,
    };
    if let Err((part, why)) = captives::check(&table.layout) {
        let name = &table.layout.parts[part].name;
        let at = drawing.elements.iter().find(|element| element.name == *name).map_or(0, |element| element.at);
        return Err(failures(vec![svg.diagnostic(at, format!("{name}: {why}"))]));
    }
    table.hash = super::hash::of(&table);
    Ok(table)
}

/// A text without the byte order mark that some editors begin it with.
fn without_mark(text: String) -> String {
    match text.strip_prefix('\u{feff}') {
        Some(rest) => rest.to_string(),
        None => text,
    }
}

/// What every table must have.
fn check_required(svg: &Source, drawing: &Drawing, diagnostics: &mut Vec<Diagnostic>) {
    let places = |class| drawing.drawn.iter().filter(move |element| element.0 == class).map(|element| element.1);
    for (class, why) in [
        (ElementClass::Flipper, "a game needs at least one"),
        (ElementClass::Drain, "a ball could never be lost"),
        (ElementClass::Plunger, "no ball could come into play"),
    ] {
        if places(class).next().is_none() {
            diagnostics.push(svg.diagnostic(0, format!("the drawing has no {}: {why}", class.word())));
        }
    }
    for at in places(ElementClass::Plunger).skip(1) {
        diagnostics.push(svg.diagnostic(at, "there is already a plunger; a table has one"));
    }
}

/// What elements are converted to: parts, lamps and solids.
struct Converted {
    parts: Vec<Part>,
    part_lines: Vec<usize>,
    lamps: Vec<Lamp>,
    solids: Vec<Solid>,
}

impl Converted {
    fn new(svg: &Source, drawing: &Drawing, config: &Config, diagnostics: &mut Vec<Diagnostic>) -> Converted {
        let mut converted =
            Converted { parts: Vec::new(), part_lines: Vec::new(), lamps: Vec::new(), solids: Vec::new() };
        let mut groups = ShadowGroups::default();
        let grouped: Vec<(&Element, u16)> =
            drawing.elements.iter().map(|element| (element, groups.of(element))).collect();
        let group_of = |id: &str| {
            let solid = |element: &Element| element.name == id && element.class.has_finish();
            let found = grouped.iter().find(|(element, _)| solid(element)).map(|&(_, group)| group);
            // Of what was refused no group is known, and no table will come of it.
            found.or_else(|| drawing.ids.is_refused(id).then_some(0))
        };
        let mut ordered = Vec::new();
        for &(element, group) in &grouped {
            let built = converted.element(element, group, config, group_of);
            match built {
                Ok(solids) => {
                    if converted.part_lines.len() < converted.parts.len() {
                        converted.part_lines.push(svg.line(element.at));
                    }
                    ordered.extend(solids.into_iter().map(|solid| (solids::draw_order(element.class), solid)))
                }
                Err(why) => diagnostics.push(svg.diagnostic(element.at, format!("{}: {why}", element.name))),
            }
        }
        ordered.sort_by_key(|&(order, _)| order);
        converted.solids = ordered.into_iter().map(|(_, solid)| solid).collect();
        converted
    }

    fn element(
        &mut self,
        element: &Element,
        group: u16,
        config: &Config,
        group_of: impl Fn(&str) -> Option<u16>,
    ) -> Result<Vec<Solid>, String> {
        match element.class {
            ElementClass::Lamp | ElementClass::Insert => {
                self.lamps.push(lamps::lamp(element, config, group_of)?);
                Ok(Vec::new())
            }
            ElementClass::Plastic => Ok(solids::solid(element, None, group, config)?.into_iter().collect()),
            _ => {
                let id = PartId(self.parts.len() as u16);
                let part = Part { name: element.name.clone(), kind: parts::kind(element, config)? };
                let solids = match &part.kind {
                    physics::Kind::Ramp(ramp) => solids::ramp_solids(element, id, ramp, group, config)?,
                    _ => solids::solid(element, Some((id, &part)), group, config)?.into_iter().collect(),
                };
                self.parts.push(part);
                Ok(solids)
            }
        }
    }
}
