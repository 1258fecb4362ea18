//! Lamps of a scene: their form, spectrum, power and how their light fades.

use super::attributes::Attributes;
use super::material::linear;
use geometry::trig;
use pinball::table::{DrawnLine, DrawnOutline, DrawnPiece, DrawnShape};
use tracer::transport::spectrum::{Emission, Gas, LONGEST_NM, SHORTEST_NM};
use tracer::transport::{Falloff, LightSource, SourceForm};

/// A lamp's height over a table and how far it reaches, mm, where nothing is said: those of a table's lamps.
const TABLE: [f64; 2] = [30.0, 260.0];

/// The light source that a shape draws.
pub fn source(shape: &DrawnShape, attributes: &Attributes) -> Result<LightSource, String> {
    let power = attributes.number("power", 0.0..=1e6)?.unwrap_or(1.0);
    let form = form(shape, attributes)?;
    Ok(LightSource { form, emission: emission(shape, attributes)?, power, falloff: falloff(attributes)? })
}

fn form(shape: &DrawnShape, attributes: &Attributes) -> Result<SourceForm, String> {
    let beam = attributes.number("beam-deg", 0.0..=360.0)?;
    let towards = attributes.number("towards-deg", -360.0..=360.0)?;
    match &shape.outline {
        DrawnOutline::Circle(circle) => {
            let center = circle.center;
            match (beam, towards) {
                (None, None) => Ok(SourceForm::Disc { center, radius: circle.radius }),
                (None, Some(_)) => Err("`data-towards-deg` needs `data-beam-deg`, how wide its light is".to_string()),
                (Some(360.0), None) => Ok(SourceForm::Point(center)),
                (Some(_), None) => {
                    Err("`data-beam-deg` of a circle needs `data-towards-deg`, where its light goes".to_string())
                }
                (Some(0.0), Some(_)) => {
                    Err("a circle has no parallel light; draw the lamp as a line with data-beam-deg=\"0\"".to_string())
                }
                (Some(beam), Some(towards)) => {
                    let axis = trig::direction(towards.to_radians());
                    Ok(SourceForm::Cone { center, axis, half_angle: 0.5 * beam.to_radians() })
                }
            }
        }
        DrawnOutline::Lines(lines) => {
            if towards.is_some() {
                return Err("`data-towards-deg` is for lamps that are circles: a line shines to its left, as one goes from its \
                            first point to its second"
                    .to_string());
            }
            let [DrawnLine { pieces, .. }] = lines.as_slice() else { return Err(EXPECTED.to_string()) };
            let [DrawnPiece::Line(line)] = pieces.as_slice() else { return Err(EXPECTED.to_string()) };
            let (line, beam) = (*line, beam.map(f64::to_radians));
            match beam {
                None => Ok(SourceForm::Tube(line)),
                Some(beam) if beam <= std::f64::consts::PI => {
                    // On the page y points down: to the left of a way is to the right of it with y up.
                    let line = geometry::Segment { a: line.b, b: line.a };
                    Ok(SourceForm::Beam { line, half_angle: 0.5 * beam })
                }
                Some(_) => Err("`data-beam-deg` of a line is at most 180: it shines to one side".to_string()),
            }
        }
    }
}

const EXPECTED: &str = "a lamp is a circle or one straight line";

fn emission(shape: &DrawnShape, attributes: &Attributes) -> Result<Emission, String> {
    let Some(text) = attributes.text("spectrum") else {
        let painted = if shape.is_filled && shape.fill.is_some() { shape.fill } else { shape.stroke };
        let painted = match &shape.outline {
            // A line has no inside, whatever SVG says of its fill.
            DrawnOutline::Lines(_) => shape.stroke.or(painted),
            DrawnOutline::Circle(_) => painted,
        };
        let color = painted.ok_or("its colour is that of its light, so it must be a plain colour")?;
        return match linear(color) {
            [0.0, 0.0, 0.0] => {
                Err("it is black, so it has no light; give it a colour or a `data-spectrum`".to_string())
            }
            color => Ok(Emission::Color(color)),
        };
    };
    let in_unit = |unit: &str| text.strip_suffix(unit).and_then(|number| number.trim().parse::<f64>().ok());
    if text == "equal-energy" {
        Ok(Emission::EqualEnergy)
    } else if let Some((_, gas)) = Gas::NAMED.iter().find(|(name, _)| *name == text) {
        Ok(Emission::Gas(*gas))
    } else if let Some(nm) = in_unit("nm").filter(|nm| (SHORTEST_NM..=LONGEST_NM).contains(nm)) {
        Ok(Emission::Line(nm))
    } else if let Some(kelvin) = in_unit("K").filter(|kelvin| (500.0..=100_000.0).contains(kelvin)) {
        Ok(Emission::Blackbody { kelvin })
    } else {
        let gases: Vec<&str> = Gas::NAMED.iter().map(|(name, _)| *name).collect();
        Err(format!(
            "its `data-spectrum` is `{text}`; write `equal-energy`, a temperature as `5600K` (500K to 100000K), a wavelength \
             as `532nm` ({SHORTEST_NM}nm to {LONGEST_NM}nm), or a gas: {}",
            gases.join(", ")
        ))
    }
}

fn falloff(attributes: &Attributes) -> Result<Falloff, String> {
    let height = attributes.number("height-mm", 0.1..=1000.0)?;
    let reach = attributes.number("reach-mm", 10.0..=10_000.0)?;
    match attributes.text("falloff") {
        Some("table") => {
            Ok(Falloff::Table { height_mm: height.unwrap_or(TABLE[0]), reach_mm: reach.unwrap_or(TABLE[1]) })
        }
        None | Some("plane") if height.or(reach).is_some() => {
            Err("`data-height-mm` and `data-reach-mm` are for data-falloff=\"table\"".to_string())
        }
        None | Some("plane") => Ok(Falloff::Plane),
        Some(text) => Err(format!("its `data-falloff` is `{text}`; write `plane` or `table`")),
    }
}
