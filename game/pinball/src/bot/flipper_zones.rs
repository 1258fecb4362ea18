//! Flipper zones: what a player sees at a glance: where the flippers are, and whether a ball is safe, in reach or lost.

use geometry::{DVec2, trig};
use physics::{BALL_RADIUS_M, BallPose, FlipperControl, Kind, Layout};

/// Fastest ball that lies, m/s.
const LYING_M_S: f64 = 0.06;
/// How far beyond a flipper's rubber a ball is still worth a stroke, m.
const REACH_MARGIN_M: f64 = 0.012;

/// The parts of a layout that decide how it is played.
#[derive(Clone, Debug, Default)]
pub(super) struct FlipperZones {
    /// The flippers.
    pub flippers: Vec<Flipper>,
    /// The line of the lowest pivots, m: below it a ball that no flipper reaches is lost.
    pub line_m: f64,
    /// Where a ball waits for the plunger.
    pub feed: Option<DVec2>,
    /// Ticks of a full pull.
    pub pull_ticks: u64,
}

/// A flipper as the player's hand knows it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Flipper {
    /// Answers to the left button.
    pub left: bool,
    /// Its pivot.
    pub pivot: DVec2,
    /// Its tip at rest.
    pub tip: DVec2,
    /// Its tip at the end of the stroke.
    pub raised_tip: DVec2,
    /// From the pivot to the end of the tip.
    pub length_m: f64,
}

impl FlipperZones {
    /// What there is to see of `layout`.
    pub fn new(layout: &Layout) -> FlipperZones {
        let mut seen = FlipperZones::default();
        for part in &layout.parts {
            match &part.kind {
                Kind::Flipper(flipper) => seen.flippers.extend(Flipper::new(flipper)),
                Kind::Plunger(plunger) => {
                    seen.feed = Some(plunger.feed);
                    seen.pull_ticks = (plunger.pull_s * f64::from(physics::TICKS_PER_SECOND)).ceil() as u64;
                }
                _ => {}
            }
        }
        seen.line_m = seen.flippers.iter().map(|flipper| flipper.pivot.y).fold(0.0, f64::max);
        if seen.flippers.is_empty() {
            seen.line_m = layout.size_m.y;
        }
        seen
    }

    /// The flipper that a ball at `center` is in reach of.
    pub fn in_reach(&self, center: DVec2) -> Option<&Flipper> {
        self.flippers.iter().find(|flipper| flipper.reaches(center))
    }

    /// A ball that no flipper can save any more, nor anything above.
    pub fn lost(&self, center: DVec2) -> bool {
        center.y > self.line_m + 0.5 * BALL_RADIUS_M && self.in_reach(center).is_none()
    }

    /// A ball that waits for the plunger.
    pub fn waits(&self, ball: &BallPose) -> bool {
        let near = |feed: DVec2| (ball.center.x - feed.x).abs() < BALL_RADIUS_M && ball.center.y > feed.y - 0.05;
        self.feed.is_some_and(near) && ball.velocity.length() < LYING_M_S
    }

    /// A ball anywhere in the plunger's lane, below the middle of the table.
    pub fn in_lane(&self, ball: &BallPose) -> bool {
        self.feed.is_some_and(|feed| (ball.center.x - feed.x).abs() < BALL_RADIUS_M && ball.center.y > 0.5 * feed.y)
    }

    /// The flipper on which a ball lies still.
    pub fn cradle(&self, ball: &BallPose) -> Option<&Flipper> {
        let lies = !ball.held && ball.velocity.length() < LYING_M_S;
        self.in_reach(ball.center).filter(|_| lies)
    }

    /// When, in ticks from now, a ball could be down at the flippers; `None` if not within a second.
    pub fn arrives_in(&self, ball: &BallPose) -> Option<u64> {
        let zone_m = self.flippers.iter().map(|flipper| flipper.raised_tip.y).fold(self.line_m, f64::min) - 0.04;
        let below_m = zone_m - ball.center.y;
        if below_m <= 0.0 {
            return Some(0);
        }
        (ball.velocity.y > 0.0 && below_m < ball.velocity.y)
            .then(|| (below_m / ball.velocity.y * f64::from(physics::TICKS_PER_SECOND)) as u64)
    }
}

impl Flipper {
    /// `None` of a diverter, which no hand moves.
    fn new(flipper: &physics::Flipper) -> Option<Flipper> {
        let pivot = flipper.base.center;
        let tip = |angle_rad| pivot + trig::direction(angle_rad) * flipper.length_m;
        let left = match flipper.control {
            FlipperControl::Left => true,
            FlipperControl::Right => false,
            FlipperControl::Rules => return None,
        };
        Some(Flipper {
            left,
            pivot,
            tip: tip(flipper.rest_rad),
            raised_tip: tip(flipper.up_rad),
            length_m: flipper.length_m + flipper.tip_radius_m,
        })
    }

    /// Whether a stroke could meet a ball at `center`: it is over the flipper, not beyond its tip and not below it.
    pub fn reaches(&self, center: DVec2) -> bool {
        let from_pivot = center - self.pivot;
        let along = (self.tip - self.pivot).normalize();
        let up = if along.x > 0.0 { DVec2::new(along.y, -along.x) } else { DVec2::new(-along.y, along.x) };
        let far = from_pivot.length() < self.length_m + BALL_RADIUS_M + REACH_MARGIN_M;
        let outward = from_pivot.dot(along) > -2.0 * BALL_RADIUS_M;
        let above = from_pivot.dot(up) > 0.0;
        far && outward && above
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use geometry::Circle;
    use physics::{Material, Part};

    /// Two flippers with a gap of 50 mm between their tips.
    fn zones() -> FlipperZones {
        let flipper = |x: f64, rest_deg: f64, up_deg: f64, control| {
            let rubber = Material { restitution: 0.8, falloff_s_per_m: 0.1, friction: 0.5 };
            Kind::Flipper(physics::Flipper {
                base: Circle { center: DVec2::new(x, 0.9), radius: 0.011 },
                length_m: 0.07,
                tip_radius_m: 0.007,
                rest_rad: rest_deg.to_radians(),
                up_rad: up_deg.to_radians(),
                control,
                material: rubber,
                coil_torque_n_m: 1.0,
                hold_torque_n_m: 1.0,
                spring_torque_n_m: 0.2,
                mass_kg: 0.05,
            })
        };
        let diverter = flipper(0.1, 90.0, 130.0, FlipperControl::Rules);
        let kinds = [
            flipper(0.15, 30.0, -25.0, FlipperControl::Left),
            diverter,
            flipper(0.32, 150.0, 205.0, FlipperControl::Right),
        ];
        let parts = kinds.map(|kind| Part { name: "flipper".into(), kind }).to_vec();
        let size_m = DVec2::new(0.5, 1.0);
        FlipperZones::new(&Layout { size_m, slope_rad: 0.1, playfield_friction: 0.1, parts })
    }

    #[test]
    fn a_ball_over_a_flipper_is_in_reach_and_one_below_or_between_is_lost() {
        let seen = zones();
        let side = |x, y| seen.in_reach(DVec2::new(x, y)).map(|flipper| flipper.left);
        assert_eq!(side(0.18, 0.88), Some(true));
        assert_eq!(side(0.29, 0.88), Some(false));
        assert_eq!(side(0.235, 0.80), None, "too far up");
        assert!(!seen.lost(DVec2::new(0.235, 0.80)));
        assert!(seen.lost(DVec2::new(0.17, 0.95)), "below the left flipper");
        assert!(seen.lost(DVec2::new(0.235, 0.96)), "between the tips");
        assert!(seen.lost(DVec2::new(0.05, 0.95)), "in the outlane");
    }

    #[test]
    fn a_falling_ball_arrives_and_a_rising_one_does_not() {
        let seen = zones();
        let mut ball = BallPose {
            id: 1,
            center: DVec2::new(0.2, 0.43),
            velocity: DVec2::new(0.0, 2.0),
            spin: [0.0; 3],
            rotation: [0.0, 0.0, 0.0, 1.0],
            held: false,
            height_m: 0.0,
            above: false,
        };
        let ticks = seen.arrives_in(&ball).unwrap();
        assert!((180..240).contains(&ticks), "{ticks} ticks for about 0.4 m at 2 m/s");
        ball.velocity.y = -2.0;
        assert_eq!(seen.arrives_in(&ball), None);
    }
}
