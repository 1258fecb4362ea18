//! Captive balls that lie on each other: what a tick takes for them is counted before anybody plays, and none is drawn in
//! another.
//!
//! Each ball of a heap presses on the others, so the impulses go round and round between them: a hundred balls take more
//! than a hundred times as long as one. The count is the same on every machine.

use geometry::DVec2;
use physics::{BALL_RADIUS_M, Controls, Kind, Layout, Machine};
use std::sync::Arc;

/// Fewer captive balls never take too long.
const MIN_BALLS: usize = 8;
/// Contact solves that a tick may take.
const MAX_CONTACT_SOLVES: u64 = 20_000;
/// How long the balls are watched: until they lie as they come to lie, and were shaken twice, ticks.
const BLOCKS: u64 = 5;
const BLOCK_TICKS: u64 = 100;

/// So deep a ball may be drawn in another: drawings round, m.
const DRAWN_M: f64 = 2e-4;

/// Refuses captive balls that lie in each other, or take too long.
///
/// # Errors
/// Which part is the first of them, and what is wrong.
pub(super) fn check(layout: &Layout) -> Result<(), (usize, String)> {
    let center = |kind: &Kind| match kind {
        Kind::CaptiveBall(captive) => Some(captive.center),
        _ => None,
    };
    let parts = layout.parts.iter().enumerate();
    let captives: Vec<(usize, DVec2)> = parts.filter_map(|(index, part)| Some((index, center(&part.kind)?))).collect();
    apart(layout, &captives)?;
    let &[(first, _), ..] = captives.as_slice() else { return Ok(()) };
    if captives.len() < MIN_BALLS {
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
                return Err((first, refusal(captives.len(), solves / (tick + 1))));
            }
        }
    }
    Ok(())
}

/// Refuses a ball that is drawn in another: there is no way out of it for either.
fn apart(layout: &Layout, captives: &[(usize, DVec2)]) -> Result<(), (usize, String)> {
    // From left to right only the next ones can be so near.
    let mut captives = captives.to_vec();
    captives.sort_by(|one, other| one.1.x.total_cmp(&other.1.x));
    for (place, &(part, center)) in captives.iter().enumerate() {
        let beside = captives[place + 1..].iter().take_while(|(_, other)| other.x - center.x < 2.0 * BALL_RADIUS_M);
        let within = |other: DVec2| 2.0 * BALL_RADIUS_M - other.distance(center);
        if let Some(&(other, at)) = beside.into_iter().find(|(_, other)| within(*other) > DRAWN_M) {
            let (depth_mm, name) = (within(at) * 1000.0, &layout.parts[other].name);
            return Err((part, format!("it lies {depth_mm:.1} mm deep in the captive ball {name}; draw them apart")));
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
