//! How long functions are and how much they ask for. Run with `--nocapture` to see the figures.

use super::code::{Word, words};
use super::tree::{self, crates, production, sources};

/// A function with a body.
struct Function {
    /// `path:line name`.
    place: String,
    /// From the line of `fn` to the line of the closing brace.
    lines: usize,
    /// With `self`, as clippy counts.
    parameters: usize,
}

/// The functions of blanked code.
fn functions(path: &str, code: &str) -> Vec<Function> {
    let words = words(code);
    let starts = (0..words.len()).filter(|&at| words[at].text == "fn" && is_name(&words, at + 1));
    starts.filter_map(|at| function(path, &words, at)).collect()
}

fn is_name(words: &[Word], at: usize) -> bool {
    words.get(at).is_some_and(|word| word.text.starts_with(|c: char| c.is_alphabetic() || c == '_'))
}

/// The function whose `fn` stands at `start`; none where it has no body.
fn function(path: &str, words: &[Word], start: usize) -> Option<Function> {
    let open = after_generics(words, start + 2);
    let close = closing(words, open);
    let body = (close..words.len()).find(|&at| ["{", ";"].contains(&words[at].text))?;
    if words[body].text == ";" {
        return None;
    }
    let line = words[start].line;
    Some(Function {
        place: format!("{path}:{line} {}", words[start + 1].text),
        lines: words[closing(words, body)].line - line + 1,
        parameters: parameters(&words[open + 1..close]),
    })
}

/// Past the generics that may start at `at`.
fn after_generics(words: &[Word], at: usize) -> usize {
    let mut depth = 0;
    let ends = |index: &usize| {
        depth += step(words[*index].text);
        depth == 0
    };
    if words[at].text == "<" { (at..words.len()).find(ends).expect("generics end") + 1 } else { at }
}

/// The bracket that closes the one at `open`.
fn closing(words: &[Word], open: usize) -> usize {
    let mut depth = 0;
    let closes = |at: &usize| {
        depth += match words[*at].text {
            "(" | "[" | "{" => 1,
            ")" | "]" | "}" => -1,
            _ => 0,
        };
        depth == 0
    };
    (open..words.len()).find(closes).expect("brackets close")
}

/// What a word adds to the depth in brackets, those of types counted too.
fn step(word: &str) -> i32 {
    match word {
        "(" | "[" | "{" | "<" => 1,
        ")" | "]" | "}" | ">" => -1,
        _ => 0,
    }
}

/// How many parameters a list between its brackets has.
fn parameters(list: &[Word]) -> usize {
    let (mut depth, mut count, mut empty) = (0, 0, true);
    for word in list {
        depth += step(word.text);
        if depth == 0 && word.text == "," {
            (count, empty) = (count + 1, true);
        } else {
            empty = false;
        }
    }
    count + usize::from(!empty)
}

/// Every function of every library, without test code.
fn all() -> Vec<Function> {
    let folders = crates().into_iter().map(|folder| format!("{folder}/src"));
    folders.flat_map(|folder| production(&folder)).flat_map(|source| functions(&source.path, &source.code)).collect()
}

fn report(title: &str, functions: &[Function]) {
    let mut lengths: Vec<_> = functions.iter().map(|function| function.lines).collect();
    lengths.sort_unstable();
    let part = |part: f64| lengths[(lengths.len() as f64 * part) as usize];
    let long = lengths.iter().filter(|&&lines| lines > LONG).count();
    println!("{title}: {} functions, median {} lines, 90th percentile {}", lengths.len(), part(0.5), part(0.9));
    println!("  longer than {LONG} lines: {long} ({:.2} %)", 100.0 * long as f64 / lengths.len() as f64);
    let mut longest: Vec<_> = functions.iter().collect();
    longest.sort_by_key(|function| std::cmp::Reverse(function.lines));
    for function in longest.iter().take(5) {
        println!("  {} lines: {}", function.lines, function.place);
    }
}

/// More lines than this are too long.
const LONG: usize = 70;
/// More parameters than this are too many.
const MOST: usize = 7;

/// How many functions may be too long, and how many may ask for too much: a table of cases, a kernel whose lanes are kept
/// in registers.
const EXCEPTIONS: usize = 2;

/// The functions of the test programs.
fn of_tests() -> Vec<Function> {
    let folders = crates().into_iter().map(|folder| format!("{folder}/tests")).chain(["tests".to_string()]);
    let present = folders.filter(|folder| tree::root().join(folder).exists());
    let files = present.flat_map(|folder| sources(&folder));
    files.flat_map(|source| functions(&source.path, &source.code)).collect()
}

#[test]
fn a_function_is_one_thought() {
    let (production, tests) = (all(), of_tests());
    report("production code", &production);
    report("test programs", &tests);
    let mut lengths: Vec<_> = production.iter().map(|function| function.lines).collect();
    lengths.sort_unstable();
    let median = lengths[lengths.len() / 2];
    assert!(median <= 7, "the median function has {median} lines");
    let long: Vec<_> = production.iter().chain(&tests).filter(|function| function.lines > LONG).collect();
    let places: Vec<_> = long.iter().map(|function| &function.place).collect();
    assert!(long.len() <= EXCEPTIONS, "longer than {LONG} lines: {places:#?}");
}

#[test]
fn a_function_asks_for_little() {
    let functions = all();
    for count in 5..=10 {
        println!("{count} parameters: {}", functions.iter().filter(|function| function.parameters == count).count());
    }
    let greedy = functions.iter().filter(|function| function.parameters > MOST).map(|function| &function.place);
    let greedy: Vec<_> = greedy.collect();
    assert!(greedy.len() <= EXCEPTIONS, "more than {MOST} parameters: {greedy:#?}");
}

#[test]
fn functions_are_measured_as_a_reader_would() {
    let code = "fn a() {}\ntrait T { fn b(&self); }\nfn c<F: Fn(u8, u8) -> [u8; 2]>(f: F, (x, y): (u8, u8), z: A<u8, u8>,) -> B\nwhere\n  F: Copy,\n{\n  if x { }\n}\nlet f: fn(u8) = g;";
    let found: Vec<_> = functions("p", code)
        .into_iter()
        .map(|function| (function.place, function.lines, function.parameters))
        .collect();
    assert_eq!(found, [("p:1 a".to_string(), 1, 0), ("p:3 c".to_string(), 6, 3)]);
}
