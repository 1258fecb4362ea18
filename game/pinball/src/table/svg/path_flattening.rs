//! Path flattening: paths become subpaths of straight pieces and circular arcs on the table, in millimetres.
//!
//! Refuses to know how SVG writes them. Curves that are neither are flattened to [`TOLERANCE_MM`] with nothing but `+ - * / sqrt` and
//! [`geometry::trig`], so that a drawing gives the same bits on every machine.

use super::biarc;
use super::transform::Transform;
use geometry::{Arc, Circle, DVec2, Segment, Shape, trig};
use std::f64::consts::{PI, TAU};

/// How far a flattened curve may be from the true one, mm.
pub(in crate::table) const TOLERANCE_MM: f64 = 0.02;
/// How far an outline that is only looked at may be from the true one, mm.
const VISIBLE_MM: f64 = 0.05;
/// Points closer than this are one point, mm.
const SAME_POINT_MM: f64 = 1e-6;
/// Coordinates beyond this are an error, mm.
const MAX_COORDINATE_MM: f64 = 1e5;
/// Pieces and points of one element beyond this are an error.
const MAX_ELEMENT_PIECES: usize = 10_000;

/// A straight or circular piece of a line, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::table) enum Piece {
    Segment(Segment),
    Arc(Arc),
}

impl Piece {
    /// The piece as a surface.
    pub fn shape(self, radius: f64) -> Shape {
        match self {
            Piece::Segment(Segment { a, b }) => Shape::capsule(a, b, radius),
            Piece::Arc(arc) => Shape { core: geometry::Core::Arc(arc), radius },
        }
    }
}

/// A connected part of a path, from one moveto to the next, mm.
#[derive(Clone, Debug, Default, PartialEq)]
pub(in crate::table) struct Subpath {
    /// Its pieces in order.
    pub pieces: Vec<Piece>,
    /// Its corners and enough points between them to be seen: a closed subpath does not repeat the first.
    pub polygon: Vec<DVec2>,
    /// It ends where it began.
    pub closed: bool,
}

/// What curves become that are neither straight nor circular.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::table) enum Curves {
    /// Chords, for what is hit by balls.
    Chords,
    /// Arcs, for what bends light.
    Arcs,
}

/// Draws subpaths; coordinates go in as the element has them and come out on the table.
pub(in crate::table) struct PathFlattener {
    curves: Curves,
    transform: Transform,
    scale: f64,
    subpaths: Vec<Subpath>,
    pieces: usize,
    pen: DVec2,
}

impl PathFlattener {
    /// A pen at `place`, which enlarges by `scale`.
    pub fn new(transform: Transform, scale: f64, curves: Curves) -> PathFlattener {
        PathFlattener { curves, transform, scale, subpaths: Vec::new(), pieces: 0, pen: DVec2::ZERO }
    }

    /// What has been drawn, without subpaths that have no length.
    pub fn finish(self) -> Vec<Subpath> {
        self.subpaths.into_iter().filter(|subpath| !subpath.pieces.is_empty()).collect()
    }

    fn to_table(&self, own: DVec2) -> Result<DVec2, String> {
        let point = self.transform.point(own.x, own.y);
        if point.is_finite() && point.abs().max_element() <= MAX_COORDINATE_MM {
            Ok(point)
        } else {
            Err("it has coordinates that are not numbers or are far outside the playfield".to_string())
        }
    }

    /// Begins a subpath.
    pub fn start(&mut self, own: DVec2) -> Result<(), String> {
        self.pen = self.to_table(own)?;
        self.subpaths.push(Subpath { polygon: vec![self.pen], ..Subpath::default() });
        Ok(())
    }

    fn subpath(&mut self) -> &mut Subpath {
        if self.subpaths.last().is_none_or(|subpath| subpath.closed) {
            self.subpaths.push(Subpath { polygon: vec![self.pen], ..Subpath::default() });
        }
        let last = self.subpaths.len() - 1;
        &mut self.subpaths[last]
    }

    fn count(&mut self, more: usize) -> Result<(), String> {
        self.pieces += more;
        if self.pieces > MAX_ELEMENT_PIECES {
            return Err(format!("it has more than {MAX_ELEMENT_PIECES} pieces; draw it more simply"));
        }
        Ok(())
    }

    fn push(&mut self, piece: Piece, to: DVec2) -> Result<(), String> {
        self.count(1)?;
        let subpath = self.subpath();
        subpath.pieces.push(piece);
        subpath.polygon.push(to);
        self.pen = to;
        Ok(())
    }

    /// A straight line.
    pub fn line(&mut self, own: DVec2) -> Result<(), String> {
        let to = self.to_table(own)?;
        self.line_on_table(to)
    }

    fn line_on_table(&mut self, to: DVec2) -> Result<(), String> {
        if self.pen.distance(to) < SAME_POINT_MM {
            return Ok(());
        }
        self.push(Piece::Segment(Segment { a: self.pen, b: to }), to)
    }

    /// Back to the start of the subpath.
    pub fn close(&mut self) -> Result<(), String> {
        let start = self.subpath().polygon[0];
        self.line_on_table(start)?;
        let subpath = self.subpath();
        subpath.closed = true;
        if subpath.polygon.len() > 1 && subpath.polygon[subpath.polygon.len() - 1].distance(start) < SAME_POINT_MM {
            subpath.polygon.pop();
        }
        self.pen = start;
        Ok(())
    }

    /// A cubic curve.
    pub fn cubic(&mut self, own: [DVec2; 3]) -> Result<(), String> {
        let from = self.pen;
        let [b, c, to] = [self.to_table(own[0])?, self.to_table(own[1])?, self.to_table(own[2])?];
        let at = |t: f64| {
            let s = 1.0 - t;
            from * (s * s * s) + b * (3.0 * s * s * t) + c * (3.0 * s * t * t) + to * (t * t * t)
        };
        if self.curves == Curves::Arcs {
            return self.arcs_along(at);
        }
        // A chord of a curve is off by at most an eighth of the second derivative, over the count squared.
        let bend = 6.0 * (from - b * 2.0 + c).length().max((b - c * 2.0 + to).length());
        let count = steps((bend / (8.0 * TOLERANCE_MM)).sqrt());
        for step in 1..=count {
            let point = at(step as f64 / count as f64);
            self.line_on_table(if step == count { to } else { point })?;
        }
        Ok(())
    }

    /// A curve on the table, from 0 to 1, as arcs.
    fn arcs_along(&mut self, curve: impl Fn(f64) -> DVec2) -> Result<(), String> {
        for (piece, to) in biarc::arcs_along(curve) {
            if let Piece::Arc(arc) = piece {
                self.see_arc(&arc, self.pen)?;
            }
            self.push(piece, to)?;
        }
        Ok(())
    }

    /// Corners between an arc's ends, as many as can be seen.
    fn see_arc(&mut self, arc: &Arc, from: DVec2) -> Result<(), String> {
        let Circle { center, radius } = arc.circle();
        let steps = arc_steps(radius, 2.0 * arc.half_angle(), VISIBLE_MM);
        self.count(steps)?;
        let [a, b] = arc.ends();
        let backwards = a.distance_squared(from) > b.distance_squared(from);
        for step in 1..steps {
            let part = step as f64 / steps as f64;
            let part = if backwards { 1.0 - part } else { part };
            let turned = trig::rotate(arc.middle(), (2.0 * part - 1.0) * arc.half_angle());
            self.subpath().polygon.push(center + turned * radius);
        }
        Ok(())
    }

    /// An arc of a circle of `radius`, or of an ellipse, as SVG gives it: from the pen to `to`.
    pub fn arc(&mut self, from: DVec2, ellipse: Ellipse, to: DVec2) -> Result<(), String> {
        let Ellipse { rx, ry, .. } = ellipse;
        if from.distance(to) * self.scale < SAME_POINT_MM {
            return Ok(());
        }
        if !(rx.is_finite() && ry.is_finite()) || rx.abs().max(ry.abs()) * self.scale > MAX_COORDINATE_MM * 100.0 {
            return Err("it has an arc whose radius is not a number or is far too large".to_string());
        }
        if rx == 0.0 || ry == 0.0 {
            return self.line(to);
        }
        if (rx.abs() - ry.abs()).abs() <= 1e-9 * rx.abs() {
            return self.circular_arc(rx.abs() * self.scale, ellipse, to);
        }
        self.elliptical_arc(from, ellipse, to)
    }

    fn circular_arc(&mut self, radius: f64, ellipse: Ellipse, to: DVec2) -> Result<(), String> {
        let from = self.pen;
        let to = self.to_table(to)?;
        let clockwise = ellipse.sweep != self.transform.mirrors();
        let (center, start, sweep) = through(from, to, radius, ellipse.large, clockwise);
        let circle = Circle { center, radius: center.distance(from) };
        let arc = Arc::new(circle, start, sweep);
        let steps = arc_steps(circle.radius, sweep, VISIBLE_MM);
        self.count(steps)?;
        for step in 1..steps {
            let part = step as f64 / steps as f64;
            let between = circle.center + trig::direction(start + sweep * part) * circle.radius;
            self.subpath().polygon.push(between);
        }
        self.push(Piece::Arc(arc), to)
    }

    fn elliptical_arc(&mut self, from: DVec2, ellipse: Ellipse, to: DVec2) -> Result<(), String> {
        let (mut rx, ry) = (ellipse.rx.abs(), ellipse.ry.abs());
        let turn = ellipse.turn_deg.to_radians();
        // In the ellipse's own axes, squeezed so that it is a circle of radius rx.
        let squeeze = |point: DVec2| {
            let turned = trig::rotate(point, -turn);
            DVec2::new(turned.x, turned.y * (rx / ry))
        };
        let stretch_y = ry / rx;
        let (a, b) = (squeeze(from), squeeze(to));
        let (center, start, sweep) = through(a, b, rx, ellipse.large, ellipse.sweep);
        rx = center.distance(a);
        let at = |part: f64| {
            let on_circle = center + trig::direction(start + sweep * part) * rx;
            trig::rotate(DVec2::new(on_circle.x, on_circle.y * stretch_y), turn)
        };
        if self.curves == Curves::Arcs {
            let transform = self.transform;
            return self.arcs_along(|part| {
                let own = at(part);
                transform.point(own.x, own.y)
            });
        }
        let count = arc_steps(rx.max(rx * stretch_y) * self.scale, sweep, TOLERANCE_MM);
        for step in 1..count {
            self.line(at(step as f64 / count as f64))?;
        }
        self.line(to)
    }
}

/// The ellipse of an SVG arc.
#[derive(Clone, Copy, Debug)]
pub(in crate::table) struct Ellipse {
    /// Half the axis that is turned.
    pub rx: f64,
    /// Half the other axis.
    pub ry: f64,
    /// How far the first axis is turned, degrees.
    pub turn_deg: f64,
    /// Takes the longer of the two ways.
    pub large: bool,
    /// Turns from x towards y.
    pub sweep: bool,
}

impl Ellipse {
    /// A circle's short way round.
    pub fn corner(radius: f64) -> Ellipse {
        Ellipse { rx: radius, ry: radius, turn_deg: 0.0, large: false, sweep: true }
    }
}

/// The centre, the start's angle and the sweep of the circle of `radius` through two points; a radius that is too small
/// to reach grows (SVG 2, "Conversion from endpoint to center parameterization").
fn through(from: DVec2, to: DVec2, radius: f64, large: bool, clockwise: bool) -> (DVec2, f64, f64) {
    let half = (from - to) * 0.5;
    let half_length = half.length();
    let rise = (radius * radius - half_length * half_length).max(0.0).sqrt();
    let side = if large != clockwise { rise } else { -rise } / half_length;
    let center = (from + to) * 0.5 + DVec2::new(half.y, -half.x) * side;
    let start = trig::angle(from - center);
    let turn = trig::angle(to - center) - start;
    let sweep = match (clockwise, turn > 0.0) {
        (true, false) => turn + TAU,
        (false, true) => turn - TAU,
        _ => turn,
    };
    (center, start, sweep)
}

fn steps(count: f64) -> usize {
    count.ceil().clamp(1.0, MAX_ELEMENT_PIECES as f64) as usize
}

/// Chords that an arc needs: the sagitta of `angle` is about `radius angle^2 / 8`.
fn arc_steps(radius: f64, sweep: f64, tolerance: f64) -> usize {
    steps((sweep.abs() * (radius / (8.0 * tolerance)).sqrt()).max(sweep.abs() * 2.0 / PI))
}

/// Points round a circle, close enough to be looked at.
pub(in crate::table) fn circle_polygon(circle: Circle) -> Vec<DVec2> {
    let count = arc_steps(circle.radius, TAU, VISIBLE_MM).max(12);
    (0..count).map(|step| circle.center + trig::direction(TAU * step as f64 / count as f64) * circle.radius).collect()
}
