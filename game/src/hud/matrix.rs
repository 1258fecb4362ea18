//! Dots into pixels: amber lamps in rows behind smoked glass.

use super::canvas::{Canvas, Color, Rect, over};
use super::dots::{Dots, HEIGHT, WIDTH};

const GLASS: Color = 0x0a_0705;
const ASLEEP: Color = 0x22_1708;
const AMBER: Color = 0xff_9d1e;
const HOT: Color = 0xff_d58c;
const BRASS: Color = super::BRASS;

/// Draws the display in `rect`: a bezel of two dots all round, `pitch` pixels from dot to dot.
pub fn draw(canvas: &mut Canvas, rect: Rect, pitch: i32, dots: &Dots) {
    canvas.fill(rect, GLASS, 255);
    frame(canvas, rect);
    let sprite = sprite(pitch);
    let colors: Vec<Color> = (0..=255).map(lamp).collect();
    let inner = rect.centred(WIDTH as i32 * pitch, HEIGHT as i32 * pitch);
    for y in -1..=HEIGHT as i32 {
        for x in -1..=WIDTH as i32 {
            let glow = glow(dots, x, y);
            let (left, top) = (inner.x + x * pitch, inner.y + y * pitch);
            if glow > 0 {
                canvas.fill(Rect::new(left, top, pitch, pitch), AMBER, glow);
            }
            if (0..WIDTH as i32).contains(&x) && (0..HEIGHT as i32).contains(&y) {
                let color = colors[usize::from(dots.level(x, y))];
                for (index, &part) in sprite.iter().enumerate().filter(|(_, part)| **part > 0) {
                    canvas.dot(left + index as i32 % pitch, top + index as i32 / pitch, color, part);
                }
            }
        }
    }
}

fn frame(canvas: &mut Canvas, rect: Rect) {
    let line = |canvas: &mut Canvas, rect: Rect, alpha| {
        canvas.fill(Rect::new(rect.x, rect.y, rect.width, 1), BRASS, alpha);
        canvas.fill(Rect::new(rect.x, rect.bottom() - 1, rect.width, 1), BRASS, alpha);
        canvas.fill(Rect::new(rect.x, rect.y + 1, 1, rect.height - 2), BRASS, alpha);
        canvas.fill(Rect::new(rect.right() - 1, rect.y + 1, 1, rect.height - 2), BRASS, alpha);
    };
    line(canvas, rect, 170);
    if rect.height > 60 {
        line(canvas, rect.grown(-2), 40);
    }
}

/// How much of each pixel of a dot's cell the dot covers, of 255.
fn sprite(pitch: i32) -> Vec<u32> {
    let (middle, radius) = (f64::from(pitch) * 0.5, f64::from(pitch) * 0.43);
    let part = |index: i32| {
        let (x, y) = (f64::from(index % pitch) + 0.5 - middle, f64::from(index / pitch) + 0.5 - middle);
        let distance = (x * x + y * y).sqrt() - radius;
        ((0.5 - distance).clamp(0.0, 1.0) * 255.0) as u32
    };
    (0..pitch * pitch).map(part).collect()
}

/// The colour of a dot: asleep, amber, and hotter at the top.
fn lamp(level: u32) -> Color {
    let warm = over(ASLEEP, AMBER, level);
    over(warm, HOT, level.saturating_sub(150) * 2)
}

/// The light that a dot's neighbours scatter in the glass there, of 255.
fn glow(dots: &Dots, x: i32, y: i32) -> u32 {
    let ring = |reach: i32| -> u32 {
        let row = |y: i32| (x - reach..=x + reach).map(move |x| u32::from(dots.level(x, y))).sum::<u32>();
        (y - reach..=y + reach).map(row).sum()
    };
    (ring(1) / 9 + ring(2) / 25) * 28 / 255
}
