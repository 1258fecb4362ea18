//! Parts: what the ball can meet: elements and numbers become [`physics::Part`]s, in SI units.

mod coils;
mod ramp;

use super::config::Config;
use super::svg::element::Element;
use super::svg::element_class::ElementClass;
use super::svg::outline::Outline;
use geometry::{Circle, Core, DVec2, Segment, Shape, trig};
use physics::{FlipperControl, Kind, Material};
use std::f64::consts::TAU;

/// Metres in a millimetre.
const M_PER_MM: f64 = 0.001;
/// How far from a ball's radius a captive ball may be drawn, mm.
const BALL_SLACK_MM: f64 = 0.5;
/// The smallest hole, and the shortest reach of a magnet, mm: half of a ball's radius.
const LEAST_HOLE_MM: f64 = 6.75;
const LEAST_REACH_MM: f64 = 6.75;
/// What a drawing's rounded numbers may lack, mm.
const ROUNDED_MM: f64 = 1e-3;
/// How far above the plunger's tip a new ball is put down, mm.
const FEED_GAP_MM: f64 = 2.0;

/// The part that an element is, or what is wrong with it.
pub(super) fn kind(element: &Element, config: &Config) -> Result<Kind, String> {
    let number = |key| config.number(element.class, &element.name, key);
    let material = material(element, config);
    let line = || line(element);
    let circle = || circle(element);
    let capsule = || line().map(|s| Shape::capsule(s.a, s.b, element.radius_mm() * M_PER_MM));
    Ok(match element.class {
        ElementClass::Bumper => Kind::Bumper(physics::Bumper {
            circle: circle()?,
            material,
            kick_m_s: number("kick_m_s"),
            threshold_m_s: number("threshold_m_s"),
        }),
        ElementClass::Slingshot => Kind::Slingshot(physics::Slingshot {
            segment: line()?,
            radius_m: element.radius_mm() * M_PER_MM,
            material,
            kick_m_s: number("kick_m_s"),
            threshold_m_s: number("threshold_m_s"),
        }),
        ElementClass::Flipper => Kind::Flipper(flipper(element, line()?, material, number)?),
        ElementClass::Target => {
            Kind::Target(physics::Target { shape: capsule()?, material, threshold_m_s: number("threshold_m_s") })
        }
        ElementClass::DropTarget => Kind::DropTarget(physics::DropTarget {
            shape: capsule()?,
            material,
            threshold_m_s: number("threshold_m_s"),
        }),
        ElementClass::Rollover => Kind::Rollover(physics::Rollover { shape: zone(element)? }),
        ElementClass::Drain => Kind::Drain(physics::Drain { shape: zone(element)? }),
        ElementClass::Gate => Kind::Gate(physics::Gate { segment: line()?, direction: way(element)?, material }),
        ElementClass::Spinner => {
            Kind::Spinner(physics::Spinner { segment: line()?, damping_per_s: number("damping_per_s") })
        }
        ElementClass::Saucer => Kind::Saucer(physics::Saucer {
            circle: no_smaller_than(circle()?, LEAST_HOLE_MM, "a hole as small as that holds no ball")?,
            capture_m_s: number("capture_m_s"),
            eject_m_s: trig::direction(degrees(element, "eject-deg")?) * data(element, "eject-m-s", 0.2, 20.0)?,
        }),
        ElementClass::Plunger => Kind::Plunger(plunger(element, line()?, number)),
        ElementClass::Ramp | ElementClass::WireForm => Kind::Ramp(ramp::ramp(element, material)?),
        ElementClass::Kickback => Kind::Kickback(coils::kickback(element, line()?, number)),
        ElementClass::Magnet => Kind::Magnet(physics::Magnet {
            circle: no_smaller_than(circle()?, LEAST_REACH_MM, "it reaches no ball that is beside its middle")?,
            pull_m_s2: number("pull_m_s2"),
        }),
        ElementClass::Diverter => Kind::Flipper(coils::diverter(element, line()?, material, number)?),
        ElementClass::CaptiveBall => Kind::CaptiveBall(captive_ball(circle()?, number("threshold_m_s"))?),
        _ => Kind::Wall(physics::Wall {
            shapes: surfaces_mm(element).into_iter().map(|shape| shape.scaled(M_PER_MM)).collect(),
            material,
        }),
    })
}

/// The surfaces of a standing element, mm: a painted circle is a disc; any other line is as thick as it is drawn.
pub(super) fn surfaces_mm(element: &Element) -> Vec<Shape> {
    let radius = element.radius_mm();
    match &element.outline {
        Outline::Circle(circle) if element.fill.is_painted() => {
            let rim = if element.stroke.is_painted() { radius } else { 0.0 };
            vec![Shape::disc(circle.center, circle.radius + rim)]
        }
        Outline::Circle(circle) => {
            vec![Shape { core: Core::Arc(geometry::Arc::new(*circle, 0.0, TAU)), radius }]
        }
        Outline::Subpaths(subpaths) => {
            subpaths.iter().flat_map(|subpath| &subpath.pieces).map(|piece| piece.shape(radius)).collect()
        }
    }
}

/// A flipper's hull at rest, mm.
pub(super) fn flipper_mm(flipper: &physics::Flipper) -> Shape {
    let tip = flipper.base.center + trig::direction(flipper.rest_rad) * flipper.length_m;
    let b = Circle { center: tip, radius: flipper.tip_radius_m };
    Shape { core: Core::Taper(geometry::Taper { a: flipper.base, b }), radius: 0.0 }.scaled(1.0 / M_PER_MM)
}

fn material(element: &Element, config: &Config) -> Material {
    let usual = match element.class {
        ElementClass::Guide | ElementClass::Diverter => "metal",
        ElementClass::Rubber | ElementClass::Slingshot => "rubber",
        ElementClass::Post | ElementClass::Peg => "post",
        ElementClass::Bumper => "sleeve",
        ElementClass::Flipper => "flipper-rubber",
        ElementClass::Target => "target",
        ElementClass::DropTarget => "drop-target",
        ElementClass::Gate | ElementClass::WireForm => "wire",
        ElementClass::Ramp => "metal",
        _ => "wood",
    };
    let setting = config.material(element.class, &element.name).or_else(|| config.materials.get(usual));
    setting.copied().unwrap_or(Material { restitution: 0.4, falloff_s_per_m: 0.0, friction: 0.25 })
}

fn line(element: &Element) -> Result<Segment, String> {
    let Segment { a, b } = element.outline.line().ok_or_else(|| expected(element, "one straight line"))?;
    Ok(Segment { a: a * M_PER_MM, b: b * M_PER_MM })
}

fn circle(element: &Element) -> Result<Circle, String> {
    let Circle { center, radius } = element.outline.circle().ok_or_else(|| expected(element, "a circle"))?;
    Ok(Circle { center: center * M_PER_MM, radius: radius * M_PER_MM })
}

/// A circle that is large enough for what it is.
fn no_smaller_than(circle: Circle, least_mm: f64, why: &str) -> Result<Circle, String> {
    let radius_mm = circle.radius / M_PER_MM;
    match radius_mm + ROUNDED_MM < least_mm {
        true => {
            Err(format!("its r is {radius_mm:.1} and must be {least_mm} or more: {why}, which has a radius of 13.5"))
        }
        false => Ok(circle),
    }
}

fn expected(element: &Element, what: &str) -> String {
    format!("{} is drawn as {what}", element.class.with_article())
}

/// Where a ball's centre is on a rollover or in a drain: in a circle, or within half the thickness of a line. A
/// rectangle is the capsule down its middle that is as wide.
fn zone(element: &Element) -> Result<Shape, String> {
    let shape = match &element.outline {
        Outline::Circle(circle) => Shape::disc(circle.center, circle.radius),
        Outline::Subpaths(_) => match element.outline.line() {
            Some(segment) if element.thickness_mm > 0.0 => Shape::capsule(segment.a, segment.b, element.radius_mm()),
            Some(_) => return Err("its line has no thickness, so no ball is ever within it".to_string()),
            None => middle_of_rect(element)?,
        },
    };
    Ok(shape.scaled(M_PER_MM))
}

fn middle_of_rect(element: &Element) -> Result<Shape, String> {
    let polygons = element.outline.polygons().unwrap_or_default();
    let [[a, b, c, d]] =
        polygons.iter().flat_map(|polygon| <[DVec2; 4]>::try_from(polygon.clone())).collect::<Vec<_>>()[..]
    else {
        return Err(expected(element, "one straight line, a circle or a rectangle"));
    };
    let (across, down) = (b - a, d - a);
    let slack = 1e-6 * (across.length_squared() + down.length_squared());
    if (a + c - b - d).length_squared() > slack || across.dot(down).abs() > slack {
        return Err(expected(element, "one straight line, a circle or a rectangle"));
    }
    let (long, short) = if across.length() >= down.length() { (across, down) } else { (down, across) };
    let start = a + short * 0.5;
    let inset = long.normalize() * (short.length() * 0.5);
    Ok(Shape::capsule(start + inset, start + long - inset, short.length() * 0.5))
}

fn flipper(
    element: &Element,
    line: Segment,
    material: Material,
    number: impl Fn(&'static str) -> f64,
) -> Result<physics::Flipper, String> {
    let control = match element.data.get("side").map(String::as_str) {
        Some("left") => FlipperControl::Left,
        Some("right") => FlipperControl::Right,
        _ => return Err("a flipper needs data-side=\"left\" or data-side=\"right\"".to_string()),
    };
    let stroke_deg = data(element, "up-deg", 10.0, 120.0)?;
    let rest_rad = trig::angle(line.along());
    let stroke_rad = stroke_deg.to_radians();
    let length_m = line.length();
    let [base, tip] = [number("base_radius_mm"), number("tip_radius_mm")].map(|mm| mm * M_PER_MM);
    if length_m + tip <= base {
        return Err("it is shorter than the disc at its pivot is wide".to_string());
    }
    Ok(physics::Flipper {
        base: Circle { center: line.a, radius: base },
        length_m,
        tip_radius_m: tip,
        rest_rad,
        up_rad: if control == FlipperControl::Left { rest_rad - stroke_rad } else { rest_rad + stroke_rad },
        control,
        material,
        coil_torque_n_m: number("coil_torque_n_m"),
        hold_torque_n_m: number("hold_torque_n_m"),
        spring_torque_n_m: number("spring_torque_n_m"),
        mass_kg: number("mass_kg"),
    })
}

fn plunger(element: &Element, line: Segment, number: impl Fn(&'static str) -> f64) -> physics::Plunger {
    let stroke_m = line.length();
    let way = -line.along() / stroke_m;
    physics::Plunger {
        feed: line.a + way * (physics::BALL_RADIUS_M + FEED_GAP_MM * M_PER_MM),
        tip: line.a,
        half_width_m: element.radius_mm() * M_PER_MM,
        direction: way,
        stroke_m,
        pull_s: number("pull_s"),
        full_speed_m_s: number("full_speed_m_s"),
    }
}

/// A captive ball is drawn as large as it is, so that its maker sees whether it has room.
fn captive_ball(circle: Circle, threshold_m_s: f64) -> Result<physics::CaptiveBall, String> {
    let [radius_mm, ball_mm] = [circle.radius, physics::BALL_RADIUS_M].map(|metres| metres / M_PER_MM);
    if (radius_mm - ball_mm).abs() > BALL_SLACK_MM {
        return Err(format!("a captive ball is a pinball, so its r is {ball_mm}, and it is {radius_mm:.1}"));
    }
    Ok(physics::CaptiveBall { center: circle.center, threshold_m_s })
}

/// Straight through the gate, to the side that its drawing names.
fn way(element: &Element) -> Result<DVec2, String> {
    let expected = "a gate needs data-way=\"up\", \"down\", \"left\", \"right\" or degrees: the way that is free";
    let word = element.data.get("way").ok_or(expected)?;
    let way = match word.as_str() {
        "up" => DVec2::NEG_Y,
        "down" => DVec2::Y,
        "left" => DVec2::NEG_X,
        "right" => DVec2::X,
        _ => trig::direction(degrees(element, "way").map_err(|_| expected)?),
    };
    let along = element.outline.line().and_then(|line| line.along().try_normalize()).unwrap_or(DVec2::X);
    if along.dot(way).abs() > 0.99 {
        return Err("its data-way runs along the gate, so no ball can pass it that way".to_string());
    }
    Ok(along.perp() * 1.0_f64.copysign(along.perp_dot(way)))
}

fn degrees(element: &Element, key: &str) -> Result<f64, String> {
    data(element, key, -360.0, 360.0).map(f64::to_radians)
}

fn data(element: &Element, key: &str, min: f64, max: f64) -> Result<f64, String> {
    let expected = || format!("data-{key} must be a number from {min} to {max}");
    let text = element
        .data
        .get(key)
        .ok_or_else(|| format!("{} needs data-{key}; {}", element.class.with_article(), expected()))?;
    let number = text.parse::<f64>().ok().filter(|number| (min..=max).contains(number));
    number.ok_or_else(|| format!("{}, and it is `{text}`", expected()))
}
