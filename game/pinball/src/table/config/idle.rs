//! What the numbers say and nothing shows: coils that kick nobody, lamps of no power, saucers that hold no ball or every one,
//! and finishes that nothing has.

use super::Config;
use crate::table::source::{Diagnostic, Source};
use crate::table::svg::element::Element;
use crate::table::svg::element_class::{ElementClass, FASTEST_M_S};
use std::collections::BTreeSet;

/// A ball that is kicked less hardly comes away, m/s.
const LEAST_KICK_M_S: f64 = 0.05;
/// Only the hardest shots of a game are faster, m/s.
const MOST_THRESHOLD_M_S: f64 = 2.0;
/// Nobody sees a lamp of less power.
const LEAST_POWER: f64 = 0.01;
/// What rolls down the table over a hole is faster: it falls a few centimetres before it is there, m/s.
const LEAST_CAPTURE_M_S: f64 = 0.25;

/// What is idle of the numbers of these things, where the file says so.
pub(in crate::table) fn warnings(source: &Source, config: &Config, elements: &[Element]) -> Vec<Diagnostic> {
    // What a class says is told of the first thing of it.
    let mut places = BTreeSet::new();
    let numbers = elements.iter().filter_map(|element| of(config, element));
    let numbers = numbers.filter(|(place, _)| places.insert(*place)).collect::<Vec<_>>();
    let told = numbers.into_iter().chain(finishes(config, elements));
    told.map(|(at, what)| source.diagnostic(at, what).into_warning()).collect()
}

/// What is idle of one thing, with the place where the number is said.
fn of(config: &Config, element: &Element) -> Option<(usize, String)> {
    let Element { class, name, .. } = element;
    let given = |key| config.given(*class, name, key);
    let deaf =
        given("threshold_m_s").filter(|(threshold, _)| *threshold > MOST_THRESHOLD_M_S).map(|(threshold, at)| {
            let what = format!(
                "{name}: with `threshold_m_s` = {threshold} hardly any ball is fast enough for this {}; {} is usual",
                class.word(),
                class.parameters().iter().find(|own| own.name == "threshold_m_s").map_or(0.0, |own| own.default)
            );
            (at, what)
        });
    deaf.or_else(|| match class {
        ElementClass::Bumper | ElementClass::Slingshot => {
            let (kick, at) = given("kick_m_s").filter(|(kick, _)| *kick < LEAST_KICK_M_S)?;
            let word = class.word();
            Some((
                at,
                format!(
                    "{name}: with `kick_m_s` = {kick} this {word} kicks no ball; a real one kicks with about 1 m/s"
                ),
            ))
        }
        ElementClass::Lamp | ElementClass::Insert => {
            let (power, at) = given("power").filter(|(power, _)| *power < LEAST_POWER)?;
            Some((at, format!("{name}: with `power` = {power} it is dark whatever the rules say; a usual lamp has 1")))
        }
        ElementClass::Saucer => {
            let (capture, at) = given("capture_m_s")?;
            let so = match capture {
                _ if capture < LEAST_CAPTURE_M_S => "nearly every ball rolls over it",
                _ if capture > FASTEST_M_S => "no ball is ever too fast for it",
                _ => return None,
            };
            Some((
                at,
                format!(
                    "{name}: with `capture_m_s` = {capture} {so}; a real one catches what is slower than about 1 m/s"
                ),
            ))
        }
        _ => None,
    })
}

/// Finishes that nothing has.
fn finishes(config: &Config, elements: &[Element]) -> Vec<(usize, String)> {
    let drawn: BTreeSet<&str> =
        elements.iter().filter_map(|element| element.data.get("finish")).map(String::as_str).collect();
    let idle =
        config.finish_places.iter().filter(|(name, _)| !drawn.contains(name.as_str()) && !config.is_finished_by(name));
    let what = |name: &str| {
        format!(
            "nothing has the finish `{name}`; write finish = \"{name}\" to a [class.NAME] or a [part.ID], data-finish=\"{name}\" \
             to a thing, or take it out"
        )
    };
    idle.map(|(name, at)| (*at, what(name))).collect()
}
