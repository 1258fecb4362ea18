//! Where a solid is in a pose, and how it looks there.

use super::{MM_PER_M, mm, outlines};
use crate::table::Solid;
use geometry::{Arc, Circle, Core, DVec2, Segment, Shape, Taper, trig};
use physics::{Kind, Layout, PartId, Pose};
use tracer::{Finish, Outline};

/// From the axle of a gate or spinner to the edge of its plate, mm: where a ball hits it.
const FLAP_MM: f64 = physics::AXLE_TO_EDGE_M * MM_PER_M;
/// Half the thickness of a gate's or spinner's plate seen on edge, mm.
const FLAP_EDGE_MM: f64 = 0.9;
/// How far a slingshot's arm pushes its rubber out, mm.
const SLING_REACH_MM: f64 = 7.0;
/// How much smaller a bumper's ring looks when it is pulled down.
const RING_PULL: f64 = 0.07;
/// Below this much of its height a drop target's shadow is under the floor.
const SHADOW_ENDS: f64 = 0.08;

/// What moves a solid.
pub enum SolidMotion {
    /// Nothing.
    Still,
    /// It turns with a flipper, round this point, from the angle at which it is drawn.
    Turns { flipper: PartId, pivot_mm: DVec2, drawn_rad: f64 },
    /// It sinks with a drop target.
    Sinks(PartId),
    /// It swings up out of this line, this way.
    Swings { gate: PartId, axle: Segment, way: DVec2 },
    /// It turns round this line.
    Spins { spinner: PartId, axle: Segment },
    /// It is pulled down with a bumper's ring.
    Pulled { bumper: PartId, center_mm: DVec2 },
    /// It is bent by a slingshot's arm.
    Bends { slingshot: PartId, out: DVec2 },
}

/// A solid in its place.
pub struct Placed {
    /// What casts its shadow, mm, each piece with its number among them: the same in every pose.
    pub shadows: Vec<(u32, Shape)>,
    /// What is seen of it, each piece with its number among them.
    pub outlines: Vec<(u32, Outline)>,
    /// How it looks.
    pub finish: Finish,
}

impl SolidMotion {
    /// What moves `solid`; `None` where the scene builder draws the part in its own way.
    pub fn of(layout: &Layout, solid: &Solid) -> Option<SolidMotion> {
        let Some(id) = solid.part else { return Some(SolidMotion::Still) };
        let Some(part) = layout.parts.get(usize::from(id.0)) else { return Some(SolidMotion::Still) };
        Some(match &part.kind {
            Kind::Plunger(_) => return None,
            Kind::Flipper(flipper) => {
                SolidMotion::Turns { flipper: id, pivot_mm: mm(flipper.base.center), drawn_rad: flipper.rest_rad }
            }
            Kind::DropTarget(_) => SolidMotion::Sinks(id),
            Kind::Gate(gate) => SolidMotion::Swings { gate: id, axle: in_mm(gate.segment), way: gate.direction },
            Kind::Spinner(spinner) => SolidMotion::Spins { spinner: id, axle: in_mm(spinner.segment) },
            Kind::Bumper(bumper) => SolidMotion::Pulled { bumper: id, center_mm: mm(bumper.circle.center) },
            Kind::Slingshot(sling) => SolidMotion::Bends { slingshot: id, out: into_play(layout, sling.segment) },
            _ => SolidMotion::Still,
        })
    }

    /// How many pieces of `solid` may cast shadows, and how many may be seen: numbers above those have none.
    pub fn most_pieces(&self, solid: &Solid) -> (u32, u32) {
        let shapes = solid.shapes_mm.len() as u32;
        let drawn = if solid.plastic_mm.is_some() { 1 } else { shapes };
        match self {
            // The plate and the two pins of its axle.
            SolidMotion::Swings { .. } | SolidMotion::Spins { .. } => (1, 3),
            SolidMotion::Bends { .. } if solid.plastic_mm.is_none() => (2 * shapes, 2 * shapes),
            _ => (shapes, drawn),
        }
    }

    /// `solid` in this pose; `finish` is how it looks as it is drawn.
    pub fn place(&self, solid: &Solid, finish: Finish, pose: &Pose) -> Placed {
        match *self {
            SolidMotion::Still => as_drawn(solid, finish),
            SolidMotion::Turns { flipper, pivot_mm, drawn_rad } => match value(&pose.flippers_rad, flipper) {
                Some(angle) => Turn { pivot: pivot_mm, by_rad: angle - drawn_rad, scale: 1.0 }.place(solid, finish),
                None => as_drawn(solid, finish),
            },
            SolidMotion::Sinks(target) => sunk(solid, finish, value(&pose.drop_targets, target).unwrap_or(1.0)),
            SolidMotion::Swings { gate, axle, way } => {
                swung(solid, finish, axle, way, value(&pose.gates_rad, gate).unwrap_or_default())
            }
            SolidMotion::Spins { spinner, axle } => {
                spun(solid, finish, axle, value(&pose.spinners_rad, spinner).unwrap_or_default())
            }
            SolidMotion::Pulled { bumper, center_mm } => {
                pulled(solid, finish, center_mm, value(&pose.extensions, bumper).unwrap_or_default())
            }
            SolidMotion::Bends { slingshot, out } => {
                bent(solid, finish, out, value(&pose.extensions, slingshot).unwrap_or_default())
            }
        }
    }
}

/// What a pose says of this part.
pub(super) fn value(parts: &[(PartId, f64)], part: PartId) -> Option<f64> {
    parts.iter().find(|(id, _)| *id == part).map(|(_, value)| *value)
}

fn in_mm(segment: Segment) -> Segment {
    Segment { a: mm(segment.a), b: mm(segment.b) }
}

/// The unit normal of a slingshot's rubber on the side of the table's middle.
fn into_play(layout: &Layout, rubber: Segment) -> DVec2 {
    let normal = rubber.left_normal().unwrap_or(DVec2::X);
    let inwards = layout.size_m * 0.5 - (rubber.a + rubber.b) * 0.5;
    if normal.dot(inwards) < 0.0 { -normal } else { normal }
}

fn as_drawn(solid: &Solid, finish: Finish) -> Placed {
    Placed { shadows: shadows(solid), outlines: numbered(outlines(solid)), finish }
}

/// What casts a solid's shadow as it is drawn.
fn shadows(solid: &Solid) -> Vec<(u32, Shape)> {
    numbered(solid.shapes_mm.iter().copied())
}

/// Pieces with their numbers.
fn numbered<T>(pieces: impl IntoIterator<Item = T>) -> Vec<(u32, T)> {
    (0..).zip(pieces).collect()
}

/// Turned and scaled round a point.
#[derive(Clone, Copy)]
struct Turn {
    pivot: DVec2,
    by_rad: f64,
    scale: f64,
}

impl Turn {
    fn point(&self, point: DVec2) -> DVec2 {
        self.pivot + trig::rotate(point - self.pivot, self.by_rad) * self.scale
    }

    fn circle(&self, circle: Circle) -> Circle {
        Circle { center: self.point(circle.center), radius: circle.radius * self.scale }
    }

    fn shape(&self, shape: Shape) -> Shape {
        let core = match shape.core {
            Core::Point(center) => Core::Point(self.point(center)),
            Core::Segment(s) => Core::Segment(Segment { a: self.point(s.a), b: self.point(s.b) }),
            Core::Arc(arc) => {
                let start = trig::angle(arc.middle()) - arc.half_angle() + self.by_rad;
                Core::Arc(Arc::new(self.circle(arc.circle()), start, 2.0 * arc.half_angle()))
            }
            Core::Taper(t) => Core::Taper(Taper { a: self.circle(t.a), b: self.circle(t.b) }),
        };
        Shape { core, radius: shape.radius * self.scale }
    }

    fn place(&self, solid: &Solid, finish: Finish) -> Placed {
        let outline = |outline| match outline {
            Outline::Shape(shape) => Outline::Shape(self.shape(shape)),
            Outline::Polygon(points) => Outline::Polygon(points.into_iter().map(|p| self.point(p)).collect()),
        };
        let shadows = numbered(solid.shapes_mm.iter().map(|&shape| self.shape(shape)));
        Placed { shadows, outlines: numbered(outlines(solid).into_iter().map(outline)), finish }
    }
}

/// A drop target at `height` of its stand: darker as it sinks into its slot, then gone.
fn sunk(solid: &Solid, finish: Finish, height: f64) -> Placed {
    let mut placed = as_drawn(solid, finish);
    let height = height.clamp(0.0, 1.0);
    if height < SHADOW_ENDS {
        placed.shadows.clear();
    }
    placed.finish.opacity *= height.sqrt() as f32;
    placed.finish.albedo = placed.finish.albedo.map(|channel| channel * (0.5 + 0.5 * height as f32));
    placed
}

/// A flap that hangs from its axle and is pushed up: seen from above it grows out of its line, and less and less of it
/// stands in the light's way.
fn swung(solid: &Solid, finish: Finish, axle: Segment, way: DVec2, angle_rad: f64) -> Placed {
    let (sin, cos) = trig::sin_cos(angle_rad.clamp(0.0, std::f64::consts::FRAC_PI_2));
    let lean = way * (FLAP_MM * sin);
    let mut outlines = vec![plate(axle, -way * FLAP_EDGE_MM, lean + way * FLAP_EDGE_MM)];
    outlines.extend(axle_pins(solid, axle));
    Placed { shadows: shortened(solid, axle, cos), outlines: numbered(outlines), finish }
}

/// A plate that turns with its middle on its axle: broad and bright when it lies flat, a line when it hangs.
fn spun(solid: &Solid, mut finish: Finish, axle: Segment, angle_rad: f64) -> Placed {
    let (sin, cos) = trig::sin_cos(angle_rad);
    let across = axle.left_normal().unwrap_or(DVec2::Y) * (FLAP_MM * sin.abs() + FLAP_EDGE_MM);
    // Its back is darker than its face, and both catch the light best when they lie flat.
    let face = if sin >= 0.0 { 1.0 } else { 0.55 };
    finish.albedo = finish.albedo.map(|channel| channel * (0.45 + 0.55 * sin.abs() as f32) * face);
    let mut outlines = vec![plate(axle, -across, across)];
    outlines.extend(axle_pins(solid, axle));
    Placed { shadows: shortened(solid, axle, cos.abs()), outlines: numbered(outlines), finish }
}

fn plate(axle: Segment, from: DVec2, to: DVec2) -> Outline {
    Outline::Polygon(vec![axle.a + from, axle.b + from, axle.b + to, axle.a + to])
}

/// The two brackets that hold an axle.
fn axle_pins(solid: &Solid, axle: Segment) -> impl Iterator<Item = Outline> {
    let radius = solid.shapes_mm.first().map_or(FLAP_EDGE_MM, |shape| shape.radius).max(FLAP_EDGE_MM) + 0.4;
    [axle.a, axle.b].into_iter().map(move |end| Outline::Shape(Shape::disc(end, radius)))
}

/// What a plate still hides when only `part` of its height is left in the light's way.
fn shortened(solid: &Solid, axle: Segment, part: f64) -> Vec<(u32, Shape)> {
    let middle = (axle.a + axle.b) * 0.5;
    let half = axle.along() * (0.5 * part);
    let radius = solid.shapes_mm.first().map_or(FLAP_EDGE_MM, |shape| shape.radius);
    vec![(0, Shape::capsule(middle - half, middle + half, radius))]
}

/// A bumper's ring, `pull` of the way down: further from the eye, so smaller, and in the skirt's shade.
fn pulled(solid: &Solid, finish: Finish, center: DVec2, pull: f64) -> Placed {
    if pull <= 0.0 {
        return as_drawn(solid, finish);
    }
    let turn = Turn { pivot: center, by_rad: 0.0, scale: 1.0 - RING_PULL * pull.min(1.0) };
    Placed { shadows: shadows(solid), ..turn.place(solid, finish) }
}

/// A slingshot's rubber with its arm `out` by `kick` of its reach: the band's line breaks in the middle. The second
/// half has a number of its own, which is free while the band does not break.
fn bent(solid: &Solid, finish: Finish, out: DVec2, kick: f64) -> Placed {
    if solid.plastic_mm.is_some() {
        return as_drawn(solid, finish);
    }
    let mut shadows = Vec::with_capacity(2 * solid.shapes_mm.len());
    for (first, shape) in (0..).step_by(2).zip(&solid.shapes_mm) {
        match shape.core {
            Core::Segment(Segment { a, b }) if kick > 0.0 => {
                let knee = (a + b) * 0.5 + out * (SLING_REACH_MM * kick.min(1.0));
                shadows.push((first, Shape::capsule(a, knee, shape.radius)));
                shadows.push((first + 1, Shape::capsule(knee, b, shape.radius)));
            }
            _ => shadows.push((first, *shape)),
        }
    }
    let outlines = shadows.iter().map(|&(number, shape)| (number, Outline::Shape(shape))).collect();
    Placed { outlines, shadows, finish }
}
