//! Messages that a script says in so many words.

use super::facts::{Call, Facts};
use super::words::Words;
use crate::rules::script::{Kind, Node, Operator, Script};

/// A message of which something is known before play.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct KnownMessage {
    /// The script's line, from 1.
    pub line: usize,
    /// What each of the display's lines can be; nothing where that is not known.
    pub lines: Vec<Vec<String>>,
    /// What else of it stands in the script: pieces between values.
    pub pieces: Vec<String>,
    /// How long it stands, ms; 0 if it stays. Nothing where that is not known.
    pub ms: Option<u64>,
}

impl KnownMessage {
    /// All of it that is known.
    pub fn texts(&self) -> impl Iterator<Item = &String> {
        self.lines.iter().flatten().chain(&self.pieces)
    }
}

/// Every message of a script.
pub fn messages(facts: &Facts, script: &Script) -> Vec<KnownMessage> {
    facts.calls_of("message").filter_map(|call| message(call, script)).collect()
}

fn message(call: &Call, script: &Script) -> Option<KnownMessage> {
    let (ms, arguments) = call.arguments.split_last()?;
    let words = &call.words[..call.words.len() - 1];
    let texts = |words: &Words| words.literals.iter().map(ToString::to_string).collect();
    let mut pieces = Vec::new();
    let unknown = arguments.iter().zip(words).filter(|(_, words)| words.others);
    unknown.for_each(|(argument, _)| collect_pieces(argument, &mut pieces));
    let lines = words.iter().map(texts).collect();
    Some(KnownMessage { line: call.line as usize, lines, pieces, ms: number(ms, script) })
}

fn collect_pieces(node: &Node, pieces: &mut Vec<String>) {
    match &node.kind {
        Kind::Text(text) => pieces.push(text.to_string()),
        Kind::Joined(parts) => parts.iter().for_each(|part| collect_pieces(part, pieces)),
        Kind::Binary(Operator::Add, sides) => sides.iter().for_each(|side| collect_pieces(side, pieces)),
        Kind::If(parts) => parts[1..].iter().for_each(|part| collect_pieces(part, pieces)),
        Kind::Block(nodes) => nodes.last().into_iter().for_each(|last| collect_pieces(last, pieces)),
        _ => {}
    }
}

fn number(node: &Node, script: &Script) -> Option<u64> {
    let number = match &node.kind {
        Kind::Int(number) => *number,
        Kind::Constant(number) => script.constant_value(*number)?.number()?,
        _ => return None,
    };
    u64::try_from(number).ok()
}
