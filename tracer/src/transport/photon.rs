//! A photon: a packet of light on its way, from its source until it is absorbed or gone.
//!
//! A packet keeps its power. Where surfaces divide light, chance decides which way all of it goes (analog Monte Carlo), so what
//! was sent is what was absorbed, is gone, or was given up, in whole packets. It carries [`HEROES`] wavelengths at once (A.
//! Wilkie et al., "Hero wavelength spectral sampling", EGSR 2014) until something bends or parts them: then one of them,
//! drawn in proportion to its power, carries all. It is polarized s or p, which no surface in the plane mixes; a matt
//! surface forgets it.

use super::interaction::{Branch, Interaction, each_crossed, interact};
use super::light_source::lambert;
use super::{BodyId, Contacts, Material, StartsOn, Surfaces};
use geometry::rng::SplitMix64;
use geometry::{DVec2, Ray};

/// Wavelengths of a packet.
pub const HEROES: usize = 4;

/// Bodies that a packet may be inside of at once and be absorbed by.
const MOST_MEDIA: usize = 8;

/// Facets that a rough surface may send light to, one after the other.
const MOST_FACETS: usize = 16;

/// A packet of light.
#[derive(Clone, Debug)]
pub struct Photon {
    /// Where it is, and which way it goes.
    pub ray: Ray,
    /// The edges that it comes from.
    pub starts_on: StartsOn,
    /// Its wavelengths, nm.
    pub wavelengths_nm: [f64; HEROES],
    /// The power of each wavelength. Their sum never changes.
    pub power: [f64; HEROES],
    /// 0: s polarized; 1: p polarized.
    pub polarization: usize,
    /// How far it has come.
    pub way: f64,
    /// The absorbing dielectrics that it is in.
    pub media: Media,
}

/// A short list of bodies.
#[derive(Clone, Copy, Debug, Default)]
pub struct Media {
    bodies: [BodyId; MOST_MEDIA],
    count: usize,
}

/// A straight piece of a packet's way.
pub struct Flight<'a> {
    /// The packet at its start.
    pub photon: &'a Photon,
    /// How far it goes; infinite if it meets nothing more.
    pub distance: f64,
    /// How much of each wavelength is absorbed on the way, 1/mm.
    pub absorption_per_mm: Option<[f64; HEROES]>,
}

/// How a packet ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// In a surface or in a medium.
    Absorbed,
    /// It has left the scene.
    Gone,
    /// It was given up, after so many surfaces.
    GivenUp,
}

/// What became of a packet where it met surfaces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Step {
    /// It goes straight on.
    Passes,
    /// A mirror or glass has turned it.
    Turns,
    /// A matt surface has sent it on, by chance; this is the surface's normal on its side.
    Scatters(DVec2),
    /// It has ended.
    Ends(End),
}

impl Media {
    /// These bodies, as far as there is room.
    pub fn of(bodies: impl IntoIterator<Item = BodyId>) -> Media {
        let mut media = Media::default();
        bodies.into_iter().for_each(|body| media.enter(body));
        media
    }

    /// There are none.
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// What they absorb of a wavelength, 1/mm.
    pub fn absorption_per_mm(&self, surfaces: &Surfaces, wavelength_nm: f64) -> f64 {
        let in_one = |body: &BodyId| match surfaces.material(*body) {
            Material::Dielectric(glass) => glass.absorption_per_mm(wavelength_nm),
            _ => 0.0,
        };
        self.list().iter().map(in_one).sum()
    }

    /// Goes into and out of the absorbing dielectrics at these contacts.
    pub fn cross(&mut self, surfaces: &Surfaces, contacts: &Contacts, wavelength_nm: f64) {
        if !contacts.list().iter().any(|contact| surfaces.absorbs(contact.body)) {
            return;
        }
        each_crossed(surfaces, contacts, wavelength_nm, |contact| {
            if surfaces.absorbs(contact.body) {
                if contact.enters { self.enter(contact.body) } else { self.leave(contact.body) }
            }
        });
    }

    fn list(&self) -> &[BodyId] {
        &self.bodies[..self.count]
    }

    fn enter(&mut self, body: BodyId) {
        if self.count < MOST_MEDIA && !self.list().contains(&body) {
            self.bodies[self.count] = body;
            self.count += 1;
        }
    }

    fn leave(&mut self, body: BodyId) {
        if let Some(at) = self.list().iter().position(|known| *known == body) {
            self.count -= 1;
            self.bodies[at] = self.bodies[self.count];
        }
    }
}

impl Photon {
    /// Its power, all wavelengths together.
    pub fn total_power(&self) -> f64 {
        self.power.iter().sum()
    }

    /// Follows the packet to its end, through at most `most_surfaces`; `fly` sees each straight piece of its way.
    pub fn follow(
        mut self,
        surfaces: &Surfaces,
        random: &mut SplitMix64,
        most_surfaces: u32,
        mut fly: impl FnMut(&Flight),
    ) -> End {
        let mut contacts = Contacts::NONE;
        for _ in 0..most_surfaces {
            if let Step::Ends(end) = self.step_with(surfaces, random, &mut contacts, &mut fly) {
                return end;
            }
        }
        End::GivenUp
    }

    /// Goes to the next surface, and on from there; `fly` sees the way to it.
    pub fn step(&mut self, surfaces: &Surfaces, random: &mut SplitMix64, fly: impl FnOnce(&Flight)) -> Step {
        self.step_with(surfaces, random, &mut { Contacts::NONE }, fly)
    }

    fn step_with(
        &mut self,
        surfaces: &Surfaces,
        random: &mut SplitMix64,
        contacts: &mut Contacts,
        fly: impl FnOnce(&Flight),
    ) -> Step {
        surfaces.meet_into(&self.ray, &self.starts_on, contacts);
        let meets = !contacts.list().is_empty();
        let distance = if meets { contacts.first().distance } else { f64::INFINITY };
        let absorption_per_mm = self.absorption(surfaces);
        fly(&Flight { photon: self, distance, absorption_per_mm });
        if !meets {
            // An endless way in an absorbing medium ends in it.
            return Step::Ends(if absorption_per_mm.is_some() { End::Absorbed } else { End::Gone });
        }
        if let Some(absorption) = absorption_per_mm
            && !self.survives(random, |of, _| libm::exp(-absorption[of] * distance))
        {
            return Step::Ends(End::Absorbed);
        }
        self.way += distance;
        self.ray.origin = contacts.first().place;
        self.meet(surfaces, contacts, random)
    }

    /// How much of each wavelength the media absorb that the packet is in, 1/mm.
    fn absorption(&self, surfaces: &Surfaces) -> Option<[f64; HEROES]> {
        if self.media.count == 0 {
            return None;
        }
        Some(self.wavelengths_nm.map(|nm| self.media.absorption_per_mm(surfaces, nm)))
    }

    /// Whether the packet goes on where `part` of each wavelength does. If so the wavelengths' powers shift, and their sum stays.
    fn survives(&mut self, random: &mut SplitMix64, part: impl Fn(usize, f64) -> f64) -> bool {
        let total = self.total_power();
        let kept: [f64; HEROES] = std::array::from_fn(|of| self.power[of] * part(of, self.wavelengths_nm[of]));
        let sum: f64 = kept.iter().sum();
        if random.unit() * total >= sum {
            return false;
        }
        self.power = kept.map(|kept| kept * (total / sum));
        true
    }

    /// One wavelength carries all from here on.
    fn choose_wavelength(&mut self, random: &mut SplitMix64) {
        if self.power[1..] == [0.0; HEROES - 1] {
            return;
        }
        let total = self.total_power();
        let mut left = random.unit() * total;
        let chosen = self.power.iter().position(|power| {
            left -= power;
            left < 0.0
        });
        // Rounding may leave a rest behind the last one.
        let chosen = chosen.or_else(|| self.power.iter().rposition(|power| *power > 0.0)).unwrap_or(0);
        self.wavelengths_nm = [self.wavelengths_nm[chosen]; HEROES];
        self.power = [0.0; HEROES];
        self.power[0] = total;
    }

    /// What becomes of it where it meets these.
    pub fn meet(&mut self, surfaces: &Surfaces, contacts: &Contacts, random: &mut SplitMix64) -> Step {
        if contacts.list().iter().any(|contact| surfaces.parts_wavelengths(contact.body)) {
            self.choose_wavelength(random);
        }
        // What one wavelength meets is asked once where the others have no power, or meet the same.
        let alike = self.power[1..] == [0.0; HEROES - 1]
            || contacts.list().iter().all(|contact| surfaces.fares_alike(contact.body));
        self.starts_on = contacts.starts_on();
        let front = contacts.first().normal;
        for _ in 0..MOST_FACETS {
            let incoming = self.ray.direction;
            // All wavelengths meet the same facet.
            let mut met = None;
            let mut facet = |normal, roughness| *met.get_or_insert_with(|| facet(normal, incoming, roughness, random));
            let mut of_wavelength =
                |of: usize| interact(surfaces, contacts, incoming, self.wavelengths_nm[of], &mut facet);
            let first = of_wavelength(0);
            let choice = if alike {
                self.choose(&first, |_| &first, random)
            } else {
                let others: [Interaction; HEROES - 1] = std::array::from_fn(|of| of_wavelength(of + 1));
                self.choose(&first, |of| if of == 0 { &first } else { &others[of - 1] }, random)
            };
            match choice {
                Choice::Absorbed => return Step::Ends(End::Absorbed),
                Choice::Scattered(normal) => {
                    self.ray.direction = lambert(normal, random.unit());
                    self.polarization = (random.next_u64() >> 63) as usize;
                    return Step::Scatters(normal);
                }
                Choice::Reflected(direction) => {
                    self.ray.direction = direction;
                    if direction.dot(front) > 0.0 {
                        return Step::Turns;
                    }
                    // A facet has sent it further into the surface: it meets another one there.
                }
                Choice::Transmitted(direction) => {
                    self.ray.direction = direction;
                    self.media.cross(surfaces, contacts, self.wavelengths_nm[0]);
                    return if direction == incoming { Step::Passes } else { Step::Turns };
                }
            }
        }
        Step::Ends(End::GivenUp)
    }

    /// One of the ways on, by chance in proportion to their power; `each` is what every wavelength meets.
    fn choose<'a>(
        &mut self,
        first: &Interaction,
        each: impl Fn(usize) -> &'a Interaction,
        random: &mut SplitMix64,
    ) -> Choice {
        let way = self.polarization;
        match *first {
            Interaction::Absorbed => Choice::Absorbed,
            Interaction::Scattered { normal, .. } => {
                let part = |of: usize| match each(of) {
                    Interaction::Scattered { reflectance, .. } => *reflectance,
                    _ => 0.0,
                };
                if self.survives(random, |of, _| part(of)) { Choice::Scattered(normal) } else { Choice::Absorbed }
            }
            Interaction::Split { reflected, transmitted } => {
                let part = |of: usize, through: bool| match each(of) {
                    Interaction::Split { reflected, transmitted } => {
                        let branch = if through { transmitted } else { reflected };
                        branch.as_ref().map_or(0.0, |branch: &Branch| branch.power[way])
                    }
                    _ => 0.0,
                };
                let total = self.total_power();
                let sum = |through: bool| (0..HEROES).map(|of| self.power[of] * part(of, through)).sum::<f64>();
                let (back, on) = (sum(false), sum(true));
                let place = random.unit() * total;
                let (through, sum, branch) = if place < back {
                    (false, back, reflected)
                } else if place < back + on {
                    (true, on, transmitted)
                } else {
                    return Choice::Absorbed;
                };
                let Some(branch) = branch else { return Choice::Absorbed };
                self.power = std::array::from_fn(|of| self.power[of] * part(of, through) * (total / sum));
                if through { Choice::Transmitted(branch.direction) } else { Choice::Reflected(branch.direction) }
            }
        }
    }
}

/// What chance has decided.
enum Choice {
    Absorbed,
    Scattered(DVec2),
    Reflected(DVec2),
    Transmitted(DVec2),
}

/// The normal of a facet that light from `direction` meets on a rough surface. Slopes are distributed as Gauss has it, and light
/// meets a facet in proportion to the width that it shows (E. Heitz, "Understanding the masking-shadowing function in
/// microfacet-based BRDFs", JCGT 3(2), 2014, section 3, in the plane).
fn facet(normal: DVec2, direction: DVec2, roughness: f64, random: &mut SplitMix64) -> DVec2 {
    let along = normal.perp();
    let (across, down) = (direction.dot(along), -direction.dot(normal));
    // The width that a facet of the slope m shows: down + m across.
    let widest = down.abs() + MOST_SLOPE * roughness * across.abs();
    loop {
        let slope = roughness * gauss(random);
        let width = down + slope * across;
        if slope.abs() <= MOST_SLOPE * roughness && random.unit() * widest < width {
            return (normal - along * slope).normalize();
        }
        if widest <= 0.0 {
            return normal;
        }
    }
}

/// Slopes beyond so many standard deviations are left out.
const MOST_SLOPE: f64 = 4.0;

/// A number of the normal distribution: G. Box and M. Muller, 1958.
fn gauss(random: &mut SplitMix64) -> f64 {
    let radius = (-2.0 * libm::log(1.0 - random.unit())).sqrt();
    radius * libm::cos(std::f64::consts::TAU * random.unit())
}
