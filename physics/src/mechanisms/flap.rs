//! Flap: the plate of a spinner or the flap of a gate: its sizes, its mass and how far it turns.

/// Height of the axles of gates and spinners, m: a ball passes below.
pub(crate) const AXLE_M: f64 = 0.030;
/// From the axle of a gate or a spinner to the edge of its flap, m.
pub const AXLE_TO_EDGE_M: f64 = 0.021;
/// How far from its axle's line a flap can still meet the ball, m: a little over 30 mm, where it stands out at 62 degrees
/// and its edge touches the ball below its middle.
pub(crate) const FLAP_REACH_M: f64 = 0.031;
/// A spinner's plate: thin steel, 42 x 30 mm.
const SPINNER_KG: f64 = 0.007;
/// A gate's flap: bent wire.
const GATE_KG: f64 = 0.002;
/// How far below its axle a spinner's plate has its middle, m: it comes to rest hanging.
const SPINNER_HANG_M: f64 = 0.0005;
/// How far a gate's flap opens, rad.
const GATE_MAX_RAD: f64 = 1.45;
/// Turning speed that a gate's flap loses, 1/s.
pub(crate) const GATE_DAMPING_PER_S: f64 = 3.0;

/// A flap, counted by kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Flap {
    Spinner(usize),
    Gate(usize),
}

impl Flap {
    /// kg.
    pub fn mass(self) -> f64 {
        match self {
            Flap::Spinner(_) => SPINNER_KG,
            Flap::Gate(_) => GATE_KG,
        }
    }

    /// How far below the axle its centre of mass hangs, m.
    pub fn hang(self) -> f64 {
        match self {
            Flap::Spinner(_) => SPINNER_HANG_M,
            Flap::Gate(_) => 0.5 * AXLE_TO_EDGE_M,
        }
    }

    /// Moment of inertia about the axle, kg m^2: of a plate about its middle, `m w^2 / 12`, or a rod about its end,
    /// `m l^2 / 3`.
    pub fn inertia(self) -> f64 {
        match self {
            Flap::Spinner(_) => SPINNER_KG * (2.0 * AXLE_TO_EDGE_M) * (2.0 * AXLE_TO_EDGE_M) / 12.0,
            Flap::Gate(_) => GATE_KG * AXLE_TO_EDGE_M * AXLE_TO_EDGE_M / 3.0,
        }
    }

    /// The angles that it can take, rad.
    pub fn range(self) -> (f64, f64) {
        match self {
            Flap::Spinner(_) => (f64::NEG_INFINITY, f64::INFINITY),
            Flap::Gate(_) => (0.0, GATE_MAX_RAD),
        }
    }
}
