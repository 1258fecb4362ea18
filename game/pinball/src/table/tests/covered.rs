//! Inserts that nobody sees, and walls that cover the table.

use super::{one, read_files, warned};

const INSERT: &str = "<circle id='arrow' class='insert' cx='200' cy='300' r='8' fill='#f40'/>";

/// Inserts under a bumper, a wall and a plastic were called good.
#[test]
fn an_insert_wholly_under_what_is_opaque_is_told() {
    for (over, name) in [
        ("<circle class='bumper' id='pop' cx='203' cy='300' r='25'/>", "pop"),
        ("<line class='wall' id='bar' x1='100' y1='300' x2='400' y2='300' stroke-width='30'/>", "bar"),
        ("<line class='wall' id='bar' x1='100' y1='301' x2='400' y2='301' stroke-width='16'/>", "bar"),
        ("<path class='plastic' id='lid' d='M150 250H250V350H150Z'/>", "lid"),
        ("<circle class='plastic' id='lid' cx='200' cy='300' r='30'/>", "lid"),
    ] {
        let told = format!("6: arrow: it lies wholly under {name} of line 5, so nobody sees it; draw it beside that");
        assert_eq!(one(warned(&format!("{over}\n{INSERT}"))), told);
    }
}

#[test]
fn an_insert_that_is_seen_or_shines_through_is_left_alone() {
    for over in [
        "<circle class='bumper' id='pop' cx='220' cy='300' r='25'/>",
        "<path class='wall' id='ring' d='M150 250H250V350H150Z' fill='none' stroke-width='4'/>",
        "<line class='drop-target' id='drop' x1='100' y1='300' x2='400' y2='300' stroke-width='30'/>",
    ] {
        assert_eq!(warned(&format!("{over}\n{INSERT}")), [""; 0], "{over}");
    }
    let plastic = format!("<path class='plastic' id='lid' d='M150 250H250V350H150Z'/>{INSERT}");
    let toml = "[finish.clear]\ntranslucency = 0.3\n[class.plastic]\nfinish = \"clear\"\n";
    let clear = read_files(&super::SVG.replace("{}", &plastic), toml, "");
    assert!(clear.expect("it is sound").warnings.is_empty());
}

/// Two inserts in one place looked like one.
#[test]
fn two_inserts_in_one_place_are_told_with_both_lines() {
    let twin = INSERT.replace("arrow", "twin").replace("200", "200.1");
    let told =
        "6: twin: it lies exactly where arrow of line 5 does, so both look like one; move it, or take one of them out";
    assert_eq!(one(warned(&format!("{INSERT}\n{twin}"))), told);
    assert_eq!(warned(&format!("{INSERT}\n{}", twin.replace("r='8'", "r='5'"))), [""; 0], "a ring");
}

/// The outer wall was filled: every lamp was told to stand in it, and the wall was not.
#[test]
fn a_wall_that_is_filled_over_the_table_is_told_alone() {
    let lamp = "<circle id='gi' class='lamp' cx='200' cy='400' r='4' fill='#fff'/>";
    let wall = "<path class='wall' id='outer' d='M5 5H495V995H5Z' fill='#6b4425' stroke-width='8'/>";
    let told = "5: outer: it is filled, so its top lies over 99 % of the playfield and hides what is there; write fill=\"none\"";
    assert_eq!(one(warned(&format!("{wall}\n{lamp}{INSERT}"))), told);
}
