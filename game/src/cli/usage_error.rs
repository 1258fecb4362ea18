//! Usage errors: what is wrong with a command line, as one sentence.

use super::Cli;
use crate::storage::because;
use crate::{Failure, tell};
use clap::CommandFactory;
use clap::error::{Error, ErrorKind};
use std::io::{self, Write};

/// The exit code of a wrong command line.
const USAGE: i32 = 2;

/// The parser's words, and plain ones.
const WORDS: [(&str, &str); 11] = [
    (" tip:", ";"),
    ("; a similar argument exists:", "; did you mean"),
    ("; a similar subcommand exists:", "; did you mean"),
    ("; some similar subcommands exist:", "; did you mean one of"),
    (" [possible values:", "; [possible values:"),
    ("unrecognized subcommand", "there is no command"),
    ("unexpected argument", "nothing is known of the argument"),
    ("' found", "'"),
    ("the following required arguments were not provided:", "it needs more words:"),
    (" was supplied", " is there"),
    (
        "invalid UTF-8 was detected in one or more arguments",
        "an argument is no text in UTF-8: give the file or folder another name",
    ),
];

/// Ends the process: with the answer to a question for help or for the version, else with the error's sentence on standard
/// error and exit code 2.
pub fn exit(error: &Error) -> ! {
    if matches!(error.kind(), ErrorKind::DisplayHelp | ErrorKind::DisplayVersion) {
        std::process::exit(answer(error));
    }
    let asked = std::env::args_os().nth(1).unwrap_or_default();
    tell(&Failure::new(sentence(&error.render().to_string(), &asked.to_string_lossy())));
    std::process::exit(USAGE);
}

/// Prints help or the version; the exit code. Nothing is wrong when nobody reads on.
fn answer(error: &Error) -> i32 {
    match error.print().and_then(|()| io::stdout().flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
            tell(&Failure::new(format!("cannot write to standard output: {}", because(&error))));
            1
        }
        _ => 0,
    }
}

/// The parser's explanation in one line: what is wrong, what it takes, its tips; not the usage that follows. `asked` is the
/// first word of the command line.
fn sentence(explanation: &str, asked: &str) -> String {
    let told = explanation.lines().take_while(|line| !line.starts_with("Usage:") && !line.starts_with("For more"));
    let words: Vec<&str> = told.flat_map(str::split_whitespace).collect();
    let told = WORDS.iter().fold(words.join(" "), |told, (parser, plain)| told.replace(parser, plain));
    let is_command = Cli::command().get_subcommands().any(|command| command.get_name() == asked);
    let command = if is_command { format!("caustic {asked}") } else { "caustic".to_string() };
    format!("{}; {command} --help says more", told.strip_prefix("error: ").unwrap_or(&told))
}

#[cfg(test)]
mod tests {
    use super::sentence;
    use crate::cli::Cli;
    use clap::Parser;

    fn told(words: &[&str]) -> String {
        let error = Cli::try_parse_from([&["caustic"], words].concat()).expect_err("it is wrong");
        sentence(&error.render().to_string(), words[0])
    }

    #[test]
    fn whatever_is_wrong_is_one_sentence() {
        assert_eq!(
            told(&["frame", "--out", "x.png", "--size", "-5x10"]),
            "invalid value '-5x10' for '--size <WxH>': write it as WIDTHxHEIGHT, for example 540x1080; caustic frame --help says more"
        );
        assert_eq!(
            told(&["replay", "a", "--light", "bright"]),
            "invalid value 'bright' for '--light <LIGHT>'; [possible values: half, full, auto]; caustic replay --help says more"
        );
        for zoom in ["-inf", "nan", "-nan", "inf", "--fullscreen", "-1"] {
            let expected = format!("invalid value '{zoom}' for '--zoom <FACTOR>': it must be a number from 1 to 4");
            assert_eq!(told(&["play", "--zoom", zoom]), format!("{expected}; caustic play --help says more"));
            assert_eq!(told(&["--zoom", zoom]), format!("{expected}; caustic --help says more"));
        }
        assert_eq!(
            told(&["simulate", "--games", "many"]),
            "invalid value 'many' for '--games <N>': it must be a whole number from 1 to 1000000; caustic simulate --help says \
             more"
        );
        assert!(told(&["pla"]).starts_with("there is no command 'pla'; did you mean one of '"));
        assert!(
            told(&["--fullscren"]).starts_with("nothing is known of the argument '--fullscren'; did you mean '--full")
        );
        assert_eq!(
            told(&["dump", "a", "--out", "d.png"]),
            "invalid value 'd.png' for '--out <DIR|->': frames are written into a folder: name one (caustic frame writes one \
             picture); caustic dump --help says more"
        );
        assert!(told(&["frame", "--out", "picture"]).contains("pictures are written as PNG: name a .png file"));
        assert_eq!(told(&["frame"]), "it needs more words: --out <FILE.png>; caustic frame --help says more");
    }
}
