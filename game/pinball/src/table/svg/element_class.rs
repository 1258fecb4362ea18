//! Element classes, the words of a drawing: what an element may be, and which numbers it has.
//!
//! This is the one list that the reader, the checker and the page about drawing agree with.

/// The class of a table's element.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(in crate::table) enum ElementClass {
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

/// Words of rendered scenes for what bends or turns light; a table in play takes what has them for art.
pub const LIGHT_BENDING_WORDS: [&str; 4] = ["glass", "prism", "lens", "mirror"];

/// A parameter: a number that `table.toml` may give.
#[derive(Debug)]
pub(in crate::table) struct Parameter {
    /// Its name, with the unit.
    pub name: &'static str,
    /// The default value.
    pub default: f64,
    /// The least value.
    pub min: f64,
    /// The greatest value.
    pub max: f64,
}

const fn parameter(name: &'static str, default: f64, min: f64, max: f64) -> Parameter {
    Parameter { name, default, min, max }
}

impl ElementClass {
    /// All of them.
    pub const ALL: [ElementClass; 25] = [
        ElementClass::Wall,
        ElementClass::Guide,
        ElementClass::Rubber,
        ElementClass::Post,
        ElementClass::Peg,
        ElementClass::Bumper,
        ElementClass::Slingshot,
        ElementClass::Flipper,
        ElementClass::Target,
        ElementClass::DropTarget,
        ElementClass::Rollover,
        ElementClass::Gate,
        ElementClass::Spinner,
        ElementClass::Saucer,
        ElementClass::Drain,
        ElementClass::Plunger,
        ElementClass::Kickback,
        ElementClass::Magnet,
        ElementClass::Diverter,
        ElementClass::CaptiveBall,
        ElementClass::Ramp,
        ElementClass::WireForm,
        ElementClass::Lamp,
        ElementClass::Insert,
        ElementClass::Plastic,
    ];

    /// Its word in the drawing.
    pub fn word(self) -> &'static str {
        match self {
            ElementClass::Wall => "wall",
            ElementClass::Guide => "guide",
            ElementClass::Rubber => "rubber",
            ElementClass::Post => "post",
            ElementClass::Peg => "peg",
            ElementClass::Bumper => "bumper",
            ElementClass::Slingshot => "slingshot",
            ElementClass::Flipper => "flipper",
            ElementClass::Target => "target",
            ElementClass::DropTarget => "drop-target",
            ElementClass::Rollover => "rollover",
            ElementClass::Gate => "gate",
            ElementClass::Spinner => "spinner",
            ElementClass::Saucer => "saucer",
            ElementClass::Drain => "drain",
            ElementClass::Plunger => "plunger",
            ElementClass::Kickback => "kickback",
            ElementClass::Magnet => "magnet",
            ElementClass::Diverter => "diverter",
            ElementClass::CaptiveBall => "captive-ball",
            ElementClass::Ramp => "ramp",
            ElementClass::WireForm => "wire-form",
            ElementClass::Lamp => "lamp",
            ElementClass::Insert => "insert",
            ElementClass::Plastic => "plastic",
        }
    }

    /// The same behind `a` or `an`.
    pub fn with_article(self) -> String {
        let word = self.word();
        let article = if word.starts_with(['a', 'e', 'i', 'o', 'u']) { "an" } else { "a" };
        format!("{article} {word}")
    }

    /// The class that this word means.
    pub fn from_word(word: &str) -> Option<ElementClass> {
        ElementClass::ALL.into_iter().find(|class| class.word() == word)
    }

    /// Every word, for a sentence.
    pub fn words() -> String {
        ElementClass::ALL.map(ElementClass::word).join(", ")
    }

    /// Whether the element is static: it only stands there.
    pub fn is_static(self) -> bool {
        matches!(
            self,
            ElementClass::Wall | ElementClass::Guide | ElementClass::Rubber | ElementClass::Post | ElementClass::Peg
        )
    }

    /// Whether the element is a part: the ball can meet it.
    pub fn is_part(self) -> bool {
        !matches!(self, ElementClass::Lamp | ElementClass::Insert | ElementClass::Plastic)
    }

    /// Whether the element is elevated: a way above the playfield.
    pub fn is_elevated(self) -> bool {
        matches!(self, ElementClass::Ramp | ElementClass::WireForm)
    }

    /// Of no use without a name that rules can say.
    pub fn needs_id(self) -> bool {
        !self.is_static()
            && !matches!(self, ElementClass::Drain | ElementClass::Plunger | ElementClass::Gate | ElementClass::Plastic)
    }

    /// Whether the ball bounces off it, so that it is made of something.
    pub fn has_material(self) -> bool {
        self.is_static()
            || matches!(
                self,
                ElementClass::Bumper
                    | ElementClass::Slingshot
                    | ElementClass::Flipper
                    | ElementClass::Diverter
                    | ElementClass::Target
                    | ElementClass::DropTarget
                    | ElementClass::Gate
                    | ElementClass::Ramp
                    | ElementClass::WireForm
            )
    }

    /// Whether it has a top that can be seen.
    pub fn has_finish(self) -> bool {
        self.has_material() || matches!(self, ElementClass::Spinner | ElementClass::Plastic)
    }

    /// The attributes that an element of this class may have, without their `data-`.
    pub fn data(self) -> impl Iterator<Item = &'static str> {
        let own: &[&str] = match self {
            ElementClass::Flipper => &["side", "up-deg"],
            ElementClass::Diverter => &["turn-deg"],
            ElementClass::Gate => &["way"],
            ElementClass::Saucer => &["eject-deg", "eject-m-s"],
            ElementClass::Ramp | ElementClass::WireForm => &["heights-mm"],
            ElementClass::Lamp => &["inside"],
            _ => &[],
        };
        own.iter().copied().chain(self.has_finish().then_some("finish"))
    }

    /// The numbers that `table.toml` may give to an element of this class. Defaults are figures of real machines.
    pub fn parameters(self) -> &'static [Parameter] {
        match self {
            ElementClass::Flipper => FLIPPER,
            ElementClass::Bumper => BUMPER,
            ElementClass::Slingshot => SLINGSHOT,
            ElementClass::Target => TARGET,
            ElementClass::DropTarget => DROP_TARGET,
            ElementClass::Spinner => SPINNER,
            ElementClass::Saucer => SAUCER,
            ElementClass::Plunger => PLUNGER,
            ElementClass::Kickback => KICKBACK,
            ElementClass::Magnet => MAGNET,
            ElementClass::Diverter => DIVERTER,
            ElementClass::CaptiveBall => CAPTIVE_BALL,
            ElementClass::Lamp => LAMP,
            ElementClass::Insert => INSERT,
            _ => &[],
        }
    }
}

/// What no ball of a table is faster than when it hits something: a threshold over it were never met.
pub(in crate::table) const FASTEST_M_S: f64 = 3.0;

// The ranges leave out what would be dead: a spinner that stops before its half turn, a saucer that catches no rolling ball,
// a magnet that does not hold one on the slope.
const FLIPPER: &[Parameter] = &[
    parameter("base_radius_mm", 11.6, 2.0, 50.0),
    parameter("tip_radius_mm", 7.0, 1.0, 50.0),
    parameter("coil_torque_n_m", 1.2, 0.001, 100.0),
    parameter("hold_torque_n_m", 0.4, 0.001, 100.0),
    parameter("spring_torque_n_m", 0.06, 0.001, 100.0),
    parameter("mass_kg", 0.08, 0.001, 10.0),
];
const BUMPER: &[Parameter] =
    &[parameter("kick_m_s", 0.8, 0.0, 20.0), parameter("threshold_m_s", 0.05, 0.0, FASTEST_M_S)];
const SLINGSHOT: &[Parameter] =
    &[parameter("kick_m_s", 2.2, 0.0, 20.0), parameter("threshold_m_s", 0.3, 0.0, FASTEST_M_S)];
const TARGET: &[Parameter] = &[parameter("threshold_m_s", 0.15, 0.0, FASTEST_M_S)];
const DROP_TARGET: &[Parameter] = &[parameter("threshold_m_s", 0.25, 0.0, FASTEST_M_S)];
const SPINNER: &[Parameter] = &[parameter("damping_per_s", 0.8, 0.0, 50.0)];
const SAUCER: &[Parameter] = &[parameter("capture_m_s", 1.0, 0.1, 20.0)];
const PLUNGER: &[Parameter] = &[parameter("pull_s", 1.0, 0.05, 20.0), parameter("full_speed_m_s", 3.5, 0.5, 15.0)];
const KICKBACK: &[Parameter] = &[parameter("speed_m_s", 3.5, 0.5, 15.0)];
const MAGNET: &[Parameter] = &[parameter("pull_m_s2", 40.0, 1.0, 500.0)];
const DIVERTER: &[Parameter] = &[
    parameter("coil_torque_n_m", 1.2, 0.001, 100.0),
    parameter("hold_torque_n_m", 0.6, 0.001, 100.0),
    parameter("spring_torque_n_m", 0.3, 0.001, 100.0),
    parameter("inertia_kg_mm2", 140.0, 1.0, 100_000.0),
];
const CAPTIVE_BALL: &[Parameter] = &[parameter("threshold_m_s", 0.15, 0.0, FASTEST_M_S)];
const LAMP: &[Parameter] = &[
    parameter("power", 1.0, 0.0, 1000.0),
    parameter("height_mm", 30.0, 0.1, 1000.0),
    parameter("reach_mm", 260.0, 10.0, 10000.0),
];
const INSERT: &[Parameter] = &[parameter("power", 1.0, 0.0, 1000.0)];
