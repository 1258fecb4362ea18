//! Matt walls in short pieces: where light that they send out is counted.

use crate::transport::{Contact, Contacts, Curve, EdgeId, Material, Parabola, Surfaces};
use geometry::DVec2;
use std::f64::consts::PI;

/// The matt walls of a scene; each has two sides, and each side its pieces.
#[derive(Clone, Debug)]
pub(super) struct Walls {
    /// By edges.
    walls: Vec<Option<Wall>>,
    pieces: usize,
}

/// A matt edge.
#[derive(Clone, Copy, Debug)]
struct Wall {
    /// Of its first side.
    first_piece: usize,
    /// Of one side.
    pieces: usize,
    /// The length of a piece, mm.
    piece_mm: f64,
    /// A whole circle: its end is its beginning.
    is_round: bool,
}

/// A place on a side of a wall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct WallPoint {
    edge: EdgeId,
    /// 0: the side of the curve's normal.
    side: usize,
    /// From the wall's beginning, pieces.
    at: f64,
}

impl WallPoint {
    /// Whether two places are on one side of one wall.
    pub(super) fn is_with(&self, other: &WallPoint) -> bool {
        (self.edge, self.side) == (other.edge, other.side)
    }
}

impl Walls {
    /// The walls of these edges, in pieces of about `piece_mm`.
    pub(super) fn new(surfaces: &Surfaces, bodies_of_edges: &[u32], piece_mm: f64) -> Walls {
        let mut pieces = 0;
        let wall = |(edge, body): (EdgeId, &u32)| {
            if !matches!(surfaces.material(*body), Material::Diffuse { .. }) {
                return None;
            }
            let curve = surfaces.curve(edge);
            let length = length(curve);
            let count = (length / piece_mm).ceil().max(1.0) as usize;
            let is_round = matches!(curve, Curve::Arc(arc) if arc.half_angle() == PI);
            let wall = Wall { first_piece: pieces, pieces: count, piece_mm: length / count as f64, is_round };
            pieces += 2 * count;
            Some(wall)
        };
        let walls = (0..).zip(bodies_of_edges).map(wall).collect();
        Walls { walls, pieces }
    }

    /// Pieces in all.
    pub(super) fn pieces(&self) -> usize {
        self.pieces
    }

    /// The matt wall that a ray meets at these contacts, if it meets one.
    pub(super) fn met(&self, surfaces: &Surfaces, contacts: &Contacts) -> Option<WallPoint> {
        let of = |contact: &Contact| surfaces.material(contact.body);
        if contacts.list().iter().any(|contact| matches!(of(contact), Material::Absorber)) {
            return None;
        }
        let contact = contacts.list().iter().find(|contact| matches!(of(contact), Material::Diffuse { .. }))?;
        let wall = self.walls[contact.edge as usize].as_ref()?;
        let curve = surfaces.curve(contact.edge);
        let side = usize::from(normal(curve, contact.place).dot(contact.normal) < 0.0);
        let at = (along(curve, contact.place) / wall.piece_mm).clamp(0.0, wall.pieces as f64);
        Some(WallPoint { edge: contact.edge, side, at })
    }

    /// The piece in which a place lies.
    pub(super) fn piece(&self, point: &WallPoint) -> usize {
        let Some(wall) = &self.walls[point.edge as usize] else { return 0 };
        wall.first_piece + point.side * wall.pieces + (point.at as usize).min(wall.pieces - 1)
    }

    /// The length of each piece, mm.
    pub(super) fn lengths_mm(&self) -> impl Iterator<Item = f64> {
        self.walls.iter().flatten().flat_map(|wall| std::iter::repeat_n(wall.piece_mm, 2 * wall.pieces))
    }

    /// Shows `visit` the pieces between two places on one side, each with its part of the way between them.
    pub(super) fn between(&self, a: &WallPoint, b: &WallPoint, mut visit: impl FnMut(usize, f64)) {
        let Some(wall) = &self.walls[a.edge as usize] else { return };
        let first = wall.first_piece + a.side * wall.pieces;
        let (mut low, mut high) = (a.at.min(b.at), a.at.max(b.at));
        let around = wall.pieces as f64;
        if wall.is_round && high - low > 0.5 * around {
            (low, high) = (high, low + around);
        }
        let piece = |number: usize| first + if number >= wall.pieces { number % wall.pieces } else { number };
        let last = if wall.is_round { usize::MAX } else { wall.pieces - 1 };
        let (from, to) = ((low as usize).min(last), (high as usize).min(last));
        if from == to || high - low < 1e-6 {
            return visit(piece(from), 1.0);
        }
        let inverse = 1.0 / (high - low);
        for number in from..=to {
            let part = (high.min(number as f64 + 1.0) - low.max(number as f64)) * inverse;
            if part > 0.0 {
                visit(piece(number), part);
            }
        }
    }
}

/// The length of a curve, mm.
fn length(curve: &Curve) -> f64 {
    match curve {
        Curve::Line(line) => line.length(),
        Curve::Arc(arc) => 2.0 * arc.half_angle() * arc.circle().radius,
        Curve::Parabola(parabola) => 2.0 * from_vertex(parabola, parabola.half),
    }
}

/// How far along a curve a place on it is, mm.
fn along(curve: &Curve, place: DVec2) -> f64 {
    match curve {
        Curve::Line(line) => line.a.distance(place),
        Curve::Arc(arc) => {
            let (from_center, middle) = (place - arc.circle().center, arc.middle());
            let turned = libm::atan2(middle.perp_dot(from_center), middle.dot(from_center));
            (turned + arc.half_angle()) * arc.circle().radius
        }
        Curve::Parabola(parabola) => {
            let x = (place - parabola.vertex).dot(parabola.axis);
            from_vertex(parabola, parabola.half) + from_vertex(parabola, x)
        }
    }
}

/// The signed length of a parabola from its vertex to x, mm: the integral of `sqrt(1 + (2 k x)^2)`.
fn from_vertex(parabola: &Parabola, x: f64) -> f64 {
    let slope = 2.0 * parabola.curvature * x;
    if slope.abs() < 1e-6 {
        return x;
    }
    0.5 * x * ((1.0 + slope * slope).sqrt() + libm::asinh(slope) / slope)
}

/// The normal of a curve at a place: of any length for a parabola.
fn normal(curve: &Curve, place: DVec2) -> DVec2 {
    match curve {
        Curve::Line(line) => line.along().perp(),
        Curve::Arc(arc) => place - arc.circle().center,
        Curve::Parabola(parabola) => {
            let x = (place - parabola.vertex).dot(parabola.axis);
            parabola.axis.perp() - parabola.axis * (2.0 * parabola.curvature * x)
        }
    }
}
