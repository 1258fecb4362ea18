//! Sheets are read as a browser reads them, for things as for art.

use super::{SVG, read, read_files, table};
use crate::table::Table;
use physics::Kind;

/// Thickness, mm, and colour of the line `w`.
fn line(drawn: &str) -> (f64, [u8; 3]) {
    let table = table(drawn);
    let id = table.part("w").unwrap();
    let Kind::Wall(wall) = &table.layout.parts[usize::from(id.0)].kind else { panic!() };
    let solid = table.solids.iter().find(|solid| solid.part == Some(id)).unwrap();
    ((wall.shapes[0].radius * 2e6).round() / 1e3, solid.finish.albedo)
}

const RED: [u8; 3] = [255, 0, 0];
const BLUE: [u8; 3] = [0, 0, 255];

#[test]
fn a_sheet_is_heard_where_a_thing_says_nothing() {
    // A wall whose look stood in a sheet was one millimetre thick and filled with black.
    let drawn = |sheet: &str| {
        line(&format!(r#"<path id="w" class="wall outer" d="M10 100 V50"/><style id="st">{sheet}</style>"#))
    };
    assert_eq!(drawn("#w{fill:none;stroke:#f00;stroke-width:6}"), (6.0, RED));
    assert_eq!(drawn(".outer { STROKE-WIDTH : 6PX; stroke: RED /* ; */ }"), (6.0, RED));
    assert_eq!(drawn("<![CDATA[ svg > path.wall { stroke: rgb(255 0 0); stroke-width: 6 } ]]>"), (6.0, RED));
    assert_eq!(drawn("path:not(.inner)[d], nobody { stroke-width: 6; stroke: red }"), (6.0, RED));
    assert_eq!(
        drawn("@media print { path { stroke: blue } } @media screen { path { stroke-width: 6; stroke: red } }"),
        (6.0, RED)
    );
    assert_eq!(drawn("path { stroke-width: 6; fill }  path:hover { stroke: blue } * { stroke: red }"), (6.0, RED));
    assert_eq!(drawn("PATH { stroke-width: 9 } path { stroke-width: 6; stroke: red }"), (6.0, RED));
}

#[test]
fn the_cascade_is_css_s() {
    let drawn = |sheet: &str, rest: &str| {
        line(&format!(
            r#"<style>{sheet}</style><g stroke="lime"><path id="w" class="wall" d="M10 100 V50" {rest}/></g>"#
        ))
        .1
    };
    assert_eq!(drawn("path { stroke: red }", r#"stroke="blue""#), RED, "a sheet before an attribute");
    assert_eq!(drawn("path { stroke: blue }", r#"style="stroke: red""#), RED, "a style before a sheet");
    assert_eq!(
        drawn("path { stroke: red !important }", r#"style="stroke: blue""#),
        RED,
        "what is important before both"
    );
    assert_eq!(drawn("path { stroke: blue !important }", r#"style="stroke: red ! IMPORTANT""#), RED);
    assert_eq!(drawn("#w { stroke: red } .wall { stroke: blue }", ""), RED, "an id before a class");
    assert_eq!(drawn("g .wall { stroke: red } .wall { stroke: blue }", ""), RED, "two words before one");
    assert_eq!(drawn("path { stroke: blue } path { stroke: red }", ""), RED, "the later before the earlier");
    assert_eq!(drawn("g { stroke: red }", ""), RED, "from an ancestor");
    assert_eq!(drawn("path { stroke: red; stroke: reddish }", ""), RED, "what is no colour says nothing");
    assert_eq!(drawn("path { stroke: inherit } g { stroke: red }", r#"stroke="blue""#), RED);
    assert_eq!(drawn("g { color: red }", r#"stroke="currentColor""#), RED);
    assert_eq!(drawn("path { stroke: unset }", r#"style="color: red""#), [0, 255, 0]);
}

#[test]
fn colours_have_every_form_of_css_and_of_a_printing_press() {
    for red in ["#f00", "RED", "rgb(100%,0%,0%)", "hsl(0deg 100% 50%)", "hwb(0 0% 0%)", "#ff0000 icc-color(a, 1, 0.5)"]
    {
        assert_eq!(line(&format!(r#"<path id="w" class="wall" d="M9 99V50" stroke="{red}"/>"#)).1, RED, "{red}");
        assert_eq!(line(&format!(r#"<path id="w" class="wall" d="M9 99V50" style="stroke:{red}"/>"#)).1, RED, "{red}");
    }
}

#[test]
fn a_copy_meets_selectors_without_what_is_around_the_original() {
    // SVG 2, 5.6.1: a rule for what is in a group means nothing in a copy of one element of it.
    let sheet =
        "<style>.outer path { stroke-width: 9 } path { stroke: red; stroke-width: 4 } #p { stroke: blue }</style>";
    let drawn = r##"<g class="outer"><path id="p" class="wall" d="M10 100 V50"/></g><use id="w" href="#p" x="9"/>"##;
    assert_eq!(line(&format!("{sheet}{drawn}")), (4.0, BLUE));
}

#[test]
fn things_that_a_sheet_hides_are_not_there() {
    let hidden = r#"<style>.off { display: none }</style><g class="off"><line class="wall" x2="9"/></g>"#;
    assert_eq!(table(hidden).layout.parts.len(), 3);
}

#[test]
fn a_place_in_a_sheet_is_a_mistake() {
    // Browsers move an element by its style; the art's rasteriser does so sometimes, and never as far.
    let mistake = |sheet: &str, rest: &str| {
        let drawn = format!(r#"<style>{sheet}</style><g><circle id="w" class="post" cx="9" cy="9" r="4" {rest}/></g>"#);
        read(&drawn, "").unwrap_err().join("\n")
    };
    assert!(mistake("circle { r: 9px }", "").contains("5: w: its style, or one around it, sets `r`"));
    assert!(mistake("g { Transform: rotate(9deg) }", "").contains("sets `transform`"));
    assert!(mistake("", "transform-origin=\"9 9\"").contains("sets `transform-origin`"));
}

#[test]
fn a_class_that_a_sheet_names_is_no_riddle() {
    assert_eq!(warnings(&table(r#"<style>.cls-1{fill:red}</style><path class="cls-1" d="M0 0h9"/>"#)), [""; 0]);
}

#[test]
fn what_is_not_read_of_a_sheet_is_told() {
    let odd = "<style>\n@import 'a.css';\npath::before { fill: red }\ng:has(a) {}\n@font-face { src: none }</style>";
    assert_eq!(
        warnings(&table(odd)),
        [
            "warning: table.svg:6: the rule `@import 'a.css'` of this sheet is not read",
            "warning: table.svg:7: the rule `path::before` of this sheet is not read",
            "warning: table.svg:8: the rule `g:has(a)` of this sheet is not read"
        ]
    );
}

#[test]
fn sheets_without_end_are_refused() {
    let refused = |sheet: &str, drawn: &str| {
        let svg = SVG.replace("{}", &format!("<style>{sheet}</style>{drawn}"));
        read_files(&svg, "", "").unwrap_err().join("\n")
    };
    let nested = format!(":is({}){{}}", ".a .b,".repeat(10_000) + ".c");
    let said = refused(&nested, &"<g><g/></g>".repeat(10_000));
    assert!(said.contains("comparisons, and at most"), "{said}");
    let said = refused(&"path{fill:red}".repeat(30_000), "");
    assert!(said.contains("table.svg:5: the sheets have more than 256 kB"), "{said}");
    let said = refused(&format!("{}path{}{{}}", ":not(".repeat(9000), ")".repeat(9000)), "");
    assert!(said.contains("more than 24 brackets lie inside each other"), "{said}");
    let said = refused(&"a b c{fill:red}".repeat(9000), &"<g/>".repeat(20_000));
    assert!(said.contains("comparisons"), "{said}");
    let said = refused(&"a ~ b{fill:red}".repeat(100), &"<g/>".repeat(20_000));
    assert!(said.contains("comparisons"), "{said}");
    let long = format!("g{{--a:{}}}", "x".repeat(200_000));
    let said = refused(&long, &"<g/>".repeat(2000));
    assert!(said.contains("more than 32 MB"), "{said}");
    let value = format!(r#"<path id="w" class="wall" d="M9 9V50" style="fill:{}"/>"#, "(".repeat(200_000));
    assert!(read(&value, "").is_ok());
}

fn warnings(table: &Table) -> Vec<String> {
    table.warnings.iter().map(ToString::to_string).collect()
}
