//! A dot-matrix display's dots: how bright each one is, and letters made of dots.

use crate::screen::{DMD_COLUMNS, DMD_ROWS};
use std::collections::BTreeMap;
use std::sync::OnceLock;

/// The brightest a dot can be.
pub const FULL: u8 = 255;

/// The letters: on each line a character and its seven rows, `#` for a dot.
const LETTERS: &str = include_str!("../../../../assets/fonts/dots.txt");
const LETTER_ROWS: usize = 7;

/// The brightness of each dot.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Dots {
    levels: Vec<u8>,
}

/// How large letters are: a dot of a letter is 1, 2 or 3 dots of the display.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Face {
    /// Seven dots high.
    Small,
    /// Fourteen dots high, its stairs rounded off.
    Large,
    /// Fourteen dots high, set closer, for long numbers.
    LargeTight,
}

impl Default for Dots {
    fn default() -> Dots {
        Dots { levels: vec![0; DMD_COLUMNS * DMD_ROWS] }
    }
}

impl Dots {
    /// How bright a dot is; dots outside the display are dark.
    pub fn level(&self, x: i32, y: i32) -> u8 {
        index(x, y).map_or(0, |index| self.levels[index])
    }

    /// Lights a dot at least this much; dots outside the display are lost.
    pub fn light(&mut self, x: i32, y: i32, level: u8) {
        if let Some(index) = index(x, y) {
            self.levels[index] = self.levels[index].max(level);
        }
    }

    /// A row of dots from `x` up to, not including, `end`.
    pub fn line(&mut self, x: i32, end: i32, y: i32, level: u8) {
        (x..end).for_each(|x| self.light(x, y, level));
    }

    /// Writes `text` with its upper left dot at `x`, `y`.
    pub fn write(&mut self, text: &str, face: Face, x: i32, y: i32, level: u8) {
        let mut pen = x;
        for character in text.chars() {
            let letter = letter(character);
            for (row, bits) in face.rows(letter).iter().enumerate() {
                for (column, _) in bits.iter().enumerate().filter(|(_, on)| **on) {
                    self.light(pen + column as i32, y + row as i32, level);
                }
            }
            pen += face.advance(letter);
        }
    }

    /// Writes `text` with its middle at `x`.
    pub fn write_centred(&mut self, text: &str, face: Face, x: i32, y: i32, level: u8) {
        self.write(text, face, x - face.width(text) / 2, y, level);
    }

    /// Writes `text` so that it ends before `x`.
    pub fn write_right(&mut self, text: &str, face: Face, x: i32, y: i32, level: u8) {
        self.write(text, face, x - face.width(text), y, level);
    }

    /// The dots moved down by `rows` (up if negative); what leaves is lost.
    #[must_use]
    pub fn moved_down(&self, rows: i32) -> Dots {
        let mut moved = Dots::default();
        for y in 0..DMD_ROWS as i32 {
            for x in 0..DMD_COLUMNS as i32 {
                moved.light(x, y + rows, self.level(x, y));
            }
        }
        moved
    }

    /// Both together, the brighter of each dot.
    #[must_use]
    pub fn with(mut self, other: &Dots) -> Dots {
        self.levels.iter_mut().zip(&other.levels).for_each(|(mine, theirs)| *mine = (*mine).max(*theirs));
        self
    }
}

fn index(x: i32, y: i32) -> Option<usize> {
    let inside = (0..DMD_COLUMNS as i32).contains(&x) && (0..DMD_ROWS as i32).contains(&y);
    inside.then(|| y as usize * DMD_COLUMNS + x as usize)
}

/// A letter's dots, row by row.
type Letter = Vec<Vec<bool>>;

impl Face {
    /// The size that shows `text` as large as the display's width allows.
    pub fn fitting(text: &str) -> Face {
        [Face::Large, Face::LargeTight]
            .into_iter()
            .find(|face| face.width(text) <= DMD_COLUMNS as i32 - 2)
            .unwrap_or(Face::Small)
    }

    /// Dots that `text` is wide.
    pub fn width(self, text: &str) -> i32 {
        let advance: i32 = text.chars().map(|character| self.advance(letter(character))).sum();
        (advance - self.gap()).max(0)
    }

    /// Dots that a line is high.
    pub fn height(self) -> i32 {
        LETTER_ROWS as i32 * self.scale()
    }

    fn scale(self) -> i32 {
        if self == Face::Small { 1 } else { 2 }
    }

    fn gap(self) -> i32 {
        if self == Face::Large { 2 } else { 1 }
    }

    fn advance(self, letter: &Letter) -> i32 {
        letter[0].len() as i32 * self.scale() + self.gap()
    }

    fn rows(self, letter: &Letter) -> Letter {
        if self == Face::Small { letter.clone() } else { doubled(letter) }
    }
}

/// The letter at twice its size; each new dot is taken from the two neighbours that meet at its corner where they
/// agree and the other two do not (the rule that is known as EPX), so diagonals stay smooth.
fn doubled(letter: &Letter) -> Letter {
    let (height, width) = (letter.len() as i32, letter[0].len() as i32);
    let dot = |x: i32, y: i32| {
        let inside = (0..height).contains(&y) && (0..width).contains(&x);
        inside && letter[y as usize][x as usize]
    };
    let corner = |x: i32, y: i32| {
        let (cx, cy) = (x / 2, y / 2);
        let (beside, across) = if x % 2 == 0 { (cx - 1, cx + 1) } else { (cx + 1, cx - 1) };
        let (upright, opposite) = if y % 2 == 0 { (cy - 1, cy + 1) } else { (cy + 1, cy - 1) };
        let (a, b) = (dot(cx, upright), dot(beside, cy));
        let smooth = a == b && a != dot(across, cy) && b != dot(cx, opposite);
        if smooth { a } else { dot(cx, cy) }
    };
    (0..2 * height).map(|y| (0..2 * width).map(|x| corner(x, y)).collect()).collect()
}

/// Whether the font has this letter, or it is a space.
pub fn has_dots(character: char) -> bool {
    font().contains_key(&upper(character))
}

fn letter(character: char) -> &'static Letter {
    font().get(&upper(character)).unwrap_or_else(|| &font()[&' '])
}

fn upper(character: char) -> char {
    character.to_uppercase().next().unwrap_or(character)
}

fn font() -> &'static BTreeMap<char, Letter> {
    static FONT: OnceLock<BTreeMap<char, Letter>> = OnceLock::new();
    FONT.get_or_init(|| {
        let mut font: BTreeMap<char, Letter> = LETTERS.lines().filter_map(parse).collect();
        font.insert(' ', vec![vec![false; 3]; LETTER_ROWS]);
        font
    })
}

fn parse(line: &str) -> Option<(char, Letter)> {
    let mut characters = line.chars();
    let character = characters.next()?;
    let rows: Letter =
        characters.as_str().split_whitespace().map(|row| row.chars().map(|dot| dot == '#').collect()).collect();
    let width = rows.first().map_or(0, Vec::len);
    let whole = rows.len() == LETTER_ROWS && width > 0 && rows.iter().all(|row| row.len() == width);
    whole.then_some((character, rows))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_letter_of_the_font_is_whole() {
        for line in LETTERS.lines() {
            assert!(parse(line).is_some(), "bad letter: {line}");
        }
        for character in ('A'..='Z').chain('0'..='9').chain(".,:!?'-+/()%".chars()) {
            assert!(letter(character).iter().flatten().any(|on| *on), "{character} is blank");
        }
    }

    #[test]
    fn a_score_of_ten_digits_fits_in_large_letters() {
        let score = "9,999,999,999";
        assert_ne!(Face::fitting(score), Face::Small);
        assert!(Face::fitting(score).width(score) <= DMD_COLUMNS as i32);
    }

    #[test]
    fn doubling_keeps_straight_lines_and_cuts_no_dot_off() {
        let bar = vec![vec![true]; LETTER_ROWS];
        assert_eq!(doubled(&bar), vec![vec![true; 2]; 2 * LETTER_ROWS]);
    }

    #[test]
    fn writing_outside_the_display_is_lost_not_wrapped() {
        let mut dots = Dots::default();
        dots.write("W", Face::Large, DMD_COLUMNS as i32, 0, FULL);
        dots.write("W", Face::Large, -40, -3, FULL);
        assert_eq!(dots, Dots::default());
    }
}
