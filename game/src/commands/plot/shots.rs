//! Where a cradled ball goes when the flipper is dropped and raised again.
//!
//! The experiment: on the table with nothing on it but its walls and its first left flipper, a ball lies still on the
//! raised flipper. The button is let go, the flipper falls, the ball rolls down it, and the button is pressed again so
//! many milliseconds after it was let go. The shot is the ball's velocity when it has left the flipper.

use super::panel::{Axis, Panel};
use super::sheet::{self, Place, Sheet, Words};
use super::{Drawn, fixture, ink};
use crate::screen::Size;
use crate::{Failure, Table};
use geometry::{DVec2, trig};
use physics::{BALL_RADIUS_M, Controls, Flipper, Kind, Machine};
use rayon::prelude::*;

/// How long a ball may take to lie still on the raised flipper, ms.
const CRADLE_MS: u32 = 4000;
/// A ball slower than this lies still, m/s.
const STILL_M_S: f64 = 1e-3;
/// The longest delay that is tried, ms.
const LONGEST_MS: u32 = 2000;
/// A ball this far from the flipper has left it, m.
const GONE_M: f64 = 5e-3;
/// Nearer than this to its rest the flipper has fallen, rad.
const FALLEN_RAD: f64 = 0.01;
/// A step back smaller than this is finer than anyone aims, deg.
const AIM_DEG: f64 = 0.05;
/// How long the flipper is watched after it is pressed, ms.
const WATCHED_MS: u32 = 120;

/// One shot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shot {
    /// From the release to the press, ms.
    pub delay_ms: u32,
    /// Where it goes: 0 is straight up the table, positive to the right, deg.
    pub angle_deg: f64,
    /// How fast, m/s.
    pub speed_m_s: f64,
}

/// The shots of a cradled ball.
#[derive(Clone, Debug)]
pub struct Shots {
    /// In the order of their delays.
    pub shots: Vec<Shot>,
    /// How long the flipper falls after the release, ms.
    pub fallen_ms: u32,
}

impl Shots {
    /// The longest row of shots of which each goes farther to the right than the one before, or as far but for 0.05 deg.
    pub fn rising(&self) -> &[Shot] {
        let rows = self.shots.chunk_by(|one, next| next.angle_deg > one.angle_deg - AIM_DEG);
        rows.max_by_key(|row| row.len()).unwrap_or(&[])
    }
}

/// The shots of a cradled ball, one for each `step_ms` of delay until it has rolled off the flipper.
///
/// # Errors
/// If the table has no left flipper, or no ball lies still on it.
pub fn measure(table: &Table, step_ms: u32) -> Result<Shots, Failure> {
    let (part, flipper) = fixture::left_flipper(table)?;
    let layout = fixture::bare(table, |other| other == part || matches!(other.kind, Kind::Wall(_)));
    let mut machine = cradled(fixture::live(layout)?, table, flipper)?;
    let (mut moments, mut fallen_ms) = (Vec::new(), 0);
    for delay_ms in 0..LONGEST_MS {
        if machine.pose().balls.is_empty() || has_passed(&machine, flipper) {
            break;
        }
        if delay_ms % step_ms == 0 {
            moments.push((delay_ms, machine.clone()));
        }
        machine.tick(Controls::default(), &[]);
        if (fixture::angle_rad(&machine) - flipper.rest_rad).abs() > FALLEN_RAD {
            fallen_ms = delay_ms + 1;
        }
    }
    let shots = moments.into_par_iter().filter_map(|(delay_ms, machine)| shoot(machine, flipper, delay_ms)).collect();
    Ok(Shots { shots, fallen_ms })
}

/// A machine with a ball that lies still on the raised flipper.
fn cradled(mut machine: Machine, table: &Table, flipper: &Flipper) -> Result<Machine, Failure> {
    (0..200).for_each(|_| machine.tick(fixture::LEFT, &[]));
    let outline = fixture::outline(flipper, flipper.up_rad);
    let [one, other] = outline.side_normals().unwrap_or([DVec2::NEG_Y; 2]);
    let normal = if one.y < other.y { one } else { other };
    let side = outline.side(normal);
    machine.put_ball(side.a.midpoint(side.b) + normal * BALL_RADIUS_M, DVec2::ZERO, [0.0; 3]);
    (0..CRADLE_MS).for_each(|_| machine.tick(fixture::LEFT, &[]));
    let ball = machine.pose().balls.first().copied();
    if ball.is_some_and(|ball| ball.velocity.length() < STILL_M_S && gap_m(&machine, flipper) < 1e-3) {
        return Ok(machine);
    }
    Err(Failure::new(format!(
        "no ball lies still on the raised left flipper of {}, so there is nothing to shoot; plot another table",
        table.name
    )))
}

/// From the ball to the flipper, m.
fn gap_m(machine: &Machine, flipper: &Flipper) -> f64 {
    let center = machine.pose().balls.first().map_or(DVec2::INFINITY, |ball| ball.center);
    fixture::outline(flipper, fixture::angle_rad(machine)).distance(center).0 - BALL_RADIUS_M
}

/// Whether the ball is below all that the flipper sweeps, or out of its reach.
fn has_passed(machine: &Machine, flipper: &Flipper) -> bool {
    let reach = flipper.length_m + flipper.tip_radius_m + BALL_RADIUS_M;
    let ball = machine.pose().balls[0];
    ball.center.distance(flipper.base.center) > reach + GONE_M
}

/// Presses, and waits until the ball has left; `None` if the flipper does not throw it up the table.
fn shoot(mut machine: Machine, flipper: &Flipper, delay_ms: u32) -> Option<Shot> {
    for _ in 0..WATCHED_MS {
        machine.tick(fixture::LEFT, &[]);
        let velocity = machine.pose().balls.first()?.velocity;
        let raised = (fixture::angle_rad(&machine) - flipper.up_rad).abs() < 0.02;
        if raised && velocity.y < 0.0 && gap_m(&machine, flipper) > GONE_M {
            let angle_deg = trig::angle(velocity.perp()).to_degrees();
            return Some(Shot { delay_ms, angle_deg, speed_m_s: velocity.length() });
        }
    }
    None
}

/// The shots as a picture: where they go, and below it how fast.
///
/// # Errors
/// If it cannot be drawn.
pub fn draw(shots: &Shots, table: &Table, size: Size) -> Result<Drawn, Failure> {
    let words = Words {
        title: "The later, the farther across".into(),
        experiment: format!("A ball cradled on the left flipper of {}: let go, then pressed again", table.title),
        finding: finding(shots),
    };
    let frame = sheet::picture(size, &words, |sheet| curves(shots, sheet))?;
    Ok(Drawn { frame, finding: words.finding })
}

fn finding(shots: &Shots) -> String {
    let fastest = shots.shots.iter().max_by(|one, other| one.speed_m_s.total_cmp(&other.speed_m_s));
    let (Some(fastest), [first, .., last]) = (fastest, shots.rising()) else {
        return "No delay throws the ball up the table.".into();
    };
    format!(
        "Later is farther right (to {AIM_DEG} deg) from {} ms, {:.0} deg, to {} ms, {:.0} deg; fastest {:.1} m/s at {} ms.",
        first.delay_ms, first.angle_deg, last.delay_ms, last.angle_deg, fastest.speed_m_s, fastest.delay_ms,
    )
}

fn curves(shots: &Shots, sheet: &Sheet) -> Result<(), Failure> {
    let all = sheet.curves();
    let middle = all.top + 0.62 * (all.bottom - all.top);
    let last = shots.shots.last().map_or(1, |shot| shot.delay_ms);
    let fastest = shots.shots.iter().map(|shot| shot.speed_m_s).fold(1.0, f64::max);
    let name = "from the release to the press, ms";
    let delays = || Axis::new(name, 0.0..f64::from(last) + 10.0, 10);
    let angles = Axis::new("angle, deg (right is positive)", -60.0..90.0, 9);
    let speeds = Axis::new("speed, m/s", 0.0..fastest * 1.1, 5);
    let above = Panel::new(sheet, Place { bottom: middle - 14.0, ..all }, &delays().unnamed(), &angles)?;
    let below = Panel::new(sheet, Place { top: middle + 14.0, ..all }, &delays(), &speeds)?;
    above.level((f64::from(shots.fallen_ms) + 8.0, 0.0), "straight up the table")?;
    above.moment(f64::from(shots.fallen_ms), "the flipper has fallen")?;
    below.moment(f64::from(shots.fallen_ms), "")?;
    let delay = |shot: &Shot| f64::from(shot.delay_ms);
    above.dots(shots.shots.iter().map(|shot| (delay(shot), shot.angle_deg)), 2.0, ink::RAMP[5])?;
    below.dots(shots.shots.iter().map(|shot| (delay(shot), shot.speed_m_s)), 2.0, ink::RAMP[2])?;
    sheet.legend("one dot a shot", &[(ink::RAMP[5], "where it goes".into()), (ink::RAMP[2], "its speed".into())])
}
