//! Where a ball can come to from the plunger, and where it can leave the playfield.

use super::{WALLS, playtest, playtest_of, sentences};
use crate::playtest::FindingKind;
use crate::table::tests::with_rules;
use geometry::{DVec2, Shape};

/// A box with a lid.
fn comes_into(lid: &str, side: &str) -> bool {
    let walls = format!(r#"<path class="wall" d="M200 300V400H260V{side}" fill="none" stroke-width="4"/>"#);
    let playtest = playtest(&format!("{lid}{walls}"));
    playtest.reach.comes_to(&Shape::disc(DVec2::new(0.23, 0.37), 0.0), 0.0)
}

/// A ball was let go behind a gate through which none comes, and what it then lay beside was told.
#[test]
fn a_ball_comes_through_a_gate_one_way() {
    let lid =
        |class: &str, more: &str| format!(r#"<line class="{class}" x1="203" y1="300" x2="257" y2="300" {more}/>"#);
    for y in ["300", "301"] {
        assert!(!comes_into(&lid("gate", r#"id="lid" data-way="up""#), y), "{y}");
    }
    assert!(comes_into(&lid("gate", r#"id="lid" data-way="down""#), "300"));
    assert!(comes_into(&lid("spinner", r#"id="lid""#), "300"), "both ways");
    assert!(comes_into(&lid("gate", r#"id="lid" data-way="up""#), "370"), "beside the gate");
}

/// Of a table whose plunger shoots no ball out, nobody could tell what is wrong with its lane.
#[test]
fn the_lane_of_a_plunger_that_fails_is_tried_too() {
    let lid = r#"<path class="wall" id="beam" d="M460 400H500" fill="none" stroke-width="4"/>"#;
    let gate = r#"<line class="gate" id="lid" x1="462" y1="300" x2="498" y2="300" data-way="up"/>"#;
    let playtest = playtest(&format!("{lid}{gate}"));
    assert_eq!(playtest.launch().len(), 1);
    assert!(playtest.reach.comes_to(&Shape::disc(DVec2::new(0.48, 0.37), 0.0), 0.0));
}

/// A wide gap was told of what stands inside of it.
#[test]
fn a_gap_is_told_of_the_wall_that_ends() {
    let walls = WALLS.replace("H500V1000", "H500V300").replace("M460 200V970H500", "M460 200V970H498");
    let playtest = playtest_of(with_rules(&walls, ""));
    let [told] = &sentences(&playtest, playtest.open_edges())[..] else { panic!() };
    assert!(told.contains(": frame: a ball can leave the playfield beside it"), "{told}");
}

/// A gap in a round cabinet was told at the corner of the page, 300 mm away.
#[test]
fn a_gap_in_a_round_frame_is_told_where_it_is() {
    let round = "M10 1000V255A240 240 0 0 1 230 15.8M270 15.8A240 240 0 0 1 490 255V1000";
    let walls = WALLS.replace("M10 1000V10H500V1000", round).replace("M500 90L420 10", "M490 300L470 260");
    let playtest = playtest_of(with_rules(&walls, ""));
    let findings = playtest.open_edges();
    let [told] = &sentences(&playtest, findings.clone())[..] else { panic!("{findings:?}") };
    assert!(told.starts_with("table.svg:5: frame: a ball can leave the playfield beside it, at 25"), "{told}");
    assert!(findings[0].place_mm.distance(DVec2::new(250.0, 13.0)) < 3.0, "{told}");
}

/// A ramp that begins 60 or 8 mm above the playfield, and a wire-form that begins 15 mm above the ramp's end: no ball came
/// onto them, for none climbs and none lands on a ramp, and they were called good.
#[test]
fn a_ramp_whose_entry_no_ball_comes_to_is_told() {
    let told = |ramp: &str, wire: &str| {
        let drawn = format!(
            r#"<path class="ramp" id="way" d="M200 600V400" data-heights-mm="{ramp}" stroke-width="40" fill="none"/>
<path class="wire-form" id="wire" d="M200 400V250" data-heights-mm="{wire}" stroke-width="30" fill="none"/>"#
        );
        let playtest = playtest(&drawn);
        let findings = playtest.unreachable();
        assert!(findings.iter().all(|finding| finding.kind == FindingKind::Unreachable));
        sentences(&playtest, findings)
    };
    assert_eq!(told("0 50", "50 40"), Vec::<String>::new());
    assert_eq!(told("0 50", "46 40"), Vec::<String>::new(), "joined");
    assert_eq!(told("1 50", "50 40"), Vec::<String>::new(), "on the playfield");
    for entry in ["60", "8"] {
        let expected = format!(
            "warning: table.svg:9: way: no ball can come onto it: its ends are {entry} and 50 mm above the playfield, and no \
             ramp that a ball can be on is joined to them; begin its data-heights-mm with 0, so that a ball rolls in"
        );
        assert_eq!(told(&format!("{entry} 50"), "50 40"), [expected], "of two ramps that are joined one is told");
    }
    for (end, other) in [("35", "50"), ("60", "50")] {
        let expected = format!(
            "warning: table.svg:10: wire: no ball can come onto it: its end beside that of way (line 9) is {other} mm high and \
             that of way (line 9) {end} mm, and a ball falls down between the two; give both the same height there in \
             data-heights-mm"
        );
        assert_eq!(told(&format!("0 {end}"), "50 40"), [expected]);
    }
    // Both ways: the wire-form's far end lies on the playfield.
    assert_eq!(told("60 50", "50 0"), Vec::<String>::new());
}
