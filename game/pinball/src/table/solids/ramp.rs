//! How ramps and wire-forms look: a floor of plastic between two sides, or two wires on hoops.
//!
//! They hang above the lamps, so they cast no shadows.

use super::finish;
use crate::table::config::Config;
use crate::table::svg::element::Element;
use crate::table::svg::element_class::ElementClass;
use crate::table::{Finish, Profile, Solid};
use geometry::{DVec2, Shape};
use physics::{Leg, PartId, Ramp};

/// Half the thickness of a ramp's sides and of a wire, mm.
const SIDE_MM: f64 = 1.1;
const WIRE_MM: f64 = 1.5;
/// From one hoop of a wire-form to the next, mm.
const HOOPS_MM: f64 = 48.0;
/// From one corner of a floor's rounded edge to the next, m.
const STEP_M: f64 = 0.004;
const MM_PER_M: f64 = 1000.0;

/// What a way above the playfield is drawn with, the lowest first.
///
/// # Errors
/// If the drawing asks for a finish that the numbers do not have.
pub(in crate::table) fn ramp_solids(
    element: &Element,
    id: PartId,
    ramp: &Ramp,
    group: u16,
    config: &Config,
) -> Result<Vec<Solid>, String> {
    let finish = finish(element, config)?;
    let part = Some(id);
    let solid = |shapes_mm, plastic_mm, finish| Solid { part, group, shapes_mm, plastic_mm, shadow: false, finish };
    let half = ramp.half_width_m;
    if element.class == ElementClass::WireForm {
        let mut wires: Vec<Shape> = hoops(ramp);
        wires.extend(sides(ramp, half, WIRE_MM));
        return Ok(vec![solid(wires, None, finish)]);
    }
    let edge = Finish { profile: Profile::Dome, opacity: 1.0, translucency: 0.5 * finish.translucency, ..finish };
    let sides = sides(ramp, half + SIDE_MM / MM_PER_M, SIDE_MM);
    Ok(vec![solid(Vec::new(), Some(floor(ramp)), finish), solid(sides, None, edge)])
}

fn sides(ramp: &Ramp, offset_m: f64, radius_mm: f64) -> Vec<Shape> {
    let beside = |leg: &Leg| [-offset_m, offset_m].map(|offset| leg.offset(offset));
    let shape = |core| Shape { core, radius: radius_mm / MM_PER_M }.scaled(MM_PER_M);
    ramp.path.iter().flat_map(beside).map(shape).collect()
}

fn hoops(ramp: &Ramp) -> Vec<Shape> {
    let hoops = |leg: &Leg| {
        let count = (leg.length() * MM_PER_M / HOOPS_MM).ceil().max(1.0);
        let leg = *leg;
        (0..=count as usize).map(move |hoop| {
            let along = leg.length() * hoop as f64 / count;
            let (middle, across) = (leg.at(along), leg.direction_at(along).perp() * ramp.half_width_m);
            Shape::capsule((middle - across) * MM_PER_M, (middle + across) * MM_PER_M, 0.7 * WIRE_MM)
        })
    };
    ramp.path.iter().flat_map(hoops).collect()
}

/// The outline of a ramp's floor, mm.
fn floor(ramp: &Ramp) -> Vec<DVec2> {
    let edge = |offset: f64| {
        let corners = move |leg: &Leg| {
            let leg = *leg;
            let steps = if matches!(leg, Leg::Line(_)) { 1 } else { (leg.length() / STEP_M).ceil().max(1.0) as usize };
            (0..=steps).map(move |step| {
                let along = leg.length() * step as f64 / steps as f64;
                (leg.at(along) + leg.direction_at(along).perp() * offset) * MM_PER_M
            })
        };
        ramp.path.iter().flat_map(corners).collect::<Vec<DVec2>>()
    };
    let mut outline = edge(-ramp.half_width_m);
    outline.extend(edge(ramp.half_width_m).into_iter().rev());
    outline.dedup_by(|a, b| a.distance(*b) < 1e-6);
    outline
}
