//! What moves on the table moves in the scene.

use super::*;
use crate::storage::tables;
use crate::table::Emitter;
use crate::{Buttons, Simulation, small_table};
use physics::Kind;
use std::collections::BTreeMap;
use std::sync::Arc;
use tracer::Profile;

fn set() -> (Arc<Table>, Snapshot) {
    let table = Arc::new(tables::load("spectrum").expect("the project's table is whole"));
    let mut simulation = Simulation::new(table.clone(), 1).expect("its rules run");
    for tick in 0..1200 {
        simulation.tick(if (100..200).contains(&tick) { Buttons::START } else { Buttons::NONE });
    }
    (table, simulation.snapshot())
}

fn view(table: &Table) -> View {
    View::fit(60, 120, table.size_mm)
}

/// The number of occluders and the sum of the tops' opacities, and all occluders.
fn built(table: &Table, snapshot: &Snapshot) -> (Vec<Occluder>, f32, usize) {
    let art = RasterizedArt::new(table, &view(table)).expect("its art can be rasterized");
    let scene = SceneBuilder::new(table).scene(table, snapshot, view(table), &art);
    (scene.occluders.clone(), scene.tops.iter().map(|top| top.finish.opacity).sum(), scene.glows.len())
}

#[test]
fn a_drop_target_that_is_down_casts_no_shadow_and_is_not_seen() {
    let (table, mut snapshot) = set();
    let (up, seen_up, _) = built(&table, &snapshot);
    let targets = snapshot.pose.drop_targets.len();
    snapshot.pose.drop_targets.iter_mut().for_each(|(_, height)| *height = 0.0);
    let (down, seen_down, _) = built(&table, &snapshot);
    assert!(targets > 0);
    assert_eq!(up.len() - down.len(), targets);
    assert!((seen_up - seen_down - targets as f32).abs() < 1e-3);
}

#[test]
fn a_flipper_that_is_up_points_where_the_machine_says() {
    let (table, mut snapshot) = set();
    let (id, angle) = snapshot.pose.flippers_rad[0];
    let Kind::Flipper(flipper) = &table.layout.parts[usize::from(id.0)].kind else { panic!("not a flipper") };
    let tip = |angle: f64| mm(flipper.base.center + geometry::trig::direction(angle) * flipper.length_m);
    let inside = |occluders: &[Occluder], point| occluders.iter().any(|o| o.shape.distance(point).0 < 0.0);
    let rest = built(&table, &snapshot).0;
    snapshot.pose.flippers_rad[0].1 = flipper.up_rad;
    let up = built(&table, &snapshot).0;
    assert!(inside(&rest, tip(angle)) && !inside(&up, tip(angle)));
    assert!(inside(&up, tip(flipper.up_rad)) && !inside(&rest, tip(flipper.up_rad)));
}

#[test]
fn light_meets_the_ball_where_the_machine_has_it() {
    let (table, snapshot) = set();
    let ball = snapshot.pose.balls.first().expect("a ball lies in the lane");
    let disc = Shape::disc(mm(ball.center), BALL_RADIUS_MM);
    assert!(built(&table, &snapshot).0.iter().any(|occluder| occluder.shape == disc));
}

#[test]
fn dark_inserts_do_not_glow_and_the_parts_keep_their_order() {
    let (table, mut snapshot) = set();
    let before = built(&table, &snapshot);
    snapshot.lamps.iter_mut().for_each(|lamp| lamp.level = 0);
    let after = built(&table, &snapshot);
    assert!(before.2 > 0);
    assert_eq!(after.2, 0);
    assert_eq!(before.0, after.0, "what casts shadows does not depend on the lamps");
}

/// What a top is, whatever it does: its group and the form of its edge.
fn kinds(scene: &Scene) -> BTreeMap<u32, (Group, Profile)> {
    scene.tops.iter().map(|top| (top.id.0, (top.group, top.finish.profile))).collect()
}

#[test]
fn a_thing_keeps_its_ids_in_every_picture() {
    let (table, snapshot) = set();
    let art = RasterizedArt::new(&table, &view(&table)).expect("its art can be rasterized");
    let builder = SceneBuilder::new(&table);
    let scene = |snapshot: &Snapshot| builder.scene(&table, snapshot, view(&table), &art);
    let mut moved = snapshot.clone();
    moved.pose.extensions.iter_mut().for_each(|(_, out)| *out = 0.7);
    moved.pose.drop_targets.iter_mut().for_each(|(_, up)| *up = 0.0);
    moved.pose.gates_rad.iter_mut().chain(&mut moved.pose.spinners_rad).for_each(|(_, angle)| *angle = 1.0);
    moved.pose.plunger = 1.0;
    let (still, moved) = (scene(&snapshot), scene(&moved));
    assert_eq!((still.check(), moved.check()), (Ok(()), Ok(())), "no id is there twice");
    let (before, after) = (kinds(&still), kinds(&moved));
    let same = before.iter().filter(|(id, kind)| after.get(id) == Some(kind)).count();
    assert_eq!(same, still.tops.len(), "all that was there is there under its id");
    assert!(moved.tops.len() > still.tops.len(), "the slingshots' rubbers are in two parts");
    let far = |outline: &Outline| matches!(outline, Outline::Shape(shape) if shape.bounds().min.x < -1e3);
    assert!(!still.tops.iter().any(|top| far(&top.outline)), "nothing is there only to be counted");
}

#[test]
fn a_spinner_that_lies_flat_is_as_broad_as_the_plate_that_a_ball_hits() {
    let (table, mut snapshot) = set();
    let width = |snapshot: &Snapshot| {
        let art = RasterizedArt::new(&table, &view(&table)).expect("its art can be rasterized");
        let scene = SceneBuilder::new(&table).scene(&table, snapshot, view(&table), &art);
        let area = |top: &Top| match &top.outline {
            Outline::Polygon(points) => {
                let next = points.iter().cycle().skip(1);
                points.iter().zip(next).map(|(a, b)| a.perp_dot(*b)).sum::<f64>().abs() * 0.5
            }
            Outline::Shape(_) => 0.0,
        };
        scene.tops.iter().map(area).sum::<f64>()
    };
    let hanging = width(&snapshot);
    let (id, angle) = &mut snapshot.pose.spinners_rad[0];
    *angle = std::f64::consts::FRAC_PI_2;
    let Kind::Spinner(spinner) = &table.layout.parts[usize::from(id.0)].kind else { panic!("not a spinner") };
    let axle_mm = spinner.segment.length() * 1000.0;
    assert!((width(&snapshot) - hanging - axle_mm * 2000.0 * physics::AXLE_TO_EDGE_M).abs() < 1.0);
}

const COILS: &str = r#"<line id="kick" class="kickback" x1="40" y1="900" x2="40" y2="870" stroke-width="20"/>
    <circle id="pull" class="magnet" cx="250" cy="450" r="45"/>
    <line id="flap" class="diverter" data-turn-deg="40" x1="330" y1="560" x2="330" y2="605" stroke-width="3"/>
    <circle id="captive" class="captive-ball" cx="150" cy="300" r="13.5"/>
    <line class="guide" x1="120" y1="314.5" x2="180" y2="314.5" stroke-width="2"/>"#;

/// The moment `ticks` after the rules have ordered these coils.
fn ordered(orders: &str, ticks: usize) -> (Table, Snapshot) {
    let rules = format!("fn on_start() {{ kickers(true); {orders} }}");
    let table = small_table::with_rules(COILS, &rules);
    let mut simulation = Simulation::new(Arc::new(table.clone()), 1).expect("its rules run");
    (0..ticks).for_each(|_| simulation.tick(Buttons::NONE));
    assert!(simulation.complaints().is_empty());
    (table, simulation.snapshot())
}

#[test]
fn what_the_rules_order_is_seen() {
    let at = |occluders: &[Occluder], x, y| occluders.iter().any(|o| o.shape.distance(DVec2::new(x, y)).0 < 0.0);
    let (table, rest) = ordered("", 16);
    let (_, moved) = ordered("kick(\"kick\"); divert(\"flap\", true); magnet(\"pull\", true);", 16);
    let (before, after) = (built(&table, &rest).0, built(&table, &moved).0);
    assert!(
        !at(&before, 40.0, 878.0) && at(&after, 40.0, 878.0),
        "the kickback's rod is out: {:?}",
        moved.pose.extensions
    );
    let tip = DVec2::new(330.0, 560.0) + geometry::trig::direction(130.0_f64.to_radians()) * 44.0;
    let (_, turned) = ordered("divert(\"flap\", true);", 100);
    let turned = built(&table, &turned).0;
    assert!(at(&before, 330.0, 604.0) && !at(&turned, 330.0, 604.0) && at(&turned, tip.x, tip.y));
    assert_eq!((rest.pose.magnets[0].1, moved.pose.magnets[0].1), (false, true));
}

#[test]
fn a_captive_ball_is_seen_as_a_ball_and_is_none_that_is_in_play() {
    let (table, snapshot) = ordered("", 16);
    assert!(snapshot.pose.balls.is_empty());
    let art = RasterizedArt::new(&table, &view(&table)).expect("its art can be rasterized");
    let scene = SceneBuilder::new(&table).scene(&table, &snapshot, view(&table), &art);
    let [ball] = &scene.balls[..] else { panic!("{:?}", scene.balls) };
    assert!(ball.center_mm.distance(DVec2::new(150.0, 300.0)) < 0.1 && ball.radius_mm == BALL_RADIUS_MM);
    assert!(scene.occluders.iter().any(|occluder| occluder.group == ball.group));
}

#[test]
fn the_light_that_an_eye_gets_used_to_is_the_integral_of_a_bulbs_falloff() {
    let (center_mm, height_mm, reach_mm) = (DVec2::splat(500.0), 30.0, 400.0);
    let bulb = Emitter::Disc { radius_mm: 1.0 };
    let kind = LampKind::Bulb { center_mm, emitter: bulb, height_mm, reach_mm, inside: None };
    let lamp = Lamp { name: String::new(), color: [255; 3], power: 2.0, kind };
    let emitter = convert::emitter(bulb);
    let id = ItemId(0);
    let light = tracer::Lamp { id, center_mm, emitter, height_mm, reach_mm, color: [1.0; 3], inside: None };
    let points = (0..1000).flat_map(|x| (0..1000).map(move |y| DVec2::new(f64::from(x), f64::from(y))));
    let mean = points.map(|point| light.falloff(point + DVec2::splat(0.5))).sum::<f64>() * 2.0 / 1e6;
    let found = crate::lamps::mean_light(&lamp, DVec2::splat(1000.0));
    assert!((found / mean - 1.0).abs() < 1e-3, "{found} {mean}");
}

#[test]
fn table_and_light_agree_on_when_a_line_is_a_point() {
    assert_eq!(Emitter::LEAST_HALF_MM, tracer::Lamp::LEAST_HALF_MM);
    assert_eq!(crate::lamps::REFERENCE_MM, tracer::Lamp::REFERENCE_MM);
}
