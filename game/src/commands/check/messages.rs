//! Messages that the display cannot show as they are meant: too wide for their time, or with letters that it has no dots for.

use crate::hud;
use crate::rules::KnownMessage;
use crate::table::FILES;
use crate::{Failure, Table};
use pinball::bot::message_log::ShownMessage;
use std::collections::BTreeSet;

/// A warning for each message whose reader would miss something.
pub fn warnings(messages: &[KnownMessage], table: &Table) -> Vec<Failure> {
    let file = table.file(FILES[2]);
    let all = messages.iter().flat_map(|message| {
        let own = hurried(message).into_iter().chain(blank_letters(message));
        own.map(|what| (message.line, what))
    });
    let all: BTreeSet<(usize, String)> = all.collect();
    all.into_iter().map(|(line, what)| Failure::warning(format!("{file}:{line}: {what}"))).collect()
}

/// The same of what was shown in play, where the script builds it: each place of the script once.
pub fn shown(messages: &[ShownMessage], known: &[KnownMessage], table: &Table) -> Vec<Failure> {
    let file = table.file(FILES[2]);
    let mut told = BTreeSet::new();
    let mut found = Vec::new();
    for ShownMessage { lines, ms } in messages {
        let texts = || lines.iter();
        // What stands in the script as it is was told with its line.
        let is_known =
            |text: &String| known.iter().any(|message| message.lines.iter().flatten().any(|one| one == text));
        let is_built_of = |message: &&KnownMessage| {
            let is_in = |piece: &String| texts().any(|text| text.contains(piece.as_str()));
            !message.pieces.is_empty() && message.pieces.iter().all(is_in)
        };
        let line = known.iter().find(is_built_of).map(|message| message.line);
        let own = lines.iter().map(|text| if is_known(text) { Vec::new() } else { vec![text.clone()] }).collect();
        let message = KnownMessage { line: 0, lines: own, pieces: Vec::new(), ms: Some(*ms) };
        for what in hurried(&message) {
            // Numbers in it are others each time.
            let gist: String = what.chars().filter(|letter| !letter.is_ascii_digit()).collect();
            if told.insert(line.map_or((None, gist), |line| (Some(line), String::new()))) {
                let place = line.map_or_else(|| file.clone(), |line| format!("{file}:{line}"));
                found.push(Failure::warning(format!("{place}: {what}")));
            }
        }
    }
    found.truncate(MOST_SHOWN);
    found
}

/// No shorter message is read, ms: an eye rests on a word for about a quarter of a second (K. Rayner, "Eye movements in reading and
/// information processing", Psychological Bulletin 124(3), 1998).
const LEAST_MS: u64 = 250;

/// Built messages that are told.
const MOST_SHOWN: usize = 20;

/// Lines that have no time to walk past.
fn hurried(message: &KnownMessage) -> Vec<String> {
    let Some(ms) = message.ms.filter(|ms| *ms > 0) else { return Vec::new() };
    let line = |(index, text): (usize, &String)| {
        if ms < LEAST_MS && !text.trim().is_empty() {
            return Some(format!(
                "the message `{text}` is gone after {ms} ms, before anybody has read it: give it {LEAST_MS} ms at least"
            ));
        }
        let lines: Vec<&str> = std::iter::repeat_n("", index).chain([text.as_str()]).collect();
        let needed = hud::reading_ms(&lines).filter(|needed| ms < *needed)?;
        Some(format!(
            "the message `{text}` is wider than the display and hurries past in its {ms} ms: give it {needed} ms, or fewer \
             letters"
        ))
    };
    let lines = message.lines.iter().enumerate();
    lines.flat_map(|(index, texts)| texts.iter().map(move |text| (index, text))).filter_map(line).collect()
}

/// Letters that the display leaves dark.
fn blank_letters(message: &KnownMessage) -> Vec<String> {
    let letters = |text: &String| -> Option<String> {
        let blank: BTreeSet<char> = text.chars().filter(|letter| !hud::has_dots(*letter)).collect();
        let blank: Vec<String> = blank.iter().map(|letter| format!("`{letter}`")).collect();
        let blank = blank.join(", ");
        (!blank.is_empty())
            .then(|| format!("the display has no dots for {blank} of the message `{text}`: it leaves a gap there"))
    };
    message.texts().filter_map(letters).collect()
}
