//! The raster of the dot-matrix display: dots into pixels, amber lamps in rows behind smoked glass.

use super::dots::Dots;
use crate::hud::palette::BRASS;
use crate::screen::{Canvas, Color, DMD_COLUMNS, DMD_ROWS, Layer, Rect, over};
use geometry::{DVec2, Shape};

const GLASS: Color = 0x0a_0705;
const ASLEEP: Color = 0x22_1708;
const LIT: Color = 0xff_9d1e;
const HOT: Color = 0xff_d58c;

/// The glass and its brass bezel, without a dot.
pub fn housing(layer: &mut Layer, rect: Rect) {
    layer.fill(rect, GLASS, 255);
    layer.frame(rect, BRASS, 170);
    if rect.height > 60 {
        layer.frame(rect.grown(-2), BRASS, 40);
    }
}

/// A place of the display: how bright its dot is (none in the bezel), and the light that is scattered there.
type Cell = (Option<u8>, u32);

/// Places across and down: the dots and one place of the bezel all round.
const ACROSS: i32 = DMD_COLUMNS as i32 + 2;
const DOWN: i32 = DMD_ROWS as i32 + 2;

/// What stands on the frame: only places that change are drawn again.
pub struct DmdRaster {
    pitch: i32,
    sprite: Vec<u32>,
    colors: Vec<Color>,
    /// As they stand on the frame.
    cells: Vec<Cell>,
}

impl DmdRaster {
    /// A display that has drawn nothing yet, `pitch` pixels from dot to dot.
    pub fn new(pitch: i32) -> DmdRaster {
        let bare = (None, 0);
        let cells = vec![bare; (ACROSS * DOWN) as usize];
        DmdRaster { pitch, sprite: sprite(pitch), colors: (0..=255).map(lamp).collect(), cells }
    }

    /// Draws what has changed; the housing in `rect` must be there.
    pub fn draw(&mut self, canvas: &mut Canvas, rect: Rect, dots: &Dots) {
        let inner = rect.centred(ACROSS * self.pitch, DOWN * self.pitch);
        for (index, glow) in glows(dots).into_iter().enumerate() {
            let (column, row) = (index as i32 % ACROSS, index as i32 / ACROSS);
            let (x, y) = (column - 1, row - 1);
            let dot = (0..DMD_COLUMNS as i32).contains(&x) && (0..DMD_ROWS as i32).contains(&y);
            let cell = (dot.then(|| dots.level(x, y)), glow);
            if self.cells[index] != cell {
                self.cells[index] = cell;
                self.draw_cell(canvas, (inner.x + column * self.pitch, inner.y + row * self.pitch), cell);
            }
        }
    }

    fn draw_cell(&self, canvas: &mut Canvas, (left, top): (i32, i32), (level, glow): Cell) {
        let glass = over(GLASS, LIT, glow);
        let color = level.map_or(glass, |level| self.colors[usize::from(level)]);
        let cell = Rect::new(left, top, self.pitch, self.pitch);
        canvas.blend(cell, |index| (over(glass, color, self.sprite[index]), 255));
    }
}

/// How much of each pixel of a dot's cell the dot covers, of 255.
fn sprite(pitch: i32) -> Vec<u32> {
    let mut layer = Layer::new(Rect::new(0, 0, pitch, pitch));
    layer.shape(&Shape::disc(DVec2::splat(f64::from(pitch) * 0.5), f64::from(pitch) * 0.43), 0, 255);
    layer.coverage()
}

/// The colour of a dot: asleep, amber, and hotter at the top.
fn lamp(level: u32) -> Color {
    let warm = over(ASLEEP, LIT, level);
    over(warm, HOT, level.saturating_sub(150) * 2)
}

/// The light that the dots around each place scatter in the glass there, of 255, row by row: the mean of the nine
/// nearest and of the twenty-five nearest.
fn glows(dots: &Dots) -> Vec<u32> {
    // Along the rows first, then down the columns.
    let along = |x: i32, y: i32| {
        let near: u32 = (x - 1..=x + 1).map(|x| u32::from(dots.level(x, y))).sum();
        (near, near + u32::from(dots.level(x - 2, y)) + u32::from(dots.level(x + 2, y)))
    };
    let rows: Vec<(u32, u32)> =
        (-3..DOWN + 1).flat_map(|y| (-1..ACROSS - 1).map(move |x| (x, y))).map(|(x, y)| along(x, y)).collect();
    let at = |index: usize, row: usize| rows[index + row * ACROSS as usize];
    let glow = |index: usize| {
        let near: u32 = (1..4).map(|row| at(index, row).0).sum();
        let far: u32 = (0..5).map(|row| at(index, row).1).sum();
        (near / 9 + far / 25) * 28 / 255
    };
    (0..(ACROSS * DOWN) as usize).map(glow).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hud::dmd::dots::{FULL, Face};
    use tracer::Frame;

    #[test]
    fn what_has_changed_and_everything_anew_are_the_same_picture() {
        let rect = Rect::new(0, 0, ACROSS * 3 + 6, DOWN * 3 + 6);
        let empty = || Frame::new(rect.width as usize, rect.height as usize);
        let (mut kept, mut matrix) = (empty(), DmdRaster::new(3));
        for text in ["BALL SAVED", "77,440", ""] {
            let mut dots = Dots::default();
            dots.write(text, Face::Large, 3, 5, FULL);
            matrix.draw(&mut Canvas::new(&mut kept), rect, &dots);
            let mut anew = empty();
            DmdRaster::new(3).draw(&mut Canvas::new(&mut anew), rect, &dots);
            assert_eq!(kept, anew, "{text}");
        }
    }

    #[test]
    fn a_dot_scatters_its_light_as_far_as_the_second_place_around_it() {
        let mut dots = Dots::default();
        dots.light(40, 16, FULL);
        let lit = |index: i32| (index % ACROSS - 41).abs() <= 1 && (index / ACROSS - 17).abs() <= 1;
        for (index, glow) in glows(&dots).into_iter().enumerate() {
            let far = (index as i32 % ACROSS - 41).abs().max((index as i32 / ACROSS - 17).abs());
            let expected = if lit(index as i32) { (28 + 10) * 28 / 255 } else { 10 * u32::from(far <= 2) * 28 / 255 };
            assert_eq!(glow, expected, "{index}");
        }
    }
}
