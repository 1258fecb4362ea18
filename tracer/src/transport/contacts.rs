//! What a ray meets: the edges in one place.

use geometry::DVec2;

/// Edges that one place may hold.
pub const MOST_TOGETHER: usize = 8;

/// The number of an edge.
pub type EdgeId = u32;

/// The number of a body: its place in the scene's list.
pub type BodyId = u32;

/// One edge that a ray meets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// Which edge.
    pub edge: EdgeId,
    /// Whose.
    pub body: BodyId,
    /// How far along the ray.
    pub distance: f64,
    /// Where.
    pub place: DVec2,
    /// The unit normal on the side from which the ray comes.
    pub normal: DVec2,
    /// The ray goes into the body; it says nothing of open lines.
    pub enters: bool,
}

/// All edges that a ray meets first: those in one place.
#[derive(Clone, Copy, Debug)]
pub struct Contacts {
    pub(super) list: [Contact; MOST_TOGETHER],
    pub(super) count: usize,
}

impl PartialEq for Contacts {
    fn eq(&self, other: &Contacts) -> bool {
        self.list() == other.list()
    }
}

/// The edges on which a ray starts.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StartsOn {
    edges: [EdgeId; MOST_TOGETHER],
    count: usize,
}

impl StartsOn {
    /// The ray starts in the open.
    pub const NOTHING: StartsOn = StartsOn { edges: [0; MOST_TOGETHER], count: 0 };

    /// The ray starts on one edge.
    pub fn one(edge: EdgeId) -> StartsOn {
        let mut edges = [0; MOST_TOGETHER];
        edges[0] = edge;
        StartsOn { edges, count: 1 }
    }

    /// Those edges.
    #[inline(always)]
    pub fn edges(&self) -> &[EdgeId] {
        &self.edges[..self.count]
    }

    /// Whether it is one of them.
    #[inline(always)]
    pub fn holds(&self, edge: EdgeId) -> bool {
        self.edges().contains(&edge)
    }
}

const NO_CONTACT: Contact =
    Contact { edge: 0, body: 0, distance: f64::INFINITY, place: DVec2::ZERO, normal: DVec2::ZERO, enters: false };

impl Contacts {
    /// Nothing is met.
    pub(super) const NONE: Contacts = Contacts { list: [NO_CONTACT; MOST_TOGETHER], count: 0 };

    /// The edges, the nearest one first.
    pub fn list(&self) -> &[Contact] {
        &self.list[..self.count]
    }

    /// The nearest one.
    pub fn first(&self) -> &Contact {
        &self.list[0]
    }

    /// A ray that goes on from here starts on these.
    pub fn starts_on(&self) -> StartsOn {
        StartsOn { edges: self.list.map(|contact| contact.edge), count: self.count }
    }
}
