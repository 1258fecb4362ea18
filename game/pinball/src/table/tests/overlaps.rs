//! Parts in each other, and parts that no ball can come to.

use super::{spectrum, table};

/// What is told of where the parts of the small table are, with `drawn` from its line 5 on.
fn told(drawn: &str) -> Vec<String> {
    table(drawn).overlaps().iter().map(|one| one.to_string().replace("table.svg:", "")).collect()
}

#[track_caller]
fn one(drawn: &str) -> String {
    let told = told(drawn);
    let [one] = &told[..] else { panic!("{told:?}") };
    one.clone()
}

const BUMPER: &str = r#"<circle class="bumper" id="pop" cx="200" cy="300" r="25"/>"#;

fn line(class: &str, id: &str, [x1, y1, x2, y2]: [f64; 4], width: f64) -> String {
    format!(r#"<line class="{class}" id="{id}" x1="{x1}" y1="{y1}" x2="{x2}" y2="{y2}" stroke-width="{width}"/>"#)
}

fn saucer(id: &str, x: f64) -> String {
    format!(r#"<circle class="saucer" id="{id}" cx="{x}" cy="300" r="14" data-eject-deg="90" data-eject-m-s="1"/>"#)
}

/// Two drop targets in one place, a saucer in a bumper: check said ok.
#[test]
fn parts_in_each_other_are_told_with_both_lines() {
    let drops = ["a", "b"].map(|id| line("drop-target", id, [99.0, 99.0, 129.0, 99.0], 4.0)).join("\n");
    assert_eq!(one(&drops), "6: b: it lies in one place with a of line 5; draw them apart");
    let hole = one(&format!("{BUMPER}\n{}", saucer("hole", 203.0)));
    assert_eq!(hole, "6: hole: a ball in it would lie 35.5 mm deep in pop of line 5; draw them apart");
    let first = one(&format!("{}\n{BUMPER}", saucer("hole", 203.0)));
    assert_eq!(first, "6: pop: it stands 35.5 mm deep in a ball that lies in hole of line 5; draw them apart");
    let beside = one(&format!("{BUMPER}\n{}", saucer("hole", 232.0)));
    assert!(beside.starts_with("6: hole: a ball in it would lie 6.5 mm deep in pop"), "{beside}");
    let target = line("target", "t", [190.0, 300.0, 220.0, 300.0], 4.0);
    assert_eq!(one(&format!("{BUMPER}\n{target}")), "6: t: it lies in pop of line 5; draw them apart");
    assert_eq!(
        one(&format!("{}\n{}", saucer("a", 200.0), saucer("b", 210.0))),
        "6: b: it lies in a of line 5; draw them apart"
    );
    let rollovers = ["a", "b"].map(|id| line("rollover", id, [99.0, 99.0, 99.0, 129.0], 2.0)).join("\n");
    assert_eq!(one(&rollovers), "warning: 6: b: it lies in one place with a of line 5; draw them apart");
}

#[test]
fn flippers_whose_strokes_cross_are_told() {
    let flipper = |id: &str, side: &str, x1: f64, x2: f64| {
        let data = format!(r#"data-side="{side}" data-up-deg="50""#);
        format!(r#"<line class="flipper" id="{id}" {data} x1="{x1}" y1="300" x2="{x2}" y2="335"/>"#)
    };
    let pair = |x1: f64, x2: f64| format!("{}\n{}", flipper("a", "left", 100.0, 160.0), flipper("b", "right", x1, x2));
    assert_eq!(told(&pair(262.0, 202.0)), [""; 0], "as they are drawn");
    assert_eq!(told(&pair(232.0, 172.0)), [""; 0], "only the tips cross");
    let same = one(&format!("{}\n{}", flipper("a", "left", 100.0, 160.0), flipper("b", "left", 110.0, 170.0)));
    assert_eq!(same, "6: b: it lies in a of line 5; draw them apart");
    let above =
        r#"<line class="flipper" id="b" data-side="right" data-up-deg="50" x1="140" y1="350" x2="80" y2="350"/>"#;
    let crossing = one(&format!("{}\n{above}", flipper("a", "left", 100.0, 160.0)));
    assert!(
        crossing.starts_with("warning: 6: b: flippers go through each other, and its stroke crosses that of a"),
        "{crossing}"
    );
}

/// Two flippers whose rubbers nearly met let no ball through, and a game had no end.
#[test]
fn flippers_that_let_no_ball_through_are_told() {
    let flipper = |id: &str, side: &str, x1: f64, x2: f64| {
        let data = format!(r#"data-side="{side}" data-up-deg="50""#);
        format!(r#"<line class="flipper" id="{id}" {data} x1="{x1}" y1="300" x2="{x2}" y2="335"/>"#)
    };
    let pair = |gap: f64| {
        let left = flipper("a", "left", 100.0, 160.0);
        format!("{left}\n{}", flipper("b", "right", 234.0 + gap, 174.0 + gap))
    };
    let narrow = one(&pair(20.0));
    let told_so = "warning: 6: b: between its tip at rest and that of a of line 5 are 20.0 mm: no ball falls through, for it is 27 mm \
                   wide; draw them farther apart";
    assert_eq!(narrow, told_so);
    assert_eq!(told(&pair(27.5)), [""; 0]);
    let away = format!("{}\n{}", flipper("a", "right", 160.0, 100.0), flipper("b", "left", 180.0, 240.0));
    assert_eq!(told(&away), [""; 0], "back to back");
}

/// A flipper went through a guide, a post or a bumper in its way, and nobody said so.
#[test]
fn what_stands_in_a_flippers_stroke_is_told() {
    let flipper =
        r#"<line class="flipper" id="f" data-side="left" data-up-deg="50" x1="100" y1="300" x2="160" y2="335"/>"#;
    for (standing, place) in [
        (r#"<circle class="post" id="w" cx="150" cy="300" r="4" fill="red"/>"#, "150, 304"),
        (r#"<path class="wall" id="w" d="M130 280L160 290" stroke-width="4"/>"#, ""),
        (r#"<circle class="bumper" id="w" cx="160" cy="280" r="20"/>"#, ""),
        (r#"<line class="target" id="w" x1="140" y1="330" x2="140" y2="310" stroke-width="4"/>"#, ""),
    ] {
        let told = one(&format!("{flipper}\n{standing}"));
        assert!(
            told.starts_with("warning: 5: f: its stroke goes through w of line 6 at ") && told.contains(place),
            "{told}"
        );
    }
    // A guide that ends at its pivot, a post below its tip, and a ramp's sides are in nobody's way.
    let guide = r#"<path class="wall" id="w" d="M60 270L102 296" stroke-width="6"/>"#;
    let post = r#"<circle class="post" id="p" cx="172" cy="352" r="4" fill="red"/>"#;
    assert_eq!(told(&format!("{flipper}\n{guide}\n{post}")), [""; 0]);
}

/// A bumper whose skirt was in a flipper's sweep was called good: only what the flipper's middle goes through was looked for.
#[test]
fn a_bumper_that_a_flippers_rubber_meets_is_told() {
    let flipper =
        r#"<line class="flipper" id="f" data-side="left" data-up-deg="50" x1="100" y1="300" x2="160" y2="335"/>"#;
    let bumper = |x: f64| format!(r#"{flipper}<circle class="bumper" id="pop" cx="{x}" cy="310" r="20"/>"#);
    let told = one(&bumper(192.0));
    assert!(told.starts_with("warning: 5: f: its stroke goes through pop of line 5 at "), "{told}");
    assert_eq!(told_of_pivot(flipper), [""; 0]);
    assert_eq!(self::told(&bumper(198.0)), [""; 0]);
    let sling = line("slingshot", "s", [174.0, 290.0, 174.0, 320.0], 4.0);
    assert!(one(&format!("{flipper}{sling}")).contains("its stroke goes through s of line 5"));
}

/// A guide and a wall that end at the pivot.
fn told_of_pivot(flipper: &str) -> Vec<String> {
    let walls =
        [line("wall", "a", [60.0, 270.0, 102.0, 296.0], 6.0), line("guide", "b", [100.0, 300.0, 70.0, 290.0], 6.0)];
    told(&format!("{flipper}{}", walls.concat()))
}

/// A flipper that was drawn as it is when it is held, one with the other's `data-side`: both were called good.
#[test]
fn a_flipper_that_does_not_go_up_is_told() {
    let flipper = |side: &str, [x2, y2]: [f64; 2]| {
        let data = format!(r#"data-side="{side}" data-up-deg="50""#);
        told(&format!(r#"<line class="flipper" id="f" {data} x1="250" y1="500" x2="{x2}" y2="{y2}"/>"#))
    };
    let up = "warning: 5: f: its tip points up before its button is held; draw it at rest, from its pivot, x1 y1, down to \
              its tip";
    assert_eq!(flipper("left", [310.0, 475.0]), [up]);
    assert_eq!(flipper("right", [190.0, 475.0]), [up]);
    let down = |side: &str, other: &str| {
        format!(
            "warning: 5: f: its tip goes down when its button is held; with data-side=\"{side}\" draw it from its pivot, x1 y1, \
             to the {other}"
        )
    };
    assert_eq!(flipper("left", [190.0, 520.0]), [down("left", "right")]);
    assert_eq!(flipper("right", [310.0, 500.0]), [down("right", "left")]);
    for good in [[310.0, 530.0], [310.0, 500.0], [310.0, 492.0], [280.0, 560.0]] {
        assert_eq!(flipper("left", good), [""; 0], "{good:?}");
    }
}

/// A plunger as wide as two lanes was called good.
#[test]
fn a_plunger_that_is_wider_than_its_lane_is_told() {
    let lane = |left: f64| {
        format!(
            "{}{}",
            line("wall", "in", [left, 700.0, left, 990.0], 6.0),
            line("wall", "out", [496.0, 700.0, 496.0, 990.0], 6.0)
        )
    };
    // The small table's plunger is 24 mm wide, at 480.
    assert_eq!(told(&lane(464.0)), [""; 0]);
    assert_eq!(told(&lane(466.0)), [""; 0], "a drawing's roundings");
    assert_eq!(
        one(&lane(470.0)),
        "warning: 4: plunger: its face is 24.0 mm wide and reaches into in of line 5; a stroke-width of 14 fits its lane"
    );
}

/// A target on the axis of a lane's wall was hit by no ball.
#[test]
fn what_no_ball_can_touch_is_told_with_what_is_in_the_way() {
    let wall = line("wall", "lane", [200.0, 200.0, 200.0, 400.0], 6.0);
    let on_axis = |width: f64| format!("{wall}\n{}", line("target", "t", [200.0, 280.0, 200.0, 310.0], width));
    assert_eq!(
        one(&on_axis(4.0)),
        "6: t: no ball can touch it: lane of line 5 is in the way on all sides; draw it before that"
    );
    assert!(one(&on_axis(6.0)).starts_with("warning: 6: t: a ball touches lane of line 5 wherever it touches it"));
    assert_eq!(told(&on_axis(8.0)), [""; 0]);
    let before = format!("{wall}\n{}", line("target", "t", [203.0, 280.0, 203.0, 310.0], 4.0));
    assert_eq!(told(&before), [""; 0]);
    let gap =
        [line("wall", "a", [200.0, 200.0, 200.0, 280.0], 4.0), line("wall", "b", [200.0, 310.0, 200.0, 400.0], 4.0)];
    let flush = line("target", "t", [200.0, 280.0, 200.0, 310.0], 4.0);
    assert_eq!(told(&format!("{}\n{flush}", gap.join("\n"))), [""; 0], "flush with the wall");
    let switch = line("rollover", "r", [200.0, 280.0, 200.0, 310.0], 2.0);
    assert!(
        one(&format!("{wall}\n{switch}")).starts_with("6: r: no ball has room over it: lane of line 5 is in the way")
    );
    let inside = r#"<circle class="rollover" id="r" cx="200" cy="300" r="6"/>"#;
    assert!(one(&format!("{BUMPER}\n{inside}")).starts_with("6: r: no ball has room over it: pop of line 5"));
}

#[test]
fn what_may_be_in_each_other_is_left_alone() {
    let post = r#"<circle class="post" cx="200" cy="300" r="6" fill="red"/>"#;
    let walls =
        [line("wall", "a", [150.0, 300.0, 250.0, 300.0], 6.0), line("guide", "b", [200.0, 250.0, 200.0, 350.0], 6.0)];
    let magnet = r#"<circle class="magnet" id="m" cx="200" cy="300" r="40"/>"#;
    assert_eq!(told(&format!("{post}{}{magnet}", walls.concat())), [""; 0]);
    assert_eq!(told(&format!("{BUMPER}{magnet}")), [""; 0]);
    let bumpers = BUMPER.replace("pop", "two").replace("200", "224");
    assert_eq!(told(&format!("{BUMPER}{bumpers}")), [""; 0]);
    let bank: String = (0..3)
        .map(|i| {
            line(
                "drop-target",
                &format!("d{i}"),
                [99.0 + 20.0 * f64::from(i), 99.0, 119.0 + 20.0 * f64::from(i), 99.0],
                4.0,
            )
        })
        .collect();
    assert_eq!(told(&format!("{bank}{}", line("target", "behind", [99.0, 93.0, 159.0, 93.0], 4.0))), [""; 0]);
    // A lane as wide as a ball, and a gate from wall to wall.
    let lane = [185.0, 216.0].map(|x| line("wall", &format!("w{x}"), [x, 200.0, x, 400.0], 4.0)).concat();
    let gate = line("gate", "g", [187.0, 300.0, 214.0, 300.0], 1.0).replace("id", "data-way='up' id");
    assert_eq!(told(&format!("{lane}{gate}{}", line("rollover", "r", [200.5, 250.0, 200.5, 280.0], 2.0))), [""; 0]);
    assert_eq!(spectrum().overlaps(), []);
}

/// A magnet of 1 m/s^2 held no ball, and check said ok.
#[test]
fn a_magnet_that_is_weaker_than_the_slope_is_told() {
    let magnet = r#"<circle class="magnet" id="mag" cx="200" cy="300" r="40"/>"#;
    let told = |numbers: &str| super::read(magnet, numbers).unwrap().overlaps();
    assert_eq!(told(""), []);
    let weak = told("[part.mag]\npull_m_s2 = 1");
    let expected = "warning: table.svg:5: mag: its pull_m_s2, 1, is less than what the slope pulls a ball down with, 1.11 m/s^2, \
                    so it holds none; give it ten times as much as the slope has";
    assert_eq!(weak.iter().map(ToString::to_string).collect::<Vec<_>>(), [expected]);
}
