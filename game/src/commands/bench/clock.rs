//! Timing, medians and the pool that a bench runs on.

use std::time::Instant;

/// How long `work` takes, ms.
#[expect(clippy::disallowed_methods, reason = "a bench is a clock")]
pub fn time_ms(work: impl FnOnce()) -> f64 {
    let start = Instant::now();
    work();
    start.elapsed().as_secs_f64() * 1e3
}

/// The value that `part` of all values do not exceed; `part` is from 0 to 1 and there is at least one value.
pub fn quantile(values: &mut [f64], part: f64) -> f64 {
    values.sort_by(f64::total_cmp);
    values[((values.len() - 1) as f64 * part).round() as usize]
}
