//! The command line's words.

mod measure;
mod render;
mod usage_error;
mod values;
mod view;

pub use measure::{Bench, BenchArgs, Plot, PlotArgs};
pub use render::{LightIntegrator, RenderArgs};
pub use view::ViewArgs;

use crate::frame_composer::LightResolution;
use crate::screen::Size;
use clap::builder::{NonEmptyStringValueParser, OsStringValueParser, TypedValueParser};
use clap::error::ErrorKind;
use clap::{Args, CommandFactory, Parser, Subcommand, ValueEnum};
use std::path::PathBuf;
use values::{film_place, folder, minutes, png_file, seconds, threads, whole, zoom};

/// Caustic: a pinball game whose only light is ray traced.
#[derive(Debug, Parser)]
#[command(name = "caustic", version, about, args_conflicts_with_subcommands = true)]
pub struct Cli {
    /// What to do; without it, play.
    #[command(subcommand)]
    pub command: Option<Command>,
    /// How to play.
    #[command(flatten)]
    pub play: PlayArgs,
}

/// What to do.
#[derive(Debug, Subcommand)]
pub enum Command {
    /// Play in a window (also what happens without a command)
    Play(PlayArgs),
    /// Watch a recording: space pauses, left and right seek 5 s, up and down change the speed
    Replay(ReplayArgs),
    /// Play recordings again without a screen and compare every stored hash
    Verify(VerifyArgs),
    /// Write a recording's frames as numbered PNG files, or as y4m to standard output
    Dump(DumpArgs),
    /// Write one frame as a PNG file
    Frame(FrameArgs),
    /// Let the bot play many games without a screen and report what happened
    Simulate(SimulateArgs),
    /// Check a table's files and print every error with its place
    Check(CheckArgs),
    /// Render drawings as scenes of light: glass, mirrors, prisms, spectra
    Render(RenderArgs),
    /// Show a drawing's light in a window: drag its lamps, lenses and prisms
    View(ViewArgs),
    /// Trace a ray-optics scene and print what its detectors measure
    Optics(OpticsArgs),
    /// Measure the light, the frame and the simulation
    Bench(BenchArgs),
    /// Measure the physics and draw what it does as PNG files
    Plot(PlotArgs),
}

/// `caustic play`
#[derive(Args, Debug, Clone)]
pub struct PlayArgs {
    /// A table's name, or the folder of one
    #[arg(long, default_value = "spectrum", value_name = "NAME|DIR", value_parser = NonEmptyStringValueParser::new())]
    pub table: String,
    /// Seed of the game's random numbers; by default one is taken from the clock
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = whole(0..=u64::MAX))]
    pub seed: Option<u64>,
    /// Also record the game to this new file
    #[arg(long, value_name = "FILE")]
    pub record: Option<PathBuf>,
    /// Size of the window in pixels
    #[arg(long, value_name = "WxH", allow_hyphen_values = true, value_parser = Size::parse)]
    pub size: Option<Size>,
    /// Fill the screen
    #[arg(long)]
    pub fullscreen: bool,
    /// Let the bot play
    #[arg(long)]
    pub bot: bool,
    /// Resolution at which light is found: half is for small machines, auto takes it while the full
    /// one is too slow for the monitor
    #[arg(long, value_enum, default_value_t = LightChoice::Auto)]
    pub light: LightChoice,
    /// How much larger than the window the table is drawn, 1 to 4; the window follows the ball
    #[arg(long, value_name = "FACTOR", default_value_t = 1.0, value_parser = zoom, allow_hyphen_values = true)]
    pub zoom: f64,
    /// Threads that trace light; by default one for each core
    #[arg(long, value_name = "N", value_parser = threads, allow_hyphen_values = true)]
    pub threads: Option<usize>,
}

/// `caustic replay`
#[derive(Args, Debug, Clone)]
pub struct ReplayArgs {
    /// The recording
    pub file: PathBuf,
    /// Size of the window in pixels
    #[arg(long, value_name = "WxH", allow_hyphen_values = true, value_parser = Size::parse)]
    pub size: Option<Size>,
    /// Fill the screen
    #[arg(long)]
    pub fullscreen: bool,
    /// Resolution at which light is found: half is for small machines, auto takes it while the full
    /// one is too slow for the monitor
    #[arg(long, value_enum, default_value_t = LightChoice::Auto)]
    pub light: LightChoice,
    /// How much larger than the window the table is drawn, 1 to 4; the window follows the ball
    #[arg(long, value_name = "FACTOR", default_value_t = 1.0, value_parser = zoom, allow_hyphen_values = true)]
    pub zoom: f64,
    /// Threads that trace light; by default one for each core
    #[arg(long, value_name = "N", value_parser = threads, allow_hyphen_values = true)]
    pub threads: Option<usize>,
}

/// `caustic verify`
#[derive(Args, Debug, Clone)]
pub struct VerifyArgs {
    /// The recordings
    #[arg(required = true, value_name = "FILE")]
    pub files: Vec<PathBuf>,
    /// Recordings that are verified at once; by default one for each core
    #[arg(long, value_name = "N", value_parser = threads, allow_hyphen_values = true)]
    pub threads: Option<usize>,
    /// Also save the simulation and restore it into a new one after every N ticks
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = whole(1..=u64::MAX))]
    pub restore_every: Option<u64>,
    /// Also hash every tick and print one number for each recording, and one for all of them by their seeds
    #[arg(long)]
    pub digest: bool,
    /// Cut one damaged recording to its sound part, in this new file, and verify that
    #[arg(long, value_name = "OUT")]
    pub salvage: Option<PathBuf>,
}

/// `caustic dump`
#[derive(Args, Debug, Clone)]
pub struct DumpArgs {
    /// The recording
    pub file: PathBuf,
    /// A folder for numbered PNG files, or - for y4m on standard output
    #[arg(long, value_name = "DIR|-", value_parser = OsStringValueParser::new().try_map(film_place))]
    pub out: PathBuf,
    /// Write over frames that are in the folder already
    #[arg(long)]
    pub overwrite: bool,
    /// Size of the frames in pixels
    #[arg(long, value_name = "WxH", allow_hyphen_values = true, value_parser = Size::parse,
        default_value = "540x1080")]
    pub size: Size,
    /// Frames in a second of play
    #[arg(long, default_value_t = 60, value_name = "N", allow_hyphen_values = true,
        value_parser = whole(1..=1000_u32))]
    pub fps: u32,
    /// Where to start, in seconds of play
    #[arg(long, value_name = "S", value_parser = seconds, allow_hyphen_values = true)]
    pub from: Option<f64>,
    /// Where to stop, in seconds of play
    #[arg(long, value_name = "S", value_parser = seconds, allow_hyphen_values = true)]
    pub to: Option<f64>,
    /// Resolution at which light is found: half is for small machines
    #[arg(long, value_enum, default_value_t = LightChoice::Full)]
    pub light: LightChoice,
    /// How much larger than the window the table is drawn, 1 to 4; the window follows the ball
    #[arg(long, value_name = "FACTOR", default_value_t = 1.0, value_parser = zoom, allow_hyphen_values = true)]
    pub zoom: f64,
    /// Threads that trace light; by default one for each core
    #[arg(long, value_name = "N", value_parser = threads, allow_hyphen_values = true)]
    pub threads: Option<usize>,
}

/// `caustic frame`
#[derive(Args, Debug, Clone)]
pub struct FrameArgs {
    /// A table's name, or the folder of one
    #[arg(long, default_value = "spectrum", value_name = "NAME|DIR", conflicts_with = "replay",
        value_parser = NonEmptyStringValueParser::new())]
    pub table: String,
    /// A recording to take the frame from
    #[arg(long, value_name = "FILE")]
    pub replay: Option<PathBuf>,
    /// The moment, in seconds of play; by default a recording's end, or a table two seconds after it was switched on
    #[arg(long, value_name = "S", value_parser = seconds, allow_hyphen_values = true)]
    pub at: Option<f64>,
    /// Size of the frame in pixels
    #[arg(long, value_name = "WxH", allow_hyphen_values = true, value_parser = Size::parse,
        default_value = "540x1080")]
    pub size: Size,
    /// Resolution at which light is found: half is for small machines
    #[arg(long, value_enum, default_value_t = LightChoice::Full)]
    pub light: LightChoice,
    /// How much larger than the window the table is drawn, 1 to 4; the window follows the ball
    #[arg(long, value_name = "FACTOR", default_value_t = 1.0, value_parser = zoom, allow_hyphen_values = true)]
    pub zoom: f64,
    /// Threads that trace light; by default one for each core
    #[arg(long, value_name = "N", value_parser = threads, allow_hyphen_values = true)]
    pub threads: Option<usize>,
    /// How light is gathered: exact, or monte-carlo (the slow reference)
    #[arg(long, value_enum, default_value_t = Integrator::Exact)]
    pub integrator: Integrator,
    /// Random samples a lamp and pixel, with --integrator monte-carlo; by default 64
    #[arg(long, value_name = "N", allow_hyphen_values = true,
        value_parser = whole(1..=65536_u32))]
    pub samples: Option<u32>,
    /// The PNG file to write
    #[arg(long, value_name = "FILE.png", value_parser = OsStringValueParser::new().try_map(png_file))]
    pub out: PathBuf,
}

/// At which resolution light is found.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum LightChoice {
    /// At half the picture's.
    Half,
    /// At the picture's own.
    Full,
    /// In a window, at the picture's own while that holds the monitor's rate; elsewhere always.
    Auto,
}

/// How light is gathered.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Integrator {
    /// Exact soft shadows.
    Exact,
    /// Random points on each lamp.
    MonteCarlo,
}

/// `caustic simulate`
#[derive(Args, Debug, Clone)]
pub struct SimulateArgs {
    /// How many games
    #[arg(long, default_value_t = 20, value_name = "N", allow_hyphen_values = true,
        value_parser = whole(1..=1_000_000_u32))]
    pub games: u32,
    /// Seed of the first game; the others count up from it
    #[arg(long, default_value_t = 1, value_name = "N", allow_hyphen_values = true, value_parser = whole(0..=u64::MAX))]
    pub seed: u64,
    /// Longest time that one game may take, in minutes of play
    #[arg(long, default_value_t = 15.0, value_name = "M", value_parser = minutes, allow_hyphen_values = true)]
    pub minutes: f64,
    /// When a game is over begin another at once, on the same machine, until --minutes are played exactly
    #[arg(long)]
    pub again: bool,
    /// Also hash every tick and print one number for all of them: the same as `verify --digest` of the recordings
    #[arg(long)]
    pub digest: bool,
    /// A table's name, or the folder of one
    #[arg(long, default_value = "spectrum", value_name = "NAME|DIR", value_parser = NonEmptyStringValueParser::new())]
    pub table: String,
    /// A folder for recordings of games in which something went wrong
    #[arg(long, value_name = "DIR", value_parser = OsStringValueParser::new().try_map(folder))]
    pub save_failures: Option<PathBuf>,
    /// A folder for recordings of all the games
    #[arg(long, value_name = "DIR", value_parser = OsStringValueParser::new().try_map(folder))]
    pub save_all: Option<PathBuf>,
    /// Write over recordings that are in these folders already
    #[arg(long)]
    pub overwrite: bool,
    /// Who plays
    #[arg(long, value_enum, default_value_t = Player::Bot)]
    pub player: Player,
    /// Games that are played at once; by default one for each core
    #[arg(long, value_name = "N", value_parser = threads, allow_hyphen_values = true)]
    pub threads: Option<usize>,
}

/// Who plays a simulated game.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Player {
    /// The bot that traps, aims and shoots.
    Bot,
    /// Flips at random: what the bot is measured against.
    Random,
    /// The bot with two more players, every key and a tilt: for demonstrations.
    Tour,
}

/// `caustic check`
#[derive(Args, Debug, Clone)]
pub struct CheckArgs {
    /// A table's name, or the folder of one
    #[arg(value_name = "NAME|DIR", value_parser = NonEmptyStringValueParser::new())]
    pub table: String,
    /// Only read the table; do not play it
    #[arg(long)]
    pub quick: bool,
    /// Print all that was found as JSON
    #[arg(long)]
    pub json: bool,
    /// Threads that play; by default one for each core
    #[arg(long, value_name = "N", value_parser = threads, allow_hyphen_values = true)]
    pub threads: Option<usize>,
}

/// `caustic optics`
#[derive(Args, Debug, Clone)]
pub struct OpticsArgs {
    /// The scene, a JSON file of the ray-optics simulator
    #[arg(value_name = "SCENE.json")]
    pub scene: PathBuf,
    /// Print all that was measured as JSON
    #[arg(long)]
    pub json: bool,
}

impl Cli {
    /// What the command line of this process asks for. Ends the process with a sentence and exit code 2 if it is wrong,
    /// and with the answer if it only asks for help.
    pub fn read() -> Cli {
        let checked = |cli: Cli| match cli.check() {
            Ok(()) => Ok(cli),
            Err(wrong) => Err(Cli::command().error(ErrorKind::ValueValidation, wrong)),
        };
        Cli::try_parse().and_then(checked).unwrap_or_else(|error| usage_error::exit(&error))
    }

    /// What two words together may not say.
    fn check(&self) -> Result<(), String> {
        match &self.command {
            Some(Command::Dump(DumpArgs { from: Some(from), to: Some(to), .. })) if from > to => {
                Err(format!("--from {from} is after --to {to}; nothing is between them"))
            }
            Some(Command::Frame(FrameArgs { replay: None, at: Some(at), .. })) if *at > LONGEST_IDLE_S => Err(format!(
                "--at {at} is too late: a table that nobody plays is shown up to {LONGEST_IDLE_S} s after it was switched on"
            )),
            Some(Command::Frame(FrameArgs { integrator: Integrator::Exact, samples: Some(_), .. })) => {
                Err("--samples is for --integrator monte-carlo; exact light takes no samples".to_string())
            }
            Some(Command::Render(args)) => args.check(),
            Some(Command::Verify(VerifyArgs { files, salvage: Some(_), .. })) if files.len() != 1 => {
                Err("--salvage cuts one recording; name just one".to_string())
            }
            Some(Command::Verify(VerifyArgs { salvage: Some(out), .. })) if out.as_os_str() == "-" => {
                Err("--salvage writes a recording, and none to standard output: name a file for it".to_string())
            }
            Some(Command::Dump(DumpArgs { size, zoom, .. }) | Command::Frame(FrameArgs { size, zoom, .. })) => {
                check_zoomed(*size, *zoom)
            }
            _ => Ok(()),
        }
    }
}

impl LightChoice {
    /// The resolution that is asked for; `None` if it is to be chosen.
    pub fn resolution(self) -> Option<LightResolution> {
        match self {
            LightChoice::Half => Some(LightResolution::Half),
            LightChoice::Full => Some(LightResolution::Full),
            LightChoice::Auto => None,
        }
    }
}

/// What is wrong with a table drawn `zoom` times as large as a picture of this size.
fn check_zoomed(size: Size, zoom: f64) -> Result<(), String> {
    let side = |side: usize| (side as f64 * zoom) as usize;
    let Size { width, height } = size;
    if zoom == 1.0 || (Size { width: side(width), height: side(height) }).is_drawable() {
        return Ok(());
    }
    Err(format!("--zoom {zoom} of {width}x{height} pixels is more than can be drawn; give less of one of them"))
}

/// How long a table that nobody plays may have been on for its picture, s: all that comes is found within 20 s of computing.
const LONGEST_IDLE_S: f64 = 3600.0;
