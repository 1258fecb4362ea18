//! A small table with everything in it, whose files are fuzzed one at a time.

use pinball::table::TableSources;
use pinball::{Failure, Table};

/// A table with one thing of each kind.
pub const SVG: &str = include_str!("../seeds/drawing/everything.svg");
/// Numbers of every kind for it.
pub const TOML: &str = include_str!("../seeds/numbers/everything.toml");

/// The table that these files say.
pub fn table(svg: &[u8], toml: &[u8], rules: &[u8]) -> Result<Table, Vec<Failure>> {
    Table::parse(TableSources {
        name: "small".to_string(),
        origin: String::new(),
        folder: String::new(),
        files: [svg, toml, rules].map(|bytes| Ok(bytes.to_vec())),
    })
}

/// Every sentence says something, and something that a terminal may be sent once it is escaped.
pub fn assert_told(failures: &[Failure]) {
    assert!(!failures.is_empty(), "refused without a word");
    for sentence in failures.iter().flat_map(Failure::sentences) {
        assert!(sentence.len() > 5 && sentence.len() < 4000, "`{sentence}`");
    }
}
