//! Colours in every form that CSS has, as sRGB.

use color::Srgb;
use std::str::FromStr;

/// What SVG 1.1 lets follow a colour: the same colour for a printing press, which no screen uses.
const FOR_PRINT: [&str; 4] = ["icc-color(", "icc-named-color(", "device-gray(", "device-cmyk("];

/// Red, green, blue and opacity of a colour.
pub(in crate::table) fn parse(text: &str) -> Option<[u8; 4]> {
    let text = for_screens(text.trim());
    let plain = svgtypes::Color::from_str(text).ok();
    let plain = plain.map(|color| [color.red, color.green, color.blue, color.alpha]);
    plain.or_else(|| {
        // CSS Color 4 and 5: lab, oklch, color(display-p3 ...) and their like.
        let color = color::parse_color(text).ok()?;
        Some(color.to_alpha_color::<Srgb>().to_rgba8().to_u8_array())
    })
}

/// A colour in a form that every reader of SVG knows: as it is, or as `#rrggbb` or `#rrggbbaa`.
pub(in crate::table) fn plain(text: &str) -> Option<String> {
    let text = text.trim();
    let [red, green, blue, alpha] = parse(text)?;
    if is_plain(text) {
        return Some(text.to_string());
    }
    let opacity = if alpha == 255 { String::new() } else { format!("{alpha:02x}") };
    Some(format!("#{red:02x}{green:02x}{blue:02x}{opacity}"))
}

/// A `#` and digits, or a name: what no reader ever took for something else.
fn is_plain(text: &str) -> bool {
    text.strip_prefix('#').unwrap_or(text).bytes().all(|byte| byte.is_ascii_alphanumeric())
}

/// A colour without what follows it for print.
fn for_screens(text: &str) -> &str {
    let print = |at: &usize| {
        let rest = text[*at..].trim_start();
        FOR_PRINT.iter().any(|word| rest.get(..word.len()).is_some_and(|start| start.eq_ignore_ascii_case(word)))
    };
    let space = text.match_indices(|c: char| c.is_ascii_whitespace()).map(|(at, _)| at).find(print);
    space.map_or(text, |at| text[..at].trim_end())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_form_that_a_browser_takes_is_a_colour() {
        for red in [
            "red",
            "RED",
            "#f00",
            "#FF0000",
            "#ff0000ff",
            "rgb(255,0,0)",
            "rgb(100% 0% 0%)",
            "rgba(255, 0, 0, 1)",
            "RGB(255 0 0 / 100%)",
            "hsl(0 100% 50%)",
            "hsla(360deg, 100%, 50%, 1)",
            "hwb(0 0% 0%)",
            "color(srgb 1 0 0)",
            " red ",
        ] {
            assert_eq!(parse(red), Some([255, 0, 0, 255]), "{red}");
        }
        for red in ["lab(54.29 80.8 69.89)", "oklch(0.628 0.2577 29.23)"] {
            let [red, green, blue, _] = parse(red).unwrap();
            assert!(red >= 254 && green <= 1 && blue <= 1, "written with four digits: {red} {green} {blue}");
        }
        assert_eq!(parse("rgb(0 0 255 / 50%)"), Some([0, 0, 255, 128]));
        assert_eq!(parse("transparent"), Some([0; 4]));
        for wrong in ["", "#ff", "reddish", "icc-color(a, 1)", "#ff0000 blue", "url(#a)", "none"] {
            assert_eq!(parse(wrong), None, "{wrong}");
        }
    }

    #[test]
    fn what_follows_for_a_printing_press_is_left_out() {
        assert_eq!(parse("#cd853f icc-color(acmecmyk, 0.11, 0.48, 0.83, 0.00)"), Some([0xcd, 0x85, 0x3f, 255]));
        assert_eq!(plain("#CD853F  ICC-Color(swop, 1)").unwrap(), "#cd853f");
        assert_eq!(plain("red device-cmyk(0, 1, 1, 0)").unwrap(), "#ff0000");
    }

    #[test]
    fn plain_colours_stay_as_they_are() {
        for same in ["#Ab0", "#ff8000", "#ff800080", "Tomato"] {
            assert_eq!(plain(same).unwrap(), same);
        }
        assert_eq!(plain("hsl(120 100% 25%)").unwrap(), "#008000");
        assert_eq!(plain("rgb(0 0 255 / 50%)").unwrap(), "#0000ff80");
    }
}
