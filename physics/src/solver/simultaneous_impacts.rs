//! Balls that are jammed: what presses on each other finds its common speeds at once.
//!
//! Hit after hit would find them too, but in a narrow wedge it takes thousands, each no time after the one before, and
//! time would not go on.

use crate::solver::contact_constraint::Other;
use crate::solver::sweep::{Sweep, bodies};
use geometry::DVec2;

/// Rounds between the balls, at most; each is exact for what does not move.
const ROUNDS: usize = 64;
/// A round that changes no speed by more than this was the last.
const SAME_M_S: f64 = 1e-10;
/// A speed below this is no approach.
const ROUNDING_M_S: f64 = 1e-12;

/// A wall: a ball that touches it must go along `normal` at `least`, m/s, or faster.
#[derive(Clone, Copy, Debug)]
struct Side {
    normal: DVec2,
    least: f64,
}

impl Sweep<'_> {
    /// Ends every approach of what touches, without a bounce; the balls' drive for what is `left` of the step goes into
    /// that at once.
    pub(crate) fn end_jam(&mut self, left: f64) {
        for at in 0..self.scratch.touches.len() {
            let touch = self.scratch.touches[at];
            self.drive_at_once(touch.ball, left);
            if let Other::Ball(other) = touch.other {
                self.drive_at_once(other, left);
            }
        }
        let sides: Vec<Vec<Side>> = (0..self.state.balls.len()).map(|ball| self.sides(ball)).collect();
        let mut all = bodies(self.plan, self.state);
        for _ in 0..ROUNDS {
            let mut change: f64 = 0.0;
            for touch in self.scratch.touches.iter_mut().filter(|touch| !matches!(touch.other, Other::Fixed(_))) {
                touch.release();
                change = change.max(touch.separate(&mut all, 0.0));
            }
            for (ball, sides) in all.balls.iter_mut().zip(&sides) {
                let free = nearest(ball.velocity, sides);
                change = change.max((free - ball.velocity).length());
                ball.velocity = free;
            }
            if change < SAME_M_S {
                break;
            }
        }
    }

    fn drive_at_once(&mut self, ball: usize, left: f64) {
        let motion = &mut self.scratch.motions[ball];
        let drive = std::mem::take(&mut motion.drive);
        motion.settled = true;
        self.state.balls[ball].velocity += drive.velocity * left;
        self.state.balls[ball].spin += drive.spin * left;
    }

    fn sides(&self, ball: usize) -> Vec<Side> {
        let own = self.scratch.touches.iter().filter(|touch| touch.ball == ball);
        let side = |touch: &crate::solver::contact_constraint::Touch| match touch.other {
            Other::Fixed(velocity) => Some(Side { normal: touch.normal, least: velocity.dot(touch.normal) }),
            _ => None,
        };
        own.filter_map(side).collect()
    }
}

/// The velocity nearest to `velocity` that leads into no side: itself, one along a side, or the corner of two.
fn nearest(velocity: DVec2, sides: &[Side]) -> DVec2 {
    let clear = |one: DVec2| sides.iter().all(|side| one.dot(side.normal) >= side.least - ROUNDING_M_S);
    if clear(velocity) {
        return velocity;
    }
    let along = |side: &Side| velocity + side.normal * (side.least - velocity.dot(side.normal));
    let corner = |a: &Side, b: &Side| {
        let turn = a.normal.perp_dot(b.normal);
        let meet = (b.normal.perp() * -a.least + a.normal.perp() * b.least) / turn;
        meet.is_finite().then_some(meet)
    };
    let corners =
        sides.iter().enumerate().flat_map(|(index, a)| sides[..index].iter().filter_map(move |b| corner(a, b)));
    let all = sides.iter().map(along).chain(corners).filter(|one| clear(*one));
    all.min_by(|a, b| a.distance_squared(velocity).total_cmp(&b.distance_squared(velocity))).unwrap_or(DVec2::ZERO)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn side(x: f64, y: f64, least: f64) -> Side {
        Side { normal: DVec2::new(x, y).normalize(), least }
    }

    #[test]
    fn a_velocity_is_turned_aside_by_a_wall_and_ended_by_a_corner() {
        let down = DVec2::new(1.0, 2.0);
        let floor = side(0.0, -1.0, 0.0);
        assert_eq!(nearest(DVec2::new(1.0, -2.0), &[floor]), DVec2::new(1.0, -2.0));
        assert!(nearest(down, &[floor]).distance(DVec2::new(1.0, 0.0)) < 1e-12);
        assert!(nearest(down, &[side(1.0, -0.1, 0.0), side(-1.0, -0.1, 0.0)]).length() < 1e-12);
        let moving = [side(1.0, 0.0, 3.0), side(0.0, -1.0, -0.5)];
        assert!(nearest(down, &moving).distance(DVec2::new(3.0, 0.5)) < 1e-12);
        let lifted = [side(1.0, -0.1, 0.0), side(-1.0, -0.1, 0.2)];
        let up = nearest(down, &lifted);
        assert!(lifted.iter().all(|side| (up.dot(side.normal) - side.least).abs() < 1e-12), "{up}");
    }
}
