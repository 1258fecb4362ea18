//! Which part of the table is shown when not all of it is: a camera that follows the ball.
//!
//! It is moved in steps of a tick, by the snapshots that are drawn and by nothing else, so the same snapshots give the
//! same frames. It refuses to know a clock, and what is in the frame.

use crate::simulation::Snapshot;
use geometry::DVec2;
use physics::BallPose;

/// How quickly it closes in, 1/s: critically damped, it has closed nine tenths of its way in 0.28 s.
const RATE: f64 = 14.0;
/// How far ahead of a ball it looks, s: a little less than its own delay on a steady way, which is 2 / rate.
const AHEAD_S: f64 = 0.11;
/// But no farther than this, mm.
const AHEAD_MM: f64 = 330.0;
/// How far from the middle what it follows may be, in parts of what is shown: nearly at the edge.
const MARGIN: f64 = 0.42;
/// How much of a ball's way to the side it goes along with: the flippers are in the middle.
const SIDEWAYS: f64 = 0.8;
/// A tick, s.
const TICK_S: f64 = 1.0 / physics::TICKS_PER_SECOND as f64;
/// After a longer gap than this it is at rest at once, ticks.
const LONGEST_GAP: u64 = 500;
/// How much less a ball counts that is held.
const HELD: f64 = 0.02;

/// Where the camera is.
#[derive(Clone, Debug, Default)]
pub struct Camera(Option<CameraState>);

#[derive(Clone, Debug)]
struct CameraState {
    tick: u64,
    aim_mm: DVec2,
    middle_mm: DVec2,
    speed_mm_s: DVec2,
}

impl Camera {
    /// The middle of what is shown of a table of `size_mm` in this snapshot, mm: of `shown_mm`, all of which is table.
    pub fn follow(&mut self, snapshot: &Snapshot, size_mm: DVec2, shown_mm: DVec2) -> DVec2 {
        let room = (size_mm - shown_mm).max(DVec2::ZERO) * 0.5;
        let within = |point: DVec2| point.clamp(size_mm * 0.5 - room, size_mm * 0.5 + room);
        let Aim { now_mm, soon_mm } = aim(&snapshot.pose.balls, size_mm);
        let aim_mm = within(soon_mm);
        let still = CameraState { tick: snapshot.tick, aim_mm, middle_mm: aim_mm, speed_mm_s: DVec2::ZERO };
        let state = self.0.get_or_insert(still.clone());
        match snapshot.tick.checked_sub(state.tick).filter(|ticks| *ticks <= LONGEST_GAP) {
            Some(ticks) => state.advance(ticks, aim_mm),
            None => *state = still,
        }
        // However fast it is, what it follows stays in sight.
        state.middle_mm = state.middle_mm.clamp(now_mm - shown_mm * MARGIN, now_mm + shown_mm * MARGIN);
        within(state.middle_mm)
    }

    /// Forgets where it was: it will be at rest wherever it looks next.
    pub fn reset(&mut self) {
        self.0 = None;
    }
}

impl CameraState {
    /// Some ticks later, when it aims somewhere else.
    fn advance(&mut self, ticks: u64, aim_mm: DVec2) {
        let from = self.aim_mm;
        for tick in 1..=ticks {
            let aim = from.lerp(aim_mm, tick as f64 / ticks as f64);
            let pull = (aim - self.middle_mm) * (RATE * RATE) - self.speed_mm_s * (2.0 * RATE);
            self.speed_mm_s += pull * TICK_S;
            self.middle_mm += self.speed_mm_s * TICK_S;
        }
        self.tick += ticks;
        self.aim_mm = aim_mm;
    }
}

/// Where to look, mm.
struct Aim {
    now_mm: DVec2,
    /// A little later.
    soon_mm: DVec2,
}

/// At the balls, the lowest by far the most; at the flippers where there is none.
fn aim(balls: &[BallPose], size_mm: DVec2) -> Aim {
    let flippers = DVec2::new(size_mm.x * 0.5, size_mm.y);
    let (mut sum, mut ahead, mut weights) = (DVec2::ZERO, DVec2::ZERO, 0.0);
    for ball in balls.iter().filter(|ball| ball.center.is_finite() && ball.velocity.is_finite()) {
        let center = ball.center * 1000.0;
        let low = (center.y / size_mm.y).clamp(0.0, 1.0) + 0.1;
        let weight = low * low * low * low * low * low * if ball.held { HELD } else { 1.0 };
        sum += center * weight;
        ahead += (ball.velocity * 1000.0 * AHEAD_S).clamp_length_max(AHEAD_MM) * weight;
        weights += weight;
    }
    if weights == 0.0 {
        return Aim { now_mm: flippers, soon_mm: flippers };
    }
    let towards = |middle: DVec2| DVec2::new(flippers.x + (middle.x - flippers.x) * SIDEWAYS, middle.y);
    Aim { now_mm: sum / weights, soon_mm: towards((sum + ahead) / weights) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use physics::Pose;

    const SIZE: DVec2 = DVec2::new(514.0, 1067.0);
    const SHOWN: DVec2 = DVec2::new(257.0, 533.5);

    fn ball(center: DVec2, velocity: DVec2) -> BallPose {
        BallPose {
            id: 1,
            center,
            velocity,
            spin: [0.0; 3],
            rotation: [0.0, 0.0, 0.0, 1.0],
            held: false,
            height_m: 0.0,
            above: false,
        }
    }

    fn snapshot(tick: u64, balls: Vec<BallPose>) -> Snapshot {
        Snapshot { tick, pose: Pose { balls, ..Pose::default() }, ..Snapshot::default() }
    }

    #[test]
    fn the_first_moment_finds_it_at_rest_on_the_ball_and_without_one_it_shows_the_flippers() {
        let center = DVec2::new(0.257, 0.5);
        let seen = Camera::default().follow(&snapshot(9, vec![ball(center, DVec2::ZERO)]), SIZE, SHOWN);
        assert!((seen - center * 1000.0).length() < 1e-9, "{seen}");
        let seen = Camera::default().follow(&snapshot(9, Vec::new()), SIZE, SHOWN);
        assert_eq!(seen, DVec2::new(257.0, SIZE.y - SHOWN.y * 0.5));
    }

    #[test]
    fn nothing_beyond_the_table_is_shown() {
        let mut camera = Camera::default();
        for tick in 0..400_u32 {
            let place = DVec2::new(0.5 * f64::from(tick % 3), 1.2 * f64::from(tick % 7 / 4));
            let seen = camera.follow(&snapshot(tick.into(), vec![ball(place, DVec2::splat(4.0))]), SIZE, SHOWN);
            let (low, high) = (seen - SHOWN * 0.5, seen + SHOWN * 0.5);
            assert!(low.min_element() >= -1e-9 && (SIZE - high).min_element() >= -1e-9, "{seen}");
        }
    }

    #[test]
    fn a_fast_ball_stays_in_sight_and_the_camera_goes_smoothly() {
        let mut camera = Camera::default();
        let mut last = None;
        // Down at 3 m/s and up again.
        for tick in 0..600_u64 {
            let (t, speed) = if tick < 300 { (tick, 3.0) } else { (600 - tick, -3.0) };
            let place = DVec2::new(0.257, 0.1 + 0.003 * t as f64);
            let seen = camera.follow(&snapshot(tick, vec![ball(place, DVec2::new(0.0, speed))]), SIZE, SHOWN);
            assert!((seen.y - place.y * 1000.0).abs() < SHOWN.y * 0.5, "out of sight at {tick}");
            let step = last.map_or(0.0, |last: DVec2| (seen - last).length());
            assert!(step < 5.0, "a jump of {step} mm at {tick}");
            last = Some(seen);
        }
    }

    #[test]
    fn how_often_it_is_asked_hardly_matters() {
        let at = |camera: &mut Camera, tick: u64| {
            let place = DVec2::new(0.257 + 0.0002 * tick as f64, 0.3 + 0.0008 * tick as f64);
            camera.follow(&snapshot(tick, vec![ball(place, DVec2::new(0.2, 0.8))]), SIZE, SHOWN)
        };
        let (mut often, mut seldom) = (Camera::default(), Camera::default());
        let fine = (0..=480).map(|tick| at(&mut often, tick)).last();
        let coarse = (0..=480).step_by(16).map(|tick| at(&mut seldom, tick)).last();
        let apart = (fine.expect("asked") - coarse.expect("asked")).length();
        assert!(apart < 0.5, "{apart} mm apart");
    }

    #[test]
    fn of_several_balls_the_lowest_counts_by_far_the_most_and_no_ball_makes_it_jump() {
        let two = |y: f64| vec![ball(DVec2::new(0.257, 0.2), DVec2::ZERO), ball(DVec2::new(0.257, y), DVec2::ZERO)];
        assert!(aim(&two(0.9), SIZE).now_mm.y > 850.0);
        let mut last = aim(&two(0.0), SIZE).now_mm.y;
        for step in 1..=1000 {
            let next = aim(&two(f64::from(step) * 0.001), SIZE).now_mm.y;
            assert!((next - last).abs() < 8.0, "{last} {next}");
            last = next;
        }
    }

    #[test]
    fn a_seek_finds_it_at_rest_again() {
        let mut camera = Camera::default();
        camera.follow(&snapshot(5000, Vec::new()), SIZE, SHOWN);
        let there = snapshot(100, vec![ball(DVec2::new(0.257, 0.4), DVec2::ZERO)]);
        assert_eq!(camera.follow(&there, SIZE, SHOWN), Camera::default().follow(&there, SIZE, SHOWN));
    }
}
