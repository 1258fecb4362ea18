//! What filling and stroking a path takes: the pixels that it covers, and the steps along its edges.

use super::Counter;
use super::area::{Area, moved};
use crate::Failure;
use resvg::usvg::tiny_skia_path::PathSegment;
use resvg::usvg::{Paint, Path, Stroke, Transform};

/// Bands into which what a path covers is cut, from the top down.
const BANDS: usize = 32;
/// Lines of subpixels in a pixel, each of which meets every edge that crosses it.
const SUBPIXEL_LINES: f64 = 4.0;
/// Operations for each segment, in which curves are cut into lines.
const SEGMENT: f64 = 40.0;
/// Operations for a segment's two sides and its join, when it is stroked.
const STROKED_SEGMENT: f64 = 400.0;
/// A dash is a path of its own.
const DASH: f64 = 400.0;
/// How many times longer than a colour other paints take.
const GRADIENT: f64 = 4.0;
const PATTERN: f64 = 24.0;

/// A path, measured.
struct Measured {
    /// Pixels that its inside covers, at most.
    covered: f64,
    /// Its length, px.
    length: f64,
    /// Steps along its edges.
    steps: f64,
    segments: f64,
}

impl Counter<'_> {
    pub(super) fn path(&mut self, path: &Path, transform: Transform, target: Area) -> Result<(), Failure> {
        let layers = self.layers;
        self.tally.inside(path.id(), |tally| Counter { layers, tally }.own_path(path, transform, target))
    }

    fn own_path(&mut self, path: &Path, transform: Transform, target: Area) -> Result<(), Failure> {
        self.near(Area::transformed(&path.data().bounds(), transform))?;
        let reach = self.near(Area::transformed(&path.stroke_bounding_box(), transform))?;
        if !path.is_visible() {
            return Ok(());
        }
        let shown = reach.rounded_out().cut_to(&target);
        let measured = measure(path, transform, &shown);
        if let Some(fill) = path.fill() {
            self.paint(fill.paint(), transform)?;
            self.tally.spend(measured.covered * factor(fill.paint()) + measured.steps + SEGMENT * measured.segments);
        }
        if let Some(stroke) = path.stroke() {
            self.paint(stroke.paint(), transform)?;
            self.tally.spend(stroked(stroke, &measured, scale(transform), shown.pixels()));
        }
        Ok(())
    }
}

/// How many times longer than a colour this paint takes.
fn factor(paint: &Paint) -> f64 {
    match paint {
        Paint::Color(_) => 1.0,
        Paint::LinearGradient(_) | Paint::RadialGradient(_) => GRADIENT,
        Paint::Pattern(_) => PATTERN,
    }
}

/// How many pixels long a unit is, at most.
fn scale(transform: Transform) -> f64 {
    let (x, y) = transform.get_scale();
    f64::from(x).max(f64::from(y))
}

/// What a stroke takes on at most `pixels` pixels.
fn stroked(stroke: &Stroke, path: &Measured, px_per_unit: f64, pixels: f64) -> f64 {
    let width = f64::from(stroke.width().get()) * px_per_unit + 2.0;
    let covered = (path.length * width).min(pixels);
    let dashes = stroke.dasharray().map_or(0.0, |dashes| {
        let period: f64 = dashes.iter().copied().map(f64::from).sum();
        // A period of nothing is no dashing at all.
        if period > 0.0 { path.length / (period * px_per_unit) * 0.5 * dashes.len() as f64 } else { 0.0 }
    });
    let steps = 2.0 * path.steps;
    covered * factor(stroke.paint()) + steps + STROKED_SEGMENT * path.segments + DASH * dashes
}

/// Measures a path, of which only `shown` is.
fn measure(path: &Path, transform: Transform, shown: &Area) -> Measured {
    let mut bands = Bands { shown: *shown, sides: [(f64::INFINITY, f64::NEG_INFINITY); BANDS] };
    let mut measured = Measured { covered: 0.0, length: 0.0, steps: 0.0, segments: 0.0 };
    let at = |point| moved(transform, point);
    let (mut start, mut last) = ([0.0; 2], [0.0; 2]);
    for segment in path.data().segments() {
        // What a segment covers lies between its corners.
        let corners = match segment {
            PathSegment::MoveTo(point) => {
                (start, last) = (at(point), at(point));
                continue;
            }
            PathSegment::LineTo(point) => [last, last, last, at(point)],
            PathSegment::QuadTo(middle, point) => [last, last, at(middle), at(point)],
            PathSegment::CubicTo(first, second, point) => [last, at(first), at(second), at(point)],
            PathSegment::Close => [last, last, last, start],
        };
        for pair in corners.windows(2).filter(|pair| pair[0] != pair[1]) {
            measured.length += distance(pair[0], pair[1]);
            measured.steps += SUBPIXEL_LINES * bands.add(pair[0], pair[1]);
        }
        last = corners[3];
        bands.add(corners[0], last);
        measured.segments += 1.0;
    }
    // An open path is filled as if it were closed.
    bands.add(last, start);
    measured.covered = bands.pixels();
    measured
}

fn distance([x, y]: [f64; 2], [other_x, other_y]: [f64; 2]) -> f64 {
    let (x, y) = (x - other_x, y - other_y);
    (x * x + y * y).sqrt()
}

/// What lies between the outermost edges of a path, band by band.
struct Bands {
    shown: Area,
    /// The least and the largest x in each band.
    sides: [(f64, f64); BANDS],
}

impl Bands {
    fn height(&self) -> f64 {
        self.shown.height() / BANDS as f64
    }

    /// Adds an edge; returns how high it is within what is shown, px.
    fn add(&mut self, a: [f64; 2], b: [f64; 2]) -> f64 {
        let ([x0, y0], [x1, y1]) = if a[1] <= b[1] { (a, b) } else { (b, a) };
        let (top, bottom) = (y0.max(self.shown.top), y1.min(self.shown.bottom));
        if top > bottom || self.shown.height() <= 0.0 {
            return 0.0;
        }
        let x_at = |y: f64| if y1 > y0 { x0 + (x1 - x0) * ((y - y0) / (y1 - y0)) } else { x0 };
        let height = self.height();
        let number = |y: f64| (((y - self.shown.top) / height) as usize).min(BANDS - 1);
        for band in number(top)..=number(bottom) {
            let above = self.shown.top + band as f64 * height;
            let ends = [x_at(above.max(top)), x_at((above + height).min(bottom))];
            // A level edge has all of its x at one y.
            let ends = if y1 > y0 { ends } else { [x0, x1] };
            let (least, most) = &mut self.sides[band];
            *least = ends.into_iter().fold(*least, f64::min);
            *most = ends.into_iter().fold(*most, f64::max);
        }
        bottom - top
    }

    fn pixels(&self) -> f64 {
        let width = |&(least, most): &(f64, f64)| most.min(self.shown.right) - least.max(self.shown.left);
        self.sides.iter().map(|sides| width(sides).max(0.0)).sum::<f64>() * self.height()
    }
}
