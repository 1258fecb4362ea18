//! The words that measure: `caustic bench` and `caustic plot`.

use super::values::{folder, threads, whole};
use crate::screen::Size;
use clap::builder::{NonEmptyStringValueParser, OsStringValueParser, TypedValueParser};
use clap::{Args, ValueEnum};
use std::path::PathBuf;

/// `caustic bench`
#[derive(Args, Debug, Clone)]
pub struct BenchArgs {
    /// What to measure
    #[arg(value_enum, default_value_t = Bench::All)]
    pub bench: Bench,
    /// Size of the frames in pixels
    #[arg(long, value_name = "WxH", allow_hyphen_values = true, value_parser = Size::parse)]
    pub size: Option<Size>,
    /// Threads that trace light; by default one for each core
    #[arg(long, value_name = "N", value_parser = threads, allow_hyphen_values = true)]
    pub threads: Option<usize>,
    /// Shots of `bench physics`, and a tenth of them at moving flippers
    #[arg(long, value_name = "N", default_value_t = 100_000, allow_hyphen_values = true, value_parser = whole(1..=1_000_000_000_u64))]
    pub shots: u64,
    /// Print rows as JSON
    #[arg(long)]
    pub json: bool,
}

/// What to measure.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Bench {
    /// The classic race: a room, three circles, four lamps.
    Room,
    /// A whole frame of the table, stage by stage.
    Table,
    /// How a frame's cost grows with pixels, lamps, occluders and balls, on a generated table.
    Growth,
    /// Packets of light, traced and laid on a film, against the literal loops.
    Photons,
    /// The beam sweep of three caustics: what it takes, and what photons take for a picture as good.
    Beams,
    /// Headless play.
    Tick,
    /// What the most work that rules may do in a second takes.
    Rules,
    /// What it takes to print art, next to what is estimated before.
    Art,
    /// How exact the light is, against shadow rays.
    Quality,
    /// How far the exact light, which measures a lamp by its chord, is from light by its angle, near a lamp.
    Chord,
    /// Whether a ball gets through anything or rubs too hard, and what a tick with six balls, and with heaps, costs.
    Physics,
    /// The indirect light of the table, baked: how long it takes, and how far it is from photons.
    Bake,
    /// All of them but quality, chord, physics, beams and bake.
    All,
}

/// `caustic plot`
#[derive(Args, Debug, Clone)]
pub struct PlotArgs {
    /// What to measure
    #[arg(value_enum, default_value_t = Plot::All)]
    pub plot: Plot,
    /// A folder for the PNG files, one a plot
    #[arg(long, value_name = "DIR", value_parser = OsStringValueParser::new().try_map(folder))]
    pub out: PathBuf,
    /// Write over plots that are in the folder already
    #[arg(long)]
    pub overwrite: bool,
    /// A table's name, or the folder of one
    #[arg(long, default_value = "spectrum", value_name = "NAME|DIR", value_parser = NonEmptyStringValueParser::new())]
    pub table: String,
    /// Size of the plots in pixels
    #[arg(long, value_name = "WxH", allow_hyphen_values = true, value_parser = Size::parse, default_value = "1200x800")]
    pub size: Size,
}

/// What to measure of the physics.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Plot {
    /// How far presses of different lengths lift a flipper, and when.
    Flipper,
    /// Where a cradled ball goes, by the delay from the release to the press, and how fast.
    Shots,
    /// How much of its speed each material gives back.
    Restitution,
    /// What becomes of the energy of balls that nothing drives.
    Energy,
    /// All of them.
    All,
}
