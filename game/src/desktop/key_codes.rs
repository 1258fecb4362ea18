//! From winit's key codes to the keys of `input`, which have the same names.

use crate::input::Key;
use winit::keyboard::KeyCode;

macro_rules! same_names {
    ($code:expr => $($name:ident)*) => {
        match $code {
            $(KeyCode::$name => Some(Key::$name),)*
            _ => None,
        }
    };
}

/// The key of this code; `None` for a key that nothing can be bound to.
#[rustfmt::skip]
pub fn key(code: KeyCode) -> Option<Key> {
    same_names!(code =>
        KeyA KeyB KeyC KeyD KeyE KeyF KeyG KeyH KeyI KeyJ KeyK KeyL KeyM
        KeyN KeyO KeyP KeyQ KeyR KeyS KeyT KeyU KeyV KeyW KeyX KeyY KeyZ
        Digit0 Digit1 Digit2 Digit3 Digit4 Digit5 Digit6 Digit7 Digit8 Digit9
        Numpad0 Numpad1 Numpad2 Numpad3 Numpad4 Numpad5 Numpad6 Numpad7 Numpad8 Numpad9
        NumpadAdd NumpadSubtract NumpadEnter
        F1 F2 F3 F4 F5 F6 F7 F8 F9 F10 F11 F12
        ArrowLeft ArrowRight ArrowUp ArrowDown
        ShiftLeft ShiftRight ControlLeft ControlRight AltLeft AltRight
        Space Enter Escape Tab Backspace Pause
        Comma Period Slash Semicolon Equal Minus)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_keep_their_names_and_others_are_none() {
        assert_eq!(key(KeyCode::ShiftLeft), Some(Key::ShiftLeft));
        assert_eq!(key(KeyCode::NumpadSubtract), Some(Key::NumpadSubtract));
        assert_eq!(key(KeyCode::BrowserHome), None);
    }
}
