//! Values of properties in the form that every reader of SVG knows: a browser's newer words in older ones.

use crate::table::svg::color;

/// Properties that are a paint: nothing, a colour, or a gradient or pattern.
const PAINTS: [&str; 2] = ["fill", "stroke"];
/// Properties that are a colour.
const COLORS: [&str; 4] = ["color", "stop-color", "flood-color", "lighting-color"];
/// Properties whose words may be names, which have a case of their own.
const NAMES: [&str; 2] = ["font", "font-family"];
/// Properties that `unset` does not inherit, because they say something of one element.
const OWN: [&str; 8] =
    ["clip-path", "display", "filter", "flood-color", "lighting-color", "mask", "opacity", "stop-color"];
/// Where `initial` is not what is said by saying nothing, because an ancestor may say something.
const INITIAL: [(&str, &str); 9] = [
    ("fill", "black"),
    ("stroke", "none"),
    ("stroke-width", "1"),
    ("color", "black"),
    ("display", "inline"),
    ("fill-opacity", "1"),
    ("stroke-opacity", "1"),
    ("opacity", "1"),
    ("visibility", "visible"),
];

/// Whether a property is a colour or a paint.
pub(super) fn is_colored(name: &str) -> bool {
    PAINTS.contains(&name) || COLORS.contains(&name)
}

/// The value of a property in plain words, or nothing if it is none.
pub(super) fn plain(name: &str, value: &str) -> Option<String> {
    let value = value.trim();
    if value.is_empty() {
        return None;
    }
    if let Some(word) = for_all(name, &value.to_ascii_lowercase()) {
        return Some(word);
    }
    if PAINTS.contains(&name) {
        return paint(value);
    }
    if COLORS.contains(&name) {
        return word(value).or_else(|| color::plain(value));
    }
    let is_word = value.bytes().all(|byte| byte.is_ascii_alphabetic() || byte == b'-');
    let keyword = is_word && !name.starts_with("--") && !NAMES.contains(&name);
    Some(if keyword { value.to_ascii_lowercase() } else { value.to_string() })
}

/// Keywords that every property has.
fn for_all(name: &str, keyword: &str) -> Option<String> {
    let inherited = !OWN.contains(&name);
    let initial = || INITIAL.iter().find(|(known, _)| *known == name).map(|(_, value)| (*value).to_string());
    match keyword {
        "inherit" => Some("inherit".to_string()),
        "unset" | "revert" | "revert-layer" if inherited => Some("inherit".to_string()),
        "initial" | "unset" | "revert" | "revert-layer" => initial(),
        _ => None,
    }
}

/// The words beside colours.
fn word(value: &str) -> Option<String> {
    value.eq_ignore_ascii_case("currentcolor").then(|| "currentColor".to_string())
}

fn paint(value: &str) -> Option<String> {
    let lower = value.to_ascii_lowercase();
    if ["none", "context-fill", "context-stroke"].contains(&lower.as_str()) {
        return Some(lower);
    }
    if !lower.starts_with("url(") {
        return word(value).or_else(|| color::plain(value));
    }
    let end = value.find(')')?;
    let (link, rest) = value.split_at(end + 1);
    let link = format!("url{}", &link[3..]);
    let fallback = if rest.trim().is_empty() { Some(String::new()) } else { paint(rest.trim()) };
    // A gradient with a second choice that nobody knows is a gradient still.
    Some(format!("{link} {}", fallback.unwrap_or_default()).trim_end().to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keywords_have_no_case_and_names_have_one() {
        assert_eq!(plain("stroke-linecap", "ROUND").unwrap(), "round");
        assert_eq!(plain("font-family", "Cinzel").unwrap(), "Cinzel");
        assert_eq!(plain("fill", "CURRENTCOLOR").unwrap(), "currentColor");
        assert_eq!(plain("fill", "URL(#Glow) Red").unwrap(), "url(#Glow) Red");
        assert_eq!(plain("fill", "url(#glow) icc-red").unwrap(), "url(#glow)");
        assert_eq!(plain("stroke-width", "4px").unwrap(), "4px");
    }

    #[test]
    fn keywords_of_every_property_are_the_old_ones() {
        assert_eq!(plain("fill", "unset").unwrap(), "inherit");
        assert_eq!(plain("fill", "INITIAL").unwrap(), "black");
        assert_eq!(plain("opacity", "unset").unwrap(), "1");
    }

    #[test]
    fn a_value_that_is_none_is_told_from_others() {
        assert_eq!((plain("fill", "reddish"), plain("stop-color", "none"), plain("stroke", " ")), (None, None, None));
    }
}
