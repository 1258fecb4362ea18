//! Cases, conditions and entries that nothing comes of.

use super::told;

#[test]
fn a_case_that_another_has_taken_is_told() {
    let rules = "fn on_switch(name) {\n  switch name {\n    \"dock\" => score(1),\n    \"drain\" => score(2),\n    \"dock\" => score(3),\n  }\n}";
    let twice = "this case is never reached: \"dock\" has a case before it; take one of them away, or join them";
    assert_eq!(told(rules), [format!("5: {twice}")]);
    assert_eq!(told("fn on_switch(name) { switch name { \"dock\" | \"dock\" => score(1) } }"), [format!("1: {twice}")]);
    let numbers = "fn on_feed() { switch ball() {\n1 => score(1),\n1 => score(2) } }";
    assert_eq!(
        told(numbers),
        ["3: this case is never reached: 1 has a case before it; take one of them away, or join them"]
    );
    for rules in [
        "fn on_switch(name) { switch name { \"dock\" if playing() => score(1), \"dock\" => score(2) } }",
        "fn on_feed() { switch ball() { 1 => score(1), 1..3 => score(2), _ => score(3) } }",
        "fn on_feed() { switch this.x { 1 => score(1), \"1\" => score(2) } this.x = 1; }",
    ] {
        assert_eq!(told(rules), Vec::<String>::new(), "{rules}");
    }
}

#[test]
fn a_condition_that_another_has_taken_is_told() {
    let taken = "this `else if` is never true: the condition on line 2 has already taken \"dock\"; take one of them away, or join them";
    let chain = |first: &str, second: &str| {
        format!(
            "fn on_switch(name) {{\nif {first} {{ score(1); }}\nelse if name == \"drain\" {{ score(2); }}\nelse if {second} {{ score(3); }} }}"
        )
    };
    for second in
        ["name == \"dock\"", "\"dock\" == name", "name == \"dock\" && playing()", "playing() && name == \"dock\""]
    {
        assert_eq!(told(&chain("name == \"dock\"", second)), [format!("4: {taken}")], "{second}");
    }
    assert_eq!(told(&chain("name == \"dock\" || name == \"target\"", "name == \"dock\"")), [format!("4: {taken}")]);
    for (first, second) in [
        ("name == \"dock\" && playing()", "name == \"dock\""),
        ("name == \"dock\"", "name == \"dock\" || name == \"target\""),
        ("name == \"dock\"", "name != \"dock\""),
        ("this.x == 1", "this.change() && this.x == 1"),
    ] {
        let rules = format!("{}\nfn change() {{ this.x = random(3); true }}", chain(first, second));
        assert_eq!(told(&rules), Vec::<String>::new(), "{first} {second}");
    }
    let separate = "fn on_switch(name) { if name == \"dock\" { score(1); } if name == \"dock\" { score(2); } }";
    assert_eq!(told(separate), Vec::<String>::new());
}

#[test]
fn conditions_that_contradict_themselves_are_told() {
    let never = "1: this is never true: nothing is \"left\" and \"right\" at once; write `||` for `&&`";
    assert_eq!(told("fn on_button(name) { if name == \"left\" && name == \"right\" { score(1); } }"), [never]);
    let always = "1: this is always true: whatever is \"left\" is not \"right\"; write `&&` for `||`";
    assert_eq!(told("fn on_button(name) { if name != \"left\" || name != \"right\" { score(1); } }"), [always]);
    for condition in
        ["name == \"left\" || name == \"right\"", "name != \"left\" && name != \"right\"", "this.x == 1 && this.y == 2"]
    {
        let rules = format!(
            "fn on_start() {{ this.x = 1; this.x += 1; this.y = now(); }} fn on_button(name) {{ if {condition} {{ score(1); }} }}"
        );
        assert_eq!(told(&rules), Vec::<String>::new(), "{condition}");
    }
}

/// A flag that nothing ever set kept its rule from ever being played.
#[test]
fn entries_that_only_ever_have_another_value_are_told() {
    let rules = |set: &str, asked: &str| {
        format!("fn on_start() {{ this.lit = false; {set} }}\nfn on_feed() {{ if {asked} {{ score(1); }} }}")
    };
    let never = "warning: 2: this.lit is asked here and is always false: no rule ever sets it to true";
    for asked in ["this.lit", "!this.lit", "playing() && this.lit", "this.lit || playing()"] {
        assert_eq!(told(&rules("", asked)), [never], "{asked}");
    }
    let mode = "warning: 2: this.mode is compared with \"multi\" here, and rules set it to \"one\" or \"two\" and to nothing else";
    assert_eq!(told(&rules("this.mode = \"two\"; this.mode = \"one\";", "this.mode == \"multi\"")), [mode]);
    for (set, asked) in [
        ("this.lit = true;", "this.lit"),
        ("this.lit = playing();", "this.lit"),
        ("this.set(\"lit\", true);", "this.lit"),
        ("for name in [\"lit\"] { this[name] = true; }", "this.lit"),
        ("this[\"lit\"] = true;", "this.lit"),
        ("this.count = 0; this.count += 1;", "this.count == 3"),
        ("this.count = [0]; this.count.push(1);", "this.count == 3"),
        ("", "this.lit == ()"),
        ("", "playing()"),
    ] {
        assert_eq!(told(&rules(set, asked)), Vec::<String>::new(), "{set} {asked}");
    }
}

/// `=+ 1` for `+= 1` set it to 1 for ever, and a reward at 5 never came: only what was asked with `==` was told.
#[test]
fn numbers_that_are_never_reached_are_told() {
    let rules = |set: &str, asked: &str| {
        format!("fn on_start() {{ this.hits = 0; {set} }}\nfn on_feed() {{ if {asked} {{ score(1); }} }}")
    };
    let set_to = |own: &str| format!("is never true here: rules set it to {own} and to nothing else");
    let never = |asked: &str, own: &str| format!("warning: 2: `this.hits {asked}` {}", set_to(own));
    assert_eq!(told(&rules("this.hits =+ 1;", "this.hits >= 5")), [never(">= 5", "0 or 1")]);
    assert_eq!(told(&rules("", "this.hits > 0")), [never("> 0", "0")]);
    assert_eq!(told(&rules("", "0 < this.hits && playing()")), [never("> 0", "0")]);
    assert_eq!(told(&rules("this.hits = 3;", "this.hits < 0")), [never("< 0", "0 or 3")]);
    let both = "warning: 2: `this.hits >= 5` and `this.hits < 3` are never true together";
    assert_eq!(told(&rules("this.hits += 1;", "this.hits >= 5 && this.hits < 3")), [both]);
    assert_eq!(told(&rules("this.hits += 1;", "this.hits < 3 && 5 <= this.hits")), [both]);
    let lost = "\nfn lost() { this.hits = 0; true }";
    for (set, asked) in [
        ("this.hits += 1;", "this.hits >= 5"),
        ("this.hits = 7;", "this.hits >= 5"),
        ("this.hits = \"many\";", "this.hits >= 5"),
        ("this.hits += 1;", "this.hits >= 3 && this.hits <= 3"),
        ("this.hits += 1;", "this.hits > 2 && this.hits < 4"),
        ("this.hits += 1;", "this.hits >= 5 && this.lost() && this.hits < 3"),
        ("this.hits += 1; this.more = this.hits;", "this.hits >= 5 && this.more < 3"),
    ] {
        assert_eq!(told(&(rules(set, asked) + lost)), Vec::<String>::new(), "{set} {asked}");
    }
}
