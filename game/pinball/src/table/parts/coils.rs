//! Coils: what the rules move by coils: kickbacks and diverters.

use super::{M_PER_MM, data};
use crate::table::svg::element::Element;
use geometry::{Circle, Segment, trig};
use physics::{FlipperControl, Material};

/// Thinnest arm of a diverter, mm: a sheet of steel.
const THIN_MM: f64 = 1.0;

/// A kickback's rod: its line goes from the tip at rest to where the tip is when it is fully out.
pub(super) fn kickback(element: &Element, line: Segment, number: impl Fn(&'static str) -> f64) -> physics::Kickback {
    let stroke_m = line.length();
    physics::Kickback {
        tip: line.a,
        half_width_m: element.radius_mm() * M_PER_MM,
        direction: line.along() / stroke_m,
        stroke_m,
        speed_m_s: number("speed_m_s"),
    }
}

/// A diverter is a flipper with equal ends that only the rules turn.
///
/// # Errors
/// If the drawing does not say how far it turns, or its arm is too thin or too short.
pub(super) fn diverter(
    element: &Element,
    line: Segment,
    material: Material,
    number: impl Fn(&'static str) -> f64,
) -> Result<physics::Flipper, String> {
    let turn_deg = data(element, "turn-deg", -120.0, 120.0)?;
    if turn_deg.abs() < 5.0 {
        return Err(format!("data-turn-deg must be 5 or more either way, and it is {turn_deg}"));
    }
    let (length_m, rest_rad) = (line.length(), trig::angle(line.along()));
    if element.thickness_mm < THIN_MM {
        return Err(format!("its stroke-width must be {THIN_MM} or more, and it is {}", element.thickness_mm));
    }
    let radius = element.radius_mm() * M_PER_MM;
    if length_m <= radius {
        return Err("it is thicker than it is long".to_string());
    }
    // What its coil has to turn is for the most part the coil's own plunger, however long the arm is.
    let inertia_kg_m2 = number("inertia_kg_mm2") * M_PER_MM * M_PER_MM;
    let end = length_m + radius;
    Ok(physics::Flipper {
        base: Circle { center: line.a, radius },
        length_m,
        tip_radius_m: radius,
        rest_rad,
        up_rad: rest_rad + turn_deg.to_radians(),
        control: FlipperControl::Rules,
        material,
        coil_torque_n_m: number("coil_torque_n_m"),
        hold_torque_n_m: number("hold_torque_n_m"),
        spring_torque_n_m: number("spring_torque_n_m"),
        mass_kg: 3.0 * inertia_kg_m2 / (end * end),
    })
}
