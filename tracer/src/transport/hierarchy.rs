//! A bounding volume hierarchy over boxes: what a ray may meet, from the nearest box on.
//!
//! Built from the top by the surface area heuristic over bins (I. Wald, "On fast construction of SAH-based bounding volume
//! hierarchies", 2007); in the plane a box is met in proportion to its circumference.

use geometry::{Bounds, DVec2, Ray};

/// Boxes in a leaf.
const LEAF: usize = 4;
/// Bins along an axis.
const BINS: usize = 16;
/// Levels of a tree; boxes in one place end in a larger leaf.
const MOST_LEVELS: usize = 48;

/// A node: a box, and what is in it.
#[derive(Clone, Copy, Debug)]
struct Node {
    bounds: Bounds,
    /// Of a leaf the first of its items; of another node its first child, which its second one follows.
    first: u32,
    /// Items of a leaf; 0 of a node with children.
    count: u32,
}

/// A tree of boxes.
#[derive(Clone, Debug, Default)]
pub struct Hierarchy {
    nodes: Vec<Node>,
    /// The items in the order of the leaves.
    items: Vec<u32>,
}

impl Hierarchy {
    /// The tree over these boxes, which are finite.
    pub fn new(boxes: &[Bounds]) -> Hierarchy {
        let mut tree = Hierarchy { nodes: Vec::new(), items: (0..boxes.len() as u32).collect() };
        if boxes.is_empty() {
            return tree;
        }
        tree.nodes.push(Node { bounds: union(boxes.iter().copied()), first: 0, count: boxes.len() as u32 });
        let mut open = vec![(0, 0)];
        while let Some((node, level)) = open.pop() {
            if level < MOST_LEVELS && tree.split(node, boxes) {
                let first = tree.nodes[node].first as usize;
                open.extend([(first, level + 1), (first + 1, level + 1)]);
            }
        }
        tree
    }

    /// Splits a leaf where that is worth it.
    fn split(&mut self, node: usize, boxes: &[Bounds]) -> bool {
        let Node { bounds, first, count } = self.nodes[node];
        let (first, count) = (first as usize, count as usize);
        if count <= LEAF {
            return false;
        }
        let items = &mut self.items[first..first + count];
        let Some((axis, plane, cost)) = best_plane(items, boxes) else { return false };
        if cost >= circumference(&bounds) * count as f64 && count <= 4 * LEAF {
            return false;
        }
        let mut left = 0;
        for index in 0..count {
            if middle(&boxes[items[index] as usize])[axis] < plane {
                items.swap(left, index);
                left += 1;
            }
        }
        if left == 0 || left == count {
            return false;
        }
        let of = |items: &[u32]| union(items.iter().map(|item| boxes[*item as usize]));
        let children = [(of(&items[..left]), first, left), (of(&items[left..]), first + left, count - left)];
        self.nodes[node] = Node { bounds, first: self.nodes.len() as u32, count: 0 };
        let nodes = children.map(|(bounds, first, count)| Node { bounds, first: first as u32, count: count as u32 });
        self.nodes.extend(nodes);
        true
    }

    /// Shows `visit` every item whose box the ray may meet before `farthest`; the visit says how far the ray goes from then
    /// on.
    pub fn visit(&self, ray: &Ray, mut farthest: f64, mut visit: impl FnMut(u32) -> f64) {
        let inverse = DVec2::ONE / ray.direction;
        let Some(root) = self.nodes.first() else { return };
        let Some(enters) = entry(&root.bounds, ray, inverse, farthest) else { return };
        let mut stack = [(0_u32, 0.0_f64); MOST_LEVELS + 2];
        let mut depth = 1;
        stack[0] = (0, enters);
        while depth > 0 {
            depth -= 1;
            let (node, enters) = stack[depth];
            if enters > farthest {
                continue;
            }
            let Node { first, count, .. } = self.nodes[node as usize];
            if count > 0 {
                for item in &self.items[first as usize..(first + count) as usize] {
                    farthest = visit(*item).min(farthest);
                }
                continue;
            }
            let near = |child: u32| entry(&self.nodes[child as usize].bounds, ray, inverse, farthest);
            let mut children = [(first, near(first)), (first + 1, near(first + 1))];
            // The nearer one comes last on the stack, so it is first.
            if children[0].1.unwrap_or(f64::INFINITY) < children[1].1.unwrap_or(f64::INFINITY) {
                children.swap(0, 1);
            }
            for (child, enters) in children {
                if let Some(enters) = enters {
                    stack[depth] = (child, enters);
                    depth += 1;
                }
            }
        }
    }
}

/// Where the ray enters the box, at most `farthest` along it: the slab test. A ray along an edge of the box is in it.
#[inline]
fn entry(bounds: &Bounds, ray: &Ray, inverse: DVec2, farthest: f64) -> Option<f64> {
    let to_min = (bounds.min - ray.origin) * inverse;
    let to_max = (bounds.max - ray.origin) * inverse;
    // 0 times infinity is no number, and `min` and `max` leave it out: the ray is within that slab for ever.
    let enters = to_min.x.min(to_max.x).max(to_min.y.min(to_max.y)).max(0.0);
    let leaves = to_min.x.max(to_max.x).min(to_min.y.max(to_max.y)).min(farthest);
    // Rounding must not lose a box that the ray touches.
    (enters <= leaves * (1.0 + 4.0 * f64::EPSILON)).then_some(enters)
}

/// The axis and the plane of the least cost, and that cost; `None` where all middles are in one place.
fn best_plane(items: &[u32], boxes: &[Bounds]) -> Option<(usize, f64, f64)> {
    let middles = union(items.iter().map(|item| {
        let middle = middle(&boxes[*item as usize]);
        Bounds::of(middle, middle)
    }));
    let mut best: Option<(usize, f64, f64)> = None;
    for axis in 0..2 {
        let (low, size) = (middles.min[axis], middles.size()[axis]);
        if size <= 0.0 {
            continue;
        }
        let mut bins: [(usize, Option<Bounds>); BINS] = [(0, None); BINS];
        for item in items {
            let bounds = boxes[*item as usize];
            let bin = (((middle(&bounds)[axis] - low) / size * BINS as f64) as usize).min(BINS - 1);
            bins[bin] = (bins[bin].0 + 1, Some(bins[bin].1.map_or(bounds, |other| other.union(bounds))));
        }
        let cost = |bins: &[(usize, Option<Bounds>)]| {
            let count: usize = bins.iter().map(|bin| bin.0).sum();
            let bounds = bins.iter().filter_map(|bin| bin.1).reduce(Bounds::union);
            bounds.map_or(0.0, |bounds| circumference(&bounds) * count as f64)
        };
        for split in 1..BINS {
            let cost = cost(&bins[..split]) + cost(&bins[split..]);
            if best.is_none_or(|best| cost < best.2) {
                best = Some((axis, low + size * split as f64 / BINS as f64, cost));
            }
        }
    }
    best
}

fn union(boxes: impl Iterator<Item = Bounds>) -> Bounds {
    let nothing = Bounds { min: DVec2::splat(f64::INFINITY), max: DVec2::splat(f64::NEG_INFINITY) };
    boxes.fold(nothing, Bounds::union)
}

fn middle(bounds: &Bounds) -> DVec2 {
    (bounds.min + bounds.max) * 0.5
}

fn circumference(bounds: &Bounds) -> f64 {
    let size = bounds.size();
    2.0 * (size.x + size.y)
}

#[cfg(test)]
mod tests {
    use super::*;
    use geometry::rng::SplitMix64;

    /// Every box that a ray meets is shown, whatever boxes there are: points, lines, one place many times.
    #[test]
    fn no_box_is_missed() {
        let mut random = SplitMix64::new(3);
        for count in [0, 1, 5, 200, 3000] {
            let boxes: Vec<Bounds> = (0..count)
                .map(|index| {
                    let at = random.point_within(DVec2::splat(100.0));
                    let size = match index % 4 {
                        0 => DVec2::ZERO,
                        1 => DVec2::new(random.uniform(0.0, 9.0), 0.0),
                        _ => random.point_within(DVec2::splat(5.0)),
                    };
                    if index % 7 == 0 {
                        Bounds::of(DVec2::splat(50.0), DVec2::splat(51.0))
                    } else {
                        Bounds::of(at, at + size)
                    }
                })
                .collect();
            let tree = Hierarchy::new(&boxes);
            for turn in 0..200 {
                let origin = random.point_within(DVec2::splat(100.0));
                let direction = match turn % 4 {
                    0 => DVec2::X,
                    1 => DVec2::NEG_Y,
                    _ => geometry::trig::direction(random.uniform(0.0, 6.3)),
                };
                let ray = Ray { origin, direction };
                let mut shown = vec![false; count];
                tree.visit(&ray, f64::INFINITY, |item| {
                    assert!(!std::mem::replace(&mut shown[item as usize], true), "shown twice");
                    f64::INFINITY
                });
                for (bounds, shown) in boxes.iter().zip(shown) {
                    let grown = bounds.grown(-1e-9);
                    let met = entry(&grown, &ray, DVec2::ONE / direction, f64::INFINITY).is_some();
                    assert!(shown || !met, "{bounds:?} {ray:?}");
                }
            }
        }
    }
}
