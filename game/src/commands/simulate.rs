//! `caustic simulate`: many games without a screen, and a summary of what happened in them.

use super::parallel::{self, digest_line, pool, progress_bar};
use super::print::{print, print_lines};
use crate::bot::anomaly::AnomalyKind;
use crate::bot::self_play::{self, SelfPlayOptions, SelfPlayRun};
use crate::bot::{Bot, CoveragePlayer, GameResult, RandomPlayer};
use crate::cli::{Player, SimulateArgs};
use crate::storage::{file_failure, new_file, tables};
use crate::{Failure, Table, recording};
use physics::{Kind, TICKS_PER_SECOND};
use rayon::prelude::*;
use std::collections::BTreeSet;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, Instant};

/// Plays the games and prints the summary.
///
/// # Errors
/// If the table cannot be read, a recording cannot be written, or anything went wrong in a game, also in its rules.
#[expect(clippy::disallowed_methods, reason = "measures the speed; the games do not read it")]
pub fn run(args: &SimulateArgs) -> Result<(), Failure> {
    let table = Arc::new(tables::load(&args.table).map_err(Failure::of_many)?);
    for dir in args.save_all.iter().chain(&args.save_failures) {
        parallel::make_folder(dir)?;
        if !args.overwrite {
            refuse_older(dir, args)?;
        }
    }
    let bar = progress_bar(u64::from(args.games), "games");
    let longest = (args.minutes * 60.0 * f64::from(TICKS_PER_SECOND)).round() as u64;
    let options = SelfPlayOptions { longest, again: args.again, digest: args.digest };
    let seeds: Vec<u64> = (0..u64::from(args.games)).map(|number| args.seed.wrapping_add(number)).collect();
    let games = pool(args.threads)?.install(|| {
        let one = |seed: &u64| {
            let began = Instant::now();
            let run = self_play::play(&table, *seed, player(args.player, *seed), options)?;
            let core_time = began.elapsed();
            bar.inc(1);
            Game::keep(run, core_time, args)
        };
        seeds.par_iter().map(one).collect::<Result<Vec<Game>, Failure>>()
    })?;
    bar.finish_and_clear();
    print_lines(summary(&table, &games))?;
    if args.digest {
        let digest = |game: &Game| game.run.digest.map(|digest| (game.run.seed, digest));
        print(&digest_line(&games.iter().filter_map(digest).collect::<Vec<_>>()))?;
    }
    let anomalies = games.iter().map(|game| game.run.anomalies.len()).sum::<usize>();
    match anomalies + complaints(&games).len() {
        0 => Ok(()),
        1 => Err(Failure::new("one thing went wrong; --save-failures DIR keeps its game")),
        many => Err(Failure::new(format!("{many} things went wrong; --save-failures DIR keeps their games"))),
    }
}

/// Refuses to write over a recording that lies in `dir`, before any game is played.
fn refuse_older(dir: &Path, args: &SimulateArgs) -> Result<(), Failure> {
    let older = |seed: u64| Some(recording_path(dir, seed)).filter(|path| path.exists());
    let seeds = (0..u64::from(args.games)).map(|number| args.seed.wrapping_add(number));
    let Some(path) = seeds.into_iter().find_map(older) else { return Ok(()) };
    let path = path.display();
    Err(Failure::new(format!("{path} is there already: name another folder, or write over it with --overwrite")))
}

fn recording_path(dir: &Path, seed: u64) -> PathBuf {
    dir.join(format!("game-{seed}.caustic"))
}

/// What the rules complained about, each sentence once.
fn complaints(games: &[Game]) -> BTreeSet<&String> {
    games.iter().flat_map(|game| &game.run.complaints).collect()
}

fn player(player: Player, seed: u64) -> self_play::Player {
    match player {
        Player::Bot => self_play::Player::Bot(Bot::new(seed)),
        Player::Random => self_play::Player::Random(RandomPlayer::new(seed)),
        Player::Tour => self_play::Player::Coverage(CoveragePlayer::new(seed)),
    }
}

/// A machine on which one game was played, or several in a row, and what it took.
struct Game {
    /// Without its recording.
    run: SelfPlayRun,
    core_time: Duration,
    /// Length of the recording.
    bytes: usize,
}

impl Game {
    /// Writes the game's recording where it is wanted, then forgets it.
    fn keep(mut run: SelfPlayRun, core_time: Duration, args: &SimulateArgs) -> Result<Game, Failure> {
        let recording = std::mem::take(&mut run.recording);
        let sound = run.anomalies.is_empty() && run.complaints.is_empty();
        let failures = args.save_failures.as_ref().filter(|_| !sound);
        for dir in args.save_all.iter().chain(failures) {
            let path = recording_path(dir, run.seed);
            new_file::write(&path, |file| file.write_all(&recording))
                .map_err(|error| file_failure("write the recording", &path, &error))?;
        }
        Ok(Game { run, core_time, bytes: recording.len() })
    }
}

/// Everything that the games have shown, as lines.
fn summary(table: &Table, games: &[Game]) -> Vec<String> {
    let runs: Vec<&SelfPlayRun> = games.iter().map(|game| &game.run).collect();
    let rules = complaints(games).into_iter().map(|complaint| format!("rules      {complaint}")).collect();
    [games_lines(table, games), switch_lines(table, &runs), anomaly_lines(&runs), rules].concat()
}

fn games_lines(table: &Table, all: &[Game]) -> Vec<String> {
    let runs: Vec<&SelfPlayRun> = all.iter().map(|game| &game.run).collect();
    let core_time: Duration = all.iter().map(|game| game.core_time).sum();
    let seconds = |ticks: u64| ticks as f64 / f64::from(TICKS_PER_SECOND);
    let played: Vec<&GameResult> = runs.iter().flat_map(|run| &run.games).collect();
    let (median, mean, best) = scores(played.iter().map(|game| game.score).collect());
    let balls = Sorted::new(runs.iter().flat_map(|run| &run.balls).map(|ticks| seconds(*ticks)));
    let games = Sorted::new(played.iter().map(|game| seconds(game.ticks)));
    let table_bytes = recording::table_bytes(table);
    let bytes: usize = all.iter().map(|game| game.bytes.saturating_sub(table_bytes)).sum();
    let over = played.iter().filter(|game| game.over).count();
    let total = seconds(runs.iter().map(|run| run.ticks).sum());
    let minutes = (total / 60.0).max(1e-9);
    let speed = total / core_time.as_secs_f64().max(1e-9);
    let machines = if played.len() > runs.len() { format!(", machines {}", runs.len()) } else { String::new() };
    vec![
        format!("games      {} ({over} came to their end){machines}", played.len()),
        format!("score      median {median}, mean {mean}, best {best}"),
        format!(
            "ball time  median {:.1} s, quartiles {:.1} s and {:.1} s",
            balls.at(0.5),
            balls.at(0.25),
            balls.at(0.75)
        ),
        format!(
            "game time  median {:.1} s, longest {:.1} s, {minutes:.1} minutes in all",
            games.at(0.5),
            games.at(1.0)
        ),
        format!("recording  {:.0} bytes a minute, and {table_bytes} bytes of the table", bytes as f64 / minutes),
        format!("speed      {speed:.0} times real time on one core"),
    ]
}

fn switch_lines(table: &Table, runs: &[&SelfPlayRun]) -> Vec<String> {
    let parts = table.layout.parts.iter().enumerate();
    let switches = parts.filter(|(_, part)| !matches!(part.kind, Kind::Wall(_) | Kind::Flipper(_) | Kind::Plunger(_)));
    let hits = |index: usize| runs.iter().map(|run| run.hits[index]).sum::<u64>();
    let mut never = Vec::new();
    let mut lines = vec!["hits".to_string()];
    for (index, part) in switches {
        match hits(index) {
            0 => never.push(part.name.as_str()),
            count => lines.push(format!("  {count:>8}  {}", part.name)),
        }
    }
    lines.push(format!("never hit  {}", if never.is_empty() { "none".to_string() } else { never.join(", ") }));
    lines
}

fn anomaly_lines(runs: &[&SelfPlayRun]) -> Vec<String> {
    let all = || runs.iter().flat_map(|run| run.anomalies.iter().map(move |anomaly| (run.seed, anomaly)));
    let count = |kind| all().filter(|(_, anomaly)| anomaly.kind == kind).count();
    let mut lines = vec![format!(
        "anomalies  stuck {}, escaped {}, overlap {}, NaN {}",
        count(AnomalyKind::Stuck),
        count(AnomalyKind::Escaped),
        count(AnomalyKind::Overlap),
        count(AnomalyKind::NotANumber)
    )];
    for (seed, anomaly) in all() {
        let (x, y) = (anomaly.center_mm.x, anomaly.center_mm.y);
        let second = anomaly.tick as f64 / f64::from(TICKS_PER_SECOND);
        let kind = anomaly.kind;
        lines.push(format!("  game {seed} at {second:.2} s: {kind} at {x:.1}, {y:.1} mm, {}", anomaly.detail));
    }
    lines
}

/// Numbers in order, for their quantiles.
struct Sorted(Vec<f64>);

impl Sorted {
    fn new(numbers: impl Iterator<Item = f64>) -> Sorted {
        let mut numbers: Vec<f64> = numbers.collect();
        numbers.sort_by(f64::total_cmp);
        Sorted(numbers)
    }

    /// The number below which this share of them lies, straight between the two nearest; 0 if there is none.
    fn at(&self, share: f64) -> f64 {
        let place = share * self.0.len().saturating_sub(1) as f64;
        let number = |place: f64| self.0.get(place as usize).copied().unwrap_or(0.0);
        let (below, above) = (number(place.floor()), number(place.ceil()));
        below + (above - below) * place.fract()
    }
}

/// Median, mean and best of scores, each as whole as a score is; 0 if there is none.
fn scores(mut all: Vec<i64>) -> (i64, i128, i64) {
    all.sort_unstable();
    let at = |place: usize| all.get(place).copied().unwrap_or(0);
    let last = all.len().saturating_sub(1);
    let sum: i128 = all.iter().map(|score| i128::from(*score)).sum();
    let count = all.len().max(1) as i128;
    // Rounded to the nearest.
    let mean = (2 * sum + count).div_euclid(2 * count);
    let middle = [last / 2, last.div_ceil(2)].map(|place| i128::from(at(place)));
    // Between two scores lies a score.
    let median = (middle[0] + middle[1]).div_euclid(2) as i64;
    (median, mean, at(last))
}

#[cfg(test)]
mod tests {
    use super::scores;

    /// The best of scores near the largest was told one more than a score can be.
    #[test]
    fn scores_are_told_to_the_last_point() {
        assert_eq!(scores(vec![i64::MAX, i64::MAX - 2]), (i64::MAX - 1, i128::from(i64::MAX) - 1, i64::MAX));
        assert_eq!(scores(vec![1, 5, 2]), (2, 3, 5));
        assert_eq!(scores(vec![10, 50, 20, 40]), (30, 30, 50));
        assert_eq!((scores(Vec::new()), scores(vec![7])), ((0, 0, 0), (7, 7, 7)));
    }
}
