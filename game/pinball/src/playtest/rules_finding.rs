//! What the rules leave out, as a sentence with the line of the function that it is missing in.

use super::finding::{Finding, FindingKind};
use crate::Table;
use crate::rules::NO_START;
use crate::table::FILES;
use physics::PartId;

/// Place and sentence of what is the rules' fault alone; none of other findings.
pub fn told(finding: &Finding, table: &Table) -> Option<(String, String)> {
    let (function, sentence) = match finding.kind {
        FindingKind::NoGame => (
            "on_button",
            "no game begins when start is pressed; where `on_button(name)` hears \"start\" and no game is on, call \
             `start_game(3)` and `add_ball()`"
                .to_string(),
        ),
        FindingKind::NoStart => (
            "on_button",
            NO_START.to_string(),
        ),
        FindingKind::BeginsAnew => (
            "start_game",
            "a game begins while a ball of another is in play, and the players' points are gone; ask `!playing()` before \
             `start_game`"
                .to_string(),
        ),
        FindingKind::NoBall => (
            "on_button",
            "a game begins and no ball comes for 14 s, until the ball search gives one; call `add_ball()` behind \
             `start_game`"
                .to_string(),
        ),
        FindingKind::NoNextGame => (
            "on_button",
            "the first game is over and no press of start begins another for 25 s; see what `on_button(name)` asks before \
             it calls `start_game`"
                .to_string(),
        ),
        _ => match of_ball_in_play(finding) {
            Some(told) => told,
            None => ("on_switch", of_lost_ball(finding, table)?),
        },
    };
    let line = match finding.kind {
        FindingKind::BeginsAnew => line_with(function, &table.rules),
        FindingKind::AlwaysTilted => line_with("tilt(true)", &table.rules).or_else(|| line_of(function, &table.rules)),
        FindingKind::FlippersDieAtLaunch => {
            line_of(function, &table.rules).or_else(|| line_with("flippers(false)", &table.rules))
        }
        _ => line_of(function, &table.rules),
    };
    let line = line.map_or_else(String::new, |line| format!(":{line}"));
    Some((format!("{}{line}", table.file(FILES[2])), sentence))
}

/// What the rules do wrong with a ball in play, and the function that it is about.
fn of_ball_in_play(finding: &Finding) -> Option<(&'static str, String)> {
    let count = finding.count;
    Some(match finding.kind {
        FindingKind::DeadFlippers => (
            "on_button",
            format!(
                "the flippers are dead while ball {count} of a game is in play; call `flippers(true)` where a game or a \
                 ball begins"
            ),
        ),
        FindingKind::DeadKickers => (
            "on_button",
            format!(
                "bumpers, slingshots and their like do nothing while ball {count} of a game is in play; call \
                 `kickers(true)` where a game or a ball begins"
            ),
        ),
        FindingKind::FlippersDieAtLaunch => (
            "on_launch",
            format!(
                "the flippers are live while ball {count} of a game waits at the plunger, and dead when it has been shot; call \
                 `flippers(false)` only where a game is over"
            ),
        ),
        FindingKind::AlwaysTilted => (
            "on_button",
            format!(
                "the machine is tilted as long as ball {count} of a game is in play, and nobody has pushed it; call \
                 `tilt(false)` where a ball begins, and `tilt(true)` only where `on_bob` or `on_slam` is told of a push"
            ),
        ),
        _ => return None,
    })
}

/// What the rules do wrong when a ball is lost.
fn of_lost_ball(finding: &Finding, table: &Table) -> Option<String> {
    let count = finding.count;
    let drain = finding.part.map_or_else(String::new, |part| format!(" in {}", name(part, table)));
    Some(match finding.kind {
        FindingKind::BallWithoutEnd => format!(
            "ball {count} is lost{drain} and nothing follows for 14 s, until the ball search gives another; when \
             `on_switch` hears the drain, which needs an `id`, and `balls_in_play()` is 0, call `next_player()` and \
             `add_ball()`, or `game_over()`"
        ),
        FindingKind::NoNextBall => format!(
            "ball {count} is lost{drain}, `next_player()` begins the next turn, and no ball comes for 14 s, until the ball \
             search gives one; call `add_ball()` where `next_player()` is true"
        ),
        FindingKind::NoGameOver => format!(
            "the last ball is lost{drain} and the game goes on without one, until the ball search gives another; call \
             `game_over()` where `next_player()` is false"
        ),
        FindingKind::GameWithoutEnd => format!(
            "the game is not over when {count} balls are lost{drain}, the last five of one turn, the longest of them in play \
             for 32 s; call `next_player()` when a ball is lost, and `game_over()` where that is false"
        ),
        FindingKind::OverEarly => {
            let (balls, are) = if count == 1 { ("ball", "is") } else { ("balls", "are") };
            format!(
                "the game is over when {count} {balls} {are} lost{drain}, though `start_game` gave it more; call `game_over()` \
                 only where `next_player()` is false"
            )
        }
        FindingKind::TurnsInPlay => {
            let (balls, are) = if count == 1 { ("ball", "is") } else { ("balls", "are") };
            let lines = lines_with("next_player(", &table.rules);
            format!(
                "the game is over when {count} {balls} {are} lost{drain}, for turns have ended while a ball was in play; call \
                 `next_player()` only where a ball is lost (it is called in {lines})"
            )
        }
        FindingKind::EndsEarly => format!(
            "a ball that is lost{drain} ends the turn while another is on the table, as the ball search may have given one; \
             let it end only when `balls_in_play()` is 0"
        ),
        _ => return None,
    })
}

/// Name and line of a part in the drawing.
fn name(part: PartId, table: &Table) -> String {
    let part = usize::from(part.0);
    let name = table.layout.parts.get(part).map_or("", |part| &part.name);
    let line = table.part_lines.get(part).map_or_else(String::new, |line| format!(" ({} line {line})", FILES[0]));
    format!("{name}{line}")
}

/// The first line of the rules on which this word is no comment's.
fn line_with(word: &str, rules: &str) -> Option<usize> {
    let has_it = |line: &str| line.split("//").next().is_some_and(|code| code.contains(word));
    rules.lines().position(has_it).map(|index| index + 1)
}

/// The lines of the rules on which this word is no comment's, in words.
fn lines_with(word: &str, rules: &str) -> String {
    let has_it = |line: &str| line.split("//").next().is_some_and(|code| code.contains(word));
    let lines = rules.lines().zip(1..).filter(|(line, _)| has_it(line));
    let lines: Vec<String> = lines.map(|(_, number): (_, usize)| number.to_string()).collect();
    match lines.split_last() {
        Some((last, [])) => format!("line {last}"),
        Some((last, first)) => format!("lines {} and {last}", first.join(", ")),
        None => "the rules".to_string(),
    }
}

/// The line on which a function of the rules begins, if there is one.
fn line_of(function: &str, rules: &str) -> Option<usize> {
    let is_it =
        |line: &str| line.trim_start().strip_prefix("fn ").is_some_and(|rest| rest.trim_start().starts_with(function));
    rules.lines().position(is_it).map(|index| index + 1)
}
