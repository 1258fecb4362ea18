//! A text file and where in it a mistake is.
//!
//! Refuses to know what the text means.

use crate::Failure;
use std::io::Read;
use std::path::Path;

/// A text file that has been read whole.
#[derive(Debug)]
pub(super) struct Source {
    /// The path as people should see it.
    pub path: String,
    /// All of it.
    pub text: String,
    /// Where each line begins.
    lines: Vec<usize>,
}

impl Source {
    /// Reads the file if it is UTF-8 text of at most `limit` bytes.
    pub fn read(path: &Path, limit: u64) -> Result<Source, Failure> {
        let shown = path.display();
        let fail = |why: String| Failure::new(format!("{shown}: {why}"));
        let file = std::fs::File::open(path).map_err(|error| match error.kind() {
            std::io::ErrorKind::NotFound => fail("there is no such file, and a table needs it".to_string()),
            _ => fail(format!("it cannot be opened: {error}")),
        })?;
        let mut bytes = Vec::new();
        file.take(limit + 1).read_to_end(&mut bytes).map_err(|error| fail(format!("it cannot be read: {error}")))?;
        if bytes.len() as u64 > limit {
            return Err(fail(format!("it is larger than {} kB, the most that a table may have", limit / 1024)));
        }
        Source::from_bytes(shown.to_string(), bytes)
    }

    fn from_bytes(path: String, bytes: Vec<u8>) -> Result<Source, Failure> {
        String::from_utf8(bytes).map(|text| Source::new(path.clone(), text)).map_err(|error| {
            let good = error.utf8_error().valid_up_to();
            let line = 1 + error.as_bytes()[..good].iter().filter(|&&byte| byte == b'\n').count();
            Failure::new(format!("{path}:{line}: this is not UTF-8 text; save the file as UTF-8"))
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

    /// A mistake in the line of the byte at `at`.
    pub fn mistake(&self, at: usize, what: impl std::fmt::Display) -> Failure {
        self.mistake_in_line(self.line(at), what)
    }

    /// A mistake in a line, from 1.
    pub fn mistake_in_line(&self, line: usize, what: impl std::fmt::Display) -> Failure {
        Failure::new(format!("{}:{line}: {what}", self.path))
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
