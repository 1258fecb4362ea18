//! What can be seen of a machine from outside.

use crate::BALL_RADIUS_M;
use crate::ball::Ball;
use crate::collision::world::Role;
use crate::layout::{FlipperControl, PartId};
use crate::machine::Machine;
use crate::mechanisms::elevation::apart;
use crate::mechanisms::magnet;
use crate::mechanisms::pose::{BallPose, Pose};
use crate::mechanisms::rigid_mechanisms::Plate;
use geometry::DVec2;

impl Machine {
    /// Where everything is now.
    pub fn pose(&self) -> Pose {
        let (plan, own) = (&self.plan, &self.state.mechanisms);
        let angles = plan.blades.iter().zip(&own.rotors).map(|(blade, rotor)| (PartId(blade.part), rotor.angle));
        let torques = plan.blades.iter().zip(&own.rotors).map(|(blade, rotor)| (PartId(blade.part), blade.lift(rotor)));
        let drops = plan.drops.iter().enumerate().map(|(index, d)| (PartId(d.part), self.works.height(index)));
        let plates = |parts: Vec<u16>, plate: fn(usize) -> Plate| {
            let angle = |(index, part)| (PartId(part), self.works.angle(plate(index)));
            parts.into_iter().enumerate().map(angle).collect()
        };
        let kickers = plan.kickers.iter().zip(&own.kickers).map(|(k, &ticks)| (PartId(k.part), kick_pose(ticks)));
        let rods = || plan.slides.iter().zip(&own.rods).map(|(slide, rod)| (slide, rod.pulled / slide.stroke));
        let pulled = rods().filter(|(slide, _)| slide.is_plunger()).map(|(_, pulled)| pulled.max(0.0));
        let kickbacks = rods().filter(|(slide, _)| !slide.is_plunger());
        let kickbacks = kickbacks.map(|(slide, pulled)| (PartId(slide.part), (-pulled).clamp(0.0, 1.0)));
        let captive = |ball: &Ball| Some((PartId(plan.captives[ball.captive()?].0), ball.pose()));
        let magnets = plan.magnets.iter().zip(&own.coils);
        Pose {
            balls: self.balls(),
            captives: self.state.balls.iter().filter_map(captive).collect(),
            flippers_rad: angles.collect(),
            flipper_torques_n_m: torques.collect(),
            drop_targets: drops.collect(),
            spinners_rad: plates(plan.spinners.iter().map(|&(part, _)| part).collect(), Plate::Spinner),
            gates_rad: plates(plan.gates.iter().map(|&(part, _)| part).collect(), Plate::Gate),
            kickers: kickers.chain(kickbacks).collect(),
            magnets: magnets.map(|(&(part, _), coil)| (PartId(part), coil.on && own.kickers_live)).collect(),
            plunger: pulled.fold(0.0, f64::max),
            cabinet_m: own.cabinet.place,
        }
    }

    /// Where the balls in play are now: the `balls` of [`Machine::pose`], without the rest.
    pub fn balls(&self) -> Vec<BallPose> {
        self.in_play().map(Ball::pose).collect()
    }

    fn in_play(&self) -> impl Iterator<Item = &Ball> {
        self.state.balls.iter().filter(|ball| ball.captive().is_none())
    }

    /// How long each ball has hardly moved where nothing should hold it, ticks: in the order of [`Pose::balls`]; 0 for
    /// a ball in a saucer, in the plunger lane, on a raised flipper or over a magnet that holds it.
    pub fn stuck_ticks(&self) -> Vec<u32> {
        let by_magnet = |ball: &Ball| magnet::holds(&self.plan, &self.state.mechanisms, ball);
        let excused = |ball: &Ball| {
            ball.is_held() || self.waits_for_plunger(ball) || self.lies_on_flipper(ball) || by_magnet(ball)
        };
        let stuck = |ball: &Ball| if excused(ball) { 0 } else { ball.still_ticks };
        self.in_play().map(stuck).collect()
    }

    fn waits_for_plunger(&self, ball: &Ball) -> bool {
        self.plan.plungers.iter().any(|(_, plunger)| {
            let from_tip = ball.center - plunger.tip;
            let lane = plunger.half_width_m + BALL_RADIUS_M;
            from_tip.dot(plunger.direction.perp()).abs() < lane && from_tip.dot(plunger.direction) < 8.0 * BALL_RADIUS_M
        })
    }

    fn lies_on_flipper(&self, ball: &Ball) -> bool {
        self.plan.blades.iter().zip(&self.state.mechanisms.rotors).any(|(blade, rotor)| {
            let gap = blade.taper(rotor.angle).distance(ball.center).0 - BALL_RADIUS_M;
            gap < 1e-3 && blade.is_raised(rotor) && blade.flipper.control != FlipperControl::Rules
        })
    }

    /// How deep a ball lies in anything that stands in its way, m; 0 or less where nothing overlaps.
    pub fn penetration_m(&self) -> f64 {
        let mut deepest = f64::NEG_INFINITY;
        let own = &self.state.mechanisms;
        for (index, ball) in self.state.balls.iter().enumerate() {
            self.plan.near(ball.track, ball.center, ball.center, |obstacle| {
                let obstacle = &self.plan.obstacles[obstacle];
                let counts = match obstacle.role {
                    Role::Drop(drop) => own.drops[drop].solid,
                    Role::Gate(_) => false,
                    _ => true,
                };
                if counts {
                    deepest = deepest.max(-obstacle.shape.distance(ball.center).0);
                }
            });
            for (blade, rotor) in self.plan.blades.iter().zip(&own.rotors).filter(|_| !ball.is_up()) {
                deepest = deepest.max(BALL_RADIUS_M - blade.taper(rotor.angle).distance(ball.center).0);
            }
            for other in self.state.balls[index + 1..].iter().filter(|other| !apart(ball, other)) {
                deepest = deepest.max(2.0 * BALL_RADIUS_M - ball.center.distance(other.center));
            }
        }
        deepest
    }

    /// How many balls are not on the playfield, or nowhere at all (not a number).
    pub fn escaped(&self) -> usize {
        let on = |ball: &Ball| {
            ball.center.cmpge(DVec2::ZERO).all() && ball.center.cmple(self.plan.size).all() && ball.velocity.is_finite()
        };
        self.state.balls.iter().filter(|ball| !on(ball)).count()
    }
}

/// How far a kicker is out, `ticks` after it fired: out in 8 ms, back in 40.
fn kick_pose(ticks: u16) -> f64 {
    let ticks = f64::from(ticks);
    if ticks < 8.0 { ticks / 8.0 } else { (1.0 - (ticks - 8.0) / 40.0).max(0.0) }
}
