//! Part commands: the script's words by which it commands a part of one kind, and what the machine is asked then.

use physics::{Command, FlipperControl, Kind, PartId};

/// A word of the script that commands a part.
#[derive(Debug)]
pub struct PartCommand {
    /// The word: the name of a function whose first argument is the part's name.
    pub word: &'static str,
    /// What the part must be, for a sentence.
    pub what: &'static str,
    /// Whether a part is that.
    pub is: fn(&Kind) -> bool,
    /// What the machine is asked.
    pub order: Order,
}

/// What the machine is asked when a script commands a part.
#[derive(Clone, Copy, Debug)]
pub enum Order {
    /// Something that is done once.
    Once(fn(PartId) -> Command),
    /// Something that the script's second argument switches on or off.
    Switch(fn(PartId, bool) -> Command),
}

/// Every word that commands a part.
pub static PART_COMMANDS: [PartCommand; 5] = [
    PartCommand {
        word: "eject",
        what: "a saucer",
        is: |kind| matches!(kind, Kind::Saucer(_)),
        order: Order::Once(Command::Eject),
    },
    PartCommand {
        word: "raise",
        what: "a drop target",
        is: |kind| matches!(kind, Kind::DropTarget(_)),
        order: Order::Once(Command::Raise),
    },
    PartCommand {
        word: "kick",
        what: "a kickback",
        is: |kind| matches!(kind, Kind::Kickback(_)),
        order: Order::Once(Command::Kick),
    },
    PartCommand {
        word: "magnet",
        what: "a magnet",
        is: |kind| matches!(kind, Kind::Magnet(_)),
        order: Order::Switch(Command::Magnet),
    },
    PartCommand {
        word: "divert",
        what: "a diverter",
        is: |kind| matches!(kind, Kind::Flipper(flipper) if flipper.control == FlipperControl::Rules),
        order: Order::Switch(Command::Divert),
    },
];
