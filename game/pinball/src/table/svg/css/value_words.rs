//! Words and units that values of CSS are made of.

/// How an element is laid out.
pub const DISPLAY: [&str; 36] = [
    "none",
    "inline",
    "block",
    "contents",
    "inline-block",
    "list-item",
    "flow",
    "flow-root",
    "flex",
    "inline-flex",
    "grid",
    "inline-grid",
    "table",
    "inline-table",
    "table-row",
    "table-cell",
    "table-column",
    "table-caption",
    "table-row-group",
    "table-header-group",
    "table-footer-group",
    "table-column-group",
    "ruby",
    "ruby-base",
    "ruby-text",
    "ruby-base-container",
    "ruby-text-container",
    "run-in",
    "compact",
    "marker",
    "math",
    "box",
    "inline-box",
    "subgrid",
    "masonry",
    "grid-lanes",
];

/// How an element is mixed with what is below it.
pub const BLEND: [&str; 18] = [
    "normal",
    "multiply",
    "screen",
    "overlay",
    "darken",
    "lighten",
    "color-dodge",
    "color-burn",
    "hard-light",
    "soft-light",
    "difference",
    "exclusion",
    "hue",
    "saturation",
    "color",
    "luminosity",
    "plus-lighter",
    "plus-darker",
];

/// What of a line stays as it is.
pub const VECTOR_EFFECT: [&str; 7] =
    ["none", "non-scaling-stroke", "non-scaling-size", "non-rotation", "fixed-position", "viewport", "screen"];

/// Functions of a filter.
pub const FILTERS: [&str; 11] = [
    "url",
    "blur",
    "brightness",
    "contrast",
    "drop-shadow",
    "grayscale",
    "hue-rotate",
    "invert",
    "opacity",
    "saturate",
    "sepia",
];

/// Sizes of letters beside numbers.
pub const FONT_SIZES: [&str; 11] = [
    "medium",
    "small",
    "large",
    "smaller",
    "larger",
    "xx-small",
    "x-small",
    "x-large",
    "xx-large",
    "xxx-large",
    "math",
];

/// How wide letters are.
pub const STRETCH: [&str; 11] = [
    "normal",
    "condensed",
    "expanded",
    "semi-condensed",
    "semi-expanded",
    "extra-condensed",
    "extra-expanded",
    "ultra-condensed",
    "ultra-expanded",
    "narrower",
    "wider",
];

/// Which letters are made of others.
pub const TEXT_TRANSFORM: [&str; 7] =
    ["none", "uppercase", "lowercase", "capitalize", "full-width", "full-size-kana", "math-auto"];

/// What of a letter stands on its line.
pub const BASELINES: [&str; 14] = [
    "auto",
    "middle",
    "central",
    "hanging",
    "alphabetic",
    "ideographic",
    "mathematical",
    "text-top",
    "text-bottom",
    "text-before-edge",
    "text-after-edge",
    "use-script",
    "no-change",
    "reset-size",
];

/// Which way letters are written.
pub const WRITING: [&str; 11] = [
    "horizontal-tb",
    "vertical-rl",
    "vertical-lr",
    "lr-tb",
    "rl-tb",
    "tb-rl",
    "lr",
    "rl",
    "tb",
    "sideways-rl",
    "sideways-lr",
];

/// Words that every property has, and that of a program which writes `null` where it has nothing to say.
pub const FOR_ALL: [&str; 6] = ["inherit", "initial", "unset", "revert", "revert-layer", "null"];

/// Units of lengths, the likeliest first.
pub const UNITS: [&str; 41] = [
    "mm", "px", "cm", "in", "pt", "pc", "q", "em", "ex", "rem", "rex", "ch", "rch", "ic", "ric", "cap", "rcap", "lh",
    "rlh", "vw", "vh", "vi", "vb", "vmin", "vmax", "svw", "svh", "lvw", "lvh", "dvw", "dvh", "cqw", "cqh", "cqi",
    "cqb", "cqmin", "cqmax", "svi", "svb", "lvi", "dvi",
];
