//! What is said and shows nothing: numbers that leave a part idle, finishes of nothing, lamps in what is opaque.

use super::{read, table};

/// What is warned of with these numbers, and `drawn` from line 5 of the drawing on.
#[track_caller]
fn warned(drawn: &str, numbers: &str) -> Vec<String> {
    let warnings = read(drawn, numbers).unwrap().warnings;
    warnings.iter().map(|one| one.to_string().replacen("warning: table.", "", 1)).collect()
}

const LAMP: &str = "<circle class='lamp' id='gi' cx='200' cy='300' r='4' fill='red'/>";
const BUMPER: &str = "<circle class='bumper' id='pop' cx='200' cy='300' r='25'/>";

/// A lamp of power 0, a slingshot that never kicks, a saucer that every ball rolls over: check said ok.
#[test]
fn numbers_that_leave_a_part_idle_are_told() {
    let sling = "<line class='slingshot' id='sl' x1='99' y1='99' x2='99' y2='160' stroke-width='4'/>";
    let saucer = "<circle class='saucer' id='hole' cx='99' cy='99' r='14' data-eject-deg='90' data-eject-m-s='1'/>";
    for (drawn, words, number, idle) in [
        (LAMP, "class.lamp", "power = 0", "gi: with `power` = 0 it is dark whatever the rules say; a usual lamp has 1"),
        (LAMP, "part.gi", "power = 0.0", "gi: with `power` = 0 it is dark"),
        (BUMPER, "class.bumper", "kick_m_s = 0", "pop: with `kick_m_s` = 0 this bumper kicks no ball"),
        (sling, "part.sl", "kick_m_s = 0.01", "sl: with `kick_m_s` = 0.01 this slingshot kicks no ball"),
        (saucer, "class.saucer", "capture_m_s = 0.1", "hole: with `capture_m_s` = 0.1 nearly every ball rolls over it"),
        (saucer, "class.saucer", "capture_m_s = 20", "hole: with `capture_m_s` = 20 no ball is ever too fast for it"),
        (
            BUMPER,
            "class.bumper",
            "threshold_m_s = 2.9",
            "pop: with `threshold_m_s` = 2.9 hardly any ball is fast enough for this bumper; 0.05 is",
        ),
        (
            sling,
            "part.sl",
            "threshold_m_s = 2.5",
            "sl: with `threshold_m_s` = 2.5 hardly any ball is fast enough for this slingshot",
        ),
    ] {
        let told = warned(drawn, &format!("[{words}]\n{number}"));
        assert!(told.len() == 1 && told[0].starts_with(&format!("toml:2: {idle}")), "{told:?}");
    }
    assert_eq!(
        warned(
            &format!("{LAMP}{BUMPER}{}", LAMP.replace("gi", "two").replace("200", "300")),
            "[class.lamp]\npower = 0.5\n[class.bumper]\nkick_m_s = 0.3\n[class.slingshot]\nkick_m_s = 0\n"
        )
        .len(),
        1,
        "the lamp in the bumper"
    );
}

#[test]
fn a_finish_that_nothing_has_is_told() {
    let finish = "[finish.gold]\ngloss = 0.9\n";
    let idle = "toml:1: nothing has the finish `gold`; write finish = \"gold\" to a [class.NAME] or a [part.ID], \
                data-finish=\"gold\" to a thing, or take it out";
    assert_eq!(warned("", finish), [idle]);
    assert_eq!(warned("", &format!("{finish}[class.wall]\nfinish = \"gold\"")), [""; 0]);
    assert_eq!(warned("", &format!("{finish}[part.left]\nfinish = \"gold\"")), [""; 0]);
    assert_eq!(warned("<line class='wall' x1='9' y1='9' x2='40' y2='9' data-finish='gold'/>", finish), [""; 0]);
}

/// A lamp that stood elsewhere than in its bumper was not told: a transform had moved the bumper away.
#[test]
fn a_lamp_that_does_not_stand_in_what_it_names_is_told() {
    let lamp = LAMP.replace("id=", "data-inside='pop' id=");
    let away = "svg:6: gi: it has data-inside=\"pop\", and stands 75 mm outside of pop of line 5; draw it in there, or leave that out";
    let moved = BUMPER.replace("cx='200'", "cx='300'");
    assert_eq!(warned(&format!("{moved}\n{lamp}"), ""), [away]);
    let near = BUMPER.replace("cx='200'", "cx='224'");
    assert_eq!(warned(&format!("{near}\n{lamp}"), ""), [""; 0]);
    let ring = "<path id='pop' class='wall' d='M150 250h100v100h-100z' fill='none' stroke-width='4'/>";
    assert_eq!(warned(&format!("{ring}\n{lamp}"), ""), [""; 0], "walls round it");
}

/// A lamp in a bumper without `data-inside` lit nothing.
#[test]
fn a_lamp_in_something_that_casts_a_shadow_is_told() {
    let told = warned(&format!("{BUMPER}\n{LAMP}"), "");
    let expected = "svg:6: gi: it stands in pop of line 5, which lets none of its light out; draw it beside that, or write \
                    data-inside=\"pop\"";
    assert_eq!(told, [expected]);
    let block = "<rect class='wall' id='w' x='150' y='250' width='100' height='100' fill='gray' stroke='gray'/>";
    assert!(warned(&format!("{block}\n{LAMP}"), "")[0].starts_with("svg:6: gi: it stands in w of line 5"));
    let tube = "<line class='lamp' id='gi' x1='180' y1='300' x2='220' y2='300' stroke='red'/>";
    assert!(warned(&format!("{tube}\n{BUMPER}"), "")[0].starts_with("svg:5: gi: it stands in pop of line 6"));
    for good in [
        format!("{BUMPER}{}", LAMP.replace("id=", "data-inside='pop' id=")),
        format!("{BUMPER}{}", LAMP.replace("cy='300'", "cy='330'")),
        format!("{}{LAMP}", block.replace("'gray' stroke", "'none' stroke")),
        format!("<circle class='plastic' cx='200' cy='300' r='25' fill='red'/>{LAMP}"),
        format!("<g data-group='pop'>{BUMPER}</g>{}", LAMP.replace("id=", "data-inside='pop' id=")),
    ] {
        assert_eq!(warned(&good, ""), [""; 0], "{good}");
    }
    assert_eq!(warned(&format!("{BUMPER}{LAMP}"), "[class.bumper]\nshadow = false"), [""; 0]);
}

/// Of a drawing of 20,000 walls it was also told that it had no drain.
#[test]
fn of_a_drawing_that_a_limit_refuses_nothing_more_is_told() {
    let walls = "<line class='wall' x1='9' y1='9' x2='40' y2='9'/>".repeat(20_001);
    let svg = format!("<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 500 1000'>{walls}</svg>");
    let told = super::read_files(&svg, "[part.pop]\nkick_m_s = 1", "").unwrap_err();
    assert_eq!(told, ["table.svg:1: there are more than 20000 things"]);
    let corners = "9 9 40 40 ".repeat(500);
    let walls = format!("<polyline class='wall' points='{corners}'/>").repeat(300);
    let svg = format!("<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 500 1000'>{walls}</svg>");
    let told = super::read_files(&svg, "", "").unwrap_err();
    assert!(told.len() == 1 && told[0].contains("more than 200000 pieces"), "{told:?}");
    assert!(table("").warnings.is_empty());
}
