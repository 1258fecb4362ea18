//! Failure: what went wrong, as one sentence for a person.

use std::{error, fmt};

/// One plain sentence: what went wrong, where, and what to do.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Failure {
    sentence: String,
    is_warning: bool,
}

impl Failure {
    /// The failure that this sentence tells.
    pub fn new(sentence: impl Into<String>) -> Failure {
        Failure { sentence: sentence.into(), is_warning: false }
    }

    /// The warning that this sentence tells: something is odd, and nothing has failed.
    pub fn warning(sentence: impl Into<String>) -> Failure {
        Failure { sentence: sentence.into(), is_warning: true }
    }

    /// Whether nothing has failed.
    pub fn is_warning(&self) -> bool {
        self.is_warning
    }

    /// All of `failures` as one, a line each.
    pub fn of_many(failures: Vec<Failure>) -> Failure {
        Failure::new(failures.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n"))
    }

    /// The same failure, with the name of the file that it is about before it.
    pub fn in_file(self, file: impl fmt::Display) -> Failure {
        Failure { sentence: format!("{file}: {}", self.sentence), ..self }
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let kind = if self.is_warning { "warning: " } else { "" };
        write!(formatter, "{kind}{}", self.sentence)
    }
}

impl error::Error for Failure {}
