//! What a key means, and which buttons are down.

use crate::Buttons;
use std::collections::BTreeMap;
use winit::keyboard::KeyCode;

/// What a key means.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Meaning {
    /// A button of the machine, down as long as the key is.
    Button(Buttons),
    /// The plunger; the start button when no game is on.
    Plunge,
    /// Something that happens once.
    Act(Act),
}

/// Something that a key does once.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Act {
    /// Pause, or go on.
    Pause,
    /// Show the keys.
    Help,
    /// Leave, where leaving is offered.
    Quit,
    /// Fill the screen, or not.
    Fullscreen,
    /// Show what happens behind the picture.
    Overlay,
    /// Save the picture.
    Screenshot,
    /// Watch the last ball.
    LastBall,
    /// Look closer at the table.
    Closer,
    /// Look at more of it.
    Farther,
}

/// What a key means while a game is played.
pub fn meaning(key: KeyCode) -> Option<Meaning> {
    use Meaning::{Act as Once, Button};
    Some(match key {
        KeyCode::ShiftLeft | KeyCode::KeyZ | KeyCode::ArrowLeft => Button(Buttons::LEFT),
        KeyCode::ShiftRight | KeyCode::Slash | KeyCode::ArrowRight => Button(Buttons::RIGHT),
        KeyCode::Space | KeyCode::Enter | KeyCode::NumpadEnter | KeyCode::ArrowDown => Meaning::Plunge,
        KeyCode::KeyX => Button(Buttons::NUDGE_LEFT),
        KeyCode::Period => Button(Buttons::NUDGE_RIGHT),
        KeyCode::ArrowUp => Button(Buttons::NUDGE_UP),
        KeyCode::KeyC | KeyCode::Comma => Button(Buttons::NUDGE_DOWN),
        KeyCode::Digit1 | KeyCode::Numpad1 => Button(Buttons::START),
        KeyCode::Escape | KeyCode::KeyP | KeyCode::Pause => Once(Act::Pause),
        KeyCode::KeyH | KeyCode::F1 => Once(Act::Help),
        KeyCode::KeyQ => Once(Act::Quit),
        KeyCode::F11 => Once(Act::Fullscreen),
        KeyCode::F3 => Once(Act::Overlay),
        KeyCode::F12 => Once(Act::Screenshot),
        KeyCode::KeyR => Once(Act::LastBall),
        KeyCode::Equal | KeyCode::NumpadAdd => Once(Act::Closer),
        KeyCode::Minus | KeyCode::NumpadSubtract => Once(Act::Farther),
        _ => return None,
    })
}

/// The keys that are held, each with the buttons that it has pressed: two keys for one button do not let it go until
/// both are up.
#[derive(Debug, Default)]
pub struct Held(BTreeMap<KeyCode, Buttons>);

impl Held {
    /// A key went down and presses these buttons until it comes up.
    pub fn press(&mut self, key: KeyCode, buttons: Buttons) {
        self.0.insert(key, buttons);
    }

    /// A key came up.
    pub fn release(&mut self, key: KeyCode) {
        self.0.remove(&key);
    }

    /// Every key came up.
    pub fn release_all(&mut self) {
        self.0.clear();
    }

    /// The buttons that are down.
    pub fn buttons(&self) -> Buttons {
        self.0.values().fold(Buttons::NONE, |down, buttons| down.with(*buttons, true))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_button_has_a_key_and_the_flippers_have_three_each() {
        let keys = [
            (Buttons::LEFT, &[KeyCode::ShiftLeft, KeyCode::KeyZ, KeyCode::ArrowLeft][..]),
            (Buttons::RIGHT, &[KeyCode::ShiftRight, KeyCode::Slash, KeyCode::ArrowRight]),
            (Buttons::NUDGE_LEFT, &[KeyCode::KeyX]),
            (Buttons::NUDGE_RIGHT, &[KeyCode::Period]),
            (Buttons::NUDGE_UP, &[KeyCode::ArrowUp]),
            (Buttons::NUDGE_DOWN, &[KeyCode::KeyC, KeyCode::Comma]),
            (Buttons::START, &[KeyCode::Digit1]),
        ];
        for (button, keys) in keys {
            keys.iter().for_each(|key| assert_eq!(meaning(*key), Some(Meaning::Button(button)), "{key:?}"));
        }
        for key in [KeyCode::Space, KeyCode::Enter, KeyCode::ArrowDown] {
            assert_eq!(meaning(key), Some(Meaning::Plunge));
        }
    }

    #[test]
    fn keys_that_act_once() {
        let keys = [
            (KeyCode::Escape, Act::Pause),
            (KeyCode::KeyP, Act::Pause),
            (KeyCode::F11, Act::Fullscreen),
            (KeyCode::F12, Act::Screenshot),
            (KeyCode::F3, Act::Overlay),
            (KeyCode::KeyR, Act::LastBall),
            (KeyCode::KeyH, Act::Help),
            (KeyCode::F1, Act::Help),
            (KeyCode::Equal, Act::Closer),
            (KeyCode::NumpadAdd, Act::Closer),
            (KeyCode::Minus, Act::Farther),
            (KeyCode::NumpadSubtract, Act::Farther),
        ];
        keys.iter().for_each(|(key, act)| assert_eq!(meaning(*key), Some(Meaning::Act(*act)), "{key:?}"));
        assert_eq!(meaning(KeyCode::KeyA), None);
    }

    #[test]
    fn a_button_with_two_keys_down_waits_for_both_to_come_up() {
        let mut held = Held::default();
        held.press(KeyCode::ShiftLeft, Buttons::LEFT);
        held.press(KeyCode::KeyZ, Buttons::LEFT);
        held.release(KeyCode::ShiftLeft);
        assert_eq!(held.buttons(), Buttons::LEFT);
        held.release(KeyCode::KeyZ);
        assert_eq!(held.buttons(), Buttons::NONE);
    }

    #[test]
    fn losing_the_focus_lets_everything_go() {
        let mut held = Held::default();
        held.press(KeyCode::ShiftLeft, Buttons::LEFT);
        held.press(KeyCode::Space, Buttons::PLUNGER);
        held.release_all();
        assert_eq!(held.buttons(), Buttons::NONE);
    }
}
