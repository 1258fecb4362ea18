//! What filling and stroking a path takes: the pixels that it covers, and the steps along its edges.

use super::Counter;
use super::area::{Area, moved};
use super::rows::Rows;
use crate::Failure;
use resvg::usvg::tiny_skia_path::PathSegment;
use resvg::usvg::{LineCap, LineJoin, Paint, Path, Stroke, Transform};

// What follows is measured: `caustic bench art` prints how long an operation of each kind is. A sheet of colour sets what
// an operation is.

/// Lines of subpixels in a pixel, each of which meets every edge that crosses it.
const SUBPIXEL_LINES: f64 = 4.0;
/// Operations for an edge on a line of subpixels.
const STEP: f64 = 3.5;
/// The same for both sides of a segment that is stroked.
const STROKED_STEP: f64 = 16.0;
/// Operations for two edges that have a line of subpixels in common: edges are kept in order by walking past each other.
const OVERLAP: f64 = 5.0;
/// The same for two segments that are stroked, of two sides each.
const STROKED_OVERLAP: f64 = 14.0;
/// Operations for each segment, in which curves are cut into lines.
const SEGMENT: f64 = 80.0;
/// Operations for a segment's two sides and its join, when it is stroked.
const STROKED_SEGMENT: f64 = 1000.0;
/// Edges of a join, as many times as high as the stroke is wide.
const JOIN_EDGES: f64 = 3.0;
/// A dash is a path of its own.
const DASH: f64 = 1000.0;
/// Arcs at the ends or at the joins of a stroke, for each of them.
const ROUND: f64 = 1000.0;
/// Operations for a pixel of the length of a stroke that is thinner than a pixel; each lies on what is below it.
const HAIRLINE: f64 = 40.0;
/// How many times longer than a colour other paints take.
const GRADIENT: f64 = 4.0;
const PATTERN: f64 = 24.0;

/// A path, measured.
struct Measured {
    /// Pixels that its inside covers, at most.
    covered: f64,
    /// Its length, px.
    length: f64,
    /// Edges on lines of subpixels.
    steps: f64,
    /// Pairs of edges that have a line in common, at most.
    overlaps: f64,
    segments: f64,
    /// Of what is shown of it, px.
    height: f64,
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
            let edges = STEP * measured.steps + OVERLAP * measured.overlaps + SEGMENT * measured.segments;
            self.tally.spend(measured.covered * factor(fill.paint()) + edges);
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
    let width = f64::from(stroke.width().get()) * px_per_unit;
    let dashes = dashes(stroke, path, px_per_unit);
    let joins = path.segments + dashes;
    let is_round = |is: bool| if is { 1.0 } else { 0.0 };
    let round = is_round(stroke.linecap() == LineCap::Round) * 2.0 * dashes
        + is_round(stroke.linejoin() == LineJoin::Round) * path.segments;
    let own = STROKED_SEGMENT * path.segments + DASH * dashes + ROUND * round;
    if width <= 1.0 {
        return own + HAIRLINE * path.length * factor(stroke.paint());
    }
    let covered = (path.length * (width + 2.0)).min(pixels);
    let edges = STROKED_STEP * path.steps + STROKED_OVERLAP * path.overlaps;
    let join_edges = STEP * SUBPIXEL_LINES * JOIN_EDGES * width.min(path.height) * joins;
    covered * factor(stroke.paint()) + edges + join_edges + own
}

/// Into how many dashes a stroke is cut.
fn dashes(stroke: &Stroke, path: &Measured, px_per_unit: f64) -> f64 {
    let Some(dashes) = stroke.dasharray() else { return 0.0 };
    let period: f64 = dashes.iter().copied().map(f64::from).sum();
    // A period of nothing is no dashing at all.
    if period > 0.0 { path.length / (period * px_per_unit) * 0.5 * dashes.len() as f64 } else { 0.0 }
}

/// Measures a path, of which only `shown` is.
fn measure(path: &Path, transform: Transform, shown: &Area) -> Measured {
    let mut rows = Rows::new(*shown);
    let (mut length, mut steps, mut segments) = (0.0, 0.0, 0.0);
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
            length += distance(pair[0], pair[1]);
            steps += SUBPIXEL_LINES * rows.add(pair[0], pair[1]);
        }
        last = corners[3];
        rows.cover(corners[0], last);
        segments += 1.0;
    }
    // An open path is filled as if it were closed.
    rows.cover(last, start);
    Measured { covered: rows.pixels(), length, steps, overlaps: rows.overlaps(), segments, height: shown.height() }
}

fn distance([x, y]: [f64; 2], [other_x, other_y]: [f64; 2]) -> f64 {
    let (x, y) = (x - other_x, y - other_y);
    (x * x + y * y).sqrt()
}
