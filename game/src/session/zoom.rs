//! How close the window looks at the table: a few steps that two keys go through.

/// The steps, the farthest first.
const STEPS: [f64; 7] = [1.0, 1.25, 1.5, 2.0, 2.5, 3.0, 4.0];

/// The next step closer.
pub fn closer(zoom: f64) -> f64 {
    STEPS.into_iter().find(|step| *step > zoom).unwrap_or(zoom)
}

/// The next step away.
pub fn farther(zoom: f64) -> f64 {
    STEPS.into_iter().rev().find(|step| *step < zoom).unwrap_or(zoom)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_ways_end_and_a_zoom_between_two_steps_finds_them() {
        assert_eq!((1..20).fold(1.0, |zoom, _| closer(zoom)), 4.0);
        assert_eq!((1..20).fold(4.0, |zoom, _| farther(zoom)), 1.0);
        assert_eq!((closer(1.7), farther(1.7)), (2.0, 1.5));
    }
}
