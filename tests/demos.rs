//! The demonstrations in `assets/demos` play to the same end on every machine.

use game::storage::{library, recordings};
use rayon::prelude::*;
use std::path::{Path, PathBuf};

fn demos() -> Vec<PathBuf> {
    library::recordings(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../assets/demos"))
}

#[test]
fn every_demonstration_plays_as_it_was_recorded() {
    let demos = demos();
    assert!(demos.len() >= 6, "there are {} demonstrations", demos.len());
    let seen: Vec<(usize, bool)> = demos.par_iter().map(|path| play(path)).collect();
    assert!(seen.contains(&(3, true)), "three players and a tilt are in one of them: {seen:?}");
}

/// Plays a recording to its end; how many players there were, and whether one tilted.
fn play(path: &Path) -> (usize, bool) {
    let mut replay = recordings::replay(recordings::read(path).unwrap()).unwrap();
    let (mut players, mut tilted) = (0, false);
    while replay.step() {
        assert_eq!(replay.difference(), None, "{}", path.display());
        if replay.tick().is_multiple_of(50) {
            let display = replay.simulation().display();
            players = players.max(display.scores.len());
            tilted |= display.tilted;
        }
    }
    assert!(replay.recording().end.is_some_and(|end| end.tick == replay.tick()), "{}", path.display());
    (players, tilted)
}

#[test]
fn the_demonstrations_are_long_small_and_use_every_key() {
    let mut pressed = 0;
    for path in demos() {
        let recording = recordings::read(&path).unwrap();
        let bytes = std::fs::metadata(&path).unwrap().len();
        let minutes = recording.ticks() as f64 / 60_000.0;
        assert!(minutes >= 1.0, "{} is {minutes} minutes long", path.display());
        assert!((bytes as f64) < 10_000.0 * minutes, "{} has {bytes} bytes", path.display());
        pressed |= recording.inputs().fold(0, |all, buttons| all | buttons.0);
    }
    assert_eq!(pressed, game::Buttons::ALL.0, "every key is pressed in one of them");
}
