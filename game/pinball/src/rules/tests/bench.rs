//! A small table, and a bench on which its rules are played by hand.

use crate::lamps::{LampController, LampLight};
use crate::rules::{Display, Program, Rules, TickInput};
use crate::table::{Lamp, LampKind};
use crate::{Buttons, Failure, Table};
use geometry::{Circle, DVec2, Shape};
use physics::{
    BallPose, Command, Drain, DropTarget, Event, EventKind, Flipper, FlipperControl, Kickback, Kind, Layout, Magnet,
    Material, Part, PartId, Plunger, Rollover, Saucer, TickEvent,
};
use std::sync::Arc;

const MATERIAL: Material = Material { restitution: 0.5, falloff_s_per_m: 0.0, friction: 0.2 };

/// A table with these rules, parts (by what their names begin with) and lamps.
pub fn table(rules: &str, parts: &[&str], lamps: &[&str]) -> Table {
    let parts = parts.iter().enumerate();
    Table {
        name: "bench".into(),
        title: String::new(),
        origin: "bench".to_string(),
        folder: String::new(),
        layout: Layout {
            size_m: DVec2::new(0.5, 1.0),
            slope_rad: 0.11,
            playfield_friction: 0.09,
            parts: parts.map(|(row, name)| Part { name: name.to_string(), kind: kind(name, row as f64) }).collect(),
        },
        part_lines: Vec::new(),
        art_ids: Default::default(),
        materials: Vec::new(),
        size_mm: DVec2::new(500.0, 1000.0),
        lamps: lamps.iter().map(|name| lamp(name)).collect(),
        solids: Vec::new(),
        floor_svg: String::new(),
        tops_svg: String::new(),
        normal_map: crate::table::NormalMapInputs::default(),
        rules: rules.into(),
        ambient: [0; 3],
        ambient_power: 0.0,
        warnings: Vec::new(),
        hash: 7,
    }
}

/// Something of the kind that the name says; most of the rules' parts are switches like any other.
fn kind(name: &str, row: f64) -> Kind {
    let place = DVec2::new(0.1, 0.1 + 0.02 * row);
    let shape = Shape::capsule(place, place + DVec2::new(0.04, 0.0), 0.002);
    match name.split('-').next() {
        Some("drain") => Kind::Drain(Drain { shape }),
        Some("saucer") => Kind::Saucer(Saucer {
            circle: Circle { center: place, radius: 0.012 },
            capture_m_s: 1.0,
            eject_m_s: DVec2::new(0.5, 1.0),
        }),
        Some("kickback") => Kind::Kickback(Kickback {
            tip: place,
            half_width_m: 0.01,
            direction: DVec2::new(0.0, -1.0),
            stroke_m: 0.025,
            speed_m_s: 3.5,
        }),
        Some("magnet") => Kind::Magnet(Magnet { circle: Circle { center: place, radius: 0.045 }, pull_m_s2: 40.0 }),
        Some("diverter") => Kind::Flipper(Flipper {
            base: Circle { center: place, radius: 0.0015 },
            length_m: 0.045,
            tip_radius_m: 0.0015,
            rest_rad: 0.0,
            up_rad: 0.7,
            control: FlipperControl::Rules,
            material: MATERIAL,
            coil_torque_n_m: 1.2,
            hold_torque_n_m: 0.6,
            spring_torque_n_m: 0.3,
            mass_kg: 0.2,
        }),
        Some("drop") => Kind::DropTarget(DropTarget { shape, material: MATERIAL, threshold_m_s: 0.2 }),
        Some("plunger") => Kind::Plunger(Plunger {
            feed: DVec2::new(0.48, 0.9),
            tip: DVec2::new(0.48, 0.93),
            half_width_m: 0.01,
            direction: DVec2::new(0.0, -1.0),
            stroke_m: 0.06,
            pull_s: 1.0,
            full_speed_m_s: 4.0,
        }),
        _ => Kind::Rollover(Rollover { shape }),
    }
}

fn lamp(name: &str) -> Lamp {
    let kind = LampKind::Bulb {
        center_mm: DVec2::new(100.0, 100.0),
        emitter: crate::table::Emitter::Disc { radius_mm: 5.0 },
        height_mm: 20.0,
        reach_mm: 200.0,
        inside: None,
    };
    Lamp { name: name.into(), color: [255, 128, 0], power: 1.0, kind }
}

/// Rules without a machine: the test says what happens, and this keeps the balls that the rules ask for.
pub struct Bench {
    pub rules: Rules,
    pub lamps: LampController,
    pub now: u64,
    pub balls: Vec<BallPose>,
    /// Every order of the rules, in order.
    pub orders: Vec<Command>,
    buttons: Buttons,
    fed: u32,
    table: Arc<Table>,
}

impl Bench {
    /// Switches the machine on.
    pub fn new(table: Table) -> Result<Bench, Failure> {
        let table = Arc::new(table);
        let mut lamps = LampController::new(&table);
        let rules = Rules::new(Arc::new(Program::new(&table)?), 1, &mut lamps)?;
        let (balls, orders) = (Vec::new(), Vec::new());
        Ok(Bench { rules, lamps, now: 0, balls, orders, buttons: Buttons::NONE, fed: 0, table })
    }

    /// One tick in which this happens; balls that were asked for arrive.
    pub fn tick(&mut self, mut events: Vec<Event>) {
        self.now += 1;
        for command in self.rules.take_commands() {
            self.orders.push(command);
            if command == Command::AddBall {
                self.fed += 1;
                self.balls.push(ball(self.fed, DVec2::new(0.48, 0.9)));
                events.push(Event { part: self.table.part("plunger"), kind: EventKind::Fed });
            }
        }
        let balls = self.balls.clone();
        let buttons = self.buttons;
        let events: Vec<TickEvent> = events.into_iter().map(TickEvent::Event).collect();
        let input = TickInput { now: self.now, buttons, before: buttons, events: &events, balls: || balls.clone() };
        self.rules.tick(&input, &mut self.lamps);
        self.lamps.tick(self.now);
    }

    /// Time in which nothing happens.
    pub fn wait(&mut self, ms: u64) {
        for _ in 0..ms {
            self.tick(Vec::new());
        }
    }

    /// A button goes down and up again.
    pub fn press(&mut self, button: Buttons) {
        for (before, buttons) in [(Buttons::NONE, button), (button, Buttons::NONE)] {
            self.now += 1;
            let balls = self.balls.clone();
            let input = TickInput { now: self.now, buttons, before, events: &[], balls: || balls.clone() };
            self.rules.tick(&input, &mut self.lamps);
            self.lamps.tick(self.now);
        }
        self.tick(Vec::new());
    }

    /// A button is held from now on, without the rules being told of the edge.
    pub fn hold(&mut self, buttons: Buttons) {
        self.buttons = buttons;
    }

    /// The part with this name.
    pub fn part(&self, name: &str) -> PartId {
        self.table.part(name).unwrap_or_else(|| panic!("no part {name}"))
    }

    /// A switch closes.
    pub fn close(&mut self, name: &str) {
        let part = Some(self.part(name));
        self.tick(vec![Event { part, kind: EventKind::Closed }]);
    }

    /// A switch closes and opens again.
    pub fn hit(&mut self, name: &str) {
        self.close(name);
        let part = Some(self.part(name));
        self.tick(vec![Event { part, kind: EventKind::Opened }]);
    }

    /// The plunger shoots the last ball onto the playfield.
    pub fn launch(&mut self) {
        if let Some(ball) = self.balls.last_mut() {
            ball.center = DVec2::new(0.25, 0.5);
        }
        self.tick(vec![Event { part: self.table.part("plunger"), kind: EventKind::Launched }]);
    }

    /// The oldest ball is lost.
    pub fn drain(&mut self) {
        self.balls.remove(0);
        self.close("drain");
    }

    /// The tilt bob touches its ring.
    pub fn bob(&mut self) {
        self.tick(vec![Event { part: None, kind: EventKind::TiltBob }]);
    }

    /// The slam switch closes.
    pub fn slam(&mut self) {
        self.tick(vec![Event { part: None, kind: EventKind::Slam }]);
    }

    /// What the display shows.
    pub fn display(&self) -> Display {
        self.rules.script_state().display()
    }

    /// The points of the player at the machine.
    pub fn score(&self) -> i64 {
        let display = self.display();
        display.scores.get(display.player).copied().unwrap_or(0)
    }

    /// What a lamp does.
    pub fn light(&self, name: &str) -> LampLight {
        self.lamps.lights(&self.table, self.now)[self.table.lamp(name).unwrap_or_else(|| panic!("no lamp {name}"))]
    }

    /// Whether the rules have given this order.
    pub fn ordered(&self, command: Command) -> bool {
        self.orders.contains(&command)
    }
}

fn ball(id: u32, center: DVec2) -> BallPose {
    BallPose {
        id,
        center,
        velocity: DVec2::ZERO,
        spin: [0.0; 3],
        rotation: [0.0, 0.0, 0.0, 1.0],
        held: false,
        height_m: 0.0,
        above: false,
    }
}
