//! Numbers: `table.toml` gives a table that can be played, or sentences.

use super::sample::{self, SVG};
use pinball::{Buttons, Simulation};
use std::sync::Arc;

/// Reads `bytes` as the numbers of a table that has everything, and plays a moment with them.
pub fn run(bytes: &[u8]) {
    match sample::table(SVG.as_bytes(), bytes, b"") {
        Err(failures) => sample::assert_told(&failures),
        Ok(table) => match Simulation::new(Arc::new(table), 1) {
            Err(failure) => sample::assert_told(&[failure]),
            Ok(mut simulation) => {
                (0..20).for_each(|tick| simulation.tick(Buttons(tick % 3)));
                assert!(simulation.pose().cabinet_m.is_finite());
            }
        },
    }
}
