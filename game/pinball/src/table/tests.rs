//! A small table, and what becomes of it.

mod art_values;
mod clones;
mod consequences;
mod covered;
mod elements;
mod errors;
mod fuzz;
mod hash;
mod idle;
mod oddities;
mod overlaps;
mod sheets;
mod slips;
mod told;
mod unread_art;
mod words;

use super::{Table, TableSources};

/// A table with one of everything that a table must have. `{}` is where a test draws.
const SVG: &str = r##"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 500 1000">
<line id="left" class="flipper" data-side="left" data-up-deg="50" x1="150" y1="850" x2="210" y2="885"/>
<line class="drain" x1="100" y1="980" x2="400" y2="980" stroke-width="20"/>
<line id="plunger" class="plunger" x1="480" y1="900" x2="480" y2="950" stroke-width="24"/>
{}
</svg>"##;

/// A cup between a slingshot and a wall, in which a ball lies at 282, 619 mm until the slingshot is fired.
pub(crate) const CUP: &str = r##"<line class="slingshot" id="sling" x1="285" y1="574" x2="251" y2="648" stroke-width="5"/>
<path class="wall" id="body" d="M291.5 630V692L253.5 720Z" fill="#204858" stroke="#204858" stroke-width="2"/>"##;
/// A wall beside the cup: what hops out falls back on it and rolls in again.
pub(crate) const BACK_TO_CUP: &str =
    r#"<path class="wall" id="back" d="M294 632L368 582V300" fill="none" stroke-width="2"/>"#;

/// Reads the small table with `drawn` on it and `numbers` in its `table.toml`.
fn read(drawn: &str, numbers: &str) -> Result<Table, Vec<String>> {
    read_files(&SVG.replace("{}", drawn), numbers, "")
}

pub(crate) fn read_files(svg: &str, toml: &str, rules: &str) -> Result<Table, Vec<String>> {
    let sources = TableSources {
        name: "small".to_string(),
        origin: String::new(),
        folder: String::new(),
        files: [svg, toml, rules].map(|text| Ok(text.as_bytes().to_vec())),
    };
    Table::parse(sources).map_err(|failures| failures.iter().map(ToString::to_string).collect())
}

/// The small table with `drawn` on it; its diagnostics fail the test.
fn table(drawn: &str) -> Table {
    with_rules(drawn, "")
}

/// The one sentence that is told.
#[track_caller]
fn one(told: Vec<String>) -> String {
    let [told] = &told[..] else { panic!("{told:#?}") };
    told.clone()
}

/// The warnings of the small table with `drawn` from its line 5 on, without the file's name.
#[track_caller]
fn warned(drawn: &str) -> Vec<String> {
    let warnings = table(drawn).warnings.into_iter().map(|warning| warning.to_string());
    warnings.map(|told| told.strip_prefix("warning: table.svg:").expect("the drawing's").to_string()).collect()
}

/// The small table with `drawn` on it and these rules; its diagnostics fail the test.
pub(crate) fn with_rules(drawn: &str, rules: &str) -> Table {
    let table = read_files(&SVG.replace("{}", drawn), "", rules);
    table.unwrap_or_else(|diagnostics| panic!("{}", diagnostics.join("\n")))
}

/// The table that this drawing is, without numbers and rules; its diagnostics fail the test.
pub(crate) fn read_svg(svg: &str) -> Table {
    read_files(svg, "", "").unwrap_or_else(|diagnostics| panic!("{}", diagnostics.join("\n")))
}

/// Spectrum, the project's own table.
pub(crate) fn spectrum() -> Table {
    let [svg, toml, rules] = [
        include_str!("../../../../assets/tables/spectrum/table.svg"),
        include_str!("../../../../assets/tables/spectrum/table.toml"),
        include_str!("../../../../assets/tables/spectrum/rules.rhai"),
    ];
    read_files(svg, toml, rules).unwrap_or_else(|diagnostics| panic!("{}", diagnostics.join("\n")))
}
