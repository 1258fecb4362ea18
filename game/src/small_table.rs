//! A small table for tests.

use crate::Table;
use crate::table::TableSources;

/// A table with one of everything that a table must have. `{}` is where a test draws.
pub const SVG: &str = r##"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 500 1000">
<line id="left" class="flipper" data-side="left" data-up-deg="50" x1="150" y1="850" x2="210" y2="885"/>
<line class="drain" x1="100" y1="980" x2="400" y2="980" stroke-width="20"/>
<line id="plunger" class="plunger" x1="480" y1="900" x2="480" y2="950" stroke-width="24"/>
{}
</svg>"##;

/// Reads the small table with `drawn` on it and `numbers` in its `table.toml`.
pub fn read(drawn: &str, numbers: &str) -> Result<Table, Vec<String>> {
    read_files(&SVG.replace("{}", drawn), numbers, "")
}

/// Reads the table of this drawing.
pub fn read_svg(svg: &str) -> Result<Table, Vec<String>> {
    read_files(svg, "", "")
}

fn read_files(svg: &str, toml: &str, rules: &str) -> Result<Table, Vec<String>> {
    let sources = TableSources {
        name: "small".to_string(),
        origin: String::new(),
        folder: String::new(),
        files: [svg, toml, rules].map(|text| Ok(text.as_bytes().to_vec())),
    };
    Table::parse(sources).map_err(|failures| failures.iter().map(ToString::to_string).collect())
}

/// The small table with `drawn` on it; its mistakes fail the test.
pub fn table(drawn: &str) -> Table {
    with_rules(drawn, "")
}

/// The small table with `drawn` on it and these rules; its mistakes fail the test.
pub fn with_rules(drawn: &str, rules: &str) -> Table {
    let table = read_files(&SVG.replace("{}", drawn), "", rules);
    table.unwrap_or_else(|mistakes| panic!("{}", mistakes.join("\n")))
}
