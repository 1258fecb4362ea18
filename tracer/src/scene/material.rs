//! Materials: what occluders are made of: where light goes that meets them on its way to the floor.
//!
//! How a top looks to an eye above is its [`crate::Finish`]. A mirror or a dielectric joins here as a variant, with its
//! reflectance, index of refraction and absorption (`docs/add_an_integrator.md`, part 3).

use crate::Rgb;

/// What a thing is made of: it says where light goes that meets it.
///
/// A group is one thing, however many occluders it is put together of: all of them are of one material.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Material {
    /// Light ends here.
    #[default]
    Opaque,
    /// Coloured glass or thin plastic: light goes straight on, tinted once by each group that it meets, so the shadow is a
    /// coloured one.
    Tinted {
        /// What passes of each colour, 0 to 1.
        transmittance: Rgb,
    },
}

impl Material {
    /// What of each colour goes straight on through the thing; `None` where nothing does. Direct light asks no more than
    /// this of a material.
    pub(crate) fn transmittance(&self) -> Option<Rgb> {
        match *self {
            Material::Opaque => None,
            Material::Tinted { transmittance } => Some(transmittance),
        }
    }
}
