//! Kinds of files: what a table's file holds where something else belongs.

use super::parse::FILES;
use super::source::{Diagnostic, Source};

/// What a text is by its look.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum FileKind {
    Drawing,
    Numbers,
    Rules,
    WebPage,
    Json,
}

impl FileKind {
    /// What each of [`FILES`] is to hold.
    const WANTED: [FileKind; 3] = [FileKind::Drawing, FileKind::Numbers, FileKind::Rules];

    /// What a text is, where that is sure.
    fn of(text: &str) -> Option<FileKind> {
        let begin = text.trim_start_matches('\u{feff}').trim_start();
        if begin.starts_with('<') {
            let head: String = begin.chars().take(200).collect::<String>().to_ascii_lowercase();
            let head =
                head.strip_prefix("<?xml").and_then(|rest| rest.split_once("?>")).map_or(&*head, |(_, rest)| rest);
            let is_page = ["<!doctype html", "<html"].iter().any(|tag| head.trim_start().starts_with(tag));
            return Some(if is_page { FileKind::WebPage } else { FileKind::Drawing });
        }
        let has_line = |is: fn(&str) -> bool| text.lines().any(is);
        let is_function = |line: &str| line.starts_with("fn ") && line.contains('(');
        let is_table =
            |line: &str| ["[material.", "[finish.", "[class.", "[part."].iter().any(|tag| line.starts_with(tag));
        match (has_line(is_function), has_line(is_table)) {
            (true, false) => Some(FileKind::Rules),
            (false, true) => Some(FileKind::Numbers),
            _ => {
                begin.strip_prefix('{').is_some_and(|rest| rest.trim_start().starts_with('"')).then_some(FileKind::Json)
            }
        }
    }

    /// With the word for it.
    fn held(self) -> &'static str {
        match self {
            FileKind::Drawing => "a drawing (SVG)",
            FileKind::Numbers => "a table's numbers (TOML)",
            FileKind::Rules => "rules (Rhai)",
            FileKind::WebPage => "a web page (HTML)",
            FileKind::Json => "JSON",
        }
    }
}

/// What is wrong with the file of this place among [`FILES`] if it holds what belongs elsewhere: whatever else were said
/// of it would come of that.
pub(super) fn mistaken(source: &Source, file: usize) -> Option<Diagnostic> {
    let wanted = FileKind::WANTED[file];
    let found = FileKind::of(&source.text).filter(|found| *found != wanted)?;
    // Of what a drawing must begin with its own sentence is told.
    let home = FileKind::WANTED.iter().position(|kind| *kind == found).map(|home| FILES[home]);
    let advice = match (home, wanted) {
        (Some(home), _) => format!("that is {home}'s; give each file the name of what is in it"),
        (None, FileKind::Drawing) => "save the drawing alone, as plain SVG".to_string(),
        (None, FileKind::Numbers) => "numbers are written NAME = VALUE, below a [TABLE]".to_string(),
        (None, _) => "write them as functions, as `fn on_start() { ... }`".to_string(),
    };
    let belongs = match wanted {
        FileKind::Drawing => "a drawing (SVG) belongs",
        FileKind::Numbers => "the table's numbers (TOML) belong",
        _ => "the rules (Rhai) belong",
    };
    Some(source.diagnostic(0, format!("{} is in it, and {belongs} here; {advice}", found.held())))
}
