//! The exact light measures a lamp by its chord, light transport by its angle and from its rim: how far the two are apart near a
//! lamp, in the open and in a penumbra.

use crate::Failure;
use crate::commands::print::print_lines;
use geometry::{DVec2, Ray, Shape, trig};
use serde::Serialize;
use std::f64::consts::PI;
use tracer::transport::{Body, Falloff, Material, StartsOn, Surfaces, TOLERANCE_MM};
use tracer::{Emitter, Group, ItemId, Lamp, Occluder, Scene, scalar, scenes};

/// A disc lamp of a table.
const RADIUS_MM: f64 = 6.0;

/// From the lamp's middle to the point, in its radii.
const DISTANCES: [f64; 8] = [1.1, 1.25, 1.5, 2.0, 3.0, 5.0, 10.0, 20.0];

/// Directions in which the lamp is looked at.
const DIRECTIONS: usize = 40_000;

/// The light of one lamp at a distance, relative to what a point of light would give there.
#[derive(Clone, Copy, Debug, Serialize)]
struct Row {
    /// From the lamp's middle, in radii.
    distance_radii: f64,
    /// In the open, with a quarter of the chord hidden, with three quarters hidden.
    chord: [f64; 3],
    angle: [f64; 3],
}

/// Prints the light by chord and by angle, and how far they are apart.
///
/// # Errors
/// If nothing can be printed.
pub fn run(json: bool) -> Result<(), Failure> {
    let rows = DISTANCES.map(row);
    let text = if json { serde_json::to_string_pretty(&rows).expect("plain numbers are JSON") } else { text(&rows) };
    print_lines(text.lines())
}

fn row(distance_radii: f64) -> Row {
    let point = DVec2::new(distance_radii * RADIUS_MM, 0.0);
    let walls = [None, Some(0.25), Some(0.75)].map(|hidden| hidden.map(|hidden| wall(point, hidden)));
    let lamp = Lamp::disc(ItemId(1), DVec2::ZERO, RADIUS_MM, [1.0; 3]);
    let alone = lamp.falloff(point);
    let chord = walls.map(|wall| by_chord(&lamp, wall, point) / alone);
    let angle = walls.map(|wall| by_angle(&lamp, wall, point) / alone);
    Row { distance_radii, chord, angle }
}

/// A wall half way from a point to the lamp's rim that hides a part of the chord, from above.
fn wall(point: DVec2, hidden: f64) -> Shape {
    let half_way = 0.5 * (point.x + RADIUS_MM);
    // The chord goes from one side to the other through the lamp's middle.
    let edge = DVec2::new(0.0, RADIUS_MM * (2.0 * hidden - 1.0));
    let end = point.lerp(edge, (point.x - half_way) / point.x);
    Shape::capsule(end, end - DVec2::new(0.0, 100.0 * RADIUS_MM), 0.0)
}

/// The game's light.
fn by_chord(lamp: &Lamp, wall: Option<Shape>, point: DVec2) -> f64 {
    let floor = scenes::white(1, 1);
    let mut scene: Scene = scenes::white_view(&floor, 1.0);
    scene.lamps.push(*lamp);
    scene.occluders.extend(wall.map(|wall| Occluder::opaque(ItemId(2), wall, Group(1))));
    f64::from(scalar::irradiance(&scene, point, None)[0])
}

/// The lamp as light transport has it: radiance 1 / (4 pi a) from every point of its rim, weighed by the way from there.
fn by_angle(lamp: &Lamp, wall: Option<Shape>, point: DVec2) -> f64 {
    let Emitter::Disc { radius_mm } = lamp.emitter else { return 0.0 };
    let falloff = Falloff::Table { height_mm: lamp.height_mm, reach_mm: lamp.reach_mm };
    let walls: Vec<Body> = wall.iter().map(|wall| Body::of_shape(wall, Material::Absorber)).collect();
    let surfaces = Surfaces::new(&walls, TOLERANCE_MM);
    let away = point.distance(lamp.center_mm);
    let half_angle = libm::asin(radius_mm / away);
    let step = 2.0 * half_angle / DIRECTIONS as f64;
    let light = |number: usize| {
        let angle = (number as f64 + 0.5) * step - half_angle;
        let ray = Ray { origin: point, direction: trig::rotate((lamp.center_mm - point) / away, angle) };
        let aside = away * libm::sin(angle);
        let way = away * libm::cos(angle) - (radius_mm * radius_mm - aside * aside).max(0.0).sqrt();
        if surfaces.is_blocked(&ray, &StartsOn::NOTHING, way) { 0.0 } else { falloff.weight(way) }
    };
    (0..DIRECTIONS).map(light).sum::<f64>() * step / (4.0 * PI * radius_mm)
}

fn text(rows: &[Row]) -> String {
    let mut text = format!(
        "A disc lamp's light on the floor, of that of a point of light: by its chord, by its angle, apart.\n\
         {:>8}  {:^24}  {:^24}  {:^24}\n",
        "distance", "in the open", "a quarter hidden", "three quarters hidden"
    );
    for Row { distance_radii, chord, angle } in rows {
        text += &format!("{distance_radii:>6.2} a");
        for (chord, angle) in chord.iter().zip(angle) {
            text += &format!("  {chord:>7.4} {angle:>7.4} {:>+6.2} %", 100.0 * (angle - chord));
        }
        text.push('\n');
    }
    text
}
