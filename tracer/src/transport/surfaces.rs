//! The surfaces of a scene, ready for rays.

use super::contacts::{BodyId, Contact, Contacts, EdgeId, StartsOn};
use super::hierarchy::Hierarchy;
use super::nearest::{Nearest, nearest};
use super::{Band, Body, Curve, Material};
use crate::simd::dispatch::SimdLevel;
use geometry::{Bounds, DVec2, Ray};

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
    pub(super) hierarchy: Hierarchy,
    simd: SimdLevel,
    bounds: Option<Bounds>,
    /// Edges that are no farther apart along a ray are met together.
    tolerance: f64,
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
        found.list().first().is_some_and(|first| first.0 < distance)
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
        contacts.count = found.list().len();
        for (contact, (distance, edge)) in contacts.list.iter_mut().zip(found.list()) {
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
