//! A whole frame of the table in play, stage by stage, as the window draws it.

use super::Row;
use super::clock::{quantile, time_ms};
use crate::commands::parallel;
use crate::frame_composer::{FrameComposer, Interpolation, LightResolution};
use crate::hud::UiState;
use crate::screen::Size;
use crate::session::LiveGame;
use crate::storage::tables;
use crate::{Buttons, Failure, Snapshot, Table};
use std::sync::Arc;
use tracer::monte_carlo::Sampling;

/// The size that figures are quoted at, beside the one of a full HD monitor on its side.
const SIZES: [Size; 2] = [Size { width: 540, height: 1080 }, Size { width: 1080, height: 1920 }];

/// Frames that are timed, after as many again to warm up; a 60th of a second of play lies between two.
const FRAMES: usize = 120;

/// How long the bot has played before the first frame, ticks.
const PLAYED: u64 = 12_000;

/// From one frame to the next, ticks.
const APART: u64 = 17;

/// The games whose balls are on the table.
const SEEDS: [u64; 3] = [1, 2, 3];

/// Times the frames of a game at each size.
pub fn rows(size: Option<Size>, threads: Option<usize>) -> Result<Vec<Row>, Failure> {
    let table = Arc::new(tables::load("spectrum").map_err(Failure::of_many)?);
    let snapshots = snapshots(&table, FRAMES)?;
    let sizes = size.map_or(SIZES.to_vec(), |size| vec![size]);
    let mut rows = Vec::new();
    for size in sizes {
        rows.extend(frames(&table, &snapshots, size, threads)?);
    }
    Ok(rows)
}

/// The hard case that figures are quoted for: a bot's game, a 60th of a second from snapshot to snapshot, with the balls of
/// two other games on the table as well, and every lamp and insert flashing in a rhythm of its own, so that no lamp
/// gives in one frame what it gave in the last.
pub(super) fn snapshots(table: &Arc<Table>, count: usize) -> Result<Vec<Snapshot>, Failure> {
    let mut snapshots = game(table, SEEDS[0], count)?;
    for seed in &SEEDS[1..] {
        for (snapshot, other) in snapshots.iter_mut().zip(game(table, *seed, count)?) {
            snapshot.pose.balls.extend(other.pose.balls.into_iter().take(1));
        }
    }
    for (number, snapshot) in snapshots.iter_mut().enumerate() {
        for (lamp, light) in snapshot.lamps.iter_mut().enumerate() {
            light.level = 250 + ((number * 97 + lamp * 331) % 750) as u16;
        }
    }
    Ok(snapshots)
}

/// What the bot's game looks like, a 60th of a second apart, while a ball is in play.
fn game(table: &Arc<Table>, seed: u64, count: usize) -> Result<Vec<Snapshot>, Failure> {
    let mut game = LiveGame::unrecorded(table.clone(), seed, true)?;
    game.play(PLAYED / APART * APART, Buttons::NONE);
    let mut snapshots = Vec::new();
    while snapshots.len() < count {
        game.play(APART, Buttons::NONE);
        let (_, current) = game.snapshots();
        if current.pose.balls.len() == 1 {
            snapshots.push(Snapshot::clone(current));
        }
    }
    Ok(snapshots)
}

fn frames(table: &Arc<Table>, snapshots: &[Snapshot], size: Size, threads: Option<usize>) -> Result<Vec<Row>, Failure> {
    let pool = parallel::pool(threads)?;
    let threads = pool.current_num_threads();
    let mut composer = FrameComposer::new(table.clone(), pool)?;
    let draw = |composer: &mut FrameComposer, snapshot: &Snapshot| -> Result<f64, Failure> {
        let mut drawn = Ok(());
        let ms = time_ms(|| {
            drawn = composer.draw(Interpolation::at(snapshot), size, &UiState::default()).map(|_| ());
        });
        drawn.map(|()| ms)
    };
    let row = |variant: &str, mut times_ms: Vec<f64>| {
        let ms = quantile(&mut times_ms, 0.5);
        Row {
            bench: "table",
            variant: variant.to_string(),
            size: Some(format!("{}x{}", size.width, size.height)),
            threads,
            ms,
            ns_per_pixel: Some(ms * 1e6 / (size.width * size.height) as f64),
            ms_99th: Some(quantile(&mut times_ms, 0.99)),
            ..Row::default()
        }
    };
    let mut rows = Vec::new();
    for (light, names) in [(LightResolution::Full, &FULL), (LightResolution::Half, &HALF)] {
        composer.set_light_resolution(light);
        for snapshot in snapshots {
            draw(&mut composer, snapshot)?;
        }
        let mut columns: [Vec<f64>; 8] = Default::default();
        for snapshot in snapshots {
            let whole_ms = draw(&mut composer, snapshot)?;
            let times = composer.times();
            let parts = [
                whole_ms,
                times.scene_ms,
                times.prepare_ms,
                times.shadows_ms,
                times.balls_ms,
                times.bloom_ms,
                times.tone_map_ms,
                times.hud_ms,
            ];
            columns.iter_mut().zip(parts).for_each(|(column, part)| column.push(part));
        }
        rows.extend(names.iter().zip(columns).map(|(name, column)| row(name, column)));
    }
    rows.extend(switches(&mut composer, snapshots, size, threads)?);
    composer.use_reference(Sampling { samples: REFERENCE_SAMPLES, seed: 0, stratified: true });
    let slow_ms = draw(&mut composer, &snapshots[0])?;
    rows.push(row(&format!("(reference, {REFERENCE_SAMPLES} rays a lamp)"), vec![slow_ms]));
    Ok(rows)
}

/// The longest frame around a change of the light's resolution, each way, while the new one is prepared beside the
/// frames.
fn switches(
    composer: &mut FrameComposer,
    snapshots: &[Snapshot],
    size: Size,
    threads: usize,
) -> Result<Vec<Row>, Failure> {
    composer.prepare_beside();
    let mut rows = Vec::new();
    for (light, name) in [(LightResolution::Full, "full"), (LightResolution::Half, "half")] {
        composer.set_light_resolution(light);
        let mut times_ms = Vec::new();
        // To and fro, so that no frame is far from the one before it.
        let mut way = snapshots.iter().chain(snapshots.iter().rev()).cycle();
        let mut left = AFTER_SWITCH;
        while left > 0 {
            let Some(snapshot) = way.next() else { break };
            let mut drawn = Ok(());
            times_ms.push(time_ms(|| {
                drawn = composer.draw(Interpolation::at(snapshot), size, &UiState::default()).map(|_| ());
            }));
            drawn?;
            left -= usize::from(!composer.is_preparing());
        }
        rows.push(Row {
            bench: "table",
            variant: format!("switch to {name} light, longest frame"),
            size: Some(format!("{}x{}", size.width, size.height)),
            threads,
            ms: quantile(&mut times_ms, 1.0),
            ..Row::default()
        });
    }
    Ok(rows)
}

/// Frames that are timed after a switch.
const AFTER_SWITCH: usize = 30;

/// What is told of a frame, and of its parts.
const FULL: [&str; 8] = [
    "whole frame",
    "- scene",
    "- what is new in it",
    "- shadows and surfaces anew",
    "- balls",
    "- bloom",
    "- sum of all lamps, tone map",
    "- display",
];

/// The same, where light is found at half the resolution.
const HALF: [&str; 8] = [
    "whole frame, half light",
    "- scene",
    "- guides, what glows",
    "- lamps at half the resolution",
    "- balls",
    "- bloom",
    "- upsampling, tone map",
    "- display",
];

/// Rays to each lamp that the slow reference is timed with: few, for it is slow.
const REFERENCE_SAMPLES: u32 = 4;
