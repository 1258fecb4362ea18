//! Rods that shoot: the plunger's, of steel with a rubber tip and the spring that drives it, and those of kickbacks,
//! whose coils are below the playfield.

use super::ids::FirstIds;
use super::solid_motion::value;
use super::{MM_PER_M, mm};
use geometry::{DVec2, Shape};
use physics::{Kind, Layout, PartId, Pose};
use std::iter;
use tracer::{Finish, Group, Occluder, Outline, Profile, Scene, Top};

const ROD_RADIUS_MM: f64 = 3.0;
const ROD_LENGTH_MM: f64 = 120.0;
/// How much of a kickback's rod is seen behind its tip at rest: there it comes out of its housing.
const KICKBACK_MM: f64 = 12.0;
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

/// Where a rod slides, mm.
pub struct Rod {
    tip: DVec2,
    way: DVec2,
    half_width: f64,
    stroke: f64,
    group: Group,
    /// The first ids of its occluders and of its tops.
    ids: FirstIds,
    /// The kickback that it is; else it is the plunger's.
    kickback: Option<PartId>,
}

impl Rod {
    /// The rods of a layout.
    pub fn all(layout: &Layout, group: Group, ids: &mut FirstIds) -> Vec<Rod> {
        let mut rods = Vec::new();
        for (index, part) in layout.parts.iter().enumerate() {
            let (tip, way, half_width_m, stroke_m, kickback) = match &part.kind {
                Kind::Plunger(p) => (p.tip, p.direction, p.half_width_m, p.stroke_m, None),
                Kind::Kickback(k) => (k.tip, k.direction, k.half_width_m, k.stroke_m, Some(PartId(index as u16))),
                _ => continue,
            };
            let (half_width, stroke) = (half_width_m * MM_PER_M, stroke_m * MM_PER_M);
            let tops = if kickback.is_some() { 2 } else { 2 + COILS as u32 };
            rods.push(Rod { tip: mm(tip), way, half_width, stroke, group, ids: ids.take(2, tops), kickback });
        }
        rods
    }

    /// How far its tip is from where it rests, in parts of its stroke, forwards.
    fn out(&self, pose: &Pose) -> f64 {
        match self.kickback {
            None => -pose.plunger.clamp(0.0, 1.0),
            Some(part) => value(&pose.extensions, part).unwrap_or_default().clamp(0.0, 1.0),
        }
    }

    /// How long it is behind its tip, mm.
    fn length(&self, out: f64) -> f64 {
        if self.kickback.is_some() { KICKBACK_MM + self.stroke * out } else { ROD_LENGTH_MM }
    }

    /// Adds the rod to the scene.
    pub fn place(&self, pose: &Pose, scene: &mut Scene) {
        let out = self.out(pose);
        let face = self.tip + self.way * (self.stroke * out);
        let tip_middle = face - self.way * TIP_RADIUS_MM;
        let reach = self.way.perp() * (self.half_width - TIP_RADIUS_MM).max(0.5);
        let rod = Shape::capsule(tip_middle, tip_middle - self.way * self.length(out), ROD_RADIUS_MM);
        let tip = Shape::capsule(tip_middle - reach, tip_middle + reach, TIP_RADIUS_MM);
        let coils = self.coils(face).filter(|_| self.kickback.is_none()).map(|coil| (coil, WIRE));
        let shown = iter::once((rod, STEEL)).chain(coils).chain(iter::once((tip, RUBBER)));
        scene.tops.extend((0..).zip(shown).map(|(number, (shape, finish))| {
            let outline = Outline::Shape(shape);
            Top { id: self.ids.top(number), outline, group: self.group, finish }
        }));
        let occluders = (0..).zip([rod, tip]);
        let occluder = |(number, shape)| Occluder::opaque(self.ids.occluder(number), shape, self.group);
        scene.occluders.extend(occluders.map(occluder));
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
