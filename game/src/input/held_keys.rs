//! The keys that are held, and the machine's buttons that they hold.

use super::Key;
use crate::Buttons;
use std::collections::BTreeMap;

/// The keys that are held, each with the buttons that it has pressed: two keys for one button do not let it go until
/// both are up.
#[derive(Debug, Default)]
pub struct HeldKeys(BTreeMap<Key, Buttons>);

impl HeldKeys {
    /// A key went down and presses these buttons until it comes up.
    pub fn press(&mut self, key: Key, buttons: Buttons) {
        self.0.insert(key, buttons);
    }

    /// A key came up.
    pub fn release(&mut self, key: Key) {
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
    fn a_button_with_two_keys_down_waits_for_both_to_come_up() {
        let mut held = HeldKeys::default();
        held.press(Key::ShiftLeft, Buttons::LEFT);
        held.press(Key::KeyZ, Buttons::LEFT);
        held.release(Key::ShiftLeft);
        assert_eq!(held.buttons(), Buttons::LEFT);
        held.release(Key::KeyZ);
        assert_eq!(held.buttons(), Buttons::NONE);
    }

    #[test]
    fn losing_the_focus_lets_everything_go() {
        let mut held = HeldKeys::default();
        held.press(Key::ShiftLeft, Buttons::LEFT);
        held.press(Key::Space, Buttons::PLUNGER);
        held.release_all();
        assert_eq!(held.buttons(), Buttons::NONE);
    }
}
