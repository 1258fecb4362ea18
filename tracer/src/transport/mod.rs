//! Light transport in the plane: light that is reflected, bent and scattered, from its lamps on.
//!
//! The realtime rooms find direct light alone. Here light meets mirrors, glass and matt walls, with its wavelength and its
//! polarization.

pub mod bake;
pub mod beams;
mod body;
mod curve;
mod film;
pub mod fresnel;
mod gamut;
mod hierarchy;
pub mod interaction;
mod light_source;
mod material;
mod path;
mod photon;
mod photons;
pub mod ray_splitting;
mod scene;
pub mod spectrum;
mod surfaces;

pub use body::{Body, Corner, Edge, arc_through};
pub use curve::{Crossing, Curve, Parabola};
pub use film::{BEAM_BITS, PACKET_BITS, PixelSegment, SplatFilm};
pub use gamut::{into_gamut, luminance};
pub use light_source::{Falloff, LightSource, SourceForm, lambert};
pub use material::{Band, Dielectric, Material};
pub use path::{PathPicture, PathTracer};
pub use photon::{End, Flight, HEROES, Media, Photon, Step};
pub use photons::{Counts, MOST_SURFACES, PhotonPicture, PhotonTracer};
pub use scene::{Scene, TOLERANCE_MM};
pub use surfaces::{BodyId, Contact, Contacts, EdgeId, MOST_TOGETHER, StartsOn, Surfaces};
