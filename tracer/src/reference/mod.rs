//! The reference: a Monte Carlo integrator and literal photons, by which every fast path is judged, and the judge.

pub(crate) mod culling_triangle;
pub mod flip;
pub mod literal_photons;
pub mod monte_carlo;
pub mod quality;
