//! Solids: what casts shadows and has a top that can be seen.

mod ramp;

pub(super) use ramp::ramp_solids;

use super::config::{Config, FinishOverrides};
use super::svg::element::Element;
use super::svg::element_class::ElementClass;
use super::svg::outline::Outline;
use super::svg::outline_offset;
use super::svg::path_flattening::Subpath;
use super::{Finish, Profile, Solid, parts};
use geometry::{DVec2, Shape};
use physics::{Kind, Part, PartId};
use std::collections::BTreeMap;

/// Shadow groups: gives each group's name a number, and each element without one a number of its own.
#[derive(Debug, Default)]
pub(super) struct ShadowGroups {
    named: BTreeMap<String, u16>,
    next: u16,
}

impl ShadowGroups {
    /// The number of the element's group.
    pub fn of(&mut self, element: &Element) -> u16 {
        let known = element.group.as_ref().and_then(|name| self.named.get(name));
        if let Some(&group) = known {
            return group;
        }
        let group = self.next;
        self.next += 1;
        if let Some(name) = &element.group {
            self.named.insert(name.clone(), group);
        }
        group
    }
}

/// The draw order of the solids: what stands, then flippers, then plastics and caps.
pub(super) fn draw_order(class: ElementClass) -> u8 {
    match class {
        ElementClass::Flipper => 1,
        ElementClass::Plastic => 2,
        class if class.is_elevated() => 3,
        _ => 0,
    }
}

/// The solid that an element is, if it is one; `part` is the part that it is, if it is one.
pub(super) fn solid(
    element: &Element,
    part: Option<(PartId, &Part)>,
    group: u16,
    config: &Config,
) -> Result<Option<Solid>, String> {
    if !element.class.has_finish() {
        return Ok(None);
    }
    let (shapes_mm, plastic_mm) = match element.class {
        ElementClass::Plastic => plastic(element)?,
        class if class.is_static() => (parts::surfaces_mm(element), filled(element)),
        _ => (part.map(|(_, part)| shapes_mm(part, element)).unwrap_or_default(), None),
    };
    let shadow = config.shadow(element.class, &element.name).unwrap_or(element.class != ElementClass::Plastic);
    let finish = finish(element, config)?;
    Ok(Some(Solid { part: part.map(|(id, _)| id), group, shapes_mm, plastic_mm, shadow, finish }))
}

fn shapes_mm(part: &Part, element: &Element) -> Vec<Shape> {
    let radius = element.radius_mm();
    match (&part.kind, &element.outline) {
        (Kind::Flipper(flipper), _) if element.class == ElementClass::Flipper => vec![parts::flipper_mm(flipper)],
        (_, Outline::Circle(circle)) => vec![Shape::disc(circle.center, circle.radius)],
        (_, Outline::Subpaths(subpaths)) => {
            subpaths.iter().flat_map(|subpath| &subpath.pieces).map(|piece| piece.shape(radius)).collect()
        }
    }
}

/// The top of a standing element that is painted inside: all of it, out to where the ball meets it.
fn filled(element: &Element) -> Option<Vec<DVec2>> {
    match &element.outline {
        Outline::Subpaths(subpaths) if element.fill.is_painted() => match subpaths.as_slice() {
            [Subpath { closed: true, polygon, .. }] => Some(outline_offset::offset(polygon, element.radius_mm())),
            _ => None,
        },
        _ => None,
    }
}

fn plastic(element: &Element) -> Result<(Vec<Shape>, Option<Vec<DVec2>>), String> {
    match &element.outline {
        Outline::Circle(circle) => Ok((vec![Shape::disc(circle.center, circle.radius)], None)),
        Outline::Subpaths(subpaths) => match subpaths.as_slice() {
            [Subpath { closed: true, polygon, pieces }] if polygon.len() > 2 => {
                Ok((pieces.iter().map(|piece| piece.shape(0.0)).collect(), Some(polygon.clone())))
            }
            _ => Err("a plastic is drawn as a circle or as one closed outline".to_string()),
        },
    }
}

/// How an element looks: what its finish says, else its class's usual form, in the colour that it is drawn in.
///
/// # Errors
/// If the drawing asks for a finish that the numbers do not have.
fn finish(element: &Element, config: &Config) -> Result<Finish, String> {
    let words = match element.data.get("finish") {
        Some(name) => config.finish_named(name)?.clone(),
        None => config.finish(element.class, &element.name).cloned().unwrap_or_default(),
    };
    let FinishOverrides { albedo, gloss, profile, opacity, translucency, emission, emission_power } = words;
    let (usual_profile, usual_gloss) = default_look(element.class);
    let art = element.class == ElementClass::Plastic;
    // A plastic's colours are in its art, which the albedo multiplies.
    let drawn = if art { Some([255; 3]) } else { element.color() };
    Ok(Finish {
        albedo: albedo.or(drawn).unwrap_or([160; 3]),
        profile: profile.unwrap_or(usual_profile),
        gloss: gloss.unwrap_or(usual_gloss),
        art,
        emission: emission.unwrap_or_default(),
        emission_power: emission_power.unwrap_or(1.0),
        opacity: opacity.unwrap_or(1.0),
        translucency: translucency.unwrap_or(0.0),
    })
}

fn default_look(class: ElementClass) -> (Profile, f32) {
    match class {
        ElementClass::Ramp => (Profile::Bevel(1.0), 0.6),
        ElementClass::WireForm => (Profile::Dome, 0.9),
        ElementClass::Wall => (Profile::Bevel(1.0), 0.15),
        ElementClass::Guide | ElementClass::Diverter => (Profile::Bevel(0.6), 0.7),
        ElementClass::Rubber | ElementClass::Slingshot => (Profile::Dome, 0.15),
        ElementClass::Post | ElementClass::Peg => (Profile::Dome, 0.4),
        ElementClass::Bumper => (Profile::Bevel(3.0), 0.3),
        ElementClass::Flipper => (Profile::Bevel(2.5), 0.35),
        ElementClass::Gate | ElementClass::Spinner => (Profile::Dome, 0.6),
        ElementClass::Plastic => (Profile::Bevel(1.2), 0.5),
        _ => (Profile::Bevel(0.8), 0.3),
    }
}
