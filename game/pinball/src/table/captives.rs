//! Captive balls that lie on each other: what a tick takes for them is counted before anybody plays.
//!
//! Each ball of a heap presses on the others, so the impulses go round and round between them: a hundred balls take more
//! than a hundred times as long as one. The count is the same on every machine.

use physics::{Controls, Kind, Layout, Machine};
use std::sync::Arc;

/// Fewer captive balls never take too long.
const MIN_BALLS: usize = 8;
/// Contact solves that a tick may take.
const MAX_CONTACT_SOLVES: u64 = 20_000;
/// How long the balls are watched: until they lie as they come to lie, and were shaken twice, ticks.
const BLOCKS: u64 = 5;
const BLOCK_TICKS: u64 = 100;

/// Refuses captive balls that take too long.
///
/// # Errors
/// How much they take, and which part is the first of them.
pub(super) fn check(layout: &Layout) -> Result<(), (usize, String)> {
    let is_captive = |kind: &Kind| matches!(kind, Kind::CaptiveBall(_));
    let mut captives = layout.parts.iter().enumerate().filter(|(_, part)| is_captive(&part.kind));
    let (Some((first, _)), others) = (captives.next(), captives.count()) else { return Ok(()) };
    if others + 1 < MIN_BALLS {
        return Ok(());
    }
    // What else is wrong with a layout is told by whoever plays it.
    let Ok(mut machine) = Machine::new(Arc::new(layout.clone())) else { return Ok(()) };
    for block in 0..BLOCKS {
        let mut solves = 0;
        for tick in 0..BLOCK_TICKS {
            let nudge = block % 2 == 1 && tick < 10;
            machine.tick(Controls { nudge_left: nudge, ..Controls::NONE }, &[]);
            solves += machine.contact_solves();
            if solves > BLOCK_TICKS * MAX_CONTACT_SOLVES {
                return Err((first, refusal(others + 1, solves / (tick + 1))));
            }
        }
    }
    Ok(())
}

fn refusal(balls: usize, solves: u64) -> String {
    format!(
        "its {balls} captive balls lie on each other and take {solves} contact solves in a tick, and {MAX_CONTACT_SOLVES} \
         is the most; draw fewer of them, or walls between them"
    )
}
