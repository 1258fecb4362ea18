//! The command line of Caustic: parse, run, and say in one sentence what went wrong.

use clap::Parser;
use std::process::ExitCode;

fn main() -> ExitCode {
    match game::commands::run(game::cli::Cli::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            eprintln!("caustic: {failure}");
            ExitCode::FAILURE
        }
    }
}
