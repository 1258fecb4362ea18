//! What casts shadows and has a top that can be seen.

mod above;

pub(super) use above::above;

use super::class::Class;
use super::drawing::Thing;
use super::numbers::{FinishWords, Numbers};
use super::outline::Outline;
use super::pen::Run;
use super::{Finish, Profile, Solid, parts, rim};
use geometry::{DVec2, Shape};
use physics::{Kind, Part, PartId};
use std::collections::BTreeMap;

/// Gives each name a number, and each thing without one a number of its own.
#[derive(Debug, Default)]
pub(super) struct Groups {
    named: BTreeMap<String, u16>,
    next: u16,
}

impl Groups {
    /// The number of the thing's group.
    pub fn of(&mut self, thing: &Thing) -> u16 {
        let known = thing.group.as_ref().and_then(|name| self.named.get(name));
        if let Some(&group) = known {
            return group;
        }
        let group = self.next;
        self.next += 1;
        if let Some(name) = &thing.group {
            self.named.insert(name.clone(), group);
        }
        group
    }
}

/// The heights of the solids: what stands, then flippers, then plastics and caps.
pub(super) fn height(class: Class) -> u8 {
    match class {
        Class::Flipper => 1,
        Class::Plastic => 2,
        class if class.is_above() => 3,
        _ => 0,
    }
}

/// The solid that a thing is, if it is one; `part` is the part that it is, if it is one.
pub(super) fn solid(
    thing: &Thing,
    part: Option<(PartId, &Part)>,
    group: u16,
    numbers: &Numbers,
) -> Result<Option<Solid>, String> {
    if !thing.class.has_finish() {
        return Ok(None);
    }
    let (shapes_mm, plastic_mm) = match thing.class {
        Class::Plastic => plastic(thing)?,
        class if class.stands() => (parts::surfaces_mm(thing), filled(thing)),
        _ => (part.map(|(_, part)| shapes_mm(part, thing)).unwrap_or_default(), None),
    };
    let shadow = numbers.shadow(thing.class, &thing.name).unwrap_or(thing.class != Class::Plastic);
    let finish = finish(thing, numbers)?;
    Ok(Some(Solid { part: part.map(|(id, _)| id), group, shapes_mm, plastic_mm, shadow, finish }))
}

fn shapes_mm(part: &Part, thing: &Thing) -> Vec<Shape> {
    let radius = thing.radius_mm();
    match (&part.kind, &thing.outline) {
        (Kind::Flipper(flipper), _) if thing.class == Class::Flipper => vec![parts::flipper_mm(flipper)],
        (_, Outline::Circle(circle)) => vec![Shape::disc(circle.center, circle.radius)],
        (_, Outline::Runs(runs)) => runs.iter().flat_map(|run| &run.pieces).map(|piece| piece.shape(radius)).collect(),
    }
}

/// The top of a standing thing that is painted inside: all of it, out to where the ball meets it.
fn filled(thing: &Thing) -> Option<Vec<DVec2>> {
    match &thing.outline {
        Outline::Runs(runs) if thing.fill.is_painted() => match runs.as_slice() {
            [Run { closed: true, polygon, .. }] => Some(rim::grown(polygon, thing.radius_mm())),
            _ => None,
        },
        _ => None,
    }
}

fn plastic(thing: &Thing) -> Result<(Vec<Shape>, Option<Vec<DVec2>>), String> {
    match &thing.outline {
        Outline::Circle(circle) => Ok((vec![Shape::disc(circle.center, circle.radius)], None)),
        Outline::Runs(runs) => match runs.as_slice() {
            [Run { closed: true, polygon, pieces }] if polygon.len() > 2 => {
                Ok((pieces.iter().map(|piece| piece.shape(0.0)).collect(), Some(polygon.clone())))
            }
            _ => Err("a plastic is drawn as a circle or as one closed outline".to_string()),
        },
    }
}

/// How a thing looks: what its finish says, else its class's usual form, in the colour that it is drawn in.
///
/// # Errors
/// If the drawing asks for a finish that the numbers do not have.
fn finish(thing: &Thing, numbers: &Numbers) -> Result<Finish, String> {
    let words = match thing.data.get("finish") {
        Some(name) => numbers.finish_named(name)?.clone(),
        None => numbers.finish(thing.class, &thing.name).cloned().unwrap_or_default(),
    };
    let FinishWords { albedo, gloss, profile, opacity, translucency, emission, emission_power } = words;
    let (usual_profile, usual_gloss) = usual(thing.class);
    let art = thing.class == Class::Plastic;
    // A plastic's colours are in its art, which the albedo multiplies.
    let drawn = if art { Some([255; 3]) } else { thing.color() };
    let power = emission_power.unwrap_or(1.0);
    Ok(Finish {
        albedo: linear(albedo.or(drawn).unwrap_or([160; 3])),
        profile: profile.unwrap_or(usual_profile),
        gloss: gloss.unwrap_or(usual_gloss),
        art,
        emission: emission.map_or([0.0; 3], |color| linear(color).map(|light| light * power)),
        opacity: opacity.unwrap_or(1.0),
        translucency: translucency.unwrap_or(0.0),
    })
}

fn usual(class: Class) -> (Profile, f32) {
    match class {
        Class::Ramp => (Profile::Bevel(1.0), 0.6),
        Class::WireForm => (Profile::Dome, 0.9),
        Class::Wall => (Profile::Bevel(1.0), 0.15),
        Class::Guide | Class::Diverter => (Profile::Bevel(0.6), 0.7),
        Class::Rubber | Class::Slingshot => (Profile::Dome, 0.15),
        Class::Post | Class::Peg => (Profile::Dome, 0.4),
        Class::Bumper => (Profile::Bevel(3.0), 0.3),
        Class::Flipper => (Profile::Bevel(2.5), 0.35),
        Class::Gate | Class::Spinner => (Profile::Dome, 0.6),
        Class::Plastic => (Profile::Bevel(1.2), 0.5),
        _ => (Profile::Bevel(0.8), 0.3),
    }
}

/// Linear light from an sRGB colour (IEC 61966-2-1).
pub(super) fn linear(color: [u8; 3]) -> [f32; 3] {
    color.map(|channel| {
        let value = f32::from(channel) / 255.0;
        if value <= 0.04045 { value / 12.92 } else { libm::powf((value + 0.055) / 1.055, 2.4) }
    })
}
