//! The DMD animation: what the dot-matrix display shows at a tick.
//!
//! It is a function of what the display says and of the tick alone: no clock and no memory, so that a recording shows
//! the same dots at every frame rate.

use super::dots::{Dots, FULL, Face};
use crate::screen::{DMD_COLUMNS, DMD_ROWS};
use crate::simulation::Display;

/// Dots move in steps of this many ticks, so that a frame rate above it redraws nothing.
const STEP_TICKS: u64 = 25;
/// Steps that a message that is too long stands before it begins to move.
const STEPS_BEFORE_SCROLL: u64 = 40;
/// The same for a message that has little time.
const FEWEST_STEPS_BEFORE_SCROLL: u64 = 8;
/// Steps of a message before its line begins to stand, and at its walk's end.
const STEPS_AT_THE_ENDS: u64 = 2;
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
        let steps = |until: u64| until.saturating_sub(display.message_tick) / STEP_TICKS;
        let lasts = display.message_until.map(steps);
        return message(&display.message, tick.saturating_sub(display.message_tick) / STEP_TICKS, lasts);
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
    dots.write(&mine, face, start_of(&mine, face, step, None), 9 - face.height() / 2, FULL);
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

/// A message that `lasts` so many steps, if it does not stay: letters appear one by one, the first line flares as it
/// comes, a line that is too long walks past. All of it has been seen before it goes.
fn message(lines: &[String], age: u64, lasts: Option<u64>) -> Dots {
    let mut dots = Dots::default();
    let faces: Vec<Face> = lines.iter().enumerate().map(|(index, line)| face_of(index, line)).collect();
    let height: i32 = faces.iter().map(|face| face.height()).sum::<i32>() + 3 * (faces.len() as i32 - 1);
    let mut y = (DMD_ROWS as i32 - height).max(0) / 2;
    let mut letters = (age + 1).saturating_mul(letters_per_step(lines, lasts));
    for (line, face) in lines.iter().zip(&faces) {
        let shown: String = line.chars().take(usize::try_from(letters).unwrap_or(usize::MAX)).collect();
        let flare = if *face == Face::Small { SOFT } else { FULL - (age.min(12) as u8 % 4) * 30 };
        dots.write(&shown, *face, start_of(line, *face, age, lasts), y, flare);
        letters = letters.saturating_sub(line.chars().count() as u64);
        y += face.height() + 3;
    }
    dots
}

fn face_of(index: usize, line: &str) -> Face {
    if index == 0 { Face::fitting(line) } else { Face::Small }
}

/// One, or so many that the last letter is there in half of the message's time.
fn letters_per_step(lines: &[String], lasts: Option<u64>) -> u64 {
    let letters: usize = lines.iter().map(|line| line.chars().count()).sum();
    lasts.map_or(1, |steps| (2 * letters as u64).div_ceil(steps.max(1)).max(1))
}

/// Dots that a line is wider than the display.
fn excess(line: &str, face: Face) -> u64 {
    (face.width(line) - (DMD_COLUMNS as i32 - 4)).max(0) as u64
}

/// Where a line begins: centred, or walking to and fro if it is wider than the display. Its first walk ends, and its end
/// has stood, when the message goes: where time is short it stands less and walks faster.
fn start_of(line: &str, face: Face, age: u64, lasts: Option<u64>) -> i32 {
    let excess = excess(line, face);
    if excess == 0 {
        return MIDDLE - face.width(line) / 2;
    }
    let room = lasts.map_or(u64::MAX, |steps| steps.saturating_sub(STEPS_AT_THE_ENDS));
    let fewest = FEWEST_STEPS_BEFORE_SCROLL.min(room / 4);
    let stands = (room.saturating_sub(excess) / 2).clamp(fewest, STEPS_BEFORE_SCROLL);
    let walks = room.saturating_sub(2 * stands).clamp(1, excess);
    let length = stands + walks;
    let along = age.max(1) - 1;
    let (lap, step) = (along / length, along % length);
    let moved = (excess * step.saturating_sub(stands) / walks) as i32;
    2 - if lap.is_multiple_of(2) { moved } else { excess as i32 - moved }
}

/// How long a message must stand for a line that is wider than the display to walk past at its usual speed, ms; `None` if
/// every line is as wide as the display or less.
pub fn reading_ms(lines: &[&str]) -> Option<u64> {
    let widest = lines.iter().enumerate().map(|(index, line)| excess(line, face_of(index, line))).max()?;
    (widest > 0).then_some((widest + 2 * STEPS_BEFORE_SCROLL + STEPS_AT_THE_ENDS) * STEP_TICKS)
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

    const LONG: &str = "THE QUICK BROWN FOX JUMPS OVER THE LAZY DOG";

    fn starts(lasts: Option<u64>, steps: u64) -> Vec<i32> {
        (0..steps).map(|age| start_of(LONG, Face::Small, age, lasts)).collect()
    }

    fn ends_in_sight(starts: &[i32]) -> bool {
        let end = starts.iter().min().map(|start| start + Face::Small.width(LONG));
        end.is_some_and(|end| (DMD_COLUMNS as i32 - 4..=DMD_COLUMNS as i32).contains(&end))
    }

    #[test]
    fn a_long_line_shows_its_first_and_its_last_letter_in_time() {
        let starts = starts(None, 1000);
        assert_eq!(starts.iter().max(), Some(&2));
        assert!(ends_in_sight(&starts));
        assert!(starts.windows(2).all(|pair| (pair[0] - pair[1]).abs() <= 1), "it walks, it does not jump");
    }

    /// A long line that stood for a second only showed its beginning: it was cut. Three steps are the fewest that can show
    /// a beginning and an end.
    #[test]
    fn a_message_that_goes_soon_has_shown_its_last_letter() {
        for lasts in [3, 4, 8, 20, 40, 100, 140, 200, 1000] {
            let starts = starts(Some(lasts), lasts);
            assert_eq!(starts[0], 2);
            assert!(ends_in_sight(&starts), "{lasts}: {:?}", starts.last());
        }
        let usual = reading_ms(&["HEADLINE", LONG]).expect("it is wider than the display") / STEP_TICKS;
        assert_eq!(starts(Some(usual), usual), starts(None, usual), "with time enough it walks as ever");
        assert_ne!(starts(Some(usual - 2), usual - 2), starts(None, usual - 2));
        assert_eq!(reading_ms(&["HEADLINE", "OF TWO LINES"]), None);
    }

    #[test]
    fn the_last_letter_of_a_message_has_come_before_it_goes() {
        let lines = [LONG.to_string(), LONG.to_string()];
        for lasts in [1, 5, 30, 85, 200] {
            let letters = lasts * letters_per_step(&lines, Some(lasts));
            assert!(letters >= 2 * LONG.len() as u64, "{lasts}");
        }
        assert_eq!(letters_per_step(&lines, Some(400)), 1, "one by one where there is time");
    }

    #[test]
    fn no_score_is_too_long_to_be_seen_whole() {
        let score = grouped(i64::MIN);
        let at = |age: u64| start_of(&score, Face::fitting(&score), age, None);
        let all: Vec<i32> = (0..1000).map(at).collect();
        let (first, last) = (all.iter().max(), all.iter().min());
        assert!(first.is_some_and(|first| *first >= 0));
        assert!(last.is_some_and(|last| last + Face::Small.width(&score) <= DMD_COLUMNS as i32));
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
            message_until: Some(0),
            ..Display::default()
        };
        for tick in [0, 1, 12_345, u64::MAX] {
            animation_dots(&odd, tick);
            animation_dots(&Display { message: Vec::new(), playing: true, ..odd.clone() }, tick);
            animation_dots(&Display { message: Vec::new(), playing: false, ..odd.clone() }, tick);
        }
    }
}
