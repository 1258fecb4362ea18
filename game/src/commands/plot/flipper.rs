//! How high a press of the button lifts the flipper, and when.

use super::panel::{Axis, Panel};
use super::sheet::{self, Sheet, Words};
use super::{Drawn, fixture, ink};
use crate::screen::Size;
use crate::{Failure, Table};
use physics::{Controls, Flipper, Machine};

/// How long the button is down, ms.
pub const PRESSES_MS: [u32; 6] = [2, 4, 8, 12, 16, 24];
/// How long each stroke is watched, ms.
const WATCHED_MS: u32 = 180;
/// Nearer than this to its rest the flipper is back, deg.
const BACK_DEG: f64 = 0.5;

/// Every stroke of one flipper.
#[derive(Clone, Debug)]
pub struct Strokes {
    /// From rest to up, deg.
    pub stroke_deg: f64,
    /// One for each of [`PRESSES_MS`], then the one of a button that is held.
    pub strokes: Vec<Stroke>,
    /// From the press to the end of the stroke, ms.
    pub up_ms: f64,
    /// From the release of a flipper that is up until it stays at rest, ms.
    pub back_ms: f64,
    /// The tip's greatest speed on its way up, m/s.
    pub tip_m_s: f64,
}

/// What one press does.
#[derive(Clone, Debug)]
pub struct Stroke {
    /// How long the button is down, ms; `None` if it is held.
    pub press_ms: Option<u32>,
    /// How far the flipper is lifted from its rest, deg, at 0, 1, 2... ms after the press.
    pub lift_deg: Vec<f64>,
}

impl Stroke {
    /// The highest that the flipper comes, deg.
    pub fn peak_deg(&self) -> f64 {
        self.lift_deg.iter().copied().fold(0.0, f64::max)
    }
}

/// Presses the button of the table's first left flipper, which stands alone on a bare playfield.
///
/// # Errors
/// If the table has no left flipper.
pub fn measure(table: &Table) -> Result<Strokes, Failure> {
    let (part, flipper) = fixture::left_flipper(table)?;
    let fresh = fixture::live(fixture::bare(table, |other| other == part))?;
    let presses = PRESSES_MS.map(Some).into_iter().chain([None]);
    let strokes: Vec<Stroke> = presses.map(|press_ms| stroke(&fresh, flipper, press_ms)).collect();
    let stroke_deg = (flipper.up_rad - flipper.rest_rad).abs().to_degrees();
    let held = &strokes[PRESSES_MS.len()].lift_deg;
    let fastest_deg_ms = held.windows(2).map(|pair| pair[1] - pair[0]).fold(0.0, f64::max);
    Ok(Strokes {
        stroke_deg,
        up_ms: crossing(held, stroke_deg),
        back_ms: back_ms(&fresh, flipper),
        tip_m_s: fastest_deg_ms.to_radians() * 1000.0 * (flipper.length_m + flipper.tip_radius_m),
        strokes,
    })
}

fn stroke(fresh: &Machine, flipper: &Flipper, press_ms: Option<u32>) -> Stroke {
    let mut machine = fresh.clone();
    let lift_deg = |tick: u32| {
        if tick > 0 {
            let down = press_ms.is_none_or(|press| tick <= press);
            machine.tick(if down { fixture::LEFT } else { Controls::default() }, &[]);
        }
        lift_deg(&machine, flipper)
    };
    Stroke { press_ms, lift_deg: (0..=WATCHED_MS).map(lift_deg).collect() }
}

fn lift_deg(machine: &Machine, flipper: &Flipper) -> f64 {
    let way = 1.0_f64.copysign(flipper.up_rad - flipper.rest_rad);
    ((fixture::angle_rad(machine) - flipper.rest_rad) * way).to_degrees()
}

/// When the lift first reaches `goal_deg`, ms, straight between two ticks; the end of the watch if never.
fn crossing(lift_deg: &[f64], goal_deg: f64) -> f64 {
    let after = lift_deg.iter().position(|lift| *lift >= goal_deg);
    match after {
        Some(0) => 0.0,
        Some(after) => {
            let (low, high) = (lift_deg[after - 1], lift_deg[after]);
            (after - 1) as f64 + (goal_deg - low) / (high - low)
        }
        None => f64::from(WATCHED_MS),
    }
}

fn back_ms(fresh: &Machine, flipper: &Flipper) -> f64 {
    let mut machine = fresh.clone();
    (0..WATCHED_MS).for_each(|_| machine.tick(fixture::LEFT, &[]));
    let mut back_ms = 0.0;
    let mut before = lift_deg(&machine, flipper);
    for tick in 1..=2 * WATCHED_MS {
        machine.tick(Controls::default(), &[]);
        let lift = lift_deg(&machine, flipper);
        if before.abs() > BACK_DEG {
            let gone = (before - BACK_DEG.copysign(before)) / (before - lift);
            back_ms = f64::from(tick - 1) + gone.clamp(0.0, 1.0);
        }
        before = lift;
    }
    back_ms
}

/// The strokes as a picture.
///
/// # Errors
/// If it cannot be drawn.
pub fn draw(strokes: &Strokes, table: &Table, size: Size) -> Result<Drawn, Failure> {
    let words = Words {
        title: "One press of the button".into(),
        experiment: format!("The left flipper of {}, alone, after presses of different lengths", table.title),
        finding: format!(
            "Up in {:.1} ms, back in {:.0} ms, tip {:.1} m/s: a press of 2 ms lifts {:.1} deg, one of 8 ms {:.0} deg.",
            strokes.up_ms,
            strokes.back_ms,
            strokes.tip_m_s,
            strokes.strokes[0].peak_deg(),
            strokes.strokes[2].peak_deg(),
        ),
    };
    let frame = sheet::picture(size, &words, |sheet| curves(strokes, sheet))?;
    Ok(Drawn { frame, finding: words.finding })
}

fn curves(strokes: &Strokes, sheet: &Sheet) -> Result<(), Failure> {
    let highest = strokes.strokes.iter().map(Stroke::peak_deg).fold(strokes.stroke_deg, f64::max);
    let x = Axis::new("after the button went down, ms", 0.0..f64::from(WATCHED_MS), 10);
    let y = Axis::new("flipper above its rest, deg", -3.0..highest + 5.0, 7);
    let panel = Panel::new(sheet, sheet.curves(), &x, &y)?;
    let clear = 0.8 * f64::from(WATCHED_MS);
    panel.level((clear, 0.0), "rest")?;
    panel.level((clear, strokes.stroke_deg), &format!("up, {:.0} deg", strokes.stroke_deg))?;
    let mut entries = Vec::new();
    for (stroke, color) in strokes.strokes.iter().zip(ink::RAMP).rev() {
        let points = stroke.lift_deg.iter().enumerate().map(|(ms, lift)| (ms as f64, *lift));
        panel.line(points, 3.0, color)?;
        let press = stroke.press_ms.map_or("held".to_string(), |press| format!("{press} ms"));
        entries.push((color, format!("{press}: {:.1} deg", stroke.peak_deg())));
    }
    entries.reverse();
    sheet.legend("pressed for: peak", &entries)
}
