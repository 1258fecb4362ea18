//! The terminal: what leaves for it is text, whatever a file says.
//!
//! Names, ids, titles, paths and what rules complain of come from files. A terminal obeys control characters, and some
//! others that cannot be seen turn a line round or hide a part of it: each becomes its code point in braces, so nothing
//! that a file says can move the cursor, change colours or the window's title, or forge a line.

use std::borrow::Cow;

/// `text` as one line that a terminal only shows.
pub fn escaped(text: &str) -> Cow<'_, str> {
    if !text.contains(is_unsafe) {
        return Cow::Borrowed(text);
    }
    let each = text.chars().map(|c| if is_unsafe(c) { c.escape_unicode().to_string() } else { c.to_string() });
    Cow::Owned(each.collect())
}

/// Control characters (C0, DELETE, C1), marks and overrides of the writing direction, what has no width, line and
/// paragraph separators, and tags.
fn is_unsafe(c: char) -> bool {
    let unseen = matches!(c,
        '\u{ad}' | '\u{34f}' | '\u{61c}' | '\u{115f}'..='\u{1160}' | '\u{17b4}'..='\u{17b5}' | '\u{180b}'..='\u{180f}'
        | '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{206f}' | '\u{3164}' | '\u{feff}'
        | '\u{ffa0}' | '\u{fff9}'..='\u{fffb}' | '\u{e0000}'..='\u{e0fff}');
    c.is_control() || unseen
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_can_be_read_stays_and_what_a_terminal_obeys_is_shown_as_its_code_point() {
        for text in ["", "walls \u{2013} 100 %", "\u{dc}berraschung \u{65e5}\u{672c} \u{5e9}", "C:\\tables\\mine"] {
            assert_eq!(escaped(text), text);
        }
        assert_eq!(escaped("\u{1b}[31mred\u{1b}[0m"), "\\u{1b}[31mred\\u{1b}[0m");
        assert_eq!(escaped("a\nb\rc\td\u{7}"), "a\\u{a}b\\u{d}c\\u{9}d\\u{7}");
        assert_eq!(escaped("\u{9b}2J \u{85} \u{7f}"), "\\u{9b}2J \\u{85} \\u{7f}");
        assert_eq!(escaped("ok\u{202e}gpj.x\u{2066}\u{200f}"), "ok\\u{202e}gpj.x\\u{2066}\\u{200f}");
        assert_eq!(escaped("a\u{200b}b\u{feff}\u{e0041}"), "a\\u{200b}b\\u{feff}\\u{e0041}");
        for c in (0..=0x10_ffff).filter_map(char::from_u32).filter(|c| c.is_control()) {
            assert!(escaped(&c.to_string()).is_ascii() && !escaped(&c.to_string()).contains(c));
        }
    }
}
