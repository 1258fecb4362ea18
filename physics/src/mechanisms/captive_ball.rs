//! Captive balls: steel balls like any other, which the walls round them keep in their places, and which are not in play.
//!
//! The sweep moves them as it moves every ball. Refuses to know how.

use crate::ball::{Ball, Hold};
use crate::collision::world::Plan;
use crate::layout::{CaptiveBall, PartId};
use crate::part::event::{Event, EventKind};

/// The captive balls of a machine, lying where they are drawn. They have the largest numbers, so that a ball in play is
/// never taken for one.
pub(crate) fn balls(plan: &Plan) -> impl Iterator<Item = Ball> {
    let numbered = plan.captives.iter().enumerate();
    numbered.map(|(index, (_, CaptiveBall { center, .. }))| Ball {
        hold: Hold::Captive(index),
        ..Ball::new(u32::MAX - index as u32, *center)
    })
}

/// Two balls have met at this speed: where one of them is captive and the other is in play, its switch closes.
pub(crate) fn meet(plan: &Plan, pair: [&Ball; 2], approach: f64, events: &mut Vec<Event>) {
    for (ball, other) in [(pair[0], pair[1]), (pair[1], pair[0])] {
        let Some(index) = ball.captive() else { continue };
        let (part, numbers) = &plan.captives[index];
        if other.captive().is_none() && approach >= numbers.threshold_m_s && approach > 0.0 {
            events.push(Event { part: Some(PartId(*part)), kind: EventKind::Closed });
        }
    }
}
