//! Collision world: all obstacles and triggers of a machine, each sorted into a uniform grid (the broad phase).
//!
//! Made once, shared by every clone of a machine, changed by none.

use crate::collision::grid::Grid;
use crate::collision::obstacle::{Obstacle, ObstacleRole};
use crate::collision::trigger::{Trigger, TriggerKind};
use crate::part::PartId;
use crate::part::material::Material;
use geometry::{DVec2, Shape};
use std::ops::Range;

/// Contact skin, m: a slow ball that is nearer than this touches. A hair's width, far above what a step's rounding and
/// the tolerance of a time of impact can open, far below what is seen.
pub(crate) const SKIN_M: f64 = 25e-6;

/// What stands still in the way of balls, and where their centres close switches.
#[derive(Clone, Debug)]
pub(crate) struct CollisionWorld {
    pub obstacles: Vec<Obstacle>,
    pub triggers: Vec<Trigger>,
    /// For each ramp the obstacles that only a ball on it meets: they stand in no grid.
    pub ramp_sides: Vec<Range<usize>>,
    obstacle_grid: Grid,
    trigger_grid: Grid,
}

impl CollisionWorld {
    /// Without anything in it.
    pub fn empty(size: DVec2) -> CollisionWorld {
        let empty = Grid::new(size, std::iter::empty(), 0.0);
        CollisionWorld {
            obstacles: Vec::new(),
            triggers: Vec::new(),
            ramp_sides: Vec::new(),
            obstacle_grid: empty.clone(),
            trigger_grid: empty,
        }
    }

    pub fn add_obstacle(&mut self, part: PartId, shape: Shape, material: Material, role: ObstacleRole) {
        self.obstacles.push(Obstacle::new(part, shape, material, role));
    }

    pub fn add_trigger(&mut self, part: PartId, shape: Shape, kind: TriggerKind) {
        self.triggers.push(Trigger { part, shape, kind });
    }

    /// Sorts everything that has been added into the grids. What is added to the obstacles after it is on a ramp.
    pub fn sort(&mut self, size: DVec2) {
        self.obstacle_grid = Grid::new(size, self.obstacles.iter().map(|obstacle| &obstacle.shape), SKIN_M);
        self.trigger_grid = Grid::new(size, self.triggers.iter().map(|trigger| &trigger.shape), 0.0);
    }

    /// Calls `visit` with every obstacle that may be near the straight path of a ball on this ramp, or on the playfield,
    /// perhaps more than once.
    pub fn visit_obstacles(&self, ramp: Option<u16>, from: DVec2, to: DVec2, mut visit: impl FnMut(usize)) {
        match ramp {
            None => self.obstacle_grid.visit(from, to, visit),
            Some(ramp) => self.ramp_sides[usize::from(ramp)].clone().for_each(&mut visit),
        }
    }

    /// Calls `visit` with every trigger that may be near the straight path of a ball, perhaps more than once.
    pub fn visit_triggers(&self, from: DVec2, to: DVec2, visit: impl FnMut(usize)) {
        self.trigger_grid.visit(from, to, visit);
    }
}
