//! The beam sweep: caustics without noise.
//!
//! A source's light is a family of rays over two numbers: u, over which it is swept, and v, which makes it wide (the place on a tube
//! or across a disc, or else the wavelength). Four neighbouring rays that meet the same surfaces bound a beam: its light in a row
//! of pixels is spread over the box of its width in u, folded with the box of its width in v. Where neighbours meet different
//! surfaces, or the middle between them is not where a beam would have it, the beam is halved. It is the idea of beam tracing
//! (P. Heckbert and P. Hanrahan, "Beam tracing polygonal objects", SIGGRAPH 1984) and of M. Watt's caustic polygons ("Light-water
//! interaction using backward beam tracing", SIGGRAPH 1990), in the plane.
//!
//! Matt surfaces end a beam, and rough ones are polished here: photons and paths find that light.

mod beam;
mod cell;
mod corner;
mod cut;
mod family;
mod film;
mod form;
mod horizon;
mod landmarks;
mod leaf;
mod picture;
mod sweep;
mod tracer;

pub use picture::BeamPicture;
pub use tracer::{BeamOptions, BeamTracer};
