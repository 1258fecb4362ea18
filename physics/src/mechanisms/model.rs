//! Model and state of a machine: what never changes, and everything that can change what happens next, as plain data.

use crate::ball::Ball;
use crate::ball::floor::Floor;
use crate::collision::obstacle::{Obstacle, ObstacleRole};
use crate::collision::time_of_impact::StraightPath;
use crate::collision::world::CollisionWorld;
use crate::mechanisms::captive_ball;
use crate::mechanisms::{MechanismModels, MechanismStates};
use geometry::DVec2;
use serde::{Deserialize, Serialize};

/// What a layout comes to once it is known that it will be played. Made once, shared by every clone of a machine.
#[derive(Clone, Debug)]
pub(crate) struct Model {
    /// Of the playfield, m.
    pub size: DVec2,
    /// The playfield's own floor.
    pub floor: Floor,
    pub collision: CollisionWorld,
    pub mechanisms: MechanismModels,
}

/// Everything that can change what happens next, but for the rigid mechanisms.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct State {
    /// Captive balls first, then the balls in play in the order in which they came.
    pub balls: Vec<Ball>,
    pub mechanisms: MechanismStates,
}

impl State {
    pub fn new(model: &Model) -> State {
        let balls = captive_ball::balls(&model.mechanisms.captive_balls).collect();
        State { balls, mechanisms: MechanismStates::new(&model.mechanisms) }
    }

    /// Whether the state has as many of everything as the model.
    pub fn fits(&self, model: &Model) -> bool {
        let captives = self.balls.iter().filter_map(Ball::captive);
        captives.eq(0..model.mechanisms.captive_balls.len()) && self.mechanisms.fit(&model.mechanisms)
    }

    /// Whether an obstacle stops a ball on this path, `distance` from touching it at its start: a drop target may be down, and a
    /// gate's flap opens one way.
    #[inline]
    pub fn is_solid(&self, model: &Model, obstacle: &Obstacle, path: &StraightPath, distance: f64) -> bool {
        match obstacle.role {
            ObstacleRole::DropTarget(index) => self.mechanisms.drop_targets[index].solid,
            ObstacleRole::Gate(index) => model.mechanisms.gates[index].numbers.stops(path, distance),
            _ => true,
        }
    }
}
