//! Foreign words: those of other languages, and what rules write for them.

use crate::rules::{host, signatures};

/// Words and signs.
const WORDS: [(&str, &str); 37] = [
    ("===", "write `==`"),
    ("!==", "write `!=`"),
    ("<>", "write `!=`"),
    (":=", "write `=`"),
    ("->", "a case of a `switch` is written with `=>`"),
    ("<-", "write `=`, or `<` and `-` apart"),
    ("++", "write `+= 1`"),
    ("--", "write `-= 1`"),
    ("...", "write `..`"),
    ("#", "a comment begins with `//`"),
    ("and", "write `&&`"),
    ("or", "write `||`"),
    ("not", "write `!`"),
    ("var", "write `let`"),
    ("null", "nothing is written `()`"),
    ("nil", "nothing is written `()`"),
    ("None", "nothing is written `()`"),
    ("undefined", "nothing is written `()`"),
    ("True", "write `true`"),
    ("False", "write `false`"),
    ("function", "write `fn`"),
    ("def", "write `fn`"),
    ("func", "write `fn`"),
    ("import", "they are one file; write its functions into this one"),
    ("include", "they are one file; write its functions into this one"),
    ("require", "they are one file; write its functions into this one"),
    ("export", "every function of this file is known in it"),
    ("class", "keep values in a map, `#{ name: value }`"),
    ("struct", "keep values in a map, `#{ name: value }`"),
    ("self", "what they remember is in `this`"),
    ("default", "the case for everything else is `_`"),
    ("case", "a case of a `switch` is written `\"name\" => ...`"),
    ("match", "write `switch`"),
    ("elseif", "write `else if`"),
    ("elif", "write `else if`"),
    ("elsif", "write `else if`"),
    ("goto", "write a function"),
];

/// Functions, and ours.
const FUNCTIONS: [(&str, &str); 20] = [
    ("size", "len"),
    ("length", "len"),
    ("count", "len"),
    ("add", "push"),
    ("push_back", "push"),
    ("delete", "remove"),
    ("has", "contains"),
    ("includes", "contains"),
    ("has_key", "contains"),
    ("indexOf", "index_of"),
    ("substr", "sub_string"),
    ("substring", "sub_string"),
    ("upper", "to_upper"),
    ("lower", "to_lower"),
    ("rand", "random"),
    ("str", "to_string"),
    ("int", "parse_int"),
    ("print", "message"),
    ("wait", "after"),
    ("sleep", "after"),
];

/// What rules write for a word or a sign of another language.
pub fn hint(sign: &str) -> Option<&'static str> {
    WORDS.iter().find(|(other, _)| *other == sign).map(|(_, hint)| *hint)
}

/// The function that is meant by another language's.
pub fn function(name: &str) -> Option<&'static str> {
    FUNCTIONS.iter().find(|(other, _)| *other == name).map(|(_, own)| *own)
}

/// What is told of a name that nothing has here.
pub fn unknown_name(name: &str) -> String {
    match hint(name) {
        Some(hint) => format!("rules have no `{name}`: {hint}"),
        None if name == "score" => {
            "score is a function, not a variable: `score()` is what the player has, and `score(10)` gives 10 points"
                .into()
        }
        None if host::named(name).is_some() => {
            format!("{name} is a function, not a variable: write {}", signatures::all_of(name))
        }
        None => format!("there is no variable or constant called {name} here"),
    }
}
