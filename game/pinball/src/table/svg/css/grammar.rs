//! Grammar: which values a property has that decides how art looks. A browser passes over any other in silence, and so does the
//! art's rasteriser. What stands for another value, as `var()` and `inherit` do, is none of these and no mistake.

use super::value_words::{
    BASELINES, BLEND, DISPLAY, FILTERS, FONT_SIZES, FOR_ALL, STRETCH, TEXT_TRANSFORM, UNITS, VECTOR_EFFECT, WRITING,
};
use crate::table::svg::class_typo;

/// What a property's value is made of.
enum Grammar {
    /// One of these words.
    Word(&'static [&'static str]),
    /// Several of these words.
    Words(&'static [&'static str]),
    /// A number, or a hundredth part of one.
    Share,
    /// A number that is not less than 0.
    Number,
    /// A length, or one of these words.
    Length(&'static [&'static str]),
    /// A length that is not less than 0, or one of these words.
    Size(&'static [&'static str]),
    /// Lengths that are not less than 0.
    Dashes,
    /// How heavy letters are.
    Weight,
    /// An address, or one of these functions.
    Effects(&'static [&'static str]),
    /// The address of an element with this tag.
    Link(&'static str),
}

use Grammar::{Dashes, Effects, Length, Link, Number, Share, Size, Weight, Word, Words};

/// The properties that are looked at.
const PROPERTIES: [(&str, Grammar); 38] = [
    ("opacity", Share),
    ("fill-opacity", Share),
    ("stroke-opacity", Share),
    ("stop-opacity", Share),
    ("flood-opacity", Share),
    ("stroke-width", Size(&[])),
    ("stroke-dashoffset", Length(&[])),
    ("stroke-dasharray", Dashes),
    ("stroke-miterlimit", Number),
    ("stroke-linecap", Word(&["butt", "round", "square"])),
    ("stroke-linejoin", Word(&["miter", "round", "bevel", "miter-clip", "arcs"])),
    ("fill-rule", Word(&["nonzero", "evenodd"])),
    ("clip-rule", Word(&["nonzero", "evenodd"])),
    ("display", Words(&DISPLAY)),
    ("visibility", Word(&["visible", "hidden", "collapse"])),
    ("mix-blend-mode", Word(&BLEND)),
    ("isolation", Word(&["auto", "isolate"])),
    ("paint-order", Words(&["normal", "fill", "stroke", "markers"])),
    ("vector-effect", Words(&VECTOR_EFFECT)),
    ("color-interpolation-filters", Word(&["auto", "sRGB", "linearRGB"])),
    ("mask-type", Word(&["luminance", "alpha"])),
    ("filter", Effects(&FILTERS)),
    ("mask", Link("mask")),
    ("clip-path", Link("clipPath")),
    ("marker", Link("marker")),
    ("marker-start", Link("marker")),
    ("marker-mid", Link("marker")),
    ("marker-end", Link("marker")),
    ("font-size", Size(&FONT_SIZES)),
    ("font-weight", Weight),
    ("font-style", Words(&["normal", "italic", "oblique"])),
    ("font-stretch", Size(&STRETCH)),
    ("letter-spacing", Length(&["normal"])),
    ("word-spacing", Length(&["normal"])),
    ("text-transform", Words(&TEXT_TRANSFORM)),
    ("dominant-baseline", Word(&BASELINES)),
    ("writing-mode", Word(&WRITING)),
    ("direction", Word(&["ltr", "rtl"])),
];
/// Words that are named where no other is near.
const MAX_NAMED: usize = 4;

/// What to do about a value that nobody can read, if this is one.
pub(super) fn mistake(property: &str, value: &str) -> Option<String> {
    let (_, grammar) = PROPERTIES.iter().find(|(name, _)| *name == property)?;
    let value = value.trim().to_ascii_lowercase();
    let is_own = value.starts_with('-') && value.as_bytes().get(1).is_some_and(u8::is_ascii_alphabetic);
    let stands_for_another =
        ["var(", "env(", "attr(", "calc(", "min(", "max(", "clamp("].iter().any(|f| value.contains(f));
    if value.is_empty() || is_own || stands_for_another || FOR_ALL.contains(&&*value) {
        return None;
    }
    match grammar {
        Word(known) => word(&value, known),
        Words(known) => value.split_ascii_whitespace().filter(|one| !is_angle(one)).find_map(|one| word(one, known)),
        Share => number(&value, &["%"]).map_or_else(|| Some(said(&value, &[], "a number from 0 to 1")), |_| None),
        Number => sized(&value, &[], &[], "a number"),
        Length(words) => length(&value, words),
        Size(words) => sized(&value, &UNITS, words, if words.is_empty() { "a number" } else { "a size in numbers" }),
        Dashes if value == "none" => None,
        Dashes => {
            let each = value.split([' ', ',', '\t', '\n', '\r']).filter(|dash| !dash.is_empty());
            each.into_iter().find_map(|dash| sized(dash, &UNITS, &[], "none, or numbers, as in \"4 2\""))
        }
        Weight => {
            let is_number = number(&value, &[]).is_some_and(|weight| (1.0..=1000.0).contains(&weight));
            (!is_number).then(|| word(&value, &["normal", "bold", "bolder", "lighter"]))?
        }
        Effects(known) => effect(&value, known),
        Link(_) if value == "none" || value.contains("url(") => None,
        Link(element) => Some(format!("write none, or url(#ID) with the id of a <{element}>")),
    }
}

/// What to do about a word that is none of these.
fn word(value: &str, known: &[&'static str]) -> Option<String> {
    if known.iter().any(|word| word.eq_ignore_ascii_case(value)) {
        return None;
    }
    if let Some(meant) = class_typo::nearest(value, known.iter().copied()) {
        return Some(format!("did you mean `{meant}`?"));
    }
    let (named, others) = known.split_at(known.len().min(MAX_NAMED));
    let (last, first) = named.split_last()?;
    let more = if others.is_empty() { "" } else { ", or another of CSS's words" };
    Some(match first {
        [] => format!("write {last}"),
        _ if more.is_empty() => format!("write {} or {last}", first.join(", ")),
        _ => format!("write {}, {last}{more}", first.join(", ")),
    })
}

/// A length of any sign, or what to do.
fn length(value: &str, words: &[&'static str]) -> Option<String> {
    let is_read = words.contains(&value) || number(value, &UNITS).or_else(|| number(value, &["%"])).is_some();
    (!is_read).then(|| said(value, words, "a number"))
}

/// A size in one of these units, or what to do.
fn sized(value: &str, units: &[&str], words: &[&'static str], usual: &str) -> Option<String> {
    if words.contains(&value) {
        return None;
    }
    let percent: &[&str] = if units.is_empty() { &[] } else { &["%"] };
    match number(value, units).or_else(|| number(value, percent)) {
        Some(size) if size < 0.0 => Some(format!("it is never less than 0; write {usual}")),
        Some(_) => None,
        None => Some(said(value, words, usual)),
    }
}

/// What to write in place of what is no number.
fn said(value: &str, words: &[&'static str], usual: &str) -> String {
    let point = value.replacen(',', ".", 1);
    if point != value && point.parse::<f64>().is_ok() {
        return format!("did you mean `{point}`?");
    }
    let (amount, unit) = value.split_at(unit_start(value));
    let meant = if amount.parse::<f64>().is_ok() { class_typo::nearest(unit, UNITS) } else { None };
    if let Some(meant) = meant.filter(|_| usual.starts_with("a number") && !usual.contains("from")) {
        return format!("did you mean `{amount}{meant}`?");
    }
    match class_typo::nearest(value, words.iter().copied()) {
        Some(meant) => format!("did you mean `{meant}`?"),
        None => format!("write {usual}"),
    }
}

/// A number, alone or with one of these units.
fn number(value: &str, units: &[&str]) -> Option<f64> {
    let (amount, unit) = value.split_at(unit_start(value));
    let is_number = amount.ends_with(|last: char| last.is_ascii_digit() || last == '.');
    (is_number && (unit.is_empty() || units.contains(&unit))).then(|| amount.parse().ok())?
}

/// Where behind a number its unit begins.
fn unit_start(value: &str) -> usize {
    value.trim_end_matches(|letter: char| letter.is_ascii_alphabetic() || letter == '%').len()
}

/// How much `oblique` letters lean.
fn is_angle(word: &str) -> bool {
    number(word, &["deg", "grad", "rad", "turn"]).is_some()
}

/// What to do about functions that are none of these.
fn effect(value: &str, known: &[&'static str]) -> Option<String> {
    if value == "none" {
        return None;
    }
    let mut named = value.match_indices('(').map(|(at, _)| {
        let before = &value[..at];
        &before[before.rfind(|c: char| !c.is_ascii_alphanumeric() && c != '-').map_or(0, |at| at + 1)..]
    });
    if !value.contains('(') {
        return Some("write none, or url(#ID) with the id of a <filter>".to_string());
    }
    // Colours in a shadow are functions too, and Microsoft's words had a colon and a point.
    let is_other = value.contains("drop-shadow") || value.contains("progid:") || value.starts_with("alpha(");
    let wrong = named.find(|name| !known.contains(name)).filter(|_| !is_other)?;
    Some(match class_typo::nearest(wrong, known.iter().copied()) {
        Some(meant) => format!("did you mean `{meant}(...)`?"),
        None => "write none, or url(#ID) with the id of a <filter>".to_string(),
    })
}

#[cfg(test)]
mod tests {
    use super::mistake;

    #[test]
    fn a_value_that_nobody_reads_is_told_with_what_was_meant() {
        for (property, value, hint) in [
            ("opacity", "half", "write a number from 0 to 1"),
            ("fill-opacity", "1,5", "did you mean `1.5`?"),
            ("stop-opacity", "none", "write a number from 0 to 1"),
            ("stroke-width", "thick", "write a number"),
            ("stroke-width", "2mn", "did you mean `2mm`?"),
            ("stroke-linecap", "rond", "did you mean `round`?"),
            ("stroke-linecap", "flat", "write butt, round or square"),
            ("stroke-dasharray", "a b", "write none, or numbers, as in \"4 2\""),
            ("stroke-miterlimit", "-3", "it is never less than 0; write a number"),
            ("fill-rule", "even-odd", "did you mean `evenodd`?"),
            ("display", "nnone", "did you mean `none`?"),
            ("visibility", "hiden", "did you mean `hidden`?"),
            ("mix-blend-mode", "blend", "write normal, multiply, screen, overlay, or another of CSS's words"),
            ("filter", "blurr(2px)", "did you mean `blur(...)`?"),
            ("mask", "nope", "write none, or url(#ID) with the id of a <mask>"),
            ("clip-path", "circle(10px)", "write none, or url(#ID) with the id of a <clipPath>"),
            ("font-size", "big", "write a size in numbers"),
            ("font-weight", "bld", "did you mean `bold`?"),
            ("letter-spacing", "wide", "write a number"),
            ("paint-order", "stroke fil", "did you mean `fill`?"),
        ] {
            assert_eq!(mistake(property, value).as_deref(), Some(hint), "{property}: {value}");
        }
    }

    #[test]
    fn what_css_and_drawing_programs_write_is_no_mistake() {
        for good in [
            "opacity:.5",
            "opacity:50%",
            "opacity:1e-3",
            "fill-opacity:200%",
            "opacity:-1",
            "opacity:var(--half)",
            "stroke-width:calc(1px + 2%)",
            "stroke-width:2.5px",
            "stroke-width:1e1mm",
            "stroke-width:2em",
            "stroke-width:INHERIT",
            "stroke-width:0.26458332",
            "stroke-width:3%",
            "stroke-dasharray:none",
            "stroke-dasharray:4, 2 1",
            "stroke-dasharray:5%",
            "stroke-dasharray:4px,2px",
            "stroke-dashoffset:-3",
            "stroke-miterlimit:10",
            "stroke-linecap:Round",
            "fill-rule:EVENODD",
            "display:inline",
            "display:block flow",
            "display:-webkit-box",
            "visibility:revert",
            "mix-blend-mode:normal",
            "isolation:auto",
            "filter:url(#a) blur(2px)",
            "filter:drop-shadow(0 0 3px rgb(0 0 0 / 50%))",
            "mask:url(#m) luminance",
            "marker-end:url(#arrow)",
            "marker:none",
            "font-size:12pt",
            "font-size:x-large",
            "font-size:1.2rem",
            "font-weight:700",
            "font-weight:bolder",
            "font-style:oblique 10deg",
            "font-stretch:75%",
            "letter-spacing:-0.5px",
            "word-spacing:0",
            "text-transform:none",
            "paint-order:markers stroke fill",
            "vector-effect:non-scaling-stroke",
            "writing-mode:lr-tb",
            "color-interpolation-filters:sRGB",
            "stroke-linejoin:null",
            "clip-path:none",
            "wavy:2",
            "font-variant-caps:any",
            "opacity:",
        ] {
            let (property, value) = good.split_once(':').unwrap();
            assert_eq!(mistake(property, value), None, "{good}");
        }
    }
}
