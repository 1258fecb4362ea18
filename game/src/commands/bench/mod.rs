//! `caustic bench`: how fast the light, a whole frame, the simulation and the rules are, on this machine, now.
//!
//! Every figure is a median of many runs within one process; what is compared is measured in the same run, in turn.

mod art;
mod bake;
mod beams;
mod chord;
mod clock;
mod friction_cone;
mod growth;
mod heap;
mod levels;
mod photons;
mod physics;
mod quality;
mod room;
mod rules;
mod shots;
mod table;
mod tick;

use super::print::print_lines;
use crate::Failure;
use crate::cli::{Bench, BenchArgs};
use serde::Serialize;

/// One measured figure.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Row {
    /// Which bench.
    pub bench: &'static str,
    /// What was measured in it.
    pub variant: String,
    /// Size in pixels, where there is one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub size: Option<String>,
    /// Threads.
    pub threads: usize,
    /// Median time of one frame, or of one tick.
    pub ms: f64,
    /// The same for a pixel.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ns_per_pixel: Option<f64>,
    /// The slowest of a hundred.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ms_99th: Option<f64>,
    /// Seconds of play in a second.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub times_real_time: Option<f64>,
    /// How many times longer than a memset of the same bytes on as many threads.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub times_memset: Option<f64>,
    /// How many times longer photons take until their picture is as near to a converged one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub times_photons: Option<f64>,
    /// Million operations that were estimated.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mops: Option<f64>,
    /// Straight pieces of ways of light.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub million_segments_a_second: Option<f64>,
    /// How many times as many as the literal way.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub times_literal: Option<f64>,
    /// The largest difference from the literal way's pictures, in levels of 255.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub most_levels_off: Option<u8>,
    /// The pixels that differ from them by more than one level, in all pictures together.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pixels_off: Option<usize>,
}

/// Runs the bench that the command line asks for and prints its rows.
///
/// # Errors
/// If a table or a demo cannot be read, or the light is not as exact as it must be.
pub fn run(args: &BenchArgs) -> Result<(), Failure> {
    if args.bench == Bench::Quality {
        return quality::run(args.threads, args.json);
    }
    if args.bench == Bench::Chord {
        return chord::run(args.json);
    }
    let mut rows = Vec::new();
    if matches!(args.bench, Bench::Room | Bench::All) {
        rows.extend(room::rows(args.size, args.threads)?);
    }
    if matches!(args.bench, Bench::Table | Bench::All) {
        rows.extend(table::rows(args.size, args.threads)?);
    }
    if matches!(args.bench, Bench::Growth | Bench::All) {
        rows.extend(growth::rows(args.size, args.threads)?);
    }
    if matches!(args.bench, Bench::Photons | Bench::All) {
        rows.extend(photons::rows(args.size, args.threads)?);
    }
    if args.bench == Bench::Beams {
        rows.extend(beams::rows(args.size, args.threads)?);
    }
    if args.bench == Bench::Physics {
        rows.extend(physics::rows(args.shots, args.threads)?);
    }
    if matches!(args.bench, Bench::Tick | Bench::All) {
        rows.extend(tick::rows()?);
    }
    if matches!(args.bench, Bench::Rules | Bench::All) {
        rows.extend(rules::rows()?);
    }
    if matches!(args.bench, Bench::Art | Bench::All) {
        rows.extend(art::rows()?);
    }
    if args.bench == Bench::Bake {
        rows.extend(bake::rows(args.threads)?);
    }
    let text = if args.json { json(&rows) } else { table(&rows) };
    print_lines(text.lines())
}

fn json(rows: &[Row]) -> String {
    serde_json::to_string_pretty(rows).expect("plain numbers and words are JSON")
}

fn table(rows: &[Row]) -> String {
    let mut text = format!("{:7} {:44} {:>10} {:>7} {:>10}\n", "bench", "variant", "size", "threads", "ms");
    for row in rows {
        let size = row.size.as_deref().unwrap_or("");
        let mut more = Vec::new();
        more.extend(row.ns_per_pixel.map(|ns| format!("{ns:.3} ns a pixel")));
        more.extend(row.ms_99th.map(|ms| format!("99th percentile {ms:.4} ms")));
        more.extend(row.times_real_time.map(|times| format!("{times:.0} x real time")));
        more.extend(row.times_memset.map(|times| format!("{times:.1} x memset")));
        more.extend(row.times_photons.map(|times| format!("photons take {times:.0} x as long")));
        more.extend(
            row.mops.map(|mops| format!("{mops:.0} million operations estimated, {:.3} ns each", row.ms / mops)),
        );
        more.extend(row.million_segments_a_second.map(|rate| format!("{rate:.3} million segments a second")));
        more.extend(row.times_literal.map(|times| format!("{times:.1} x literal")));
        if let (Some(pixels), Some(levels)) = (row.pixels_off, row.most_levels_off) {
            more.push(format!("{pixels} pixels off by more than 1 level (most {levels})"));
        }
        let more = more.join(", ");
        let line =
            format!("{:7} {:44} {size:>10} {:>7} {:>10.4}   {more}", row.bench, row.variant, row.threads, row.ms);
        text += line.trim_end();
        text.push('\n');
    }
    text
}
