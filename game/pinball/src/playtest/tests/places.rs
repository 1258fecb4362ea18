//! Where balls are let go: in pockets and beside what moves on every table, whatever else is on it.

use super::{playtest, playtest_of, sentences};
use crate::playtest::{Finding, FindingKind, Playtest};
use crate::table::tests::{BACK_TO_CUP, CUP, spectrum};
use geometry::{DVec2, Shape};
use physics::{BALL_RADIUS_M, Controls};

/// What is told of 120 balls.
fn let_go(playtest: &Playtest) -> Vec<String> {
    let findings = playtest.places(120).into_iter().filter_map(|place| playtest.let_go(place)).collect();
    sentences(playtest, playtest.merged(findings))
}

/// A pocket was told of a table and not of the same one with a post more: none of its places was in the pocket.
#[test]
fn a_pocket_is_told_whatever_else_is_on_the_table() {
    let cup = r#"<path class="wall" id="cup" d="M218 340L230 352L242 340" fill="none" stroke-width="2"/>"#;
    for post in 0..4 {
        let (x, y) = (100 + 37 * post, 500 + 13 * post);
        let told = let_go(&playtest(&format!(r#"{cup}<circle class="post" id="p" cx="{x}" cy="{y}" r="4"/>"#)));
        assert_eq!(told.len(), 1, "{told:?}");
        assert!(told[0].contains(": cup: a ball lies still beside it"), "{told:?}");
    }
}

/// A ball that has passed a level gate falls back on its flap.
#[test]
fn a_gate_that_holds_a_ball_is_told_whatever_else_is_on_the_table() {
    let gate = r#"<line class="gate" id="flap" x1="203" y1="350" x2="232" y2="350" data-way="up"/>
<path class="wall" d="M200 300V400M235 300V400" fill="none" stroke-width="6"/>"#;
    for post in 0..4 {
        let (x, y) = (60 + 31 * post, 500 + 17 * post);
        let told = let_go(&playtest(&format!(r#"{gate}<circle class="post" id="p" cx="{x}" cy="{y}" r="4"/>"#)));
        assert!(told.len() == 1 && told[0].contains(": flap: a ball lies still beside it"), "{told:?}");
    }
}

/// A ball that was let go below a gate's flap lay there for ever, on one table and not on the same with a post more. No ball
/// comes to rest there: shot from below, as fast as takes it just there, it goes on or falls back.
#[test]
fn no_ball_is_let_go_below_a_flap() {
    let gate = r#"<line class="gate" id="flap" x1="198" y1="366" x2="236" y2="350" data-way="up"/>
<path class="wall" d="M195 300V450M239 300V450" fill="none" stroke-width="6"/>"#;
    let playtest = playtest(gate);
    let flap = Shape::capsule(DVec2::new(0.198, 0.366), DVec2::new(0.236, 0.350), 0.0);
    assert!(playtest.places(100_000).iter().all(|place| flap.distance(*place).0 >= BALL_RADIUS_M));
    for shot in 0..80 {
        let speed = 0.24 + 0.003 * f64::from(shot);
        let mut machine = playtest.machine.clone();
        machine.put_ball(DVec2::new(0.217, 0.41), DVec2::new(0.0, -speed), [0.0; 3]);
        (0..5000).for_each(|_| machine.tick(Controls::NONE, &[]));
        let lies = machine.balls().iter().any(|ball| flap.distance(ball.center).0 < 0.5 * BALL_RADIUS_M);
        assert!(!lies, "{speed} m/s");
    }
}

/// Of two balls in one pocket one was freed by the ball search: the pocket was told twice.
#[test]
fn a_pocket_is_told_once_whatever_becomes_of_its_balls() {
    let playtest = playtest("");
    let near = |kind, x| Finding::near(kind, playtest.machine.layout(), DVec2::new(x, 0.4), false);
    let both = vec![near(FindingKind::FreedBySearch, 0.30), near(FindingKind::Stuck, 0.31)];
    let told = sentences(&playtest, playtest.merged(both));
    assert!(told.len() == 1 && told[0].contains("does not free it (2 times)"), "{told:?}");
}

/// A ramp whose ends are both above the playfield was called good, and no ball ever came onto it.
#[test]
fn a_ramp_that_no_ball_rolls_onto_is_told() {
    let ramp = |id: &str, heights: &str, y: f64| {
        format!(
            r#"<path class="ramp" id="{id}" d="M100 {y}V{}" data-heights-mm="{heights}" stroke-width="40" fill="none"/>"#,
            y - 200.0
        )
    };
    let unreachable = |drawn: &str| {
        let playtest = playtest(drawn);
        sentences(&playtest, playtest.unreachable())
    };
    let told = unreachable(&ramp("way", "48 40", 700.0));
    assert!(
        told.len() == 1 && told[0].contains(": way: no ball can come onto it: its ends are 48 and 40 mm"),
        "{told:?}"
    );
    assert_eq!(unreachable(&ramp("way", "0 48", 700.0)), Vec::<String>::new());
    let joined = format!("{}{}", ramp("way", "0 48", 700.0), ramp("on", "48 40", 500.0));
    assert_eq!(unreachable(&joined), Vec::<String>::new());
}

/// Of a ball that lay on a level ramp a far wall was told.
#[test]
fn a_ball_on_a_ramp_is_told_of_the_ramp() {
    let ramp =
        r#"<path class="ramp" id="way" d="M100 600V300H300" data-heights-mm="0 50 50" stroke-width="40" fill="none"/>
<circle class="post" id="below" cx="200" cy="300" r="6"/>"#
            .replace("V300H300", "V350A50 50 0 0 1 150 300H300")
            .replace("0 50 50", "0 50 50 50");
    let playtest = playtest(&ramp);
    let near = |above| Finding::near(FindingKind::Stuck, playtest.machine.layout(), DVec2::new(0.2, 0.3), above);
    assert!(sentences(&playtest, vec![near(true)])[0].contains(": way: "));
    assert!(sentences(&playtest, vec![near(false)])[0].contains(": below: "));
    // Below its low end, where a ball rolls in from above and does not come out.
    let wedge = Finding::near(FindingKind::Stuck, playtest.machine.layout(), DVec2::new(0.105, 0.48), false);
    assert!(sentences(&playtest, vec![wedge])[0].contains(": way: "));
}

#[test]
fn all_pockets_of_a_table_are_tried() {
    let playtest = playtest_of(spectrum());
    let pits = playtest.reach.pits().len();
    assert!((2..=125).contains(&pits), "{pits}");
}

#[test]
fn there_are_as_many_places_as_were_asked_for() {
    let playtest = playtest(r#"<circle class="bumper" id="pop" cx="200" cy="400" r="30"/>"#);
    assert_eq!(playtest.places(500).len(), 500);
    assert!(playtest.places(3).len() <= 5);
}

/// A ball came to rest between a wall and a post 14 mm from it, in a pocket 0.8 mm deep that no grid has.
#[test]
fn a_ball_that_lies_between_a_post_and_a_wall_is_found() {
    let post = |x: f64| format!(r#"<circle class="post" id="stud" cx="{x}" cy="550" r="5"/>"#);
    let stuck = |drawn: &str| {
        let playtest = playtest(drawn);
        let findings = playtest.places(500).into_iter().filter_map(|place| playtest.let_go(place)).collect();
        sentences(&playtest, playtest.merged(findings))
    };
    let told = stuck(&post(33.0));
    assert!(
        told.len() == 1 && told[0].contains(": a ball lies still beside it at 2") && told[0].contains(", 532 mm"),
        "{told:?}"
    );
    // The wall was told alone, and the post was at fault.
    assert!(told[0].contains("stud") && told[0].matches("(line ").count() == 1, "{told:?}");
    assert_eq!(stuck(&post(80.0)), Vec::<String>::new());
}

/// A ball in a cup hopped out at each round of the ball search and fell back, for an hour: the cup was told as one that the
/// search empties, as its rest took too many contact solves to be watched on.
#[test]
fn a_ball_that_the_search_only_makes_hop_is_stuck() {
    let told = |drawn: &str| {
        let playtest = playtest(drawn);
        let finding = playtest.let_go(DVec2::new(0.2833, 0.6173));
        sentences(&playtest, finding.into_iter().collect())
    };
    let [hops] = &told(&format!("{CUP}{BACK_TO_CUP}"))[..] else { panic!() };
    assert!(
        hops.contains("a ball lies still beside it at 282, 619 mm, and the ball search does not free it"),
        "{hops}"
    );
    let [freed] = &told(CUP)[..] else { panic!() };
    assert!(
        freed.contains("a ball lies still beside it at 282, 619 mm until the ball search fires every coil"),
        "{freed}"
    );
}
