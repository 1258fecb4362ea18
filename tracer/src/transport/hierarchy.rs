//! A bounding volume hierarchy over boxes: what a ray may meet, from the nearest box on.
//!
//! Built from the top by the surface area heuristic over bins (I. Wald, "On fast construction of SAH-based bounding volume
//! hierarchies", 2007); in the plane a box is met in proportion to its circumference. Then nodes of two children are folded into
//! nodes of eight, whose boxes a ray is tried against at once (I. Wald, C. Benthin, S. Boulos, "Getting rid of packets", 2008).

use super::packets::{LANES, Lanes};
use geometry::{Bounds, DVec2, Ray};

/// Boxes in a leaf.
const LEAF: usize = LANES;
/// Bins along an axis.
const BINS: usize = 16;
/// Levels of the tree of pairs; boxes in one place end in a larger leaf.
const MOST_LEVELS: usize = 48;
/// Nodes that wait in a list of fixed length; what is more waits in one that grows.
const MOST_WAITING: usize = 48;

/// A node of the tree of pairs: a box, and what is in it.
#[derive(Clone, Copy, Debug)]
struct Pair {
    bounds: Bounds,
    /// Of a leaf the first of its items; of another node its first child, which its second one follows.
    first: u32,
    /// Items of a leaf; 0 of a node with children.
    count: u32,
}

/// A node: the boxes of its children.
#[derive(Clone, Debug)]
#[repr(align(64))]
struct Node {
    /// For x and y.
    min: [Lanes; 2],
    max: [Lanes; 2],
    /// A child is a node, or a leaf where [`IS_LEAF`] is set.
    children: [u32; LANES],
}

/// Says of a child that it is a leaf.
const IS_LEAF: u32 = 1 << 31;

/// A tree of boxes.
#[derive(Clone, Debug, Default)]
pub struct Hierarchy {
    nodes: Vec<Node>,
    /// The items in the order of the leaves.
    items: Vec<u32>,
    /// From and to among the items, for each leaf.
    leaves: Vec<[u32; 2]>,
}

/// The tree of pairs in the making.
struct Builder<'a> {
    boxes: &'a [Bounds],
    pairs: Vec<Pair>,
    items: Vec<u32>,
}

impl Builder<'_> {
    /// Splits a leaf where there is more than one place.
    fn split(&mut self, node: usize) -> bool {
        let Pair { bounds, first, count } = self.pairs[node];
        let (first, count) = (first as usize, count as usize);
        if count <= LEAF {
            return false;
        }
        let items = &mut self.items[first..first + count];
        let Some((axis, plane, _)) = best_plane(items, self.boxes) else { return false };
        let mut left = 0;
        for index in 0..count {
            if middle(&self.boxes[items[index] as usize])[axis] < plane {
                items.swap(left, index);
                left += 1;
            }
        }
        if left == 0 || left == count {
            return false;
        }
        let of = |items: &[u32]| union(items.iter().map(|item| self.boxes[*item as usize]));
        let children = [(of(&items[..left]), first, left), (of(&items[left..]), first + left, count - left)];
        self.pairs[node] = Pair { bounds, first: self.pairs.len() as u32, count: 0 };
        let pairs = children.map(|(bounds, first, count)| Pair { bounds, first: first as u32, count: count as u32 });
        self.pairs.extend(pairs);
        true
    }

    /// The nodes below `pair` that become the children of one: the largest ones are opened until there are enough.
    fn children(&self, pair: u32) -> Vec<u32> {
        let mut children = vec![pair];
        let size = |child: &u32| circumference(&self.pairs[*child as usize].bounds);
        loop {
            let open = (0..children.len()).filter(|at| self.pairs[children[*at] as usize].count == 0);
            let largest = open.max_by(|a, b| size(&children[*a]).total_cmp(&size(&children[*b])));
            let Some(largest) = largest.filter(|_| children.len() < LANES) else { return children };
            let first = self.pairs[children[largest] as usize].first;
            children[largest] = first;
            children.push(first + 1);
        }
    }
}

impl Hierarchy {
    /// The tree over these boxes, which are finite.
    pub fn new(boxes: &[Bounds]) -> Hierarchy {
        let mut builder = Builder { boxes, pairs: Vec::new(), items: (0..boxes.len() as u32).collect() };
        if boxes.is_empty() {
            return Hierarchy::default();
        }
        let root = Pair { bounds: union(boxes.iter().copied()), first: 0, count: boxes.len() as u32 };
        builder.pairs.push(root);
        let mut open = vec![(0, 0)];
        while let Some((pair, level)) = open.pop() {
            if level < MOST_LEVELS && builder.split(pair) {
                let first = builder.pairs[pair].first as usize;
                open.extend([(first, level + 1), (first + 1, level + 1)]);
            }
        }
        Hierarchy::folded(builder)
    }

    /// The tree of eights of a tree of pairs.
    fn folded(builder: Builder) -> Hierarchy {
        let (mut nodes, mut leaves) = (vec![Node::EMPTY], Vec::new());
        let mut open = vec![(0, 0)];
        while let Some((node, pair)) = open.pop() {
            for (lane, child) in builder.children(pair).into_iter().enumerate() {
                let Pair { bounds, first, count } = builder.pairs[child as usize];
                let number = if count > 0 {
                    leaves.push([first, first + count]);
                    (leaves.len() - 1) as u32 | IS_LEAF
                } else {
                    nodes.push(Node::EMPTY);
                    open.push((nodes.len() - 1, child));
                    (nodes.len() - 1) as u32
                };
                nodes[node].set(lane, &bounds, number);
            }
        }
        Hierarchy { nodes, items: builder.items, leaves }
    }

    /// The items of each leaf.
    pub fn leaves(&self) -> impl Iterator<Item = &[u32]> {
        self.leaves.iter().map(|[from, to]| &self.items[*from as usize..*to as usize])
    }

    /// The leaves that a ray may meet before `farthest`, the nearest boxes first.
    #[inline(always)]
    pub fn along(&self, ray: &Ray, farthest: f64) -> Along<'_> {
        let mut along = Along {
            nodes: &self.nodes,
            slabs: Slabs::of(ray),
            farthest,
            children: [0; MOST_WAITING],
            entries: [0.0; MOST_WAITING],
            count: 0,
            more: Vec::new(),
        };
        if !self.nodes.is_empty() {
            along.push(0, 0.0);
        }
        along
    }
}

/// A ray, ready for boxes.
struct Slabs {
    origin: [f64; 2],
    /// 1 over the direction; where that is 0 not infinity, which times 0 is no number.
    inverse: [f64; 2],
}

impl Slabs {
    #[inline(always)]
    fn of(ray: &Ray) -> Slabs {
        let inverse = |along: f64| if along == 0.0 { f64::MAX } else { 1.0 / along };
        Slabs { origin: ray.origin.to_array(), inverse: ray.direction.to_array().map(inverse) }
    }
}

/// Leaves along a ray.
pub struct Along<'a> {
    nodes: &'a [Node],
    slabs: Slabs,
    /// What lies beyond is left out; who asks may bring it nearer.
    pub farthest: f64,
    /// Nodes and leaves, and where the ray enters them.
    children: [u32; MOST_WAITING],
    entries: [f64; MOST_WAITING],
    count: usize,
    more: Vec<(u32, f64)>,
}

impl Along<'_> {
    /// The next leaf.
    #[inline(always)]
    pub fn next_leaf(&mut self) -> Option<usize> {
        loop {
            let (child, enters) = self.pop()?;
            if enters > self.farthest {
                continue;
            }
            if child & IS_LEAF != 0 {
                return Some((child ^ IS_LEAF) as usize);
            }
            let node = &self.nodes[child as usize];
            let (entries, mut met) = node.entries(&self.slabs, self.farthest);
            let (mut order, mut count) = ([0_usize; LANES], 0);
            while met != 0 {
                let lane = met.trailing_zeros() as usize % LANES;
                met &= met - 1;
                // The nearest one comes last, so it is next.
                let mut at = count;
                while at > 0 && entries[order[at - 1]] < entries[lane] {
                    order[at] = order[at - 1];
                    at -= 1;
                }
                order[at] = lane;
                count += 1;
            }
            order[..count].iter().for_each(|lane| self.push(node.children[*lane], entries[*lane]));
        }
    }

    #[inline(always)]
    fn push(&mut self, child: u32, enters: f64) {
        if self.count == MOST_WAITING {
            return self.more.push((child, enters));
        }
        (self.children[self.count], self.entries[self.count]) = (child, enters);
        self.count += 1;
    }

    #[inline(always)]
    fn pop(&mut self) -> Option<(u32, f64)> {
        if self.count == 0 {
            return None;
        }
        if self.count == MOST_WAITING
            && let Some(last) = self.more.pop()
        {
            return Some(last);
        }
        self.count -= 1;
        Some((self.children[self.count], self.entries[self.count]))
    }
}

impl Node {
    /// No children: nothing enters a box from infinity to minus infinity.
    const EMPTY: Node =
        Node { min: [[f64::INFINITY; LANES]; 2], max: [[f64::NEG_INFINITY; LANES]; 2], children: [0; LANES] };

    /// Puts a child into a lane. Its box is a little larger, for the rounding of where rays enter and leave it.
    fn set(&mut self, lane: usize, bounds: &Bounds, child: u32) {
        let largest = bounds.min.abs().max(bounds.max.abs()).max_element();
        let bounds = bounds.grown(largest * 8.0 * f64::EPSILON + f64::MIN_POSITIVE);
        for axis in 0..2 {
            (self.min[axis][lane], self.max[axis][lane]) = (bounds.min[axis], bounds.max[axis]);
        }
        self.children[lane] = child;
    }

    /// Where the ray enters each child's box, and a bit for each that it enters, at most `farthest` along it: the slab test.
    #[inline(always)]
    fn entries(&self, slabs: &Slabs, farthest: f64) -> (Lanes, u32) {
        let [x, y] = [0, 1].map(|axis| {
            let (min, max) = (&self.min[axis], &self.max[axis]);
            if slabs.inverse[axis] < 0.0 { (max, min) } else { (min, max) }
        });
        let ([ox, oy], [ix, iy]) = (slabs.origin, slabs.inverse);
        let (mut entries, mut exits, mut bits) = ([0.0; LANES], [0.0; LANES], [0_u64; LANES]);
        for lane in 0..LANES {
            let (enters_x, enters_y) = ((x.0[lane] - ox) * ix, (y.0[lane] - oy) * iy);
            let enters = if enters_x > enters_y { enters_x } else { enters_y };
            entries[lane] = if enters > 0.0 { enters } else { 0.0 };
        }
        for lane in 0..LANES {
            let (leaves_x, leaves_y) = ((x.1[lane] - ox) * ix, (y.1[lane] - oy) * iy);
            let leaves = if leaves_x < leaves_y { leaves_x } else { leaves_y };
            exits[lane] = if leaves < farthest { leaves } else { farthest };
        }
        for lane in 0..LANES {
            // Rounding must not lose a box that the ray touches.
            let meets = (entries[lane] <= exits[lane] * (1.0 + 4.0 * f64::EPSILON)) & (entries[lane] < f64::INFINITY);
            bits[lane] = if meets { 1 << lane } else { 0 };
        }
        (entries, bits.iter().fold(0, |met, bit| met | bit) as u32)
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

#[cfg(test)]
mod tests {
    use super::*;
    use geometry::Segment;
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
                let mut along = tree.along(&ray, f64::INFINITY);
                while let Some(leaf) = along.next_leaf() {
                    for item in tree.leaves().nth(leaf).expect("a leaf of the tree") {
                        assert!(!std::mem::replace(&mut shown[*item as usize], true), "shown twice");
                    }
                }
                for (bounds, shown) in boxes.iter().zip(shown) {
                    assert!(shown || !meets(&bounds.grown(-1e-9), &ray), "{bounds:?} {ray:?}");
                }
            }
        }
    }

    /// Whether the ray meets the box, which may be empty: by its sides and its inside, in another way than the tree has.
    fn meets(bounds: &Bounds, ray: &Ray) -> bool {
        if bounds.min.cmpgt(bounds.max).any() {
            return false;
        }
        let corners =
            [bounds.min, DVec2::new(bounds.max.x, bounds.min.y), bounds.max, DVec2::new(bounds.min.x, bounds.max.y)];
        let side = |at: usize| Segment { a: corners[at], b: corners[(at + 1) % 4] };
        bounds.contains(ray.origin) || (0..4).any(|at| side(at).cast(ray).is_some())
    }
}
