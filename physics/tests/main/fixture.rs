//! Small playfields to try things on.

use geometry::{Circle, DVec2, Segment, Shape};
use physics::*;
use std::sync::Arc;

pub const RUBBER: Material = Material { restitution: 0.85, falloff_s_per_m: 0.13, friction: 0.3 };
pub const WOOD: Material = Material { restitution: 0.4, falloff_s_per_m: 0.0, friction: 0.25 };
pub const FLIPPER_RUBBER: Material = Material { restitution: 0.88, falloff_s_per_m: 0.15, friction: 0.9 };

pub fn v(x: f64, y: f64) -> DVec2 {
    DVec2::new(x, y)
}

pub fn part(name: &str, kind: Kind) -> Part {
    Part { name: name.into(), kind }
}

pub fn walls(shapes: Vec<Shape>, material: Material) -> Kind {
    Kind::Wall(Wall { shapes, material })
}

/// A layout with nothing on it: the playfield of a real machine.
pub fn bare() -> Layout {
    Layout { size_m: v(0.514, 1.067), slope_rad: 6.5_f64.to_radians(), playfield_friction: 0.09, parts: Vec::new() }
}

/// Four walls, 10 mm inside the edge.
pub fn frame(material: Material) -> Part {
    let (a, b, c, d) = (v(0.01, 0.01), v(0.504, 0.01), v(0.504, 1.057), v(0.01, 1.057));
    let sides = [(a, b), (b, c), (c, d), (d, a)];
    part("frame", walls(sides.iter().map(|&(a, b)| Shape::capsule(a, b, 0.003)).collect(), material))
}

pub fn plunger() -> Part {
    let kind = Kind::Plunger(Plunger {
        feed: v(0.48, 0.93),
        tip: v(0.48, 0.99),
        half_width_m: 0.008,
        way: v(0.0, -1.0),
        stroke_m: 0.05,
        pull_s: 0.8,
        full_speed_m_s: 3.5,
    });
    part("plunger", kind)
}

pub fn flipper(left: bool) -> Part {
    let pivot = if left { v(0.16, 0.93) } else { v(0.354, 0.93) };
    let (rest, up) = (28.0_f64.to_radians(), -23.0_f64.to_radians());
    let turn = std::f64::consts::PI;
    let (rest_rad, up_rad) = if left { (rest, up) } else { (turn - rest, turn - up) };
    let kind = Kind::Flipper(Flipper {
        base: Circle { center: pivot, radius: 0.0116 },
        length_m: 0.0605,
        tip_radius_m: 0.007,
        rest_rad,
        up_rad,
        left,
        material: FLIPPER_RUBBER,
        coil_torque_n_m: 3.3,
        hold_torque_n_m: 1.4,
        spring_torque_n_m: 0.32,
        mass_kg: 0.30,
    });
    part(if left { "left-flipper" } else { "right-flipper" }, kind)
}

pub fn machine(layout: Layout) -> Machine {
    Machine::new(Arc::new(layout)).expect("the fixture's numbers can be")
}

/// A table with one of everything.
pub fn table() -> Layout {
    let mut layout = bare();
    let line = |ax: f64, ay: f64, bx: f64, by: f64| Segment { a: v(ax, ay), b: v(bx, by) };
    let capsule = |s: Segment, r: f64| Shape::capsule(s.a, s.b, r);
    layout.parts = vec![
        frame(WOOD),
        flipper(true),
        flipper(false),
        plunger(),
        part("lane", walls(vec![Shape::capsule(v(0.455, 0.3), v(0.455, 1.057), 0.002)], WOOD)),
        part(
            "inlanes",
            walls(
                vec![capsule(line(0.02, 0.80, 0.152, 0.9188), 0.002), capsule(line(0.445, 0.84, 0.362, 0.9188), 0.002)],
                WOOD,
            ),
        ),
        part(
            "arch",
            walls(
                vec![Shape {
                    core: geometry::Core::Arc(geometry::Arc::new(
                        Circle { center: v(0.257, 0.26), radius: 0.247 },
                        std::f64::consts::PI,
                        std::f64::consts::PI,
                    )),
                    radius: 0.002,
                }],
                WOOD,
            ),
        ),
        part(
            "bumper",
            Kind::Bumper(Bumper {
                circle: Circle { center: v(0.2, 0.3), radius: 0.03 },
                material: RUBBER,
                kick_m_s: 0.8,
                threshold_m_s: 0.05,
            }),
        ),
        part(
            "slingshot",
            Kind::Slingshot(Slingshot {
                segment: line(0.09, 0.72, 0.13, 0.82),
                radius_m: 0.004,
                material: RUBBER,
                kick_m_s: 2.2,
                threshold_m_s: 0.2,
            }),
        ),
        part(
            "target",
            Kind::Target(Target {
                shape: capsule(line(0.40, 0.40, 0.42, 0.45), 0.002),
                material: WOOD,
                threshold_m_s: 0.1,
            }),
        ),
        part(
            "drop",
            Kind::DropTarget(DropTarget {
                shape: capsule(line(0.30, 0.20, 0.33, 0.20), 0.002),
                material: WOOD,
                threshold_m_s: 0.3,
            }),
        ),
        part("rollover", Kind::Rollover(Rollover { zone: capsule(line(0.05, 0.45, 0.07, 0.45), 0.006) })),
        part("gate", Kind::Gate(Gate { segment: line(0.38, 0.12, 0.38, 0.18), way: v(-1.0, 0.0), material: WOOD })),
        part("spinner", Kind::Spinner(Spinner { segment: line(0.05, 0.55, 0.10, 0.55), damping_per_s: 0.7 })),
        part(
            "saucer",
            Kind::Saucer(Saucer {
                circle: Circle { center: v(0.35, 0.55), radius: 0.014 },
                capture_m_s: 1.0,
                eject_m_s: v(-0.6, 0.8),
            }),
        ),
        part("drain", Kind::Drain(Drain { zone: capsule(line(0.03, 1.035, 0.44, 1.035), 0.005) })),
    ];
    layout
}

/// Small steps of a number that looks like chance: the same on every machine.
pub struct Chance(pub u64);

impl Chance {
    /// In [0, 1).
    pub fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        let mixed = (self.0 ^ (self.0 >> 29)).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        (mixed >> 11) as f64 / (1u64 << 53) as f64
    }

    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }
}
