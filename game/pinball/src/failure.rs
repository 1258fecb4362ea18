//! Failure: what went wrong, as a sentence for a person.

use std::{error, fmt};

/// Plain sentences, usually one: what went wrong, where, and what to do.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Failure(Vec<Sentence>);

#[derive(Clone, Debug, PartialEq, Eq)]
struct Sentence {
    text: String,
    is_warning: bool,
}

impl Failure {
    /// The failure that this sentence tells.
    pub fn new(sentence: impl Into<String>) -> Failure {
        Failure(vec![Sentence { text: shortened(sentence.into()), is_warning: false }])
    }

    /// The warning that this sentence tells: something is odd, and nothing has failed.
    pub fn warning(sentence: impl Into<String>) -> Failure {
        Failure(vec![Sentence { text: shortened(sentence.into()), is_warning: true }])
    }

    /// Whether nothing has failed.
    pub fn is_warning(&self) -> bool {
        self.0.iter().all(|sentence| sentence.is_warning)
    }

    /// All of `failures` as one, in their order.
    pub fn of_many(failures: Vec<Failure>) -> Failure {
        Failure(failures.into_iter().flat_map(|failure| failure.0).collect())
    }

    /// Each of its sentences as a failure of its own.
    pub fn into_each(self) -> impl Iterator<Item = Failure> {
        self.0.into_iter().map(|sentence| Failure(vec![sentence]))
    }

    /// The same failure, with the name of the file that it is about before it: `line 5: ...` becomes `FILE:5: ...`.
    pub fn in_file(mut self, file: impl fmt::Display) -> Failure {
        if let Some(Sentence { text, .. }) = self.0.first_mut() {
            let placed = text.strip_prefix("line ").and_then(|rest| rest.split_once(": "));
            let placed = placed.filter(|(line, _)| line.parse::<usize>().is_ok());
            *text = match placed {
                Some((line, what)) => format!("{file}:{line}: {what}"),
                None => format!("{file}: {text}"),
            };
        }
        self
    }

    /// The sentences, each of which is told in a line of its own. What they quote may itself hold line breaks.
    pub fn sentences(&self) -> impl Iterator<Item = String> {
        self.0.iter().map(Sentence::to_string)
    }
}

/// Characters of a quote that are enough to find it.
const MAX_QUOTE: usize = 100;
/// Characters of a word outside of quotes, as an id before what is wrong with the thing; a path may be longer.
const MAX_WORD: usize = 200;
/// Characters of a sentence that anybody reads.
const MAX_SENTENCE: usize = 2000;

/// A sentence of which every quote in `backticks` and every word is as long as one can read: a file may have one of a
/// megabyte.
fn shortened(sentence: String) -> String {
    if sentence.len() <= MAX_QUOTE {
        return sentence;
    }
    let pieces = sentence.split('`').enumerate();
    let pieces: Vec<String> = pieces
        .map(|(at, piece)| if at % 2 == 1 { beginning(piece, MAX_QUOTE) } else { in_short_words(piece) })
        .collect();
    beginning(&pieces.join("`"), MAX_SENTENCE)
}

/// A text whose words are as long as one can read.
fn in_short_words(text: &str) -> String {
    let short = |word: &str| match word.contains(['/', '\\']) {
        true => word.to_string(),
        // What follows a name is separated from it all the same.
        false if word.len() > MAX_WORD && word.ends_with(':') => beginning(word, MAX_WORD) + ":",
        false => beginning(word, MAX_WORD),
    };
    text.split(' ').map(short).collect::<Vec<_>>().join(" ")
}

/// The beginning of a text, and dots for what is left out.
fn beginning(text: &str, most: usize) -> String {
    match text.char_indices().nth(most) {
        Some((end, _)) => format!("{}...", &text[..end]),
        None => text.to_string(),
    }
}

impl fmt::Display for Sentence {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let kind = if self.is_warning { "warning: " } else { "" };
        write!(formatter, "{kind}{}", self.text)
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.sentences().collect::<Vec<_>>().join("\n"))
    }
}

impl error::Error for Failure {}

#[cfg(test)]
mod tests {
    use super::*;

    /// A table whose part was of a kind of a megabyte filled the terminal with it.
    #[test]
    fn quotes_from_files_are_cut_and_what_is_said_of_them_is_not() {
        let long = "\u{e4}".repeat(1 << 20);
        let told = Failure::new(format!("there is no `{long}` here; write `wall`")).to_string();
        assert_eq!(told, format!("there is no `{}...` here; write `wall`", "\u{e4}".repeat(100)));
        assert!(Failure::warning(long).to_string().chars().count() < 2100);
        let named = Failure::new(format!("assets/tables/a/table.svg:7: {}: it has no length", "a".repeat(3 << 20)));
        assert_eq!(named.to_string(), format!("assets/tables/a/table.svg:7: {}...: it has no length", "a".repeat(200)));
        let path = format!("{}: there is no such file", "/folder".repeat(200));
        assert_eq!(Failure::new(&path).to_string(), path);
        let plain = "the class `sling-shot` means nothing; ".repeat(4);
        assert_eq!(Failure::new(&plain).to_string(), plain);
    }
}
