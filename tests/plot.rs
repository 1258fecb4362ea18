//! Plots of the physics: what was measured holds, and a picture is made of it.

#![expect(clippy::disallowed_methods, reason = "the test reads what it has written")]

use game::Table;
use game::commands::plot::{energy, flipper, restitution, shots};
use std::collections::BTreeSet;
use std::fs::{self, File};
use std::io::BufReader;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn spectrum() -> Table {
    game::storage::tables::load("spectrum").expect("a good table")
}

/// A folder of this test's own, not made yet.
fn folder(name: &str) -> PathBuf {
    std::env::temp_dir().join(format!("caustic-plot-{name}-{}", std::process::id()))
}

fn plot(what: &str, out: &Path, more: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_caustic"));
    command.args(["plot", what, "--out"]).arg(out).args(more).output().expect("the program runs")
}

/// Width, height and the colours of a picture.
fn colors(path: &Path) -> (u32, u32, BTreeSet<[u8; 3]>) {
    let file = File::open(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let mut reader = png::Decoder::new(BufReader::new(file)).read_info().expect("a PNG file");
    let mut bytes = vec![0; reader.output_buffer_size().expect("a size")];
    let info = reader.next_frame(&mut bytes).expect("a picture");
    let colors = bytes[..info.buffer_size()].chunks_exact(3).map(|rgb| [rgb[0], rgb[1], rgb[2]]).collect();
    (info.width, info.height, colors)
}

#[test]
fn every_plot_is_written_and_says_what_it_found() {
    let out = folder("all");
    let done = plot("all", &out, &["--size", "300x210"]);
    assert_eq!(done.status.code(), Some(0), "{}", String::from_utf8_lossy(&done.stderr));
    let said = String::from_utf8(done.stdout).expect("UTF-8");
    for (name, found) in [
        ("flipper.png", "Up in "),
        ("shots.png", "farther right"),
        ("restitution.png", "measured impacts"),
        ("energy.png", "it rises in none of 5000 ticks"),
    ] {
        let (width, height, colors) = colors(&out.join(name));
        assert_eq!((width, height), (300, 210), "{name}");
        assert!(colors.len() > 100, "{name} has {} colours only", colors.len());
        let line = said.lines().find(|line| line.contains(name)).expect(name);
        assert!(line.contains(found), "{line}");
    }
    assert_eq!(fs::read_dir(&out).expect("a folder").count(), 4);
    fs::remove_dir_all(&out).expect("the folder goes");
}

#[test]
fn sizes_of_every_shape_can_be_drawn() {
    let out = folder("sizes");
    for size in ["64x64", "64x900", "900x64"] {
        let done = plot("flipper", &out, &["--size", size, "--overwrite"]);
        assert_eq!(done.status.code(), Some(0), "{size}: {}", String::from_utf8_lossy(&done.stderr));
        let (width, height, _) = colors(&out.join("flipper.png"));
        assert_eq!(format!("{width}x{height}"), size);
    }
    // What was there was written over without a word.
    let again = plot("flipper", &out, &["--size", "64x64"]);
    let told = String::from_utf8_lossy(&again.stderr);
    assert_eq!(again.status.code(), Some(1), "{told}");
    assert!(
        told.contains("flipper.png is there already: name another folder, or write over it with --overwrite"),
        "{told}"
    );
    fs::remove_dir_all(&out).expect("the folder goes");
}

#[test]
fn a_wrong_plot_is_a_sentence() {
    let out = folder("wrong");
    fs::write(&out, "kept").expect("a file");
    for (what, more, code, told) in [
        ("flipper", &["--size", "12x800"][..], 2, "each side must be from 64 to 16384 pixels"),
        ("spin", &[], 2, "possible values: flipper, shots, restitution, energy, all"),
        ("flipper", &["--table", "no-such-table"], 1, "there is no table called no-such-table"),
        ("flipper", &[], 1, "is a file; name a folder"),
    ] {
        let done = plot(what, &out, more);
        let said = String::from_utf8_lossy(&done.stderr).into_owned();
        assert_eq!(done.status.code(), Some(code), "{what} {more:?}: {said}");
        assert!(said.contains(told) && !said.contains("panicked"), "{what} {more:?}: {said}");
    }
    assert_eq!(fs::read_to_string(&out).expect("the file"), "kept");
    fs::remove_file(&out).expect("the file goes");
}

#[test]
fn a_table_that_has_nothing_to_measure_is_told_so() {
    let mut table = spectrum();
    table.layout.parts.retain(|part| part.name != "left-flipper");
    let said = flipper::measure(&table).expect_err("it has no left flipper").to_string();
    assert!(said.contains("spectrum has no left flipper"), "{said}");
    let mut table = spectrum();
    table.layout.parts.retain(|part| part.name != "inlane-left-guide");
    let said = shots::measure(&table, 100).expect_err("the ball rolls away").to_string();
    assert!(said.contains("no ball lies still"), "{said}");
}

#[test]
fn longer_presses_lift_the_flipper_higher() {
    let strokes = flipper::measure(&spectrum()).expect("a left flipper");
    assert_eq!(strokes.strokes.len(), flipper::PRESSES_MS.len() + 1);
    for pair in strokes.strokes.windows(2).take(flipper::PRESSES_MS.len() - 1) {
        let (less, more) = (pair[0].peak_deg(), pair[1].peak_deg());
        assert!(more > less + 1e-3, "{:?} ms lifts by {more} deg, less by {less}", pair[1].press_ms);
    }
    assert!((19.0..26.0).contains(&strokes.up_ms), "up in {} ms", strokes.up_ms);
    assert!((85.0..100.0).contains(&strokes.back_ms), "back in {} ms", strokes.back_ms);
    assert!((5.0..6.5).contains(&strokes.tip_m_s), "tip at {} m/s", strokes.tip_m_s);
}

#[test]
fn a_later_press_shoots_farther_across() {
    let shots = shots::measure(&spectrum(), 10).expect("a ball that lies still");
    let rising = shots.rising();
    let (first, last) = (rising.first().expect("a shot"), rising.last().expect("a shot"));
    assert!(last.angle_deg - first.angle_deg > 45.0, "from {first:?} to {last:?}");
    assert!(last.delay_ms - first.delay_ms > 400, "from {first:?} to {last:?}");
    let fastest = shots.shots.iter().map(|shot| shot.speed_m_s).fold(0.0, f64::max);
    assert!((4.0..7.6).contains(&fastest), "{fastest} m/s");
}

#[test]
fn every_material_gives_back_what_the_table_says() {
    let table = spectrum();
    let bounces = restitution::measure(&table, 9).expect("materials");
    let names: Vec<&str> = bounces.iter().map(|bounces| bounces.name.as_str()).collect();
    assert!(["wood", "metal", "rubber", "post", "flipper-rubber"].iter().all(|name| names.contains(name)), "{names:?}");
    for bounces in &bounces {
        assert_eq!(bounces.measured.len(), 9);
        for (speed, share) in &bounces.measured {
            let wanted = bounces.material.restitution_at(*speed);
            assert!((share / wanted - 1.0).abs() < 0.01, "{} at {speed} m/s: {share}, not {wanted}", bounces.name);
        }
        let (first, last) = (bounces.measured[0].0, bounces.measured[8].0);
        assert!((first - 0.05).abs() < 1e-3 && (last - 5.0).abs() < 1e-3, "from {first} to {last} m/s");
    }
}

#[test]
fn nothing_that_is_dead_makes_energy() {
    for balls in [1, 5, 12] {
        let fall = energy::measure(&spectrum(), balls, 4000).expect("room for them");
        assert_eq!(fall.balls, balls);
        assert!(fall.largest_rise() < 1e-6, "{balls} balls: a rise by {} of itself in a tick", fall.largest_rise());
        let (first, last) = (fall.energy[0].total_j(), fall.energy[4000].total_j());
        assert!(first > 0.1 * balls as f64 && last < 0.4 * first, "{balls} balls: from {first} to {last} J");
    }
}
