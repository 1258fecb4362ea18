//! Why the evaluation of a node ended before its value was there.

use super::data::Data;
use std::sync::Arc;

/// What a node gives.
pub type Answer = Result<Data, Stop>;

/// Why a node has no value.
#[derive(Debug)]
pub enum Stop {
    /// Something is wrong.
    Failed(Box<Failed>),
    /// `break`, with the loop's value.
    Break(Data),
    /// `continue`.
    Continue,
    /// `return`, with the function's value.
    Return(Data),
}

/// What is wrong.
#[derive(Debug)]
pub struct Failed {
    /// A sentence, or what the script has thrown.
    pub what: Data,
    /// The line, from 1; 0 as long as nobody knows it.
    pub line: u32,
    /// What it is to the script.
    pub kind: FailureKind,
    /// Where in what the script remembers nothing stands, because of which it failed; `None` as long as nobody has looked.
    pub unset: Option<Vec<Arc<str>>>,
}

/// What a failure is to the script.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FailureKind {
    /// `try` may catch it.
    Catchable,
    /// The script has thrown it; `try` may catch it.
    Thrown,
    /// Calls nest too deep: no `try` is to go on from there.
    Final,
    /// No steps are left.
    Spent,
}

impl Stop {
    /// No steps are left.
    pub fn spent() -> Stop {
        Stop::Failed(Box::new(Failed { what: Data::Unit, line: 0, kind: FailureKind::Spent, unset: None }))
    }

    /// A failure that no `try` catches.
    pub fn last(what: &str) -> Stop {
        Stop::Failed(Box::new(Failed { what: Data::Text(what.into()), line: 0, kind: FailureKind::Final, unset: None }))
    }

    /// The script has thrown this.
    pub fn thrown(what: Data) -> Stop {
        Stop::Failed(Box::new(Failed { what, line: 0, kind: FailureKind::Thrown, unset: None }))
    }

    /// The same, on this line if none is known yet.
    pub fn at(mut self, line: u32) -> Stop {
        if let Stop::Failed(failed) = &mut self
            && failed.line == 0
        {
            failed.line = line;
        }
        self
    }
}

/// A failure that is told in this sentence.
pub fn fail(what: impl AsRef<str>) -> Stop {
    let what = Data::Text(what.as_ref().into());
    Stop::Failed(Box::new(Failed { what, line: 0, kind: FailureKind::Catchable, unset: None }))
}
