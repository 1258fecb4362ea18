//! Interpolation: the snapshot between those of two ticks.

use crate::simulation::{LampLight, Snapshot};
use physics::{BallPose, PartId, Pose};
use std::f64::consts::{PI, TAU};

/// Two snapshots and a point between them: play goes in ticks, frames are shown in between.
#[derive(Clone, Copy)]
pub struct Interpolation<'a> {
    /// The snapshot of the earlier tick.
    pub previous: &'a Snapshot,
    /// The snapshot of the later tick.
    pub current: &'a Snapshot,
    /// How far from the earlier to the later snapshot, 0 to 1.
    pub alpha: f64,
}

impl<'a> Interpolation<'a> {
    /// A snapshot itself.
    pub fn at(snapshot: &'a Snapshot) -> Interpolation<'a> {
        Interpolation { previous: snapshot, current: snapshot, alpha: 1.0 }
    }

    /// The snapshot at that point. What only one of the two knows, and what cannot be between (the display, the tick), is
    /// as in the later.
    pub fn snapshot(&self) -> Snapshot {
        let Interpolation { previous, current, alpha } = *self;
        let pose = blend_pose(&previous.pose, &current.pose, alpha);
        let lamps = if previous.lamps.len() == current.lamps.len() {
            previous.lamps.iter().zip(&current.lamps).map(|(a, b)| blend_lamp(*a, *b, alpha)).collect()
        } else {
            current.lamps.clone()
        };
        Snapshot { pose, lamps, ..current.clone() }
    }
}

fn blend_pose(a: &Pose, b: &Pose, alpha: f64) -> Pose {
    let ball = |ball: &BallPose| match a.balls.iter().find(|before| before.id == ball.id) {
        Some(before) => blend_ball(before, ball, alpha),
        None => *ball,
    };
    let captive = |&(part, ref now): &(PartId, BallPose)| match a.captives.iter().find(|(before, _)| *before == part) {
        Some((_, before)) => (part, blend_ball(before, now, alpha)),
        None => (part, *now),
    };
    Pose {
        balls: b.balls.iter().map(ball).collect(),
        captives: b.captives.iter().map(captive).collect(),
        flippers_rad: blend_parts(&a.flippers_rad, &b.flippers_rad, |x, y| mix(x, y, alpha)),
        drop_targets: blend_parts(&a.drop_targets, &b.drop_targets, |x, y| mix(x, y, alpha)),
        spinners_rad: blend_parts(&a.spinners_rad, &b.spinners_rad, |x, y| mix_angle(x, y, alpha)),
        gates_rad: blend_parts(&a.gates_rad, &b.gates_rad, |x, y| mix(x, y, alpha)),
        extensions: blend_parts(&a.extensions, &b.extensions, |x, y| mix(x, y, alpha)),
        plunger: mix(a.plunger, b.plunger, alpha),
        cabinet_m: a.cabinet_m.lerp(b.cabinet_m, alpha),
        ..b.clone()
    }
}

fn blend_ball(a: &BallPose, b: &BallPose, alpha: f64) -> BallPose {
    let rotation = nlerp(a.rotation, b.rotation, alpha);
    let height_m = a.height_m + (b.height_m - a.height_m) * alpha;
    let (center, velocity) = (a.center.lerp(b.center, alpha), a.velocity.lerp(b.velocity, alpha));
    BallPose { center, velocity, rotation, height_m, ..*b }
}

/// Each part of `b`, blended with the same part of `a` where that has it at the same place.
fn blend_parts(a: &[(PartId, f64)], b: &[(PartId, f64)], mix: impl Fn(f64, f64) -> f64) -> Vec<(PartId, f64)> {
    let one = |(index, &(part, value)): (usize, &(PartId, f64))| match a.get(index) {
        Some(&(before, old)) if before == part => (part, mix(old, value)),
        _ => (part, value),
    };
    b.iter().enumerate().map(one).collect()
}

fn mix(a: f64, b: f64, alpha: f64) -> f64 {
    a + (b - a) * alpha
}

/// The short way round, for a plate that turns and turns.
fn mix_angle(a: f64, b: f64, alpha: f64) -> f64 {
    let turn = (b - a + PI).rem_euclid(TAU) - PI;
    a + turn * alpha
}

/// Normalised blend of two unit quaternions, the short way: a tick turns a ball by less than a radian, where it is as
/// good as the arc.
fn nlerp(a: [f64; 4], b: [f64; 4], alpha: f64) -> [f64; 4] {
    let dot: f64 = a.iter().zip(&b).map(|(x, y)| x * y).sum();
    let sign = if dot < 0.0 { -1.0 } else { 1.0 };
    let mixed: [f64; 4] = std::array::from_fn(|i| mix(a[i], b[i] * sign, alpha));
    let length = mixed.iter().map(|x| x * x).sum::<f64>().sqrt();
    if length > 1e-6 { mixed.map(|x| x / length) } else { b }
}

fn blend_lamp(a: LampLight, b: LampLight, alpha: f64) -> LampLight {
    let channel = |x: u16, y: u16| mix(f64::from(x), f64::from(y), alpha).round() as u16;
    let color = std::array::from_fn(|i| channel(a.color[i].into(), b.color[i].into()) as u8);
    LampLight { level: channel(a.level, b.level), color }
}

#[cfg(test)]
mod tests {
    use super::*;
    use geometry::DVec2;

    fn ball(id: u32, x: f64) -> BallPose {
        let (center, velocity) = (DVec2::new(x, 0.0), DVec2::ZERO);
        BallPose {
            id,
            center,
            velocity,
            spin: [0.0; 3],
            rotation: [0.0, 0.0, 0.0, 1.0],
            held: false,
            height_m: 0.0,
            above: false,
        }
    }

    fn with_balls(balls: Vec<BallPose>) -> Snapshot {
        Snapshot { pose: Pose { balls, ..Pose::default() }, ..Snapshot::default() }
    }

    #[test]
    fn a_ball_is_followed_by_its_id_not_by_its_place_in_the_list() {
        let before = with_balls(vec![ball(1, 0.0), ball(2, 1.0)]);
        let after = with_balls(vec![ball(2, 2.0), ball(3, 9.0)]);
        let halfway = Interpolation { previous: &before, current: &after, alpha: 0.5 }.snapshot();
        assert_eq!(halfway.pose.balls[0].center.x, 1.5);
        assert_eq!(halfway.pose.balls[1].center.x, 9.0, "a new ball does not fly in from another one's place");
    }

    #[test]
    fn the_ends_of_a_blend_are_the_ticks_themselves() {
        let a = with_balls(vec![ball(1, 0.25)]);
        let b = with_balls(vec![ball(1, 0.5)]);
        let at = |alpha: f64| Interpolation { previous: &a, current: &b, alpha }.snapshot();
        assert_eq!(at(0.0).pose, a.pose);
        assert_eq!(at(1.0).pose, b.pose);
    }

    #[test]
    fn a_spinner_goes_the_short_way_over_the_turn() {
        let angle = mix_angle(3.0, -3.0, 0.5);
        assert!((angle - PI).abs() < 1e-12, "{angle}");
    }

    #[test]
    fn a_blended_rotation_is_a_rotation() {
        let half = std::f64::consts::FRAC_1_SQRT_2;
        let mixed = nlerp([0.0, 0.0, 0.0, 1.0], [0.0, 0.0, -half, -half], 0.3);
        assert!((mixed.iter().map(|x| x * x).sum::<f64>() - 1.0).abs() < 1e-12);
    }
}
