//! The search for what a ray meets first: leaf after leaf of the hierarchy.

use super::Surfaces;
use super::contacts::{EdgeId, MOST_TOGETHER, StartsOn};
use crate::simd::dispatch::multiversion;
use geometry::Ray;

/// The nearest edges along a ray, by distance and then by number: those in one place.
#[derive(Clone, Copy, Debug)]
pub(super) struct Nearest {
    list: [(f64, EdgeId); MOST_TOGETHER],
    count: usize,
    tolerance: f64,
}

impl Nearest {
    /// Nothing is near.
    pub fn none(tolerance: f64) -> Nearest {
        Nearest { list: [(f64::INFINITY, 0); MOST_TOGETHER], count: 0, tolerance }
    }

    /// Them, with their distances.
    pub fn list(&self) -> &[(f64, EdgeId)] {
        &self.list[..self.count]
    }

    /// How far an edge may be that is in the place of the nearest one.
    #[inline(always)]
    pub fn farthest(&self) -> f64 {
        self.list[0].0 + self.tolerance
    }

    /// Adds an edge that is near enough.
    pub fn add(&mut self, distance: f64, edge: EdgeId) {
        let mut at = self.count;
        while at > 0 && (distance, edge) < self.list[at - 1] {
            at -= 1;
        }
        if at == MOST_TOGETHER {
            return;
        }
        self.list.copy_within(at..MOST_TOGETHER - 1, at + 1);
        self.list[at] = (distance, edge);
        self.count = (self.count + 1).min(MOST_TOGETHER);
        let farthest = self.farthest();
        while self.list[self.count - 1].0 > farthest {
            self.count -= 1;
        }
    }
}

multiversion! {
    /// What the ray meets first, not beyond `farthest`.
    pub(super) fn nearest(surfaces: &Surfaces, ray: &Ray, starts_on: &StartsOn, farthest: f64, nearest: &mut Nearest) = nearest_body;
}

#[inline(always)]
fn nearest_body(surfaces: &Surfaces, ray: &Ray, starts_on: &StartsOn, farthest: f64, nearest: &mut Nearest) {
    let hierarchy = &surfaces.hierarchy;
    let mut along = hierarchy.along(ray, farthest);
    while let Some(leaf) = along.next_leaf() {
        for edge in hierarchy.leaf(leaf) {
            let distance = surfaces.curve(*edge).distance(ray, starts_on.holds(*edge));
            if distance <= nearest.farthest() && distance < f64::INFINITY {
                nearest.add(distance, *edge);
            }
        }
        along.farthest = nearest.farthest().min(farthest);
    }
}
