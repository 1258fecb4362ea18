//! The words of a drawing: what an element may be, and which numbers it has.
//!
//! This is the one list that the reader, the checker and the page about drawing agree with.

/// What a thing in the drawing is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Class {
    Wall,
    Guide,
    Rubber,
    Post,
    Peg,
    Bumper,
    Slingshot,
    Flipper,
    Target,
    DropTarget,
    Rollover,
    Gate,
    Spinner,
    Saucer,
    Drain,
    Plunger,
    Kickback,
    Magnet,
    Diverter,
    CaptiveBall,
    Ramp,
    WireForm,
    Lamp,
    Insert,
    Plastic,
}

/// A number that `table.toml` may give.
#[derive(Debug)]
pub(super) struct Key {
    /// Its name, with the unit.
    pub name: &'static str,
    /// What it is when nobody says.
    pub default: f64,
    /// The least that it may be.
    pub min: f64,
    /// The most that it may be.
    pub max: f64,
}

const fn key(name: &'static str, default: f64, min: f64, max: f64) -> Key {
    Key { name, default, min, max }
}

impl Class {
    /// All of them.
    pub const ALL: [Class; 25] = [
        Class::Wall,
        Class::Guide,
        Class::Rubber,
        Class::Post,
        Class::Peg,
        Class::Bumper,
        Class::Slingshot,
        Class::Flipper,
        Class::Target,
        Class::DropTarget,
        Class::Rollover,
        Class::Gate,
        Class::Spinner,
        Class::Saucer,
        Class::Drain,
        Class::Plunger,
        Class::Kickback,
        Class::Magnet,
        Class::Diverter,
        Class::CaptiveBall,
        Class::Ramp,
        Class::WireForm,
        Class::Lamp,
        Class::Insert,
        Class::Plastic,
    ];

    /// Its word in the drawing.
    pub fn word(self) -> &'static str {
        match self {
            Class::Wall => "wall",
            Class::Guide => "guide",
            Class::Rubber => "rubber",
            Class::Post => "post",
            Class::Peg => "peg",
            Class::Bumper => "bumper",
            Class::Slingshot => "slingshot",
            Class::Flipper => "flipper",
            Class::Target => "target",
            Class::DropTarget => "drop-target",
            Class::Rollover => "rollover",
            Class::Gate => "gate",
            Class::Spinner => "spinner",
            Class::Saucer => "saucer",
            Class::Drain => "drain",
            Class::Plunger => "plunger",
            Class::Kickback => "kickback",
            Class::Magnet => "magnet",
            Class::Diverter => "diverter",
            Class::CaptiveBall => "captive-ball",
            Class::Ramp => "ramp",
            Class::WireForm => "wire-form",
            Class::Lamp => "lamp",
            Class::Insert => "insert",
            Class::Plastic => "plastic",
        }
    }

    /// The class that this word means.
    pub fn of(word: &str) -> Option<Class> {
        Class::ALL.into_iter().find(|class| class.word() == word)
    }

    /// Every word, for a sentence.
    pub fn words() -> String {
        Class::ALL.map(Class::word).join(", ")
    }

    /// Something that only stands there.
    pub fn stands(self) -> bool {
        matches!(self, Class::Wall | Class::Guide | Class::Rubber | Class::Post | Class::Peg)
    }

    /// The ball can meet it.
    pub fn is_part(self) -> bool {
        !matches!(self, Class::Lamp | Class::Insert | Class::Plastic)
    }

    /// A way above the playfield.
    pub fn is_above(self) -> bool {
        matches!(self, Class::Ramp | Class::WireForm)
    }

    /// Of no use without a name that rules can say.
    pub fn needs_id(self) -> bool {
        !self.stands() && !matches!(self, Class::Drain | Class::Plunger | Class::Gate | Class::Plastic)
    }

    /// Whether the ball bounces off it, so that it is made of something.
    pub fn has_material(self) -> bool {
        self.stands()
            || matches!(
                self,
                Class::Bumper
                    | Class::Slingshot
                    | Class::Flipper
                    | Class::Diverter
                    | Class::Target
                    | Class::DropTarget
                    | Class::Gate
                    | Class::Ramp
                    | Class::WireForm
            )
    }

    /// Whether it has a top that can be seen.
    pub fn has_finish(self) -> bool {
        self.has_material() || matches!(self, Class::Spinner | Class::Plastic)
    }

    /// The attributes that a thing of this class may have, without their `data-`.
    pub fn data(self) -> impl Iterator<Item = &'static str> {
        let own: &[&str] = match self {
            Class::Flipper => &["side", "up-deg"],
            Class::Diverter => &["turn-deg"],
            Class::Gate => &["way"],
            Class::Saucer => &["eject-deg", "eject-m-s"],
            Class::Ramp | Class::WireForm => &["heights-mm"],
            Class::Lamp => &["inside"],
            _ => &[],
        };
        own.iter().copied().chain(self.has_finish().then_some("finish"))
    }

    /// The numbers that `table.toml` may give to a thing of this class. Defaults are figures of real machines.
    pub fn keys(self) -> &'static [Key] {
        match self {
            Class::Flipper => FLIPPER,
            Class::Bumper => BUMPER,
            Class::Slingshot => SLINGSHOT,
            Class::Target => TARGET,
            Class::DropTarget => DROP_TARGET,
            Class::Spinner => SPINNER,
            Class::Saucer => SAUCER,
            Class::Plunger => PLUNGER,
            Class::Kickback => KICKBACK,
            Class::Magnet => MAGNET,
            Class::Diverter => DIVERTER,
            Class::CaptiveBall => CAPTIVE_BALL,
            Class::Lamp => LAMP,
            Class::Insert => INSERT,
            _ => &[],
        }
    }
}

const FLIPPER: &[Key] = &[
    key("base_radius_mm", 11.6, 2.0, 50.0),
    key("tip_radius_mm", 7.0, 1.0, 50.0),
    key("coil_torque_n_m", 1.2, 0.001, 100.0),
    key("hold_torque_n_m", 0.4, 0.001, 100.0),
    key("spring_torque_n_m", 0.06, 0.001, 100.0),
    key("mass_kg", 0.08, 0.001, 10.0),
];
const BUMPER: &[Key] = &[key("kick_m_s", 0.8, 0.0, 20.0), key("threshold_m_s", 0.05, 0.0, 20.0)];
const SLINGSHOT: &[Key] = &[key("kick_m_s", 2.2, 0.0, 20.0), key("threshold_m_s", 0.3, 0.0, 20.0)];
const TARGET: &[Key] = &[key("threshold_m_s", 0.15, 0.0, 20.0)];
const DROP_TARGET: &[Key] = &[key("threshold_m_s", 0.25, 0.0, 20.0)];
const SPINNER: &[Key] = &[key("damping_per_s", 0.8, 0.0, 1000.0)];
const SAUCER: &[Key] = &[key("capture_m_s", 1.0, 0.0, 20.0)];
const PLUNGER: &[Key] = &[key("pull_s", 1.0, 0.05, 20.0), key("full_speed_m_s", 3.5, 0.1, 15.0)];
const KICKBACK: &[Key] = &[key("speed_m_s", 3.5, 0.1, 15.0)];
const MAGNET: &[Key] = &[key("pull_m_s2", 40.0, 0.0, 500.0)];
const DIVERTER: &[Key] = &[
    key("coil_torque_n_m", 1.2, 0.001, 100.0),
    key("hold_torque_n_m", 0.6, 0.001, 100.0),
    key("spring_torque_n_m", 0.3, 0.001, 100.0),
    key("inertia_kg_mm2", 140.0, 1.0, 100_000.0),
];
const CAPTIVE_BALL: &[Key] = &[key("threshold_m_s", 0.15, 0.0, 20.0)];
const LAMP: &[Key] =
    &[key("power", 1.0, 0.0, 1000.0), key("height_mm", 30.0, 0.1, 1000.0), key("reach_mm", 260.0, 1.0, 10000.0)];
const INSERT: &[Key] = &[key("power", 1.0, 0.0, 1000.0)];
