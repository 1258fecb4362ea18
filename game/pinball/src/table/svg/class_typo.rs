//! Words in a `class` that are none of the table's, told from those that were meant to be.

use super::element_class::ElementClass;

/// Words that say something of art.
pub(in crate::table) const ART: [&str; 3] = ["wood", "plastics", "relief"];
/// Words that Inkscape writes for itself.
const INKSCAPE: [&str; 2] = ["UnoptimicedTransforms", "UnoptimizedTransforms"];

/// Whether a word that is no thing's has a meaning all the same.
pub(in crate::table) fn is_known(word: &str) -> bool {
    ART.contains(&word) || INKSCAPE.contains(&word)
}

/// The class that a word means but for case, a hyphen, a plural or one letter.
pub(in crate::table) fn meant(word: &str) -> Option<&'static str> {
    nearest(word, ElementClass::ALL.map(ElementClass::word))
}

/// The word for art that a word means, in the same way.
pub(in crate::table) fn meant_for_art(word: &str) -> Option<&'static str> {
    nearest(word, ART)
}

/// The first known word that a word means but for case, a hyphen, a plural or one letter.
pub(in crate::table) fn nearest<'k>(word: &str, known: impl IntoIterator<Item = &'k str>) -> Option<&'k str> {
    let word = bare(word);
    let known: Vec<&str> = known.into_iter().collect();
    let singular = [word.strip_suffix(&['s'][..]), word.strip_suffix(&['e', 's'][..])];
    let is = |known: &str, word: &[char]| bare(known) == word;
    let same = |word: &[char]| known.iter().copied().find(|known| is(known, word));
    same(&word)
        .or_else(|| singular.into_iter().flatten().find_map(same))
        .or_else(|| known.iter().copied().find(|known| is_one_letter_off(&word, &bare(known))))
        .or_else(|| {
            known.iter().copied().find(|known| singular[0].is_some_and(|word| is_one_letter_off(word, &bare(known))))
        })
}

/// Whether two words are one but for case and hyphens.
pub(in crate::table) fn is_same(word: &str, other: &str) -> bool {
    bare(word) == bare(other)
}

/// A word without case, hyphens and underscores.
fn bare(word: &str) -> Vec<char> {
    word.chars().filter(|c| !matches!(c, '-' | '_' | '.')).flat_map(char::to_lowercase).collect()
}

/// Whether one letter more, less or another, or two letters that change places, make one word of the other.
fn is_one_letter_off(word: &[char], other: &[char]) -> bool {
    let same = word.iter().zip(other).take_while(|(a, b)| a == b).count();
    let (word, other) = (&word[same..], &other[same..]);
    match (word, other) {
        ([_, word @ ..], [_, other @ ..]) if word == other => true,
        ([a, b, word @ ..], [c, d, other @ ..]) if (a, b) == (d, c) && word == other => true,
        ([_, word @ ..], other) if word == other => true,
        (word, [_, other @ ..]) if word == other => true,
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_but_for_case_plural_or_one_letter_are_meant() {
        for (word, class) in [
            ("sling-shot", "slingshot"),
            ("Sling_Shot", "slingshot"),
            ("slingshots", "slingshot"),
            ("posts", "post"),
            ("Post", "post"),
            ("POSTS", "post"),
            ("droptarget", "drop-target"),
            ("dropTargets", "drop-target"),
            ("flippr", "flipper"),
            ("flippers", "flipper"),
            ("filpper", "flipper"),
            ("fliper", "flipper"),
            ("bumpper", "bumper"),
            ("wal", "wall"),
            ("Plastik", "plastic"),
            ("wireform", "wire-form"),
            ("roll-over", "rollover"),
            ("captive_ball", "captive-ball"),
            ("guids", "guide"),
        ] {
            assert_eq!(meant(word), Some(class), "{word}");
        }
        for other in ["", "cls-1", "st0", "decoration", "art", "outhole", "neon-sign", "pol", "p"] {
            assert_eq!(meant(other), None, "{other}");
        }
        assert_eq!((meant_for_art("Relief"), meant_for_art("reliefs")), (Some("relief"), Some("relief")));
    }

    #[test]
    fn every_class_is_meant_by_itself_and_no_word_for_art_by_mistake() {
        for class in ElementClass::ALL {
            assert_eq!(meant(class.word()), Some(class.word()));
        }
        assert!(ART.into_iter().all(is_known) && !is_known("woods"));
    }
}
