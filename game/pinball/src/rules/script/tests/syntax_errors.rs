//! Scripts that cannot be read: each is told in one sentence, in the words of the house, with the line.

use super::try_read;

fn told(text: &str) -> String {
    let mistakes = try_read(text).err().unwrap_or_default();
    mistakes.iter().map(|(line, what)| format!("{line}: {what}")).collect::<Vec<_>>().join(" | ")
}

/// Broken scripts.
const BROKEN: [&str; 66] = [
    "fn on_start() {\n  score(1);\n",
    "fn on_start() {\n  if true {\n    score(1);\n}\nfn on_feed() {\n  score(2);\n}\n",
    "fn on_start() {\n  score(1);\n}\n}\n",
    "fn on_start() {\n  score(1;\n}\n",
    "fn on_start() {\n  score 1);\n}\n",
    "fn on_start() {\n  message(\"A, 0);\n}\n",
    "fn on_start() {\n  message(`A, 0);\n}\n",
    "fn on_start() {\n  message('ABC', 0);\n}\n",
    "fn on_start() {\n  score(1);\u{0}\n}\n",
    "\u{1f}\u{8b}\u{8}\u{0}x",
    "fn on_start() {\n  /* never closed\n  score(1);\n}\n",
    "fn on_switch(name) {\n  if name = \"x\" { score(1); }\n}\n",
    "fn on_start() {\n  async();\n}\n",
    "fn on_start() {\n  let var = 1;\n}\n",
    "fn on_start() {\n  var x = 1;\n}\n",
    "fn on_start() {\n  let x = 99999999999999999999;\n}\n",
    "fn on_start() {\n  let x = 5 5;\n}\n",
    "fn on_start() {\n  let = 5;\n}\n",
    "fn on_start() {\n  let x = ;\n}\n",
    "fn on_start() {\n  score(1,);\n  score(,1);\n}\n",
    "fn on_start() {\n  x++;\n}\n",
    "fn on_start() {\n  if true score(1);\n}\n",
    "fn on_start() {\n  if { score(1); }\n}\n",
    "fn on_start() {\n  else { score(1); }\n}\n",
    "fn on_start() {\n  switch 1 { _ => score(1), 2 => score(2) }\n}\n",
    "fn on_start() {\n  switch 1 { 2 = score(2) }\n}\n",
    "fn on_start() {\n  switch 1 { 1 => score(1) 2 => score(2) }\n}\n",
    "fn on_start() {\n  switch 1 { x => score(1) }\n}\n",
    "fn on_start {\n  score(1);\n}\n",
    "fn on_start()\n  score(1);\n",
    "fn () {\n  score(1);\n}\n",
    "fn on_start() {\n  fn inner() { score(1); }\n}\n",
    "fn on_start() {}\nfn on_start() {}\n",
    "fn f(a, a) {}\n",
    "fn on_start() {\n  let m = #{ a: 1, a: 2 };\n}\n",
    "fn on_start() {\n  let m = #{ a = 1 };\n}\n",
    "fn on_start() {\n  break;\n}\n",
    "fn on_start() {\n  if 5 { score(1); }\n}\n",
    "const X = 1;\nfn on_start() {\n  X = 2;\n}\n",
    "fn on_start() {\n  5 = x;\n}\n",
    "fn on_start() {\n  message(\u{201c}A\u{201d}, 0);\n}\n",
    "fn on_start() {\n  message(\"\\q\", 0);\n}\n",
    "fn on_start() {\n  score(1) @ 2;\n}\n",
    "fn on_start() {\n  for x of [1] { score(x); }\n}\n",
    "fn on_start() {\n  while true score(1);\n}\n",
    "function on_start() {\n  score(1);\n}\n",
    "fn on_start() {\n  let a = [1 2];\n}\n",
    "fn on_start() {\n  let a = #{ a: 1 b: 2 };\n}\n",
    "fn on_start() {\n  lamp(\"red\" \"on\");\n}\n",
    "fn on_switch(name {\n  score(1);\n}\n",
    "fn on_switch name) {\n  score(1);\n}\n",
    "fn on_switch(name) {\n  if name == == \"x\" { score(1); }\n}\n",
    "fn on_switch(name) {\n  if name == \"x\" and true { score(1); }\n}\n",
    "fn on_switch(name) {\n  if name == \"x\" { score(1); } elseif true { score(2); }\n}\n",
    "fn on_start() {\n  let x == 5;\n}\n",
    "fn on_start() {\n  let x 5;\n}\n",
    "const X;\n",
    "fn on_start() {\n  let x = 1;\n  x =+ 1;\n}\n",
    "fn on_start() {\n  switch 1 { 1 = > score(1) }\n}\n",
    "fn on_start() {\n  let x = null;\n}\n",
    "fn on_start() {\n  message(\"A\", 0)\n  score(1);\n}\n",
    "fn on_start() {\n  let x = \"a\n\";\n}\n",
    "fn on_start() {\n  do { score(1); }\n}\n",
    "fn on_start() {\n  this. = 1;\n}\n",
    "fn on_start() {\n  a::b();\n}\n",
    "fn on_start() {\n  if (true { score(1); }\n}\n",
];

#[test]
fn print_all() {
    for text in BROKEN {
        println!("{text}  --> {}\n", told(text));
    }
}
