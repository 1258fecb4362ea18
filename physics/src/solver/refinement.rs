//! The very moment of a hit, once it is known what hits what: where both are then, and how fast.
//!
//! Refuses to know what happens then.

use crate::BALL_RADIUS_M;
use crate::solver::sweep::{SLOW_M_S, Strike, Sweep, Target};
use geometry::DVec2;

/// Farther than this from where it seemed to be, a hit was no hit on the straight way either.
const BEND_M: f64 = 2e-6;

impl Sweep<'_> {
    /// The very moment of a hit that was found on a straight way: the true one bends by a quarter of a micron.
    pub(crate) fn refine(&self, mut strike: Strike, reach: f64) -> Strike {
        for _ in 0..2 {
            if strike.time <= 0.0 {
                break;
            }
            let (gap, normal, closing) = self.gap_at(&strike);
            if closing <= SLOW_M_S || gap.abs() > BEND_M {
                break;
            }
            strike.time = (strike.time + gap / closing).clamp(0.0, reach);
            strike.normal = normal;
        }
        strike
    }

    /// Distance, normal and speed of approach of the two that meet, at the moment of the strike.
    fn gap_at(&self, strike: &Strike) -> (f64, DVec2, f64) {
        let time = strike.time;
        let place = |ball: usize| self.state.balls[ball].center + self.mean_velocity(ball, time) * time;
        let speed = |ball: usize| 2.0 * self.mean_velocity(ball, time) - self.mean_velocity(ball, 0.0);
        let (center, velocity) = (place(strike.ball), speed(strike.ball));
        match strike.target {
            Target::Obstacle(index) => {
                let (distance, normal) = self.plan.obstacles[index].shape.distance(center);
                (distance, normal, -velocity.dot(normal))
            }
            Target::Rod(index) => {
                let (rod, slide) = (&self.state.mechanisms.rods[index], &self.plan.slides[index]);
                let moved = slide.velocity(rod);
                let (distance, normal) = slide.face(rod).distance(center - moved * time);
                (distance, normal, (moved - velocity).dot(normal))
            }
            Target::Flipper(index) => {
                let (rotor, blade) = (&self.state.mechanisms.rotors[index], &self.plan.blades[index]);
                let (distance, normal) = blade.taper(rotor.angle + rotor.speed * time).distance(center);
                let lever = center - normal * BALL_RADIUS_M - blade.pivot();
                (distance - BALL_RADIUS_M, normal, (rotor.velocity_at(lever) - velocity).dot(normal))
            }
            Target::Ball(other) => {
                let away = center - place(other);
                let normal = away.try_normalize().unwrap_or(strike.normal);
                (away.length() - 2.0 * BALL_RADIUS_M, normal, (speed(other) - velocity).dot(normal))
            }
        }
    }

    /// How much faster than on its mean a flipper turns at the moment of a firm hit, rad/s.
    pub(crate) fn ahead(&self, strike: &Strike, left: f64, duration: f64) -> f64 {
        let Target::Flipper(index) = strike.target else { return 0.0 };
        let gain = self.state.mechanisms.rotors[index].rest_of_step;
        let ahead = gain * (1.0 - 2.0 * left / duration);
        let firm = self.gap_at(&Strike { time: 0.0, ..*strike }).2 > 4.0 * (gain * self.plan.blades[index].reach).abs();
        if firm { ahead } else { 0.0 }
    }
}
