//! Usage errors: what is wrong with a command line, as one sentence.

use crate::{Failure, tell};
use clap::error::{Error, ErrorKind};

/// The exit code of a wrong command line.
const USAGE: i32 = 2;

/// Ends the process: with the answer to a question for help or for the version, else with the error's sentence on standard
/// error and exit code 2.
pub fn exit(error: &Error) -> ! {
    if matches!(error.kind(), ErrorKind::DisplayHelp | ErrorKind::DisplayVersion) {
        error.exit();
    }
    tell(&Failure::new(sentence(&error.render().to_string())));
    std::process::exit(USAGE);
}

/// The parser's explanation in one line: what is wrong, what it takes, its tips; not the usage that follows.
fn sentence(explanation: &str) -> String {
    let told = explanation.lines().take_while(|line| !line.starts_with("Usage:") && !line.starts_with("For more"));
    let words: Vec<&str> = told.flat_map(str::split_whitespace).collect();
    let told = words.join(" ").replace(" tip:", ";").replace(" [possible values:", "; [possible values:");
    format!("{}; caustic --help says more", told.strip_prefix("error: ").unwrap_or(&told))
}

#[cfg(test)]
mod tests {
    use super::sentence;
    use crate::cli::Cli;
    use clap::Parser;

    fn told(words: &[&str]) -> String {
        let error = Cli::try_parse_from([&["caustic"], words].concat()).expect_err("it is wrong");
        sentence(&error.render().to_string())
    }

    #[test]
    fn whatever_is_wrong_is_one_sentence() {
        assert_eq!(
            told(&["frame", "--out", "x.png", "--size", "-5x10"]),
            "invalid value '-5x10' for '--size <WxH>': write it as WIDTHxHEIGHT, for example 540x1080; caustic --help says more"
        );
        assert_eq!(
            told(&["replay", "a", "--light", "bright"]),
            "invalid value 'bright' for '--light <LIGHT>'; [possible values: half, full, auto]; caustic --help says more"
        );
        assert!(told(&["pla"]).starts_with("unrecognized subcommand 'pla'; some similar subcommands exist: '"));
        assert_eq!(
            told(&["frame"]),
            "the following required arguments were not provided: --out <FILE.png>; caustic --help says more"
        );
    }
}
