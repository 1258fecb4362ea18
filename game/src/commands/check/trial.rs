//! The playtest of `caustic check`, on every core.

use super::super::parallel::progress_bar;
use crate::{Failure, Table};
use pinball::playtest::{BotRun, Finding, Playtest};
use rayon::prelude::*;
use std::sync::Arc;

/// Balls that are let go, each at a place of its own.
const PLACES: usize = 500;

/// What play has shown of a table.
pub struct Trial {
    /// What went wrong, and what is odd.
    pub findings: Vec<Failure>,
    /// Balls that were let go.
    pub places: usize,
    /// The bot's score.
    pub bot_score: i64,
}

/// Plays the table.
///
/// # Errors
/// If it cannot be played at all.
pub fn play(table: &Arc<Table>) -> Result<Trial, Failure> {
    let playtest = Playtest::new(table)?;
    let places = playtest.places(PLACES);
    let bar = progress_bar(places.len() as u64, "balls");
    let let_go = || -> Vec<Finding> {
        let one = |place| {
            let finding = playtest.let_go(place);
            bar.inc(1);
            finding
        };
        places.par_iter().copied().filter_map(one).collect()
    };
    let (run, found) = rayon::join(|| playtest.bot_run(), let_go);
    bar.finish_and_clear();
    let BotRun { findings, score, complaints } = run?;
    let all =
        [playtest.launch().to_vec(), found, playtest.coils(), playtest.open_edges(), playtest.unreachable(), findings];
    let findings = playtest.merged(all.concat()).into_iter().map(|finding| finding.failure(table));
    let findings = complaints.into_iter().map(Failure::new).chain(findings).collect();
    Ok(Trial { findings, places: places.len(), bot_score: score })
}
