//! Unseen: what of a table is there and shows nothing of itself: lamps without light, lines without width, hidden things.

use super::lamps;
use super::source::{Diagnostic, Source};
use super::svg::element::Element;
use super::svg::element_class::ElementClass;
use super::svg::outline::Outline;
use geometry::DVec2;

/// A lamp's colour gives hardly any light below this part of what white gives.
const DARK: f64 = 0.005;

/// Warns of what cannot be seen as its maker means it; of many alike once.
pub(super) fn warnings(source: &Source, elements: &[Element], has_mistakes: bool) -> Vec<Diagnostic> {
    let lamps = elements.iter().filter_map(|lamp| Some(source.diagnostic(lamp.at, dark(lamp)?)));
    let thin = "its line is 0 wide, so nobody sees it, and a ball bounces off it all the same; give it a stroke-width";
    let hidden = "its visibility is hidden, and it is there all the same; what is not to be there has display=\"none\"";
    let unlit = "its opacity is 0, and it shines all the same; what is not to shine has display=\"none\", or is switched off \
                 by the rules";
    let clear = "its opacity is 0, and it is there all the same; what is not to be there has display=\"none\"";
    // Of a thing with another mistake the place may be wrong for that.
    let corner = "its middle is the corner of the drawing, 0 0; say with cx and cy where it is";
    let once = [
        once(source, elements, is_thin, thin),
        once(source, elements, |element| element.is_hidden, hidden),
        once(source, elements, |element| is_clear(element) && !element.is_hidden, clear),
        once(source, elements, |element| element.is_clear && is_lamp(element) && !element.is_hidden, unlit),
        once(source, elements, |element| !has_mistakes && is_in_the_corner(element), corner),
    ];
    lamps.chain(once.into_iter().flatten()).map(Diagnostic::into_warning).collect()
}

/// Says it of the first of those that are so, and how many more there are.
fn once(source: &Source, elements: &[Element], is_so: impl Fn(&Element) -> bool, what: &str) -> Option<Diagnostic> {
    let mut those = elements.iter().filter(|element| is_so(element));
    let first = those.next()?;
    let more = match those.count() {
        0 => String::new(),
        more => format!(" (so it is with {more} more)"),
    };
    Some(source.diagnostic(first.at, format!("{}: {what}{more}", first.name)))
}

/// Whether a thing that can be seen or falls into says that it cannot.
fn is_clear(element: &Element) -> bool {
    element.is_clear && (element.class.has_finish() || element.class == ElementClass::Saucer)
}

/// Whether a round thing is where SVG puts it when nobody says a place.
fn is_in_the_corner(element: &Element) -> bool {
    element.outline.circle().is_some_and(|circle| circle.center == DVec2::ZERO)
}

fn is_lamp(element: &Element) -> bool {
    matches!(element.class, ElementClass::Lamp | ElementClass::Insert)
}

/// What to say of a lamp that gives hardly any light.
fn dark(lamp: &Element) -> Option<String> {
    let color = lamps::color(lamp).ok().filter(|color| is_lamp(lamp) && luminance(*color) < DARK)?;
    let (name, paint) = (&lamp.name, lamps::light_word(lamp));
    let [red, green, blue] = color;
    Some(match color {
        [0, 0, 0] => format!(
            "{name}: its {paint} is black, so it gives no light unless the rules give it a colour; SVG's {paint} is \
             black where nobody says another"
        ),
        _ => {
            // A fraction of 1 is a fraction of 255 there.
            let hint = if red.max(green).max(blue) <= 1 { "; the numbers of `rgb()` go to 255" } else { "" };
            format!(
                "{name}: its {paint} is read as #{red:02x}{green:02x}{blue:02x}, which is nearly black, so it gives hardly any \
                 light{hint}; write a brighter one, and make a lamp weaker with `power`"
            )
        }
    })
}

/// How bright an sRGB colour is, from 0 to 1, to a hundredth.
fn luminance(color: [u8; 3]) -> f64 {
    let [red, green, blue] = color.map(|channel| {
        let level = f64::from(channel) / 255.0;
        // The curve of sRGB as a polynomial.
        level * (level * (level * 0.305_306_011 + 0.682_171_111) + 0.012_522_878)
    });
    0.2126 * red + 0.7152 * green + 0.0722 * blue
}

/// Whether a thing is its line, and that has no width.
fn is_thin(element: &Element) -> bool {
    let is_line = element.class.is_static()
        || matches!(
            element.class,
            ElementClass::Slingshot
                | ElementClass::Target
                | ElementClass::DropTarget
                | ElementClass::Gate
                | ElementClass::Spinner
        );
    let is_closed = matches!(element.outline, Outline::Circle(_)) || element.outline.polygons().is_some();
    is_line && element.thickness_mm == 0.0 && !(is_closed && element.fill.is_painted())
}
