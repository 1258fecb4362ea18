//! Drop target: a target that falls below the playfield when it is hit hard enough, and rises when the rules say so.
//!
//! The target itself is a rigid body in a slot (`crate::mechanisms::rigid_mechanisms`); here is when it falls, rises and
//! stands in the way.

use crate::ball::Ball;
use crate::collision::obstacle::ObstacleRole;
use crate::mechanisms::model::{Model, State};
use crate::mechanisms::rigid_mechanisms::RigidMechanisms;
use crate::part::PartId;
use crate::part::event::Event;
use crate::part::material::Material;
use crate::part::validation::{self, Checked};
use geometry::Shape;
use serde::{Deserialize, Serialize};

/// What a drop target needs to rise, s: no ball may come over it so soon.
const RISE_S: f64 = 0.05;
/// A drop target with more of it above the playfield stands in the ball's way: its top is above the ball's middle.
const STANDING_HEIGHT: f64 = 0.55;

/// A target that falls. Its switch is closed from its fall until it stands again.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct DropTarget {
    /// Its face while it stands.
    pub shape: Shape,
    /// What the face is made of.
    pub material: Material,
    /// Slowest approach that knocks it off its ledge, m/s.
    pub threshold_m_s: f64,
}

/// A drop target's switch and surface.
#[derive(Clone, Debug)]
pub(crate) struct DropTargetModel {
    pub part: PartId,
    /// Slowest approach that knocks it off its ledge, m/s.
    pub threshold: f64,
    /// Its face among the obstacles.
    pub obstacle: usize,
}

/// A drop target, apart from where it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct DropTargetState {
    /// It stands in the ball's way.
    pub solid: bool,
    /// It has left its ledge.
    pub falling: bool,
    pub goal: DropTargetGoal,
}

/// What a drop target is to do.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) enum DropTargetGoal {
    Up,
    Down,
    /// Rise as soon as no ball is in its way.
    Rise,
}

impl DropTarget {
    pub(crate) fn check(&self) -> Checked {
        validation::shape(&self.shape)?;
        validation::not_negative("the threshold", self.threshold_m_s)?;
        validation::material(&self.material)
    }

    pub(crate) fn add_to(&self, part: PartId, model: &mut Model) {
        let (obstacle, index) = (model.collision.obstacles.len(), model.mechanisms.drop_targets.len());
        model.collision.add_obstacle(part, self.shape, self.material, ObstacleRole::DropTarget(index));
        model.mechanisms.drop_targets.push(DropTargetModel { part, threshold: self.threshold_m_s, obstacle });
    }
}

impl DropTargetState {
    pub fn standing() -> DropTargetState {
        DropTargetState { solid: true, falling: false, goal: DropTargetGoal::Up }
    }

    /// A ball has hit it at `approach`, m/s. True if it falls.
    pub fn hit(&mut self, model: &DropTargetModel, approach: f64) -> bool {
        let falls = self.goal == DropTargetGoal::Up && approach >= model.threshold;
        if falls {
            self.goal = DropTargetGoal::Down;
            self.falling = false;
        }
        falls
    }

    /// It is to rise, if it is down.
    pub fn raise(&mut self) {
        if self.goal == DropTargetGoal::Down {
            self.goal = DropTargetGoal::Rise;
            self.solid = false;
            self.falling = false;
        }
    }
}

/// Lets the drop targets fall that were hit, and raises those that are asked to rise and have no ball over them.
pub(crate) fn tick(model: &Model, state: &mut State, rigid: &mut RigidMechanisms, events: &mut Vec<Event>) {
    let targets = model.mechanisms.drop_targets.iter().zip(&mut state.mechanisms.drop_targets);
    for (index, (own, target)) in targets.enumerate() {
        let shape = &model.collision.obstacles[own.obstacle].shape;
        let is_away = |ball: &Ball, time: f64| shape.distance(ball.center).0 > ball.velocity.length() * time;
        // Asked only where it matters: most targets stand, and nothing is to be done.
        let is_clear = |time: f64| state.balls.iter().all(|ball| is_away(ball, time));
        let high = rigid.height(index) > STANDING_HEIGHT;
        match target.goal {
            DropTargetGoal::Rise if is_clear(RISE_S) => {
                target.goal = DropTargetGoal::Up;
                rigid.send(index, true);
            }
            // A ball has come over it while it rose: down again, until it has gone.
            DropTargetGoal::Up if high && !target.solid && !is_clear(0.0) => {
                target.goal = DropTargetGoal::Rise;
                rigid.send(index, false);
            }
            DropTargetGoal::Up if high && !target.solid => {
                target.solid = true;
                events.push(Event::opened(own.part));
            }
            DropTargetGoal::Down if target.solid => {
                if target.falling {
                    target.solid = high;
                } else {
                    target.falling = true;
                    rigid.send(index, false);
                }
            }
            _ => {}
        }
    }
}
