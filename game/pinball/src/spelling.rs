//! Spelling: the word that was meant by one that nobody knows.

/// Longest word for which another is sought that is like it, bytes.
const MAX_SOUGHT: usize = 64;
/// Letters that two words may differ by; of a short word it is no more than every second one.
const MAX_DISTANCE: usize = 2;

/// The known word that differs from this one by little, if there is one.
pub(crate) fn near<'a>(word: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let letters = word.chars().count();
    let is_like = |other: &&str| letters.abs_diff(other.chars().count()) <= MAX_DISTANCE;
    let (distance, other) = nearest(word, known.into_iter().filter(is_like), true)?;
    (2 * distance <= letters.max(other.chars().count())).then_some(other)
}

/// The same in the way in which parts and lamps are found: their sentences can be caught by scripts, and so are in games
/// that were recorded.
pub(crate) fn near_name<'a>(name: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    nearest(name, known, false).map(|(_, other)| other)
}

fn nearest<'a>(word: &str, known: impl IntoIterator<Item = &'a str>, swaps: bool) -> Option<(usize, &'a str)> {
    let short = known.into_iter().filter(|other| word.len().max(other.len()) <= MAX_SOUGHT);
    let best = short.map(|other| (distance(word, other, swaps), other)).min();
    best.filter(|(distance, _)| *distance <= MAX_DISTANCE)
}

/// Levenshtein's distance between two words; with `swaps` two letters that have changed places are one mistake.
fn distance(a: &str, b: &str, swaps: bool) -> usize {
    let [a, b]: [Vec<char>; 2] = [a, b].map(|word| word.chars().collect());
    let mut before = vec![0; b.len() + 1];
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for i in 0..a.len() {
        let mut next = vec![i + 1; b.len() + 1];
        for j in 0..b.len() {
            let replaced = row[j] + usize::from(a[i] != b[j]);
            let is_swap = swaps && i > 0 && j > 0 && a[i] == b[j - 1] && a[i - 1] == b[j];
            let swapped = if is_swap { before[j - 1] + 1 } else { usize::MAX };
            next[j + 1] = replaced.min(row[j + 1] + 1).min(next[j] + 1).min(swapped);
        }
        before = std::mem::replace(&mut row, next);
    }
    row[b.len()]
}

#[cfg(test)]
mod tests {
    use super::{near, near_name};

    #[test]
    fn a_word_is_near_another_of_two_letters_and_a_short_one_of_fewer() {
        let known = ["lamp", "score", "on", "now", "add_ball"];
        for (word, meant) in [("lmap", "lamp"), ("scor", "score"), ("add_bal", "add_ball"), ("nw", "now")] {
            assert_eq!(near(word, known), Some(meant));
        }
        assert_eq!(near_name("olt", ["slot", "o"]), Some("o"), "as ever");
        for word in ["x", "ab", "lam-12", "ball"] {
            assert_eq!(near(word, known), None, "{word}");
        }
    }
}
