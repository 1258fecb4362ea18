//! Shading: what surfaces make of the light that arrives. The lamps' falloff, the floor and the tops with their albedo
//! and edges, the chrome ball and the environment that it mirrors. It knows nothing of what was drawn before.

pub(crate) mod albedo_map;
pub(crate) mod chrome_ball;
pub(crate) mod coverage;
pub(crate) mod environment;
pub(crate) mod falloff;
pub(crate) mod surface;
pub(crate) mod top_layer;
