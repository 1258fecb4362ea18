//! The DMD animation: what the dot-matrix display shows at a tick.
//!
//! It is a function of what the display says and of the tick alone: no clock and no memory, so that a recording shows
//! the same dots at every frame rate.

use super::dots::{Dots, FULL, Face};
use crate::screen::{DMD_COLUMNS, DMD_ROWS};
use crate::simulation::Display;

/// Dots move in steps of this many ticks, so that a frame rate above it redraws nothing.
const STEP_TICKS: u64 = 25;
/// Steps for a letter of a message to appear.
const STEPS_PER_LETTER: u64 = 1;
/// Steps that a message that is too long stands before it begins to move.
const STEPS_BEFORE_SCROLL: u64 = 40;
/// Steps that each page of the attract show stands.
const PAGE_STEPS: u64 = 150;
/// Steps in which one page gives way to the next.
const TURN_STEPS: u64 = DMD_ROWS as u64 / 2;

const DIM: u8 = 110;
const SOFT: u8 = 170;
const MIDDLE: i32 = DMD_COLUMNS as i32 / 2;

/// The dots of the animation at a tick.
pub fn animation_dots(display: &Display, tick: u64) -> Dots {
    let step = tick / STEP_TICKS;
    if display.tilted {
        return tilt(step);
    }
    if !display.message.is_empty() {
        return message(&display.message, tick.saturating_sub(display.message_tick) / STEP_TICKS);
    }
    if display.playing { score(display, step) } else { attract(display, step) }
}

/// A score with its thousands set apart.
pub fn grouped(score: i64) -> String {
    let digits = score.unsigned_abs().to_string();
    let mut text = String::with_capacity(digits.len() + digits.len() / 3 + 1);
    if score < 0 {
        text.push('-');
    }
    for (index, digit) in digits.chars().enumerate() {
        if index > 0 && (digits.len() - index).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

fn tilt(step: u64) -> Dots {
    let mut dots = Dots::default();
    dots.write_centred("TILT", Face::Large, MIDDLE, 9, if step % 24 < 16 { FULL } else { DIM });
    dots
}

fn score(display: &Display, step: u64) -> Dots {
    let mut dots = Dots::default();
    let mine = grouped(display.scores.get(display.player).copied().unwrap_or_default());
    let face = Face::fitting(&mine);
    dots.write_centred(&mine, face, MIDDLE, 9 - face.height() / 2, FULL);
    let right = DMD_COLUMNS as i32 - 2;
    // A calm sign of life: one brighter dot walks along the rule.
    dots.line(2, right, 20, 60);
    let walk = (step as i32) % (right + 20) - 10;
    (-6..=6).for_each(|d| dots.light((walk + d).clamp(2, right - 1), 20, (FULL as i32 - 30 * d.abs()) as u8));
    let others: Vec<String> = display
        .scores
        .iter()
        .enumerate()
        .filter(|(index, _)| *index != display.player)
        .map(|(index, score)| format!("{}: {}", index + 1, grouped(*score)))
        .collect();
    let ball = format!("BALL {}", display.ball);
    if others.is_empty() {
        dots.write(&ball, Face::Small, 2, 24, SOFT);
        dots.write_right(&format!("OF {}", display.balls), Face::Small, right, 24, DIM);
    } else {
        dots.write(&format!("P{} {ball}", display.player + 1), Face::Small, 2, 24, SOFT);
        let turn = (step / 80) as usize % others.len();
        dots.write_right(&others[turn], Face::Small, right, 24, DIM);
    }
    dots
}

/// A message: letters appear one by one, the first line flares as it comes, a line that is too long walks past.
fn message(lines: &[String], age: u64) -> Dots {
    let mut dots = Dots::default();
    let faces: Vec<Face> =
        lines.iter().enumerate().map(|(i, line)| if i == 0 { Face::fitting(line) } else { Face::Small }).collect();
    let height: i32 = faces.iter().map(|face| face.height()).sum::<i32>() + 3 * (faces.len() as i32 - 1);
    let mut y = (DMD_ROWS as i32 - height).max(0) / 2;
    let mut letters = age / STEPS_PER_LETTER + 1;
    for (line, face) in lines.iter().zip(&faces) {
        let shown: String = line.chars().take(letters as usize).collect();
        let flare = if *face == Face::Small { SOFT } else { FULL - (age.min(12) as u8 % 4) * 30 };
        dots.write(&shown, *face, start_of(line, *face, age), y, flare);
        letters = letters.saturating_sub(line.chars().count() as u64);
        y += face.height() + 3;
    }
    dots
}

/// Where a line begins: centred, or walking to and fro if it is wider than the display.
fn start_of(line: &str, face: Face, age: u64) -> i32 {
    let excess = face.width(line) - (DMD_COLUMNS as i32 - 4);
    if excess <= 0 {
        return MIDDLE - face.width(line) / 2;
    }
    let length = excess as u64 + STEPS_BEFORE_SCROLL;
    let along = age.max(1) - 1;
    let (lap, step) = (along / length, along % length);
    let moved = step.saturating_sub(STEPS_BEFORE_SCROLL) as i32;
    2 - if lap.is_multiple_of(2) { moved } else { excess - moved }
}

/// What is shown while nobody plays: a few pages that roll on like a shutter.
fn attract(display: &Display, step: u64) -> Dots {
    let pages = if display.scores.iter().any(|score| *score > 0) { 4 } else { 3 };
    let (turn, within) = (step / PAGE_STEPS, step % PAGE_STEPS);
    let here = attract_page(display, turn % pages, step);
    if within + TURN_STEPS < PAGE_STEPS {
        return here;
    }
    let rows = ((within + TURN_STEPS - PAGE_STEPS) * 2) as i32;
    let next = attract_page(display, (turn + 1) % pages, step);
    here.moved_down(-rows).with(&next.moved_down(DMD_ROWS as i32 - rows))
}

fn attract_page(display: &Display, page: u64, step: u64) -> Dots {
    let mut dots = Dots::default();
    match page {
        0 => {
            dots.write_centred("CAUSTIC", Face::Large, MIDDLE, 4, FULL);
            // A caustic: the bright curve that light draws at the bottom of a cup.
            for x in 0..DMD_COLUMNS as i32 {
                let phase = (x + step as i32) as f64 * 0.098;
                let bend = geometry::trig::sin_cos(phase).0 * geometry::trig::sin_cos(phase * 0.37).1;
                dots.light(x, 26 + (bend * 3.4).round() as i32, 90 + (bend.abs() * 165.0) as u8);
            }
        }
        1 => {
            dots.write_centred("PRESS", Face::Small, MIDDLE, 4, SOFT);
            dots.write_centred("SPACE", Face::Large, MIDDLE, 13, if step % 40 < 28 { FULL } else { DIM });
        }
        2 => {
            dots.write_centred("SHIFT TO FLIP", Face::Small, MIDDLE, 2, SOFT);
            dots.write_centred("SPACE TO SHOOT", Face::Small, MIDDLE, 12, SOFT);
            dots.write_centred("H FOR HELP", Face::Small, MIDDLE, 22, SOFT);
        }
        _ => {
            let best = display.scores.iter().copied().max().unwrap_or_default();
            dots.write_centred("LAST GAME", Face::Small, MIDDLE, 3, SOFT);
            let text = grouped(best);
            dots.write_centred(&text, Face::fitting(&text), MIDDLE, 14, FULL);
        }
    }
    dots
}

#[cfg(test)]
mod tests {
    use super::*;

    fn display() -> Display {
        Display { scores: vec![1_234_567], ball: 1, balls: 3, playing: true, ..Display::default() }
    }

    #[test]
    fn a_score_is_set_apart_in_thousands() {
        assert_eq!(grouped(0), "0");
        assert_eq!(grouped(999), "999");
        assert_eq!(grouped(1_000), "1,000");
        assert_eq!(grouped(-1_234_567), "-1,234,567");
        assert_eq!(grouped(i64::MIN), "-9,223,372,036,854,775,808");
    }

    #[test]
    fn another_score_is_another_picture() {
        let mut other = display();
        other.scores[0] += 10;
        assert_ne!(animation_dots(&display(), 500), animation_dots(&other, 500));
    }

    #[test]
    fn a_long_line_shows_its_first_and_its_last_letter_in_time() {
        let line = "THE QUICK BROWN FOX JUMPS OVER THE LAZY DOG";
        let starts: Vec<i32> = (0..1000).map(|age| start_of(line, Face::Small, age)).collect();
        assert_eq!(starts.iter().max(), Some(&2));
        let end = starts.iter().min().map(|start| start + Face::Small.width(line));
        assert!(end.is_some_and(|end| (DMD_COLUMNS as i32 - 4..=DMD_COLUMNS as i32).contains(&end)), "{end:?}");
        assert!(starts.windows(2).all(|pair| (pair[0] - pair[1]).abs() <= 1), "it walks, it does not jump");
    }

    #[test]
    fn a_tilt_is_shown_whatever_else_there_is_to_say() {
        let tilted = Display { tilted: true, message: vec!["JACKPOT".to_string()], ..display() };
        let plain = Display { tilted: true, ..display() };
        assert_eq!(animation_dots(&tilted, 3000), animation_dots(&plain, 3000));
    }

    #[test]
    fn no_display_whatever_it_says_can_stop_the_picture() {
        let odd = Display {
            scores: vec![i64::MAX; 9],
            player: 77,
            message: vec!["\u{1F600}".repeat(300), String::new(), "x".repeat(500), String::new(), String::new()],
            message_tick: u64::MAX,
            ..Display::default()
        };
        for tick in [0, 1, 12_345, u64::MAX] {
            animation_dots(&odd, tick);
            animation_dots(&Display { message: Vec::new(), playing: true, ..odd.clone() }, tick);
            animation_dots(&Display { message: Vec::new(), playing: false, ..odd.clone() }, tick);
        }
    }
}
