//! Classes that mean nothing, and tables of odd sizes.

use super::{SVG, read, read_files, table};
use geometry::DVec2;

#[test]
fn a_word_that_is_nearly_a_thing_s_is_a_mistake() {
    // A slingshot with the class "sling-shot" was printed on the floor, and nobody said why it did not kick.
    let drawn = |class: &str| {
        let drawn = format!(r#"<path class="{class}" id="sling1" d="M80 640l34 76" data-group="g"/>"#);
        read(&drawn, "").unwrap_err()
    };
    assert_eq!(drawn("sling-shot"), ["table.svg:5: the class `sling-shot` means nothing; did you mean `slingshot`?"]);
    for (class, meant) in [("posts", "post"), ("Post", "post"), ("flippr", "flipper"), ("wall Rubbers", "rubber")] {
        let [mistake] = &drawn(class)[..] else { panic!("{:?}", drawn(class)) };
        assert!(mistake.ends_with(&format!("did you mean `{meant}`?")), "{mistake}");
    }
}

#[test]
fn another_word_is_told_once_and_words_for_art_are_legal() {
    let art = r#"<g class="wood relief plastics UnoptimicedTransforms"><path class="wood" d="M0 0h9"/></g>"#;
    assert!(table(art).warnings.is_empty());
    let riddles = r#"<path class="cloud" d="M0 0h9"/><path class="wood cloud" d="M0 0h9"/>
        <g class="posts"><g class="Relief"/></g><defs class="sky"/>"#;
    let warnings: Vec<String> = table(riddles).warnings.iter().map(ToString::to_string).collect();
    assert_eq!(
        warnings,
        [
            "warning: table.svg:5: the class `cloud` means nothing, so what has it is art",
            "warning: table.svg:6: the class `Relief` means nothing; did you mean `relief`?",
            "warning: table.svg:6: the class `posts` means nothing here: give each shape in it a class",
        ]
    );
}

#[test]
fn warnings_are_told_with_mistakes_and_after_them() {
    let told = read("<path class=\"cloud\" d=\"M0 0h9\"/>\n<line id=\"w\" class=\"wall\"/>", "x = 1").unwrap_err();
    let [line, number, cloud] = &told[..] else { panic!("{told:?}") };
    assert!(
        line.starts_with("table.svg:6: w: it has neither `x2` nor `y2`") && number.starts_with("table.toml:1: "),
        "{told:?}"
    );
    assert!(cloud.starts_with("warning: table.svg:5: "), "{cloud}");
}

#[test]
fn a_width_in_print_scales_all_that_is_drawn() {
    // Inkscape's pixels: 96 in an inch. A drawing of 420 x 900 mm was read as 1587 x 3402 mm.
    let svg = |size: &str, drawn: &str| SVG.replace("viewBox=\"0 0 500 1000\"", size).replace("{}", drawn);
    let drawn = r##"<circle id="p" class="post" cx="100" cy="300" r="4" fill="gray"/>
        <rect id="win" class="insert" x="200" y="200" width="40" height="20" fill="red"/>"##;
    let small = read_files(&svg("viewBox=\"0 0 500 1000\"", drawn), "", "").unwrap();
    let scale = |number: f64| number * 96.0 / 25.4;
    let size = format!("width=\"500mm\" height=\"1000mm\" viewBox=\"0 0 {} {}\"", scale(500.0), scale(1000.0));
    let inside = drawn.replace("id=\"win\"", "id=\"win\" stroke=\"red\"");
    let group = format!("<g transform=\"scale({})\">{inside}", scale(1.0));
    let pixels = svg(&size, "{}").replacen("<line", &format!("{group}<line"), 1).replace("{}", "</g>");
    let large = read_files(&pixels, "", "").unwrap();
    assert!((large.size_mm - DVec2::new(500.0, 1000.0)).length() < 1e-9, "{}", large.size_mm);
    assert!(large.warnings.is_empty());
    assert_eq!(large.layout.parts.len(), small.layout.parts.len());
    let first = |table: &crate::Table| table.layout.parts.iter().find(|part| part.name == "p").cloned().unwrap();
    let physics::Kind::Wall(wall) = first(&large).kind else { panic!() };
    let (distance, _) = wall.shapes[0].distance(DVec2::new(0.1, 0.3));
    assert!((distance + 0.004).abs() < 1e-12, "{distance}");
    let engraved =
        |svg: &str| svg.split("stroke-width:").nth(1).unwrap().split('"').next().unwrap().parse::<f64>().unwrap();
    assert!((engraved(&large.floor_svg) - 0.8).abs() < 1e-9, "0.8 mm, in the group's units");
}

#[test]
fn a_table_of_an_odd_size_is_warned_of() {
    let svg = SVG.replace("viewBox=\"0 0 500 1000\"", "viewBox=\"0 0 1587.4016 3401.5748\"").replace("{}", "");
    let table = read_files(&svg, "", "").unwrap();
    let [warning] = &table.warnings[..] else { panic!("{:?}", table.warnings) };
    assert!(
        warning.to_string().starts_with("warning: table.svg:1: the playfield is 1587.4 x 3401.57 mm, and a real one")
    );
}

#[test]
fn things_in_an_inner_svg_are_where_it_puts_them() {
    let drawn = r##"<svg x="100" y="200" width="100" height="100" viewBox="0 0 50 50" transform="translate(0 50)">
        <circle id="p" class="post" cx="10" cy="10" r="4" fill="gray"/></svg>"##;
    let table = table(drawn);
    let physics::Kind::Wall(wall) = &table.layout.parts[table.part("p").map_or(0, |id| usize::from(id.0))].kind else {
        panic!()
    };
    let (distance, _) = wall.shapes[0].distance(DVec2::new(0.12, 0.27));
    assert!((distance + 0.008).abs() < 1e-12, "{distance}");
}
