//! The plunger: a steel rod with a rubber tip, and the spring that drives it.

use super::mm;
use geometry::{DVec2, Shape};
use physics::{Kind, Layout};
use tracer::{Finish, Group, Occluder, Outline, Profile, Scene, Top};

const ROD_RADIUS_MM: f64 = 3.0;
const ROD_LENGTH_MM: f64 = 120.0;
const TIP_RADIUS_MM: f64 = 3.0;
const COLLAR_MM: f64 = 9.0;
const WIRE_RADIUS_MM: f64 = 0.9;
const SPRING_HALF_WIDTH_MM: f64 = 6.0;
/// From the tip at rest, beyond the stroke, to the housing that the spring pushes against.
const HOUSING_MM: f64 = 16.0;
const COILS: usize = 9;

const STEEL: Finish = finish([0.52, 0.54, 0.58], 0.85);
const RUBBER: Finish = finish([0.06, 0.06, 0.07], 0.15);
const WIRE: Finish = finish([0.42, 0.41, 0.38], 0.7);

const fn finish(albedo: [f32; 3], gloss: f32) -> Finish {
    Finish { albedo, profile: Profile::Dome, gloss, art: false, emission: [0.0; 3], opacity: 1.0, translucency: 0.0 }
}

/// Where a plunger's rod slides.
pub struct Rod {
    tip: DVec2,
    way: DVec2,
    half_width: f64,
    stroke: f64,
    group: Group,
}

impl Rod {
    /// The rod of a layout's plunger, if it has one.
    pub fn of(layout: &Layout, group: Group) -> Option<Rod> {
        layout.parts.iter().find_map(|part| match &part.kind {
            Kind::Plunger(plunger) => Some(Rod {
                tip: mm(plunger.tip),
                way: plunger.way,
                half_width: plunger.half_width_m * 1000.0,
                stroke: plunger.stroke_m * 1000.0,
                group,
            }),
            _ => None,
        })
    }

    /// Puts the rod on stage, pulled back by `pull` of its stroke.
    pub fn place(&self, pull: f64, scene: &mut Scene) {
        let face = self.tip - self.way * (self.stroke * pull.clamp(0.0, 1.0));
        let tip_middle = face - self.way * TIP_RADIUS_MM;
        let reach = self.way.perp() * (self.half_width - TIP_RADIUS_MM).max(0.5);
        let rod = Shape::capsule(tip_middle, tip_middle - self.way * ROD_LENGTH_MM, ROD_RADIUS_MM);
        let tip = Shape::capsule(tip_middle - reach, tip_middle + reach, TIP_RADIUS_MM);
        let mut show = |shape, finish| {
            scene.tops.push(Top { outline: Outline::Shape(shape), group: self.group, finish });
        };
        show(rod, STEEL);
        for coil in self.coils(face) {
            show(coil, WIRE);
        }
        show(tip, RUBBER);
        scene.occluders.extend([rod, tip].map(|shape| Occluder { shape, group: self.group }));
    }

    /// The turns of the spring between the tip's collar and the housing: the same number however far it is pressed.
    fn coils(&self, face: DVec2) -> impl Iterator<Item = Shape> {
        let collar = face - self.way * COLLAR_MM;
        let housing = self.tip - self.way * (self.stroke + COLLAR_MM + HOUSING_MM);
        let step = (housing - collar) / COILS as f64;
        let side = self.way.perp() * SPRING_HALF_WIDTH_MM;
        (0..COILS).map(move |turn| {
            let from = collar + step * turn as f64 - side;
            Shape::capsule(from, from + side * 2.0 + step * 0.6, WIRE_RADIUS_MM)
        })
    }
}
