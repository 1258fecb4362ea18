//! A corner of a beam: one of the rays that bound it.

use crate::transport::interaction::{Branch, Interaction, interact};
use crate::transport::{Contacts, Media, StartsOn, Surfaces};
use geometry::Ray;

/// A ray of a beam where it leaves a surface or its source.
#[derive(Clone, Copy)]
pub(super) struct Corner {
    pub ray: Ray,
    pub starts_on: StartsOn,
    pub nm: f64,
    /// What is left of s and of p.
    pub power: [f64; 2],
    pub way: f64,
    pub media: Media,
}

/// The corners of one edge of a beam: v 0 and v 1.
pub(super) type Side = [Corner; 2];

impl Corner {
    /// The ray behind a surface: through it, or reflected.
    pub fn next(&self, surfaces: &Surfaces, contacts: &Contacts, through: bool) -> Option<Corner> {
        let mut smooth = |normal, _| normal;
        let interaction = interact(surfaces, contacts, self.ray.direction, self.nm, &mut smooth);
        let Interaction::Split { reflected, transmitted } = interaction else { return None };
        let Branch { direction, power } = if through { transmitted? } else { reflected? };
        let contact = contacts.first();
        let mut media = self.media;
        let passed = libm::exp(-media.absorption_per_mm(surfaces, self.nm) * contact.distance);
        if through {
            media.cross(surfaces, contacts, self.nm);
        }
        Some(Corner {
            ray: Ray { origin: contact.place, direction },
            starts_on: contacts.starts_on(),
            nm: self.nm,
            power: [0, 1].map(|way| self.power[way] * power[way] * passed),
            way: self.way + contact.distance,
            media,
        })
    }
}
