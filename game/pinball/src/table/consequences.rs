//! Consequences: mistakes that a table has because of one that is told as a warning. Then that is the mistake, and they are
//! none: what is wrong beside it is told when it is mended.

use super::source::Diagnostic;

/// How a cause is told, and what comes of it.
const CAUSES: [([&str; 2], &[&str]); 2] = [
    (
        ["is hidden (`display: none`)", "a sheet says `display: none` of this"],
        &["the drawing has no ", " hides it (`display: none`)", "data-inside: no solid has the id"],
    ),
    (["width and height do not fit the viewBox"; 2], &["a captive ball is a pinball, so its r is"]),
];

/// Leaves the cause alone, as a mistake.
pub(super) fn joined(diagnostics: Vec<Diagnostic>) -> Vec<Diagnostic> {
    CAUSES.iter().fold(diagnostics, |diagnostics, (cause, effects)| {
        let is_cause = |one: &Diagnostic| one.is_warning() && cause.iter().any(|words| one.says(words));
        let is_effect = |one: &Diagnostic| !one.is_warning() && effects.iter().any(|words| one.says(words));
        let comes_of_it =
            diagnostics.iter().any(is_cause) && diagnostics.iter().any(|one| !one.is_warning() && one.says(effects[0]));
        if !comes_of_it {
            return diagnostics;
        }
        let left = diagnostics.into_iter().filter(|one| !is_effect(one));
        left.map(|one| if is_cause(&one) { one.into_mistake() } else { one }).collect()
    })
}
