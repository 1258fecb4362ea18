//! The report of `caustic check`, as lines for a person and as data.

use crate::table::{FILES, LampKind};
use crate::{Failure, Table};
use serde_json::{Value, json};
use std::sync::Arc;

/// What was found about a table.
pub struct Report {
    name: String,
    /// The table, if it could be read.
    pub table: Option<Arc<Table>>,
    /// Errors and warnings.
    pub found: Vec<Failure>,
    /// What its art costs to print, million operations, if it can be printed.
    pub print_mops: Option<f64>,
    /// How many balls were let go, and the bot's score, if it was played.
    pub play: Option<(usize, i64)>,
}

impl Report {
    /// Nothing is known yet about the table that the command line calls `name`.
    pub fn new(name: &str) -> Report {
        Report { name: name.to_string(), table: None, found: Vec::new(), print_mops: None, play: None }
    }

    /// How many mistakes there are.
    pub fn errors(&self) -> usize {
        self.found.iter().filter(|failure| !failure.is_warning()).count()
    }

    /// `2 errors, 1 warning`
    pub fn counts(&self) -> String {
        counts(self.errors(), self.found.len() - self.errors())
    }

    /// The line of a good table.
    pub fn summary(&self) -> String {
        let Some(table) = &self.table else { return format!("nothing is known of {}", self.name) };
        let (lamps, inserts) = lamps(table);
        let play = self.play.map(|(places, score)| format!(" places={places} bot_score={score}"));
        format!(
            "ok {} title={:?} size_mm={}x{} parts={} lamps={lamps} inserts={inserts} solids={} warnings={} \
             print_mops={:.0}{} hash={:016x}",
            self.name,
            table.title,
            hundredths(table.size_mm.x),
            hundredths(table.size_mm.y),
            table.layout.parts.len(),
            table.solids.len(),
            self.found.len(),
            self.print_mops.unwrap_or_default(),
            play.unwrap_or_default(),
            table.hash
        )
    }

    /// All of it as one JSON object.
    pub fn json(&self) -> String {
        let told = |warnings: bool| -> Vec<Value> {
            let own = self.found.iter().filter(|failure| failure.is_warning() == warnings);
            own.flat_map(Failure::sentences).map(|sentence| self.placed(&sentence)).collect()
        };
        let mut all = json!({
            "table": self.name,
            "ok": self.errors() == 0,
            "errors": told(false),
            "warnings": told(true),
            "print_mops": self.print_mops,
            "play": self.play.map(|(places, score)| json!({ "places": places, "bot_score": score })),
        });
        if let (Some(table), Value::Object(object)) = (&self.table, &mut all) {
            let (lamps, inserts) = lamps(table);
            object.insert("title".into(), json!(table.title));
            object.insert("size_mm".into(), json!([hundredths(table.size_mm.x), hundredths(table.size_mm.y)]));
            object.insert("parts".into(), json!(table.layout.parts.len()));
            object.insert("lamps".into(), json!(lamps));
            object.insert("inserts".into(), json!(inserts));
            object.insert("solids".into(), json!(table.solids.len()));
            object.insert("hash".into(), json!(format!("{:016x}", table.hash)));
        }
        ascii(&format!("{all:#}"))
    }

    /// A sentence taken apart: its file and line, if it says them, and what it says.
    fn placed(&self, sentence: &str) -> Value {
        let said = sentence.strip_prefix("warning: ").unwrap_or(sentence);
        for file in FILES {
            let Some((path, rest)) = said.split_once(file).filter(|(path, _)| !path.contains(": ")) else { continue };
            let path = format!("{path}{file}");
            let Some(rest) = rest.strip_prefix(':') else { continue };
            let line = rest.split_once(": ").and_then(|(line, what)| Some((line.parse::<usize>().ok()?, what)));
            return match line {
                Some((line, what)) => json!({ "file": path, "line": line, "message": what }),
                None => json!({ "file": path, "line": null, "message": rest.trim_start() }),
            };
        }
        json!({ "file": null, "line": null, "message": said })
    }
}

/// JSON that says the same in letters that every terminal takes.
fn ascii(json: &str) -> String {
    let each = json.chars().map(|c| {
        let mut units = [0; 2];
        let is_plain = c == '\n' || (' '..='~').contains(&c);
        match is_plain {
            true => c.to_string(),
            false => c.encode_utf16(&mut units).iter().map(|unit| format!("\\u{unit:04x}")).collect(),
        }
    });
    each.collect()
}

/// How many lamps stand on the table, and how many windows are in its floor.
fn lamps(table: &Table) -> (usize, usize) {
    let bulbs = table.lamps.iter().filter(|lamp| matches!(lamp.kind, LampKind::Bulb { .. })).count();
    (bulbs, table.lamps.len() - bulbs)
}

/// A length to a hundredth of a millimetre.
fn hundredths(mm: f64) -> f64 {
    (mm * 100.0).round() / 100.0
}

/// `2 errors, 1 warning`
pub fn counts(errors: usize, warnings: usize) -> String {
    let several = |count: usize, what: &str| format!("{count} {what}{}", if count == 1 { "" } else { "s" });
    let counts = [(errors, "error"), (warnings, "warning")];
    let counts: Vec<String> = counts.iter().filter(|one| one.0 > 0).map(|one| several(one.0, one.1)).collect();
    counts.join(", ")
}

/// One sentence a line; below several stands how many there are.
pub fn counted(mut found: Vec<Failure>) -> Failure {
    let warnings = found.iter().filter(|failure| failure.is_warning()).count();
    if found.len() > 1 {
        found.push(Failure::new(counts(found.len() - warnings, warnings)));
    }
    Failure::of_many(found)
}
