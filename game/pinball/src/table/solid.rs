//! Solids: what casts a shadow, has a top that can be seen, or both.

use geometry::{DVec2, Shape};
use physics::PartId;
use serde::{Deserialize, Serialize};

/// A drawn element that casts a shadow, has a top, or both.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Solid {
    /// The part that moves it or is hit with it, if any.
    pub part: Option<PartId>,
    /// Solids with the same group do not shade each other's tops.
    pub group: u16,
    /// What casts its shadow, mm, as drawn (a flipper at rest, a drop target up).
    pub shapes_mm: Vec<Shape>,
    /// A plastic's closed outline, mm, where it is not the shapes themselves.
    pub plastic_mm: Option<Vec<DVec2>>,
    /// Casts a shadow.
    pub shadow: bool,
    /// How its top looks.
    pub finish: Finish,
}

/// How a solid's top looks.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Finish {
    /// Reflectance, sRGB. With `art` it multiplies the art.
    pub albedo: [u8; 3],
    /// Its form.
    pub profile: Profile,
    /// Strength of its highlights: 0 is matt, 1 is polished metal.
    pub gloss: f32,
    /// Takes its colour from the plastics' art where that is opaque.
    pub art: bool,
    /// Light of its own, sRGB.
    pub emission: [u8; 3],
    /// What that light is multiplied by.
    pub emission_power: f32,
    /// How much of it there is: 1 is solid, 0 is not there.
    pub opacity: f32,
    /// How much of the light below it comes through, in the colour of its albedo.
    pub translucency: f32,
}

/// A top's form in cross section.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Profile {
    /// Flat, with an edge rounded over this width, mm.
    Bevel(f32),
    /// Round all over: a rubber ring, a wire, a dome.
    Dome,
}

impl Solid {
    /// Whether its top has an outline of its own, and lies over a place.
    pub fn has_top_over(&self, place_mm: DVec2) -> bool {
        self.plastic_mm.as_ref().is_some_and(|top| contains(top, place_mm))
    }
}

/// Whether a polygon holds a place, by the rule of even and odd.
fn contains(polygon: &[DVec2], place: DVec2) -> bool {
    let next = polygon.iter().cycle().skip(1);
    let crossed = polygon.iter().zip(next).filter(|(a, b)| {
        let is_beside = (a.y > place.y) != (b.y > place.y);
        is_beside && place.x < a.x + (b.x - a.x) * (place.y - a.y) / (b.y - a.y)
    });
    crossed.count() % 2 == 1
}
