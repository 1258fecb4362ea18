//! Triggers: what happens where a ball's centre is, as on rollovers, in drains and in saucers.

use crate::collision::trigger::{Trigger, TriggerKind};
use crate::mechanisms::model::{Model, State};
use crate::mechanisms::{rollover, saucer};
use crate::part::event::Event;
use geometry::DVec2;

/// What the balls' centres have come to in a tick.
#[derive(Default)]
struct Reached {
    /// The rollovers that balls are on, once for each ball.
    rollovers: Vec<usize>,
    /// The balls that are in a drain.
    drained: Vec<usize>,
}

/// Closes and opens the switches that the balls have come to since they were at `starts`.
pub(crate) fn tick(model: &Model, state: &mut State, starts: &[DVec2], events: &mut Vec<Event>) {
    let mut reached = Reached::default();
    for (ball, &start) in starts.iter().enumerate() {
        for trigger in triggers_near(model, state, ball, start) {
            reach(model, state, &model.collision.triggers[trigger], (ball, start), &mut reached, events);
        }
        saucer::settle(&model.mechanisms.saucers, &mut state.balls[ball], events);
    }
    rollover::emit_switch_events(
        &model.mechanisms.rollovers,
        &reached.rollovers,
        &mut state.mechanisms.rollovers,
        events,
    );
    for &ball in reached.drained.iter().rev() {
        state.balls.remove(ball);
    }
}

/// The triggers that may be near the path of a ball on the playfield, in their order.
fn triggers_near(model: &Model, state: &State, ball: usize, start: DVec2) -> Vec<usize> {
    let mut near: Vec<usize> = Vec::new();
    let up = state.balls[ball].is_up();
    model.collision.visit_triggers(start, state.balls[ball].center, |trigger| {
        if !up && !near.contains(&trigger) {
            near.push(trigger);
        }
    });
    near.sort_unstable();
    near
}

/// What a trigger does to a ball, which was at `start`.
fn reach(
    model: &Model,
    state: &mut State,
    trigger: &Trigger,
    (ball, start): (usize, DVec2),
    reached: &mut Reached,
    events: &mut Vec<Event>,
) {
    let center = state.balls[ball].center;
    let in_play = state.balls[ball].captive().is_none();
    let within = trigger.contains(center);
    let crossed = || trigger.is_crossed(start, center);
    match trigger.kind {
        TriggerKind::Rollover(rollover) if within => reached.rollovers.push(rollover),
        TriggerKind::Rollover(rollover) if state.mechanisms.rollovers[rollover] == 0 && crossed() => {
            events.push(Event::closed(trigger.part));
            events.push(Event::opened(trigger.part));
        }
        TriggerKind::Drain if in_play && (within || crossed()) && !reached.drained.contains(&ball) => {
            events.push(Event::closed(trigger.part));
            reached.drained.push(ball);
        }
        TriggerKind::Gate(gate) if model.mechanisms.gates[gate].numbers.is_passed(start, center) => {
            events.push(Event::closed(trigger.part));
        }
        TriggerKind::Saucer(saucer) if within => saucer::capture(model, state, saucer, ball),
        _ => {}
    }
}
