//! Members: which `Type::name` the sources define. Fields, variants, functions and constants of structures,
//! enumerations, traits and their implementations.

use std::collections::BTreeSet;

use super::code::{Word, is_word, words};

/// The members that a file's code defines, as (type, name).
pub fn members(code: &str) -> BTreeSet<(String, String)> {
    let words = words(code);
    let mut found = BTreeSet::new();
    for (at, word) in words.iter().enumerate() {
        let owner = match word.text {
            "struct" | "enum" | "trait" | "union" => words.get(at + 1).map(|name| name.text),
            "impl" if starts_item(&words, at) => implemented(&words[at + 1..]),
            _ => None,
        };
        let Some(owner) = owner.filter(|name| name.starts_with(char::is_uppercase)) else { continue };
        for name in names_in_braces(&words[at + 1..], word.text == "enum") {
            found.insert((owner.to_string(), name.to_string()));
        }
    }
    found
}

/// Whether the word at `at` stands where an item may begin: no `impl Trait` in a signature does.
fn starts_item(words: &[Word], at: usize) -> bool {
    at == 0 || ["{", "}", ";", "]", "unsafe"].contains(&words[at - 1].text)
}

/// The type that an implementation is of: the last name of the path after `for`, or after the generics.
fn implemented<'a>(words: &[Word<'a>]) -> Option<&'a str> {
    let mut depth = 0_i32;
    let mut name = None;
    for word in words {
        match word.text {
            "{" | ";" | "where" if depth == 0 => return name,
            "<" => depth += 1,
            ">" => depth -= 1,
            "for" if depth == 0 => name = None,
            text if depth == 0 && text.starts_with(is_word) => name = Some(text),
            _ => {}
        }
    }
    None
}

/// The names that the first braces define, not those inside of further braces: what follows `fn` or `const`, what stands
/// before a `:`, and the variants of an enumeration.
fn names_in_braces<'a>(words: &[Word<'a>], is_enum: bool) -> Vec<&'a str> {
    let mut found = Vec::new();
    let (mut braces, mut others) = (0, 0);
    for (at, word) in words.iter().enumerate() {
        match word.text {
            ";" if braces == 0 => break,
            "{" => braces += 1,
            "}" if braces == 1 => break,
            "}" => braces -= 1,
            "(" | "[" => others += 1,
            ")" | "]" => others -= 1,
            text if braces == 1 && others == 0 && text.starts_with(is_word) => {
                let before = if at == 0 { "" } else { words[at - 1].text };
                let after = words.get(at + 1).map_or("", |word| word.text);
                let is_variant = is_enum && ["{", ",", "]"].contains(&before);
                if ["fn", "const"].contains(&before) || after == ":" || is_variant {
                    found.push(text);
                }
            }
            _ => {}
        }
    }
    found
}

#[test]
fn members_are_read_as_the_compiler_does() {
    let code = "struct A<T> { #[x] pub b: Vec<T>, c: [u8; 2] }\nenum D { E, F { g: u8 }, H(u8) }\n\
                impl<T: Copy> Tr<T> for m::A<T> where T: Q { const I: u8 = 1; fn j(k: u8) { let l: u8 = k; } }\n\
                impl A<u8> { pub fn n() {} }\ntrait Tr { fn o(&self); }\nstruct P(u8);\nfn q() {}";
    let found: Vec<String> = members(code).into_iter().map(|(owner, name)| format!("{owner}::{name}")).collect();
    let expected = ["A::I", "A::b", "A::c", "A::j", "A::n", "D::E", "D::F", "D::H", "Tr::o"];
    assert_eq!(found, expected);
}
