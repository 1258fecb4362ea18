//! What calls cost. The steps of a call are held against the values and texts that it must touch, for every function
//! that there is and the largest values that there are.

use super::{PLENTY, read, run, steps};
use crate::rules::host;
use crate::rules::script::data::{Data, Entries, Range};
use crate::rules::script::library::{self, list_order};
use crate::rules::script::meter::{MAX_ITEMS, MAX_TEXT, Meter};
use crate::rules::script::{Interpreter, Script, Stop};
use geometry::rng::SplitMix64;

const FUNCTIONS: &str =
    "fn item(a) { a } fn first(a, b) { a } fn yes(a) { true } fn no(a) { false } fn this_one() { this }";

/// Functions that take no longer for a larger subject, with the types of subjects of which that is so.
const CONSTANT: [(&str, &[&str]); 15] = [
    ("type_of", &["array", "map", "string"]),
    ("len", &["array", "map"]),
    ("is_empty", &["array", "map", "string"]),
    ("clear", &["array", "map", "string"]),
    ("get", &["array", "map"]),
    ("set", &["array", "map"]),
    ("contains", &["map"]),
    ("remove", &["map"]),
    ("push", &["array"]),
    ("append", &["array"]),
    ("mixin", &["map"]),
    ("fill_with", &["map"]),
    ("pop", &["array"]),
    ("truncate", &["array"]),
    ("pad", &["array"]),
];

/// Copies, which only a test may make without paying.
fn copy(value: &Data) -> Data {
    value.copy(&mut Meter::new(PLENTY)).expect("plenty of steps")
}

/// The values in a value; a text by itself has one more for 16 bytes, while texts in a list or a map share theirs.
fn size(value: &Data) -> u64 {
    match value {
        Data::Text(text) => 1 + text.len() as u64 / 16,
        other => values_in(other),
    }
}

fn values_in(value: &Data) -> u64 {
    match value {
        Data::List(items) => 1 + items.iter().map(values_in).sum::<u64>(),
        Data::Map(entries) => 1 + entries.values().map(values_in).sum::<u64>(),
        _ => 1,
    }
}

/// What a function that goes through a value takes at least: an eighth of a step for each item.
fn least_steps(value: &Data) -> u64 {
    match value {
        Data::Text(text) => text.len() as u64 / 128,
        Data::List(items) => items.len() as u64 / 8,
        Data::Map(entries) => entries.len() as u64 / 8,
        _ => 0,
    }
}

/// The largest values of each type, and small ones.
fn values(script: &Script) -> Vec<Data> {
    let text = |length: usize| Data::text("ab".repeat(length / 2));
    let list = |count: usize| Data::List((0..count as i64).map(Data::Int).collect());
    let map = |count: usize| -> Data {
        Data::Map((0..count).map(|key| (format!("{key:0200}").into(), Data::count(key))).collect::<Entries>())
    };
    let same = Data::List((0..MAX_ITEMS).map(|_| text(2)).collect());
    let nested = Data::List((0..64).map(|_| list(64)).collect());
    let mut all = vec![text(MAX_TEXT), list(MAX_ITEMS), same, nested, map(MAX_ITEMS)];
    all.extend([text(2), list(2), map(2), Data::Int(0), Data::Int(1), Data::Int(4095), Data::Bool(true)]);
    all.push(Data::Range(Range::exclusive(0, i64::MAX)));
    all.extend((0..script.functions().count()).map(|number| Data::Function(number as u16)));
    all
}

fn is_nested(value: &Data) -> bool {
    matches!(value, Data::List(items) if !items.iter().all(|item| matches!(item, Data::Int(_))))
}

/// Every way to choose so many of the values.
fn choices(values: &[Data], count: usize) -> Vec<Vec<&Data>> {
    match count {
        0 => vec![Vec::new()],
        _ => {
            let with = |value, mut rest: Vec<_>| {
                rest.push(value);
                rest
            };
            let shorter = choices(values, count - 1);
            values.iter().flat_map(|value| shorter.iter().map(move |rest| with(value, rest.clone()))).collect()
        }
    }
}

#[test]
fn every_function_pays_for_what_it_reads_and_writes() {
    let script = read(FUNCTIONS);
    let values = values(&script);
    let arguments: Vec<Data> = values.iter().filter(|value| !is_nested(value)).map(copy).collect();
    // No function takes a map and something else, and to copy large maps for each pair takes long.
    let pairs: Vec<Data> = arguments.iter().filter(|value| !matches!(value, Data::Map(_))).map(copy).collect();
    for function in library::all() {
        for subject in values.iter().filter(|subject| size(subject) > 200) {
            let mut most = None;
            for count in function.least..=function.most {
                for arguments in choices(if count == 2 { &pairs } else { &arguments }, count) {
                    let mut changed = copy(subject);
                    let given = arguments.iter().map(|value| copy(value)).collect();
                    let call = |interpreter: &mut Interpreter| function.call(interpreter, &mut changed, given);
                    let Some((answer, paid)) = steps(call, &script) else { continue };
                    // What it was given was paid for before, and may be in what it gives or has changed.
                    let given = size(subject) + arguments.iter().map(|value| size(value)).sum::<u64>();
                    let copied = size(&answer).saturating_sub(if function.changes() { given } else { 0 });
                    let written = copied.max((size(&answer) + size(&changed)).saturating_sub(given));
                    let types: Vec<_> = arguments.iter().map(|value| value.type_name()).collect();
                    assert!(paid * 8 >= written, "{} {types:?}: {paid} steps for {written} values", function.name);
                    most = most.max(Some(paid));
                }
            }
            let Some(most) = most else { continue };
            let kind = subject.type_name();
            let constant = CONSTANT.iter().any(|(name, types)| *name == function.name && types.contains(&kind));
            let least = least_steps(subject);
            assert!(constant || most >= least, "{} of a {kind}: {most} steps, not {least}", function.name);
        }
    }
}

#[test]
fn what_is_said_to_be_constant_exists() {
    for (name, types) in CONSTANT {
        assert!(library::named(name).is_some() && !types.is_empty(), "{name}");
    }
}

#[test]
fn functions_of_the_game_pay_for_their_texts() {
    let script = read(FUNCTIONS);
    let long = || Data::text("ab".repeat(MAX_TEXT / 2));
    for function in host::all() {
        for count in function.least..=function.most {
            let given: Vec<Data> = (0..count).map(|_| long()).collect();
            let mut meter = Meter::new(PLENTY);
            let mut context = super::context();
            let mut interpreter =
                Interpreter { script: &script, meter: &mut meter, context: Some(&mut context), calls: 0 };
            let _ = interpreter.call_host(function, &given);
            let least = given.iter().map(size).sum::<u64>();
            assert!(meter.spent() >= least, "{} {count}: {} steps for {least}", function.name, meter.spent());
        }
    }
}

#[test]
fn operators_and_places_pay_for_what_they_copy_and_compare() {
    let head = "fn full() { let l = []; l.pad(4096, 1); l } fn long() { let t = \"\"; t.pad(4096, \"ab\"); t }";
    for (body, least) in [
        ("let a = full(); let b = a;", 2 * 4096),
        ("let a = full(); this.a = a; let b = this.a;", 3 * 4096),
        ("let a = full(); a == a;", 3 * 4096),
        ("let a = full(); [a];", 2 * 4096),
        ("let a = full(); `${a.extract(0, 500)}`;", 4096 + 1000),
        ("let a = full(); for x in a { break; }", 2 * 4096),
        ("let a = full(); switch a { 1 => 2 }", 2 * 4096),
        ("let a = full(); id(a);", 3 * 4096),
        ("let a = long(); a == a;", 4096 / 16),
        ("let a = long(); a[4000];", 2 * 4096 / 16),
        ("let a = long(); let b = a.sub_string(1) + \"x\";", 2 * 4096 / 16),
        ("let a = long(); let m = #{}; m[a] = 1; m[a];", 2 * 4096 / 16),
        ("let a = long(); for c in a {}", 4096),
        ("for i in 0..100000 {}", 100_000),
    ] {
        let script = read(&format!("{head} fn id(x) {{ x }} fn main() {{ {body} }}"));
        let number = (0..).zip(script.functions()).find(|(_, function)| function.name == "main").expect("a main").0;
        let mut this = Data::Map(Entries::new());
        let call = |interpreter: &mut Interpreter| interpreter.call(number, Vec::new(), Some(&mut this));
        let (_, paid) = steps(call, &script).unwrap_or_else(|| panic!("{body} fails"));
        assert!(paid >= least, "{body}: {paid} steps, not {least}");
    }
}

#[test]
fn nothing_grows_without_end() {
    for (body, what) in [
        ("let a = [1]; loop { a += a; }", "a list or a map may hold 4096 values and no more"),
        ("let s = \"x\"; loop { s += s; }", "a text may be 4096 bytes long and no longer"),
        ("let a = []; loop { a = [a]; }", "lists and maps may be nested 16 deep and no deeper"),
        ("let a = [[]]; loop { a.push([a.pop()]); }", "lists and maps may be nested 16 deep and no deeper"),
        ("let m = #{}; let i = 0; loop { i += 1; m[`${i}`] = i; }", "a list or a map may hold 4096 values and no more"),
        (
            "let a = \"aa\"; a.pad(4096, \"a\"); a.replace(\"a\", \"bb\");",
            "a text may be 4096 bytes long and no longer",
        ),
    ] {
        assert_eq!(run(&format!("fn main() {{ {body} }}")), Err((1, what.into())), "{body}");
    }
}

/// A script sorted by chance: Rust's own sort panics when it finds out, and the panic was printed on the way to a
/// sentence.
#[test]
fn a_comparison_that_contradicts_itself_is_told_and_leaves_the_list() {
    let script = read("fn compare(a, b) { random(3) - 1 }");
    for count in (0..300).step_by(7) {
        let before: Vec<i64> = (0..count).collect();
        let mut items: Vec<Data> = before.iter().copied().map(Data::Int).collect();
        let mut told = None;
        let sort = |interpreter: &mut Interpreter| -> Result<Data, Stop> {
            told = list_order::sort(interpreter, &mut items, Some(&Data::Function(0))).err();
            Ok(Data::Unit)
        };
        assert!(steps(sort, &script).is_some(), "{count} items");
        if let Some(Stop::Failed(failed)) = &told {
            assert!(failed.sentence("").starts_with("sort's function contradicts itself: "));
            assert_eq!(items.iter().map(number_of).collect::<Vec<_>>(), before, "after an error all is as before");
        }
        assert!(told.is_some() || count < 100, "{count} items by chance, and nobody has noticed");
    }
}

#[test]
fn a_function_that_lets_equal_values_go_first_sorts() {
    // What the README says of both and of neither: to a function that gives the same of both they are equal.
    for function in ["a <= b", "a < b", "a - b", "b.len() >= a.len()", "true", "1", "-1", "if a < b { -1 } else { 1 }"]
    {
        let list = if function.contains("len") { "[\"a\", \"\", \"b\", \"\"]" } else { "[2, 1, 2, 1, 3]" };
        assert!(run(&format!("fn main() {{ let l = {list}; l.sort(|a, b| {function}); }}")).is_ok(), "{function}");
    }
}

#[test]
fn a_sorted_list_has_the_order_of_its_twin() {
    let mut chance = SplitMix64::new(8);
    let script = read(FUNCTIONS);
    for count in 0..80 {
        let mut items: Vec<Data> = (0..count).map(|_| Data::Int(chance.below(20) as i64)).collect();
        let mut twin: Vec<i64> = items.iter().map(number_of).collect();
        let sort = |interpreter: &mut Interpreter| -> Result<Data, Stop> {
            list_order::sort(interpreter, &mut items, None)?;
            Ok(Data::Unit)
        };
        steps(sort, &script).expect("numbers have an order");
        twin.sort();
        assert_eq!(items.iter().map(number_of).collect::<Vec<_>>(), twin);
    }
}

fn number_of(value: &Data) -> i64 {
    match value {
        Data::Int(number) => *number,
        other => panic!("{other:?}"),
    }
}
