//! `caustic check`, as a table's maker meets it.

#![expect(clippy::disallowed_methods, reason = "a table's files are the repository's own")]

use std::path::Path;
use std::process::{Command, Output};

fn check(table: &str) -> Output {
    Command::new(env!("CARGO_BIN_EXE_caustic")).args(["check", table]).output().expect("the program runs")
}

fn told(output: &Output) -> (Option<i32>, String, String) {
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (output.status.code(), text(&output.stdout), text(&output.stderr))
}

#[test]
fn the_table_that_comes_with_the_game_is_good() {
    let (code, said, complained) = told(&check("spectrum"));
    assert_eq!(code, Some(0), "{complained}");
    assert!(said.starts_with("ok spectrum title=\"Spectrum\" size_mm=514x1067 parts="), "{said}");
}

#[test]
fn a_bad_table_is_told_mistake_by_mistake() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("../assets/tables/spectrum");
    let dir = std::env::temp_dir().join(format!("caustic-check-{}", std::process::id()));
    std::fs::create_dir_all(&dir).expect("a folder");
    for file in ["table.svg", "table.toml", "rules.rhai"] {
        let text = std::fs::read_to_string(source.join(file)).expect(file);
        let text = text.replace("data-side=\"right\"", "data-side=\"wrong\"").replace("slope_deg =", "slope =");
        std::fs::write(dir.join(file), text).expect(file);
    }
    let (code, said, complained) = told(&check(&dir.to_string_lossy()));
    std::fs::remove_dir_all(&dir).expect("the folder goes");
    assert_eq!((code, said.as_str()), (Some(1), ""));
    assert!(complained.starts_with("caustic: the table has 2 mistakes\n"), "{complained}");
    assert!(complained.contains("a flipper needs data-side=\"left\" or data-side=\"right\""), "{complained}");
    assert!(complained.contains("`slope` is not known; there are name, slope_deg"), "{complained}");
}

#[test]
fn an_unknown_table_is_told_with_those_that_there_are() {
    let (code, _, complained) = told(&check("no-such-table"));
    assert_eq!(code, Some(1));
    assert!(complained.contains("there is no table called no-such-table: there are "), "{complained}");
    assert!(complained.contains("spectrum"), "{complained}");
}
