//! Bindings: which action each key is bound to.

use super::{Action, Key, ReplayAction, UiAction};
use crate::Buttons;

/// What a key is bound to while a game is played; the rest of it holds while a recording is watched, too.
pub fn action(key: Key) -> Option<Action> {
    use Action::{Button, Plunge, Ui};
    Some(match key {
        Key::ShiftLeft | Key::KeyZ | Key::ArrowLeft => Button(Buttons::LEFT),
        Key::ShiftRight | Key::Slash | Key::ArrowRight => Button(Buttons::RIGHT),
        Key::Space | Key::Enter | Key::NumpadEnter | Key::ArrowDown => Plunge,
        Key::KeyX => Button(Buttons::NUDGE_LEFT),
        Key::Period => Button(Buttons::NUDGE_RIGHT),
        Key::ArrowUp => Button(Buttons::NUDGE_UP),
        Key::KeyC | Key::Comma => Button(Buttons::NUDGE_DOWN),
        Key::Digit1 | Key::Numpad1 => Button(Buttons::START),
        Key::Escape | Key::KeyP | Key::Pause => Ui(UiAction::Pause),
        Key::KeyH | Key::F1 => Ui(UiAction::Help),
        Key::KeyQ => Ui(UiAction::Quit),
        Key::F11 => Ui(UiAction::Fullscreen),
        Key::F3 => Ui(UiAction::DebugOverlay),
        Key::F12 => Ui(UiAction::Screenshot),
        Key::KeyR => Ui(UiAction::LastBall),
        Key::Equal | Key::NumpadAdd => Ui(UiAction::ZoomIn),
        Key::Minus | Key::NumpadSubtract => Ui(UiAction::ZoomOut),
        _ => return None,
    })
}

/// What a key is bound to while a recording is watched, before what [`action`] says.
pub fn replay_action(key: Key) -> Option<ReplayAction> {
    Some(match key {
        Key::Space => ReplayAction::TogglePause,
        Key::ArrowLeft => ReplayAction::SeekBack,
        Key::ArrowRight => ReplayAction::SeekForward,
        Key::ArrowUp => ReplayAction::Faster,
        Key::ArrowDown => ReplayAction::Slower,
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_button_has_a_key_and_the_flippers_have_three_each() {
        let keys = [
            (Buttons::LEFT, &[Key::ShiftLeft, Key::KeyZ, Key::ArrowLeft][..]),
            (Buttons::RIGHT, &[Key::ShiftRight, Key::Slash, Key::ArrowRight]),
            (Buttons::NUDGE_LEFT, &[Key::KeyX]),
            (Buttons::NUDGE_RIGHT, &[Key::Period]),
            (Buttons::NUDGE_UP, &[Key::ArrowUp]),
            (Buttons::NUDGE_DOWN, &[Key::KeyC, Key::Comma]),
            (Buttons::START, &[Key::Digit1]),
        ];
        for (button, keys) in keys {
            keys.iter().for_each(|key| assert_eq!(action(*key), Some(Action::Button(button)), "{key:?}"));
        }
        for key in [Key::Space, Key::Enter, Key::ArrowDown] {
            assert_eq!(action(key), Some(Action::Plunge));
        }
    }

    #[test]
    fn keys_that_act_once() {
        let keys = [
            (Key::Escape, UiAction::Pause),
            (Key::KeyP, UiAction::Pause),
            (Key::F11, UiAction::Fullscreen),
            (Key::F12, UiAction::Screenshot),
            (Key::F3, UiAction::DebugOverlay),
            (Key::KeyR, UiAction::LastBall),
            (Key::KeyH, UiAction::Help),
            (Key::F1, UiAction::Help),
            (Key::Equal, UiAction::ZoomIn),
            (Key::NumpadAdd, UiAction::ZoomIn),
            (Key::Minus, UiAction::ZoomOut),
            (Key::NumpadSubtract, UiAction::ZoomOut),
        ];
        keys.iter().for_each(|(key, ui)| assert_eq!(action(*key), Some(Action::Ui(*ui)), "{key:?}"));
        assert_eq!(action(Key::KeyA), None);
    }

    #[test]
    fn a_replay_takes_the_arrows_and_space_and_leaves_the_other_keys() {
        let keys = [
            (Key::Space, ReplayAction::TogglePause),
            (Key::ArrowLeft, ReplayAction::SeekBack),
            (Key::ArrowRight, ReplayAction::SeekForward),
            (Key::ArrowUp, ReplayAction::Faster),
            (Key::ArrowDown, ReplayAction::Slower),
        ];
        keys.iter().for_each(|(key, replay)| assert_eq!(replay_action(*key), Some(*replay), "{key:?}"));
        for key in [Key::Escape, Key::KeyQ, Key::KeyH, Key::F12] {
            assert_eq!(replay_action(key), None);
        }
    }
}
