//! Shadow rays past floating balls: in space, to places all over a lamp.

use crate::reference::monte_carlo::rays::Rays;
use crate::visibility::sphere_shadow::{self, Sphere};
use crate::{Ball, Group, Lamp};
use geometry::{DVec2, trig};

/// The part of a turn between a seed of a sunflower and the next.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

impl Rays {
    /// How much of a lamp floating balls leave, but for those of a group: rays in space to places all over the lamp.
    pub fn unoccluded_fraction(&self, balls: &[Ball], lamp: &Lamp, without: Option<Group>) -> f64 {
        sphere_shadow::occluding_balls(balls, lamp, without).map(|ball| self.behind(ball, lamp)).product()
    }

    fn behind(&self, ball: &Ball, lamp: &Lamp) -> f64 {
        let sphere = Sphere::new(ball, self.point);
        let place = |target: DVec2| [target.x - self.point.x, target.y - self.point.y, lamp.height_mm()];
        if !sphere.may_hide(place(lamp.center_mm), lamp.radius_mm()) {
            return 1.0;
        }
        let (mut seen, mut all) = (0.0, 0.0);
        for sample in 0..self.sampling.samples.max(1) {
            let target = self.target(lamp, sample);
            let to = place(target);
            let arrives =
                if lamp.tube().is_some() { 1.0 / (to[0] * to[0] + to[1] * to[1] + to[2] * to[2]) } else { 1.0 };
            all += arrives;
            seen += if sphere.hides(to) { 0.0 } else { arrives };
        }
        seen / all
    }

    /// A place on a lamp. Those on a disc are spread as the seeds of a sunflower are, with a start that chance chooses.
    fn target(&self, lamp: &Lamp, sample: u32) -> DVec2 {
        if let Some(half) = lamp.tube() {
            return lamp.center_mm + half * (2.0 * self.place(sample) - 1.0);
        }
        let turn = if self.sampling.stratified {
            self.key.unit() + f64::from(sample) * GOLDEN
        } else {
            self.key.with(u64::from(sample)).with(1).unit()
        };
        let around = trig::direction(std::f64::consts::TAU * (turn - turn.floor()));
        lamp.center_mm + around * (lamp.radius_mm() * self.place(sample).sqrt())
    }
}
