//! Diagnostics: what can be seen of a machine from outside: poses, stuck balls, penetration, escaped balls.

use crate::BALL_RADIUS_M;
use crate::ball::Ball;
use crate::ball::pose::BallPose;
use crate::collision::obstacle::ObstacleRole;
use crate::machine::Machine;
use crate::mechanisms;
use crate::mechanisms::pose::{Pose, balls_in_play};
use crate::mechanisms::ramp_path::RampPath;
use crate::part::PartId;
use geometry::DVec2;

impl Machine {
    /// Where everything is now.
    pub fn pose(&self) -> Pose {
        Pose::of(&self.model, &self.state, &self.rigid)
    }

    /// Where the balls in play are now: the `balls` of [`Machine::pose`], without the rest.
    pub fn balls(&self) -> Vec<BallPose> {
        balls_in_play(&self.state).map(Ball::pose).collect()
    }

    /// How long each ball has hardly moved where nothing should hold it, ticks: in the order of [`Pose::balls`]; 0 for
    /// a ball that a mechanism holds: in a saucer, in the plunger lane, on a raised flipper.
    pub fn stuck_ticks(&self) -> Vec<u32> {
        let is_held = |ball: &Ball| mechanisms::holds(&self.model, &self.state, ball);
        let stuck = |ball: &Ball| if is_held(ball) { 0 } else { ball.still_ticks };
        balls_in_play(&self.state).map(stuck).collect()
    }

    /// From which ramp or wire-form a ball goes on to which other: the one and the other of each joint.
    pub fn ramp_joints(&self) -> Vec<(PartId, PartId)> {
        let ramps = &self.model.mechanisms.ramps;
        let part_of = |ramp: &u16| ramps[usize::from(*ramp)].part;
        let joints =
            |ramp: &RampPath| ramp.joined.map(|other| Some((ramp.part, part_of(&other?)))).into_iter().flatten();
        ramps.iter().flat_map(joints).collect()
    }

    /// How deep a ball lies in anything that stands in its way, m; 0 or less where nothing overlaps.
    pub fn penetration_m(&self) -> f64 {
        let own = self.state.balls.iter().enumerate();
        let depths = own.map(|(index, ball)| self.depth_of(ball, &self.state.balls[index + 1..]));
        depths.fold(f64::NEG_INFINITY, f64::max)
    }

    /// The same of one ball; none if it is not there.
    pub fn penetration_of_m(&self, id: u32) -> Option<f64> {
        let balls = &self.state.balls;
        let index = balls.iter().position(|ball| ball.id == id)?;
        let [before, after] = [&balls[..index], &balls[index + 1..]].map(|others| self.depth_of(&balls[index], others));
        Some(before.max(after))
    }

    /// How deep a ball on the playfield would lie at `center` in what never gives way, m; 0 or less where nothing
    /// overlaps. Drop targets, gates, flippers and other balls are left out: they move.
    pub fn depth_in_fixed_m(&self, center: DVec2) -> f64 {
        self.depth_in_obstacles(None, center, |_| false)
    }

    /// How deep a ball lies in obstacles, and in those drop targets that `stands` says.
    fn depth_in_obstacles(&self, ramp: Option<u16>, center: DVec2, stands: impl Fn(usize) -> bool) -> f64 {
        let mut deepest = f64::NEG_INFINITY;
        let collision = &self.model.collision;
        collision.visit_obstacles(ramp, center, center, |obstacle| {
            let obstacle = &collision.obstacles[obstacle];
            let counts = match obstacle.role {
                ObstacleRole::DropTarget(index) => stands(index),
                ObstacleRole::Gate(_) => false,
                _ => true,
            };
            if counts {
                deepest = deepest.max(-obstacle.shape.distance(center).0);
            }
        });
        deepest
    }

    /// How deep a ball lies in obstacles, flippers and these other balls.
    fn depth_of(&self, ball: &Ball, others: &[Ball]) -> f64 {
        let (model, states) = (&self.model, &self.state.mechanisms);
        let mut deepest = self.depth_in_obstacles(ball.ramp, ball.center, |target| states.drop_targets[target].solid);
        for (flipper, state) in model.mechanisms.flippers.iter().zip(&states.flippers).filter(|_| !ball.is_up()) {
            deepest = deepest.max(BALL_RADIUS_M - flipper.outline(state.angle).distance(ball.center).0);
        }
        for other in others.iter().filter(|other| !ball.passes(other)) {
            deepest = deepest.max(2.0 * BALL_RADIUS_M - ball.center.distance(other.center));
        }
        deepest
    }

    /// How often the impulse of a contact was found in the last tick: what touches each other, round after round. It is
    /// what a tick costs where many balls lie on each other, and the same on every machine.
    pub fn contact_solves(&self) -> u64 {
        self.buffers.contact_solves
    }

    /// How many balls are not on the playfield, or nowhere at all (not a number).
    pub fn escaped(&self) -> usize {
        let size = self.model.size;
        let is_on = |ball: &Ball| {
            ball.center.cmpge(DVec2::ZERO).all() && ball.center.cmple(size).all() && ball.velocity.is_finite()
        };
        self.state.balls.iter().filter(|ball| !is_on(ball)).count()
    }
}
