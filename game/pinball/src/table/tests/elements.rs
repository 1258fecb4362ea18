//! Each class of element becomes what it should, in metres.

use super::table;
use crate::table::{LampKind, Table};
use geometry::{Core, DVec2, Shape};
use physics::Kind;

fn kind<'a>(table: &'a Table, name: &str) -> &'a Kind {
    let id = table.part(name).unwrap_or_else(|| panic!("no part {name}"));
    &table.layout.parts[usize::from(id.0)].kind
}

fn near(a: DVec2, x: f64, y: f64) -> bool {
    a.distance(DVec2::new(x, y)) < 1e-12
}

fn walls(table: &Table, name: &str) -> Vec<Shape> {
    match kind(table, name) {
        Kind::Wall(wall) => wall.shapes.clone(),
        other => panic!("{other:?}"),
    }
}

#[test]
fn the_small_table_is_what_it_says() {
    let table = table("");
    assert_eq!(table.layout.size_m, DVec2::new(0.5, 1.0));
    let names: Vec<&str> = table.layout.parts.iter().map(|part| part.name.as_str()).collect();
    assert_eq!(names, ["left", "drain#1", "plunger"]);
    let Kind::Flipper(flipper) = kind(&table, "left") else { panic!() };
    assert!(near(flipper.base.center, 0.15, 0.85) && flipper.base.radius == 0.0116);
    assert!((flipper.rest_rad - geometry::trig::angle(DVec2::new(60.0, 35.0))).abs() < 1e-12);
    assert!((flipper.rest_rad - flipper.up_rad - 50.0_f64.to_radians()).abs() < 1e-12);
    let Kind::Plunger(plunger) = kind(&table, "plunger") else { panic!() };
    assert!(near(plunger.direction, 0.0, -1.0) && near(plunger.tip, 0.48, 0.9));
    assert!((plunger.stroke_m - 0.05).abs() < 1e-12 && (plunger.half_width_m - 0.012).abs() < 1e-12);
    assert!(plunger.feed.y < 0.9 - physics::BALL_RADIUS_M && near(DVec2::new(plunger.feed.x, 0.0), 0.48, 0.0));
}

#[test]
fn a_wall_is_as_thick_as_its_line_and_its_arcs_are_arcs() {
    let table =
        table(r#"<path id="w" class="wall" d="M10 100 V50 A30 30 0 0 1 70 50 h20" stroke-width="6" fill="none"/>"#);
    let shapes = walls(&table, "w");
    assert!(shapes.iter().all(|shape| (shape.radius - 0.003).abs() < 1e-15));
    let [Core::Segment(first), Core::Arc(arc), Core::Segment(last)] =
        shapes.iter().map(|s| s.core).collect::<Vec<_>>()[..]
    else {
        panic!("{shapes:?}")
    };
    assert!(near(first.a, 0.01, 0.1) && near(first.b, 0.01, 0.05) && near(last.b, 0.09, 0.05));
    assert!(near(arc.circle().center, 0.04, 0.05) && (arc.circle().radius - 0.03).abs() < 1e-12);
    assert!(near(arc.middle(), 0.0, -1.0) && (arc.half_angle() - std::f64::consts::FRAC_PI_2).abs() < 1e-12);
}

#[test]
fn every_kind_of_line_makes_a_wall() {
    let table = table(
        r#"<polyline id="open" class="guide" points="10,10 20,10 20 30" stroke-width="2" fill="none"/>
        <polygon id="closed" class="rubber" points="100 100 140 100 140 140" stroke-width="4" fill="none"/>
        <rect id="box" class="wall" x="200" y="200" width="40" height="20"/>
        <rect id="round" class="wall" x="200" y="300" width="40" height="20" rx="5"/>
        <circle id="post" class="post" cx="300" cy="300" r="4" fill="gray"/>
        <circle id="ring" class="rubber" cx="350" cy="300" r="12" fill="none" stroke="black" stroke-width="3"/>"#,
    );
    assert_eq!(walls(&table, "open").len(), 2);
    assert_eq!(walls(&table, "closed").len(), 3);
    assert_eq!(walls(&table, "box").len(), 4);
    let arcs = walls(&table, "round").iter().filter(|shape| matches!(shape.core, Core::Arc(_))).count();
    assert_eq!((walls(&table, "round").len(), arcs), (8, 4));
    assert_eq!(walls(&table, "post"), [Shape::disc(DVec2::new(300.0, 300.0), 4.0).scaled(0.001)]);
    let [Shape { core: Core::Arc(ring), radius }] = walls(&table, "ring")[..] else { panic!() };
    assert!((ring.half_angle() - std::f64::consts::PI).abs() < 1e-15 && (radius - 0.0015).abs() < 1e-15);
}

#[test]
fn curves_stay_within_a_fiftieth_of_a_millimetre() {
    // The cubic and the ellipse have known points; every flattened point must lie on the true curve, and no chord's
    // middle may be farther from it than the tolerance.
    let table = table(
        r#"<path id="c" class="wall" d="M100 100 C100 200 300 200 300 100" stroke-width="2" fill="none"/>
        <path id="e" class="wall" d="M100 400 A100 50 0 0 1 300 400" stroke-width="2" fill="none"/>"#,
    );
    let cubic = |t: f64| {
        let s = 1.0 - t;
        let weights = [s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t];
        let points = [(0.1, 0.1), (0.1, 0.2), (0.3, 0.2), (0.3, 0.1)].map(DVec2::from);
        weights.iter().zip(points).map(|(&weight, point)| point * weight).sum::<DVec2>()
    };
    let curve: Vec<DVec2> = (0..=20_000).map(|step| cubic(f64::from(step) / 20_000.0)).collect();
    for shape in walls(&table, "c") {
        let Core::Segment(chord) = shape.core else { panic!() };
        let middle = (chord.a + chord.b) * 0.5;
        let off = curve.iter().map(|point| point.distance(middle)).fold(f64::INFINITY, f64::min);
        assert!(off < 0.000_02 + 1e-7, "{off} m");
    }
    for shape in walls(&table, "e") {
        let Core::Segment(chord) = shape.core else { panic!() };
        for point in [chord.a, (chord.a + chord.b) * 0.5] {
            let unit = (point - DVec2::new(0.2, 0.4)) / DVec2::new(0.1, 0.05);
            assert!((unit.length() - 1.0).abs() * 0.05 < 0.000_02, "{point}");
            assert!(point.y < 0.400_001, "the arc goes over the top: {point}");
        }
    }
}

#[test]
fn transforms_move_scale_and_mirror_things_and_their_thickness() {
    let table = table(
        r#"<g transform="translate(100 200) scale(2)"><g transform="rotate(90)" stroke-width="3">
        <line id="turned" class="wall" x1="10" y1="0" x2="20" y2="0"/></g></g>
        <g transform="matrix(-1 0 0 1 500 0)"><path id="mirrored" class="wall" d="M10 50 A30 30 0 0 1 70 50" fill="none"/></g>"#,
    );
    let [Shape { core: Core::Segment(line), radius }] = walls(&table, "turned")[..] else { panic!() };
    assert!(near(line.a, 0.1, 0.22) && near(line.b, 0.1, 0.24) && (radius - 0.003).abs() < 1e-15);
    let [Shape { core: Core::Arc(arc), .. }] = walls(&table, "mirrored")[..] else { panic!() };
    assert!(near(arc.circle().center, 0.46, 0.05) && near(arc.middle(), 0.0, -1.0));
}

#[test]
fn arcs_take_the_side_and_the_way_that_svg_says() {
    let arc = |flags: &str| {
        let drawn = format!(r#"<path id="a" class="wall" fill="none" d="M100 100 A50 50 0 {flags} 150 150"/>"#);
        let shapes = walls(&table(&drawn), "a");
        let Core::Arc(arc) = shapes[0].core else { panic!() };
        (arc.circle().center * 1000.0, (arc.half_angle() * 2.0).to_degrees())
    };
    for (flags, x, y, turn) in [
        ("0 0", 150.0, 100.0, 90.0),
        ("0 1", 100.0, 150.0, 90.0),
        ("1 0", 100.0, 150.0, 270.0),
        ("1 1", 150.0, 100.0, 270.0),
    ] {
        let (center, degrees) = arc(flags);
        assert!(
            center.distance(DVec2::new(x, y)) < 1e-9 && (degrees - turn).abs() < 1e-9,
            "{flags}: {center} {degrees}"
        );
    }
}

#[test]
fn switches_and_kickers_become_what_they_are() {
    let table = table(
        r##"<circle id="pop" class="bumper" cx="100" cy="100" r="25" stroke="red" stroke-width="4"/>
        <line id="sling" class="slingshot" x1="100" y1="700" x2="130" y2="760" stroke-width="6"/>
        <line id="stand" class="target" x1="300" y1="300" x2="320" y2="300" stroke-width="4"/>
        <line id="drop" class="drop-target" x1="300" y1="400" x2="320" y2="400" stroke-width="4"/>
        <line id="lane" class="rollover" x1="50" y1="300" x2="50" y2="320" stroke-width="16"/>
        <circle id="star" class="rollover" cx="80" cy="300" r="10"/>
        <line id="gate" class="gate" x1="400" y1="100" x2="400" y2="140" stroke-width="2" data-way="left"/>
        <line id="slanted" class="gate" x1="420" y1="100" x2="420" y2="140" stroke-width="2" data-way="-30"/>
        <line id="spin" class="spinner" x1="30" y1="500" x2="60" y2="500" stroke-width="2"/>
        <circle id="hole" class="saucer" cx="250" cy="500" r="14" data-eject-deg="90" data-eject-m-s="1.5"/>"##,
    );
    let Kind::Bumper(bumper) = kind(&table, "pop") else { panic!() };
    assert!(near(bumper.circle.center, 0.1, 0.1) && (bumper.circle.radius - 0.025).abs() < 1e-15);
    let Kind::Slingshot(sling) = kind(&table, "sling") else { panic!() };
    assert!((sling.radius_m - 0.003).abs() < 1e-15 && sling.kick_m_s > 0.0);
    let Kind::Target(target) = kind(&table, "stand") else { panic!() };
    let Kind::DropTarget(drop) = kind(&table, "drop") else { panic!() };
    assert!((target.shape.radius - 0.002).abs() < 1e-15 && (drop.shape.radius - 0.002).abs() < 1e-15);
    let Kind::Rollover(lane) = kind(&table, "lane") else { panic!() };
    assert!(
        lane.shape.distance(DVec2::new(0.0575, 0.31)).0 < 0.0 && lane.shape.distance(DVec2::new(0.0585, 0.31)).0 > 0.0
    );
    let Kind::Rollover(star) = kind(&table, "star") else { panic!() };
    assert_eq!(star.shape, Shape::disc(DVec2::new(80.0, 300.0), 10.0).scaled(0.001));
    let Kind::Gate(gate) = kind(&table, "gate") else { panic!() };
    assert!(near(gate.direction, -1.0, 0.0));
    let Kind::Gate(slanted) = kind(&table, "slanted") else { panic!() };
    assert!(near(slanted.direction, 1.0, 0.0), "it opens straight, to the side that is named");
    assert!(matches!(kind(&table, "spin"), Kind::Spinner(spinner) if spinner.damping_per_s > 0.0));
    let Kind::Saucer(saucer) = kind(&table, "hole") else { panic!() };
    assert!(near(saucer.eject_m_s, 0.0, 1.5) && (saucer.circle.radius - 0.014).abs() < 1e-15);
}

#[test]
fn coils_and_captive_balls_become_what_they_are() {
    let numbers =
        "[class.kickback]\nspeed_m_s = 4\n[part.pull]\npull_m_s2 = 55\n[class.captive-ball]\nthreshold_m_s = 0.3";
    let drawn = r#"<line id="kick" class="kickback" x1="40" y1="900" x2="40" y2="876" stroke-width="20"/>
        <circle id="pull" class="magnet" cx="250" cy="400" r="45"/>
        <line id="flap" class="diverter" data-turn-deg="40" x1="300" y1="500" x2="300" y2="545" stroke-width="3"/>
        <circle id="captive" class="captive-ball" cx="200" cy="300" r="13.3"/>"#;
    let table = super::read(drawn, numbers).unwrap();
    let Kind::Kickback(kick) = kind(&table, "kick") else { panic!() };
    assert!(near(kick.tip, 0.04, 0.9) && near(kick.direction, 0.0, -1.0) && kick.speed_m_s == 4.0);
    assert!((kick.stroke_m - 0.024).abs() < 1e-12 && (kick.half_width_m - 0.01).abs() < 1e-12);
    let Kind::Magnet(magnet) = kind(&table, "pull") else { panic!() };
    assert!(near(magnet.circle.center, 0.25, 0.4) && (magnet.circle.radius - 0.045).abs() < 1e-12);
    assert_eq!(magnet.pull_m_s2, 55.0);
    let Kind::Flipper(flap) = kind(&table, "flap") else { panic!() };
    assert_eq!((flap.control, flap.base.radius, flap.tip_radius_m), (physics::FlipperControl::Rules, 0.0015, 0.0015));
    let quarter = std::f64::consts::FRAC_PI_2;
    assert!((flap.rest_rad - quarter).abs() < 1e-12 && (flap.up_rad - quarter - 40.0_f64.to_radians()).abs() < 1e-12);
    let end = flap.length_m + flap.tip_radius_m;
    assert!(
        (flap.mass_kg * end * end / 3.0 - 140e-6).abs() < 1e-12,
        "its moment of inertia does not depend on its length"
    );
    let Kind::CaptiveBall(captive) = kind(&table, "captive") else { panic!() };
    assert!(near(captive.center, 0.2, 0.3) && captive.threshold_m_s == 0.3);
    let seen: Vec<&str> = table
        .solids
        .iter()
        .filter_map(|solid| solid.part)
        .map(|id| table.layout.parts[usize::from(id.0)].name.as_str())
        .collect();
    assert_eq!(seen, ["flap", "left"], "the scene builder draws rods and balls, and magnets lie below the floor");
}

#[test]
fn ramps_have_a_height_at_each_corner_and_wire_forms_have_wires() {
    let drawn = r#"<path id="up" class="ramp" d="M200 800 V700 A60 60 0 0 1 260 640 H300" stroke-width="44" fill="none"
            data-heights-mm="0, 40 50 50"/>
        <path id="down" class="wire-form" d="M300 640 A60 60 0 0 0 360 580" stroke-width="30" fill="none"
            data-heights-mm="50 20"/>"#;
    let table = super::read(drawn, "").unwrap();
    let Kind::Ramp(up) = kind(&table, "up") else { panic!() };
    assert_eq!((up.path.len(), up.heights_m.as_slice()), (3, &[0.0, 0.04, 0.05, 0.05][..]));
    assert!((up.half_width_m - 0.022).abs() < 1e-12);
    let ends: Vec<DVec2> = up.path.iter().flat_map(|leg| [leg.at(0.0), leg.at(leg.length())]).collect();
    assert!(near(ends[0], 0.2, 0.8) && near(ends[5], 0.3, 0.64), "{ends:?}");
    assert!(ends[1].distance(ends[2]) < 1e-9 && ends[3].distance(ends[4]) < 1e-9, "each leg begins where one ends");
    let Kind::Ramp(down) = kind(&table, "down") else { panic!() };
    assert!(near(down.path[0].at(0.0), 0.3, 0.64) && near(down.path[0].at(down.path[0].length()), 0.36, 0.58));
    let solids = |name: &str| {
        let named = |id: physics::PartId| table.layout.parts[usize::from(id.0)].name == name;
        table.solids.iter().filter(|solid| solid.part.is_some_and(named)).collect::<Vec<_>>()
    };
    assert!(solids("up").len() == 2 && solids("up")[0].plastic_mm.is_some(), "a floor and its sides");
    assert!(solids("down").len() == 1 && solids("down")[0].shapes_mm.len() > 4, "two wires and their hoops");
    assert!(table.solids.iter().filter(|solid| solid.shadow).all(|solid| !solids("up").contains(&solid)));
}

#[test]
fn a_drain_may_be_a_rectangle() {
    let svg = super::SVG.replace(
        r#"<line class="drain" x1="100" y1="980" x2="400" y2="980" stroke-width="20"/>"#,
        r#"<rect id="drain" class="drain" x="100" y="970" width="300" height="20"/>{}"#,
    );
    let table = super::read_files(&svg.replace("{}", ""), "", "").unwrap();
    let Kind::Drain(drain) = kind(&table, "drain") else { panic!() };
    let Shape { core: Core::Segment(line), radius } = drain.shape else { panic!() };
    assert!(
        (radius - 0.01).abs() < 1e-12 && near(line.a.min(line.b), 0.11, 0.98) && near(line.a.max(line.b), 0.39, 0.98)
    );
}

#[test]
fn numbers_come_from_the_part_then_its_class_then_real_machines() {
    let numbers = "[class.bumper]\nkick_m_s = 1.1\nmaterial = \"felt\"\n[part.b]\nkick_m_s = 2\n\
                   [material.felt]\nrestitution = 0.2\nfriction = 0.7\n";
    let bumpers = r#"<circle id="a" class="bumper" cx="100" cy="100" r="25"/><circle id="b" class="bumper" cx="200" cy="100" r="25"/>"#;
    let table = super::read(bumpers, numbers).unwrap();
    let bumper = |name| match kind(&table, name) {
        Kind::Bumper(bumper) => bumper.clone(),
        other => panic!("{other:?}"),
    };
    assert_eq!([bumper("a").kick_m_s, bumper("b").kick_m_s], [1.1, 2.0]);
    assert_eq!([bumper("a").threshold_m_s, bumper("b").threshold_m_s], [0.05, 0.05]);
    assert_eq!((bumper("b").material.restitution, bumper("b").material.friction), (0.2, 0.7));
}

#[test]
fn lamps_shine_in_their_fill_and_know_what_they_stand_in() {
    let drawn = r##"<circle id="pop" class="bumper" cx="100" cy="100" r="25"/>
        <circle id="bulb" class="lamp" cx="100" cy="100" r="5" fill="#ff8000" data-inside="pop"/>
        <path id="arrow" class="insert" style="fill:#00ff00" d="M200 200 h20 v20 h-20 z"/>"##;
    let table = super::read(drawn, "[class.lamp]\npower = 2.5\n[part.bulb]\nreach_mm = 300").unwrap();
    let [bulb, arrow] = &table.lamps[..] else { panic!() };
    assert_eq!((bulb.name.as_str(), bulb.color, bulb.power), ("bulb", [255, 128, 0], 2.5));
    let group = table.solids.iter().find(|solid| solid.part == table.part("pop")).map(|solid| solid.group);
    let LampKind::Bulb { inside, reach_mm, emitter, .. } = bulb.kind else { panic!() };
    assert_eq!((inside, reach_mm, emitter), (group, 300.0, crate::table::Emitter::Disc { radius_mm: 5.0 }));
    let LampKind::Insert { outlines_mm } = &arrow.kind else { panic!() };
    assert_eq!(outlines_mm[0], [(200.0, 200.0), (220.0, 200.0), (220.0, 220.0), (200.0, 220.0)].map(DVec2::from));
    assert_eq!(table.lamp("arrow"), Some(1));
}

#[test]
fn a_lamp_that_is_drawn_as_a_line_is_a_tube_in_the_colour_of_its_line() {
    let drawn =
        r##"<line id="neon" class="lamp" x1="40" y1="60" x2="100" y2="140" stroke="#ff0080" stroke-width="4"/>"##;
    let table = super::read(drawn, "").unwrap();
    assert_eq!(table.lamps[0].color, [255, 0, 128]);
    let LampKind::Bulb { center_mm, emitter, .. } = table.lamps[0].kind else { panic!() };
    assert_eq!(center_mm, DVec2::new(70.0, 100.0));
    assert_eq!(emitter, crate::table::Emitter::Segment { half_mm: DVec2::new(30.0, 40.0) });
}

#[test]
fn solids_stand_below_flippers_below_plastics_and_groups_hold_together() {
    let table = table(
        r#"<g data-group="island"><path id="roof" class="plastic" d="M100 100 h50 v50 z"/>
        <line id="side" class="wall" x1="100" y1="100" x2="150" y2="100" stroke-width="2"/></g>
        <line id="alone" class="wall" x1="300" y1="100" x2="350" y2="100" stroke-width="2"/>
        <polygon id="block" class="wall" points="300 300 340 300 340 340 300 340" fill="brown" stroke-width="4"/>
        <circle id="hole" class="saucer" cx="250" cy="500" r="14" data-eject-deg="90" data-eject-m-s="1.5"/>"#,
    );
    let names: Vec<&str> = table
        .solids
        .iter()
        .map(|solid| solid.part.map_or("plastic", |id| table.layout.parts[usize::from(id.0)].name.as_str()))
        .collect();
    assert_eq!(names, ["side", "alone", "block", "left", "plastic"]);
    let [side, alone, block, left, roof] = &table.solids[..] else { panic!() };
    assert_eq!(side.group, roof.group);
    assert!(side.group != alone.group && alone.group != block.group);
    assert!(side.shadow && left.shadow && !roof.shadow && roof.finish.art && !side.finish.art);
    assert_eq!(roof.plastic_mm.as_ref().map(Vec::len), Some(3));
    assert!(matches!(left.shapes_mm[..], [Shape { core: Core::Taper(hull), .. }] if hull.a.radius == 11.6));
    assert_eq!(block.shapes_mm.len(), 4);
    let top = block.plastic_mm.as_ref().unwrap();
    let low = top.iter().copied().reduce(DVec2::min).unwrap();
    assert!(low.distance(DVec2::new(298.0, 298.0)) < 1e-9, "the top reaches as far as the wall is thick: {low}");
}

#[test]
fn the_page_about_drawing_knows_every_word() {
    let page = include_str!("../../../../../assets/tables/README.md");
    for class in crate::table::svg::element_class::ElementClass::ALL {
        let mut words = vec![class.word().to_string()];
        words.extend(class.data().map(|data| format!("data-{data}")));
        words.extend(class.parameters().iter().map(|key| key.name.to_string()));
        for word in words {
            assert!(page.contains(&format!("`{word}")), "assets/tables/README.md does not say `{word}`");
        }
    }
}
