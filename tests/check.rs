//! `caustic check`, as a table's maker meets it.

#![expect(clippy::disallowed_methods, reason = "a table's files are the repository's own")]

use std::path::{Path, PathBuf};
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
    assert!(complained.contains("there is no table called no-such-table: there is only spectrum"), "{complained}");
    assert!(complained.contains("spectrum"), "{complained}");
}

/// A small table of this test's own, with `drawn` on it.
struct Table(PathBuf);

impl Table {
    fn new(name: &str, drawn: &str) -> Table {
        let dir = std::env::temp_dir().join(format!("caustic-check-{name}-{}", std::process::id()));
        std::fs::create_dir_all(&dir).expect("a folder");
        let svg = format!(
            r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 514 1067">
<line class="flipper" id="left" x1="145.5" y1="900" x2="205" y2="933" stroke-width="18" data-side="left" data-up-deg="51"/>
<line class="plunger" id="plunger" x1="484" y1="960" x2="484" y2="1006" stroke-width="30"/>
<rect class="drain" id="drain" x="12" y="1016" width="440" height="45"/>
{drawn}
</svg>"#
        );
        for (file, text) in [("table.svg", svg.as_str()), ("table.toml", "name = \"t\""), ("rules.rhai", "")] {
            std::fs::write(dir.join(file), text).expect(file);
        }
        Table(dir)
    }
}

impl Drop for Table {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

fn assert_refused(name: &str, drawn: &str, parts: &[&str]) {
    let table = Table::new(name, drawn);
    let (code, said, complained) = told(&check(&table.0.to_string_lossy()));
    assert_eq!((code, said.as_str()), (Some(1), ""), "{complained}");
    assert_eq!(complained.lines().count(), 1, "{complained}");
    for part in parts {
        assert!(complained.contains(part), "`{complained}` does not say `{part}`");
    }
}

/// A corner at -2147483649 mm made the rasteriser panic in play, and with arcs in the same path abort, while `check` said
/// that the table was good.
#[test]
fn art_that_the_rasteriser_cannot_take_is_refused() {
    let number = ["table.svg: line 5: ", "the number 2147483649 in it is too large"];
    let panics = r#"<path d="M12 668 L408 838 L-2147483649 812 V704 L458 668 V914 L284 992 Z" fill="red"/>"#;
    assert_refused("panic", panics, &number);
    let aborts = r#"<g class="wood"><path d="M12 668 A36 36 0 0 1 48 704 V812 L62 838 L145 892 L146 912 L205 950 H265 L324 912 L325 892 L408 838 L-2147483649 812 V704 A36 36 0 0 1 458 668 V914 L284 992 V1067 H186 V992 L12 914 Z"/></g>"#;
    assert_refused("abort", aborts, &number);
    let scaled = r#"<g id="big" transform="scale(1e5)"><path d="M12 668 L408 838 V914 Z" transform="scale(1e5)"/></g>"#;
    assert_refused(
        "scaled",
        scaled,
        &["`big` in line 5 reaches too far beyond the playfield to be printed; cut it off"],
    );
}

/// Seconds of play took minutes on a table with 150 captive balls that lie on each other.
#[test]
fn a_heap_of_captive_balls_is_refused_with_what_it_takes() {
    let heap = |balls: usize| {
        let place = |ball: usize| (41.0 + 27.0 * (ball % 15) as f64, 680.0 - 26.9 * (ball / 15) as f64);
        let ball = |ball: usize| {
            let (x, y) = place(ball);
            format!(r#"<circle class="captive-ball" id="b{ball}" cx="{x}" cy="{y}" r="13.5"/>"#)
        };
        let balls: String = (0..balls).map(ball).collect();
        format!(r#"{balls}<path class="wall" d="M20 20V700H480V20Z" stroke-width="6" fill="none"/>"#)
    };
    assert_refused(
        "heap",
        &heap(150),
        &[
            "table.svg:5: b0: its 150 captive balls lie on each other and take ",
            "contact solves in a tick, and 20000 is the most",
        ],
    );
    let few = Table::new("few", &heap(10));
    let (code, said, complained) = told(&check(&few.0.to_string_lossy()));
    assert_eq!(code, Some(0), "{complained}");
    assert!(said.contains(" print_mops="), "{said}");
}
