//! The surfaces of a scene, ready for rays.

use super::hierarchy::Hierarchy;
use super::{Band, Body, Curve, Material};
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

/// All edges of a scene's bodies.
#[derive(Clone, Debug)]
pub struct Surfaces {
    surfaces: Vec<Surface>,
    materials: Vec<(Material, Option<Band>)>,
    hierarchy: Hierarchy,
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

    fn holds(&self, edge: EdgeId) -> bool {
        self.edges[..self.count].contains(&edge)
    }
}

const NO_CONTACT: Contact =
    Contact { edge: 0, body: 0, distance: f64::INFINITY, place: DVec2::ZERO, normal: DVec2::ZERO, enters: false };

impl Contacts {
    const NONE: Contacts = Contacts { list: [NO_CONTACT; MOST_TOGETHER], count: 0 };

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

    fn add(&mut self, contact: Contact, tolerance: f64) {
        let mut at = 0;
        while at < self.count && self.list[at].distance <= contact.distance {
            at += 1;
        }
        if at == MOST_TOGETHER {
            return;
        }
        self.list.copy_within(at..MOST_TOGETHER - 1, at + 1);
        self.list[at] = contact;
        self.count = (self.count + 1).min(MOST_TOGETHER);
        let farthest = self.list[0].distance + tolerance;
        while self.list[self.count - 1].distance > farthest {
            self.count -= 1;
        }
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
        Surfaces {
            hierarchy: Hierarchy::new(&boxes),
            bounds: boxes.into_iter().reduce(Bounds::union),
            surfaces,
            materials: bodies.iter().map(|body| (body.material, body.band)).collect(),
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
        &self.materials[body as usize].0
    }

    /// Whether light of different wavelengths goes different ways at a body.
    pub fn parts_wavelengths(&self, body: BodyId) -> bool {
        let (material, band) = &self.materials[body as usize];
        band.is_some() || matches!(material, Material::Dielectric(glass) if !glass.dispersion.is_constant())
    }

    /// Whether light is absorbed inside of a body.
    pub fn absorbs(&self, body: BodyId) -> bool {
        matches!(self.material(body), Material::Dielectric(glass) if glass.transmittance_per_mm != [1.0; 3])
    }

    /// Whether a body acts on a wavelength.
    pub fn acts(&self, body: BodyId, wavelength_nm: f64) -> bool {
        self.materials[body as usize].1.is_none_or(|band| band.holds(wavelength_nm))
    }

    /// What the ray meets first.
    pub fn meet(&self, ray: &Ray, starts_on: &StartsOn) -> Option<Contacts> {
        let mut contacts = Contacts::NONE;
        self.hierarchy.visit(ray, f64::INFINITY, |edge| {
            self.look(edge, ray, starts_on, &mut contacts);
            contacts.first().distance + self.tolerance
        });
        (contacts.count > 0).then_some(contacts)
    }

    /// [`Surfaces::meet`], literally: every edge is looked at.
    pub fn meet_literally(&self, ray: &Ray, starts_on: &StartsOn) -> Option<Contacts> {
        let mut contacts = Contacts::NONE;
        (0..self.surfaces.len() as EdgeId).for_each(|edge| self.look(edge, ray, starts_on, &mut contacts));
        (contacts.count > 0).then_some(contacts)
    }

    /// Whether anything lies on the way from the ray's origin to `distance` along it.
    pub fn is_blocked(&self, ray: &Ray, starts_on: &StartsOn, distance: f64) -> bool {
        let mut blocked = false;
        self.hierarchy.visit(ray, distance, |edge| {
            let crossing = self.surfaces[edge as usize].curve.cross(ray, starts_on.holds(edge));
            blocked |= crossing.is_some_and(|crossing| crossing.distance < distance);
            if blocked { 0.0 } else { distance }
        });
        blocked
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

    fn look(&self, edge: EdgeId, ray: &Ray, starts_on: &StartsOn, contacts: &mut Contacts) {
        let surface = &self.surfaces[edge as usize];
        let Some(crossing) = surface.curve.cross(ray, starts_on.holds(edge)) else { return };
        if crossing.distance > contacts.first().distance + self.tolerance {
            return;
        }
        let along = crossing.normal.dot(ray.direction);
        let contact = Contact {
            edge,
            body: surface.body,
            distance: crossing.distance,
            place: ray.at(crossing.distance),
            normal: if along > 0.0 { -crossing.normal } else { crossing.normal },
            enters: (along < 0.0) != surface.inward,
        };
        contacts.add(contact, self.tolerance);
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
