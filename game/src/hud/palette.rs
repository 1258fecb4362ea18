//! The colours of the HUD: a night observatory, brass and amber.

use crate::screen::Color;

/// Blue-black, under dialogs and notices.
pub const NIGHT: Color = 0x06_0810;
/// Brass, of frames and hairlines.
pub const BRASS: Color = 0xb0_8d57;
/// Amber, of what counts now.
pub const AMBER: Color = 0xff_b347;
/// Ivory, of plain text.
pub const IVORY: Color = 0xec_e6d6;
/// Mist, of labels.
pub const MIST: Color = 0x86_8fa3;
