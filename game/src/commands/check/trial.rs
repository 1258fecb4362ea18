//! The playtest of `caustic check`, on every core.

use super::super::parallel::progress_bar;
use crate::{Failure, Table};
use pinball::bot::message_log::ShownMessage;
use pinball::playtest::{BotRun, Finding, FindingKind, Playtest};
use rayon::prelude::*;
use std::sync::Arc;

/// Balls that are let go, each at a place of its own.
const PLACES: usize = 500;

/// Findings that are told.
const MAX_REPORTED: usize = 100;

/// What play has shown of a table.
pub struct Trial {
    /// What went wrong, and what is odd.
    pub findings: Vec<Failure>,
    /// Balls that were let go.
    pub places: usize,
    /// The bot's score.
    pub bot_score: i64,
    /// The messages that were shown to it.
    pub messages: Vec<ShownMessage>,
}

/// Plays the table.
///
/// # Errors
/// If it cannot be played at all.
pub fn play(table: &Arc<Table>) -> Result<Trial, Failure> {
    let playtest = Playtest::new(table)?;
    let coils = playtest.coils();
    // Where captive balls roll about, all else is a consequence, and takes long.
    let is_sound = coils.iter().all(|finding| finding.kind != FindingKind::ComesOut);
    let places = if is_sound { playtest.places(PLACES) } else { Vec::new() };
    let bar = progress_bar(places.len() as u64, "balls");
    let let_go = || -> Vec<Finding> {
        let one = |place| {
            let finding = playtest.let_go(place);
            bar.inc(1);
            finding
        };
        places.par_iter().copied().filter_map(one).collect()
    };
    // Of a table whose plunger fails, what a game shows is a consequence too.
    let plays = is_sound && playtest.launch().is_empty();
    let bot = || plays.then(|| playtest.bot_run()).transpose();
    let first_game = || if plays { playtest.first_game() } else { Ok(Default::default()) };
    let (run, (rules, found)) = rayon::join(bot, || rayon::join(first_game, let_go));
    bar.finish_and_clear();
    let run = run?.unwrap_or_default();
    let BotRun { findings: played, score, messages, complaints } = run;
    let (mut rules, more) = rules?;
    // What rules leave undone that end in a mistake is a consequence of that.
    rules.retain(|finding| more.is_empty() || !finding.kind.follows_mistakes());
    let all = [found, coils, playtest.open_edges(), playtest.unreachable(), played, rules].concat();
    let findings = [playtest.launch().to_vec(), playtest.merged(all)].concat().into_iter();
    // What both games complained about is told once.
    let complaints = complaints.iter().chain(more.iter().filter(|one| !complaints.contains(one)));
    let findings = complaints.map(Failure::new).chain(findings.map(|finding| finding.failure(table)));
    let findings = first_of(findings.collect());
    Ok(Trial { findings, places: places.len(), bot_score: score, messages })
}

/// As many as are worth reading at once.
fn first_of(mut findings: Vec<Failure>) -> Vec<Failure> {
    let rest = findings.split_off(findings.len().min(MAX_REPORTED));
    let errors = rest.iter().filter(|failure| !failure.is_warning()).count();
    if !rest.is_empty() {
        let more = format!("and {} more", super::report::counts(errors, rest.len() - errors));
        findings.push(if errors > 0 { Failure::new(more) } else { Failure::warning(more) });
    }
    findings
}
