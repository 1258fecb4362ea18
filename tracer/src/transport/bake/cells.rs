//! Cells of a scene, and what of each is one place.
//!
//! A cell that surfaces divide is several places, each a *node* with its own light: points of a lattice in the cell are one node
//! where they see each other one by one. A point takes from the nodes of the four cells around it, and from those only of
//! which it sees a lattice point.

use crate::transport::{StartsOn, Surfaces};
use geometry::{Bounds, DVec2, Ray};
use rayon::prelude::*;

/// Lattice points along a side of a cell.
const SIDE: usize = 4;
const POINTS: usize = SIDE * SIDE;

/// The lattice is shifted by this part of a cell, so that drawn coordinates do not lie on it.
const SHIFT: f64 = 0.012_345_678_9;

/// A lattice point nearer than this to a surface is none where light is gathered, mm.
const CLEARANCE_MM: f64 = 1e-4;

/// Cells in rows over a region.
#[derive(Clone, Debug)]
pub(super) struct Cells {
    /// The upper left corner of the first cell.
    origin: DVec2,
    cell_mm: f64,
    width: usize,
    height: usize,
    /// By cells: where their points begin, and the end of all.
    first_point: Vec<u32>,
    points: Vec<LatticePoint>,
    nodes: Vec<Node>,
    /// By cells: nothing is in it or next to it.
    is_clear: Vec<bool>,
}

#[derive(Clone, Copy, Debug)]
struct LatticePoint {
    at: DVec2,
    node: u32,
}

/// One place.
#[derive(Clone, Copy, Debug)]
pub(super) struct Node {
    /// Where its light is gathered.
    pub(super) at: DVec2,
    /// Its part of the cell's area.
    pub(super) share: f64,
}

/// The nodes of a cell before they have numbers.
struct CellNodes {
    points: Vec<LatticePoint>,
    nodes: Vec<Node>,
    is_clear: bool,
}

impl Cells {
    /// The cells whose middles span a region at least.
    pub(super) fn new(surfaces: &Surfaces, region: &Bounds, cell_mm: f64) -> Cells {
        let count = |size: f64| (size / cell_mm).ceil().max(0.0) as usize + 2;
        let size = region.size();
        let (width, height) = (count(size.x), count(size.y));
        let origin = region.min - DVec2::splat(cell_mm * (0.5 + SHIFT));
        let corner = |cell: usize| origin + DVec2::new((cell % width) as f64, (cell / width) as f64) * cell_mm;
        let made: Vec<CellNodes> =
            (0..width * height).into_par_iter().map(|cell| cell_nodes(surfaces, corner(cell), cell_mm)).collect();
        let (mut points, mut nodes, mut first_point) = (Vec::new(), Vec::new(), vec![0]);
        for cell in &made {
            let base = nodes.len() as u32;
            points.extend(cell.points.iter().map(|point| LatticePoint { node: base + point.node, ..*point }));
            nodes.extend(&cell.nodes);
            first_point.push(points.len() as u32);
        }
        let is_clear = made.iter().map(|cell| cell.is_clear).collect();
        Cells { origin, cell_mm, width, height, first_point, points, nodes, is_clear }
    }

    pub(super) fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    pub(super) fn width(&self) -> usize {
        self.width
    }

    pub(super) fn height(&self) -> usize {
        self.height
    }

    pub(super) fn cell_mm(&self) -> f64 {
        self.cell_mm
    }

    /// A point in cells from the upper left corner.
    pub(super) fn place_of(&self, point: DVec2) -> DVec2 {
        (point - self.origin) / self.cell_mm
    }

    /// The node of a cell that a point belongs to: that of the nearest lattice point that it sees.
    pub(super) fn node_seen(&self, surfaces: &Surfaces, cell: usize, from: DVec2) -> Option<usize> {
        let points = self.points_of(cell);
        if self.is_clear[cell] {
            return points.first().map(|point| point.node as usize);
        }
        nearest_seen(surfaces, points, from)
    }

    /// Shows `take` the nodes that a point's light is the weighted mean of.
    pub(super) fn around(&self, surfaces: &Surfaces, point: DVec2, mut take: impl FnMut(usize, f64)) {
        let place = self.place_of(point) - 0.5;
        let most = DVec2::new((self.width - 1) as f64, (self.height - 1) as f64);
        let place = place.clamp(DVec2::ZERO, most);
        let [x, y] = [place.x.min(most.x - 1.0) as usize, place.y.min(most.y - 1.0) as usize];
        let part = place - DVec2::new(x as f64, y as f64);
        let corners = [(0, 0), (1, 0), (0, 1), (1, 1)].map(|(right, down)| {
            let across = if right == 1 { part.x } else { 1.0 - part.x };
            let along = if down == 1 { part.y } else { 1.0 - part.y };
            ((y + down) * self.width + x + right, across * along)
        });
        if corners.iter().all(|(cell, _)| self.is_clear[*cell]) {
            return corners.into_iter().for_each(|(cell, weight)| {
                take(self.points_of(cell)[0].node as usize, weight);
            });
        }
        let mut found = false;
        for (cell, _) in corners {
            if let Some(node) = nearest_seen(surfaces, self.points_of(cell), point) {
                // In an undivided cell these are the bilinear weights.
                let near = DVec2::ONE - (point - self.nodes[node].at).abs() / self.cell_mm;
                take(node, near.x.max(LEAST_NEARNESS) * near.y.max(LEAST_NEARNESS));
                found = true;
            }
        }
        if !found && let Some(node) = self.seen_near(surfaces, point, [x, y]) {
            take(node, 1.0);
        }
    }

    /// The nearest node that a point sees among the cells around the four.
    fn seen_near(&self, surfaces: &Surfaces, point: DVec2, [x, y]: [usize; 2]) -> Option<usize> {
        let rows = y.saturating_sub(1)..(y + 3).min(self.height);
        let columns = x.saturating_sub(1)..(x + 3).min(self.width);
        let cells = rows.flat_map(|row| columns.clone().map(move |column| row * self.width + column));
        let points: Vec<LatticePoint> = cells.flat_map(|cell| self.points_of(cell)).copied().collect();
        nearest_seen(surfaces, &points, point)
    }

    fn points_of(&self, cell: usize) -> &[LatticePoint] {
        &self.points[self.first_point[cell] as usize..self.first_point[cell + 1] as usize]
    }
}

/// Where a point sees no near node, those that it sees still count.
const LEAST_NEARNESS: f64 = 1e-3;

/// The node of the nearest of these points that is seen.
fn nearest_seen(surfaces: &Surfaces, points: &[LatticePoint], from: DVec2) -> Option<usize> {
    let mut tried = 0_u64;
    for _ in 0..points.len().min(64) {
        let open = (0..points.len().min(64)).filter(|at| tried & (1 << at) == 0);
        let nearest = open.min_by(|a, b| {
            let away = |at: usize| points[at].at.distance_squared(from);
            away(*a).total_cmp(&away(*b))
        })?;
        if sees(surfaces, from, points[nearest].at) {
            return Some(points[nearest].node as usize);
        }
        tried |= 1 << nearest;
    }
    None
}

/// Whether nothing is between two points; a surface at the second one is.
fn sees(surfaces: &Surfaces, from: DVec2, to: DVec2) -> bool {
    match Ray::towards(from, to) {
        Some(ray) => !surfaces.is_blocked(&ray, &StartsOn::NOTHING, from.distance(to) * (1.0 + 1e-12) + 1e-9),
        None => true,
    }
}

fn cell_nodes(surfaces: &Surfaces, corner: DVec2, cell_mm: f64) -> CellNodes {
    let mut groups: [usize; POINTS] = std::array::from_fn(|at| at);
    let mut is_clear = true;
    let group_at = |x: usize, y: usize| (x < SIDE && y < SIDE).then(|| y * SIDE + x);
    for line in 0..SIDE {
        // From the last point of the cell before to the first one of the cell behind: a surface may lie on either margin.
        for step in 0..=SIDE {
            for [from, to] in
                [[(step.wrapping_sub(1), line), (step, line)], [(line, step.wrapping_sub(1)), (line, step)]]
            {
                let open = sees(surfaces, lattice_point(corner, cell_mm, from), lattice_point(corner, cell_mm, to));
                is_clear &= open;
                if let (true, Some(one), Some(other)) = (open, group_at(from.0, from.1), group_at(to.0, to.1)) {
                    let (one, other) = (groups[one], groups[other]);
                    groups.iter_mut().filter(|group| **group == other).for_each(|group| *group = one);
                }
            }
        }
    }
    if is_clear {
        let at = corner + DVec2::splat(0.5 * cell_mm);
        return CellNodes {
            points: vec![LatticePoint { at, node: 0 }],
            nodes: vec![Node { at, share: 1.0 }],
            is_clear,
        };
    }
    let (mut points, mut nodes) = (Vec::new(), Vec::new());
    for group in 0..POINTS {
        let members = || (0..POINTS).filter(|at| groups[*at] == group);
        let of = || members().map(|at| lattice_point(corner, cell_mm, (at % SIDE, at / SIDE)));
        let count = of().count();
        if count == 0 {
            continue;
        }
        let middle = of().sum::<DVec2>() / count as f64;
        let free = of().filter(|at| is_free(surfaces, *at));
        let Some(at) = free.min_by(|a, b| a.distance_squared(middle).total_cmp(&b.distance_squared(middle))) else {
            continue;
        };
        points.extend(of().map(|at| LatticePoint { at, node: nodes.len() as u32 }));
        nodes.push(Node { at, share: count as f64 / POINTS as f64 });
    }
    CellNodes { points, nodes, is_clear }
}

/// A point of the lattice of a cell; before it (0 less 1, wrapping) or behind it is the next cell's.
fn lattice_point(corner: DVec2, cell_mm: f64, (x, y): (usize, usize)) -> DVec2 {
    let place = DVec2::new(x as isize as f64, y as isize as f64);
    corner + (place + 0.5) * (cell_mm / SIDE as f64)
}

/// Whether a point lies on no surface: what is gathered there would come from both sides.
fn is_free(surfaces: &Surfaces, at: DVec2) -> bool {
    [DVec2::X, DVec2::Y].into_iter().all(|axis| sees(surfaces, at - axis * CLEARANCE_MM, at + axis * CLEARANCE_MM))
}
