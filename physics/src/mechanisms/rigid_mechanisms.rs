//! Rigid mechanisms: spinner plates, gate flaps and drop targets, each a jointed body in a rapier world of its own.
//!
//! None of them touches another, so each has its own world: what spins costs nothing for what hangs. Refuses to know
//! what a ball is: others read how a body stands and turn it.
//!
//! A mechanism that does not move is not stepped. Clones of a machine share its body until one of them must step it.

use crate::mechanisms::MechanismModels;
use crate::mechanisms::flap::{Flap, GATE_DAMPING_PER_S};
use crate::mechanisms::jointed_body::{BodyMotion, JointedBody};
use std::f64::consts::PI;
use std::sync::Arc;

/// Iterations of rapier's joint solver in a tick: stops and springs need them.
const SOLVER_ITERATIONS: usize = 4;
/// A spinner's plate meets no stop and is nearly balanced; it spins for many seconds after every ball.
const SPINNER_SOLVER_ITERATIONS: usize = 1;

/// All rigid bodies.
#[derive(Clone)]
pub(crate) struct RigidMechanisms {
    spinners: Vec<Arc<JointedBody>>,
    gates: Vec<Arc<JointedBody>>,
    drop_targets: Vec<Arc<JointedBody>>,
}

impl std::fmt::Debug for RigidMechanisms {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let awake: Vec<u16> = self.bodies().map(|body| body.awake).collect();
        f.debug_struct("RigidMechanisms").field("awake", &awake).finish_non_exhaustive()
    }
}

impl RigidMechanisms {
    /// Everything hanging, every target up.
    pub fn new(models: &MechanismModels) -> RigidMechanisms {
        let spinner = |damping| Arc::new(JointedBody::hanging(Flap::Spinner(0), damping));
        let gate = || Arc::new(JointedBody::hanging(Flap::Gate(0), GATE_DAMPING_PER_S));
        RigidMechanisms {
            spinners: models.spinners.iter().map(|own| spinner(own.numbers.damping_per_s)).collect(),
            gates: models.gates.iter().map(|_| gate()).collect(),
            drop_targets: models.drop_targets.iter().map(|_| Arc::new(JointedBody::standing())).collect(),
        }
    }

    fn bodies(&self) -> impl Iterator<Item = &JointedBody> {
        self.spinners.iter().chain(&self.gates).chain(&self.drop_targets).map(|body| &**body)
    }

    fn flap(&self, flap: Flap) -> &JointedBody {
        match flap {
            Flap::Spinner(index) => &self.spinners[index],
            Flap::Gate(index) => &self.gates[index],
        }
    }

    /// The angle of a flap from hanging, rad; positive where its lower edge has gone the ball's way.
    pub fn angle(&self, flap: Flap) -> f64 {
        self.flap(flap).angle
    }

    /// How fast a flap turns, rad/s.
    pub fn angular_velocity(&self, flap: Flap) -> f64 {
        self.flap(flap).angular_velocity()
    }

    /// Gives a flap an angular impulse about its axle, N m s.
    pub fn push(&mut self, flap: Flap, impulse: f64) {
        let body = match flap {
            Flap::Spinner(index) => &mut self.spinners[index],
            Flap::Gate(index) => &mut self.gates[index],
        };
        Arc::make_mut(body).push(flap, impulse);
    }

    /// How far up a drop target stands: 1 is up, 0 is flush with the playfield.
    pub fn height(&self, drop_target: usize) -> f64 {
        self.drop_targets[drop_target].height()
    }

    /// Lets a drop target fall, or raises it.
    pub fn send(&mut self, drop_target: usize, up: bool) {
        Arc::make_mut(&mut self.drop_targets[drop_target]).send(up);
    }

    /// One tick. Calls `half_turn` once for each half turn that a spinner's plate makes.
    pub fn tick(&mut self, mut half_turn: impl FnMut(usize)) {
        for (index, spinner) in self.spinners.iter_mut().enumerate().filter(|(_, body)| body.awake > 0) {
            let spinner = Arc::make_mut(spinner);
            let before = half_turns(spinner.angle);
            spinner.step(SPINNER_SOLVER_ITERATIONS);
            spinner.follow();
            let turned = half_turns(spinner.angle).abs_diff(before);
            (0..turned).for_each(|_| half_turn(index));
        }
        for gate in self.gates.iter_mut().filter(|body| body.awake > 0) {
            let gate = Arc::make_mut(gate);
            gate.step(SOLVER_ITERATIONS);
            gate.follow();
        }
        for target in self.drop_targets.iter_mut().filter(|body| body.awake > 0) {
            Arc::make_mut(target).step(SOLVER_ITERATIONS);
        }
    }

    /// The state as bytes.
    pub fn save(&self) -> Vec<u8> {
        let all =
            |bodies: &[Arc<JointedBody>]| -> Vec<JointedBody> { bodies.iter().map(|body| (**body).clone()).collect() };
        postcard::to_stdvec(&[all(&self.spinners), all(&self.gates), all(&self.drop_targets)]).unwrap_or_default()
    }

    /// The bodies that `save` wrote, if they fit the models.
    pub fn restore(models: &MechanismModels, bytes: &[u8]) -> Option<RigidMechanisms> {
        let bodies: [Vec<JointedBody>; 3] = postcard::from_bytes(bytes).ok()?;
        let counts = [models.spinners.len(), models.gates.len(), models.drop_targets.len()];
        let mut counted = bodies.iter().zip(counts);
        let fits = counted.all(|(own, count)| own.len() == count && own.iter().all(JointedBody::is_whole));
        let [spinners, gates, drop_targets] = bodies.map(|own| own.into_iter().map(Arc::new).collect());
        fits.then_some(RigidMechanisms { spinners, gates, drop_targets })
    }

    /// Where every body is and how it moves.
    pub fn motion(&self) -> Vec<BodyMotion> {
        self.bodies().map(JointedBody::motion).collect()
    }
}

/// How many times a plate at `angle` has been through upright, from hanging.
fn half_turns(angle: f64) -> i64 {
    (angle / PI + 0.5).floor() as i64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn clones_at_every_tick_go_on_as_the_original_does() {
        let spinner = JointedBody::hanging(Flap::Spinner(0), 0.7);
        let gate = JointedBody::hanging(Flap::Gate(0), GATE_DAMPING_PER_S);
        let (spinners, gates) = (vec![Arc::new(spinner)], vec![Arc::new(gate)]);
        let mut rigid = RigidMechanisms { spinners, gates, drop_targets: vec![Arc::new(JointedBody::standing())] };
        rigid.push(Flap::Spinner(0), 1e-4);
        rigid.push(Flap::Gate(0), 1e-5);
        rigid.send(0, false);
        let mut cloned = rigid.clone();
        for tick in 0..3000 {
            let before = cloned.clone();
            cloned.tick(|_| {});
            // It is shared no more, and nothing that moves keeps its engine.
            drop(before);
            rigid.tick(|_| {});
            assert_eq!(rigid.motion(), cloned.motion(), "after {tick} ticks");
        }
        assert_eq!(rigid.motion()[2].0, 0, "the target has come to rest");
        assert!(rigid.motion()[0].0 > 0, "while the spinner still turns");
    }

    #[test]
    fn a_spinner_turns_within_a_hundredth_as_far_as_one_that_is_stepped_much_more_finely() {
        for impulse in [2e-6, 1e-5, 3e-5, 1e-4] {
            let new = || {
                let mut body = JointedBody::hanging(Flap::Spinner(0), 0.7);
                body.push(Flap::Spinner(0), impulse);
                body
            };
            let (mut play, mut fine) = (new(), new());
            for tick in 0..3000 {
                play.step(SPINNER_SOLVER_ITERATIONS);
                fine.step(16);
                play.follow();
                fine.follow();
                let error = (play.angle - fine.angle).abs();
                assert!(error < 0.01 * (fine.angle.abs() + 1.0), "{error} rad after {tick} ticks, {impulse} N m s");
            }
        }
    }
}
