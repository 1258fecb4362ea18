//! Magnets that are weaker than the slope.

use crate::table::Table;
use geometry::trig;
use physics::Kind;

const GRAVITY_M_S2: f64 = 9.81;

/// The magnets that pull less than the slope does, so that a ball rolls through them; each with what to say and that it is a
/// warning.
pub fn findings(table: &Table) -> Vec<(usize, String, bool)> {
    let slope_m_s2 = GRAVITY_M_S2 * trig::direction(table.layout.slope_rad).y;
    let parts = table.layout.parts.iter().enumerate();
    let weak = parts.filter_map(|(part, placed)| match &placed.kind {
        Kind::Magnet(magnet) if magnet.pull_m_s2 < slope_m_s2 => Some((part, magnet.pull_m_s2)),
        _ => None,
    });
    let told = |(part, pull_m_s2): (usize, f64)| {
        let what = format!(
            "its pull_m_s2, {pull_m_s2}, is less than what the slope pulls a ball down with, {slope_m_s2:.2} m/s^2, so it holds \
             none; give it ten times as much as the slope has"
        );
        (part, what, true)
    };
    weak.map(told).collect()
}
