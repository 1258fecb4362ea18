//! Scripts that cannot be read: each is told in one sentence, in the words of the house, with the line.

use super::try_read;

/// What is told of a script, each mistake with its line.
fn told(text: &str) -> String {
    let mistakes = try_read(text).err().unwrap_or_default();
    mistakes.iter().map(|(line, what)| format!("{line}: {what}")).collect::<Vec<_>>().join(" | ")
}

/// Broken scripts, and what is told of them.
const BROKEN: [(&str, &str); 64] = [
    ("fn on_start() {\n  score(1);\n", "1: a `}` is missing: the `{` on this line is never closed"),
    (
        "fn on_start() {\n  if true {\n    score(1);\n}\nfn on_feed() {\n  score(2);\n}\n",
        "2: a `}` is missing: the `{` on this line is not closed before `fn on_feed` on line 5",
    ),
    (
        "fn on_start() {\n  score(1);\n}\n}\n",
        "4: this `}` closes nothing: take it away, or write the `{` that is missing before it",
    ),
    (
        "fn on_start() {\n  score(1;\n}\n",
        "2: a `)` is missing: the `(` on this line is not closed before the `}` on line 3",
    ),
    (
        "fn on_start() {\n  score 1);\n}\n",
        "2: this `)` closes nothing: take it away, or write the `(` that is missing before it",
    ),
    ("fn on_start() {\n  message(\"A, 0);\n}\n", "2: a text begins on this line and is not closed: a `\"` is missing"),
    (
        "fn on_start() {\n  message(`A, 0);\n}\n",
        "2: a text begins on this line and is not closed: a backtick is missing",
    ),
    ("fn on_start() {\n  message('ABC', 0);\n}\n", "2: between `'` and `'` stands one letter: write a text as \"...\""),
    (
        "fn on_start() {\n  score(1);\u{0}\n}\n",
        "2: here stands the character U+0000, which no script has: save the file as plain text (UTF-8)",
    ),
    (
        "\u{1f}\u{8b}\u{8}\u{0}x",
        "1: here stands the character U+001F, which no script has: save the file as plain text (UTF-8)",
    ),
    (
        "fn on_start() {\n  /* never closed\n  score(1);\n}\n",
        "2: a comment begins on this line and is never closed: a `*/` is missing",
    ),
    ("fn on_switch(name) {\n  if name = \"x\" { score(1); }\n}\n", "2: `=` sets a variable: to compare, write `==`"),
    ("fn on_start() {\n  async();\n}\n", "2: `async` is a word that the language keeps for itself: take another name"),
    (
        "fn on_start() {\n  let var = 1;\n}\n",
        "2: `var` is a word that the language keeps for itself: take another name",
    ),
    ("fn on_start() {\n  var x = 1;\n}\n", "2: rules have no `var`: write `let`"),
    (
        "fn on_start() {\n  let x = 99999999999999999999;\n}\n",
        "2: `99999999999999999999` is no whole number from -9223372036854775808 to 9223372036854775807",
    ),
    ("fn on_start() {\n  let x = 5 5;\n}\n", "2: a `;` is missing behind `5`"),
    ("fn on_start() {\n  let = 5;\n}\n", "2: a name is missing behind `let`"),
    ("fn on_start() {\n  let x = ;\n}\n", "2: a value is missing behind `=`, before `;`"),
    ("fn on_start() {\n  score(1,);\n  score(,1);\n}\n", "3: a value is missing behind `(`, before `,`"),
    ("fn on_start() {\n  x++;\n}\n", "2: rules have no sign `++`: write `+= 1`"),
    ("fn on_start() {\n  if true score(1);\n}\n", "2: a `{` is missing behind `true`"),
    ("fn on_start() {\n  if { score(1); }\n}\n", "2: a condition is missing behind `if`"),
    (
        "fn on_start() {\n  else { score(1); }\n}\n",
        "2: `else` stands behind the `}` of an `if`, and there is none here",
    ),
    (
        "fn on_start() {\n  switch 1 { _ => score(1), 2 => score(2) }\n}\n",
        "2: `_` is the case for everything else, and cases behind it would never be reached: put it last",
    ),
    ("fn on_start() {\n  switch 1 { 2 = score(2) }\n}\n", "2: a `=>` is missing behind `2`"),
    ("fn on_start() {\n  switch 1 { 1 => score(1) 2 => score(2) }\n}\n", "2: a `,` is missing behind `)`"),
    (
        "fn on_start() {\n  switch 1 { x => score(1) }\n}\n",
        "2: a case of a `switch` is a number, a text in quotes, `true`, `false` or `_`, and `=>` stands behind it",
    ),
    ("fn on_start {\n  score(1);\n}\n", "1: a `(` is missing: write `fn on_start()`, or parameters in it"),
    ("fn on_start()\n  score(1);\n", "1: a `{` is missing: the function `on_start` has no body"),
    ("fn () {\n  score(1);\n}\n", "1: a name is missing behind `fn`"),
    (
        "fn on_start() {\n  fn inner() { score(1); }\n}\n",
        "1: a `}` is missing: the `{` on this line is not closed before `fn inner` on line 2",
    ),
    (
        "fn on_start() {}\nfn on_start() {}\n",
        "2: there are two functions `on_start`: take one away, or put both into one",
    ),
    ("fn f(a, a) {}\n", "1: `f` has two parameters called `a`: give one another name"),
    ("fn on_start() {\n  let m = #{ a: 1, a: 2 };\n}\n", "2: the map has two entries `a`: take one away"),
    ("fn on_start() {\n  let m = #{ a = 1 };\n}\n", "2: a `:` is missing behind `a`"),
    ("fn on_start() {\n  break;\n}\n", "2: `break` and `continue` stand in a loop: `return` leaves a function"),
    ("fn on_start() {\n  if 5 { score(1); }\n}\n", "2: a condition must be true or false, not a number"),
    ("const X = 1;\nfn on_start() {\n  X = 2;\n}\n", "3: a constant cannot be changed"),
    (
        "fn on_start() {\n  5 = x;\n}\n",
        "2: only a variable or a part of one can be set with `=`; to compare, write `==`",
    ),
    (
        "fn on_start() {\n  message(\u{201c}A\u{201d}, 0);\n}\n",
        "2: `\u{201c}` is no quote that a script knows: write a text as \"...\"",
    ),
    (
        "fn on_start() {\n  message(\"\\q\", 0);\n}\n",
        "2: `\\q` means nothing in a text: a backslash is written `\\\\`, a quote `\\\"`",
    ),
    ("fn on_start() {\n  score(1) @ 2;\n}\n", "2: rules have no sign `@`: take it away, or write another"),
    ("fn on_start() {\n  for x of [1] { score(x); }\n}\n", "2: `in` is missing behind `x`"),
    ("fn on_start() {\n  while true score(1);\n}\n", "2: a `{` is missing behind `true`"),
    ("function on_start() {\n  score(1);\n}\n", "1: rules have no `function`: write `fn`"),
    ("fn on_start() {\n  let a = [1 2];\n}\n", "2: a `,` is missing behind `1`"),
    ("fn on_start() {\n  let a = #{ a: 1 b: 2 };\n}\n", "2: a `,` is missing behind `1`"),
    ("fn on_start() {\n  lamp(\"red\" \"on\");\n}\n", "2: a `,` is missing behind `\"red\"`"),
    ("fn on_switch(name {\n  score(1);\n}\n", "1: a `)` is missing: the `(` on this line is never closed"),
    (
        "fn on_switch name) {\n  score(1);\n}\n",
        "1: this `)` closes nothing: take it away, or write the `(` that is missing before it",
    ),
    (
        "fn on_switch(name) {\n  if name == == \"x\" { score(1); }\n}\n",
        "2: a value is missing behind `==`, before `==`",
    ),
    ("fn on_switch(name) {\n  if name == \"x\" and true { score(1); }\n}\n", "2: rules have no `and`: write `&&`"),
    (
        "fn on_switch(name) {\n  if name == \"x\" { score(1); } elseif true { score(2); }\n}\n",
        "2: rules have no `elseif`: write `else if`",
    ),
    ("fn on_start() {\n  let x == 5;\n}\n", "2: `==` compares: to set a variable, write `=`"),
    ("fn on_start() {\n  let x 5;\n}\n", "2: a `=` is missing behind `x`"),
    ("fn on_start() {\n  switch 1 { 1 = > score(1) }\n}\n", "2: a `=>` is missing behind `1`"),
    ("fn on_start() {\n  let x = null;\n}\n", "2: rules have no `null`: nothing is written `()`"),
    ("fn on_start() {\n  message(\"A\", 0)\n  score(1);\n}\n", "2: a `;` is missing behind `)`"),
    ("fn on_start() {\n  let x = \"a\n\";\n}\n", "2: a text begins on this line and is not closed: a `\"` is missing"),
    ("fn on_start() {\n  do { score(1); }\n}\n", "2: `while` is missing behind `}`"),
    ("fn on_start() {\n  this. = 1;\n}\n", "2: a name is missing behind `.`"),
    ("fn on_start() {\n  a::b();\n}\n", "2: rules have no `::`: they have no modules"),
    (
        "fn on_start() {\n  if (true { score(1); }\n}\n",
        "2: a `)` is missing: the `(` on this line is not closed before the `}` on line 3",
    ),
];

/// "Unexpected '}'", "NUL" and "Expecting ')'" said neither which bracket was meant nor what to do.
#[test]
fn broken_scripts_are_told_in_plain_words() {
    for (text, expected) in BROKEN {
        assert_eq!(told(text), expected, "{text}");
    }
}

/// Brackets that stand apart before a mistake of another kind do not hide it.
#[test]
fn the_first_mistake_is_told() {
    let missing = "fn on_start() {\n  score(1)\n  score(2);\n}\nfn on_feed() {\n";
    assert_eq!(told(missing), "2: a `;` is missing behind `)`");
    let text = "fn on_start() {\n  message(\"A } (\", 0); // {\n  score(1)\n  score(2);\n}\n";
    assert_eq!(told(text), "3: a `;` is missing behind `)`");
}

/// A text that never ends swallowed the brackets behind it, and one of them was told to be missing, lines away.
#[test]
fn a_quote_without_its_partner_is_told_on_its_own_line() {
    let text = "fn on_start() {\n  message(\"ALPHA, \"PRESS START\", 0);\n}\nfn on_feed() {\n}\n";
    assert_eq!(told(text), "2: a `\"` is missing on this line: texts stand between two of them");
}
