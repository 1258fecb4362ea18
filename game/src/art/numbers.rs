//! Numbers in a drawing's attributes: none may be so large that the libraries lose themselves in it.
//!
//! An arc is cut into more curves the larger it is, so that one of 1e300 mm fills the memory before anybody sees it.

use resvg::usvg::roxmltree::Node;
use simplecss::DeclarationTokenizer;

/// The largest number that art may have anywhere: ten kilometres in a drawing.
const MAX_NUMBER: f64 = 1e7;

/// What is wrong with the numbers of an element, if anything is.
pub(super) fn mistake(node: Node) -> Option<String> {
    let too_large = |number: f64| format!("the number {number} in it is too large; {MAX_NUMBER} is the most");
    let values = node.attributes().filter(|own| is_number(own.name())).map(|own| own.value());
    let styled = node.attribute("style").into_iter().flat_map(DeclarationTokenizer::from);
    let values = values.chain(styled.filter(|own| is_number(own.name)).map(|own| own.value));
    let largest = values.map(largest).fold(0.0, f64::max);
    if largest > MAX_NUMBER {
        return Some(too_large(largest));
    }
    // A length in letters multiplies with each font size round it.
    let in_letters = |length: &str| length.contains("em") || length.contains("ex");
    let relative = ["r", "rx", "ry"].into_iter().find(|name| node.attribute(*name).is_some_and(in_letters));
    relative.map(|name| format!("its {name} is given in letters; give it as a number"))
}

/// Whether the numbers in an attribute decide how many curves a shape is cut into.
fn is_number(attribute: &str) -> bool {
    matches!(
        attribute,
        "d" | "points"
            | "x"
            | "y"
            | "width"
            | "height"
            | "r"
            | "rx"
            | "ry"
            | "cx"
            | "cy"
            | "font-size"
            | "stroke-width"
    )
}

/// The largest number in a text, without its sign.
pub(super) fn largest(text: &str) -> f64 {
    let bytes = text.as_bytes();
    let (mut at, mut most) = (0, 0.0);
    while at < bytes.len() {
        // What follows a `#` is the name of a colour or of an element.
        if bytes[at] == b'#' {
            at += bytes[at..].iter().take_while(|byte| !byte.is_ascii_whitespace() && **byte != b')').count();
        } else if is_start(bytes, at) {
            let end = number_end(bytes, at);
            most = text[at..end].parse().map_or(most, |number| f64::max(most, number));
            at = end;
        } else {
            at += 1;
        }
    }
    most
}

fn is_start(bytes: &[u8], at: usize) -> bool {
    let digit = |at: usize| bytes.get(at).is_some_and(u8::is_ascii_digit);
    digit(at) || (bytes[at] == b'.' && digit(at + 1))
}

/// The end of the number that starts at `start`.
fn number_end(bytes: &[u8], start: usize) -> usize {
    let digits = |from: usize| from + bytes[from..].iter().take_while(|byte| byte.is_ascii_digit()).count();
    let mut end = digits(start);
    if bytes.get(end) == Some(&b'.') {
        end = digits(end + 1);
    }
    if matches!(bytes.get(end), Some(b'e' | b'E')) {
        let sign = usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
        let exponent = digits(end + 1 + sign);
        end = if exponent > end + 1 + sign { exponent } else { end };
    }
    end
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_largest_number_of_a_text_is_found() {
        let cases = [
            ("", 0.0),
            ("M12-7.5e2L.5.25", 750.0),
            ("l.123456789.987654321", 0.987_654_321),
            ("3em 2e1em", 20.0),
            ("url(#p99999999) 4", 4.0),
            ("#12345678", 0.0),
            ("matrix(1e300,0)", 1e300),
            ("-2147483649", 2_147_483_649.0),
            ("1e999", f64::INFINITY),
            ("5e", 5.0),
            ("7.", 7.0),
        ];
        for (text, number) in cases {
            assert_eq!(largest(text), number, "{text}");
        }
    }
}
