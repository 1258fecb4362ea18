//! Input: the keys of a keyboard as plain data, what each is bound to, and which are held.
//!
//! This room refuses to know a window system: `desktop` translates that one's key codes to [`Key`].

mod action;
mod bindings;
mod held_keys;
mod key;

pub use action::{Action, ReplayAction, UiAction};
pub use bindings::{action, replay_action};
pub use held_keys::HeldKeys;
pub use key::Key;
