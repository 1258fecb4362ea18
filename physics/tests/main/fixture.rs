//! Small playfields to try things on.

use geometry::{Circle, DVec2, Segment, Shape};
use physics::*;
use std::sync::Arc;

pub const RUBBER: Material = Material { restitution: 0.85, falloff_s_per_m: 0.13, friction: 0.3 };
pub const WOOD: Material = Material { restitution: 0.4, falloff_s_per_m: 0.0, friction: 0.25 };
pub const METAL: Material = Material { restitution: 0.3, falloff_s_per_m: 0.0, friction: 0.2 };
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
        direction: v(0.0, -1.0),
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
        control: if left { FlipperControl::Left } else { FlipperControl::Right },
        material: FLIPPER_RUBBER,
        coil_torque_n_m: 3.3,
        hold_torque_n_m: 1.4,
        spring_torque_n_m: 0.32,
        mass_kg: 0.30,
    });
    part(if left { "left-flipper" } else { "right-flipper" }, kind)
}

/// A machine whose flippers and kickers are live.
pub fn live(layout: Layout) -> Machine {
    let mut machine = machine(layout);
    machine.tick(Controls::default(), &[Command::SetFlippers(true), Command::SetCoils(true)]);
    machine
}

/// A flat playfield with this thing on it, as part 0.
pub fn with(kind: Kind) -> Layout {
    let mut layout = bare();
    layout.slope_rad = 0.0;
    layout.parts.push(part("thing", kind));
    layout
}

/// Ticks on, and counts how often `kind` happens.
pub fn run(machine: &mut Machine, ticks: usize, kind: EventKind) -> usize {
    let mut count = 0;
    for _ in 0..ticks {
        machine.tick(Controls::default(), &[]);
        count += machine.events().iter().filter(|event| event.kind == kind).count();
        assert!(machine.penetration_m() < 5e-5, "{} m deep", machine.penetration_m());
    }
    count
}

/// The part of this name.
pub fn id(machine: &Machine, name: &str) -> PartId {
    let index = machine.layout().parts.iter().position(|part| part.name == name).expect("a part of this name");
    PartId(index as u16)
}

/// What the rules could order at this tick: magnet, diverter and kickback are busy all the time.
pub fn orders(machine: &Machine, tick: u32) -> Vec<Command> {
    let (magnet, diverter) = (id(machine, "magnet"), id(machine, "diverter"));
    match tick {
        tick if tick % 300 == 10 => vec![Command::Magnet(magnet, tick % 600 == 10)],
        tick if tick % 130 == 20 => vec![Command::Divert(diverter, tick % 260 == 20)],
        tick if tick % 170 == 30 => vec![Command::Kick(id(machine, "kickback"))],
        _ => Vec::new(),
    }
}

pub fn machine(layout: Layout) -> Machine {
    Machine::new(Arc::new(layout)).expect("the fixture's numbers can be")
}

/// Where the table's captive ball lies.
pub const CAPTIVE: DVec2 = DVec2::new(0.30, 0.66);

/// Two guides with a post at the lower end of each, on which a ball at `center` lies with its rim sticking out.
pub fn pocket(center: DVec2) -> Part {
    let (post, guide, lane) = (0.003, 0.002, 0.015);
    let down = ((BALL_RADIUS_M + post).powi(2) - lane * lane).sqrt();
    let at = |x: f64, y: f64| center + v(x, y);
    let beside = lane + guide;
    let shapes = vec![
        Shape::disc(at(-lane, down), post),
        Shape::disc(at(lane, down), post),
        Shape::capsule(at(-beside, down), at(-beside, -0.04), guide),
        Shape::capsule(at(beside, down), at(beside, -0.04), guide),
        Shape::capsule(at(-beside, -0.04), at(beside, -0.04), guide),
    ];
    part("pocket", walls(shapes, METAL))
}

pub fn magnet(center: DVec2) -> Magnet {
    Magnet { circle: Circle { center, radius: 0.045 }, pull_m_s2: 40.0 }
}

/// A rod that shoots up the table.
pub fn kickback(tip: DVec2) -> Kickback {
    Kickback { tip, half_width_m: 0.01, direction: v(0.0, -1.0), stroke_m: 0.025, speed_m_s: 3.5 }
}

/// A flap of sheet steel that hangs down the table and turns by 40 degrees, clockwise.
pub fn diverter(pivot: DVec2) -> Part {
    let rest_rad = std::f64::consts::FRAC_PI_2;
    let kind = Kind::Flipper(Flipper {
        base: Circle { center: pivot, radius: 0.0015 },
        length_m: 0.045,
        tip_radius_m: 0.0015,
        rest_rad,
        up_rad: rest_rad + 40.0_f64.to_radians(),
        control: FlipperControl::Rules,
        material: METAL,
        coil_torque_n_m: 1.2,
        hold_torque_n_m: 0.6,
        spring_torque_n_m: 0.3,
        mass_kg: 0.2,
    });
    part("diverter", kind)
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
        part("rollover", Kind::Rollover(Rollover { shape: capsule(line(0.05, 0.45, 0.07, 0.45), 0.006) })),
        part(
            "gate",
            Kind::Gate(Gate { segment: line(0.38, 0.12, 0.38, 0.18), direction: v(-1.0, 0.0), material: WOOD }),
        ),
        part("spinner", Kind::Spinner(Spinner { segment: line(0.05, 0.55, 0.10, 0.55), damping_per_s: 0.7 })),
        part(
            "saucer",
            Kind::Saucer(Saucer {
                circle: Circle { center: v(0.35, 0.55), radius: 0.014 },
                capture_m_s: 1.0,
                eject_m_s: v(-0.6, 0.8),
            }),
        ),
        part("magnet", Kind::Magnet(magnet(v(0.25, 0.45)))),
        diverter(v(0.40, 0.62)),
        part("kickback", Kind::Kickback(kickback(v(0.06, 1.0)))),
        pocket(CAPTIVE),
        part("captive", Kind::CaptiveBall(CaptiveBall { center: CAPTIVE, threshold_m_s: 0.1 })),
        part("drain", Kind::Drain(Drain { shape: capsule(line(0.03, 1.035, 0.44, 1.035), 0.005) })),
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
