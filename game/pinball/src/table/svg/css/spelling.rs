//! Spelling of properties: those that decide how a drawing looks, told from what was meant to be one of them.
//!
//! A browser passes over a property that it does not know, and so do drawing programs, which write many of their own. So only
//! what is nearly a known one is told.

use crate::table::svg::class_typo;

/// The properties of SVG, and some of CSS that drawing programs write.
const PROPERTIES: [&str; 78] = [
    "alignment-baseline",
    "baseline-shift",
    "clip",
    "clip-path",
    "clip-rule",
    "color",
    "color-interpolation",
    "color-interpolation-filters",
    "color-profile",
    "color-rendering",
    "cursor",
    "direction",
    "display",
    "dominant-baseline",
    "enable-background",
    "fill",
    "fill-opacity",
    "fill-rule",
    "filter",
    "flood-color",
    "flood-opacity",
    "font",
    "font-family",
    "font-feature-settings",
    "font-kerning",
    "font-size",
    "font-size-adjust",
    "font-stretch",
    "font-style",
    "font-variant",
    "font-variant-caps",
    "font-weight",
    "glyph-orientation-horizontal",
    "glyph-orientation-vertical",
    "image-rendering",
    "isolation",
    "letter-spacing",
    "lighting-color",
    "line-height",
    "marker",
    "marker-end",
    "marker-mid",
    "marker-start",
    "marks",
    "mask",
    "mask-type",
    "mix-blend-mode",
    "opacity",
    "overflow",
    "paint-order",
    "pointer-events",
    "shape-inside",
    "shape-padding",
    "shape-rendering",
    "solid-color",
    "solid-opacity",
    "stop-color",
    "stop-opacity",
    "stroke",
    "stroke-dasharray",
    "stroke-dashoffset",
    "stroke-linecap",
    "stroke-linejoin",
    "stroke-miterlimit",
    "stroke-opacity",
    "stroke-width",
    "text-align",
    "text-anchor",
    "text-decoration",
    "text-indent",
    "text-rendering",
    "transform",
    "unicode-bidi",
    "vector-effect",
    "visibility",
    "white-space",
    "word-spacing",
    "writing-mode",
];
/// The longest name that is looked at, bytes.
const MAX_NAME: usize = 64;
/// How many letters and hyphens a name may have more or less than what is meant.
const MAX_MORE: usize = 4;

/// The property that a name means but for case, a hyphen or one letter, if it is none itself.
pub(in crate::table) fn meant(name: &str) -> Option<&'static str> {
    let is_own = name.starts_with('-') || PROPERTIES.contains(&name);
    if is_own || !(3..=MAX_NAME).contains(&name.len()) {
        return None;
    }
    // A drawing has many attributes: most of them begin like no property that is about as long.
    let begins = |other: &str| name.as_bytes()[0].eq_ignore_ascii_case(&other.as_bytes()[0]);
    let like = |other: &&'static str| other.len().abs_diff(name.len()) <= MAX_MORE && begins(other);
    class_typo::nearest(name, PROPERTIES.into_iter().filter(like))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_near_miss_is_meant_and_nothing_else_is() {
        for (name, property) in [
            ("stroke-widht", "stroke-width"),
            ("stroke-with", "stroke-width"),
            ("strokewidth", "stroke-width"),
            ("strokeWidth", "stroke-width"),
            ("stroke_width", "stroke-width"),
            ("fil", "fill"),
            ("colour", "color"),
            ("opactiy", "opacity"),
            ("fill-opasity", "fill-opacity"),
            ("stop-colour", "stop-color"),
        ] {
            assert_eq!(meant(name), Some(property), "{name}");
        }
        let attributes = "alignmentBaseline azimuth baseFrequency class clipPathUnits cx cy d dx dy edgeMode elevation fr \
                          from fx fy gradientTransform gradientUnits height href id in in2 k1 kernelMatrix lang \
                          lengthAdjust markerHeight markerUnits markerWidth maskUnits max media method min mode \
                          numOctaves offset operator order orient origin path pathLength patternUnits points \
                          preserveAspectRatio r radius refX result rotate rx ry scale seed side slope spacing \
                          specularExponent spreadMethod startOffset stdDeviation stitchTiles style surfaceScale tableValues \
                          target textLength title to type values version viewBox width x x1 x2 xChannelSelector y z";
        let others = "-inkscape-stroke --fill inline-size line-width grid gap margin border font-variation-settings \
                      text-orientation text-decoration-line flow-into flex-flow float bottom right z-index zoom";
        for name in attributes.split(' ').chain(others.split(' ')).filter(|name| *name != "alignmentBaseline") {
            assert_eq!(meant(name), None, "{name}");
        }
    }
}
