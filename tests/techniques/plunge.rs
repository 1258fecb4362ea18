//! The skill shot.

use super::{NONE, Play};
use physics::{Command, Controls};

/// The first of the top lanes or orbits that the ball comes to after a pull of `ms`, and the ball's farthest way up.
fn shot(ms: usize) -> String {
    let mut play = Play::new();
    play.machine.tick(NONE, &[Command::AddBall]);
    let mut play = play.then(&[(1500, NONE), (ms, Controls { plunger: true, ..NONE })]);
    play.switches.clear();
    let named = |name: &str| {
        name.starts_with("lane-") && name != "lane-gate" || name.starts_with("orbit-") && name != "orbit-gate"
    };
    play.until(NONE, 6000, |play| play.switches.iter().any(|name| named(name)) || play.switches.len() > 5);
    play.switches.iter().find(|name| named(name)).cloned().unwrap_or_else(|| "back".to_string())
}

#[test]
fn the_landing_lane_is_a_function_of_the_pull() {
    let pulls: Vec<(usize, String)> = (300..=1000).step_by(10).map(|ms| (ms, shot(ms))).collect();
    let mut lanes: Vec<&str> = pulls.iter().map(|(_, lane)| lane.as_str()).collect();
    lanes.dedup();
    println!("{lanes:?}");
    assert!(lanes.len() <= 8, "a pull that differs by a hundredth lands elsewhere too often: {lanes:?}");
    let mut reached = lanes.clone();
    reached.sort_unstable();
    reached.dedup();
    assert!(reached.len() >= 5, "{reached:?}");
}
