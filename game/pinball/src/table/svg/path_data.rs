//! SVG path data, command by command: what is relative, smooth or implied becomes plain calls of a [`PathFlattener`].

use super::path_flattening::{Ellipse, PathFlattener};
use geometry::DVec2;
use svgtypes::PathSegment;

/// Draws SVG path data.
pub(in crate::table) fn draw(pen: &mut PathFlattener, data: &str) -> Result<(), String> {
    let mut cursor = Cursor::default();
    for segment in svgtypes::PathParser::from(data) {
        let segment = segment.map_err(|error| unreadable(data, &error))?;
        cursor.draw(pen, segment)?;
    }
    Ok(())
}

/// Why a path cannot be read to its end; none of one without commands.
pub(in crate::table) fn unread(data: &str) -> Option<String> {
    let is_said = !matches!(data.trim(), "" | "none");
    let mistake = svgtypes::PathParser::from(data).find_map(Result::err).filter(|_| is_said)?;
    Some(unreadable(data, &mistake))
}

/// Characters of what stands at a mistake that show where it is.
const SHOWN: usize = 24;

/// What of a path cannot be read.
fn unreadable(data: &str, error: &svgtypes::Error) -> String {
    use svgtypes::Error::{InvalidChar, InvalidNumber, InvalidString, UnexpectedData};
    let place = match error {
        // Counted from 1, in letters.
        InvalidChar(_, place) | InvalidNumber(place) | InvalidString(_, place) | UnexpectedData(place) => *place,
        _ => usize::MAX,
    };
    let letters = || data.chars().skip(place.saturating_sub(1));
    let shown: String = letters().take(SHOWN).collect();
    let more = if letters().nth(SHOWN).is_some() { "..." } else { "" };
    let begins = data.trim_start().starts_with(['M', 'm']);
    match shown.trim() {
        _ if !begins => "its path cannot be read: it begins with M and a place, as in `M10 20`".to_string(),
        "" => "its path cannot be read: it ends in the middle of a command; numbers are missing".to_string(),
        shown => format!(
            "its path cannot be read from `{shown}{more}` on: each command is one letter of M L H V C S Q T A Z and the \
             numbers that it takes"
        ),
    }
}

/// Where SVG's relative and smooth commands start from, in the element's own coordinates.
#[derive(Default)]
struct Cursor {
    at: DVec2,
    start: DVec2,
    /// The last control point, if the last command was a cubic (true) or a quadratic (false) curve.
    control: Option<(bool, DVec2)>,
}

impl Cursor {
    fn draw(&mut self, pen: &mut PathFlattener, segment: PathSegment) -> Result<(), String> {
        let base = if segment.is_abs() { DVec2::ZERO } else { self.at };
        let point = |x: f64, y: f64| base + DVec2::new(x, y);
        let control = self.control.take();
        match segment {
            PathSegment::MoveTo { x, y, .. } => {
                self.at = point(x, y);
                self.start = self.at;
                pen.start(self.at)
            }
            PathSegment::LineTo { x, y, .. } => self.line(pen, point(x, y)),
            PathSegment::HorizontalLineTo { x, .. } => self.line(pen, DVec2::new(base.x + x, self.at.y)),
            PathSegment::VerticalLineTo { y, .. } => self.line(pen, DVec2::new(self.at.x, base.y + y)),
            PathSegment::CurveTo { x1, y1, x2, y2, x, y, .. } => {
                self.cubic(pen, [point(x1, y1), point(x2, y2), point(x, y)])
            }
            PathSegment::SmoothCurveTo { x2, y2, x, y, .. } => {
                let first = self.reflected(control, true);
                self.cubic(pen, [first, point(x2, y2), point(x, y)])
            }
            PathSegment::Quadratic { x1, y1, x, y, .. } => self.quadratic(pen, point(x1, y1), point(x, y)),
            PathSegment::SmoothQuadratic { x, y, .. } => {
                let middle = self.reflected(control, false);
                self.quadratic(pen, middle, point(x, y))
            }
            PathSegment::EllipticalArc { rx, ry, x_axis_rotation, large_arc, sweep, x, y, .. } => {
                let ellipse = Ellipse { rx, ry, turn_deg: x_axis_rotation, large: large_arc, sweep };
                let from = std::mem::replace(&mut self.at, point(x, y));
                pen.arc(from, ellipse, self.at)
            }
            PathSegment::ClosePath { .. } => {
                self.at = self.start;
                pen.close()
            }
        }
    }

    fn line(&mut self, pen: &mut PathFlattener, to: DVec2) -> Result<(), String> {
        self.at = to;
        pen.line(to)
    }

    fn cubic(&mut self, pen: &mut PathFlattener, points: [DVec2; 3]) -> Result<(), String> {
        self.control = Some((true, points[1]));
        self.at = points[2];
        pen.cubic(points)
    }

    fn quadratic(&mut self, pen: &mut PathFlattener, middle: DVec2, to: DVec2) -> Result<(), String> {
        let from = self.at;
        let third = |end: DVec2| end + (middle - end) * (2.0 / 3.0);
        self.cubic(pen, [third(from), third(to), to])?;
        self.control = Some((false, middle));
        Ok(())
    }

    fn reflected(&self, control: Option<(bool, DVec2)>, cubic: bool) -> DVec2 {
        match control {
            Some((kind, point)) if kind == cubic => self.at * 2.0 - point,
            _ => self.at,
        }
    }
}
