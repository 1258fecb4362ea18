//! The backdrop, which the table stands in: the wall of a night observatory, drawn once for a size.
//!
//! Blue-black, a few stars, and beside the table the graduated brass scale of an instrument.

use super::dmd;
use super::palette::{BRASS, IVORY};
use crate::screen::{Canvas, Color, Layer, Placement, Rect};
use geometry::rng::mix32;

const ZENITH: Color = 0x0c_1220;
const HORIZON: Color = 0x05_070c;
const DUSK: Color = 0x1b_2a4a;
const WELL: Color = 0x02_0306;

/// Draws all that lies around the table and behind the display.
pub fn draw(canvas: &mut Canvas, placement: &Placement) {
    let whole = Rect::new(0, 0, placement.width as i32, placement.height as i32);
    let mut layer = Layer::new(whole);
    layer.gradient(whole, ZENITH, HORIZON);
    stars(&mut layer, whole);
    let table = placement.table;
    layer.glow(table.centred(table.width * 9 / 4, table.height * 3 / 2), DUSK, 130);
    scale(&mut layer, placement);
    layer.fill(table.grown(frame_width(placement)), BRASS, 90);
    layer.fill(table.grown(frame_width(placement) - 1), WELL, 255);
    dmd::housing(&mut layer, placement.matrix);
    layer.lay(canvas);
}

fn frame_width(placement: &Placement) -> i32 {
    if placement.table.height > 300 { 3 } else { 1 }
}

/// Stars in places that only depend on the size, each about as far from the next as chance has it.
fn stars(layer: &mut Layer, whole: Rect) {
    let cell = 46;
    for row in 0..=whole.height / cell {
        for column in 0..=whole.width / cell {
            let seed = scatter(row as u32 * 7919 + column as u32 * 104_729 + 17);
            let (x, y) = ((seed & 0xff) as i32 * cell / 256, ((seed >> 8) & 0xff) as i32 * cell / 256);
            let brightness = (seed >> 16) & 0xff;
            let alpha = 14 + brightness * brightness / 900;
            let (x, y) = (column * cell + x, row * cell + y);
            layer.fill(Rect::new(x, y, 1, 1), IVORY, alpha);
            if brightness > 238 {
                let glint = [(1, 0), (-1, 0), (0, 1), (0, -1)];
                glint.iter().for_each(|(dx, dy)| layer.fill(Rect::new(x + dx, y + dy, 1, 1), IVORY, alpha / 3));
            }
        }
    }
}

/// Well-mixed bits of a number.
fn scatter(seed: u32) -> u32 {
    mix32(seed.wrapping_mul(0x9e37_79b9))
}

/// Graduations along both sides of the table: two hundred parts, every fifth and tenth longer.
fn scale(layer: &mut Layer, placement: &Placement) {
    let table = placement.table;
    let divisions = 200;
    if table.height < 2 * divisions {
        return;
    }
    let long = (table.width / 36).max(4);
    for part in 0..=divisions {
        let y = table.y + (table.height - 1) * part / divisions;
        let (length, alpha) = match part {
            part if part % 10 == 0 => (long, 120),
            part if part % 5 == 0 => (long * 2 / 3, 80),
            _ => (long / 3, 46),
        };
        let gap = frame_width(placement) + 2;
        layer.fill(Rect::new(table.x - gap - length, y, length, 1), BRASS, alpha);
        layer.fill(Rect::new(table.right() + gap, y, length, 1), BRASS, alpha);
    }
}
