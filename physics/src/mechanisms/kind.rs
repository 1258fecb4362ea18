//! Kinds: what a part can be, and what the rules can ask of the parts. Two closed enums, and where each case goes.

use crate::mechanisms::model::{Model, State};
use crate::mechanisms::{flipper, kicker, magnet, rod, saucer};
use crate::part::event::Event;
use crate::part::validation::Checked;
use crate::part::{PartId, index_of};
use geometry::{Circle, Shape};
use serde::{Deserialize, Serialize};

pub use crate::mechanisms::captive_ball::CaptiveBall;
pub use crate::mechanisms::drain::Drain;
pub use crate::mechanisms::drop_target::DropTarget;
pub use crate::mechanisms::flipper::{Flipper, FlipperControl};
pub use crate::mechanisms::gate::Gate;
pub use crate::mechanisms::kickback::Kickback;
pub use crate::mechanisms::kicker::{Bumper, Slingshot};
pub use crate::mechanisms::magnet::Magnet;
pub use crate::mechanisms::plunger::Plunger;
pub use crate::mechanisms::ramp::Ramp;
pub use crate::mechanisms::ramp_leg::Leg;
pub use crate::mechanisms::rollover::Rollover;
pub use crate::mechanisms::saucer::Saucer;
pub use crate::mechanisms::spinner::Spinner;
pub use crate::mechanisms::target::Target;
pub use crate::mechanisms::wall::Wall;

/// What a part is.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Kind {
    /// Anything that only stands there: walls, guides, posts, rubbers.
    Wall(Wall),
    /// A flipper, or a diverter: a flap that the rules turn as a flipper's button turns a flipper.
    Flipper(Flipper),
    /// A pop bumper.
    Bumper(Bumper),
    /// The kicking rubber of a slingshot.
    Slingshot(Slingshot),
    /// A standup target.
    Target(Target),
    /// A target that falls below the playfield when it is hit hard enough.
    DropTarget(DropTarget),
    /// A switch under a ball that rolls over it.
    Rollover(Rollover),
    /// A ramp or a wire-form: a path above the playfield.
    Ramp(Ramp),
    /// A flap that lets the ball through one way.
    Gate(Gate),
    /// A plate on a horizontal axle that turns as the ball passes below it.
    Spinner(Spinner),
    /// A hole that holds a ball until it is thrown out.
    Saucer(Saucer),
    /// Where a ball leaves the playfield.
    Drain(Drain),
    /// The spring rod that shoots the ball, and the place where new balls arrive.
    Plunger(Plunger),
    /// A rod that the rules shoot out across a lane.
    Kickback(Kickback),
    /// An electromagnet below the playfield.
    Magnet(Magnet),
    /// A ball that the walls round it keep in its place.
    CaptiveBall(CaptiveBall),
}

impl Kind {
    /// Whether the numbers can be; what is wrong, as one sentence.
    pub(crate) fn check(&self) -> Checked {
        match self {
            Kind::Wall(own) => own.check(),
            Kind::Flipper(own) => own.check(),
            Kind::Bumper(own) => own.check(),
            Kind::Slingshot(own) => own.check(),
            Kind::Target(own) => own.check(),
            Kind::DropTarget(own) => own.check(),
            Kind::Rollover(own) => own.check(),
            Kind::Ramp(own) => own.check(),
            Kind::Gate(own) => own.check(),
            Kind::Spinner(own) => own.check(),
            Kind::Saucer(own) => own.check(),
            Kind::Drain(own) => own.check(),
            Kind::Plunger(own) => own.check(),
            Kind::Kickback(own) => own.check(),
            Kind::Magnet(own) => own.check(),
            Kind::CaptiveBall(own) => own.check(),
        }
    }

    /// Adds what balls meet of this part, and its mechanism, to the model.
    pub(crate) fn add_to(&self, part: PartId, model: &mut Model) {
        match self {
            Kind::Wall(own) => own.add_to(part, model),
            Kind::Flipper(own) => own.add_to(part, model),
            Kind::Bumper(own) => own.add_to(part, model),
            Kind::Slingshot(own) => own.add_to(part, model),
            Kind::Target(own) => own.add_to(part, model),
            Kind::DropTarget(own) => own.add_to(part, model),
            Kind::Rollover(own) => own.add_to(part, model),
            Kind::Ramp(own) => own.add_to(part, model),
            Kind::Gate(own) => own.add_to(part, model),
            Kind::Spinner(own) => own.add_to(part, model),
            Kind::Saucer(own) => own.add_to(part, model),
            Kind::Drain(own) => own.add_to(part, model),
            Kind::Plunger(own) => own.add_to(part, model),
            Kind::Kickback(own) => own.add_to(part, model),
            Kind::Magnet(own) => own.add_to(part, model),
            Kind::CaptiveBall(own) => own.add_to(part, model),
        }
    }

    /// What of it stands still in a ball's way when it stands: not flippers, flaps and rods, which move, nor ramps.
    pub fn surfaces(&self) -> Vec<Shape> {
        match self {
            Kind::Wall(own) => own.shapes.clone(),
            Kind::Target(own) => vec![own.shape],
            Kind::DropTarget(own) => vec![own.shape],
            Kind::Bumper(own) => vec![Shape::disc(own.circle.center, own.circle.radius)],
            Kind::Slingshot(own) => vec![Shape::capsule(own.segment.a, own.segment.b, own.radius_m)],
            _ => Vec::new(),
        }
    }

    /// The most that it pulls a ball along the playfield, m/s^2; none of what pulls no ball.
    pub fn pull_m_s2(&self) -> Option<f64> {
        match self {
            Kind::Magnet(own) => Some(own.pull_m_s2),
            _ => None,
        }
    }

    /// Its switch.
    pub fn switch(&self) -> Switch {
        match self {
            Kind::Wall(_) | Kind::Flipper(_) | Kind::Plunger(_) => Switch::None,
            Kind::DropTarget(_) | Kind::Rollover(_) | Kind::Saucer(_) | Kind::Kickback(_) | Kind::Magnet(_) => {
                Switch::Maintained
            }
            Kind::Bumper(_)
            | Kind::Slingshot(_)
            | Kind::Target(_)
            | Kind::Ramp(_)
            | Kind::Gate(_)
            | Kind::Spinner(_)
            | Kind::Drain(_)
            | Kind::CaptiveBall(_) => Switch::Momentary,
        }
    }

    /// Where it notices a ball without throwing it back, m: over a hole, a switch or a field.
    pub fn sensor(&self) -> Option<Shape> {
        let disc = |circle: Circle| Shape::disc(circle.center, circle.radius);
        match self {
            Kind::Rollover(own) => Some(own.shape),
            Kind::Drain(own) => Some(own.shape),
            Kind::Saucer(own) => Some(disc(own.circle)),
            Kind::Magnet(own) => Some(disc(own.circle)),
            _ => None,
        }
    }
}

/// A part's switch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Switch {
    /// There is none.
    None,
    /// It closes for a moment, and is never told to open.
    Momentary,
    /// It is closed as long as a ball is there, or a target is down.
    Maintained,
}

/// What the rules ask of the machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Command {
    /// Put a new ball in the plunger lane (as soon as its place is free).
    AddBall,
    /// Throw out the ball that this saucer holds, if it holds one.
    Eject(PartId),
    /// Raise this drop target (as soon as no ball is in its way).
    Raise(PartId),
    /// Flippers obey their buttons, or hang down.
    SetFlippers(bool),
    /// Bumpers, slingshots, kickbacks and magnets work, or not.
    SetCoils(bool),
    /// Shoot this kickback's rod out, unless coils are switched off or it is on its way out already.
    Kick(PartId),
    /// Switch this magnet on or off.
    Magnet(PartId, bool),
    /// Turn this diverter to the end of its stroke, or let its spring turn it back.
    Divert(PartId, bool),
    /// Fire every coil once to free a ball that is stuck: bumpers and slingshots throw what lies at them, kickbacks
    /// shoot, saucers throw out what they hold, drop targets rise, magnets are switched off. No switch closes by this
    /// alone.
    BallSearch,
}

impl Command {
    /// Executes the command.
    pub(crate) fn execute(&self, model: &Model, state: &mut State, events: &mut Vec<Event>) {
        let (models, own) = (&model.mechanisms, &mut state.mechanisms);
        match *self {
            Command::AddBall => own.queue = own.queue.saturating_add(1),
            Command::Eject(part) => {
                if let Some(saucer) = index_of(part, &models.saucers) {
                    saucer::eject(model, state, saucer, events);
                }
            }
            Command::Raise(part) => {
                if let Some(target) = models.drop_targets.iter().position(|target| target.part == part) {
                    own.drop_targets[target].raise();
                }
            }
            Command::SetFlippers(live) => own.flippers_enabled = live,
            Command::SetCoils(live) => own.coils_enabled = live,
            Command::Kick(part) => {
                if own.coils_enabled {
                    rod::fire(&models.rods, &mut own.rods, |rod| rod.part == part);
                }
            }
            Command::Magnet(part, on) => magnet::switch(model, own, part, on),
            Command::Divert(part, on) => flipper::divert(models, own, part, on),
            Command::BallSearch => ball_search(model, state, events),
        }
    }
}

/// Fires every coil once, whatever its switch says.
fn ball_search(model: &Model, state: &mut State, events: &mut Vec<Event>) {
    kicker::fire_all(model, state);
    for saucer in 0..model.mechanisms.saucers.len() {
        saucer::eject(model, state, saucer, events);
    }
    state.mechanisms.drop_targets.iter_mut().for_each(|target| target.raise());
    rod::fire(&model.mechanisms.rods, &mut state.mechanisms.rods, |_| true);
    magnet::switch_all_off(&mut state.mechanisms);
}
