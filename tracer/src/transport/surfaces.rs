//! The surfaces of a scene, ready for rays.

use super::hierarchy::Hierarchy;
use super::packets::{LANES, Lanes, Leaf, Packets};
use super::{Band, Body, Curve, Material};
use crate::simd::dispatch::{SimdLevel, multiversion};
use geometry::{Bounds, DVec2, Ray};

/// Edges that one place may hold.
pub const MOST_TOGETHER: usize = 8;

/// The number of an edge.
pub type EdgeId = u32;

/// The number of a body: its place in the scene's list.
pub type BodyId = u32;

/// An edge with what it belongs to.
#[derive(Clone, Copy, Debug)]
struct Surface {
    curve: Curve,
    body: BodyId,
    inward: bool,
}

/// What is asked of a body wherever light meets it.
#[derive(Clone, Copy, Debug)]
struct Facts {
    material: Material,
    band: Option<Band>,
    /// Light of different wavelengths goes different ways.
    parts: bool,
    /// Light of all wavelengths fares alike.
    alike: bool,
    /// It absorbs light on its way within.
    absorbs: bool,
}

impl Facts {
    fn of(body: &Body) -> Facts {
        let Body { material, band, .. } = *body;
        let is_grey = |[r, g, b]: [f64; 3]| r == g && g == b;
        let alike = match material {
            Material::Diffuse { reflectance } | Material::Mirror { reflectance, .. } => is_grey(reflectance),
            Material::Metal { .. } => false,
            Material::Dielectric(glass) => glass.dispersion.is_constant(),
            Material::Absorber | Material::BeamSplitter { .. } => true,
            Material::IdealLens { .. } | Material::IdealMirror { .. } => true,
        };
        let parts = matches!(material, Material::Dielectric(glass) if !glass.dispersion.is_constant());
        let absorbs = matches!(material, Material::Dielectric(glass) if glass.transmittance_per_mm != [1.0; 3]);
        Facts { material, band, parts: parts || band.is_some(), alike: alike && band.is_none(), absorbs }
    }
}

/// All edges of a scene's bodies.
#[derive(Clone, Debug)]
pub struct Surfaces {
    surfaces: Vec<Surface>,
    bodies: Vec<Facts>,
    hierarchy: Hierarchy,
    packets: Packets,
    /// The packets of the hierarchy's leaves.
    leaves: Vec<Leaf>,
    simd: SimdLevel,
    bounds: Option<Bounds>,
    /// Edges that are no farther apart along a ray are met together.
    tolerance: f64,
}

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
    list: [Contact; MOST_TOGETHER],
    count: usize,
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

/// The nearest edges along a ray, by distance and then by number: those in one place.
#[derive(Clone, Copy, Debug)]
struct Nearest {
    list: [(f64, EdgeId); MOST_TOGETHER],
    count: usize,
    tolerance: f64,
}

impl Nearest {
    fn none(tolerance: f64) -> Nearest {
        Nearest { list: [(f64::INFINITY, 0); MOST_TOGETHER], count: 0, tolerance }
    }

    /// How far an edge may be that is in the place of the nearest one.
    #[inline(always)]
    fn farthest(&self) -> f64 {
        self.list[0].0 + self.tolerance
    }

    fn add(&mut self, distance: f64, edge: EdgeId) {
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

    /// Adds those of a packet that are near enough.
    #[inline(always)]
    fn add_lanes(&mut self, distances: &Lanes, edges: &[EdgeId; LANES]) {
        let mut least = *distances;
        for half in [LANES / 2, LANES / 4, LANES / 8] {
            for lane in 0..half {
                let (a, b) = (least[lane], least[lane + half]);
                least[lane] = if a < b { a } else { b };
            }
        }
        if least[0] <= self.farthest() && least[0] < f64::INFINITY {
            for lane in 0..LANES {
                if distances[lane] <= self.farthest() && distances[lane] < f64::INFINITY {
                    self.add(distances[lane], edges[lane]);
                }
            }
        }
    }
}

multiversion! {
    /// What the ray meets first, not beyond `farthest`.
    fn nearest(surfaces: &Surfaces, ray: &Ray, starts_on: &StartsOn, farthest: f64, nearest: &mut Nearest) = nearest_body;
}

#[inline(always)]
fn nearest_body(surfaces: &Surfaces, ray: &Ray, starts_on: &StartsOn, farthest: f64, nearest: &mut Nearest) {
    let Surfaces { packets, leaves, .. } = surfaces;
    let mut along = surfaces.hierarchy.along(ray, farthest);
    while let Some(leaf) = along.next_leaf() {
        let Leaf { lines, arcs, others } = &leaves[leaf];
        for packet in &packets.lines[lines[0] as usize..lines[1] as usize] {
            nearest.add_lanes(&packet.cross(ray, starts_on), &packet.edges);
        }
        for packet in &packets.arcs[arcs[0] as usize..arcs[1] as usize] {
            nearest.add_lanes(&packet.cross(ray, starts_on), &packet.edges);
        }
        for edge in &packets.others[others[0] as usize..others[1] as usize] {
            if let Some(crossing) = surfaces.curve(*edge).cross(ray, starts_on.holds(*edge))
                && crossing.distance <= nearest.farthest()
            {
                nearest.add(crossing.distance, *edge);
            }
        }
        along.farthest = nearest.farthest().min(farthest);
    }
}

impl Surfaces {
    /// The surfaces of these bodies. Edges within `tolerance` of each other along a ray act together.
    pub fn new(bodies: &[Body], tolerance: f64) -> Surfaces {
        let surfaces: Vec<Surface> = bodies
            .iter()
            .zip(0..)
            .flat_map(|(body, number)| {
                body.edges.iter().map(move |edge| Surface { curve: edge.curve, body: number, inward: edge.inward })
            })
            .collect();
        let boxes: Vec<Bounds> = surfaces.iter().map(|surface| surface.curve.bounds()).collect();
        let hierarchy = Hierarchy::new(&boxes);
        let mut packets = Packets::default();
        let curve = |edge: EdgeId| surfaces[edge as usize].curve;
        let leaves = hierarchy.leaves().map(|edges| packets.pack(edges, curve)).collect();
        Surfaces {
            hierarchy,
            packets,
            leaves,
            simd: SimdLevel::best(),
            bounds: boxes.into_iter().reduce(Bounds::union),
            surfaces,
            bodies: bodies.iter().map(Facts::of).collect(),
            tolerance,
        }
    }

    /// The box around all of them.
    pub fn bounds(&self) -> Option<Bounds> {
        self.bounds
    }

    /// The curve of an edge.
    pub fn curve(&self, edge: EdgeId) -> &Curve {
        &self.surfaces[edge as usize].curve
    }

    /// What a body is made of.
    pub fn material(&self, body: BodyId) -> &Material {
        &self.bodies[body as usize].material
    }

    /// Whether light of different wavelengths goes different ways at a body.
    pub fn parts_wavelengths(&self, body: BodyId) -> bool {
        self.bodies[body as usize].parts
    }

    /// Whether a body is a dielectric that acts on all wavelengths.
    pub fn is_plain_glass(&self, body: BodyId) -> bool {
        let Facts { material, band, .. } = &self.bodies[body as usize];
        band.is_none() && matches!(material, Material::Dielectric(_))
    }

    /// Whether light of all wavelengths goes the same ways at a body, the same parts of it on each.
    pub fn fares_alike(&self, body: BodyId) -> bool {
        self.bodies[body as usize].alike
    }

    /// Whether light is absorbed inside of a body.
    pub fn absorbs(&self, body: BodyId) -> bool {
        self.bodies[body as usize].absorbs
    }

    /// Whether a body acts on a wavelength.
    pub fn acts(&self, body: BodyId, wavelength_nm: f64) -> bool {
        self.bodies[body as usize].band.is_none_or(|band| band.holds(wavelength_nm))
    }

    /// The same, whose inner loops run at another SIMD level.
    pub fn with_simd(self, simd: SimdLevel) -> Surfaces {
        Surfaces { simd, ..self }
    }

    /// What the ray meets first.
    pub fn meet(&self, ray: &Ray, starts_on: &StartsOn) -> Option<Contacts> {
        let mut contacts = Contacts::NONE;
        self.meet_into(ray, starts_on, &mut contacts);
        (contacts.count > 0).then_some(contacts)
    }

    /// The same into a list that is there: a list of eight takes as long to copy as many a ray to trace.
    pub(super) fn meet_into(&self, ray: &Ray, starts_on: &StartsOn, contacts: &mut Contacts) {
        let mut found = Nearest::none(self.tolerance);
        nearest(self.simd, self, ray, starts_on, f64::INFINITY, &mut found);
        self.list(ray, &found, contacts);
    }

    /// [`Surfaces::meet`], literally: every edge is looked at.
    pub fn meet_literally(&self, ray: &Ray, starts_on: &StartsOn) -> Option<Contacts> {
        let mut found = Nearest::none(self.tolerance);
        for (edge, surface) in (0..).zip(&self.surfaces) {
            if let Some(crossing) = surface.curve.cross(ray, starts_on.holds(edge))
                && crossing.distance <= found.farthest()
            {
                found.add(crossing.distance, edge);
            }
        }
        let mut contacts = Contacts::NONE;
        self.list(ray, &found, &mut contacts);
        (contacts.count > 0).then_some(contacts)
    }

    /// Whether anything lies on the way from the ray's origin to `distance` along it.
    pub fn is_blocked(&self, ray: &Ray, starts_on: &StartsOn, distance: f64) -> bool {
        let mut found = Nearest::none(self.tolerance);
        nearest(self.simd, self, ray, starts_on, distance, &mut found);
        found.list[0].0 < distance
    }

    /// The dielectrics in which a point lies, by the parity of the edges on a ray from it.
    pub fn media_at(&self, point: DVec2) -> Vec<BodyId> {
        let ray = Ray { origin: point, direction: DVec2::new(0.8, 0.6) };
        let mut inside = vec![];
        for surface in &self.surfaces {
            if !matches!(self.material(surface.body), Material::Dielectric(_)) {
                continue;
            }
            if surface.curve.crossings(&ray, false) % 2 == 1 {
                toggle(&mut inside, surface.body);
            }
        }
        inside.sort_unstable();
        inside
    }

    fn list(&self, ray: &Ray, found: &Nearest, contacts: &mut Contacts) {
        contacts.count = found.count;
        for (contact, (distance, edge)) in contacts.list.iter_mut().zip(&found.list[..found.count]) {
            *contact = self.contact(ray, *distance, *edge);
        }
    }

    fn contact(&self, ray: &Ray, distance: f64, edge: EdgeId) -> Contact {
        let surface = &self.surfaces[edge as usize];
        let place = ray.at(distance);
        let normal = surface.curve.normal_at(place);
        let along = normal.dot(ray.direction);
        Contact {
            edge,
            body: surface.body,
            distance,
            place,
            normal: if along > 0.0 { -normal } else { normal },
            enters: (along < 0.0) != surface.inward,
        }
    }
}

/// Puts a body into the list, or takes it out.
fn toggle(inside: &mut Vec<BodyId>, body: BodyId) {
    match inside.iter().position(|known| *known == body) {
        Some(at) => {
            inside.swap_remove(at);
        }
        None => inside.push(body),
    }
}

#[cfg(test)]
mod tests {
    use super::super::spectrum::Dispersion;
    use super::*;
    use geometry::rng::SplitMix64;
    use geometry::{Shape, trig};

    /// The tree and the literal loop agree on every ray, one that starts on an edge too.
    #[test]
    fn the_tree_meets_what_the_literal_loop_meets() {
        let mut random = SplitMix64::new(5);
        let bodies: Vec<Body> = (0..200)
            .map(|index| {
                let at = random.point_within(DVec2::splat(200.0));
                let shape = match index % 3 {
                    0 => Shape::disc(at, random.uniform(0.5, 6.0)),
                    1 => Shape::capsule(at, at + random.point_within(DVec2::splat(15.0)), 0.0),
                    _ => Shape::capsule(at, at + random.point_within(DVec2::splat(15.0)), 1.0),
                };
                Body::of_shape(&shape, Material::MIRROR)
            })
            .collect();
        let surfaces = Surfaces::new(&bodies, 1e-6);
        let mut met = 0;
        for _ in 0..2_000 {
            let direction = trig::direction(random.uniform(0.0, 6.3));
            let mut ray = Ray { origin: random.point_within(DVec2::splat(200.0)), direction };
            let mut starts_on = StartsOn::NOTHING;
            for _ in 0..20 {
                let contacts = surfaces.meet(&ray, &starts_on);
                assert_eq!(contacts, surfaces.meet_literally(&ray, &starts_on));
                let Some(contacts) = contacts else { break };
                met += 1;
                let Contact { distance, normal, .. } = *contacts.first();
                assert!(surfaces.is_blocked(&ray, &starts_on, distance * (1.0 + 1e-9)));
                assert!(!surfaces.is_blocked(&ray, &starts_on, distance * (1.0 - 1e-9)));
                let direction = ray.direction - normal * (2.0 * normal.dot(ray.direction));
                ray = Ray { origin: ray.at(distance), direction };
                starts_on = contacts.starts_on();
            }
        }
        assert!(met > 10_000, "{met}");
    }

    /// The same contacts, to the bit, at every SIMD level.
    #[test]
    fn every_simd_level_meets_the_same() {
        let scene = crate::scenes::optical_jumble(60, 3);
        let mut random = SplitMix64::new(6);
        for _ in 0..2_000 {
            let direction = trig::direction(random.uniform(0.0, 6.3));
            let ray = Ray { origin: random.point_within(DVec2::new(540.0, 1080.0)), direction };
            let at = |simd| Surfaces::new(&scene.bodies, 1e-6).with_simd(simd).meet(&ray, &StartsOn::NOTHING);
            let met: Vec<_> = SimdLevel::available().into_iter().map(at).collect();
            assert!(met.windows(2).all(|two| two[0] == two[1]));
        }
    }

    #[test]
    fn a_point_lies_in_the_glasses_that_are_round_it() {
        let glass = Material::glass(Dispersion::Constant(1.5));
        let disc = |x: f64, radius: f64| Body::of_shape(&Shape::disc(DVec2::new(x, 0.0), radius), glass);
        let wall = Body::of_shape(&Shape::disc(DVec2::new(0.0, 0.0), 50.0), Material::Absorber);
        let surfaces = Surfaces::new(&[disc(0.0, 10.0), disc(5.0, 10.0), wall, disc(0.0, 1.0)], 1e-6);
        assert_eq!(surfaces.media_at(DVec2::new(0.0, 0.0)), [0, 1, 3]);
        assert_eq!(surfaces.media_at(DVec2::new(-8.0, 0.0)), [0]);
        assert_eq!(surfaces.media_at(DVec2::new(12.0, 0.0)), [1]);
        assert_eq!(surfaces.media_at(DVec2::new(30.0, 0.0)), []);
    }
}
