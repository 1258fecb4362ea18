//! Messages that the display cannot show as they are meant: too wide for their time, or with letters that it has no dots for.

use crate::hud;
use crate::rules::KnownMessage;
use crate::table::FILES;
use crate::{Failure, Table};
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

/// Lines that have no time to walk past.
fn hurried(message: &KnownMessage) -> Vec<String> {
    let Some(ms) = message.ms.filter(|ms| *ms > 0) else { return Vec::new() };
    let line = |(index, text): (usize, &String)| {
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
