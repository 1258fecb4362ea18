//! Each class of thing becomes what it should, in metres.

use super::table;
use crate::table::Table;
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
    assert!((flipper.rest_rad - (35.0_f64 / 60.0).atan()).abs() < 1e-12);
    assert!((flipper.rest_rad - flipper.up_rad - 50.0_f64.to_radians()).abs() < 1e-12);
    let Kind::Plunger(plunger) = kind(&table, "plunger") else { panic!() };
    assert!(near(plunger.way, 0.0, -1.0) && near(plunger.tip, 0.48, 0.9));
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
