//! What good players do, on the real table's lower half: each technique is a recorded input that succeeds at its timing
//! and fails outside of its window. Nothing in the machine knows of any of them.

mod bounce;
mod cabinet;
mod catch;
mod cradle;
mod pass;
mod plunge;
mod shot;

use geometry::DVec2;
use physics::{BALL_RADIUS_M, BallPose, Command, Controls, EventKind, Flipper, FlipperControl, Kind, Machine};
use std::sync::{Arc, OnceLock};

pub const NONE: Controls = Controls::NONE;
pub const LEFT: Controls = Controls { left: true, ..NONE };
pub const RIGHT: Controls = Controls { right: true, ..NONE };
pub const BOTH: Controls = Controls { left: true, right: true, ..NONE };

/// What the hands do, each for so many milliseconds.
pub type Input = [(usize, Controls)];

/// Spectrum with its coils live, and what has happened on it.
#[derive(Clone)]
pub struct Play {
    pub machine: Machine,
    /// The switches that have closed, by name.
    pub switches: Vec<String>,
    /// How often the tilt bob has touched its ring.
    pub bob: usize,
}

impl Play {
    pub fn new() -> Play {
        static FRESH: OnceLock<Machine> = OnceLock::new();
        let machine = FRESH.get_or_init(|| {
            let table = game::storage::tables::load("spectrum").expect("the table is sound");
            let mut machine = Machine::new(Arc::new(table.layout.clone())).expect("the table can be played");
            machine.tick(NONE, &[Command::SetFlippers(true), Command::SetCoils(true)]);
            machine
        });
        Play { machine: machine.clone(), switches: Vec::new(), bob: 0 }
    }

    /// A ball that rolls without slip: its centre in mm, its velocity in m/s.
    pub fn ball(mut self, center_mm: (f64, f64), velocity: (f64, f64)) -> Play {
        let (center, (x, y)) = (DVec2::new(center_mm.0, center_mm.1) * 0.001, velocity);
        self.machine.put_ball(center, DVec2::new(x, y), [-y / BALL_RADIUS_M, x / BALL_RADIUS_M, 0.0]);
        self
    }

    /// One ball at rest between the raised left flipper and the guide that leads to it; the button is held.
    pub fn cradled() -> Play {
        static CRADLED: OnceLock<Play> = OnceLock::new();
        let cradled = || Play::new().ball((85.0, 828.0), (0.0, 0.0)).then(&[(9000, LEFT)]);
        let mut play = CRADLED.get_or_init(cradled).clone();
        play.switches.clear();
        play
    }

    pub fn tick(&mut self, hands: Controls) {
        self.machine.tick(hands, &[]);
        for event in self.machine.events() {
            match (event.kind, event.part) {
                (EventKind::Closed, Some(part)) => {
                    self.switches.push(self.machine.layout().parts[usize::from(part.0)].name.clone());
                }
                (EventKind::TiltBob, _) => self.bob += 1,
                _ => {}
            }
        }
    }

    /// Plays the input to its end.
    pub fn then(mut self, input: &Input) -> Play {
        input.iter().for_each(|&(ms, hands)| (0..ms).for_each(|_| self.tick(hands)));
        self
    }

    /// Holds the hands like this until something is so: after how many milliseconds, or `None` if not within `most`.
    pub fn until(&mut self, hands: Controls, most: usize, so: impl Fn(&Play) -> bool) -> Option<usize> {
        (1..=most).find(|_| {
            self.tick(hands);
            so(self)
        })
    }

    /// The first ball, if it has not drained.
    pub fn first(&self) -> Option<BallPose> {
        self.machine.pose().balls.first().copied()
    }

    /// The balls whose centre is in this rectangle, mm.
    pub fn within(&self, x: std::ops::Range<f64>, y: std::ops::Range<f64>) -> Vec<BallPose> {
        let inside = |ball: &BallPose| x.contains(&(ball.center.x * 1e3)) && y.contains(&(ball.center.y * 1e3));
        self.machine.pose().balls.into_iter().filter(inside).collect()
    }

    /// A ball lies on the left flipper, which is held up.
    pub fn is_held_left(&self) -> bool {
        self.within(135.0..205.0, 840.0..900.0).iter().any(is_still)
    }

    /// A ball lies on the right flipper, which is held up.
    pub fn is_held_right(&self) -> bool {
        self.within(265.0..335.0, 840.0..900.0).iter().any(is_still)
    }

    pub fn has_met(&self, switch: &str) -> bool {
        self.switches.iter().any(|name| name == switch)
    }
}

pub fn is_still(ball: &BallPose) -> bool {
    ball.velocity.length() < 1e-3
}

/// The left flipper's numbers.
pub fn left_flipper() -> Flipper {
    let play = Play::new();
    let flipper = |kind: &Kind| matches!(kind, Kind::Flipper(flipper) if flipper.control == FlipperControl::Left);
    let part = play.machine.layout().parts.iter().find(|part| flipper(&part.kind));
    match part.map(|part| part.kind.clone()) {
        Some(Kind::Flipper(flipper)) => flipper,
        _ => panic!("Spectrum has a left flipper"),
    }
}

/// The longest run of neighbours that succeed.
pub fn longest_window(successes: &[bool]) -> usize {
    successes.split(|&success| !success).map(<[bool]>::len).max().unwrap_or(0)
}
