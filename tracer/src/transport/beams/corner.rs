//! A corner of a beam: one of the rays that bound it.

use crate::transport::interaction::{Branch, Interaction, interact};
use crate::transport::{Contacts, EdgeId, Media, StartsOn, Surfaces};
use geometry::{DVec2, Ray};

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

/// A corner, and what its ray meets next.
#[derive(Clone, Copy)]
pub(super) struct Probe {
    pub corner: Corner,
    pub edge: Option<EdgeId>,
    /// Where, or where nobody sees it any more.
    pub end: DVec2,
}

/// What a surface does with a ray that goes on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Way {
    Reflected,
    Through,
}

impl Corner {
    /// s and p together.
    pub fn strength(&self) -> f64 {
        self.power[0] + self.power[1]
    }

    /// The ray behind a surface; `None` where nothing goes this way.
    pub fn next(&self, surfaces: &Surfaces, contacts: &Contacts, way: Way) -> Option<Corner> {
        let mut smooth = |normal, _| normal;
        let interaction = interact(surfaces, contacts, self.ray.direction, self.nm, &mut smooth);
        let Interaction::Split { reflected, transmitted } = interaction else { return None };
        let Branch { direction, power } = if way == Way::Through { transmitted? } else { reflected? };
        let contact = contacts.first();
        let mut media = self.media;
        let passed = libm::exp(-media.absorption_per_mm(surfaces, self.nm) * contact.distance);
        if way == Way::Through {
            media.cross(surfaces, contacts, self.nm);
        }
        Some(Corner {
            ray: Ray { origin: contact.place, direction },
            starts_on: contacts.starts_on(),
            nm: self.nm,
            power: [0, 1].map(|of| self.power[of] * power[of] * passed),
            way: self.way + contact.distance,
            media,
        })
    }
}
