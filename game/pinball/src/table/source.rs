//! A text file and its diagnostics: what is wrong, at which line.
//!
//! Refuses to know what the text means.

use crate::Failure;
use std::fmt;

/// Mistakes that are worth reading at once.
const MAX_REPORTED: usize = 100;

/// What people should see as the path of the file `name` of a table from `origin`.
pub(super) fn path(origin: &str, name: &str) -> String {
    if origin.is_empty() || origin.ends_with('/') { format!("{origin}{name}") } else { format!("{origin}/{name}") }
}

/// A diagnostic: what is wrong, and where. Diagnostics sort by file and line, mistakes before warnings.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Diagnostic {
    /// The table can be played all the same.
    is_warning: bool,
    path: String,
    /// From 1; 0 for the file as a whole.
    line: usize,
    what: String,
}

impl Diagnostic {
    /// A diagnostic of a file as a whole.
    pub fn of_file(path: impl fmt::Display, what: impl fmt::Display) -> Diagnostic {
        Diagnostic { is_warning: false, path: path.to_string(), line: 0, what: what.to_string() }
    }

    /// Whether the table can be played all the same.
    pub fn is_warning(&self) -> bool {
        self.is_warning
    }

    /// Whether another is of the same place, and says no more than the beginning of this one.
    pub fn says_more_than(&self, other: &Diagnostic) -> bool {
        (&self.path, self.line) == (&other.path, other.line) && self.what.starts_with(&other.what)
    }

    /// Whether these words are in it.
    pub fn says(&self, words: &str) -> bool {
        self.what.contains(words)
    }

    /// The same as a mistake.
    pub fn into_mistake(self) -> Diagnostic {
        Diagnostic { is_warning: false, ..self }
    }

    /// The same as a warning.
    pub fn into_warning(self) -> Diagnostic {
        Diagnostic { is_warning: true, ..self }
    }

    /// The same as a sentence for a person.
    pub fn failure(&self) -> Failure {
        let sentence = self.to_string();
        if self.is_warning { Failure::warning(sentence) } else { Failure::new(sentence) }
    }
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Diagnostic { path, line: 0, what, .. } => write!(formatter, "{path}: {what}"),
            Diagnostic { path, line, what, .. } => write!(formatter, "{path}:{line}: {what}"),
        }
    }
}

/// The diagnostics as sentences, by file and line.
pub(in crate::table) fn failures(mut diagnostics: Vec<Diagnostic>) -> Vec<Failure> {
    diagnostics.sort();
    diagnostics.dedup();
    let mut failures: Vec<Failure> = diagnostics.iter().take(MAX_REPORTED).map(Diagnostic::failure).collect();
    if diagnostics.len() > MAX_REPORTED {
        let rest = &diagnostics[MAX_REPORTED..];
        let mistakes = rest.iter().filter(|diagnostic| !diagnostic.is_warning()).count();
        let more = format!("and {mistakes} more mistakes and {} more warnings", rest.len() - mistakes);
        failures.push(if mistakes > 0 { Failure::new(more) } else { Failure::warning(more) });
    }
    failures
}

/// What bytes are that begin as no text in UTF-8 does, and what to do, for a drawing or for another text.
fn other_than_text(path: &str, bytes: &[u8]) -> Option<&'static str> {
    let utf_16 = "this is text in UTF-16; save the file as UTF-8";
    let either = |drawing, other| Some(if path.ends_with(".svg") { drawing } else { other });
    match bytes {
        [0x1f, 0x8b, ..] => either(
            "it is compressed, as an .svgz is; unpack it, or save it as plain SVG",
            "it is compressed with gzip; unpack it: here plain text belongs",
        ),
        [b'P', b'K', 3, 4, ..] => Some("it is a zip archive; unpack it"),
        [0xff, 0xfe, ..] | [0xfe, 0xff, ..] | [0, b'<', ..] | [b'<', 0, ..] => Some(utf_16),
        [0x89, b'P', b'N', b'G', ..] | [0xff, 0xd8, 0xff, ..] => {
            either("it is a picture of pixels; draw it as SVG", "it is a picture, and here plain text belongs")
        }
        [b'%', b'P', b'D', b'F', ..] => {
            either("it is a PDF; save the drawing as plain SVG", "it is a PDF, and here plain text belongs")
        }
        _ => None,
    }
}

/// The text of the file called `path`, which holds `bytes`.
///
/// # Errors
/// If that is no text in UTF-8: what it is, and what to do.
pub fn text(path: &str, bytes: Vec<u8>) -> Result<String, Failure> {
    let source = Source::read(path.to_string(), Ok(bytes), u64::MAX);
    source.map(|source| source.text).map_err(|diagnostic| diagnostic.failure())
}

/// A text file that has been read whole.
#[derive(Clone, Debug)]
pub(super) struct Source {
    /// The path as people should see it.
    pub path: String,
    /// All of it.
    pub text: String,
    /// Where each line begins.
    lines: Vec<usize>,
}

impl Source {
    /// The text of the file called `path`, which holds `bytes`, if that is UTF-8 text of at most `limit` bytes.
    pub fn read(path: String, bytes: Result<Vec<u8>, String>, limit: u64) -> Result<Source, Diagnostic> {
        let bytes = bytes.map_err(|why| Diagnostic::of_file(&path, why))?;
        if bytes.len() as u64 > limit {
            let why = format!("it is larger than {} kB, the most that a table may have", limit / 1024);
            return Err(Diagnostic::of_file(path, why));
        }
        if let Some(why) = other_than_text(&path, &bytes) {
            return Err(Diagnostic::of_file(path, why));
        }
        Source::from_bytes(path, bytes)
    }

    fn from_bytes(path: String, bytes: Vec<u8>) -> Result<Source, Diagnostic> {
        String::from_utf8(bytes).map(|text| Source::new(path.clone(), text)).map_err(|error| {
            let good = error.utf8_error().valid_up_to();
            let line = 1 + error.as_bytes()[..good].iter().filter(|&&byte| byte == b'\n').count();
            Diagnostic {
                is_warning: false,
                path,
                line,
                what: "this is not UTF-8 text; save the file as UTF-8".to_string(),
            }
        })
    }

    /// A text that came from `path`.
    pub fn new(path: String, text: String) -> Source {
        let after = text.bytes().enumerate().filter(|&(_, byte)| byte == b'\n').map(|(at, _)| at + 1);
        let lines = std::iter::once(0).chain(after).collect();
        Source { path, text, lines }
    }

    /// The line, from 1, of the byte at `at`.
    pub fn line(&self, at: usize) -> usize {
        self.lines.partition_point(|&start| start <= at)
    }

    /// A diagnostic in the line of the byte at `at`.
    pub fn diagnostic(&self, at: usize, what: impl fmt::Display) -> Diagnostic {
        self.diagnostic_in_line(self.line(at), what)
    }

    /// A diagnostic in a line, from 1.
    pub fn diagnostic_in_line(&self, line: usize, what: impl fmt::Display) -> Diagnostic {
        Diagnostic { is_warning: false, path: self.path.clone(), line, what: what.to_string() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_count_from_one() {
        let source = Source::new("a".to_string(), "one\ntwo\n\nfour".to_string());
        let lines: Vec<usize> = [0, 3, 4, 8, 9, 12].into_iter().map(|at| source.line(at)).collect();
        assert_eq!(lines, [1, 1, 2, 3, 4, 4]);
    }

    #[test]
    fn bytes_that_are_not_text_are_found() {
        let failure = Source::from_bytes("a.svg".to_string(), b"one\ntw\xffo".to_vec()).unwrap_err();
        assert_eq!(failure.to_string(), "a.svg:2: this is not UTF-8 text; save the file as UTF-8");
    }
}
