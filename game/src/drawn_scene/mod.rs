//! Drawn scenes: a drawing as bodies and light sources, for light in the plane that is reflected, bent and scattered.

mod attributes;
mod body;
mod lamp;
mod material;
mod scene;
#[cfg(test)]
mod tests;

pub use scene::DrawnScene;
