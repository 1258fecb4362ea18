//! Whether a ball can close the switches of a table, shot at them as a player can.

use super::{WALLS, playtest, playtest_of, sentences, with_rules};
use crate::playtest::{FindingKind, put_ball};
use geometry::DVec2;
use physics::Kind;

fn coils(drawn: &str) -> Vec<String> {
    let playtest = playtest(drawn);
    sentences(&playtest, playtest.merged([playtest.coils(), playtest.unreachable()].concat()))
}

fn kinds(drawn: &str) -> Vec<FindingKind> {
    let playtest = playtest(drawn);
    let all = playtest.merged([playtest.coils(), playtest.unreachable()].concat());
    all.iter().map(|finding| finding.kind).collect()
}

/// Of two drop targets 5 mm apart a ball that was shot at the end of one hit both, and the one was told as dead.
#[test]
fn parts_that_stand_close_together_are_hit_by_themselves() {
    let bank = |gap: f64| {
        let target = |index: u32| {
            let x = 150.0 + f64::from(index) * (25.0 + gap);
            format!(
                r#"<line class="drop-target" id="d{index}" x1="{x}" y1="300" x2="{}" y2="300" stroke-width="4"/>"#,
                x + 25.0
            )
        };
        format!(r#"{}<path class="wall" d="M140 290H300" stroke-width="4"/>"#, (0..3).map(target).collect::<String>())
    };
    for gap in [0.0, 2.0, 5.0, 9.0] {
        assert_eq!(coils(&bank(gap)), Vec::<String>::new(), "{gap}");
    }
}

/// A target that lies in its wall was called good: no trial asked for targets at all.
#[test]
fn a_target_that_no_ball_hits_is_told() {
    let wall = r#"<path class="wall" id="side" d="M200 250V450" fill="none" stroke-width="6"/>"#;
    let thin = r#"<path class="wall" id="side" d="M200 250V450" fill="none" stroke-width="4"/>"#;
    let target = |x: f64, width: f64| {
        format!(r#"{wall}<line class="target" id="face" x1="{x}" y1="330" x2="{x}" y2="360" stroke-width="{width}"/>"#)
    };
    assert_eq!(coils(&target(205.0, 4.0)), Vec::<String>::new());
    assert_eq!(kinds(&target(200.0, 1.0)), [FindingKind::Unreachable]);
    let told = coils(&target(200.0, 1.0).replace(wall, thin));
    assert!(told.len() == 1 && told[0].contains("table.svg:9: face: of "), "{told:?}");
    assert!(told[0].contains("that are shot at it none closes its switch; turn it so that a ball comes"), "{told:?}");
    // In a lane in which a ball can only roll past it.
    let lane = r#"<path class="wall" d="M229.2 250V450" fill="none" stroke-width="1"/>"#;
    let beside = target(201.0, 1.0).replace("stroke-width=\"6\"", "stroke-width=\"1\"");
    assert_eq!(kinds(&beside), []);
    assert_eq!(kinds(&format!("{beside}{lane}")), [FindingKind::SwitchNeverCloses]);
}

#[test]
fn a_rollover_that_no_ball_is_over_is_told() {
    let wall = r#"<path class="wall" d="M200 250V450" fill="none" stroke-width="6"/>"#;
    let rollover = |x: f64| format!(r#"{wall}<line class="rollover" id="r" x1="{x}" y1="330" x2="{x}" y2="360"/>"#);
    assert_eq!(coils(&rollover(230.0)), Vec::<String>::new());
    let told = coils(&rollover(207.0));
    assert!(told.len() == 1 && told[0].contains(": r: no ball can come to it"), "{told:?}");
}

/// A saucer of 1 mm, or one that catches nothing that moves, was called good.
#[test]
fn a_saucer_that_catches_no_ball_is_told() {
    let saucer = |radius: f64, more: &str| {
        format!(
            r#"<circle class="saucer" id="hole" cx="200" cy="300" r="{radius}" data-eject-deg="90" data-eject-m-s="1"/>{more}"#
        )
    };
    assert_eq!(coils(&saucer(15.0, "")), Vec::<String>::new());
    assert_eq!(coils(&saucer(8.0, "")), Vec::<String>::new());
    // A drawing may not say so small a radius any more: a table that is made otherwise may have it.
    let mut table = with_rules(&format!("{WALLS}\n{}", saucer(8.0, "")), "");
    for part in &mut table.layout.parts {
        if let Kind::Saucer(saucer) = &mut part.kind {
            saucer.circle.radius = 0.001;
        }
    }
    let playtest = playtest_of(table);
    let told = sentences(&playtest, playtest.merged([playtest.coils(), playtest.unreachable()].concat()));
    assert!(
        told.len() == 1 && told[0].contains("it catches none; see its radius (1.0 mm), its capture_m_s (1)"),
        "{told:?}"
    );
    let bumper = r#"<circle class="bumper" id="pop" cx="200" cy="300" r="30"/>"#;
    assert_eq!(kinds(&saucer(10.0, bumper)), [FindingKind::Unreachable]);
}

#[test]
fn a_spinner_and_a_gate_that_no_ball_passes_are_told() {
    let lane = r#"<path class="wall" d="M180 250V450M220 250V450" fill="none" stroke-width="6"/>"#;
    let end = r#"<path class="wall" d="M180 337H220" fill="none" stroke-width="6"/>"#;
    let spinner = r#"<line class="spinner" id="s" x1="184" y1="350" x2="216" y2="350"/>"#;
    let gate = r#"<line class="gate" id="g" x1="184" y1="350" x2="216" y2="350" data-way="up"/>"#;
    assert_eq!(coils(&format!("{lane}{spinner}")), Vec::<String>::new());
    assert_eq!(coils(&format!("{lane}{gate}")), Vec::<String>::new());
    let told = coils(&format!("{lane}{end}{gate}"));
    assert!(told.len() == 1 && told[0].contains(": g: of ") && told[0].contains("none passes it"), "{told:?}");
}

/// They went through each other, and nobody said so.
#[test]
fn flippers_whose_strokes_cross_are_told() {
    let right = |x: f64| {
        format!(
            r#"<line class="flipper" id="right" data-side="right" data-up-deg="50" x1="{x}" y1="850" x2="{}" y2="885"/>"#,
            x - 60.0
        )
    };
    assert_eq!(coils(&right(310.0)), Vec::<String>::new());
    assert_eq!(coils(&right(290.0)), Vec::<String>::new(), "tips that touch when both are up");
    let told = coils(&right(265.0));
    assert_eq!(told.len(), 1, "{told:?}");
    assert!(told[0].contains(": left: its stroke crosses that of right (line 9) at "), "{told:?}");
}

/// A guide across a ramp's entry: a ball came as far as the guide, and the ramp was called good.
#[test]
fn a_ramp_whose_entry_is_barred_is_told() {
    let ramp = |more: &str| {
        format!(
            r#"<path class="ramp" id="way" d="M200 600V400" data-heights-mm="0 48" stroke-width="40" fill="none"/>{more}"#
        )
    };
    let guide = |y: f64, from: f64| ramp(&format!(r#"<path class="guide" d="M{from} {y}H225" stroke-width="4"/>"#));
    assert_eq!(coils(&ramp("")), Vec::<String>::new());
    let told = coils(&guide(604.0, 175.0));
    assert!(told.len() == 1 && told[0].starts_with("warning: table.svg:9: way: of "), "{told:?}");
    assert!(
        told[0].ends_with("that are shot into it none comes onto it; leave its entry free, wider than a ball's 27 mm"),
        "{told:?}"
    );
    assert_eq!(kinds(&guide(590.0, 175.0)), [FindingKind::SwitchNeverCloses], "in the ramp, and no ball is on it yet");
    assert_eq!(coils(&guide(520.0, 175.0)), Vec::<String>::new(), "below the ramp");
    assert_eq!(coils(&guide(604.0, 215.0)), Vec::<String>::new(), "it leaves room");
    // The upper end lies on the playfield.
    let turned = ramp("").replace("M200 600V400", "M200 400V600").replace("0 48", "48 0");
    assert_eq!(coils(&turned), Vec::<String>::new());
    assert_eq!(coils(&format!("{turned}{}", guide(604.0, 175.0).split_once("/>").unwrap().1)).len(), 1);
}

/// A captive ball that was drawn some millimetres above where it rests rolled while it was shot at, and was told as dead.
#[test]
fn a_captive_ball_rolls_to_its_place_before_it_is_shot_at() {
    let cage = "M190 398L182 392V372A18 18 0 0 1 218 372V392L210 398";
    let cage = format!(r#"<path class="wall" id="cage" d="{cage}" fill="none" stroke-width="3"/>"#);
    let ball = |y: f64| format!(r#"{cage}<circle class="captive-ball" id="cap" cx="200" cy="{y}" r="13.5"/>"#);
    assert_eq!(coils(&ball(386.7)), Vec::<String>::new());
    assert_eq!(coils(&ball(380.0)), Vec::<String>::new());
    let shut = r#"<path class="wall" d="M185 401H215" fill="none" stroke-width="3"/>"#;
    let told = coils(&format!("{}{shut}", ball(380.0)));
    assert!(told.iter().all(|told| !told.contains("turn it")), "{told:?}");
}

/// A kickback of 0.5 m/s threw its ball up, got it back and threw it again, for ever.
#[test]
fn a_kickback_whose_ball_falls_back_on_it_is_told() {
    let lane = r#"<path class="wall" d="M150 300V700M190 300V700" fill="none" stroke-width="6"/>"#;
    let drawn = format!(
        r#"{WALLS}{lane}<line class="kickback" id="kb" x1="170" y1="600" x2="170" y2="565" stroke-width="26"/>"#
    );
    let told = |speed_m_s: f64| {
        let mut table = with_rules(&drawn, "");
        for part in &mut table.layout.parts {
            if let Kind::Kickback(kickback) = &mut part.kind {
                kickback.speed_m_s = speed_m_s;
            }
        }
        let playtest = playtest_of(table);
        sentences(&playtest, playtest.coils())
    };
    assert_eq!(told(4.0), Vec::<String>::new());
    for speed_m_s in [0.5, 0.8] {
        let all = told(speed_m_s);
        let [told] = &all[..] else { panic!("{all:?}") };
        let expected = format!(
            ": kb: the ball that it throws falls back on it: throw it faster than its speed_m_s, {speed_m_s}, or to where the \
             way is free"
        );
        assert!(told.ends_with(&expected), "{told}");
    }
}

/// A captive ball that lay wedged was pressed into its cage by less than the width of an atom: nothing that was put anywhere
/// had room, both flippers were told not to flip, and pockets were told of none.
#[test]
fn what_lies_in_a_wall_elsewhere_takes_no_room() {
    let playtest = playtest(r#"<circle class="post" id="stud" cx="200" cy="300" r="10"/>"#);
    let (stud, free) = (DVec2::new(0.2, 0.3), DVec2::new(0.3, 0.4));
    let mut machine = playtest.machine.clone();
    assert!(!put_ball(&mut machine, stud, DVec2::ZERO));
    assert!(machine.penetration_m() > 0.0);
    assert!(put_ball(&mut machine, free, DVec2::ZERO));
    assert!(!put_ball(&mut machine, free + DVec2::new(0.02, 0.0), DVec2::ZERO), "in another ball");
    let cage = r#"<path class="guide" d="M92 455V430A18 18 0 0 1 128 430V455" stroke-width="4"/>
<path class="guide" d="M92 455V462M128 455L122 462" stroke-width="4"/>
<circle class="captive-ball" id="cap" cx="110" cy="452" r="13.5"/>"#;
    assert_eq!(coils(cage), Vec::<String>::new());
}
