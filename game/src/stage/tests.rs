//! What moves on the table moves on the stage.

use super::*;
use crate::{Buttons, Simulation};
use physics::Kind;
use std::sync::Arc;

fn set() -> (Arc<Table>, Snapshot) {
    let table = Arc::new(Table::load("spectrum").expect("the project's table is whole"));
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
fn staged(table: &Table, moment: &Snapshot) -> (Vec<Occluder>, f32, usize) {
    let printed = Printed::new(table, &view(table)).expect("its art can be printed");
    let scene = Stage::new(table).scene(table, moment, view(table), &printed);
    (scene.occluders.clone(), scene.tops.iter().map(|top| top.finish.opacity).sum(), scene.glows.len())
}

#[test]
fn a_drop_target_that_is_down_casts_no_shadow_and_is_not_seen() {
    let (table, mut moment) = set();
    let (up, seen_up, _) = staged(&table, &moment);
    let targets = moment.pose.drop_targets.len();
    moment.pose.drop_targets.iter_mut().for_each(|(_, height)| *height = 0.0);
    let (down, seen_down, _) = staged(&table, &moment);
    assert!(targets > 0);
    assert_eq!(up.len() - down.len(), targets);
    assert!((seen_up - seen_down - targets as f32).abs() < 1e-3);
}

#[test]
fn a_flipper_that_is_up_points_where_the_machine_says() {
    let (table, mut moment) = set();
    let (id, angle) = moment.pose.flippers_rad[0];
    let Kind::Flipper(flipper) = &table.layout.parts[usize::from(id.0)].kind else { panic!("not a flipper") };
    let tip = |angle: f64| mm(flipper.base.center + geometry::trig::direction(angle) * flipper.length_m);
    let inside = |occluders: &[Occluder], point| occluders.iter().any(|o| o.shape.distance(point).0 < 0.0);
    let rest = staged(&table, &moment).0;
    moment.pose.flippers_rad[0].1 = flipper.up_rad;
    let up = staged(&table, &moment).0;
    assert!(inside(&rest, tip(angle)) && !inside(&up, tip(angle)));
    assert!(inside(&up, tip(flipper.up_rad)) && !inside(&rest, tip(flipper.up_rad)));
}

#[test]
fn light_meets_the_ball_where_the_machine_has_it() {
    let (table, moment) = set();
    let ball = moment.pose.balls.first().expect("a ball lies in the lane");
    let disc = Shape::disc(mm(ball.center), BALL_RADIUS_MM);
    assert!(staged(&table, &moment).0.iter().any(|occluder| occluder.shape == disc));
}

#[test]
fn dark_inserts_do_not_glow_and_the_parts_keep_their_order() {
    let (table, mut moment) = set();
    let before = staged(&table, &moment);
    moment.lamps.iter_mut().for_each(|lamp| lamp.level = 0);
    let after = staged(&table, &moment);
    assert!(before.2 > 0);
    assert_eq!(after.2, 0);
    assert_eq!(before.0, after.0, "what casts shadows does not depend on the lamps");
}

#[test]
fn a_spinner_that_lies_flat_is_broader_than_one_that_hangs() {
    let (table, mut moment) = set();
    let width = |moment: &Snapshot| {
        let printed = Printed::new(&table, &view(&table)).expect("its art can be printed");
        let scene = Stage::new(&table).scene(&table, moment, view(&table), &printed);
        let area = |top: &Top| match &top.outline {
            Outline::Polygon(points) => {
                let next = points.iter().cycle().skip(1);
                points.iter().zip(next).map(|(a, b)| a.perp_dot(*b)).sum::<f64>().abs() * 0.5
            }
            Outline::Shape(_) => 0.0,
        };
        scene.tops.iter().map(area).sum::<f64>()
    };
    let hanging = width(&moment);
    let (id, angle) = &mut moment.pose.spinners_rad[0];
    *angle = std::f64::consts::FRAC_PI_2;
    let Kind::Spinner(spinner) = &table.layout.parts[usize::from(id.0)].kind else { panic!("not a spinner") };
    let axle_mm = spinner.segment.length() * 1000.0;
    assert!((width(&moment) - hanging - axle_mm * 22.0).abs() < 1.0);
}
