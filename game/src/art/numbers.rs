//! Numbers in a drawing's attributes: none may be so large that the libraries lose themselves in it.
//!
//! An arc is cut into more curves the larger it is, so that one of 1e300 mm fills the memory before anybody sees it; a
//! displacement of 1e9 is more than a whole number of pixels holds.

use resvg::usvg::roxmltree::Node;
use simplecss::DeclarationTokenizer;

/// The largest number that art may have anywhere: ten kilometres in a drawing.
const MAX_NUMBER: f64 = 1e7;

/// The smallest number but 0 that a step of a filter may have: what is divided by less is beyond single precision.
const MIN_FILTER_NUMBER: f64 = 1e-9;

/// What is wrong with the numbers of an element, if anything is.
pub(super) fn mistake(node: Node) -> Option<String> {
    let too_large = |number: f64| format!("the number {number} in it is too large; {MAX_NUMBER} is the most");
    let counts = |name: &str| is_number(name) || (is_filter_primitive(node) && !is_word(name));
    let values = node.attributes().filter(|own| counts(own.name())).map(|own| own.value());
    let styled = node.attribute("style").into_iter().flat_map(DeclarationTokenizer::from);
    let values = values.chain(styled.filter(|own| is_number(own.name)).map(|own| own.value));
    let [least, most] = values.map(range).fold(NO_NUMBERS, |[least, most], [l, m]| [least.min(l), most.max(m)]);
    if most > MAX_NUMBER {
        return Some(too_large(most));
    }
    if is_filter_primitive(node) && least < MIN_FILTER_NUMBER {
        return Some(format!("the number {least:e} in it is too small; write 0, or {MIN_FILTER_NUMBER:e} at least"));
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

/// Whether an element is a step of a filter, whose arithmetic is done in whole numbers here and there.
fn is_filter_primitive(node: Node) -> bool {
    node.tag_name().name().starts_with("fe")
}

/// Whether an attribute of a filter's step holds names, in which digits are no numbers.
fn is_word(attribute: &str) -> bool {
    matches!(attribute, "id" | "class" | "in" | "in2" | "result" | "href" | "style")
}

/// The range of no numbers at all.
const NO_NUMBERS: [f64; 2] = [f64::INFINITY, 0.0];

/// The smallest number but 0 and the largest number in a text, without their signs.
fn range(text: &str) -> [f64; 2] {
    let bytes = text.as_bytes();
    let (mut at, [mut least, mut most]) = (0, NO_NUMBERS);
    while at < bytes.len() {
        // What follows a `#` is the name of a colour or of an element.
        if bytes[at] == b'#' {
            at += bytes[at..].iter().take_while(|byte| !byte.is_ascii_whitespace() && **byte != b')').count();
        } else if is_start(bytes, at) {
            let end = number_end(bytes, at);
            if let Ok(number) = text[at..end].parse::<f64>() {
                most = most.max(number);
                least = if number > 0.0 { least.min(number) } else { least };
            }
            at = end;
        } else {
            at += 1;
        }
    }
    [least, most]
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
            assert_eq!(range(text)[1], number, "{text}");
        }
        assert_eq!(range("0 -3 1e-20 5"), [1e-20, 5.0]);
    }
}
