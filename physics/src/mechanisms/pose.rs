//! Pose: where everything is, as a picture, a bot or a debug overlay needs to know.

use crate::ball::Ball;
use crate::ball::pose::BallPose;
use crate::mechanisms::flap::Flap;
use crate::mechanisms::kind::Kind;
use crate::mechanisms::model::{Model, State};
use crate::mechanisms::rigid_mechanisms::RigidMechanisms;
use crate::mechanisms::{kicker, magnet};
use crate::part::PartId;
use geometry::DVec2;

/// Where everything that moves is at the end of a tick.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Pose {
    /// The balls in play, in the order in which they came; a ball that a saucer holds is among them.
    pub balls: Vec<BallPose>,
    /// The captive balls, which are not in play.
    pub captives: Vec<(PartId, BallPose)>,
    /// The angle at which each flipper and each diverter points, rad.
    pub flippers_rad: Vec<(PartId, f64)>,
    /// Torque of each flipper's coil less that of its spring, N m: positive lifts it.
    pub flipper_torques_n_m: Vec<(PartId, f64)>,
    /// How far up each drop target stands: 1 is up, 0 is flush with the playfield.
    pub drop_targets: Vec<(PartId, f64)>,
    /// The angle of each spinner's plate from hanging, rad.
    pub spinners_rad: Vec<(PartId, f64)>,
    /// The angle of each gate's flap from closed, rad, 0 or more.
    pub gates_rad: Vec<(PartId, f64)>,
    /// How far each bumper's ring is pulled down and each slingshot's arm and kickback's rod is out, 0 to 1.
    pub extensions: Vec<(PartId, f64)>,
    /// Whether each magnet pulls.
    pub magnets: Vec<(PartId, bool)>,
    /// How far the plunger is pulled, 0 to 1.
    pub plunger: f64,
    /// How far the cabinet has moved from where it stands, m.
    pub cabinet_m: DVec2,
}

/// The balls in play.
pub(crate) fn balls_in_play(state: &State) -> impl Iterator<Item = &Ball> {
    state.balls.iter().filter(|ball| ball.captive().is_none())
}

impl Pose {
    /// Where everything is now.
    pub(crate) fn of(model: &Model, state: &State, rigid: &RigidMechanisms) -> Pose {
        let (models, states) = (&model.mechanisms, &state.mechanisms);
        let flippers = || models.flippers.iter().zip(&states.flippers);
        let captive = |ball: &Ball| Some((models.captive_balls[ball.captive()?].part, ball.pose()));
        let angle = |part: PartId, flap: Flap| (part, rigid.angle(flap));
        let spinners = models.spinners.iter().enumerate();
        let gates = models.gates.iter().enumerate();
        let targets = models.drop_targets.iter().enumerate();
        Pose {
            balls: balls_in_play(state).map(Ball::pose).collect(),
            captives: state.balls.iter().filter_map(captive).collect(),
            flippers_rad: flippers().map(|(flipper, state)| (flipper.part, state.angle)).collect(),
            flipper_torques_n_m: flippers().map(|(flipper, state)| (flipper.part, flipper.lift(state))).collect(),
            drop_targets: targets.map(|(index, target)| (target.part, rigid.height(index))).collect(),
            spinners_rad: spinners.map(|(index, own)| angle(own.part, Flap::Spinner(index))).collect(),
            gates_rad: gates.map(|(index, own)| angle(own.part, Flap::Gate(index))).collect(),
            extensions: extensions(model, state),
            magnets: magnet::pose(model, states),
            plunger: plunger(model, state),
            cabinet_m: states.cabinet.offset,
        }
    }
}

impl Pose {
    /// Whether a magnet that is on may hold this ball where it is; `kind_of` says what a part is.
    pub fn may_hold<'a>(&self, ball: &BallPose, kind_of: impl Fn(PartId) -> Option<&'a Kind>) -> bool {
        let over = |part: PartId| match kind_of(part) {
            Some(Kind::Magnet(magnet)) => magnet.circle.center.distance(ball.center) < magnet.circle.radius,
            _ => false,
        };
        self.magnets.iter().any(|&(part, on)| on && over(part))
    }
}

/// How far the kickers' arms, then the kickbacks' rods are out.
fn extensions(model: &Model, state: &State) -> Vec<(PartId, f64)> {
    let (models, states) = (&model.mechanisms, &state.mechanisms);
    let kickers = models.kickers.iter().zip(&states.kicker_ticks);
    let kickers = kickers.map(|(kicker, &ticks)| (kicker.part, kicker::extension(ticks)));
    let rods = models.rods.iter().zip(&states.rods).filter(|(model, _)| !model.is_plunger());
    kickers.chain(rods.map(|(model, rod)| (model.part, (-model.pull(rod)).clamp(0.0, 1.0)))).collect()
}

/// How far the plunger is pulled.
fn plunger(model: &Model, state: &State) -> f64 {
    let rods = model.mechanisms.rods.iter().zip(&state.mechanisms.rods);
    let pulls = rods.filter(|(model, _)| model.is_plunger()).map(|(model, rod)| model.pull(rod).max(0.0));
    pulls.fold(0.0, f64::max)
}
