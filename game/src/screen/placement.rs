//! Where the table and the display are in a frame of some size.
//!
//! A tall frame has the display above the table, a broad one beside it: whichever leaves the larger table. Every
//! size has a place for the table, however small or odd; the display gives way first.

use super::Rect;
use geometry::DVec2;

/// Dots across the dot-matrix display (DMD).
pub const DMD_COLUMNS: usize = 128;
/// Dots down the dot-matrix display.
pub const DMD_ROWS: usize = 32;

/// Dots across and down.
const DOTS: (i32, i32) = (DMD_COLUMNS as i32, DMD_ROWS as i32);

/// Where everything is, in pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Placement {
    /// Pixels across.
    pub width: usize,
    /// Pixels down.
    pub height: usize,
    /// The playfield, with its own proportions (to the pixel).
    pub table: Rect,
    /// How far the playfield may move when the cabinet is pushed.
    pub well: Rect,
    /// The dot-matrix display; empty if there is no room for it.
    pub matrix: Rect,
    /// Pixels from dot to dot; 0 if there is no room for the matrix.
    pub pitch: i32,
    /// What is written next to the matrix.
    pub side: Side,
}

/// Where points of the table are in a frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScreenFromTable {
    /// The playfield's upper left corner, pixels; beyond the frame where that is not shown.
    pub origin: DVec2,
    /// Pixels a metre.
    pub px_per_m: f64,
}

/// Where the display's other parts are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Above the table: a cell on the left and on the right of the matrix.
    Band(Rect, Rect),
    /// Beside the table: all of the panel, with the matrix in it.
    Panel(Rect),
}

impl Placement {
    /// The placement for a frame of `width` x `height` pixels (1 or more each) of a table of `size_mm`.
    pub fn new(width: usize, height: usize, size_mm: DVec2) -> Placement {
        let (above, beside) = (Placement::above(width, height, size_mm), Placement::beside(width, height, size_mm));
        if beside.table.height > above.table.height { beside } else { above }
    }

    /// The display above the table.
    pub fn above(width: usize, height: usize, size_mm: DVec2) -> Placement {
        let (w, h) = (width as i32, height as i32);
        let pad = pad(w, h);
        let dots = (DOTS.0 + 2 * bezel(1), DOTS.1 + 2 * bezel(1));
        let pitch = (w * 3 / 4 / dots.0).min(h * 13 / 100 / dots.1).max(0);
        let bezel = bezel(pitch);
        let rows = if pitch > 0 { DOTS.1 * pitch + 2 * bezel } else { h / 10 };
        let band = Rect::new(pad, pad, w - 2 * pad, rows);
        let matrix = if pitch > 0 { band.centred(DOTS.0 * pitch + 2 * bezel, rows) } else { band.centred(0, 0) };
        let left = Rect::new(band.x, band.y, matrix.x - band.x - pad, rows);
        let right = Rect::new(matrix.right() + pad, band.y, band.right() - matrix.right() - pad, rows);
        let room = Rect::new(pad, band.bottom() + pad, w - 2 * pad, h - band.bottom() - 2 * pad);
        let table = fit(room, size_mm);
        let table = table.moved(0, room.y - table.y);
        let well = table.grown(pad).clipped(Rect::new(0, band.bottom(), w, h - band.bottom()));
        Placement { width, height, table, well, matrix, pitch, side: Side::Band(left, right) }
    }

    /// The display beside the table.
    pub fn beside(width: usize, height: usize, size_mm: DVec2) -> Placement {
        let (w, h) = (width as i32, height as i32);
        let pad = pad(w, h);
        let least = (h * 30 / 100).min(w / 2);
        let gap = 2 * pad;
        let table = fit(Rect::new(pad, pad, w - 2 * pad - gap - least, h - 2 * pad), size_mm);
        let room = (w - table.width - 2 * pad - gap).min(h * 62 / 100).max(0);
        let pitch = room / (DOTS.0 + 2 * bezel(1));
        let bezel = bezel(pitch);
        let (across, down) = (DOTS.0 * pitch + 2 * bezel, DOTS.1 * pitch + 2 * bezel);
        // The panel is as wide as the matrix, so that everything in it has the same two edges.
        let panel_width = if pitch > 0 { across } else { room };
        let left = (w - table.width - gap - panel_width) / 2;
        let table = table.moved(left - table.x, 0);
        let panel = Rect::new(table.right() + gap, pad, panel_width, h - 2 * pad);
        let matrix = if pitch > 0 && down < panel.height {
            Rect::new(panel.x + (panel.width - across) / 2, panel.y + title_height(panel), across, down)
        } else {
            Rect::new(panel.x, panel.y, 0, 0)
        };
        let pitch = if matrix.is_empty() { 0 } else { pitch };
        let well = table.grown(pad).clipped(Rect::new(0, 0, panel.x, h));
        Placement { width, height, table, well, matrix, pitch, side: Side::Panel(panel) }
    }
}

/// Space around things.
fn pad(width: i32, height: i32) -> i32 {
    (width.min(height) / 45).max(2)
}

/// The frame around the dots.
fn bezel(pitch: i32) -> i32 {
    2 * pitch
}

/// Room for the title above the matrix in a panel.
pub fn title_height(panel: Rect) -> i32 {
    (panel.width / 6).min(panel.height / 8)
}

/// The largest rectangle with the proportions of `size_mm` in the middle of `room`, a pixel at least.
fn fit(room: Rect, size_mm: DVec2) -> Rect {
    let scale = (f64::from(room.width.max(1)) / size_mm.x).min(f64::from(room.height.max(1)) / size_mm.y);
    let side = |mm: f64| ((mm * scale).round() as i32).max(1);
    room.centred(side(size_mm.x), side(size_mm.y))
}

#[cfg(test)]
mod tests {
    use super::*;

    const TABLE: DVec2 = DVec2::new(514.0, 1067.0);

    fn whole(width: usize, height: usize) -> Rect {
        Rect::new(0, 0, width as i32, height as i32)
    }

    #[test]
    fn a_tall_picture_has_its_display_above_and_a_broad_one_beside() {
        assert!(matches!(Placement::new(540, 1080, TABLE).side, Side::Band(..)));
        assert!(matches!(Placement::new(1920, 1080, TABLE).side, Side::Panel(_)));
    }

    #[test]
    fn the_larger_table_wins_at_every_size() {
        for (width, height) in (64..1400).step_by(61).flat_map(|w| (64..1400).step_by(53).map(move |h| (w, h))) {
            let chosen = Placement::new(width, height, TABLE).table;
            for other in [Placement::above(width, height, TABLE), Placement::beside(width, height, TABLE)] {
                assert!(chosen.height >= other.table.height, "{width}x{height}");
            }
        }
    }

    #[test]
    fn everything_is_inside_the_picture_and_nothing_covers_the_table() {
        for (width, height) in (64..1400).step_by(37).flat_map(|w| (64..1400).step_by(41).map(move |h| (w, h))) {
            let placement = Placement::new(width, height, TABLE);
            let parts = match placement.side {
                Side::Band(left, right) => [left, right, placement.matrix],
                Side::Panel(panel) => [panel, panel, placement.matrix],
            };
            for part in parts.into_iter().filter(|part| !part.is_empty()) {
                assert_eq!(part.clipped(whole(width, height)), part, "{width}x{height} {part:?}");
                assert!(part.clipped(placement.well).is_empty(), "{width}x{height} {part:?} {placement:?}");
            }
            assert_eq!(placement.table.clipped(whole(width, height)), placement.table, "{width}x{height}");
        }
    }

    #[test]
    fn the_table_keeps_its_proportions() {
        for (width, height) in [(540, 1080), (1920, 1080), (333, 777), (3840, 2160)] {
            let table = Placement::new(width, height, TABLE).table;
            let height_wanted = f64::from(table.width) * TABLE.y / TABLE.x;
            assert!((f64::from(table.height) - height_wanted).abs() < 2.1, "{width}x{height}: {table:?}");
        }
    }
}
