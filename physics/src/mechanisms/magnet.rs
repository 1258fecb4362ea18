//! Magnet: an electromagnet below the playfield: what it does to a ball, and when it holds a ball.
//!
//! The pull along the playfield is the gradient of the potential `-(1 - (r/R)^2)^3`, the smooth kernel of compact
//! support of Muller et al., Particle-Based Fluid Simulation for Interactive Applications (2003): nothing in the
//! middle, most at 0.45 R, nothing at the reach R and beyond, and no edge between. It has the shape of a small coil's
//! pull on soft steel, `r / (r^2 + h^2)^4`, which is a gradient too but never ends.
//!
//! So the magnet itself gives a ball nothing and takes nothing: what flies through leaves as fast as it came. What slows
//! a ball is friction. The magnet presses it on the playfield, and steel that turns in a field resists the turning: its
//! magnetisation lags behind (rotational hysteresis; Chikazumi, Physics of Ferromagnetism, 1997), a torque that does not
//! depend on speed, like that of rolling. A slow ball comes to rest by it, near the middle; a fast one is bent and goes on.

use crate::ball::Ball;
use crate::ball::ball_step::BallStep;
use crate::mechanisms::MechanismStates;
use crate::mechanisms::model::Model;
use crate::part::event::{Event, EventKind};
use crate::part::validation::{self, Checked};
use crate::part::{Numbered, PartId, index_of};
use geometry::{Circle, DVec2};
use serde::{Deserialize, Serialize};

/// A magnet that pulls harder than this would swing a ball faster than a tick can follow, m/s^2.
const MAX_PULL_M_S2: f64 = 500.0;
/// One over the most that `x (1 - x^2)^2` comes to, at `x = 1 / sqrt(5)`.
const INVERSE_PEAK: f64 = 3.493_856_214_843_422;
/// What presses a ball on the playfield over the middle, over the most that pulls it along: the near pole is below it.
const NORMAL_LOAD_RATIO: f64 = 2.0;
/// Deceleration of a ball that rolls in the field, over what presses it.
const HYSTERESIS: f64 = 0.08;
/// A ball lies in the middle when it is no farther from it than this part of the reach...
const HOLDING_RADIUS: f64 = 0.15;
/// ... and no faster than this, m/s; it has left when it is twice as far.
const HOLDING_M_S: f64 = 0.05;

/// An electromagnet below the playfield that pulls balls to its middle while the rules have it switched on.
/// Its switch is closed while it holds a ball in its middle.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Magnet {
    /// Its middle, and how far it reaches.
    pub circle: Circle,
    /// The most that it pulls along the playfield, m/s^2: at 0.45 of its reach. A real one holds a ball against ten
    /// times the slope and more.
    pub pull_m_s2: f64,
}

impl Magnet {
    pub(crate) fn check(&self) -> Checked {
        validation::circle(&self.circle)?;
        validation::not_negative("the pull", self.pull_m_s2)?;
        validation::at_most("the pull", self.pull_m_s2, MAX_PULL_M_S2)
    }

    pub(crate) fn add_to(&self, part: PartId, model: &mut Model) {
        model.mechanisms.magnets.push(Numbered { part, numbers: self.clone() });
    }
}

/// Magnet state.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct MagnetState {
    /// The rules have switched it on.
    pub on: bool,
    /// A ball lies in its middle: its switch is closed.
    pub holds: bool,
}

/// Where a ball is in a magnet's field: from the ball to the middle, over the reach; `None` out of reach.
fn within(magnet: &Magnet, center: DVec2) -> Option<DVec2> {
    let inwards = (magnet.circle.center - center) / magnet.circle.radius;
    (inwards.length_squared() < 1.0).then_some(inwards)
}

/// What a magnet pulls a ball with, m/s^2: along the playfield, and down.
fn pull(magnet: &Magnet, center: DVec2) -> (DVec2, f64) {
    let Some(inwards) = within(magnet, center) else { return (DVec2::ZERO, 0.0) };
    let fade = 1.0 - inwards.length_squared();
    let strength = magnet.pull_m_s2 * fade * fade;
    (inwards * (INVERSE_PEAK * strength), NORMAL_LOAD_RATIO * strength)
}

/// Lets the magnets that are on apply on a ball in a step of `duration`.
///
/// The pull is that half-way through the step. Over a step this is the symplectic midpoint rule, so a ball that swings
/// through the middle gains nothing from the size of the step.
pub(crate) fn apply(model: &Model, states: &MechanismStates, ball: &Ball, duration: f64, ball_step: &mut BallStep) {
    let half_way = ball.center + ball.velocity * (0.5 * duration);
    for (coil, Numbered { numbers: magnet, .. }) in states.magnets.iter().zip(&model.mechanisms.magnets) {
        if coil.on && states.coils_enabled && !ball.is_up() {
            let (along, down) = pull(magnet, half_way);
            ball_step.external += along;
            ball_step.floor.normal_load += down;
            ball_step.floor.drag += HYSTERESIS * down;
        }
    }
}

/// Whether a magnet holds this ball.
pub(crate) fn holds(model: &Model, states: &MechanismStates, ball: &Ball) -> bool {
    let mut coils = states.magnets.iter().zip(&model.mechanisms.magnets);
    coils.any(|(coil, own)| coil.holds && lies(&own.numbers, ball, 2.0 * HOLDING_RADIUS))
}

fn lies(magnet: &Magnet, ball: &Ball, middle: f64) -> bool {
    !ball.is_held() && within(magnet, ball.center).is_some_and(|inwards| inwards.length() <= middle)
}

/// Closes the switches of magnets that have come to hold a ball, and opens those of magnets that it has left.
pub(crate) fn emit_switch_events(model: &Model, balls: &[Ball], states: &mut MechanismStates, events: &mut Vec<Event>) {
    let live = states.coils_enabled;
    for (coil, Numbered { part, numbers: magnet }) in states.magnets.iter_mut().zip(&model.mechanisms.magnets) {
        let rests = |ball: &Ball| lies(magnet, ball, HOLDING_RADIUS) && ball.velocity.length() < HOLDING_M_S;
        let holds = match coil.holds {
            true => balls.iter().any(|ball| lies(magnet, ball, 2.0 * HOLDING_RADIUS)),
            false => coil.on && live && balls.iter().any(rests),
        };
        if holds != coil.holds {
            let kind = if holds { EventKind::Closed } else { EventKind::Opened };
            events.push(Event { part: Some(*part), kind });
        }
        coil.holds = holds;
    }
}

/// The rules switch a magnet on or off.
pub(crate) fn switch(model: &Model, states: &mut MechanismStates, part: PartId, on: bool) {
    if let Some(magnet) = index_of(part, &model.mechanisms.magnets) {
        states.magnets[magnet].on = on;
    }
}

/// Switches every magnet off.
pub(crate) fn switch_all_off(states: &mut MechanismStates) {
    states.magnets.iter_mut().for_each(|coil| coil.on = false);
}

/// Whether each magnet pulls.
pub(crate) fn pose(model: &Model, states: &MechanismStates) -> Vec<(PartId, bool)> {
    let magnets = model.mechanisms.magnets.iter().zip(&states.magnets);
    magnets.map(|(own, coil)| (own.part, coil.on && states.coils_enabled)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::TICK_S;

    const MAGNET: Magnet = Magnet { circle: Circle { center: DVec2::new(0.25, 0.5), radius: 0.045 }, pull_m_s2: 40.0 };

    fn potential(center: DVec2) -> f64 {
        let fade = within(&MAGNET, center).map_or(0.0, |inwards| 1.0 - inwards.length_squared());
        -INVERSE_PEAK * MAGNET.pull_m_s2 * MAGNET.circle.radius / 6.0 * fade * fade * fade
    }

    #[test]
    fn the_pull_is_the_slope_of_its_potential_and_is_most_where_it_says() {
        let step = 1e-7;
        let mut most: f64 = 0.0;
        for mm in 0..60 {
            let place = MAGNET.circle.center + DVec2::new(0.6, 0.8) * (f64::from(mm) * 1e-3);
            let slope = |way: DVec2| (potential(place - way * step) - potential(place + way * step)) / (2.0 * step);
            let (along, _) = pull(&MAGNET, place);
            assert!((along - DVec2::new(slope(DVec2::X), slope(DVec2::Y))).length() < 1e-4, "{mm} mm: {along}");
            most = most.max(along.length());
        }
        assert!((most / MAGNET.pull_m_s2 - 1.0).abs() < 1e-3, "{most}");
        let (middle, edge) = (pull(&MAGNET, MAGNET.circle.center), pull(&MAGNET, DVec2::new(0.2951, 0.5)));
        assert!(middle.0 == DVec2::ZERO && middle.1 == 80.0 && edge == (DVec2::ZERO, 0.0));
    }

    #[test]
    fn half_way_is_where_a_step_keeps_the_energy() {
        let (mut center, mut velocity) = (MAGNET.circle.center + DVec2::new(0.02, 0.0), DVec2::new(0.0, 0.3));
        let energy = |center: DVec2, velocity: DVec2| 0.5 * velocity.length_squared() + potential(center);
        let first = energy(center, velocity);
        let mut farthest: f64 = 0.0;
        for _ in 0..60_000 {
            let (along, _) = pull(&MAGNET, center + velocity * (0.5 * TICK_S));
            center += (velocity + along * (0.5 * TICK_S)) * TICK_S;
            velocity += along * TICK_S;
            farthest = farthest.max((energy(center, velocity) / first - 1.0).abs());
        }
        assert!(farthest < 0.01, "a minute changes the energy by {farthest} of itself");
    }
}
