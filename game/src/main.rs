//! The command line of Caustic: parse, run, and say in one sentence what went wrong.

use std::process::ExitCode;

fn main() -> ExitCode {
    match game::commands::run(game::cli::Cli::read()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            game::tell(&failure);
            ExitCode::FAILURE
        }
    }
}
