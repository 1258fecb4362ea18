//! Notices what must never happen to a ball.

use super::stay::Stay;
use geometry::{DVec2, Shape};
use physics::{BALL_RADIUS_M, BallPose, Kind, Layout, PartId, Pose};
use std::collections::BTreeMap;

/// Ticks between two looks.
const LOOK_TICKS: u64 = 10;
/// How far a ball must move in [`STUCK_TICKS`], m.
const STUCK_M: f64 = 0.002;
/// How long a ball may lie outside of lane, saucer and flippers, ticks.
const STUCK_TICKS: u64 = 20_000;
/// How long a ball may hop about one place outside of the same, ticks: the ball search fires its coils ten times.
const HOPPING_TICKS: u64 = 120_000;
/// A ball that is no farther from a flipper may be thrown by it, m.
const FLIPPER_RANGE_M: f64 = 0.002;
/// How far a ball may reach into another thing, m.
const OVERLAP_M: f64 = 0.000_05;

/// What went wrong.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum AnomalyKind {
    /// A ball has not moved for 20 s where nothing holds it, or it has come back to the same place for 120 s where
    /// nothing holds it and no flipper throws it.
    Stuck,
    /// A ball is outside the playfield.
    Escaped,
    /// A ball is more than 0.05 mm inside a wall, a flipper, a bumper or another ball.
    Overlap,
    /// A ball is nowhere: a number is not finite.
    NotANumber,
}

impl std::fmt::Display for AnomalyKind {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.write_str(match self {
            AnomalyKind::Stuck => "stuck",
            AnomalyKind::Escaped => "escaped",
            AnomalyKind::Overlap => "overlap",
            AnomalyKind::NotANumber => "NaN",
        })
    }
}

/// One thing that went wrong.
#[derive(Clone, Debug, PartialEq)]
pub struct Anomaly {
    /// What.
    pub kind: AnomalyKind,
    /// When.
    pub tick: u64,
    /// Where the ball was, mm.
    pub center_mm: DVec2,
    /// It was on a ramp, or high above the playfield.
    pub above: bool,
    /// What it was in or near: a part's name, or how fast it was.
    pub detail: String,
}

/// The anomaly detector: watches the balls of one game.
pub struct AnomalyDetector {
    solids: Vec<Solid>,
    flippers: Vec<physics::Flipper>,
    kinds: Vec<Kind>,
    size_m: DVec2,
    /// Where each ball was when it last moved, and when.
    rests: BTreeMap<u32, (DVec2, u64)>,
    /// About which place each ball stays.
    stays: BTreeMap<u32, Stay>,
    /// What has been noticed: once for each ball and kind.
    noticed: BTreeMap<(u32, AnomalyKind), Anomaly>,
}

/// A surface that does not move.
struct Solid {
    name: String,
    shape: Shape,
    /// A drop target's index among the pose's drop targets.
    drop_target: Option<usize>,
}

impl AnomalyDetector {
    /// A detector for a game on this layout.
    pub fn new(layout: &Layout) -> AnomalyDetector {
        let mut detector = AnomalyDetector {
            solids: vec![],
            flippers: vec![],
            kinds: layout.parts.iter().map(|part| part.kind.clone()).collect(),
            size_m: layout.size_m,
            rests: BTreeMap::new(),
            stays: BTreeMap::new(),
            noticed: BTreeMap::new(),
        };
        let mut drop_targets = 0;
        for part in &layout.parts {
            let drop_target = matches!(part.kind, Kind::DropTarget(_)).then_some(drop_targets);
            drop_targets += usize::from(drop_target.is_some());
            for shape in part.kind.surfaces() {
                detector.solids.push(Solid { name: part.name.clone(), shape, drop_target });
            }
            if let Kind::Flipper(flipper) = &part.kind {
                detector.flippers.push(flipper.clone());
            }
        }
        detector
    }

    /// Looks at the table after a tick. `excused`: a ball may lie still here (in the plunger's lane, on a raised flipper,
    /// or no game is on).
    pub fn look(&mut self, tick: u64, pose: &Pose, excused: impl Fn(&BallPose) -> bool) {
        if !tick.is_multiple_of(LOOK_TICKS) {
            return;
        }
        for (index, ball) in pose.balls.iter().enumerate() {
            let others = pose.balls[index + 1..].iter().chain(pose.captives.iter().map(|(_, captive)| captive));
            if !(ball.center.is_finite() && ball.velocity.is_finite()) {
                self.notice(tick, ball, AnomalyKind::NotANumber, format!("velocity {:?}", ball.velocity));
                continue;
            }
            if self.outside(ball.center) {
                self.notice(tick, ball, AnomalyKind::Escaped, format!("at {:.2} m/s", ball.velocity.length()));
            }
            if let Some((name, depth_m)) = self.inside_of(ball, pose, others) {
                self.notice(tick, ball, AnomalyKind::Overlap, format!("{:.3} mm inside {name}", depth_m * 1000.0));
            }
            let kind_of = |part: PartId| self.kinds.get(usize::from(part.0));
            let excused = ball.held || pose.may_hold(ball, kind_of) || excused(ball);
            self.look_for_rest(tick, ball, excused);
            self.look_for_stay(tick, ball, excused || self.is_at_flipper(ball, pose));
        }
        for (_, captive) in &pose.captives {
            if !(captive.center.is_finite() && captive.velocity.is_finite()) {
                self.notice(tick, captive, AnomalyKind::NotANumber, "a captive ball".to_string());
            } else if self.outside(captive.center) {
                self.notice(tick, captive, AnomalyKind::Escaped, "a captive ball".to_string());
            }
        }
        self.rests.retain(|id, _| pose.balls.iter().any(|ball| ball.id == *id));
        self.stays.retain(|id, _| pose.balls.iter().any(|ball| ball.id == *id));
    }

    /// Everything that was noticed.
    pub fn anomalies(self) -> Vec<Anomaly> {
        self.noticed.into_values().collect()
    }

    fn notice(&mut self, tick: u64, ball: &BallPose, kind: AnomalyKind, detail: String) {
        let anomaly = Anomaly { kind, tick, center_mm: ball.center * 1000.0, above: ball.above, detail };
        self.noticed.entry((ball.id, kind)).or_insert(anomaly);
    }

    fn outside(&self, center: DVec2) -> bool {
        let inside = |at: f64, size: f64| (-BALL_RADIUS_M..size + BALL_RADIUS_M).contains(&at);
        !inside(center.x, self.size_m.x) || !inside(center.y, self.size_m.y)
    }

    fn look_for_rest(&mut self, tick: u64, ball: &BallPose, excused: bool) {
        let (place, since) = self.rests.entry(ball.id).or_insert((ball.center, tick));
        if excused || place.distance(ball.center) > STUCK_M {
            (*place, *since) = (ball.center, tick);
        } else if tick - *since > STUCK_TICKS {
            self.notice(tick, ball, AnomalyKind::Stuck, "does not move".to_string());
        }
    }

    fn look_for_stay(&mut self, tick: u64, ball: &BallPose, excused: bool) {
        let stay = self.stays.entry(ball.id).or_insert(Stay::new(ball.center, tick));
        if excused {
            *stay = Stay::new(ball.center, tick);
        } else if stay.look(ball.center, tick) > HOPPING_TICKS {
            self.notice(tick, ball, AnomalyKind::Stuck, "does not come away from there in 120 s".to_string());
        }
    }

    fn is_at_flipper(&self, ball: &BallPose, pose: &Pose) -> bool {
        let mut flippers = self.flippers.iter().zip(&pose.flippers_rad);
        flippers.any(|(flipper, (_, angle))| {
            flipper.outline(*angle).distance(ball.center).0 < BALL_RADIUS_M + FLIPPER_RANGE_M
        })
    }

    /// What the ball is inside of, and how deep.
    fn inside_of<'a>(
        &self,
        ball: &BallPose,
        pose: &Pose,
        others: impl Iterator<Item = &'a BallPose>,
    ) -> Option<(String, f64)> {
        let stands = |solid: &Solid| match solid.drop_target {
            Some(index) => pose.drop_targets.get(index).is_some_and(|(_, up)| *up >= 1.0),
            None => true,
        };
        if ball.above {
            return None; // what stands on the playfield is below it, and its own way is a part of the machine's
        }
        let near = |solid: &&Solid| solid.shape.bounds().grown(BALL_RADIUS_M).contains(ball.center);
        let solids = self.solids.iter().filter(near).filter(|solid| stands(solid));
        let solids = solids.map(|solid| (solid.name.as_str(), solid.shape.distance(ball.center).0));
        let flippers = self.flippers.iter().zip(&pose.flippers_rad);
        let flippers =
            flippers.map(|(flipper, (_, angle))| ("a flipper", flipper.outline(*angle).distance(ball.center).0));
        let others = others.filter(|_| !ball.held);
        let balls = others.map(|other| ("another ball", other.center.distance(ball.center) - BALL_RADIUS_M));
        solids
            .chain(flippers)
            .chain(balls)
            .map(|(name, distance)| (name.to_string(), BALL_RADIUS_M - distance))
            .find(|(_, depth)| *depth > OVERLAP_M)
    }
}

#[cfg(test)]
mod tests;
