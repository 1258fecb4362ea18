//! The keys, as they are told to the player.

/// Keys and what they do.
pub const HELP: &[(&str, &str)] = &[
    ("Shift left, right  \u{b7}  Z  /  \u{b7}  arrows", "flippers"),
    ("Space  \u{b7}  Enter  \u{b7}  Down", "hold and let go: shoot"),
    ("X  .  Up  \u{b7}  C  ,", "push  \u{b7}  pull back"),
    ("1", "start, add a player"),
    ("Esc  \u{b7}  P", "pause"),
    ("R", "watch the last ball"),
    ("+  \u{2212}", "closer, farther"),
    ("F3  F11  F12", "rays, full screen, picture"),
    ("H  \u{b7}  F1", "these keys"),
];

/// Keys while a recording is watched.
pub const REPLAY_HELP: &[(&str, &str)] = &[
    ("Space", "pause"),
    ("Left  Right", "5 seconds back, on"),
    ("Up  Down", "faster, slower"),
    ("+  \u{2212}", "closer, farther"),
    ("F3  F11  F12", "rays, full screen, picture"),
    ("Q  \u{b7}  Esc", "leave"),
];
