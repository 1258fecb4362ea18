//! Damage: what can be wrong with the bytes of a recording.

use super::format::{FORMAT_1, FORMAT_VERSION};

/// What bytes are that stand behind all that was recorded.
pub(super) const BEHIND: &str = "after the end";

/// Why bytes are refused as a recording.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Damage {
    /// They do not begin as a recording does.
    #[error("this is not a Caustic recording: its first bytes are not the ones that every recording begins with")]
    NotARecording,
    /// They are written in another format.
    #[error("it is written in format version {0}, this program reads versions {FORMAT_1} to {FORMAT_VERSION}")]
    FormatVersion(u16),
    /// They are whole, but a later program has put something into them that this one must not leave out.
    #[error("it was recorded with a chunk `{0}` that this program does not know; play it with a newer Caustic")]
    UnknownChunk(char),
    /// The end is missing.
    #[error("it is cut short: {left} of its {whole} bytes are left")]
    CutShort {
        /// Bytes that are there.
        left: u64,
        /// Bytes that the file had.
        whole: u64,
    },
    /// It is cut before any play begins.
    #[error("it is cut short: its {0} bytes end before the play begins")]
    CutInHeader(u64),
    /// Some bytes are not what was written.
    #[error(
        "it is damaged: {} not what was written, {}",
        if first == last { format!("byte {first} is") } else { format!("bytes {first} to {last} are") },
        if *what == BEHIND { "behind its end".to_string() } else { format!("in {what}; the {ticks} ticks before are whole") }
    )]
    Changed {
        /// The first byte of the part that does not match its check.
        first: usize,
        /// The last byte of it.
        last: usize,
        /// What the part holds.
        what: &'static str,
        /// The ticks that come before it.
        ticks: u64,
    },
}
