//! `caustic check`, as a table's maker meets it.

#![expect(clippy::disallowed_methods, reason = "a table's files are the repository's own")]

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// What is found without play.
fn check(table: &str) -> Output {
    run(&["check", "--quick", table])
}

fn run(words: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_caustic")).args(words).output().expect("the program runs")
}

fn told(output: &Output) -> (Option<i32>, String, String) {
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (output.status.code(), text(&output.stdout), text(&output.stderr))
}

#[test]
fn the_table_that_comes_with_the_game_is_good() {
    let (code, said, complained) = told(&run(&["check", "spectrum"]));
    assert_eq!((code, complained.as_str()), (Some(0), ""));
    assert!(said.starts_with("ok spectrum title=\"Spectrum\" size_mm=514x1067 parts="), "{said}");
    let played = said.contains(" warnings=0 ") && said.contains(" places=") && said.contains(" bot_score=");
    assert!(played, "{said}");
}

/// A plunger drawn from its handle to its tip: `check` said that the table was good, and no ball ever came into play.
#[test]
fn what_only_play_shows_is_told_and_left_out_in_haste() {
    let turned = [("d=\"m 395,805 v 42\"", "d=\"m 395,847 v -42\"")];
    let (code, said, complained) = orchard_with(&["check"], "plunger", &turned);
    assert_eq!((code, said.as_str()), (Some(1), ""));
    assert!(
        complained.contains(
            "plunger: new balls arrive before it at 395, 862 mm, which is inside lanefloor (line 104): draw it"
        ),
        "{complained}"
    );
    let (code, said, complained) = orchard_with(&["check", "--quick"], "plunger-quick", &turned);
    assert_eq!((code, complained.as_str()), (Some(0), ""), "{said}");
}

/// A ball that had just passed the gate fell back on its flap and lay there.
#[test]
fn a_gate_that_holds_a_ball_is_told_by_its_name() {
    let level = [("d=\"m 376,250 38,-16\"", "d=\"m 376,250 h 38\"")];
    let (code, _, complained) = orchard_with(&["check"], "gate", &level);
    assert_eq!(code, Some(1));
    assert!(
        complained
            .contains(": gate1: a ball lies still beside it at 385, 236 mm, and the ball search does not free it"),
        "{complained}"
    );
}

#[test]
fn all_of_it_is_data_if_it_is_asked_for() {
    let typo = [("\"slingshot\"", "\"sling-shot\"")];
    let (code, said, complained) = orchard_with(&["check", "--json"], "json-typo", &typo);
    assert_eq!((code, complained.as_str()), (Some(1), "caustic: 1 error\n"));
    let found: serde_json::Value = serde_json::from_str(&said).expect("JSON");
    assert_eq!((&found["ok"], &found["errors"][0]["line"]), (&false.into(), &178.into()), "{said}");
    assert_eq!(found["errors"][0]["message"], "the class `sling-shot` means nothing; did you mean `slingshot`?");
    let (code, said, complained) = orchard_with(&["check", "--json"], "json", &[]);
    assert_eq!((code, complained.as_str()), (Some(0), ""));
    let found: serde_json::Value = serde_json::from_str(&said).expect("JSON");
    assert_eq!((&found["parts"], &found["play"]["places"]), (&14.into(), &500.into()), "{said}");
    assert_eq!((&found["errors"], &found["warnings"]), (&serde_json::json!([]), &serde_json::json!([])));
}

/// A title with a letter that turns lines round made the data unreadable.
#[test]
fn data_is_json_whatever_a_file_says() {
    let table = Table::new("bidi", "");
    std::fs::write(table.0.join("table.toml"), "name = \"A\u{202e}B\u{9b}\u{1f600}\"").expect("numbers");
    let (_, said, _) = told(&run(&["check", "--quick", "--json", &table.0.to_string_lossy()]));
    assert!(said.is_ascii(), "{said}");
    let found: serde_json::Value = serde_json::from_str(&said).expect("JSON");
    assert_eq!(found["title"], "A\u{202e}B\u{9b}\u{1f600}");
}

/// The notepad of Windows begins a file with a byte order mark.
#[test]
fn a_byte_order_mark_is_no_mistake() {
    let table = Table::with_rules("mark", "", "\u{feff}fn on_start() { let begun = now(); }");
    let (code, _, complained) = told(&check(&table.0.to_string_lossy()));
    assert_eq!((code, complained.as_str()), (Some(0), ""));
}

/// A message of 43 letters that stood for a second showed its beginning; one of 90 ms was called ok.
#[test]
fn a_message_that_has_no_time_is_told() {
    let rules =
        "fn on_start() { message(\"THE QUICK BROWN FOX JUMPS OVER THE LAZY DOG\", 1_000); message(\"SHORT\", 90); }";
    let table = Table::with_rules("message", "", rules);
    let (code, said, complained) = told(&check(&table.0.to_string_lossy()));
    assert_eq!(code, Some(0), "{complained}");
    assert!(said.contains(" warnings=2 "), "{said}");
    assert!(complained.contains("rules.rhai:1: the message `SHORT` is gone after 90 ms"), "{complained}");
    let expected = "rules.rhai:1: the message `THE QUICK BROWN FOX JUMPS OVER THE LAZY DOG` is wider than the display";
    assert!(complained.contains(expected), "{complained}");
}

/// A message that the script puts together was shown for half a second, and was too wide for that.
#[test]
fn a_message_that_is_built_in_play_and_has_no_time_is_told() {
    let walls =
        r#"<path class="wall" d="M10 1060V10H504V1060M464 200V1060M504 90L424 10" fill="none" stroke-width="6"/>"#;
    let rules = r#"fn on_start() { after(500, "sum"); after(2000, "template"); after(4000, "loop"); after(6000, "short"); }
fn on_timer(name) {
    if name == "sum" { message("THE TARGETS ARE HIT FOR " + 250 + " POINTS AND MORE TO COME", 500); }
    let n = 7;
    if name == "template" { message(`ONLY ${n} BALLS ARE LEFT AND THE DAY IS OLD AND GREY`, 500); }
    let s = "A";
    while s.len < 50 { s += "A"; }
    if name == "loop" { message(s, 500); }
    if name == "short" { message("SHORT", 80); }
}"#;
    let table = Table::with_rules("built", walls, rules);
    let (_, _, complained) = told(&run(&["check", &table.0.to_string_lossy()]));
    let all = [
        (":3", "THE TARGETS ARE HIT FOR 250 POINTS AND MORE TO COME"),
        (":5", "ONLY 7 BALLS ARE LEFT AND THE DAY IS OLD AND GREY"),
        ("", &"A".repeat(50)),
    ];
    for (line, text) in all {
        let expected =
            format!("rules.rhai{line}: the message `{text}` is wider than the display and hurries past in its 500 ms");
        assert_eq!(complained.matches(&expected).count(), 1, "{complained}");
    }
    assert!(complained.contains("rules.rhai:9: the message `SHORT` is gone after 80 ms"), "{complained}");
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
    assert!(complained.ends_with("\n2 errors\n"), "{complained}");
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

/// What `check` says, without play, of the orchard with these changes to its drawing.
fn orchard(name: &str, changes: &[(&str, &str)]) -> (Option<i32>, String, String) {
    orchard_with(&["check", "--quick"], name, changes)
}

/// What these words say of the orchard, a table as Inkscape 1.2 saves it, with these changes to its drawing.
fn orchard_with(words: &[&str], name: &str, changes: &[(&str, &str)]) -> (Option<i32>, String, String) {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/orchard");
    let dir = std::env::temp_dir().join(format!("caustic-orchard-{name}-{}", std::process::id()));
    std::fs::create_dir_all(&dir).expect("a folder");
    for file in ["table.svg", "table.toml", "rules.rhai"] {
        let mut text = std::fs::read_to_string(source.join(file)).expect(file);
        for (from, to) in changes.iter().filter(|_| file == "table.svg") {
            assert!(text.contains(from), "{from}");
            text = text.replace(from, to);
        }
        std::fs::write(dir.join(file), text).expect(file);
    }
    let told = told(&run(&[words, &[&dir.to_string_lossy()]].concat()));
    std::fs::remove_dir_all(&dir).expect("the folder goes");
    told
}

/// How many parts the line of `check` counts.
fn parts(said: &str) -> &str {
    said.split_once("parts=").expect("a count").1.split(' ').next().expect("a number")
}

/// Inkscape's "Edit > Clone" of a bumper was printed on the floor, and nothing was there to hit.
#[test]
fn a_drawing_that_inkscape_saved_is_a_table() {
    let (code, said, complained) = orchard("as-it-is", &[]);
    assert_eq!((code, complained.as_str()), (Some(0), ""), "{said}");
    assert!(said.contains("title=\"Orchard\" size_mm=420x900 parts=14 ") && said.contains("warnings=0"), "{said}");
    // The clone of the bumper is the fourteenth.
    let (code, said, complained) = orchard("without-clone", &[("xlink:href=\"#bump1\"", "xlink:href=\"#star1\"")]);
    assert_eq!((code, parts(&said), complained.as_str()), (Some(0), "13", ""));
}

/// A wall whose look stood in a sheet was as thin as a line that nobody gave a thickness, and black.
#[test]
fn a_look_in_a_sheet_is_the_look_that_a_thing_has() {
    let style = "style=\"fill:none;stroke:#8f5902;stroke-width:6;stroke-linecap:round;stroke-dasharray:none\"";
    let sheet = "<style id=\"st\">#outer{FILL:none;/* brown */stroke:#8f5902;stroke-width:6}</style></svg>";
    let (_, written, _) = orchard("attribute", &[]);
    let (code, said, complained) = orchard("sheet", &[(style, ""), ("</svg>", sheet)]);
    assert_eq!((code, complained.as_str()), (Some(0), ""), "{said}");
    let hash = |said: &str| said.split_once("hash=").expect("a hash").1.to_string();
    assert_eq!(hash(&said), hash(&written), "the same table to the bit");
}

/// A page of 420 x 900 mm that Inkscape had divided into pixels was a table of 1.6 x 3.4 metres.
#[test]
fn the_size_in_print_and_the_view_box_say_how_large_a_table_is() {
    let pixels = [("viewBox=\"0 0 420 900\"", "viewBox=\"0 0 1587.4016 3401.5748\"")];
    let whole = "<g transform=\"scale(3.7795275)\"><g\n     inkscape:label=\"Art\"";
    let scaled = [pixels[0], ("<g\n     inkscape:label=\"Art\"", whole), ("</svg>", "</g></svg>")];
    let (code, said, complained) = orchard("pixels", &scaled);
    assert_eq!((code, complained.as_str()), (Some(0), ""), "{said}");
    assert!(said.contains("size_mm=420x900 parts=14 "), "{said}");
    // Without a unit of print one unit is one millimetre.
    let (code, said, complained) =
        orchard("units", &[pixels[0], ("width=\"420mm\"", "width=\"420\""), ("height=\"900mm\"", "height=\"900px\"")]);
    assert_eq!(code, Some(0), "{complained}");
    assert!(said.contains("size_mm=1587.4x3401.57 ") && said.contains("warnings=1"), "{said}");
    assert!(
        complained.starts_with("caustic: warning: ") && complained.contains("the playfield is 1587.4 x 3401.57 mm")
    );
    let stretched = ("viewBox=\"0 0 420 900\"", "viewBox=\"0 0 420 1800\" preserveAspectRatio=\"none\"");
    let (code, _, complained) = orchard("stretched", &[stretched]);
    assert!(code == Some(1) && complained.contains("stretch its viewBox"), "{complained}");
}

/// A slingshot of the class `sling-shot` was art, and `check` said that all was well.
#[test]
fn mistakes_and_warnings_are_counted() {
    let (code, said, complained) = orchard("typo", &[("\"slingshot\"", "\"sling-shot\"")]);
    assert_eq!((code, said.as_str()), (Some(1), ""));
    assert!(
        complained.ends_with(":178: the class `sling-shot` means nothing; did you mean `slingshot`?\n"),
        "{complained}"
    );
    let two = [("\"slingshot\"", "\"sling-shot\""), ("sodipodi:type=\"star\"", "class=\"star\"")];
    let (_, _, complained) = orchard("typo-and-word", &two);
    assert!(complained.ends_with("\n1 error, 1 warning\n"), "{complained}");
    assert!(
        complained.contains("\nwarning: ") && complained.contains("the class `star` means nothing"),
        "{complained}"
    );
    // Illustrator gives every shape a word of its own.
    let (code, said, _) = orchard("own-word", &[("class=\"bumper\"", "class=\"bumper st0\"")]);
    assert!(code == Some(0) && said.contains("warnings=0"), "{said}");
    let (code, said, complained) = orchard("word", &two[1..]);
    assert!(code == Some(0) && said.contains("warnings=1"), "{said}");
    assert!(complained.contains("warning: ") && complained.contains("the class `star` means nothing"), "{complained}");
}

/// It was told that a limit of the library that reads art was met.
#[test]
fn art_that_draws_itself_is_told_by_its_ids() {
    let circle = "<g id=\"a\"><use xlink:href=\"#b\"/></g><g id=\"b\"><use xlink:href=\"#a\"/></g></defs>";
    let (code, _, complained) = orchard("circle", &[("</defs>", circle)]);
    assert_eq!(code, Some(1));
    assert!(complained.contains("#a -> #b -> #a; take this reference out"), "{complained}");
}

#[test]
fn a_file_in_the_place_of_a_folder_is_told_as_such() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let (code, said, complained) = told(&check(&root.join("README.md").to_string_lossy()));
    assert_eq!((code, said.as_str()), (Some(1), ""));
    assert!(complained.ends_with("README.md is a file; name the folder of a table\n"), "{complained}");
    let (_, _, complained) = told(&check(&root.join("tests/orchard/table.svg").to_string_lossy()));
    assert!(complained.contains("table.svg is a file; name its folder, "), "{complained}");
    assert!(complained.ends_with("/tests/orchard\n"), "{complained}");
}

/// "There is no table called /dev/zero", which is there.
#[cfg(unix)]
#[test]
fn a_device_in_the_place_of_a_folder_is_told_as_such() {
    let (code, said, complained) = told(&check("/dev/zero"));
    assert_eq!((code, said.as_str()), (Some(1), ""));
    assert!(complained.ends_with("/dev/zero is a device and no folder; name the folder of a table\n"), "{complained}");
}

/// A small table of this test's own, with `drawn` on it.
struct Table(PathBuf);

impl Table {
    fn new(name: &str, drawn: &str) -> Table {
        Table::with_rules(name, drawn, "")
    }

    fn with_rules(name: &str, drawn: &str, rules: &str) -> Table {
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
        for (file, text) in [("table.svg", svg.as_str()), ("table.toml", "name = \"t\""), ("rules.rhai", rules)] {
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
    let number = ["table.svg:5: ", "the number 2147483649 in it is too large"];
    let panics = r#"<path d="M12 668 L408 838 L-2147483649 812 V704 L458 668 V914 L284 992 Z" fill="red"/>"#;
    assert_refused("panic", panics, &number);
    let aborts = r#"<g class="wood"><path d="M12 668 A36 36 0 0 1 48 704 V812 L62 838 L145 892 L146 912 L205 950 H265 L324 912 L325 892 L408 838 L-2147483649 812 V704 A36 36 0 0 1 458 668 V914 L284 992 V1067 H186 V992 L12 914 Z"/></g>"#;
    assert_refused("abort", aborts, &number);
    let function = r#"<rect id="r" width="9" height="9" style="filter:blur(1e38px)"/>"#;
    let measured = ["table.svg:5: rect `r`: the number 1", "in it is too large"];
    assert_refused("function", function, &measured);
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

/// What is wrong with a thing stood behind its name, and that was cut off before it.
#[test]
fn a_name_of_a_million_letters_hides_nothing() {
    let id = "a".repeat(1_000_000);
    let table = Table::new("long-id", &format!(r#"<line class="wall" id="{id}" x1="9" y1="9" x2="9" y2="9"/>"#));
    let (code, _, complained) = told(&check(&table.0.to_string_lossy()));
    assert_eq!(code, Some(1));
    assert!(complained.ends_with("aaa...: it has no length\n") && complained.len() < 500, "{complained}");
}

/// It was told without a line, and no other place said where the letters are.
#[test]
fn a_font_that_is_not_there_is_told_with_its_line() {
    let text =
        "<style>.word { font-family: Arial }</style>\n<g>\n<text class=\"word\" x=\"99\" y=\"99\">Lux</text></g>";
    let expected = ["table.svg:7: there is no font \"Arial\"; there are Cinzel, Marcellus, Oxanium"];
    assert_refused("font", text, &expected);
    assert_refused("fonts", &text.replace("<g>", "<g font-family=\"Marcellus\">"), &expected);
}

/// Of two scales one was taken, and nobody said which.
#[test]
fn a_size_that_does_not_fit_the_view_box_is_told() {
    let (code, said, complained) = orchard("unequal", &[("width=\"420mm\"", "width=\"430mm\"")]);
    assert_eq!(code, Some(0), "{complained}");
    assert!(said.contains("size_mm=420x900 ") && said.contains("warnings=1"), "{said}");
    let expected = "they say 1.0238 mm a unit across and 1.0000 down; 1.0000 was taken for both";
    assert!(complained.starts_with("caustic: warning: ") && complained.contains(expected), "{complained}");
}
