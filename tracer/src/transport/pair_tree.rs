//! A tree of boxes, two by two.
//!
//! Built from the top by the surface area heuristic over bins (I. Wald, "On fast construction of SAH-based bounding volume
//! hierarchies", 2007); in the plane a box is met in proportion to its circumference.

use geometry::{Bounds, DVec2};

/// Boxes in a leaf: a box is eight times as cheap as what is in it.
const LEAF: usize = 1;
/// Bins along an axis.
const BINS: usize = 16;
/// Levels of the tree of pairs; boxes in one place end in a larger leaf.
const MOST_LEVELS: usize = 48;

/// A node of the tree of pairs: a box, and what is in it.
#[derive(Clone, Copy, Debug)]
pub struct Pair {
    /// Round all that is in it.
    pub bounds: Bounds,
    /// Of a leaf the first of its items; of another node its first child, which its second one follows.
    pub first: u32,
    /// Items of a leaf; 0 of a node with children.
    pub count: u32,
}

/// A tree of boxes in pairs.
pub struct PairTree {
    /// The root is the first.
    pub pairs: Vec<Pair>,
    /// The items in the order of the leaves.
    pub items: Vec<u32>,
}

impl PairTree {
    /// The tree over these boxes, of which there are some.
    pub fn new(boxes: &[Bounds]) -> PairTree {
        let root = Pair { bounds: union(boxes.iter().copied()), first: 0, count: boxes.len() as u32 };
        let mut tree = PairTree { pairs: vec![root], items: (0..boxes.len() as u32).collect() };
        let mut open = vec![(0, 0)];
        while let Some((pair, level)) = open.pop() {
            if level < MOST_LEVELS && tree.split(pair, boxes) {
                let first = tree.pairs[pair].first as usize;
                open.extend([(first, level + 1), (first + 1, level + 1)]);
            }
        }
        tree
    }

    /// Splits a leaf where there is more than one place.
    fn split(&mut self, node: usize, boxes: &[Bounds]) -> bool {
        let Pair { bounds, first, count } = self.pairs[node];
        let (first, count) = (first as usize, count as usize);
        if count <= LEAF {
            return false;
        }
        let items = &mut self.items[first..first + count];
        let Some((axis, plane, _)) = best_plane(items, boxes) else { return false };
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
        self.pairs[node] = Pair { bounds, first: self.pairs.len() as u32, count: 0 };
        let pairs = children.map(|(bounds, first, count)| Pair { bounds, first: first as u32, count: count as u32 });
        self.pairs.extend(pairs);
        true
    }

    /// The nodes below `pair` that become the children of one: the largest ones are opened until there are enough.
    pub fn children(&self, pair: u32, most: usize) -> Vec<u32> {
        let mut children = vec![pair];
        let size = |child: &u32| circumference(&self.pairs[*child as usize].bounds);
        loop {
            let open = (0..children.len()).filter(|at| self.pairs[children[*at] as usize].count == 0);
            let largest = open.max_by(|a, b| size(&children[*a]).total_cmp(&size(&children[*b])));
            let Some(largest) = largest.filter(|_| children.len() < most) else { return children };
            let first = self.pairs[children[largest] as usize].first;
            children[largest] = first;
            children.push(first + 1);
        }
    }
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
