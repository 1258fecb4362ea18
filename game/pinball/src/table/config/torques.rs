//! Torques of flippers and diverters: a coil that is weaker than the spring turns nothing, and each number by itself is right.

use super::Config;
use crate::table::source::{Diagnostic, Source};
use crate::table::svg::element::Element;
use crate::table::svg::element_class::ElementClass;
use std::collections::BTreeSet;

/// The things whose coil or whose hold is too weak, where the file says the number.
pub(in crate::table) fn mistakes(source: &Source, config: &Config, elements: &[Element]) -> Vec<Diagnostic> {
    let turns = |element: &&Element| matches!(element.class, ElementClass::Flipper | ElementClass::Diverter);
    // What a class says is told of the first thing of it.
    let mut places = BTreeSet::new();
    let found = elements.iter().filter(turns).flat_map(|element| of(source, config, element));
    found.filter(|(place, _)| places.insert(*place)).map(|(_, mistake)| mistake).collect()
}

/// What is wrong with one thing, each with the place where it is said.
fn of(source: &Source, config: &Config, element: &Element) -> Vec<(usize, Diagnostic)> {
    let number = |key| config.number(element.class, &element.name, key);
    let place = |key| config.given(element.class, &element.name, key).map(|(_, at)| at);
    let spring = number("spring_torque_n_m");
    if config.is_refused(element.class, &element.name, "spring_torque_n_m") {
        return Vec::new();
    }
    let too_weak = |(key, so): &(&'static str, &str)| {
        let torque = number(key);
        let at = place(key).or_else(|| place("spring_torque_n_m")).filter(|_| torque <= spring)?;
        let name = &element.name;
        let what = format!(
            "{name}: its `{key}`, {torque}, must be more than its `spring_torque_n_m`, {spring}, or it never {so}"
        );
        Some((at, source.diagnostic(at, what)))
    };
    [("coil_torque_n_m", "turns"), ("hold_torque_n_m", "stays turned")].iter().filter_map(too_weak).collect()
}
