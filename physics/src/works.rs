//! The mechanisms that are rigid bodies: spinner plates, gate flaps and drop targets, in one rapier world.
//!
//! Each moves in its own upright plane, seen from the side: x is the ball's way, y is up, 0 on the playfield. The planes
//! lie side by side in the one world, out of each other's reach. Refuses to know what a ball is: others read how a body
//! stands and turn it.
//!
//! While nothing moves the world is not stepped. Clones of a machine share the world until one of them must step it.

use crate::TICK_S;
use crate::plan::Plan;
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
/// Ticks without motion after which the world stands still.
const QUIET_TICKS: u16 = 250;
/// Slower than this is no motion: m/s, and rad/s.
const QUIET: f32 = 2e-3;

/// What rapier knows.
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
    spinners: Vec<Turning>,
    gates: Vec<Turning>,
    drops: Vec<Sliding>,
    /// Ticks that the world is still stepped if nothing moves it.
    awake: u16,
}

/// A body on an axle.
#[derive(Clone, Copy, Serialize, Deserialize)]
struct Turning {
    body: RigidBodyHandle,
    /// From hanging, rad; goes on past a turn.
    angle: f64,
}

/// A body in an upright slot.
#[derive(Clone, Copy, Serialize, Deserialize)]
struct Sliding {
    body: RigidBodyHandle,
    joint: ImpulseJointHandle,
}

/// The body of a plate or flap, counted by kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Plate {
    Spinner(usize),
    Gate(usize),
}

/// All rigid bodies.
pub(crate) struct Works {
    world: Arc<World>,
    pipeline: PhysicsPipeline,
    ccd: CCDSolver,
}

impl Clone for Works {
    fn clone(&self) -> Works {
        Works::around(Arc::clone(&self.world))
    }
}

impl std::fmt::Debug for Works {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Works").field("awake", &self.world.awake).finish_non_exhaustive()
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
        let mut world = World {
            islands: IslandManager::new(),
            broad_phase: BroadPhaseBvh::default(),
            narrow_phase: NarrowPhase::new(),
            bodies: RigidBodySet::new(),
            colliders: ColliderSet::new(),
            joints: ImpulseJointSet::new(),
            multibodies: MultibodyJointSet::new(),
            soft_bodies: SoftBodySet::new(),
            spinners: Vec::new(),
            gates: Vec::new(),
            drops: Vec::new(),
            awake: 0,
        };
        for (_, spinner) in &plan.spinners {
            let turning = world.add_turning(PLATE_KG, PLATE_HANG_M, Plate::Spinner(0), spinner.damping_per_s);
            world.spinners.push(turning);
        }
        for _ in &plan.gates {
            let turning = world.add_turning(FLAP_KG, 0.5 * BLADE_M, Plate::Gate(0), FLAP_DAMPING_PER_S);
            world.gates.push(turning);
        }
        for _ in &plan.drops {
            let sliding = world.add_sliding();
            world.drops.push(sliding);
        }
        Works::around(Arc::new(world))
    }

    fn around(world: Arc<World>) -> Works {
        Works { world, pipeline: PhysicsPipeline::new(), ccd: CCDSolver::new() }
    }

    fn turning(&self, plate: Plate) -> &Turning {
        match plate {
            Plate::Spinner(index) => &self.world.spinners[index],
            Plate::Gate(index) => &self.world.gates[index],
        }
    }

    /// The angle of a plate from hanging, rad; positive where its lower edge has gone the ball's way.
    pub fn angle(&self, plate: Plate) -> f64 {
        self.turning(plate).angle
    }

    /// How fast a plate turns, rad/s.
    pub fn turn(&self, plate: Plate) -> f64 {
        f64::from(self.world.bodies[self.turning(plate).body].angvel())
    }

    /// Gives a plate an angular impulse about its axle, N m s.
    pub fn push(&mut self, plate: Plate, impulse: f64) {
        let body = self.turning(plate).body;
        let world = Arc::make_mut(&mut self.world);
        world.awake = QUIET_TICKS;
        if let Some(body) = world.bodies.get_mut(body) {
            // Set for the whole body at once: the axle's reaction is not left to the solver.
            let turn = body.angvel() + (impulse / plate.inertia()) as f32;
            let axle = Vector::new(0.0, AXLE_M as f32);
            let arm = body.center_of_mass() - Vector::new(body.translation().x, axle.y);
            body.set_angvel(turn, true);
            body.set_linvel(Vector::new(-arm.y, arm.x) * turn, true);
        }
    }

    /// How far up a drop target stands: 1 is up, 0 is flush with the playfield.
    pub fn height(&self, drop: usize) -> f64 {
        let sunk = -f64::from(self.world.bodies[self.world.drops[drop].body].translation().y);
        (1.0 - sunk / FALL_M).clamp(0.0, 1.0)
    }

    /// Lets a drop target fall, or raises it.
    pub fn send(&mut self, drop: usize, up: bool) {
        let joint = self.world.drops[drop].joint;
        let world = Arc::make_mut(&mut self.world);
        world.awake = QUIET_TICKS;
        let (place, frequency) = if up { (0.0, UP_RAD_S) } else { (-FALL_M, DOWN_RAD_S) };
        if let Some(joint) = world.joints.get_mut(joint, true) {
            let (stiffness, damping) = (frequency * frequency, 2.0 * frequency);
            joint.data.set_motor_position(JointAxis::LinX, place as f32, stiffness as f32, damping as f32);
        }
    }

    /// One tick. Calls `half_turn` once for each half turn that a spinner's plate makes.
    pub fn tick(&mut self, mut half_turn: impl FnMut(usize)) {
        if self.world.awake == 0 {
            return;
        }
        let world = Arc::make_mut(&mut self.world);
        world.step(&mut self.pipeline, &mut self.ccd);
        for (index, spinner) in world.spinners.iter_mut().enumerate() {
            let before = half_turns(spinner.angle);
            spinner.follow(&world.bodies);
            let turned = half_turns(spinner.angle).abs_diff(before);
            (0..turned).for_each(|_| half_turn(index));
        }
        world.gates.iter_mut().for_each(|gate| gate.follow(&world.bodies));
    }

    /// The state as bytes.
    pub fn save(&self) -> Vec<u8> {
        postcard::to_stdvec(&*self.world).unwrap_or_default()
    }

    /// The world that `save` wrote, if it fits the plan.
    pub fn restore(plan: &Plan, bytes: &[u8]) -> Option<Works> {
        let world: World = postcard::from_bytes(bytes).ok()?;
        let all = |turning: &[Turning], count| {
            turning.len() == count && turning.iter().all(|one| world.bodies.get(one.body).is_some())
        };
        let slides = |one: &Sliding| world.bodies.get(one.body).is_some() && world.joints.get(one.joint).is_some();
        let fits = all(&world.spinners, plan.spinners.len())
            && all(&world.gates, plan.gates.len())
            && world.drops.len() == plan.drops.len()
            && world.drops.iter().all(slides);
        fits.then(|| Works::around(Arc::new(world)))
    }

    /// Where every body is and how it moves.
    pub fn motion(&self) -> (u16, Vec<(f64, [f32; 6])>) {
        let turning = self.world.spinners.iter().chain(&self.world.gates).map(|one| (one.angle, one.body));
        let bodies = turning.chain(self.world.drops.iter().map(|one| (0.0, one.body)));
        let motion = bodies.map(|(angle, body)| {
            let body = &self.world.bodies[body];
            let (place, turned, speed) = (body.translation(), body.rotation(), body.linvel());
            (angle, [place.x, place.y, turned.im, speed.x, speed.y, body.angvel()])
        });
        (self.world.awake, motion.collect())
    }
}

/// How many times a plate at `angle` has been through upright, from hanging.
fn half_turns(angle: f64) -> i64 {
    (angle / PI + 0.5).floor() as i64
}

impl Turning {
    /// Takes the angle over from rapier, which keeps it within a turn.
    fn follow(&mut self, bodies: &RigidBodySet) {
        let rotation = bodies[self.body].rotation();
        let now = libm::atan2(f64::from(rotation.im), f64::from(rotation.re));
        let turn = 2.0 * PI;
        let change = now - self.angle;
        self.angle += change - turn * (change / turn).round();
    }
}

impl World {
    fn count(&self) -> usize {
        self.spinners.len() + self.gates.len() + self.drops.len()
    }

    /// Where the next plane lies, m.
    fn plane(&self) -> f32 {
        self.count() as f32
    }

    fn add_body(&mut self, place: Vector, middle: Vector, mass: f64, inertia: f64, damping: f64) -> RigidBodyHandle {
        let properties = MassProperties::new(middle, mass as f32, inertia as f32);
        let body = RigidBodyBuilder::dynamic()
            .translation(place)
            .additional_mass_properties(properties)
            .angular_damping(damping as f32)
            .can_sleep(false);
        self.bodies.insert(body)
    }

    fn add_turning(&mut self, mass: f64, hang: f64, plate: Plate, damping: f64) -> Turning {
        let place = Vector::new(self.plane(), AXLE_M as f32);
        let own_inertia = plate.inertia() - mass * hang * hang;
        let body = self.add_body(place, Vector::new(0.0, -hang as f32), mass, own_inertia, damping);
        let axle = self.bodies.insert(RigidBodyBuilder::fixed().translation(place));
        let mut joint = RevoluteJointBuilder::new();
        let (low, high) = plate.range();
        if low.is_finite() {
            joint = joint.limits([low as f32, high as f32]);
        }
        self.joints.insert(axle, body, joint.build(), true);
        Turning { body, angle: 0.0 }
    }

    fn add_sliding(&mut self) -> Sliding {
        let place = Vector::new(self.plane(), 0.0);
        let body = self.add_body(place, Vector::ZERO, TARGET_KG, 1e-5, 0.0);
        let slot = self.bodies.insert(RigidBodyBuilder::fixed().translation(place));
        let (stiffness, damping) = ((UP_RAD_S * UP_RAD_S) as f32, (2.0 * UP_RAD_S) as f32);
        let joint = PrismaticJointBuilder::new(Vector::Y)
            .limits([-FALL_M as f32, 0.0])
            .motor_position(0.0, stiffness, damping)
            .build();
        let joint = self.joints.insert(slot, body, joint, true);
        Sliding { body, joint }
    }

    fn step(&mut self, pipeline: &mut PhysicsPipeline, ccd: &mut CCDSolver) {
        let parameters = IntegrationParameters { dt: TICK_S as f32, ..IntegrationParameters::default() };
        pipeline.step(
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
            ccd,
            &(),
            &(),
        );
        let moves = |body: &RigidBody| {
            body.is_dynamic() && (body.linvel().length() > QUIET || body.angvel().abs() > 100.0 * QUIET)
        };
        let moving = self.bodies.iter().any(|(_, body)| moves(body));
        self.awake = if moving { QUIET_TICKS } else { self.awake - 1 };
    }
}
