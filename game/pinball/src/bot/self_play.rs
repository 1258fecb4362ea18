//! Self-play: whole games, played without a screen, with everything that is worth knowing about them.

use super::anomaly::Anomaly;
use super::game_result::GameResult;
use super::message_log::ShownMessage;
use super::run_statistics::RunStatistics;
use super::{Bot, CoveragePlayer, RandomPlayer};
use crate::recording::Recorder;
use crate::simulation::Digest;
use crate::{Buttons, Failure, Simulation, Table};
use std::io::{self, Cursor};
use std::sync::Arc;

/// From a game's end to the press of start that begins the next, where games follow each other at once, ticks: the
/// display has shown the end by then.
const PAUSE_TICKS: u64 = 500;
/// How long start is pressed for that, ticks. If the rules do not begin a game then it is pressed again after a pause.
const PRESS_TICKS: u64 = 100;

/// Who plays.
#[derive(Clone, Debug)]
pub enum Player {
    /// Traps, aims and shoots.
    Bot(Bot),
    /// Flips at random.
    Random(RandomPlayer),
    /// Uses every button.
    Coverage(CoveragePlayer),
}

impl Player {
    /// What the player presses in the next tick.
    pub fn buttons(&mut self, simulation: &Simulation) -> Buttons {
        match self {
            Player::Bot(bot) => bot.buttons(simulation),
            Player::Random(random) => random.buttons(simulation),
            Player::Coverage(coverage) => coverage.buttons(simulation),
        }
    }
}

/// How much is played, and what is made of it.
#[derive(Clone, Copy, Debug)]
pub struct SelfPlayOptions {
    /// Ticks that may be played.
    pub longest: u64,
    /// When a game is over the next begins at once, until `longest` ticks are played exactly.
    pub again: bool,
    /// Hashes every tick.
    pub digest: bool,
}

impl SelfPlayOptions {
    /// One game of at most `longest` ticks.
    pub fn one_game(longest: u64) -> SelfPlayOptions {
        SelfPlayOptions { longest, again: false, digest: false }
    }
}

/// What came of a game, or of several that followed each other on the same machine.
pub struct SelfPlayRun {
    /// The machine's seed.
    pub seed: u64,
    /// Ticks that were played.
    pub ticks: u64,
    /// The games, in their order: one, unless the options say that another follows.
    pub games: Vec<GameResult>,
    /// How long each ball was in play, ticks.
    pub balls: Vec<u64>,
    /// How often each part's switch closed, by the part's index.
    pub hits: Vec<u64>,
    /// What went wrong.
    pub anomalies: Vec<Anomaly>,
    /// The messages that were shown for a time.
    pub messages: Vec<ShownMessage>,
    /// What the rules complained about.
    pub complaints: Vec<String>,
    /// How often a game was begun while a ball of another was in play.
    pub restarts: u32,
    /// Of every tick, if the options ask for it.
    pub digest: Option<Digest>,
    /// The recording, finished.
    pub recording: Vec<u8>,
}

impl SelfPlayRun {
    /// The best score of the best game.
    pub fn score(&self) -> i64 {
        self.games.iter().map(|game| game.score).max().unwrap_or(0)
    }
}

/// Plays with these options.
///
/// # Errors
/// If the table's rules do not run.
pub fn play(
    table: &Arc<Table>,
    seed: u64,
    mut player: Player,
    options: SelfPlayOptions,
) -> Result<SelfPlayRun, Failure> {
    let mut simulation = Simulation::new(table.clone(), seed)?;
    let mut recorder = Recorder::new(Cursor::new(Vec::new()), &simulation, seed).map_err(unrecorded)?;
    let mut statistics = RunStatistics::new(table);
    let mut digest = options.digest.then(Digest::default);
    while simulation.ticks() < options.longest && (options.again || !statistics.finished(simulation.ticks())) {
        let again = options.again && statistics.over_at().is_some_and(|over| presses_start(simulation.ticks() - over));
        let buttons = player.buttons(&simulation);
        let buttons = buttons.with(Buttons::START, buttons.contains(Buttons::START) || again);
        simulation.tick(buttons);
        recorder.record(&simulation, buttons).map_err(unrecorded)?;
        statistics.look(&simulation, buttons);
        if let Some(digest) = &mut digest {
            digest.add(simulation.hash());
        }
    }
    let seen = statistics.finish(&simulation);
    Ok(SelfPlayRun {
        seed,
        ticks: simulation.ticks(),
        games: seen.games,
        balls: seen.balls,
        hits: seen.hits,
        anomalies: seen.anomalies,
        messages: seen.messages,
        complaints: simulation.complaints(),
        restarts: simulation.rules_state().restarts,
        digest,
        recording: recorder.finish(&simulation).map_err(unrecorded)?.into_inner(),
    })
}

/// A recording in memory takes whatever is written, but the type of a writer cannot say so.
fn unrecorded(error: io::Error) -> Failure {
    Failure::new(format!("the game cannot be recorded: {error}"))
}

/// Whether start is down this many ticks after a game's end, to begin the next.
fn presses_start(since_over: u64) -> bool {
    since_over % (PAUSE_TICKS + PRESS_TICKS) >= PAUSE_TICKS
}
