//! The mechanisms that are rigid bodies: spinner plates, gate flaps and drop targets, each in a rapier world of its own.
//!
//! Each moves in its own upright plane, seen from the side: x is the ball's way, y is up, 0 on the playfield. None of them
//! touches another, so each has its own world: what spins costs nothing for what hangs. Refuses to know what a ball is:
//! others read how a body stands and turn it.
//!
//! While a mechanism does not move its world is not stepped. Clones of a machine share a world until one of them must
//! step it.

use crate::TICK_S;
use crate::collision::world::Plan;
use rapier2d::prelude::*;
use serde::{Deserialize, Serialize};
use std::f64::consts::PI;
use std::sync::Arc;

/// Height of the axles of gates and spinners, m: a ball passes below.
pub(crate) const AXLE_M: f64 = 0.030;
/// From a plate's or flap's axle to its edge, m.
pub(crate) const BLADE_M: f64 = 0.021;
/// A spinner's plate: thin steel, 42 x 30 mm.
const PLATE_KG: f64 = 0.007;
/// A gate's flap: bent wire.
const FLAP_KG: f64 = 0.002;
/// How far below its axle a spinner's plate has its middle: it comes to rest hanging.
const PLATE_HANG_M: f64 = 0.0005;
/// How far a flap opens, rad.
const FLAP_MOST_RAD: f64 = 1.45;
/// Turning speed that a flap loses, 1/s.
const FLAP_DAMPING_PER_S: f64 = 3.0;
/// How far a drop target falls, m.
const FALL_M: f64 = 0.030;
/// Mass of a drop target.
const TARGET_KG: f64 = 0.02;
/// Natural frequency of the spring that pulls a target down and of the coil that raises it, rad/s.
const DOWN_RAD_S: f64 = 40.0;
const UP_RAD_S: f64 = 120.0;
/// Ticks without motion after which a world stands still.
const QUIET_TICKS: u16 = 250;
/// Slower than this is no motion: m/s, and rad/s.
const QUIET: f32 = 2e-3;
/// Parts that rapier divides a tick into: stops and springs need them.
const ROUNDS: usize = 4;
/// A spinner's plate meets no stop and is nearly balanced; it spins for many seconds after every ball.
const SPINNER_ROUNDS: usize = 1;

/// A mechanism: all that rapier knows of it.
#[derive(Clone, Serialize, Deserialize)]
struct World {
    islands: IslandManager,
    broad_phase: BroadPhaseBvh,
    narrow_phase: NarrowPhase,
    bodies: RigidBodySet,
    colliders: ColliderSet,
    joints: ImpulseJointSet,
    multibodies: MultibodyJointSet,
    soft_bodies: SoftBodySet,
    /// The one body that moves.
    body: RigidBodyHandle,
    /// Its axle or slot.
    joint: ImpulseJointHandle,
    /// From hanging, rad; goes on past a turn. 0 of what does not turn.
    angle: f64,
    /// Ticks that the world is still stepped if nothing moves it.
    awake: u16,
    #[serde(skip)]
    engine: Engine,
}

/// The body of a plate or flap, counted by kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Plate {
    Spinner(usize),
    Gate(usize),
}

/// All rigid bodies.
#[derive(Clone)]
pub(crate) struct Works {
    spinners: Vec<Arc<World>>,
    gates: Vec<Arc<World>>,
    drops: Vec<Arc<World>>,
}

/// What rapier works with. It remembers from step to step which world it worked on, so each world has its own; a new one
/// goes on exactly as an old one does.
struct Engine {
    pipeline: PhysicsPipeline,
    ccd: CCDSolver,
}

impl Default for Engine {
    fn default() -> Engine {
        Engine { pipeline: PhysicsPipeline::new(), ccd: CCDSolver::new() }
    }
}

impl Clone for Engine {
    fn clone(&self) -> Engine {
        Engine::default()
    }
}

impl std::fmt::Debug for Works {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let awake: Vec<u16> = self.worlds().map(|world| world.awake).collect();
        f.debug_struct("Works").field("awake", &awake).finish_non_exhaustive()
    }
}

impl Plate {
    /// Moment of inertia about the axle, kg m^2.
    pub fn inertia(self) -> f64 {
        match self {
            Plate::Spinner(_) => PLATE_KG * (2.0 * BLADE_M) * (2.0 * BLADE_M) / 12.0,
            Plate::Gate(_) => FLAP_KG * BLADE_M * BLADE_M / 3.0,
        }
    }

    /// The angles that it can take, rad.
    pub fn range(self) -> (f64, f64) {
        match self {
            Plate::Spinner(_) => (f64::NEG_INFINITY, f64::INFINITY),
            Plate::Gate(_) => (0.0, FLAP_MOST_RAD),
        }
    }
}

impl Works {
    /// Everything hanging, every target up.
    pub fn new(plan: &Plan) -> Works {
        let spinner = |damping| World::turning(PLATE_KG, PLATE_HANG_M, Plate::Spinner(0), damping);
        let gate = || World::turning(FLAP_KG, 0.5 * BLADE_M, Plate::Gate(0), FLAP_DAMPING_PER_S);
        Works {
            spinners: plan.spinners.iter().map(|(_, numbers)| Arc::new(spinner(numbers.damping_per_s))).collect(),
            gates: plan.gates.iter().map(|_| Arc::new(gate())).collect(),
            drops: plan.drops.iter().map(|_| Arc::new(World::sliding())).collect(),
        }
    }

    fn worlds(&self) -> impl Iterator<Item = &World> {
        self.spinners.iter().chain(&self.gates).chain(&self.drops).map(|world| &**world)
    }

    fn plate(&self, plate: Plate) -> &World {
        match plate {
            Plate::Spinner(index) => &self.spinners[index],
            Plate::Gate(index) => &self.gates[index],
        }
    }

    /// The angle of a plate from hanging, rad; positive where its lower edge has gone the ball's way.
    pub fn angle(&self, plate: Plate) -> f64 {
        self.plate(plate).angle
    }

    /// How fast a plate turns, rad/s.
    pub fn turn(&self, plate: Plate) -> f64 {
        let world = self.plate(plate);
        f64::from(world.bodies[world.body].angvel())
    }

    /// Gives a plate an angular impulse about its axle, N m s.
    pub fn push(&mut self, plate: Plate, impulse: f64) {
        let world = match plate {
            Plate::Spinner(index) => &mut self.spinners[index],
            Plate::Gate(index) => &mut self.gates[index],
        };
        Arc::make_mut(world).push(plate, impulse);
    }

    /// How far up a drop target stands: 1 is up, 0 is flush with the playfield.
    pub fn height(&self, drop: usize) -> f64 {
        let world = &self.drops[drop];
        let sunk = -f64::from(world.bodies[world.body].translation().y);
        (1.0 - sunk / FALL_M).clamp(0.0, 1.0)
    }

    /// Lets a drop target fall, or raises it.
    pub fn send(&mut self, drop: usize, up: bool) {
        let world = Arc::make_mut(&mut self.drops[drop]);
        world.awake = QUIET_TICKS;
        let (place, frequency) = if up { (0.0, UP_RAD_S) } else { (-FALL_M, DOWN_RAD_S) };
        if let Some(joint) = world.joints.get_mut(world.joint, true) {
            let (stiffness, damping) = (frequency * frequency, 2.0 * frequency);
            joint.data.set_motor_position(JointAxis::LinX, place as f32, stiffness as f32, damping as f32);
        }
    }

    /// One tick. Calls `half_turn` once for each half turn that a spinner's plate makes.
    pub fn tick(&mut self, mut half_turn: impl FnMut(usize)) {
        for (index, spinner) in self.spinners.iter_mut().enumerate().filter(|(_, world)| world.awake > 0) {
            let spinner = Arc::make_mut(spinner);
            let before = half_turns(spinner.angle);
            spinner.step(SPINNER_ROUNDS);
            spinner.follow();
            let turned = half_turns(spinner.angle).abs_diff(before);
            (0..turned).for_each(|_| half_turn(index));
        }
        for gate in self.gates.iter_mut().filter(|world| world.awake > 0) {
            let gate = Arc::make_mut(gate);
            gate.step(ROUNDS);
            gate.follow();
        }
        for drop in self.drops.iter_mut().filter(|world| world.awake > 0) {
            Arc::make_mut(drop).step(ROUNDS);
        }
    }

    /// The state as bytes.
    pub fn save(&self) -> Vec<u8> {
        let all = |worlds: &[Arc<World>]| -> Vec<World> { worlds.iter().map(|world| (**world).clone()).collect() };
        postcard::to_stdvec(&[all(&self.spinners), all(&self.gates), all(&self.drops)]).unwrap_or_default()
    }

    /// The worlds that `save` wrote, if they fit the plan.
    pub fn restore(plan: &Plan, bytes: &[u8]) -> Option<Works> {
        let worlds: [Vec<World>; 3] = postcard::from_bytes(bytes).ok()?;
        let counts = [plan.spinners.len(), plan.gates.len(), plan.drops.len()];
        let whole = |world: &World| world.bodies.get(world.body).is_some() && world.joints.get(world.joint).is_some();
        let fits = worlds.iter().zip(counts).all(|(own, count)| own.len() == count && own.iter().all(whole));
        let [spinners, gates, drops] = worlds.map(|own| own.into_iter().map(Arc::new).collect());
        fits.then_some(Works { spinners, gates, drops })
    }

    /// Where every body is and how it moves.
    pub fn motion(&self) -> Vec<(u16, f64, [f32; 6])> {
        let motion = |world: &World| {
            let body = &world.bodies[world.body];
            let (place, turned, speed) = (body.translation(), body.rotation(), body.linvel());
            (world.awake, world.angle, [place.x, place.y, turned.im, speed.x, speed.y, body.angvel()])
        };
        self.worlds().map(motion).collect()
    }
}

/// How many times a plate at `angle` has been through upright, from hanging.
fn half_turns(angle: f64) -> i64 {
    (angle / PI + 0.5).floor() as i64
}

impl World {
    /// A body whose axle or slot is at `place`, on a joint.
    fn new(place: Vector, body: RigidBodyBuilder, joint: impl Into<GenericJoint>) -> World {
        let (mut bodies, mut joints) = (RigidBodySet::new(), ImpulseJointSet::new());
        let body = bodies.insert(body.translation(place).can_sleep(false));
        let fixed = bodies.insert(RigidBodyBuilder::fixed().translation(place));
        let joint = joints.insert(fixed, body, joint, true);
        World {
            islands: IslandManager::new(),
            broad_phase: BroadPhaseBvh::default(),
            narrow_phase: NarrowPhase::new(),
            bodies,
            colliders: ColliderSet::new(),
            joints,
            multibodies: MultibodyJointSet::new(),
            soft_bodies: SoftBodySet::new(),
            body,
            joint,
            angle: 0.0,
            awake: 0,
            engine: Engine::default(),
        }
    }

    fn turning(mass: f64, hang: f64, plate: Plate, damping: f64) -> World {
        let own_inertia = plate.inertia() - mass * hang * hang;
        let middle = Vector::new(0.0, -hang as f32);
        let body = RigidBodyBuilder::dynamic()
            .additional_mass_properties(MassProperties::new(middle, mass as f32, own_inertia as f32))
            .angular_damping(damping as f32);
        let mut joint = RevoluteJointBuilder::new();
        let (low, high) = plate.range();
        if low.is_finite() {
            joint = joint.limits([low as f32, high as f32]);
        }
        World::new(Vector::new(0.0, AXLE_M as f32), body, joint.build())
    }

    fn sliding() -> World {
        let properties = MassProperties::new(Vector::ZERO, TARGET_KG as f32, 1e-5);
        let body = RigidBodyBuilder::dynamic().additional_mass_properties(properties);
        let (stiffness, damping) = ((UP_RAD_S * UP_RAD_S) as f32, (2.0 * UP_RAD_S) as f32);
        let joint = PrismaticJointBuilder::new(Vector::Y)
            .limits([-FALL_M as f32, 0.0])
            .motor_position(0.0, stiffness, damping)
            .build();
        World::new(Vector::ZERO, body, joint)
    }

    fn push(&mut self, plate: Plate, impulse: f64) {
        self.awake = QUIET_TICKS;
        if let Some(body) = self.bodies.get_mut(self.body) {
            // Set for the whole body at once: the axle's reaction is not left to the solver.
            let turn = body.angvel() + (impulse / plate.inertia()) as f32;
            let axle = Vector::new(0.0, AXLE_M as f32);
            let arm = body.center_of_mass() - Vector::new(body.translation().x, axle.y);
            body.set_angvel(turn, true);
            body.set_linvel(Vector::new(-arm.y, arm.x) * turn, true);
        }
    }

    /// Takes the angle over from rapier, which keeps it within a turn.
    fn follow(&mut self) {
        let rotation = self.bodies[self.body].rotation();
        let now = libm::atan2(f64::from(rotation.im), f64::from(rotation.re));
        let turn = 2.0 * PI;
        let change = now - self.angle;
        self.angle += change - turn * (change / turn).round();
    }

    fn step(&mut self, rounds: usize) {
        let own = IntegrationParameters::default();
        let parameters = IntegrationParameters { dt: TICK_S as f32, num_solver_iterations: rounds, ..own };
        self.engine.pipeline.step(
            Vector::new(0.0, -9.81),
            &parameters,
            &mut self.islands,
            &mut self.broad_phase,
            &mut self.narrow_phase,
            &mut self.bodies,
            &mut self.colliders,
            &mut self.joints,
            &mut self.multibodies,
            &mut self.soft_bodies,
            &mut self.engine.ccd,
            &(),
            &(),
        );
        let body = &self.bodies[self.body];
        let moves = body.linvel().length() > QUIET || body.angvel().abs() > 100.0 * QUIET;
        self.awake = if moves { QUIET_TICKS } else { self.awake - 1 };
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn clones_at_every_tick_go_on_as_the_original_does() {
        let spinner = World::turning(PLATE_KG, PLATE_HANG_M, Plate::Spinner(0), 0.7);
        let gate = World::turning(FLAP_KG, 0.5 * BLADE_M, Plate::Gate(0), FLAP_DAMPING_PER_S);
        let (spinners, gates) = (vec![Arc::new(spinner)], vec![Arc::new(gate)]);
        let mut works = Works { spinners, gates, drops: vec![Arc::new(World::sliding())] };
        works.push(Plate::Spinner(0), 1e-4);
        works.push(Plate::Gate(0), 1e-5);
        works.send(0, false);
        let mut cloned = works.clone();
        for tick in 0..3000 {
            let before = cloned.clone();
            cloned.tick(|_| {});
            // It is shared no more, and nothing that moves keeps its engine.
            drop(before);
            works.tick(|_| {});
            assert_eq!(works.motion(), cloned.motion(), "after {tick} ticks");
        }
        assert_eq!(works.motion()[2].0, 0, "the target has come to rest");
        assert!(works.motion()[0].0 > 0, "while the spinner still turns");
    }

    #[test]
    fn a_spinner_turns_within_a_hundredth_as_far_as_one_that_is_stepped_much_more_finely() {
        for impulse in [2e-6, 1e-5, 3e-5, 1e-4] {
            let new = || {
                let mut world = World::turning(PLATE_KG, PLATE_HANG_M, Plate::Spinner(0), 0.7);
                world.push(Plate::Spinner(0), impulse);
                world
            };
            let (mut play, mut fine) = (new(), new());
            for tick in 0..3000 {
                play.step(SPINNER_ROUNDS);
                fine.step(16);
                play.follow();
                fine.follow();
                let error = (play.angle - fine.angle).abs();
                assert!(error < 0.01 * (fine.angle.abs() + 1.0), "{error} rad after {tick} ticks, {impulse} N m s");
            }
        }
    }
}
