//! Objects of a scene: each type by name, as a source, a body or a detector.

use super::detector::Detector;
use super::fields::{Fields, point};
use super::sources::Source;
use geometry::{DVec2, Ray, Segment, Shape};
use serde_json::Value;
use tracer::transport::spectrum::Dispersion;
use tracer::transport::{Band, Body, Corner, Curve, Dielectric, Edge, Material, Parabola, arc_through};

/// What an object is.
pub enum Object {
    /// Light, its brightness and its wavelength, nm.
    Source(Source, f64, f64),
    Bodies(Vec<Body>),
    Detector(Detector),
    /// It changes nothing: a label, a ruler.
    Decoration,
}

/// The types that change nothing.
const DECORATIONS: [&str; 6] = ["Ruler", "Protractor", "LineArrow", "TextLabel", "Drawing", "PointLabel"];

/// Corners of all outlines together at most: whether two edges of one cross is asked of each pair.
pub const MOST_CORNERS: usize = 20_000;

/// How a half plane's edge is drawn: a line this long, in units.
const ENDLESS: f64 = 1e7;

/// Reads an object; `colors` says that wavelengths act.
///
/// # Errors
/// What is wrong with it.
pub fn read(kind: &str, fields: &Fields, colors: bool) -> Result<Object, String> {
    match kind {
        "SingleRay" | "PointSource" | "AngleSource" | "Beam" => source(kind, fields),
        "Glass" | "SphericalLens" | "CircleGlass" | "PlaneGlass" => glass_body(kind, fields, colors),
        "Detector" => {
            let line = line(fields)?;
            let bin = fields.number("binSize", 1.0)?;
            let has_map = fields.flag("irradMap", false)?;
            if has_map && bin <= 0.0 {
                return Err("\"binSize\" must be over 0".to_string());
            }
            let two_sided = fields.flag("twoSided", true)?;
            Ok(Object::Detector(Detector { line, two_sided, bin: has_map.then_some(bin) }))
        }
        _ if DECORATIONS.contains(&kind) => Ok(Object::Decoration),
        _ => surface(kind, fields, colors),
    }
}

/// A source of light.
fn source(kind: &str, fields: &Fields) -> Result<Object, String> {
    let wavelength = || fields.number("wavelength", 540.0);
    let brightness = |default: f64| {
        let brightness = fields.number("brightness", default)?;
        if brightness > 0.0 { Ok(brightness) } else { Err("\"brightness\" must be over 0".to_string()) }
    };
    match kind {
        "SingleRay" => {
            let Segment { a, b } = line(fields)?;
            let ray = Ray::towards(a, b).ok_or("the points \"p1\" and \"p2\" must differ")?;
            Ok(Object::Source(Source::Single { ray }, brightness(1.0)?, wavelength()?))
        }
        "PointSource" => {
            let center = DVec2::new(fields.number("x", f64::NAN)?, fields.number("y", f64::NAN)?);
            if !center.is_finite() {
                return Err("\"x\" and \"y\" are missing".to_string());
            }
            Ok(Object::Source(Source::Point { center }, brightness(0.5)?, wavelength()?))
        }
        "AngleSource" => {
            let Segment { a: center, b: towards } = line(fields)?;
            let angle = angle(fields, "emisAngle", 36.001)?;
            let symmetric = fields.flag("symmetric", true)?;
            Ok(Object::Source(Source::Angle { center, towards, angle, symmetric }, brightness(0.5)?, wavelength()?))
        }
        _ => {
            let Segment { a: from, b: to } = line(fields)?;
            if fields.flag("random", false)? {
                return Err("\"random\" rays cannot be the same here: only beams with a fixed list of rays are read"
                    .to_string());
            }
            let (angle, lambert) = (angle(fields, "emisAngle", 0.0)?, fields.flag("lambert", false)?);
            Ok(Object::Source(Source::Beam { from, to, angle, lambert }, brightness(0.5)?, wavelength()?))
        }
    }
}

/// A body of glass.
fn glass_body(kind: &str, fields: &Fields, colors: bool) -> Result<Object, String> {
    match kind {
        "Glass" | "SphericalLens" => {
            let body = Body::closed(&path(fields)?, glass(fields, colors)?);
            let body =
                body.ok_or("the outline \"path\" must hold an area, and no two arc points may follow each other")?;
            if crosses_itself(&body) {
                return Err("the outline \"path\" crosses itself".to_string());
            }
            Ok(Object::Bodies(vec![body]))
        }
        "CircleGlass" => Ok(Object::Bodies(vec![Body::of_shape(&disc(fields)?, glass(fields, colors)?)])),
        _ => {
            let Segment { a, b } = line(fields)?;
            let along = (b - a).normalize() * ENDLESS;
            let curve = Curve::Line(Segment { a: a - along, b: a + along });
            // A ray to the right of the line's way (y up) leaves the glass.
            let edges = vec![Edge { curve, inward: true }];
            Ok(Object::Bodies(vec![Body { edges, material: glass(fields, colors)?, band: None }]))
        }
    }
}

/// A surface without an inside: mirrors, lenses, splitters, blockers.
fn surface(kind: &str, fields: &Fields, colors: bool) -> Result<Object, String> {
    let body = |curve: Curve, material: Material| -> Result<Object, String> {
        Ok(Object::Bodies(vec![filtered(Body::open([curve], material), fields, colors)?]))
    };
    match kind {
        "Mirror" => body(Curve::Line(line(fields)?), Material::MIRROR),
        "ArcMirror" => {
            let Segment { a, b } = line(fields)?;
            let arc = arc_through(a, fields.point("p3")?, b).map(|(arc, _)| Curve::Arc(arc));
            body(arc.unwrap_or(Curve::Line(Segment { a, b })), Material::MIRROR)
        }
        "ParabolicMirror" => {
            let Segment { a, b } = line(fields)?;
            body(Curve::Parabola(parabola(a, b, fields.point("p3")?)?), Material::MIRROR)
        }
        "IdealLens" | "IdealMirror" => {
            let focal_length = fields.number("focalLength", 100.0)?;
            if focal_length == 0.0 {
                return Err("\"focalLength\" must not be 0".to_string());
            }
            let lens = Material::IdealLens { focal_length };
            let material = if kind == "IdealLens" { lens } else { Material::IdealMirror { focal_length } };
            body(Curve::Line(line(fields)?), material)
        }
        "BeamSplitter" => {
            let transmittance = fields.number("transRatio", 0.5)?;
            if !(0.0..=1.0).contains(&transmittance) {
                return Err("\"transRatio\" must be from 0 to 1".to_string());
            }
            body(Curve::Line(line(fields)?), Material::BeamSplitter { transmittance })
        }
        "Blocker" => body(Curve::Line(line(fields)?), Material::Absorber),
        "CircleBlocker" => {
            let disc = Body::of_shape(&disc(fields)?, Material::Absorber);
            Ok(Object::Bodies(vec![filtered(disc, fields, colors)?]))
        }
        "Aperture" => {
            let [a, b, c, d] = ["p1", "p2", "p3", "p4"].map(|name| fields.point(name));
            let lines = [Segment { a: a?, b: c? }, Segment { a: b?, b: d? }].map(Curve::Line);
            Ok(Object::Bodies(vec![filtered(Body::open(lines, Material::Absorber), fields, colors)?]))
        }
        _ => Err("objects of this type are not read".to_string()),
    }
}

fn line(fields: &Fields) -> Result<Segment, String> {
    let line = Segment { a: fields.point("p1")?, b: fields.point("p2")? };
    if line.length() > 0.0 { Ok(line) } else { Err("the points \"p1\" and \"p2\" must differ".to_string()) }
}

fn disc(fields: &Fields) -> Result<Shape, String> {
    let Segment { a, b } = line(fields)?;
    Ok(Shape::disc(a, a.distance(b)))
}

fn angle(fields: &Fields, name: &'static str, default: f64) -> Result<f64, String> {
    let degrees = fields.number(name, default)?;
    if (0.0..=360.0).contains(&degrees) {
        Ok(degrees.to_radians())
    } else {
        Err(format!("\"{name}\" must be from 0 to 360 degrees"))
    }
}

/// A body that acts on some wavelengths, if the scene has wavelengths and the object a filter.
fn filtered(body: Body, fields: &Fields, colors: bool) -> Result<Body, String> {
    let filter = fields.flag("filter", false)?;
    let inverted = fields.flag("invert", false)?;
    let (middle_nm, half_nm) = (fields.number("wavelength", 540.0)?, fields.number("bandwidth", 10.0)?);
    Ok(if filter && colors { body.in_band(Band { middle_nm, half_nm, inverted }) } else { body })
}

/// The material of a glass.
fn glass(fields: &Fields, colors: bool) -> Result<Material, String> {
    let index = fields.number("refIndex", 1.5)?;
    let cauchy = fields.number("cauchyB", 0.004)?;
    if index <= 0.0 {
        return Err("\"refIndex\" must be over 0".to_string());
    }
    let dispersion = if colors { Dispersion::Cauchy { a: index, b: cauchy } } else { Dispersion::Constant(index) };
    let reflects = fields.flag("partialReflect", true)?;
    Ok(Material::Dielectric(Dielectric { reflects, ..Dielectric::clear(dispersion) }))
}

fn path(fields: &Fields) -> Result<Vec<Corner>, String> {
    let corner = |value: &Value| {
        let place = point(value)?;
        let is_arc = value.get("arc").and_then(Value::as_bool).unwrap_or(false);
        Some(if is_arc { Corner::Through(place) } else { Corner::Point(place) })
    };
    let corners: Option<Vec<Corner>> = fields.list("path")?.iter().map(corner).collect();
    corners
        .ok_or_else(|| "\"path\" must be a list of points {\"x\": .., \"y\": .., \"arc\": true or false}".to_string())
}

/// Whether two edges of an outline cross each other, other than at a common corner.
fn crosses_itself(body: &Body) -> bool {
    let lines: Vec<Segment> = body
        .edges
        .iter()
        .filter_map(|edge| match edge.curve {
            Curve::Line(line) => Some(line),
            _ => None,
        })
        .collect();
    let crosses = |one: &Segment, other: &Segment| {
        let side = |line: &Segment, point: DVec2| line.along().perp_dot(point - line.a);
        side(one, other.a) * side(one, other.b) < 0.0 && side(other, one.a) * side(other, one.b) < 0.0
    };
    lines.iter().enumerate().any(|(at, one)| lines[at + 1..].iter().any(|other| crosses(one, other)))
}

/// `y = a x^2` from its vertex, x along the way from one end to the other, through the first end.
fn parabola(a: DVec2, b: DVec2, vertex: DVec2) -> Result<Parabola, String> {
    let axis = (b - a).normalize();
    let end = DVec2::new((a - vertex).dot(axis), (a - vertex).dot(axis.perp()));
    if end.x == 0.0 {
        return Err("the vertex \"p3\" must not lie straight below \"p1\"".to_string());
    }
    Ok(Parabola { vertex, axis, curvature: end.y / (end.x * end.x), half: 0.5 * a.distance(b) })
}
