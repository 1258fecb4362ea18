//! Balls that are stuck, and balls that only look so.

use super::{Anomaly, AnomalyDetector, AnomalyKind};
use crate::table::tests::{BACK_TO_CUP, CUP, with_rules};
use geometry::DVec2;
use physics::{BallPose, Command, Controls, Machine};
use std::sync::Arc;

/// From one round of the ball search to the next, ticks.
const SEARCH_TICKS: u64 = 12_000;

/// What is noticed of a ball that is let go there, in 140 s.
fn noticed(drawn: &str, place: DVec2, search_ticks: u64, excused: impl Fn(&BallPose) -> bool) -> Vec<Anomaly> {
    let table = with_rules(drawn, "");
    let mut machine = Machine::new(Arc::new(table.layout.clone())).unwrap();
    machine.tick(Controls::NONE, &[Command::SetCoils(true)]);
    machine.put_ball(place, DVec2::ZERO, [0.0; 3]);
    let mut detector = AnomalyDetector::new(&table.layout);
    for tick in 0..140_000 {
        let search = if tick % search_ticks == search_ticks - 1 { &[Command::BallSearch][..] } else { &[] };
        machine.tick(Controls::NONE, search);
        detector.look(tick, &machine.pose(), &excused);
    }
    detector.anomalies()
}

/// A ball that the ball search threw out of a cup fell back into it, every 12 s for an hour, and was not called stuck.
#[test]
fn a_ball_that_hops_in_a_cup_is_stuck() {
    let cup = &format!("{CUP}{BACK_TO_CUP}");
    let place = DVec2::new(0.2833, 0.6173);
    let [anomaly] = &noticed(cup, place, SEARCH_TICKS, |_| false)[..] else { panic!() };
    assert_eq!(anomaly.kind, AnomalyKind::Stuck);
    assert!(anomaly.center_mm.distance(place * 1000.0) < 150.0 && anomaly.tick >= 120_000, "{anomaly:?}");
    assert_eq!(noticed(cup, place, SEARCH_TICKS, |_| true), [], "the plunger's lane, a raised flipper");
}

/// A saucer may keep its ball for as long as it likes.
#[test]
fn a_ball_that_is_held_is_not_stuck() {
    let saucer =
        r#"<circle class="saucer" id="hole" cx="200" cy="300" r="15" data-eject-deg="90" data-eject-m-s="1"/>"#;
    assert_eq!(noticed(saucer, DVec2::new(0.2, 0.3), u64::MAX, |_| false), []);
}
