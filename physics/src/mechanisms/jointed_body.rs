//! Jointed body: one rigid body on an axle or in a slot, in a rapier world of its own.
//!
//! It moves in its own upright plane, seen from the side: x is the ball's direction, y is up, 0 on the playfield.

use crate::mechanisms::flap::{AXLE_M, Flap};
use crate::{GRAVITY_M_S2, TICK_S};
use rapier2d::prelude::*;
use serde::{Deserialize, Serialize};
use std::f64::consts::PI;

/// How far a drop target falls, m.
const FALL_M: f64 = 0.030;
/// Mass of a drop target, kg.
const TARGET_KG: f64 = 0.02;
/// Its moment of inertia, kg m^2: its slot lets it not turn, and rapier wants one.
const TARGET_INERTIA: f32 = 1e-5;
/// Natural frequency of the spring that pulls a target down, rad/s...
const DOWN_RAD_S: f64 = 40.0;
/// ... and of the coil that raises it. Both are critically damped.
const UP_RAD_S: f64 = 120.0;
/// Ticks without motion after which a body stands still and is not stepped.
const QUIET_TICKS: u16 = 250;
/// A body slower than this does not move, m/s...
const QUIET_M_S: f32 = 2e-3;
/// ... nor does a body that turns more slowly than this, rad/s.
const QUIET_RAD_S: f32 = 100.0 * QUIET_M_S;

/// A mechanism: all that rapier knows of it.
#[derive(Clone, Serialize, Deserialize)]
pub(crate) struct JointedBody {
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
    pub angle: f64,
    /// Ticks that the body is still stepped if nothing moves it.
    pub awake: u16,
    #[serde(skip)]
    engine: Engine,
}

/// Where a body is and how it moves: ticks awake, angle, and rapier's place, rotation and speeds.
pub(crate) type BodyMotion = (u16, f64, [f32; 6]);

/// What rapier rigid with. It remembers from step to step which world it worked on, so each world has its own; a new one
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

impl JointedBody {
    /// A body whose axle or slot is at `place`, on a joint.
    fn new(place: Vector, body: RigidBodyBuilder, joint: impl Into<GenericJoint>) -> JointedBody {
        let (mut bodies, mut joints) = (RigidBodySet::new(), ImpulseJointSet::new());
        let body = bodies.insert(body.translation(place).can_sleep(false));
        let fixed = bodies.insert(RigidBodyBuilder::fixed().translation(place));
        let joint = joints.insert(fixed, body, joint, true);
        JointedBody {
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

    /// A flap that hangs on its axle.
    pub fn hanging(flap: Flap, damping_per_s: f64) -> JointedBody {
        let (mass, hang) = (flap.mass(), flap.hang());
        let own_inertia = flap.inertia() - mass * hang * hang;
        let middle = Vector::new(0.0, -hang as f32);
        let body = RigidBodyBuilder::dynamic()
            .additional_mass_properties(MassProperties::new(middle, mass as f32, own_inertia as f32))
            .angular_damping(damping_per_s as f32);
        let mut joint = RevoluteJointBuilder::new();
        let (low, high) = flap.range();
        if low.is_finite() {
            joint = joint.limits([low as f32, high as f32]);
        }
        JointedBody::new(Vector::new(0.0, AXLE_M as f32), body, joint.build())
    }

    /// A drop target that stands in its slot.
    pub fn standing() -> JointedBody {
        let properties = MassProperties::new(Vector::ZERO, TARGET_KG as f32, TARGET_INERTIA);
        let body = RigidBodyBuilder::dynamic().additional_mass_properties(properties);
        let (stiffness, damping) = ((UP_RAD_S * UP_RAD_S) as f32, (2.0 * UP_RAD_S) as f32);
        let joint = PrismaticJointBuilder::new(Vector::Y)
            .limits([-FALL_M as f32, 0.0])
            .motor_position(0.0, stiffness, damping)
            .build();
        JointedBody::new(Vector::ZERO, body, joint)
    }

    /// Gives a flap an angular impulse about its axle, N m s.
    pub fn push(&mut self, flap: Flap, impulse: f64) {
        self.awake = QUIET_TICKS;
        if let Some(body) = self.bodies.get_mut(self.body) {
            // Set for the whole body at once: the axle's reaction is not left to the solver.
            let turn = body.angvel() + (impulse / flap.inertia()) as f32;
            let axle = Vector::new(0.0, AXLE_M as f32);
            let arm = body.center_of_mass() - Vector::new(body.translation().x, axle.y);
            body.set_angvel(turn, true);
            body.set_linvel(Vector::new(-arm.y, arm.x) * turn, true);
        }
    }

    /// Takes the angle over from rapier, which keeps it within a turn.
    pub fn follow(&mut self) {
        let rotation = self.bodies[self.body].rotation();
        let now = libm::atan2(f64::from(rotation.im), f64::from(rotation.re));
        let turn = 2.0 * PI;
        let change = now - self.angle;
        self.angle += change - turn * (change / turn).round();
    }

    /// One tick, with so many iterations of the joint's solver.
    pub fn step(&mut self, iterations: usize) {
        let own = IntegrationParameters::default();
        let parameters = IntegrationParameters { dt: TICK_S as f32, num_solver_iterations: iterations, ..own };
        self.engine.pipeline.step(
            Vector::new(0.0, -GRAVITY_M_S2 as f32),
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
        let moves = body.linvel().length() > QUIET_M_S || body.angvel().abs() > QUIET_RAD_S;
        self.awake = if moves { QUIET_TICKS } else { self.awake - 1 };
    }

    /// How fast it turns, rad/s.
    pub fn angular_velocity(&self) -> f64 {
        f64::from(self.bodies[self.body].angvel())
    }

    /// How far up a drop target stands: 1 is up, 0 is flush with the playfield.
    pub fn height(&self) -> f64 {
        let sunk = -f64::from(self.bodies[self.body].translation().y);
        (1.0 - sunk / FALL_M).clamp(0.0, 1.0)
    }

    /// Lets a drop target fall, or raises it.
    pub fn send(&mut self, up: bool) {
        self.awake = QUIET_TICKS;
        let (place, frequency) = if up { (0.0, UP_RAD_S) } else { (-FALL_M, DOWN_RAD_S) };
        if let Some(joint) = self.joints.get_mut(self.joint, true) {
            let (stiffness, damping) = (frequency * frequency, 2.0 * frequency);
            joint.data.set_motor_position(JointAxis::LinX, place as f32, stiffness as f32, damping as f32);
        }
    }

    /// Whether what has been read from bytes has all its parts.
    pub fn is_whole(&self) -> bool {
        self.bodies.get(self.body).is_some() && self.joints.get(self.joint).is_some()
    }

    pub fn motion(&self) -> BodyMotion {
        let body = &self.bodies[self.body];
        let (place, turned, speed) = (body.translation(), body.rotation(), body.linvel());
        (self.awake, self.angle, [place.x, place.y, turned.im, speed.x, speed.y, body.angvel()])
    }
}
