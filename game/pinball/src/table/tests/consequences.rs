//! A cause is told, and what comes of it is not.

use super::{SVG, one, read_files};

/// A hidden layer was told as a table without flipper, drain and plunger, and as names that no thing has.
#[test]
fn what_a_hidden_layer_takes_away_is_told_as_that() {
    let hidden = SVG.replace("1000\">", "1000\"><g id=\"all\" display=\"none\">").replace("</svg>", "</g></svg>");
    let told = one(read_files(&hidden.replace("{}", ""), "[part.left]\nmaterial = \"rubber\"\n", "").unwrap_err());
    let layer = "table.svg:1: this g `all` is hidden (`display: none`), so the 3 things in it are not on the table; show it, or \
                 delete it";
    assert_eq!(told, layer);
    let post = "<g id=\"all\" display=\"none\"><circle class=\"post\" cx=\"9\" cy=\"9\" r=\"4\"/></g>";
    let table = read_files(&SVG.replace("{}", post), "", "").expect("nothing comes of it");
    assert_eq!(table.warnings.len(), 1, "{:?}", table.warnings);
}

/// A page out of proportion made captive balls too small.
#[test]
fn what_a_page_out_of_proportion_shrinks_is_told_as_that() {
    let ball = "<circle id=\"ball\" class=\"captive-ball\" cx=\"200\" cy=\"300\" r=\"13.5\"/>";
    let page = SVG.replace("{}", ball).replace("viewBox", "width=\"500mm\" height=\"950mm\" viewBox");
    let told = one(read_files(&page, "", "").unwrap_err());
    assert!(told.starts_with("table.svg:1: width and height do not fit the viewBox"), "{told}");
}
