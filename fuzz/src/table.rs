//! A table that is made of bytes, and played: whatever stands on it, no ball is lost in numbers, and a saved game goes on.

use super::sample;
use pinball::{Buttons, Simulation};
use std::fmt::Write as _;
use std::sync::Arc;

/// Things that a table is made of, at most.
const MOST_THINGS: usize = 24;
/// Ticks that are played, at most.
const MOST_TICKS: usize = 300;

/// Makes a table of `bytes`, and plays it with what is left of them.
pub fn run(bytes: &[u8]) {
    let mut bytes = Source(bytes);
    let table = match sample::table(drawing(&mut bytes).as_bytes(), numbers(&mut bytes).as_bytes(), rules().as_bytes())
    {
        Err(failures) => return sample::assert_told(&failures),
        Ok(table) => table,
    };
    let mut simulation = match Simulation::new(Arc::new(table), 1) {
        Err(failure) => return sample::assert_told(&[failure]),
        Ok(simulation) => simulation,
    };
    let ticks = MOST_TICKS.min(50 + bytes.0.len() * 20);
    for tick in 0..ticks {
        let held = Buttons(bytes.0.get(tick / 20).copied().unwrap_or(0));
        simulation.tick(held.with(Buttons::START, tick < 10));
        for ball in simulation.pose().balls {
            assert!(ball.center.is_finite() && ball.velocity.is_finite(), "a ball is nowhere");
        }
    }
    let restored = simulation.restored(&simulation.save()).expect("what was saved can be restored");
    assert_eq!(restored.hash(), simulation.hash(), "a restored game is the same");
}

/// Bytes that are taken one after the other; when there are no more, zeros.
struct Source<'a>(&'a [u8]);

impl Source<'_> {
    fn byte(&mut self) -> u8 {
        let Some((first, rest)) = self.0.split_first() else { return 0 };
        self.0 = rest;
        *first
    }

    /// A place on the playfield, mm: fine near whole tens, so that things meet in corners.
    fn place(&mut self) -> (f64, f64) {
        let mut along = |size: f64| {
            let (coarse, fine) = (f64::from(self.byte()), f64::from(self.byte()));
            coarse / 255.0 * size + if fine < 128.0 { 0.0 } else { (fine - 192.0) / 16.0 }
        };
        (along(500.0), along(1000.0))
    }

    fn width(&mut self) -> f64 {
        [0.0, 1.0, 2.0, 4.0, 8.0, 26.5, 27.0, 27.1, 30.0, 60.0, 0.01, 200.0][usize::from(self.byte()) % 12]
    }
}

fn drawing(bytes: &mut Source) -> String {
    let mut svg = String::from(r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 500 1000">"#);
    svg.push_str(
        r#"<line id="left" class="flipper" data-side="left" data-up-deg="50" x1="150" y1="850" x2="210" y2="885"/>
<line class="drain" x1="100" y1="980" x2="400" y2="980" stroke-width="20"/>
<line id="plunger" class="plunger" x1="480" y1="900" x2="480" y2="950" stroke-width="24"/>
<path class="wall" d="M8 1000V8H496V1000M460 980V200" stroke-width="6" fill="none"/>"#,
    );
    let things = usize::from(bytes.byte()) % (MOST_THINGS + 1);
    for index in 0..things {
        thing(&mut svg, index, bytes);
    }
    svg.push_str("</svg>");
    svg
}

/// Draws one thing of a kind that the next byte says.
fn thing(svg: &mut String, index: usize, bytes: &mut Source) {
    let kind = bytes.byte() % 17;
    let ((x1, y1), (x2, y2), width) = (bytes.place(), bytes.place(), bytes.width());
    let extra = i32::from(bytes.byte()) * 2 - 256;
    let line = format!(r#"x1="{x1}" y1="{y1}" x2="{x2}" y2="{y2}" stroke-width="{width}""#);
    let circle = format!(r#"cx="{x1}" cy="{y1}" r="{width}""#);
    let drawn = match kind {
        0 => format!(r#"<line class="wall" {line}/>"#),
        1 => format!(
            r#"<path class="rubber" d="M{x1} {y1}A{width} {width} 0 0 1 {x2} {y2}L{y1} {x2}" stroke-width="3"/>"#
        ),
        2 => format!(r#"<circle class="post" {circle}/>"#),
        3 => format!(r#"<circle class="bumper" id="t{index}" {circle}/>"#),
        4 => format!(r#"<line class="slingshot" id="t{index}" {line}/>"#),
        5 => format!(r#"<line class="flipper" id="t{index}" data-side="right" data-up-deg="{}" {line}/>"#, extra.abs()),
        6 => format!(r#"<line class="target" id="t{index}" {line}/>"#),
        7 => format!(r#"<line class="drop-target" id="t{index}" {line}/>"#),
        8 => format!(r#"<line class="rollover" id="t{index}" {line}/>"#),
        9 => format!(r#"<line class="gate" id="t{index}" data-way="{extra}" {line}/>"#),
        10 => format!(r#"<line class="spinner" id="t{index}" {line}/>"#),
        11 => format!(r#"<circle class="saucer" id="t{index}" data-eject-deg="{extra}" data-eject-m-s="2" {circle}/>"#),
        12 => format!(r#"<line class="kickback" id="t{index}" {line}/>"#),
        13 => format!(r#"<circle class="magnet" id="t{index}" {circle}/>"#),
        14 => format!(r#"<line class="diverter" id="t{index}" data-turn-deg="{extra}" {line}/>"#),
        15 => format!(r#"<circle class="captive-ball" id="t{index}" cx="{x1}" cy="{y1}" r="13.5"/>"#),
        _ => format!(
            r#"<path class="ramp" id="t{index}" d="M{x1} {y1}L{x2} {y2}V{y1}" data-heights-mm="0 {} {}" stroke-width="{width}"/>"#,
            extra.abs() / 3,
            extra.abs() / 4
        ),
    };
    let _ = writeln!(svg, "{drawn}");
}

fn numbers(bytes: &mut Source) -> String {
    let slope = [6.5, 0.0, 1.0, 15.0][usize::from(bytes.byte()) % 4];
    format!("slope_deg = {slope}\n")
}

fn rules() -> &'static str {
    r#"fn on_button(name) {
    if name == "start" && !playing() { start_game(3); flippers(true); kickers(true); add_ball(); add_ball(); }
}
fn on_switch(name) {
    score(10);
    if name == "drain" && balls_in_play() == 0 { add_ball(); }
    after(300, "search");
}
fn on_timer(name) { add_ball(); }"#
}
