//! Signatures: with what each function of the game can be called, as `assets/tables/README.md` tells it to table makers.

use super::part_commands::{Order, PART_COMMANDS};

/// What a value must be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Type {
    /// A text.
    Text,
    /// A whole number.
    Number,
    /// `true` or `false`.
    Flag,
}

/// A way to call a function: `lamp(name, mode)`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Signature {
    /// The function.
    pub function: &'static str,
    /// Its parameters, as they are written.
    parameters: &'static str,
}

/// Every way to call a function of the game that commands no part.
static SIGNATURES: [&str; 40] = [
    "score()",
    "score(points)",
    "scores()",
    "player()",
    "players()",
    "ball()",
    "playing()",
    "tilted()",
    "start_game(balls)",
    "add_player()",
    "next_player()",
    "game_over()",
    "tilt(on)",
    "max_players()",
    "message()",
    "message(line, ms)",
    "message(line, line, ms)",
    "progress(name, done, of)",
    "after(ms, timer)",
    "cancel(timer)",
    "running(timer)",
    "time_left(timer)",
    "now()",
    "random(n)",
    "exists(name)",
    "closed(name)",
    "balls_in_play()",
    "add_ball()",
    "flippers(on)",
    "kickers(on)",
    "lamp(name, mode)",
    "lamp(name, level)",
    "lamp(name, mode, period_ms)",
    "lamp(name, mode, period_ms, shift_ms)",
    "lamp_color(name)",
    "lamp_color(name, color)",
    "flash(name, ms)",
    "flash(name, ms, color)",
    "show(name, mode, period_ms, delay_ms, ms)",
    "show(name, mode, period_ms, delay_ms, ms, color)",
];

/// Parameters that are whole numbers, and that are `true` or `false`; the others are texts.
const NUMBERS: [&str; 10] = ["points", "balls", "ms", "done", "of", "n", "level", "period_ms", "shift_ms", "delay_ms"];
const FLAG: &str = "on";

/// The ways to call a function.
pub fn of(function: &str) -> impl Iterator<Item = Signature> {
    let own = SIGNATURES.iter().filter_map(|text| {
        let (function, parameters) = text.strip_suffix(')')?.split_once('(')?;
        Some(Signature { function, parameters })
    });
    let commands = PART_COMMANDS.iter().map(|command| {
        let parameters = if let Order::Switch(_) = command.order { "name, on" } else { "name" };
        Signature { function: command.word, parameters }
    });
    own.chain(commands).filter(move |signature| signature.function == function)
}

/// The ways to call a function as a person writes them: `` `score()` or `score(points)` ``.
pub fn all_of(function: &str) -> String {
    written(of(function))
}

/// Ways to call a function as a person writes them.
pub fn written(signatures: impl Iterator<Item = Signature>) -> String {
    let own = signatures.map(|Signature { function, parameters }| format!("`{function}({parameters})`"));
    own.collect::<Vec<_>>().join(" or ")
}

impl Signature {
    /// The names of the parameters.
    pub fn parameters(self) -> impl Iterator<Item = &'static str> {
        self.parameters.split(", ").filter(|name| !name.is_empty())
    }
}

/// What a parameter of this name must be.
pub fn type_of(parameter: &str) -> Type {
    match parameter {
        FLAG => Type::Flag,
        name if NUMBERS.contains(&name) => Type::Number,
        _ => Type::Text,
    }
}

impl Type {
    /// As it stands in a sentence.
    pub fn word(self) -> &'static str {
        match self {
            Type::Text => "a text",
            Type::Number => "a whole number",
            Type::Flag => "`true` or `false`",
        }
    }
}
