//! Matt walls in short pieces: where light that they send out is counted.
//!
//! A piece ends where another surface meets its wall, so that no piece has two rooms on one side.

use super::cuts::cuts;
use super::wall_curve::{along, length, normal};
use crate::transport::{Contact, Contacts, Curve, EdgeId, Material, Surfaces};
use std::f64::consts::PI;

/// The matt walls of a scene; each has two sides, and each side its pieces.
#[derive(Clone, Debug)]
pub(super) struct Walls {
    /// By edges.
    walls: Vec<Option<Wall>>,
    pieces: usize,
}

/// A matt edge.
#[derive(Clone, Debug)]
struct Wall {
    /// Of its first side.
    first_piece: usize,
    /// Where pieces begin and end, from the wall's beginning, mm.
    bounds_mm: Vec<f64>,
    /// A whole circle: its end is its beginning.
    is_round: bool,
}

/// A place on a side of a wall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct WallPoint {
    edge: EdgeId,
    /// 0: the side of the curve's normal.
    side: usize,
    /// From the wall's beginning, mm.
    at_mm: f64,
    /// On its side.
    piece: usize,
}

impl WallPoint {
    /// Whether two places are on one side of one wall.
    pub(super) fn is_with(&self, other: &WallPoint) -> bool {
        (self.edge, self.side) == (other.edge, other.side)
    }
}

impl Wall {
    /// A wall in pieces of about `piece_mm`.
    fn new(surfaces: &Surfaces, edges: EdgeId, edge: EdgeId, piece_mm: f64, first_piece: usize) -> Wall {
        let curve = surfaces.curve(edge);
        let ends = cuts(surfaces, edges, edge);
        let mut bounds_mm = vec![0.0];
        for ends in ends.windows(2) {
            let count = ((ends[1] - ends[0]) / piece_mm).ceil().max(1.0);
            let bound = |number: usize| ends[0] + (ends[1] - ends[0]) * (number as f64 / count);
            bounds_mm.extend((1..=count as usize).map(bound));
        }
        let is_round = matches!(curve, Curve::Arc(arc) if arc.half_angle() == PI);
        Wall { first_piece, bounds_mm, is_round }
    }

    fn pieces(&self) -> usize {
        self.bounds_mm.len() - 1
    }

    fn length_mm(&self) -> f64 {
        self.bounds_mm[self.pieces()]
    }

    fn piece_at(&self, at_mm: f64) -> usize {
        self.bounds_mm[1..self.pieces()].partition_point(|end| *end <= at_mm)
    }
}

impl Walls {
    /// The walls of these edges, of which the bodies are told, in pieces of about `piece_mm`.
    pub(super) fn new(surfaces: &Surfaces, bodies_of_edges: &[u32], piece_mm: f64) -> Walls {
        let mut pieces = 0;
        let edges = bodies_of_edges.len() as EdgeId;
        let wall = |(edge, body): (EdgeId, &u32)| {
            let is_wall = matches!(surfaces.material(*body), Material::Diffuse { .. });
            if !is_wall || length(surfaces.curve(edge)) <= 0.0 {
                return None;
            }
            let wall = Wall::new(surfaces, edges, edge, piece_mm, pieces);
            pieces += 2 * wall.pieces();
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
        let at_mm = along(curve, contact.place).clamp(0.0, wall.length_mm());
        Some(WallPoint { edge: contact.edge, side, at_mm, piece: wall.piece_at(at_mm) })
    }

    /// The piece in which a place lies.
    pub(super) fn piece(&self, point: &WallPoint) -> usize {
        let Some(wall) = &self.walls[point.edge as usize] else { return 0 };
        wall.first_piece + point.side * wall.pieces() + point.piece
    }

    /// The length of each piece, mm.
    pub(super) fn lengths_mm(&self) -> impl Iterator<Item = f64> {
        self.walls.iter().flatten().flat_map(|wall| {
            let side = || wall.bounds_mm.windows(2).map(|ends| ends[1] - ends[0]);
            side().chain(side())
        })
    }

    /// Shows `visit` the pieces between two places on one side, each with its part of the way between them.
    pub(super) fn between(&self, a: &WallPoint, b: &WallPoint, mut visit: impl FnMut(usize, f64)) {
        let Some(wall) = &self.walls[a.edge as usize] else { return };
        let first = wall.first_piece + a.side * wall.pieces();
        let (low, high) = if a.at_mm <= b.at_mm { (a, b) } else { (b, a) };
        let way = high.at_mm - low.at_mm;
        if low.piece == high.piece && way < 0.5 * wall.length_mm() || way < LEAST_WAY_MM {
            return visit(first + low.piece, 1.0);
        }
        let mut show = |from: &WallPoint, to: &WallPoint, inverse: f64| {
            for piece in from.piece..=to.piece {
                let part = to.at_mm.min(wall.bounds_mm[piece + 1]) - from.at_mm.max(wall.bounds_mm[piece]);
                if part > 0.0 {
                    visit(first + piece, part * inverse);
                }
            }
        };
        if !(wall.is_round && way > 0.5 * wall.length_mm()) {
            return show(low, high, 1.0 / way);
        }
        // The shorter way round a circle leads over its beginning.
        let inverse = 1.0 / (wall.length_mm() - way);
        let last = wall.pieces() - 1;
        show(high, &WallPoint { at_mm: wall.length_mm(), piece: last, ..*high }, inverse);
        show(&WallPoint { at_mm: 0.0, piece: 0, ..*low }, low, inverse);
    }
}

/// Places nearer together than this are one.
const LEAST_WAY_MM: f64 = 1e-6;
