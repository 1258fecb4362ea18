//! A script: whatever it says, the game goes on at its pace, and what is wrong is told.

use super::sample::{self, SVG};
use pinball::{Buttons, Simulation};
use std::sync::Arc;

/// Ticks that are played with each script.
const TICKS: u64 = 60;

/// Reads `bytes` as rules, and plays with them.
pub fn run(bytes: &[u8]) {
    let table = match sample::table(SVG.as_bytes(), b"", bytes) {
        Err(failures) => return sample::assert_told(&failures),
        Ok(table) => table,
    };
    let mut simulation = match Simulation::new(Arc::new(table), 1) {
        Err(failure) => return sample::assert_told(&[failure]),
        Ok(simulation) => simulation,
    };
    for tick in 0..TICKS {
        simulation.tick(if tick % 20 < 10 { Buttons::START | Buttons::LEFT } else { Buttons::PLUNGER });
    }
    let saved = simulation.save();
    let restored = simulation.restored(&saved).expect("what was saved can be restored");
    assert_eq!(restored.hash(), simulation.hash(), "a restored game is the same");
    assert!(simulation.complaints().len() < 1000);
}
