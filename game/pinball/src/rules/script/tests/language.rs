//! What expressions and statements mean: what they mean in Rhai.

use super::{run, try_read, value};
use crate::rules::host;
use crate::rules::script::library;

/// The page for table makers.
const PAGE: &str = include_str!("../../../../../../assets/tables/README.md");

/// The expressions of the tests here.
pub fn expressions() -> impl Iterator<Item = &'static str> {
    EXPRESSIONS.iter().chain(CALLS).map(|(expression, _)| *expression)
}

/// Expressions and statements, with their values.
const EXPRESSIONS: &[(&str, &str)] = &[
    ("1 + 2 * 3 - 8 / 3 % 2", "7"),
    ("-7 / 2", "-3"),
    ("2 ** 10", "1024"),
    ("6 & 3 | 8 ^ 1", "11"),
    ("1 << 4 >> 2", "4"),
    ("1 < 2 && !(2 <= 1) || false", "true"),
    ("\"b\" > \"a\"", "true"),
    ("1 == \"1\"", "false"),
    ("[1, [2, ()]] == [1, [2, ()]]", "true"),
    ("#{ a: 1 } != #{ a: 2 }", "true"),
    ("\"a\" + 1 + true", "a1true"),
    ("`${1 + 1} of ${[\"x\", 3]}`", "2 of [\"x\", 3]"),
    ("[1, 2, 3][-1]", "3"),
    ("\"grün\"[2]", "ü"),
    ("\"grün\".len", "4"),
    ("#{ a: #{ b: [5, 6] } }.a.b[1]", "6"),
    ("#{ a: 1 }.b", "()"),
    ("#{}.a?.b?.c ?? 9", "9"),
    ("2 in [1, 2]", "true"),
    ("\"x\" in #{ x: 1 }", "true"),
    ("5 in 0..5", "false"),
    ("4 !in 0..=4", "false"),
    ("if 1 > 2 { \"a\" } else { \"b\" }", "b"),
    ("switch 7 { 1 | 7 => \"one\", _ => \"none\" }", "one"),
    ("switch 7 { 1 => 1, 5..8 => \"range\", _ => 2 }", "range"),
    ("switch \"b\" { \"a\" => 1, \"b\" if 1 > 2 => 2, \"b\" => 3 }", "3"),
    ("switch 9 { 1 => 1 }", "()"),
    ("{ let a = 1; { let a = 2; } a }", "1"),
    ("{ let n = 0; for i in 1..=4 { if i == 3 { continue; } n += i; } n }", "7"),
    ("{ let n = 0; for (item, i) in [5, 6] { n += item * i; } n }", "6"),
    ("{ let t = \"\"; for c in \"abc\" { t = c + t; } t }", "cba"),
    ("{ let n = 0; loop { n += 1; if n == 5 { break n * 2; } } }", "10"),
    ("{ let n = 9; while n > 3 { n -= 2; } n }", "3"),
    ("{ let n = 0; do { n += 1; } until n >= 4; n }", "4"),
    ("{ let l = [1]; l += 2; l += [3, 4]; l }", "[1, 2, 3, 4]"),
    ("{ let a = [1]; let b = a; b.push(2); a }", "[1]"),
    ("{ let m = #{}; m.x = 1; m[\"y\"] = [2]; m.y[0] += 5; m }", "#{\"x\": 1, \"y\": [7]}"),
    ("{ let t = \"\"; try { throw \"no\"; } catch (e) { t = e + \"!\"; } t }", "no!"),
    ("{ try { 1 } catch { 2 } }", "()"),
    (
        "{ let l = []; for i in range(0, 7, 3) { l += i; } for i in range(5, 0, -2) { l += i; } l }",
        "[0, 3, 6, 5, 3, 1]",
    ),
    ("`${1..3} ${1..=3}` + type_of(1..=3)", "1..3 1..=3range="),
    ("\"banana\" - \"an\"", "ba"),
    ("1 << -1", "0"),
    ("-8 >> 70", "-1"),
    ("`${()}` + () + [()]", "[()]"),
    ("{ let f = |x| x * 2; f.call(21) }", "42"),
    ("type_of(1) + type_of(\"\") + type_of([]) + type_of(#{})", "i64stringarraymap"),
    ("abs(-3) + (-4).abs() + max(1, 2) + min(1, 2)", "10"),
];

#[test]
fn expressions_have_the_values_that_rhai_gives_them() {
    for (expression, expected) in EXPRESSIONS {
        assert_eq!(value(expression), *expected, "{expression}");
    }
}

/// Calls of the functions of texts, lists and maps, with their values.
const CALLS: &[(&str, &str)] = &[
    ("\"Abc\".to_upper() + \"Abc\".to_lower()", "ABCabc"),
    ("\"abcb\".index_of(\"b\") + \"abcb\".index_of(\"b\", 2) + \"a\".index_of(\"x\")", "3"),
    ("\"abcdef\".sub_string(1, 3) + \"abc\".sub_string(-1)", "bcdc"),
    ("{ let t = \"a-b\"; t.replace(\"-\", \"++\"); t }", "a++b"),
    ("{ let t = \" a \"; t.trim(); t }", "a"),
    ("{ let t = \"7\"; t.pad(3, \"0\"); t }", "700"),
    ("\"a,b\".split(\",\")", "[\"a\", \"b\"]"),
    ("\"12\".parse_int() + 1", "13"),
    ("{ let l = [1, 2]; l.for_each(|i| this += i); l.for_each(|| this *= 2); l }", "[2, 6]"),
    ("\"\".index_of(\"\") + \"ab\".index_of(\"b\", -1) + [5].index_of(5, -9)", "0"),
    ("{ let l = [1, 2]; l.set(7, 5); l.set(-9, 6); [l, l.get(-9), l.get(2)] }", "[[6, 2], 6, ()]"),
    ("{ let l = [1, 2]; l.insert(-1, 7); l.insert(9, 8); l }", "[1, 7, 2, 8]"),
    ("[1, 2, 3].filter(|x| 1)", "[]"),
    ("\"abc\".starts_with(\"ab\") && \"abc\".ends_with(\"bc\") && \"abc\".contains(\"b\")", "true"),
    ("{ let l = [3, 1, 2]; l.sort(); l }", "[1, 2, 3]"),
    ("{ let l = [3, 1, 2]; l.sort(|a, b| b - a); l }", "[3, 2, 1]"),
    ("{ let l = [1, 1, 2, 1]; l.dedup(); l }", "[1, 2, 1]"),
    ("{ let l = [1, 2, 3, 4]; l.retain(|x| x > 2); l.insert(0, 9); l.reverse(); l }", "[4, 3, 9]"),
    ("{ let l = [1, 2, 3]; [l.pop(), l.shift(), l.remove(0), l.pop()] }", "[3, 1, 2, ()]"),
    ("{ let l = [1, 2, 3, 4]; l.truncate(3); l.chop(2); l.pad(4, 0); l.append([7]); l }", "[2, 3, 0, 0, 7]"),
    ("[1, 2, 3, 4].extract(1, 2) + [5, 6].extract(-1)", "[2, 3, 6]"),
    ("[1, 2, 3].map(|x, i| x * i).filter(|x| x > 0)", "[2, 6]"),
    ("[1, 2].map(|| this + 1)", "[2, 3]"),
    ("[1, 2, 3].reduce(|sum, x| sum + x, 0) + [4].index_of(4)", "6"),
    ("[1, 2].some(|x| x == 2) && [1, 2].all(|x| x > 0) && [1, 2].find(|x| x > 1) == 2", "true"),
    ("[1, 2].zip([3, 4], |a, b| a * b) + [1, 2].zip([3], |a, b, i| [a, b, i])", "[3, 8, [1, 3, 0]]"),
    ("[4, 5].reduce(|sum, x, i| sum + x * i, 0)", "5"),
    ("{ let l = [1, 2, 3]; [l.retain(|x| x > 1), l] }", "[[1], [2, 3]]"),
    ("#{ b: 1, a: 2 }.keys() + #{ b: 1, a: 2 }.values()", "[\"a\", \"b\", 2, 1]"),
    (
        "{ let m = #{ a: 1 }; m.mixin(#{ a: 2, b: 3 }); m.fill_with(#{ a: 9, c: 4 }); m.remove(\"b\"); m }",
        "#{\"a\": 2, \"c\": 4}",
    ),
    ("{ let l = [1, 2]; l.set(0, 5); [l.get(0), l.get(9), #{ a: 3 }.get(\"a\")] }", "[5, (), 3]"),
];

#[test]
fn the_functions_of_texts_lists_and_maps_do_what_rhai_says() {
    for (expression, expected) in CALLS {
        assert_eq!(value(expression), *expected, "{expression}");
    }
}

/// Where Rhai has a type for letters, and one for what `for` goes through.
#[test]
fn a_letter_is_a_text_and_the_letters_are_a_list() {
    assert_eq!(value("\"abc\".chars()"), "[\"a\", \"b\", \"c\"]");
    assert_eq!(value("type_of(\"abc\"[0]) + type_of('x')"), "stringstring");
}

#[test]
fn functions_get_copies_and_methods_change_what_they_are_called_on() {
    let script = "
const TWO = 2;
fn grow() { this.n += TWO; }
fn spoil(list) { list.push(9); list }
fn main() {
    this.a = #{ n: 1 };
    this.a.grow();
    let list = [1];
    let spoilt = spoil(list);
    this.out = [this.a.n, list, spoilt];
}";
    assert_eq!(run(script), Ok("[3, [1], [1, 9]]".into()));
}

#[test]
fn what_a_function_is_given_is_evaluated_from_left_to_right() {
    let script = "
fn next() { this.n += 1; this.n }
fn pair(a, b) { [a, b] }
fn main() { this.n = 0; this.out = [pair(this.next(), this.next()), max(this.next(), this.next())]; }";
    assert_eq!(run(script), Ok("[[1, 2], 4]".into()));
}

#[test]
fn an_error_leaves_what_it_met_as_it_was() {
    let script = "fn main() { this.out = [1]; try { this.out -= 1; } catch {} try { this.out[5] = 1; } catch {} }";
    assert_eq!(run(script), Ok("[1]".into()));
}

#[test]
fn what_is_wrong_in_play_is_said_with_its_line() {
    for (body, what) in [
        ("9223372036854775807 + 1", "9223372036854775807 + 1 is no whole number of 64 bits"),
        ("1 / 0", "1 cannot be divided by 0"),
        ("1 + ()", "`+` does not go between a i64 and a ()"),
        ("[1][1]", "there is no item 1 among 1"),
        ("#{}.a.b", "a () has no property \"b\""),
        ("if abs(1) { 2 }", "a condition must be true or false, not i64"),
        ("\"x\".push(1)", "push cannot be called with (string, i64)"),
        ("lamp(\"rde\", \"on\")", "there is no lamp called \"rde\" in the drawing; did you mean \"red\"?"),
        ("lamp(1, 2)", "lamp cannot be called with (i64, i64)"),
        ("LIST.push(1)", "push changes what it is called on, and this is a constant"),
        ("throw \"so\"", "so"),
    ] {
        let script = format!("const LIST = [1];\nfn main() {{\n  {body};\n}}");
        assert_eq!(run(&script), Err((3, what.into())), "{body}");
    }
}

#[test]
fn what_does_not_exist_is_found_before_play() {
    for (body, what) in [
        ("nothing_like_it(1)", "there is no function called nothing_like_it"),
        ("this.shake()", "there is no function called shake"),
        ("random()", "random cannot be called with 0 values: it is `random(n)`"),
        ("eval(\"1\")", "there is no function called eval"),
        ("nobody += 1", "there is no variable or constant called nobody here"),
        ("{ let inner = 1; } inner", "there is no variable or constant called inner here"),
        ("LIST = [2]", "a constant cannot be changed"),
        ("let n = 1; [1].map(|x| x + n)", "there is no variable or constant called n here"),
    ] {
        let mistakes = try_read(&format!("const LIST = [1];\nfn main() {{\n  {body};\n}}")).expect_err(body);
        assert_eq!(mistakes, [(3, what.to_string())], "{body}");
    }
}

#[test]
fn the_page_for_table_makers_names_every_function() {
    for name in library::all().map(|function| function.name).chain(host::all().map(|function| function.name)) {
        assert!(PAGE.contains(&format!("`{name}`")) || PAGE.contains(&format!("`{name}(")), "{name}");
    }
}
