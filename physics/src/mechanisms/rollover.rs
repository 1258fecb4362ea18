//! Rollover: a switch below the playfield that is closed while a ball is over it.

use crate::collision::trigger::TriggerKind;
use crate::mechanisms::model::Model;
use crate::part::PartId;
use crate::part::event::Event;
use crate::part::validation::{self, Checked};
use geometry::Shape;
use serde::{Deserialize, Serialize};

/// A switch under the ball.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Rollover {
    /// The switch is closed while a ball's centre is in this shape.
    pub shape: Shape,
}

impl Rollover {
    pub(crate) fn check(&self) -> Checked {
        validation::shape(&self.shape)
    }

    pub(crate) fn add_to(&self, part: PartId, model: &mut Model) {
        let rollovers = &mut model.mechanisms.rollovers;
        model.collision.add_trigger(part, self.shape, TriggerKind::Rollover(rollovers.len()));
        rollovers.push(part);
    }
}

/// Closes the switches of rollovers that balls have come to, and opens those that they have left. `covered` has the
/// rollover below each ball that is on one; `counts` has how many balls were on each.
pub(crate) fn emit_switch_events(parts: &[PartId], covered: &[usize], counts: &mut [u16], events: &mut Vec<Event>) {
    for (rollover, count) in counts.iter_mut().enumerate() {
        let now = covered.iter().filter(|&&on| on == rollover).count() as u16;
        let before = std::mem::replace(count, now);
        match (before > 0, now > 0) {
            (false, true) => events.push(Event::closed(parts[rollover])),
            (true, false) => events.push(Event::opened(parts[rollover])),
            _ => {}
        }
    }
}
