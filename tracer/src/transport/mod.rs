//! Light transport in the plane: light that is reflected, bent and scattered, from its lamps on.
//!
//! The realtime rooms find direct light alone. Here light meets mirrors, glass and matt walls, with its wavelength and its
//! polarization.

pub mod bake;
pub mod beams;
mod body;
mod contacts;
mod curve;
mod film;
pub mod fresnel;
mod gamut;
mod hierarchy;
pub mod interaction;
mod lamp_faces;
mod light_source;
mod material;
mod nearest;
mod pair_tree;
mod path;
mod photon;
mod photons;
mod pixel_walk;
pub mod ray_splitting;
mod scene;
pub mod spectrum;
mod splat_queue;
mod surfaces;

pub use body::{Body, Corner, Edge, arc_through};
pub use contacts::{BodyId, Contact, Contacts, EdgeId, MOST_TOGETHER, StartsOn};
pub use curve::{Crossing, Curve, Parabola};
pub use film::{PACKET_BITS, SplatFilm};
pub use gamut::{into_gamut, luminance};
pub use lamp_faces::LampFaces;
pub use light_source::{Falloff, LightSource, SourceForm, lambert};
pub use material::{Band, Dielectric, Material};
pub use path::{PathPicture, PathTracer};
pub use photon::{End, Flight, HEROES, Media, Photon, Step};
pub use photons::{Counts, MOST_SURFACES, PhotonPicture, PhotonTracer};
pub use pixel_walk::PixelSegment;
pub use scene::{Scene, TOLERANCE_MM};
pub use surfaces::Surfaces;
