//! Kicker: a coil that throws the ball off a surface when it is hit, as a pop bumper's ring and a slingshot's arm.

use crate::ball::Ball;
use crate::collision::obstacle::{Obstacle, ObstacleRole};
use crate::mechanisms::model::{Model, State};
use crate::part::PartId;
use crate::part::material::Material;
use crate::part::validation::{self, Checked};
use geometry::{Circle, DVec2, Segment, Shape};
use serde::{Deserialize, Serialize};

/// Ticks since it fired after which a kicker is ready again.
const READY_TICKS: u16 = 60;
/// A coil that fires with no ball in its switch throws off what is no farther from its surface, m.
const KICK_REACH_M: f64 = 3e-3;
/// Ticks after which a kicker's arm or ring is all the way out, and ticks that it then takes to go back.
const OUT_TICKS: f64 = 8.0;
const BACK_TICKS: f64 = 40.0;

/// A pop bumper.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Bumper {
    /// Its skirt, where the ball meets it.
    pub circle: Circle,
    /// What the skirt is made of.
    pub material: Material,
    /// Speed that it adds outwards, m/s.
    pub kick_m_s: f64,
    /// Slowest approach that closes its switch, m/s.
    pub threshold_m_s: f64,
}

/// The kicking rubber of a slingshot.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Slingshot {
    /// The rubber between its posts.
    pub segment: Segment,
    /// The rubber's radius, m.
    pub radius_m: f64,
    /// The rubber.
    pub material: Material,
    /// Speed that it adds at its middle, m/s, falling as 1 - x^2 to its ends.
    pub kick_m_s: f64,
    /// Slowest approach that closes its switch, m/s.
    pub threshold_m_s: f64,
}

/// A coil that throws the ball off a surface.
#[derive(Clone, Debug)]
pub(crate) struct KickerModel {
    pub part: PartId,
    /// Speed that it adds, m/s.
    kick: f64,
    /// Slowest approach that closes its switch, m/s.
    threshold: f64,
    /// A slingshot's rubber; a bumper kicks alike all round.
    rubber: Option<Segment>,
}

impl Bumper {
    pub(crate) fn check(&self) -> Checked {
        validation::circle(&self.circle)?;
        check_kick(self.kick_m_s, self.threshold_m_s)?;
        validation::material(&self.material)
    }

    pub(crate) fn add_to(&self, part: PartId, model: &mut Model) {
        let shape = Shape::disc(self.circle.center, self.circle.radius);
        let kicker = KickerModel { part, kick: self.kick_m_s, threshold: self.threshold_m_s, rubber: None };
        kicker.add_to(shape, self.material, model);
    }
}

impl Slingshot {
    pub(crate) fn check(&self) -> Checked {
        validation::segment(&self.segment)?;
        validation::not_negative("the rubber's radius", self.radius_m)?;
        check_kick(self.kick_m_s, self.threshold_m_s)?;
        validation::material(&self.material)
    }

    pub(crate) fn add_to(&self, part: PartId, model: &mut Model) {
        let shape = Shape::capsule(self.segment.a, self.segment.b, self.radius_m);
        let rubber = Some(self.segment);
        let kicker = KickerModel { part, kick: self.kick_m_s, threshold: self.threshold_m_s, rubber };
        kicker.add_to(shape, self.material, model);
    }
}

fn check_kick(kick_m_s: f64, threshold_m_s: f64) -> Checked {
    validation::not_negative("the kick", kick_m_s)?;
    validation::not_negative("the threshold", threshold_m_s)
}

impl KickerModel {
    fn add_to(self, shape: Shape, material: Material, model: &mut Model) {
        let role = ObstacleRole::Kicker(model.mechanisms.kickers.len());
        model.collision.add_obstacle(self.part, shape, material, role);
        model.mechanisms.kickers.push(self);
    }

    /// Speed that it adds to a ball at `center`: a slingshot's falls as `1 - x^2` to its ends.
    pub fn speed_at(&self, center: DVec2) -> f64 {
        let offset = self.rubber.map_or(0.0, |rubber| 2.0 * rubber.parameter(center) - 1.0);
        self.kick * (1.0 - offset * offset)
    }

    /// A ball has hit it at `approach`, m/s. True if it fires: if it is live and ready.
    pub fn hit(&self, ticks: &mut u16, live: bool, approach: f64) -> bool {
        let ready = live && *ticks >= READY_TICKS;
        let fires = ready && approach >= self.threshold;
        if fires {
            *ticks = 0;
        }
        fires
    }
}

/// The ticks since each kicker fired, at first.
pub(crate) fn ready(kickers: &[KickerModel]) -> Vec<u16> {
    vec![READY_TICKS; kickers.len()]
}

/// One tick nearer to being ready again.
pub(crate) fn tick(kicker_ticks: &mut [u16]) {
    for ticks in kicker_ticks {
        *ticks = (*ticks + 1).min(READY_TICKS);
    }
}

/// Fires every kicker, whatever its switch says: what lies at it is thrown off.
pub(crate) fn fire_all(model: &Model, state: &mut State) {
    for obstacle in &model.collision.obstacles {
        let ObstacleRole::Kicker(index) = obstacle.role else { continue };
        state.mechanisms.kicker_ticks[index] = 0;
        for ball in state.balls.iter_mut().filter(|ball| !ball.is_held()) {
            throw_off(&model.mechanisms.kickers[index], obstacle, ball);
        }
    }
}

fn throw_off(kicker: &KickerModel, obstacle: &Obstacle, ball: &mut Ball) {
    let (distance, normal) = obstacle.shape.distance(ball.center);
    if distance < KICK_REACH_M {
        ball.velocity += normal * kicker.speed_at(ball.center);
    }
}

/// How far a kicker is out, `ticks` after it fired, 0 to 1.
pub(crate) fn extension(ticks: u16) -> f64 {
    let ticks = f64::from(ticks);
    if ticks < OUT_TICKS { ticks / OUT_TICKS } else { (1.0 - (ticks - OUT_TICKS) / BACK_TICKS).max(0.0) }
}
