//! Art is printed as things are read: one cascade, the same colours, the same transforms.

use super::{VIEW, pixel};
use crate::art;
use crate::small_table::{SVG, read, read_svg, table};
use crate::table::Table;
use geometry::DVec2;
use tracer::View;

/// What is printed in the middle of a square millimetre of the floor.
fn printed(table: &Table, x: usize, y: usize) -> [u8; 3] {
    let art = art::floor(table, &VIEW).unwrap();
    let [red, green, blue, _] = pixel(&art.floor, x, y);
    [red, green, blue]
}

/// Nothing is printed here.
const BARE: [u8; 3] = [8, 8, 10];

#[test]
fn a_thing_and_art_of_one_style_have_one_colour() {
    // The art's rasteriser has a cascade of its own, which knows no case, no escapes, and for which the first of two
    // important declarations wins.
    let sheets = [
        ("* { fill: #ff8000 }", ""),
        (".s { FILL: #FF8000 /* orange */ }", ""),
        (".s { fill: #ff8000 icc-color(swop, 0, 0.5, 1, 0) }", ""),
        (".s { fill: rgb(255 128 0 / 100%) }", "fill=\"red\""),
        (".s { fill: hwb(30.1 0% 0%) }", ""),
        (".s { fill: oklch(0.7319 0.1858 52.985) }", ""),
        (".s { fill: red !important } .s.s { fill: #ff8000 !important }", "style=\"fill: blue\""),
        ("path.s:not(.t) { fill: #ff8000 } .t { fill: red }", ""),
        (".s:nth-child(odd), .s:nth-child(even) { fill: #ff8000 }", ""),
        ("@media print { .s { fill: red } } @media screen { .s { fill: #ff8000 } }", ""),
        (r".\73 { f\69ll: #ff8000 }", "fill=\"lime\""),
        (".s { fill: lime; fill: reddish } .s { fill: unset } g { fill: #ff8000 }", ""),
        (".s { color: #ff8000; fill: CurrentColor }", ""),
        ("", "style=\"fill:/* ; */ #f80000; Fill: #ff8000 !important; fill: red\""),
        ("", "fill=\"#ff8000 icc-color(swop, 0, 0.5, 1, 0)\""),
        ("", "style=\"fill:#ff8000 icc-color(swop, 0, 0.5, 1, 0)\""),
    ];
    for (sheet, rest) in sheets {
        let drawn = format!(
            r#"<style>{sheet}</style><g><path class="s" {rest} d="M100 100h50v50h-50z"/>
            <path id="win" class="insert s" {rest} d="M200 100h50v50h-50z"/></g>"#
        );
        let table = table(&drawn);
        let [thing] = &table.lamps[..] else { panic!() };
        assert_eq!(printed(&table, 120, 120), thing.color, "{sheet} {rest}");
        assert!(thing.color.iter().zip([255, 128, 0]).all(|(a, b)| a.abs_diff(b) <= 1), "{sheet}: {:?}", thing.color);
    }
}

#[test]
fn clones_of_things_are_no_art_and_clones_of_art_are() {
    let drawn = r##"<g id="bank"><circle id="a" class="bumper" cx="100" cy="100" r="20" fill="red"/>
        <rect x="140" y="90" width="20" height="20" fill="lime"/></g><use id="c" href="#bank" y="100"/>"##;
    let table = table(drawn);
    assert_eq!([printed(&table, 100, 100), printed(&table, 100, 200)], [BARE; 2]);
    assert_eq!([printed(&table, 150, 100), printed(&table, 150, 200)], [[0, 255, 0]; 2]);
}

#[test]
fn links_of_both_forms_lead_to_what_they_name() {
    let drawn = r##"<g xmlns:xlink="http://www.w3.org/1999/xlink"><linearGradient id="one"><stop stop-color="#ff8000"/></linearGradient>
        <linearGradient id="two" xlink:href="#one"/><linearGradient id="three" xlink:href="#none" href="#one"/>
        <rect id="star" x="100" y="100" width="50" height="50" fill="url(#two)"/>
        <rect x="200" y="100" width="50" height="50" fill="url(#three)"/>
        <g id="bank"><circle id="a" class="bumper" cx="400" cy="100" r="20"/><use xlink:href="#star" y="100"/></g>
        <use id="c" xlink:href="#bank" y="100"/></g>"##;
    let table = table(drawn);
    for (x, y) in [(120, 120), (220, 120), (120, 220), (120, 320)] {
        assert_eq!(printed(&table, x, y), [255, 128, 0], "{x} {y}");
    }
}

#[test]
fn an_inner_svg_is_transformed_once() {
    // usvg 0.45 applies transform and opacity of an inner <svg> twice (linebender/resvg, issue 1066).
    let drawn = r##"<svg transform="translate(50 50)" width="40" height="40" style="overflow:visible">
        <rect width="20" height="20" fill="#f00"/></svg>
        <svg x="200" y="200" width="40" height="40" opacity="0.5"><rect width="40" height="40" fill="#fff"/></svg>
        <svg x="300" y="300" width="40" height="40"><rect width="90" height="40" fill="#fff"/></svg>"##;
    let table = table(drawn);
    assert_eq!((printed(&table, 60, 60), printed(&table, 110, 110)), ([255, 0, 0], BARE));
    let [red, ..] = printed(&table, 220, 220);
    assert!(red.abs_diff(131) <= 2, "half of white and half of the floor: {red}");
    assert_eq!((printed(&table, 320, 320), printed(&table, 350, 320)), ([255; 3], BARE), "it is still cut at its edge");
}

#[test]
fn what_lies_in_a_layer_serves_art_in_another() {
    // Inkscape leaves a gradient where it was made; when that was the relief layer, what it filled was not printed.
    let drawn = r##"<g class="relief"><linearGradient id="glow"><stop stop-color="#ff8000"/></linearGradient>
        <path id="star" d="M300 100h50v50h-50z" fill="#808080"/></g>
        <g class="plastics"><pattern id="dots" width="1" height="1"><rect width="50" height="50" fill="#0f0"/></pattern></g>
        <rect x="100" y="100" width="50" height="50" fill="url(#glow)"/>
        <rect x="200" y="100" width="50" height="50" style="fill:url('#dots')"/><use href="#star" y="100"/>"##;
    let table = table(drawn);
    assert_eq!(printed(&table, 120, 120), [255, 128, 0]);
    assert_eq!(printed(&table, 220, 120), [0, 255, 0]);
    assert_eq!(
        (printed(&table, 320, 120), printed(&table, 320, 220)),
        (BARE, [0x80; 3]),
        "relief is not printed itself"
    );
    assert!(table.normal_map.height_svg.is_some());
}

#[test]
fn art_of_a_page_in_other_units_is_printed_in_millimetres() {
    let size = "width=\"500mm\" height=\"1000mm\" viewBox=\"0 0 2000 4000\"";
    let large = SVG.replace("viewBox=\"0 0 500 1000\"", size).replace("<line", "<line transform=\"scale(4)\"");
    let table =
        read_svg(&large.replace("{}", r##"<rect x="400" y="400" width="200" height="200" fill="#f00"/>"##)).unwrap();
    assert_eq!(table.size_mm, DVec2::new(500.0, 1000.0));
    assert_eq!((printed(&table, 101, 101), printed(&table, 148, 148)), ([255, 0, 0], [255, 0, 0]));
    assert_eq!((printed(&table, 98, 120), printed(&table, 152, 120)), (BARE, BARE));
    let view = View { width: 60, height: 40, origin_mm: DVec2::new(95.0, 95.0), mm_per_px: 0.5 };
    assert_eq!(art::floor(&table, &view).unwrap().floor[11 * 60 + 11], [255, 0, 0, 255]);
}

#[test]
fn art_that_draws_itself_is_told_by_its_ids() {
    // It was "SVG data parsing failed cause nodes limit reached".
    let circle = r##"<defs><g id="a"><use href="#b"/></g><g id="b"><use href="#a"/></g></defs><use href="#a"/>"##;
    let mistakes = read(circle, "").unwrap_err();
    assert_eq!(
        mistakes,
        [
            "table.svg:5: #a and what it refers to refer to each other without end: #a -> #b -> #a; take this reference out"
        ]
    );
    let masks = r##"<mask id="m"><path mask="url(#n)"/></mask><mask id="n"><path mask="url(#o)"/></mask>
        <mask id="o"><path mask="url(#m)"/></mask><rect width="9" height="9" mask="url(#m)"/>"##;
    assert!(read(masks, "").unwrap_err()[0].contains("#m -> #n -> #o -> #m"));
}
