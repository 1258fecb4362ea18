//! The screen's geometry and its pixels: sizes, where the table and the displays are placed, and what is drawn on.
//!
//! It refuses to know what is shown: a table, a game or a key.

mod canvas;
mod contour;
mod layer;
mod placement;
mod size;

pub use canvas::{Canvas, Color, Rect, over};
pub use layer::{CachedLayer, Layer};
pub use placement::{DMD_COLUMNS, DMD_ROWS, Placement, ScreenFromTable, Side, title_height};
pub use size::Size;
