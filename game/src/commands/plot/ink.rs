//! Ink: what plots are drawn with: the night, brass and ivory of the game's display, and colours that keep apart on
//! them.

use plotters::style::RGBColor;

/// The sheet.
pub const NIGHT: RGBColor = RGBColor(0x0b, 0x0e, 0x1a);
/// Behind the curves.
pub const PANEL: RGBColor = RGBColor(0x11, 0x16, 0x28);
/// Lines of the grid.
pub const GRID: RGBColor = RGBColor(0x23, 0x2b, 0x44);
/// The frame, and lines that mean something.
pub const BRASS: RGBColor = RGBColor(0xb0, 0x8d, 0x57);
/// What was found.
pub const AMBER: RGBColor = RGBColor(0xff, 0xb3, 0x47);
/// Titles, and the most important curve.
pub const IVORY: RGBColor = RGBColor(0xec, 0xe6, 0xd6);
/// Names and numbers.
pub const MIST: RGBColor = RGBColor(0xa3, 0xab, 0xbd);

/// From the least to the most: indigo to ivory, each brighter than the last.
pub const RAMP: [RGBColor; 7] = [
    RGBColor(0x5a, 0x63, 0xd8),
    RGBColor(0x3f, 0x8d, 0xee),
    RGBColor(0x2f, 0xb4, 0xc4),
    RGBColor(0x5c, 0xc9, 0x7a),
    RGBColor(0xc2, 0xd1, 0x4f),
    RGBColor(0xff, 0xb3, 0x47),
    IVORY,
];

/// Things without an order.
pub const KINDS: [RGBColor; 9] = [
    RGBColor(0xff, 0x6f, 0x61),
    RGBColor(0xff, 0x9f, 0x45),
    RGBColor(0xf7, 0xd7, 0x5b),
    RGBColor(0x9b, 0xd9, 0x5a),
    RGBColor(0x3f, 0xd0, 0xa5),
    RGBColor(0x45, 0xc0, 0xf0),
    RGBColor(0x7a, 0x93, 0xff),
    RGBColor(0xb9, 0x86, 0xff),
    RGBColor(0xf2, 0x8a, 0xcb),
];
