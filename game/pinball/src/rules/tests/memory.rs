//! What a script remembers is plain data: it survives saving, and nothing else does.

use super::bench::{Bench, table};
use crate::rules::{State, Value};
use proptest::prelude::*;

const RULES: &str = "
const STEP = 7;
const NAMES = [\"a\", \"b\"];
fn on_start() { this.count = 0; this.list = [1, \"two\", [true, ()]]; this.map = #{ b: 1, a: #{ c: \"x\" } }; }
fn grow(by) { this.count += by; }
fn on_launch() { this.grow(STEP); this.map.b += NAMES.len(); this.drawn = random(1000); after(5, \"t\"); }
fn on_timer(name) { this.list.push(name); }
";

#[test]
fn a_script_remembers_and_its_functions_know_its_constants() {
    let mut bench = Bench::new(table(RULES, &["lane"], &[])).expect("the rules are sound");
    bench.launch();
    bench.wait(10);
    assert_eq!(bench.rules.take_complaints(), Vec::<String>::new());
    let Value::Map(memory) = bench.rules.state().memory() else { panic!("a map") };
    assert_eq!(memory["count"], Value::Int(7));
    let Value::Map(map) = &memory["map"] else { panic!("a map") };
    assert_eq!(map["b"], Value::Int(3));
    let Value::List(list) = &memory["list"] else { panic!("a list") };
    assert_eq!(list.last(), Some(&Value::Text("t".into())));
}

#[test]
fn a_state_survives_its_bytes() {
    let mut bench = Bench::new(table(RULES, &["lane"], &[])).expect("the rules are sound");
    bench.launch();
    let bytes = postcard::to_stdvec(bench.rules.state()).expect("plain data");
    let back: State = postcard::from_bytes(&bytes).expect("what was written");
    assert_eq!(&back, bench.rules.state());
    assert_eq!(postcard::to_stdvec(&back).expect("plain data"), bytes);
    for state in [&back, bench.rules.state()] {
        let mut hashed = physics::Fingerprint::default();
        state.add_to(&mut hashed);
        let State { memory, script, search, .. } = bench.rules.state();
        let own = physics::fingerprint(&(memory, script, search));
        assert_eq!(hashed.finish(), own, "the bytes that are kept are its own, and no debt adds nothing");
    }
}

#[test]
fn a_function_cannot_be_remembered() {
    let rules = "fn on_launch() { this.good = 1; this.bad = |x| x + 1; }";
    let mut bench = Bench::new(table(rules, &["lane"], &[])).expect("the rules are sound");
    bench.launch();
    let complaints = bench.rules.take_complaints();
    assert!(complaints.len() == 1 && complaints[0].contains("cannot be remembered"), "{complaints:?}");
}

fn values() -> impl Strategy<Value = Value> {
    let leaf = prop_oneof![
        Just(Value::Unit),
        any::<bool>().prop_map(Value::Bool),
        any::<i64>().prop_map(Value::Int),
        "[a-z é\"]{0,8}".prop_map(Value::Text),
    ];
    leaf.prop_recursive(4, 32, 6, |inner| {
        prop_oneof![
            prop::collection::vec(inner.clone(), 0..6).prop_map(Value::List),
            prop::collection::btree_map("[a-z]{1,5}", inner, 0..6).prop_map(Value::Map),
        ]
    })
}

proptest! {
    #[test]
    fn the_script_sees_what_is_remembered(value in values()) {
        prop_assert_eq!(Value::from_script(value.to_script()), Ok(value));
    }
}
