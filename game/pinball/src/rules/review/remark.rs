//! A remark: what is odd or wrong in a script, with its line.

/// What is odd or wrong.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Remark {
    /// The line, from 1; 0 where it is about the whole script.
    pub line: usize,
    /// What, and what to do.
    pub what: String,
    /// It may be meant so.
    pub is_warning: bool,
}

impl Remark {
    /// This is certainly wrong.
    pub fn error(line: usize, what: impl Into<String>) -> Remark {
        Remark { line, what: what.into(), is_warning: false }
    }

    /// This may be wrong.
    pub fn warning(line: usize, what: impl Into<String>) -> Remark {
        Remark { line, what: what.into(), is_warning: true }
    }
}

/// The line of a text that stands in quotes in the script, on this line or a little before it; else the first; else
/// this line.
pub fn line_of(quoted: &str, script: &str, near: u32) -> usize {
    let near = near as usize;
    let quoted = format!("\"{quoted}\"");
    let holds = script.lines().zip(1..).filter(|(line, _)| line.contains(&quoted)).map(|(_, number)| number);
    let lines: Vec<usize> = holds.collect();
    let before = lines.iter().rev().find(|line| **line <= near && **line + NEAR_LINES >= near);
    before.or(lines.first()).copied().unwrap_or(near)
}

/// The line on which a text in quotes stands that is used on this one, if it stands on one line alone, as in a constant.
pub fn written_line(quoted: &str, script: &str, used: usize) -> usize {
    let quoted = format!("\"{quoted}\"");
    let holds = |line: &str| line.split("//").next().is_some_and(|code| code.contains(&quoted));
    let mut lines = script.lines().zip(1..).filter(|(line, _)| holds(line)).map(|(_, number)| number);
    match (lines.next(), lines.next()) {
        (Some(only), None) => only,
        _ => used,
    }
}

/// A case and what it does stand no farther apart.
const NEAR_LINES: usize = 8;
