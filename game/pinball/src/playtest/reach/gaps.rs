//! Gaps: where a ball can leave the playfield through the line round all that stands on it.

use super::{Reach, Square};
use geometry::{Core, DVec2, Shape, trig};
use physics::Layout;
use std::f64::consts::TAU;

/// Directions in which the outline is measured.
const DIRECTIONS: u32 = 64;

/// A way out of the playfield.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gap {
    /// Its middle, m.
    pub middle: DVec2,
    /// The place in it that is nearest to what stands beside it, m.
    pub side: DVec2,
}

impl Reach {
    /// Where a ball can come to the edge of the playfield: not there, but where it leaves what the walls are drawn round.
    pub fn gaps(&self, layout: &Layout) -> Vec<Gap> {
        let outline = Outline::new(layout);
        let is_inside = |square: usize| outline.holds(self.middle(square));
        let mut seen = vec![false; self.squares.len()];
        let mut crossed = vec![false; self.squares.len()];
        let mut found: Vec<usize> = self.open_edges().collect();
        while let Some(square) = found.pop() {
            if std::mem::replace(&mut seen[square], true) {
                continue;
            }
            if is_inside(square) {
                crossed[square] = true;
            } else {
                found.extend(self.beside(square).filter(|near| self.squares[*near] != Square::OutOfReach));
            }
        }
        self.runs(crossed).into_iter().filter_map(|run| self.gap(&run, &outline)).collect()
    }

    /// The squares of each run of neighbours, the corners' too.
    fn runs(&self, mut left: Vec<bool>) -> Vec<Vec<usize>> {
        let mut runs = Vec::new();
        for first in 0..left.len() {
            let mut run = Vec::new();
            let mut found = vec![first];
            while let Some(square) = found.pop() {
                if std::mem::take(&mut left[square]) {
                    run.push(square);
                    found.extend(self.beside(square).flat_map(|near| self.beside(near)).chain(self.beside(square)));
                }
            }
            if !run.is_empty() {
                runs.push(run);
            }
        }
        runs
    }

    fn gap(&self, run: &[usize], outline: &Outline) -> Option<Gap> {
        let least = |measure: &dyn Fn(DVec2) -> f64| {
            let places = run.iter().map(|square| self.middle(*square));
            places.min_by(|one, other| measure(*one).total_cmp(&measure(*other)))
        };
        let mean = run.iter().map(|square| self.middle(*square)).sum::<DVec2>() / run.len() as f64;
        let middle = least(&|place| place.distance_squared(mean))?;
        let side = least(&|place| outline.to_nearest(place))?;
        Some(Gap { middle, side })
    }
}

/// All that stands on a table, and its convex outline.
struct Outline {
    shapes: Vec<Shape>,
    /// How far they go in each direction.
    farthest: Vec<(DVec2, f64)>,
}

impl Outline {
    fn new(layout: &Layout) -> Outline {
        let shapes: Vec<Shape> = layout.parts.iter().flat_map(|part| part.kind.surfaces()).collect();
        let directions = (0..DIRECTIONS).map(|step| trig::direction(TAU * f64::from(step) / f64::from(DIRECTIONS)));
        let farthest = |way: DVec2| shapes.iter().map(|shape| support(shape, way)).fold(f64::NEG_INFINITY, f64::max);
        let farthest = directions.map(|way| (way, farthest(way))).collect();
        Outline { shapes, farthest }
    }

    fn holds(&self, place: DVec2) -> bool {
        self.farthest.iter().all(|(way, farthest)| place.dot(*way) <= *farthest)
    }

    fn to_nearest(&self, place: DVec2) -> f64 {
        self.shapes.iter().map(|shape| shape.distance(place).0).fold(f64::INFINITY, f64::min)
    }
}

/// How far a shape goes in a direction.
fn support(shape: &Shape, way: DVec2) -> f64 {
    let core = match &shape.core {
        Core::Point(center) => center.dot(way),
        Core::Segment(segment) => segment.a.dot(way).max(segment.b.dot(way)),
        Core::Arc(arc) => {
            let circle = arc.circle();
            let ends = arc.ends().into_iter().map(|end| end.dot(way)).fold(f64::NEG_INFINITY, f64::max);
            let far = circle.center + way * circle.radius;
            if arc.spans(far) { far.dot(way) } else { ends }
        }
        Core::Taper(taper) => [taper.a, taper.b]
            .map(|disc| disc.center.dot(way) + disc.radius)
            .into_iter()
            .fold(f64::NEG_INFINITY, f64::max),
    };
    core + shape.radius
}
