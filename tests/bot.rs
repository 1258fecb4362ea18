//! The bot plays better than chance, and the same way every time.

use game::bot::self_play::{self, Player, SelfPlayOptions, SelfPlayRun};
use game::bot::{Bot, CoveragePlayer, RandomPlayer};
use game::storage::recordings;
use game::{Recording, Simulation, Table};
use rayon::prelude::*;
use std::sync::Arc;

fn spectrum() -> Arc<Table> {
    Arc::new(game::storage::tables::load("spectrum").unwrap())
}

/// Games of these seeds, at most so many ticks long.
fn games(seeds: std::ops::Range<u64>, longest: u64, player: impl Fn(u64) -> Player + Sync) -> Vec<SelfPlayRun> {
    let table = spectrum();
    seeds
        .into_par_iter()
        .map(|seed| self_play::play(&table, seed, player(seed), SelfPlayOptions::one_game(longest)).unwrap())
        .collect()
}

fn score(runs: &[SelfPlayRun]) -> i64 {
    runs.iter().map(|run| run.score()).sum()
}

#[test]
fn the_bot_outscores_a_player_who_flips_at_random() {
    let minute = 60_000;
    let bot = games(1..4, minute, |seed| Player::Bot(Bot::new(seed)));
    let random = games(1..4, minute, |seed| Player::Random(RandomPlayer::new(seed)));
    let (bot, random) = (score(&bot), score(&random));
    assert!(bot > random, "bot {bot}, random {random}");
}

#[test]
fn the_same_seed_gives_the_same_game_on_any_number_of_threads() {
    let play = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| games(5..8, 15_000, |seed| Player::Bot(Bot::new(seed))))
    };
    let bytes = |runs: Vec<SelfPlayRun>| runs.into_iter().map(|run| run.recording).collect::<Vec<_>>();
    let (one, three) = (bytes(play(1)), bytes(play(3)));
    assert!(one == three, "the recordings differ");
    assert!(one[0] != one[1], "every seed has its own game");
}

#[test]
fn a_game_that_the_bot_played_is_played_again_from_its_recording() {
    let run = games(11..12, 20_000, |seed| Player::Bot(Bot::new(seed))).remove(0);
    let recording = Recording::parse(&run.recording).unwrap();
    let mut replay = recordings::replay(recording.clone()).unwrap();
    let mut restored = recordings::replay(recording).unwrap();
    while replay.step() && restored.step() {
        if replay.tick().is_multiple_of(777) {
            restored.save_and_restore().unwrap();
        }
    }
    assert_eq!((replay.difference(), restored.difference()), (None, None));
    assert_eq!((replay.tick(), replay.simulation().hash()), (run.ticks, restored.simulation().hash()));
    // Any moment is found from any other.
    for tick in [12_345, 3, 19_000, 12_345] {
        replay.seek(tick);
        let mut fresh = recordings::replay(replay.recording().clone()).unwrap();
        fresh.seek(tick);
        assert_eq!((replay.tick(), replay.simulation().hash()), (tick, fresh.simulation().hash()));
    }
}

#[test]
fn game_follows_game_until_the_time_is_used_up_exactly() {
    let options = SelfPlayOptions { longest: 150_001, again: true, digest: true };
    let run = self_play::play(&spectrum(), 3, Player::Random(RandomPlayer::new(3)), options).unwrap();
    assert_eq!(run.ticks, 150_001);
    let (last, over) = run.games.split_last().unwrap();
    assert!(!over.is_empty(), "one is over before the time is");
    assert!(over.iter().all(|game| game.over && game.score > 0), "{over:?}");
    assert_eq!(run.games.iter().map(|game| game.ticks).sum::<u64>(), run.ticks, "{last:?}");
    assert_eq!(run.digest.unwrap().ticks(), run.ticks);
    let mut replay = recordings::replay(Recording::parse(&run.recording).unwrap()).unwrap();
    let mut digest = game::simulation::Digest::default();
    while replay.step() {
        digest.add(replay.simulation().hash());
    }
    assert_eq!((replay.difference(), Some(digest)), (None, run.digest));
}

#[test]
fn the_tour_tilts_the_machine_and_does_not_slam_it() {
    let mut simulation = Simulation::new(spectrum(), 1).unwrap();
    let mut player = CoveragePlayer::new(1);
    let (mut tilted, mut slams) = (false, 0);
    for _ in 0..150_000 {
        let buttons = player.buttons(&simulation);
        simulation.tick(buttons);
        slams += simulation.events().filter(|event| event.kind == physics::EventKind::Slam).count();
        tilted |= simulation.display().tilted;
    }
    assert!(tilted && slams == 0, "tilted: {tilted}, {slams} slams");
}
