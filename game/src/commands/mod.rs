//! Commands: what each word of the command line does.

pub mod bench;
pub mod check;
pub mod dump;
pub mod frame;
pub mod optics;
pub mod parallel;
pub mod play;
pub mod plot;
mod print;
pub mod render;
pub mod replay;
pub mod simulate;
pub mod verify;
pub mod view;

use crate::Failure;
use crate::cli::{Cli, Command};

/// Runs what the command line asks for.
///
/// # Errors
/// One sentence that says what went wrong and what to do.
pub fn run(cli: Cli) -> Result<(), Failure> {
    match cli.command.unwrap_or(Command::Play(cli.play)) {
        Command::Play(args) => play::run(args),
        Command::Replay(args) => replay::run(&args),
        Command::Dump(args) => dump::run(&args),
        Command::Frame(args) => frame::run(&args),
        Command::Simulate(args) => simulate::run(&args),
        Command::Bench(args) => bench::run(&args),
        Command::Plot(args) => plot::run(&args),
        Command::Check(args) => check::run(&args),
        Command::Render(args) => render::run(&args),
        Command::View(args) => view::run(&args),
        Command::Optics(args) => optics::run(&args),
        Command::Verify(args) => verify::run(&args),
    }
}
