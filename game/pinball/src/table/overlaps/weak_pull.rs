//! Parts that pull balls more weakly than the slope does.

use crate::table::Table;
use geometry::trig;

const GRAVITY_M_S2: f64 = 9.81;

/// The parts that pull less than the slope does, so that a ball rolls through their field; each with what to say and that it
/// is a warning.
pub fn findings(table: &Table) -> Vec<(usize, String, bool)> {
    let slope_m_s2 = GRAVITY_M_S2 * trig::direction(table.layout.slope_rad).y;
    let parts = table.layout.parts.iter().enumerate();
    let pulls = parts.filter_map(|(part, placed)| Some((part, placed.kind.pull_m_s2()?)));
    let told = |(part, pull_m_s2): (usize, f64)| {
        let what = format!(
            "its pull_m_s2, {pull_m_s2}, is less than what the slope pulls a ball down with, {slope_m_s2:.2} m/s^2, so it holds \
             none; give it ten times as much as the slope has"
        );
        (part, what, true)
    };
    pulls.filter(|(_, pull_m_s2)| *pull_m_s2 < slope_m_s2).map(told).collect()
}
