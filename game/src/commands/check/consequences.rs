//! Consequences: what `check` finds in several ways is told once.

use crate::Failure;
use std::collections::BTreeSet;

/// How the review begins and ends that an entry of `this` is never set, and how play does.
const UNSET: [&str; 2] = [", and no rule ever sets it", " was never set"];
/// What the review says of rules without a second ball, and what play says of the same.
const ONE_BALL: [&str; 2] =
    [" stays at its first: no rule calls `next_player()`", ", though `start_game` gave it more;"];

/// The findings without what is said twice, in their order.
pub fn once(found: Vec<Failure>) -> Vec<Failure> {
    let sentences: Vec<String> = found.iter().map(ToString::to_string).collect();
    let in_play: BTreeSet<&str> = sentences.iter().filter_map(|one| unset(one, UNSET[1])).collect();
    let has_one_ball = sentences.iter().any(|one| one.contains(ONE_BALL[0]));
    let (mut told, mut entries) = (BTreeSet::new(), BTreeSet::new());
    let is_new = |sentence: &str| {
        let is_unset = unset(sentence, UNSET[0]).is_some_and(|entry| in_play.contains(entry));
        let is_again = unset(sentence, UNSET[1]).is_some_and(|entry| !entries.insert(entry.to_string()));
        let is_one_ball = has_one_ball && sentence.contains(ONE_BALL[1]);
        told.insert(sentence.to_string()) && !is_unset && !is_again && !is_one_ball
    };
    let new: Vec<bool> = sentences.iter().map(String::as_str).map(is_new).collect();
    found.into_iter().zip(new).filter_map(|(one, is_new)| is_new.then_some(one)).collect()
}

/// The entry of `this` that a sentence says is never set.
fn unset<'s>(sentence: &'s str, end: &str) -> Option<&'s str> {
    let (before, _) = sentence.split_once(end)?;
    let at = before.rfind("this.")?;
    before[at..].split(' ').next()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn told(found: &[&str]) -> Vec<String> {
        let found = found.iter().map(|one| match one.strip_prefix("warning: ") {
            Some(one) => Failure::warning(one.to_string()),
            None => Failure::new(one.to_string()),
        });
        once(found.collect()).iter().map(ToString::to_string).collect()
    }

    /// `this.bonus` was set nowhere: the review said it in two lines and play in two more.
    #[test]
    fn an_entry_that_is_never_set_is_told_once() {
        let review = "warning: a:4: this.bonus is read here (and in line 9), and no rule ever sets it";
        let play = [
            "a:9: `*` does not go between nothing and a whole number: this.bonus was never set",
            "a:4: `+` does not go: this.bonus was never set",
        ];
        assert_eq!(told(&[review, play[0], play[1]]), [play[0]]);
        assert_eq!(told(&[review]), [review]);
        assert_eq!(told(&[review, "a:9: `*`: this.other was never set"]).len(), 2);
    }

    /// Two balls that began the game anew were told in the same words.
    #[test]
    fn the_same_words_are_said_once_and_a_game_of_one_ball_too() {
        assert_eq!(told(&["warning: a:1: b", "warning: a:1: b", "a:2: b"]), ["warning: a:1: b", "a:2: b"]);
        let review = "warning: a:1: a game of 3 balls stays at its first: no rule calls `next_player()`; call it";
        let play = "warning: a:2: the game is over when 1 ball is lost, though `start_game` gave it more; call";
        assert_eq!(told(&[review, play]), [review]);
        assert_eq!(told(&[play]), [play]);
    }
}
