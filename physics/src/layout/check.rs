//! Whether a layout's numbers can be at all.

use crate::BALL_RADIUS_M;
use crate::layout::{Kind, Layout, Leg, Material, Part, PartId, Ramp};
use crate::machine::Error;
use geometry::{Arc, Circle, Core, DVec2, Segment, Shape};

/// More of anything than this is a slip of the pen, in SI units.
const MOST: f64 = 1e6;
/// A magnet that pulls harder than this would swing a ball faster than a tick can follow.
const MOST_PULL_M_S2: f64 = 500.0;
/// How deep a captive ball may be drawn into a wall, m: it moves out of it.
const SNUG_M: f64 = 0.2e-3;

pub(crate) fn layout(layout: &Layout) -> Result<(), Error> {
    let fail = |index: usize, text: String| Error::Layout(PartId(index as u16), text);
    if layout.parts.len() > usize::from(u16::MAX) {
        return Err(fail(0, format!("a layout may have {} parts and this has more", u16::MAX)));
    }
    let whole = || {
        point("the playfield's size", layout.size_m)?;
        positive("the playfield's width", layout.size_m.x)?;
        positive("the playfield's height", layout.size_m.y)?;
        at_most("the playfield's size", layout.size_m.max_element(), 10.0)?;
        finite("the slope", layout.slope_rad)?;
        at_most("the slope", layout.slope_rad.abs(), 1.5)?;
        not_negative("the playfield's friction", layout.playfield_friction)
    };
    whole().map_err(|text| fail(0, text))?;
    let parts = layout.parts.iter().enumerate();
    let mut shapes = 0;
    for (index, part) in parts {
        self::part(part).map_err(|text| fail(index, text))?;
        shapes += if let Kind::Wall(wall) = &part.kind { wall.shapes.len() } else { 2 };
        if shapes > usize::from(u16::MAX) {
            return Err(fail(index, format!("a layout may have {} surfaces and this has more", u16::MAX)));
        }
    }
    let mut parts = layout.parts.iter().enumerate();
    parts.try_for_each(|(index, part)| room(layout, part).map_err(|text| fail(index, text)))
}

/// A captive ball must have room where it is drawn.
fn room(layout: &Layout, part: &Part) -> Checked {
    let Kind::CaptiveBall(captive) = &part.kind else { return Ok(()) };
    let depth = |shape: &Shape| BALL_RADIUS_M - shape.distance(captive.center).0;
    for other in &layout.parts {
        let Kind::Wall(wall) = &other.kind else { continue };
        if let Some(deep) = wall.shapes.iter().map(depth).find(|&deep| deep > SNUG_M) {
            return Err(format!("it lies {:.1} mm deep in \"{}\"; a ball must have room", deep * 1000.0, other.name));
        }
    }
    Ok(())
}

type Checked = Result<(), String>;

fn finite(what: &str, number: f64) -> Checked {
    if number.abs() <= MOST { Ok(()) } else { Err(format!("{what} must be a number of reasonable size, not {number}")) }
}

fn positive(what: &str, number: f64) -> Checked {
    finite(what, number)?;
    if number > 0.0 { Ok(()) } else { Err(format!("{what} must be more than 0, not {number}")) }
}

fn not_negative(what: &str, number: f64) -> Checked {
    finite(what, number)?;
    if number >= 0.0 { Ok(()) } else { Err(format!("{what} must be 0 or more, not {number}")) }
}

fn at_most(what: &str, number: f64, most: f64) -> Checked {
    if number <= most { Ok(()) } else { Err(format!("{what} must be {most} or less, not {number}")) }
}

fn point(what: &str, point: DVec2) -> Checked {
    finite(what, point.x)?;
    finite(what, point.y)
}

fn unit(what: &str, vector: DVec2) -> Checked {
    point(what, vector)?;
    if (vector.length() - 1.0).abs() < 1e-6 { Ok(()) } else { Err(format!("{what} must be a vector of length 1")) }
}

fn material(material: &Material) -> Checked {
    not_negative("the restitution", material.restitution)?;
    at_most("the restitution", material.restitution, 1.0)?;
    not_negative("the falloff", material.falloff_s_per_m)?;
    not_negative("the friction", material.friction)
}

fn segment(segment: &Segment) -> Checked {
    point("an end", segment.a)?;
    point("an end", segment.b)?;
    positive("the length", segment.length())
}

fn circle(circle: &Circle) -> Checked {
    point("the centre", circle.center)?;
    positive("the radius", circle.radius)
}

fn arc(arc: &Arc) -> Checked {
    circle(&arc.circle())?;
    finite("the arc's angle", arc.half_angle())?;
    point("the arc's middle", arc.middle())
}

fn shape(shape: &Shape) -> Checked {
    not_negative("the thickness", shape.radius)?;
    match &shape.core {
        Core::Point(center) => point("the centre", *center),
        Core::Segment(ends) => {
            point("an end", ends.a)?;
            point("an end", ends.b)
        }
        Core::Arc(core) => arc(core),
        Core::Taper(taper) => circle(&taper.a).and(circle(&taper.b)),
    }
}

/// How far the end of a leg may be from the start of the next, m.
const GAP_M: f64 = 1e-4;
/// The highest that a floor may be, m.
const HIGHEST_M: f64 = 0.5;

fn ramp(ramp: &Ramp) -> Checked {
    material(&ramp.material)?;
    finite("half the width", ramp.half_width_m)?;
    if ramp.half_width_m <= BALL_RADIUS_M {
        return Err("its sides must be farther apart than a ball is wide".into());
    }
    for leg in &ramp.path {
        match leg {
            Leg::Line(line) => segment(line)?,
            Leg::Turn { arc: turn, .. } => {
                arc(turn)?;
                positive("the angle of a turn", turn.half_angle())?;
                if turn.circle().radius <= ramp.half_width_m + BALL_RADIUS_M {
                    return Err("a turn must be wider than half its width and a ball's radius".into());
                }
            }
        }
    }
    if ramp.path.is_empty() {
        return Err("its way has no length".into());
    }
    if ramp.path.windows(2).any(|pair| pair[0].at(pair[0].length()).distance(pair[1].at(0.0)) > GAP_M) {
        return Err("each leg of its way must begin where the last one ends".into());
    }
    if ramp.heights_m.len() != ramp.path.len() + 1 {
        return Err(format!(
            "its way has {} corners and ends, so it needs as many heights, not {}",
            ramp.path.len() + 1,
            ramp.heights_m.len()
        ));
    }
    for &height in &ramp.heights_m {
        not_negative("a height", height)?;
        at_most("a height", height, HIGHEST_M)?;
    }
    Ok(())
}

fn part(part: &Part) -> Checked {
    match &part.kind {
        Kind::Wall(wall) => {
            wall.shapes.iter().try_for_each(shape)?;
            material(&wall.material)
        }
        Kind::Flipper(f) => {
            circle(&f.base)?;
            positive("the length", f.length_m)?;
            positive("the tip's radius", f.tip_radius_m)?;
            finite("the angle at rest", f.rest_rad)?;
            finite("the angle when up", f.up_rad)?;
            positive("the stroke", (f.up_rad - f.rest_rad).abs())?;
            at_most("the stroke", (f.up_rad - f.rest_rad).abs(), 3.2)?;
            positive("the coil's torque", f.coil_torque_n_m)?;
            positive("the hold torque", f.hold_torque_n_m)?;
            positive("the spring's torque", f.spring_torque_n_m)?;
            positive("the mass", f.mass_kg)?;
            if f.hold_torque_n_m <= f.spring_torque_n_m {
                return Err("the hold torque must be more than the spring's".into());
            }
            material(&f.material)
        }
        Kind::Bumper(b) => {
            circle(&b.circle)?;
            not_negative("the kick", b.kick_m_s)?;
            not_negative("the threshold", b.threshold_m_s)?;
            material(&b.material)
        }
        Kind::Slingshot(s) => {
            segment(&s.segment)?;
            not_negative("the rubber's radius", s.radius_m)?;
            not_negative("the kick", s.kick_m_s)?;
            not_negative("the threshold", s.threshold_m_s)?;
            material(&s.material)
        }
        Kind::Target(t) => {
            shape(&t.shape)?;
            not_negative("the threshold", t.threshold_m_s)?;
            material(&t.material)
        }
        Kind::DropTarget(t) => {
            shape(&t.shape)?;
            not_negative("the threshold", t.threshold_m_s)?;
            material(&t.material)
        }
        Kind::Rollover(r) => shape(&r.shape),
        Kind::Ramp(r) => ramp(r),
        Kind::Gate(g) => {
            segment(&g.segment)?;
            unit("the gate's way", g.direction)?;
            if g.segment.along().dot(g.direction).abs() > 1e-6 {
                return Err("the gate's way must lead straight through it".to_string());
            }
            material(&g.material)
        }
        Kind::Spinner(s) => {
            segment(&s.segment)?;
            not_negative("the damping", s.damping_per_s)
        }
        Kind::Saucer(s) => {
            circle(&s.circle)?;
            not_negative("the capture speed", s.capture_m_s)?;
            point("the ejection", s.eject_m_s)
        }
        Kind::Drain(d) => shape(&d.shape),
        Kind::Plunger(p) => {
            point("the feed", p.feed)?;
            point("the tip", p.tip)?;
            unit("the plunger's way", p.direction)?;
            positive("half the tip's width", p.half_width_m)?;
            positive("the stroke", p.stroke_m)?;
            positive("the time of a pull", p.pull_s)?;
            positive("the full speed", p.full_speed_m_s)
        }
        Kind::Kickback(k) => {
            point("the tip", k.tip)?;
            unit("the kickback's way", k.direction)?;
            positive("half the face's width", k.half_width_m)?;
            positive("the stroke", k.stroke_m)?;
            positive("the speed", k.speed_m_s)
        }
        Kind::Magnet(m) => {
            circle(&m.circle)?;
            not_negative("the pull", m.pull_m_s2)?;
            at_most("the pull", m.pull_m_s2, MOST_PULL_M_S2)
        }
        Kind::CaptiveBall(c) => {
            point("the centre", c.center)?;
            not_negative("the threshold", c.threshold_m_s)
        }
    }
}
