//! What becomes of light where it meets surfaces, for one wavelength: no chance, no path, no picture.

use super::{Contact, Contacts, Curve, MOST_TOGETHER, Material, Surfaces, fresnel};
use crate::transport::spectrum::reflectance_of_rgb;
use geometry::DVec2;

/// A way on, and what of the light goes it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Branch {
    /// Of length 1.
    pub direction: DVec2,
    /// The parts of the s and of the p polarized power, 0 to 1.
    pub power: [f64; 2],
}

/// What becomes of light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Interaction {
    /// It ends.
    Absorbed,
    /// It goes on in all directions on the side of the normal.
    Scattered {
        /// On the side from which it came.
        normal: DVec2,
        /// What does not end, 0 to 1.
        reflectance: f64,
    },
    /// It goes on in one or two directions; what of it does not, ends.
    Split {
        /// Back to the side from which it came.
        reflected: Option<Branch>,
        /// To the other side: into and out of dielectrics, as the contacts say.
        transmitted: Option<Branch>,
    },
}

impl Interaction {
    /// Nothing happens.
    fn pass(direction: DVec2) -> Interaction {
        Interaction::Split { reflected: None, transmitted: Some(Branch { direction, power: [1.0; 2] }) }
    }
}

/// What becomes of light that comes in `direction` (of length 1).
///
/// Of surfaces in one place the one acts that comes first in this order: absorbers; matt ones; mirrors, splitters and lenses;
/// dielectrics, which act together. `facet` turns a normal into that of the facet that the light meets; it is asked only for
/// rough surfaces.
pub fn interact(
    surfaces: &Surfaces,
    contacts: &Contacts,
    direction: DVec2,
    wavelength_nm: f64,
    facet: &mut dyn FnMut(DVec2, f64) -> DVec2,
) -> Interaction {
    if let [contact] = contacts.list()
        && surfaces.is_plain_glass(contact.body)
    {
        return refract(surfaces, contacts, direction, wavelength_nm, facet);
    }
    let acting = || contacts.list().iter().filter(|contact| surfaces.acts(contact.body, wavelength_nm));
    let material = |contact: &Contact| surfaces.material(contact.body);
    if acting().any(|contact| matches!(material(contact), Material::Absorber)) {
        return Interaction::Absorbed;
    }
    let matt = acting().find_map(|contact| match material(contact) {
        Material::Diffuse { reflectance } => Some((contact.normal, reflectance_of_rgb(*reflectance, wavelength_nm))),
        _ => None,
    });
    if let Some((normal, reflectance)) = matt {
        return Interaction::Scattered { normal, reflectance };
    }
    match acting().find(|contact| !matches!(material(contact), Material::Dielectric(_))) {
        Some(contact) => {
            let material = material(contact);
            let roughness = material.roughness();
            let normal = if roughness > 0.0 { facet(contact.normal, roughness) } else { contact.normal };
            sheet(material, surfaces.curve(contact.edge), contact, direction, normal, wavelength_nm)
        }
        None => refract(surfaces, contacts, direction, wavelength_nm, facet),
    }
}

/// A surface without an inside.
fn sheet(
    material: &Material,
    curve: &Curve,
    contact: &Contact,
    direction: DVec2,
    normal: DVec2,
    wavelength_nm: f64,
) -> Interaction {
    let mirrored = reflect(direction, normal);
    let branch = |direction: DVec2, power: [f64; 2]| Some(Branch { direction, power });
    match *material {
        Material::Mirror { reflectance, .. } => {
            let power = [reflectance_of_rgb(reflectance, wavelength_nm); 2];
            Interaction::Split { reflected: branch(mirrored, power), transmitted: None }
        }
        Material::Metal { metal, .. } => {
            let power = fresnel::metal(-direction.dot(normal), metal.index(wavelength_nm));
            Interaction::Split { reflected: branch(mirrored, power), transmitted: None }
        }
        Material::BeamSplitter { transmittance } => Interaction::Split {
            reflected: branch(mirrored, [1.0 - transmittance; 2]),
            transmitted: branch(direction, [transmittance; 2]),
        },
        Material::IdealLens { focal_length } => {
            let through = thin_lens(curve, contact, direction, focal_length);
            Interaction::Split { reflected: None, transmitted: branch(through, [1.0; 2]) }
        }
        Material::IdealMirror { focal_length } => {
            let through = thin_lens(curve, contact, direction, focal_length);
            Interaction::Split { reflected: branch(reflect(through, contact.normal), [1.0; 2]), transmitted: None }
        }
        Material::Absorber | Material::Diffuse { .. } | Material::Dielectric(_) => Interaction::Absorbed,
    }
}

/// The direction behind a lens without thickness: the slope to the axis changes by the height over the focal length.
fn thin_lens(curve: &Curve, contact: &Contact, direction: DVec2, focal_length: f64) -> DVec2 {
    let Curve::Line(line) = curve else { return direction };
    let Some(along) = line.along().try_normalize() else { return direction };
    let forward = -contact.normal;
    let cosine = direction.dot(forward);
    // The height of the place where the ray crosses, from the line's middle.
    let middle = (line.a + line.b) * 0.5;
    let height = (contact.place - middle).dot(along);
    let slope = direction.dot(along) / cosine - height / focal_length;
    (forward + along * slope).normalize()
}

/// Dielectrics that begin and end in one place: their indices multiply.
fn refract(
    surfaces: &Surfaces,
    contacts: &Contacts,
    direction: DVec2,
    wavelength_nm: f64,
    facet: &mut dyn FnMut(DVec2, f64) -> DVec2,
) -> Interaction {
    let (mut ratio, mut reflects, mut roughness) = (1.0, false, 0.0_f64);
    let mut normal = None;
    each_crossed(surfaces, contacts, wavelength_nm, |contact| {
        let Material::Dielectric(glass) = surfaces.material(contact.body) else { return };
        let index = glass.dispersion.index(wavelength_nm);
        ratio *= if contact.enters { index } else { 1.0 / index };
        reflects |= glass.reflects;
        roughness = roughness.max(glass.roughness);
        normal = normal.or(Some(contact.normal));
    });
    let Some(normal) = normal else { return Interaction::pass(direction) };
    if (ratio - 1.0).abs() < 1e-14 {
        return Interaction::pass(direction);
    }
    let normal = if roughness > 0.0 { facet(normal, roughness) } else { normal };
    let cosine = -direction.dot(normal);
    let mirrored = reflect(direction, normal);
    match fresnel::dielectric(cosine, ratio) {
        None => {
            Interaction::Split { reflected: Some(Branch { direction: mirrored, power: [1.0; 2] }), transmitted: None }
        }
        Some((reflected, refracted_cosine)) => {
            let through = (direction + normal * cosine) / ratio - normal * refracted_cosine;
            let reflected = if reflects { reflected } else { [0.0; 2] };
            Interaction::Split {
                reflected: reflects.then_some(Branch { direction: mirrored, power: reflected }),
                transmitted: Some(Branch { direction: through.normalize(), power: reflected.map(|part| 1.0 - part) }),
            }
        }
    }
}

/// Shows `visit` the dielectrics that light goes into or out of at these contacts. A corner of one body is met as two edges: a ray
/// that passes it goes in and out, which is nothing, and one that goes in through it goes in once.
pub fn each_crossed(surfaces: &Surfaces, contacts: &Contacts, wavelength_nm: f64, mut visit: impl FnMut(&Contact)) {
    let is_crossed = |contact: &Contact| {
        matches!(surfaces.material(contact.body), Material::Dielectric(_)) && surfaces.acts(contact.body, wavelength_nm)
    };
    if let [contact] = contacts.list() {
        if is_crossed(contact) {
            visit(contact);
        }
        return;
    }
    let mut found: [Option<&Contact>; MOST_TOGETHER] = [None; MOST_TOGETHER];
    for (at, contact) in contacts.list().iter().enumerate().filter(|(_, contact)| is_crossed(contact)) {
        match found.iter().position(|known| known.is_some_and(|known| known.body == contact.body)) {
            Some(known) if found[known].is_some_and(|known| known.enters != contact.enters) => found[known] = None,
            Some(_) => {}
            None => found[at] = Some(contact),
        }
    }
    found.into_iter().flatten().for_each(visit);
}

/// The mirror image of a direction.
pub fn reflect(direction: DVec2, normal: DVec2) -> DVec2 {
    direction - normal * (2.0 * direction.dot(normal))
}

#[cfg(test)]
mod tests {
    use super::super::spectrum::Dispersion;
    use super::super::{Body, StartsOn};
    use super::*;
    use geometry::rng::SplitMix64;
    use geometry::{Ray, Segment, Shape, trig};

    fn smooth(normal: DVec2, _: f64) -> DVec2 {
        normal
    }

    /// n1 sin i = n2 sin t, over a million random hits of discs in discs; and the powers of both ways add up to 1.
    #[test]
    fn snell_holds_on_a_million_hits() {
        let mut random = SplitMix64::new(11);
        let mut hits = 0;
        while hits < 1_000_000 {
            let index = random.uniform(1.05, 2.5);
            let outer = random.uniform(1.05, 2.5);
            let glass = |index: f64| Material::glass(Dispersion::Constant(index));
            let disc = |radius: f64, index: f64| Body::of_shape(&Shape::disc(DVec2::ZERO, radius), glass(index));
            let surfaces = Surfaces::new(&[disc(10.0, outer), disc(5.0, index)], 1e-6);
            for _ in 0..1_000 {
                let direction = trig::direction(random.uniform(0.0, 6.3));
                let origin = trig::direction(random.uniform(0.0, 6.3)) * random.uniform(0.0, 12.0);
                let ray = Ray { origin, direction };
                let Some(contacts) = surfaces.meet(&ray, &StartsOn::NOTHING) else { continue };
                hits += 1;
                let contact = contacts.first();
                let ratio = [outer, index][contact.body as usize];
                let ratio = if contact.enters { ratio } else { 1.0 / ratio };
                let along = contact.normal.perp();
                let Interaction::Split { reflected, transmitted } =
                    interact(&surfaces, &contacts, direction, 550.0, &mut smooth)
                else {
                    panic!("glass splits")
                };
                let reflected = reflected.expect("glass reflects");
                assert!((reflected.direction.dot(along) - direction.dot(along)).abs() < 1e-12);
                match transmitted {
                    Some(through) => {
                        assert!((through.direction.dot(along) * ratio - direction.dot(along)).abs() < 1e-10);
                        assert!((through.direction.length() - 1.0).abs() < 1e-12);
                        for way in 0..2 {
                            assert!((through.power[way] + reflected.power[way] - 1.0).abs() < 1e-15);
                        }
                    }
                    None => assert!(direction.dot(along).abs() >= ratio * (1.0 - 1e-12)),
                }
            }
        }
    }

    /// A lens brings parallel light to its focus, and its mirror twin back to the one before it.
    #[test]
    fn an_ideal_lens_has_its_focus() {
        let line = Curve::Line(Segment { a: DVec2::new(0.0, -20.0), b: DVec2::new(0.0, 20.0) });
        for (material, focus) in [
            (Material::IdealLens { focal_length: 30.0 }, DVec2::new(30.0, 0.0)),
            (Material::IdealLens { focal_length: -30.0 }, DVec2::new(-30.0, 0.0)),
            (Material::IdealMirror { focal_length: 30.0 }, DVec2::new(-30.0, 0.0)),
        ] {
            let surfaces = Surfaces::new(&[Body::open([line], material)], 1e-6);
            for height in [-15.0, -1.0, 4.0, 19.0] {
                let ray = Ray { origin: DVec2::new(-50.0, height), direction: DVec2::X };
                let contacts = surfaces.meet(&ray, &StartsOn::NOTHING).expect("it is there");
                let Interaction::Split { reflected, transmitted } =
                    interact(&surfaces, &contacts, ray.direction, 550.0, &mut smooth)
                else {
                    panic!("a lens lets light on")
                };
                let out = reflected.or(transmitted).expect("one way");
                let place = ray.at(contacts.first().distance);
                assert!((focus - place).perp_dot(out.direction).abs() < 1e-9, "{material:?} {height}");
            }
        }
    }

    /// Two glasses that share an edge: the ray goes out of the one and into the other at once, with the ratio of their indices.
    #[test]
    fn glasses_that_touch_act_together() {
        let corner = |x: f64, y: f64| super::super::Corner::Point(DVec2::new(x, y));
        let slab = |from: f64, to: f64, index: f64| {
            let corners = [corner(from, -9.0), corner(to, -9.0), corner(to, 9.0), corner(from, 9.0)];
            Body::closed(&corners, Material::glass(Dispersion::Constant(index))).expect("it has area")
        };
        let surfaces = Surfaces::new(&[slab(0.0, 5.0, 1.5), slab(5.0, 9.0, 1.5), slab(9.0, 12.0, 1.8)], 1e-6);
        let ray = Ray { origin: DVec2::new(2.0, 0.0), direction: DVec2::new(0.8, 0.6) };
        let contacts = surfaces.meet(&ray, &StartsOn::NOTHING).expect("an edge");
        assert_eq!(contacts.list().len(), 2);
        // Equal glass: nothing happens.
        let nothing = interact(&surfaces, &contacts, ray.direction, 550.0, &mut smooth);
        assert_eq!(nothing, Interaction::pass(ray.direction));
        let ray = Ray { origin: DVec2::new(6.0, 0.0), ..ray };
        let contacts = surfaces.meet(&ray, &StartsOn::NOTHING).expect("an edge");
        let Interaction::Split { transmitted: Some(through), .. } =
            interact(&surfaces, &contacts, ray.direction, 550.0, &mut smooth)
        else {
            panic!("glass lets light through")
        };
        assert!((through.direction.y - 0.6 * 1.5 / 1.8).abs() < 1e-12);
    }
}
