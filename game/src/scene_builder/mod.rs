//! From a snapshot of the game to the scene of light: lamps, what stands in their way, what can be seen.
//!
//! The scene builder turns a [`Snapshot`] into a [`tracer::Scene`]. What never moves is worked out once for a table;
//! what does (flippers, diverters, drop targets, gates, spinners, kickers, rods, balls) is put in its place for each
//! frame, always under the same ids (`ids.rs`), so that a renderer can tell what has changed. It refuses to know what
//! a pixel, a window, a rule or a clock is.

mod convert;
mod ids;
mod rod;
mod solid_motion;
#[cfg(test)]
mod tests;

use crate::Failure;
use crate::art;
use crate::simulation::{LampLight, Snapshot};
use crate::table::{Lamp, LampKind, Solid, Table};
use geometry::{DVec2, Shape};
use ids::FirstIds;
use physics::{Kind, Leg};
use solid_motion::SolidMotion;
use std::collections::BTreeMap;
use tracer::{
    Finish, Floor, Glow, Group, ItemId, Mask, Material, Occluder, Outline, Overhang, Revision, Rgb, Scene, Top, View,
};

/// Metres to millimetres.
const MM_PER_M: f64 = 1000.0;

/// A ball's radius, mm.
pub const BALL_RADIUS_MM: f64 = physics::BALL_RADIUS_M * MM_PER_M;

/// How far above the floor a player's eye is, mm.
const EYE_MM: f64 = 1100.0;

/// A ball that lies in a saucer is lower, so less of it stands out of the hole.
const SUNK: f64 = 0.9;

/// How much of a lamp's light comes out through the cap above it.
const CAP_GLOW: f32 = 0.09;

/// How much of the light that falls on what stands around a bulb comes back: it is translucent, and the bulb is so near
/// that its art would drown in white.
const FROSTED_SCATTER: f32 = 0.3;

/// How much of its gloss is left, for the same reason.
const FROSTED_GLOSS: f32 = 0.3;

/// The rasterized art of a table, at one view's resolution.
pub struct RasterizedArt {
    /// The floor and the plastics.
    pub floor: Floor,
    /// Where each lamp of the table that is an insert shines, in the lamps' order; empty masks for bulbs.
    pub masks: Vec<Mask>,
}

impl RasterizedArt {
    /// Rasterizes what `view` shows of `table`.
    ///
    /// # Errors
    /// If the table's art cannot be rasterized at this size.
    pub fn new(table: &Table, view: &View) -> Result<RasterizedArt, Failure> {
        let mut masks = art::masks(table, view);
        masks.iter_mut().for_each(|mask| mask.revision = Revision::fresh());
        Ok(RasterizedArt { floor: rasterize_floor(table, view)?, masks })
    }
}

/// Rasterizes the floor and the plastics as `view` shows them.
///
/// # Errors
/// If the table's art cannot be rasterized at this size.
pub fn rasterize_floor(table: &Table, view: &View) -> Result<Floor, Failure> {
    Ok(Floor { revision: Revision::fresh(), ..art::floor(table, view)? })
}

/// What of a table a scene is built from: everything that does not change from picture to picture.
pub struct SceneBuilder {
    actors: Vec<Actor>,
    overhangs: Vec<Overhang>,
    rods: Vec<rod::Rod>,
    /// The first group that no solid uses.
    free_group: u16,
    ambient: Rgb,
}

/// A solid with what moves it.
struct Actor {
    solid: Solid,
    /// What it belongs to in the light.
    group: Group,
    /// What it is made of.
    material: Material,
    /// How it looks as it is drawn.
    finish: Finish,
    /// The first ids of its occluders and of its tops.
    ids: FirstIds,
    motion: SolidMotion,
    /// The bulb inside it, an index into the table's lamps, if it is the cap above one.
    bulb: Option<usize>,
    /// A bulb is inside it or under it.
    frosted: bool,
}

impl SceneBuilder {
    /// Everything of `table` that does not change from picture to picture.
    pub fn new(table: &Table) -> SceneBuilder {
        let free_group = table.solids.iter().map(|solid| solid.group).max().map_or(0, |group| group.saturating_add(1));
        let mut ids = FirstIds::default();
        let rods = rod::Rod::all(&table.layout, Group(free_group), &mut ids);
        let mut highest = BTreeMap::new();
        highest.extend(table.solids.iter().enumerate().map(|(index, solid)| (solid.group, index)));
        let is_highest = |index: usize| highest.get(&table.solids[index].group) == Some(&index);
        let actor = |index| Actor::new(table, index, is_highest(index), &mut ids);
        let mut actors: Vec<Actor> = (0..table.solids.len()).filter_map(actor).collect();
        let mut free_group = free_group;
        for actor in actors.iter_mut().filter(|actor| actor.material != Material::Opaque) {
            // A group of its own: what it belongs to may be as opaque as ever.
            free_group = free_group.saturating_add(1);
            actor.group = Group(free_group);
        }
        SceneBuilder { actors, overhangs: overhangs(table), rods, free_group, ambient: convert::ambient(table) }
    }

    /// What `snapshot` looks like from `view`. `art` must be of the same table and view.
    pub fn scene<'a>(&self, table: &Table, snapshot: &Snapshot, view: View, art: &'a RasterizedArt) -> Scene<'a> {
        let mut scene = Scene {
            view,
            lamps: lamps(&table.lamps, &snapshot.lamps),
            occluders: Vec::with_capacity(2 * self.actors.len()),
            overhangs: self.overhangs.clone(),
            tops: Vec::with_capacity(2 * self.actors.len()),
            balls: Vec::with_capacity(snapshot.pose.balls.len() + snapshot.pose.captives.len()),
            glows: glows(&table.lamps, &snapshot.lamps, &art.masks),
            floor: &art.floor,
            half_floor: None,
            ambient: self.ambient,
        };
        self.rods.iter().for_each(|rod| rod.place(&snapshot.pose, &mut scene));
        for actor in &self.actors {
            let glow = actor.bulb.map_or([0.0; 3], |bulb| glow_of(&table.lamps[bulb], snapshot.lamps.get(bulb)));
            actor.place(snapshot, glow, &mut scene);
        }
        self.place_balls(snapshot, &mut scene);
        scene
    }

    fn place_balls(&self, snapshot: &Snapshot, scene: &mut Scene) {
        let captives = snapshot.pose.captives.iter().map(|(part, pose)| (ids::captive(*part), pose));
        let balls = snapshot.pose.balls.iter().map(|pose| (ids::ball(pose.id), pose));
        for (index, (id, pose)) in captives.chain(balls).enumerate() {
            let group = Group(self.free_group.saturating_add(1 + index as u16));
            let center_mm = pose.center * MM_PER_M;
            let height_mm = pose.height_m * MM_PER_M;
            let radius_mm = if pose.held { BALL_RADIUS_MM * SUNK } else { BALL_RADIUS_MM * nearness(height_mm) };
            let rotation = pose.rotation.map(|part| part as f32);
            let ball = tracer::Ball { id, center_mm, radius_mm, height_mm, below: !pose.above, group, rotation };
            if !ball.is_airborne() {
                scene.occluders.push(Occluder::opaque(id, Shape::disc(center_mm, radius_mm), group));
            }
            scene.balls.push(ball);
        }
    }
}

impl Actor {
    /// `None` for what is not drawn from its solid; `highest` says that it is the last of its group.
    fn new(table: &Table, index: usize, highest: bool, ids: &mut FirstIds) -> Option<Actor> {
        let solid = table.solids[index].clone();
        let motion = SolidMotion::of(&table.layout, &solid)?;
        let inside =
            |lamp: &Lamp| matches!(lamp.kind, LampKind::Bulb { inside: Some(group), .. } if group == solid.group);
        let within = table.lamps.iter().position(inside);
        let finish = convert::finish(&solid.finish);
        let (group, material) = (Group(solid.group), material(&solid, &finish));
        let (occluders, tops) = motion.most_pieces(&solid);
        let ids = ids.take(occluders, tops);
        let (bulb, frosted) = (within.filter(|_| highest), within.is_some());
        Some(Actor { solid, group, material, finish, ids, motion, bulb, frosted })
    }

    fn place(&self, snapshot: &Snapshot, glow: Rgb, scene: &mut Scene) {
        let (group, material, ids) = (self.group, self.material, self.ids);
        let placed = self.motion.place(&self.solid, self.finish, &snapshot.pose);
        if self.solid.shadow {
            let occluder =
                |&(number, shape): &(u32, Shape)| Occluder { id: ids.occluder(number), shape, group, material };
            scene.occluders.extend(placed.shadows.iter().map(occluder));
        }
        let mut finish = placed.finish;
        finish.emission = std::array::from_fn(|i| finish.emission[i] + finish.albedo[i] * glow[i]);
        if self.frosted {
            finish.albedo = finish.albedo.map(|channel| channel * FROSTED_SCATTER);
            finish.gloss *= FROSTED_GLOSS;
        }
        let top = |(number, outline)| Top { id: ids.top(number), outline, group, finish };
        scene.tops.extend(placed.outlines.into_iter().map(top));
    }
}

/// What hangs above the balls: the floors, sides and wires of the ways above the playfield.
fn overhangs(table: &Table) -> Vec<Overhang> {
    let way = |solid: &Solid| {
        let part = solid.part.and_then(|id| table.layout.parts.get(usize::from(id.0)))?;
        if let Kind::Ramp(ramp) = &part.kind { Some(ramp.clone()) } else { None }
    };
    table.solids.iter().filter_map(|solid| way(solid).map(|ramp| (solid, ramp))).flat_map(hung).collect()
}

/// A floor is its way, as broad as it is; sides and wires are what they are.
fn hung((solid, ramp): (&Solid, physics::Ramp)) -> Vec<Overhang> {
    let passes = 1.0 - solid.finish.opacity;
    let floor = |leg: &Leg| Shape { core: leg.offset(0.0), radius: ramp.half_width_m }.scaled(MM_PER_M);
    let shapes: Vec<Shape> = match solid.plastic_mm {
        Some(_) => ramp.path.iter().map(floor).collect(),
        None => solid.shapes_mm.clone(),
    };
    shapes.into_iter().map(|shape| Overhang { shape, passes }).collect()
}

/// How much larger a thing looks that is `height_mm` nearer to the eye than the floor.
fn nearness(height_mm: f64) -> f64 {
    EYE_MM / (EYE_MM - height_mm.clamp(0.0, 0.5 * EYE_MM))
}

/// What a solid is made of. Light passes a translucent one on its way over the table, in its colour, as deep as the glass is
/// thick, so squared; a plastic lies flat above the light.
fn material(solid: &Solid, &Finish { albedo, translucency, .. }: &Finish) -> Material {
    if !solid.shadow || translucency <= 0.0 || solid.plastic_mm.is_some() {
        return Material::Opaque;
    }
    Material::Tinted { transmittance: albedo.map(|channel| translucency * channel * channel) }
}

/// A solid's outlines as it is drawn.
fn outlines(solid: &Solid) -> Vec<Outline> {
    match &solid.plastic_mm {
        Some(polygon) => vec![Outline::Polygon(polygon.clone())],
        None => solid.shapes_mm.iter().map(|&shape| Outline::Shape(shape)).collect(),
    }
}

fn lamps(lamps: &[Lamp], lights: &[LampLight]) -> Vec<tracer::Lamp> {
    let bulb = |(id, (lamp, lit)): (u32, (&Lamp, &LampLight))| match lamp.kind {
        LampKind::Insert { .. } => None,
        LampKind::Bulb { center_mm, emitter, height_mm, reach_mm, inside } => {
            let (color, emitter) = (radiance(lamp, lit), convert::emitter(emitter));
            let (id, inside) = (ItemId(id), inside.map(Group));
            Some(tracer::Lamp { id, center_mm, emitter, height_mm, reach_mm, color, inside })
        }
    };
    (0..).zip(lamps.iter().zip(lights)).filter_map(bulb).collect()
}

fn glows<'a>(lamps: &[Lamp], lights: &[LampLight], masks: &'a [Mask]) -> Vec<Glow<'a>> {
    let lit = |(id, ((lamp, light), mask)): (u32, ((&Lamp, &LampLight), &'a Mask))| {
        let shines = matches!(lamp.kind, LampKind::Insert { .. }) && light.level > 0;
        shines.then(|| Glow { id: ItemId(id), mask, color: radiance(lamp, light) })
    };
    (0..).zip(lamps.iter().zip(lights).zip(masks)).filter_map(lit).collect()
}

/// A lamp's light: its colour, linear, times its power and its level.
fn radiance(lamp: &Lamp, lit: &LampLight) -> Rgb {
    let strength = lamp.power as f32 * f32::from(lit.level) / 1000.0;
    convert::linear(lit.color, strength)
}

/// What comes out through the cap above a bulb.
fn glow_of(lamp: &Lamp, light: Option<&LampLight>) -> Rgb {
    light.map_or([0.0; 3], |light| radiance(lamp, light).map(|channel| channel * CAP_GLOW))
}

/// `point` in millimetres.
fn mm(point_m: DVec2) -> DVec2 {
    point_m * MM_PER_M
}
