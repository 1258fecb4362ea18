//! What the playtest finds on small tables with one fault each, and that Spectrum has none.

mod places;
mod reach;
mod switches;
mod whole_game;

use super::{FindingKind, Playtest};
use crate::Table;
use crate::table::tests::{spectrum, with_rules};
use geometry::DVec2;
use physics::Kind;
use std::sync::Arc;

/// Walls round the small table: a lane for the plunger, a bend at its top, and ways down to the drain.
const WALLS: &str = r#"<path class="wall" id="frame" d="M10 1000V10H500V1000" fill="none" stroke-width="8"/>
<path class="wall" id="lane" d="M460 200V970H500" fill="none" stroke-width="4"/>
<path class="wall" id="bend" d="M500 90L420 10" fill="none" stroke-width="6"/>
<path class="wall" id="ways" d="M10 860L100 985M460 860L400 985" fill="none" stroke-width="6"/>"#;

fn playtest(drawn: &str) -> Playtest {
    playtest_of(with_rules(&format!("{WALLS}\n{drawn}"), ""))
}

fn playtest_of(table: Table) -> Playtest {
    Playtest::new(&Arc::new(table)).unwrap()
}

/// What is told of 400 balls.
fn let_go(playtest: &Playtest) -> Vec<String> {
    let findings = playtest.places(400).into_iter().filter_map(|place| playtest.let_go(place)).collect();
    sentences(playtest, playtest.merged(findings))
}

fn sentences(playtest: &Playtest, findings: Vec<super::Finding>) -> Vec<String> {
    findings.iter().map(|finding| finding.failure(&playtest.table).to_string()).collect()
}

#[test]
fn a_table_without_faults_has_no_findings() {
    let playtest = playtest(r#"<circle class="bumper" id="pop" cx="200" cy="400" r="30"/>"#);
    assert_eq!(playtest.launch(), []);
    assert_eq!(playtest.coils(), []);
    assert_eq!(playtest.unreachable(), []);
    assert_eq!(playtest.open_edges(), []);
    assert_eq!(let_go(&playtest), Vec::<String>::new());
}

/// A plunger drawn from its handle to its tip shot every ball into the floor of its lane: the table could not be played,
/// and was called good.
#[test]
fn a_plunger_that_points_down_is_told() {
    let svg = include_str!("tests/plunger_upside_down.svg");
    let playtest = playtest_of(crate::table::tests::read_svg(svg));
    let told = sentences(&playtest, playtest.launch().to_vec());
    assert_eq!(told.len(), 1);
    let expected = "table.svg:8: plunger: new balls arrive before it at 484, 1022 mm, which is inside wall#2 (line 5): draw it from";
    assert!(told[0].starts_with(expected), "{told:?}");
    assert_eq!(playtest.unreachable(), [], "that is a consequence");
}

#[test]
fn a_lane_that_leads_straight_up_gives_the_ball_back() {
    let straight = WALLS.replace("M500 90L420 10", "M460 200V10");
    let playtest = playtest_of(with_rules(&straight, ""));
    assert_eq!(playtest.launch()[0].kind, FindingKind::Unlaunched);
}

/// A gate that lets nobody out of the lane was told as a plunger that does not shoot.
#[test]
fn what_the_ball_turns_back_at_is_named() {
    let gate = r#"<line class="gate" id="one-way" x1="500" y1="400" x2="460" y2="400" data-way="down"/>"#;
    let playtest = playtest(gate);
    let told = sentences(&playtest, playtest.launch().to_vec());
    assert_eq!(told.len(), 1, "{told:?}");
    assert!(told[0].contains("plunger: the ball comes back to it"), "{told:?}");
    assert!(told[0].contains("beside one-way (line 9)"), "{told:?}");
}

/// A ball in a pocket behind a flipper's base touches the flipper, which only jogs it: the pocket was excused.
#[test]
fn a_pocket_behind_a_flipper_is_none_that_the_player_can_empty() {
    let flipper =
        r#"<line class="flipper" id="bat" x1="200" y1="600" x2="270" y2="630" data-side="left" data-up-deg="50"/>"#;
    let behind = r#"<path class="wall" id="corner" d="M140 540V575L190 602" fill="none" stroke-width="4"/>"#;
    let guide = r#"<path class="wall" id="rail" d="M110 540L193 592" fill="none" stroke-width="4"/>"#;
    let stuck = |drawn: &str| {
        let playtest = playtest(drawn);
        let findings = playtest.places(3000).into_iter().filter_map(|place| playtest.let_go(place)).collect();
        sentences(&playtest, playtest.merged(findings))
    };
    assert_eq!(stuck(&format!("{flipper}{guide}")), Vec::<String>::new());
    let told = stuck(&format!("{flipper}{behind}"));
    assert_eq!(told.len(), 1, "{told:?}");
    assert!(told[0].starts_with("table.svg:9: corner: a ball lies still beside it at 184, 581 mm"), "{told:?}");
}

/// A pocket between two walls was told of each.
#[test]
fn a_pocket_is_told_once_whatever_its_walls() {
    let west = r#"<path class="wall" id="west" d="M150 300L228 360" fill="none" stroke-width="4"/>"#;
    let east = r#"<path class="wall" id="east" d="M232 360L310 300" fill="none" stroke-width="4"/>"#;
    let told = let_go(&playtest(&format!("{west}{east}")));
    assert_eq!(told.len(), 1, "{told:?}");
}

#[test]
fn a_feed_inside_a_wall_is_told_with_the_wall() {
    let playtest = playtest(r#"<circle class="post" id="stud" cx="490" cy="880" r="6"/>"#);
    let told = sentences(&playtest, playtest.launch().to_vec());
    assert!(
        told[0].contains("plunger: new balls arrive before it at 480, 885 mm, which is inside stud (line 9)"),
        "{told:?}"
    );
}

#[test]
fn a_pocket_is_told_with_its_wall_and_how_many_balls_it_has_caught() {
    let playtest =
        playtest(r#"<path class="wall" id="cup" d="M150 300L230 360L310 300" fill="none" stroke-width="4"/>"#);
    let told = let_go(&playtest);
    assert_eq!(told.len(), 1, "{told:?}");
    assert!(told[0].starts_with("table.svg:9: cup: a ball lies still beside it at 230, 34"), "{told:?}");
    assert!(told[0].contains(" times): close the pocket"), "{told:?}");
}

#[test]
fn a_gap_in_the_frame_is_told_with_the_wall_beside_it() {
    let gap = WALLS.replace("M10 1000V10H500V1000", "M10 1000V500M10 420V10H500V1000");
    let playtest = playtest_of(with_rules(&gap, ""));
    let told = sentences(&playtest, playtest.open_edges());
    assert!(
        told[0].starts_with("table.svg:5: frame: a ball can leave the playfield beside it, at 7, 459 mm"),
        "{told:?}"
    );
    assert_eq!(told.len(), 1);
}

#[test]
fn a_way_is_a_way_if_a_ball_fits_through() {
    let target = |width: f64| {
        let (left, right) = (300.0 - 0.5 * width - 2.0, 300.0 + 0.5 * width + 2.0);
        let drawn = format!(
            r#"<line class="target" id="hidden" x1="280" y1="300" x2="320" y2="300"/>
<path class="wall" d="M{left} 400H240V280H360V400H{right}" fill="none" stroke-width="4" stroke-linecap="butt"/>"#
        );
        playtest(&drawn).unreachable().iter().map(|finding| finding.kind).collect::<Vec<_>>()
    };
    assert_eq!(target(26.9), [FindingKind::Unreachable]);
    assert_eq!(target(27.5), []);
}

#[test]
fn a_saucer_in_a_box_keeps_its_ball() {
    let saucer =
        r#"<circle class="saucer" id="hole" cx="200" cy="300" r="15" data-eject-deg="90" data-eject-m-s="1"/>"#;
    let walls = r#"<path class="wall" d="M182 282H218V318H182Z" fill="none" stroke-width="4"/>"#;
    let kinds = |drawn: &str| playtest(drawn).coils().iter().map(|finding| finding.kind).collect::<Vec<_>>();
    assert_eq!(kinds(saucer), []);
    assert_eq!(kinds(&format!("{saucer}{walls}")), [FindingKind::KeepsItsBall]);
}

#[test]
fn a_flipper_below_a_roof_is_told() {
    let flipper =
        r#"<line class="flipper" id="odd" x1="200" y1="600" x2="260" y2="600" data-side="left" data-up-deg="50"/>"#;
    let roof = r#"<path class="wall" d="M170 560H290V580H170Z"/>"#;
    let kinds = |drawn: &str| playtest(drawn).coils().iter().map(|finding| finding.kind).collect::<Vec<_>>();
    assert_eq!(kinds(flipper), []);
    assert_eq!(kinds(&format!("{flipper}{roof}")), [FindingKind::DoesNotFlip]);
}

/// Where a captive ball rolled out of the table, every wall of it was told to be open.
#[test]
fn a_captive_ball_that_comes_out_is_told_by_its_name() {
    let ball = r#"<circle class="captive-ball" id="held" cx="250" cy="400" r="13.5"/>"#;
    let cage = r#"<path class="wall" d="M232 380V416H268V380" fill="none" stroke-width="4"/>"#;
    let kinds = |drawn: &str| playtest(drawn).coils().iter().map(|finding| finding.kind).collect::<Vec<_>>();
    assert_eq!(kinds(&format!("{ball}{cage}")), []);
    assert_eq!(kinds(ball), [FindingKind::ComesOut]);
    let captive = playtest(ball);
    let told = let_go(&captive);
    assert_eq!(told, Vec::<String>::new(), "the others have not left the table");
}

#[test]
fn spectrum_has_no_findings() {
    let playtest = playtest_of(spectrum());
    assert_eq!(sentences(&playtest, playtest.launch().to_vec()), Vec::<String>::new());
    assert_eq!(sentences(&playtest, playtest.coils()), Vec::<String>::new());
    assert_eq!(sentences(&playtest, playtest.unreachable()), Vec::<String>::new());
    assert_eq!(sentences(&playtest, playtest.open_edges()), Vec::<String>::new());
    assert!(playtest.places(usize::MAX).len() > 50_000);
    let near = DVec2::new(0.25, 0.9);
    assert!(playtest.places(300).iter().any(|place| place.distance(near) < 0.05), "spread over all of it");
}

/// 800 drop targets took 26 seconds to be tried, each of them among all the others.
#[test]
fn of_very_many_coils_some_are_tried() {
    let target = |index: usize| {
        let (x, y) = (40 + index % 20 * 20, 120 + index / 20 * 20);
        format!(r#"<line class="drop-target" id="d{index}" x1="{x}" y1="{y}" x2="{}" y2="{y}"/>"#, x + 10)
    };
    let kinds = |count: usize| {
        let playtest = playtest(&(0..count).map(target).collect::<String>());
        playtest.trials().map(|(part, _)| part).collect::<Vec<_>>()
    };
    assert_eq!(kinds(40).len(), 41, "and a flipper");
    let some = kinds(600);
    assert!((30..=33).contains(&some.len()), "{}", some.len());
    // Behind the flipper stand the walls.
    let apart = some[2].0 - some[1].0;
    assert!(some[1..].windows(2).all(|pair| pair[1].0 - pair[0].0 == apart), "{some:?}");
}

/// A ball that lay on a diverter was told of a saucer 90 mm away.
#[test]
fn a_ball_that_lies_on_a_diverter_is_told_of_it() {
    let arm =
        r#"<line class="diverter" id="arm" x1="200" y1="400" x2="240" y2="400" stroke-width="8" data-turn-deg="40"/>"#;
    let hook = r#"<path class="wall" id="hook" d="M262 380V360" stroke-width="4"/>"#;
    let playtest = playtest(&format!("{arm}{hook}"));
    let place = DVec2::new(0.22, 0.38);
    let near = super::Finding::near(FindingKind::Stuck, playtest.machine.layout(), place, false);
    assert!(sentences(&playtest, vec![near])[0].contains(": arm: a ball lies still beside it"));
}

/// A plunger that was too slow was told by where its ball turns back, as if something barred the lane.
#[test]
fn a_plunger_that_is_too_slow_is_told_so() {
    let mut table = spectrum();
    for part in &mut table.layout.parts {
        if let Kind::Plunger(plunger) = &mut part.kind {
            plunger.full_speed_m_s = 1.2;
        }
    }
    let playtest = playtest_of(table);
    let [told] = &sentences(&playtest, playtest.launch().to_vec())[..] else { panic!() };
    let slow =
        "plunger: the ball comes back to it however far it is pulled: its full_speed_m_s, 1.2, carries a ball up to ";
    assert!(told.contains(slow) && told.ends_with(" mm and no farther; give it more in table.toml"), "{told}");
}

/// A plunger drawn upside down where nothing stands below it shot its ball off the table, and was told by a place 44 m away.
#[test]
fn a_plunger_that_shoots_off_the_table_is_told_to_be_upside_down() {
    let lane = WALLS.replace("M460 200V970H500", "M460 200V1000");
    let mut table = with_rules(&lane, "");
    for part in &mut table.layout.parts {
        if let Kind::Plunger(plunger) = &mut part.kind {
            (plunger.direction, plunger.feed) = (-plunger.direction, plunger.tip - plunger.direction * 0.015);
        }
    }
    let playtest = playtest_of(table);
    let [told] = &sentences(&playtest, playtest.launch().to_vec())[..] else { panic!() };
    assert_eq!(
        told,
        "table.svg:4: plunger: it is drawn upside down and shoots down the table: draw it from the tip at rest, x1 y1, down to \
         the tip when fully pulled, x2 y2"
    );
    let far = super::Finding::near(FindingKind::Escaped, playtest.machine.layout(), DVec2::new(0.453, 44.6), false);
    assert_eq!(far.place_mm, DVec2::new(453.0, 1000.0), "where it has left");
}
