//! A bounding volume hierarchy over boxes: what a ray may meet, from the nearest box on.
//!
//! Nodes of a tree of pairs are folded into nodes of eight, whose boxes a ray is tried against at once (I. Wald, C. Benthin, S. Boulos, "Getting rid of packets", 2008).

use super::pair_tree::{Pair, PairTree};
use geometry::{Bounds, Ray};

/// Children of a node: their boxes are tried at once.
const LANES: usize = 8;

/// A number for each child.
type Lanes = [f64; LANES];

/// Nodes that wait in a list of fixed length; what is more waits in one that grows.
const MOST_WAITING: usize = 48;

/// A node: the boxes of its children.
#[derive(Clone, Debug)]
#[repr(align(64))]
struct Node {
    /// For x and y.
    min: [Lanes; 2],
    max: [Lanes; 2],
    /// A child is a node, or a leaf where [`IS_LEAF`] is set.
    children: [u32; LANES],
    /// A bit for each lane that holds one.
    used: u32,
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

impl Hierarchy {
    /// The tree over these boxes, which are finite.
    pub fn new(boxes: &[Bounds]) -> Hierarchy {
        if boxes.is_empty() { Hierarchy::default() } else { Hierarchy::folded(PairTree::new(boxes)) }
    }

    /// The tree of eights of a tree of pairs.
    fn folded(tree: PairTree) -> Hierarchy {
        let (mut nodes, mut leaves) = (vec![Node::EMPTY], Vec::new());
        let mut open = vec![(0, 0)];
        while let Some((node, pair)) = open.pop() {
            for (lane, child) in tree.children(pair, LANES).into_iter().enumerate() {
                let Pair { bounds, first, count } = tree.pairs[child as usize];
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
        Hierarchy { nodes, items: tree.items, leaves }
    }

    /// The items of a leaf.
    #[inline(always)]
    pub fn leaf(&self, leaf: usize) -> &[u32] {
        let [from, to] = self.leaves[leaf];
        &self.items[from as usize..to as usize]
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
    /// No children.
    const EMPTY: Node = Node { min: [[0.0; LANES]; 2], max: [[0.0; LANES]; 2], children: [0; LANES], used: 0 };

    /// Puts a child into a lane. Its box is a little larger, for the rounding of where rays enter and leave it.
    fn set(&mut self, lane: usize, bounds: &Bounds, child: u32) {
        let largest = bounds.min.abs().max(bounds.max.abs()).max_element();
        let bounds = bounds.grown(largest * 8.0 * f64::EPSILON + f64::MIN_POSITIVE);
        for axis in 0..2 {
            (self.min[axis][lane], self.max[axis][lane]) = (bounds.min[axis], bounds.max[axis]);
        }
        self.children[lane] = child;
        self.used |= 1 << lane;
    }

    /// Where the ray enters each child's box, and a bit for each that it enters, at most `farthest` along it: the slab test.
    #[inline(always)]
    fn entries(&self, slabs: &Slabs, farthest: f64) -> (Lanes, u32) {
        let ([ox, oy], [ix, iy]) = (slabs.origin, slabs.inverse);
        let (mut entries, mut exits, mut bits) = ([0.0; LANES], [0.0; LANES], [0_u64; LANES]);
        for lane in 0..LANES {
            let x = [(self.min[0][lane] - ox) * ix, (self.max[0][lane] - ox) * ix];
            let y = [(self.min[1][lane] - oy) * iy, (self.max[1][lane] - oy) * iy];
            entries[lane] = greater(greater(less(x[0], x[1]), less(y[0], y[1])), 0.0);
            exits[lane] = less(less(greater(x[0], x[1]), greater(y[0], y[1])), farthest);
        }
        for lane in 0..LANES {
            // Rounding must not lose a box that the ray touches.
            let meets = entries[lane] <= exits[lane] * (1.0 + 4.0 * f64::EPSILON);
            bits[lane] = if meets { 1 << lane } else { 0 };
        }
        (entries, bits.iter().fold(0, |met, bit| met | bit) as u32 & self.used)
    }
}

/// The smaller number, in one instruction: `f64::min` also has to think about what is no number.
#[inline(always)]
fn less(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}

/// The larger number, in one instruction.
#[inline(always)]
fn greater(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

#[cfg(test)]
mod tests {
    use super::*;
    use geometry::rng::SplitMix64;
    use geometry::{DVec2, Segment};

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
                    for item in tree.leaf(leaf) {
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
