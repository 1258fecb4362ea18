//! Balls in wedges: many hits in one tick, and still no energy is made and no time is lost.

use crate::energy::{ROUNDING, energy, throw};
use crate::fixture::*;
use geometry::Shape;
use physics::*;

/// The least that the fastest ball moves in a tick, in parts of its way: less is time that did not pass.
const MOVES: f64 = 0.01;
/// Slower than this a ball may stand still.
const STILL_M_S: f64 = 2e-3;

/// Counts the ticks in a row in which everything stood still though something was fast.
#[derive(Default)]
struct Lost {
    now: u32,
    most: u32,
}

impl Lost {
    fn look(&mut self, before: &Machine, after: &Machine) {
        let (before, after) = (before.pose().balls, after.pose().balls);
        // A ball whose speed was turned round within the tick may be where it was: both speeds count.
        let slower = |a: &BallPose, b: &BallPose| a.velocity.length().min(b.velocity.length());
        let pairs = || before.iter().zip(&after).filter(|(a, b)| slower(a, b) > STILL_M_S);
        let stands = |(a, b): (&BallPose, &BallPose)| a.center.distance(b.center) < MOVES * slower(a, b) * TICK_S;
        let lost = pairs().count() > 0 && pairs().all(stands);
        self.now = if lost { self.now + 1 } else { 0 };
        self.most = self.most.max(self.now);
    }
}

#[test]
fn balls_that_are_driven_into_a_wedge_gain_nothing_and_lose_no_time() {
    let mut chance = Chance(23);
    let mut met = 0;
    for game in 0..60 {
        let wedge = chance.between(0.05, 0.4);
        let sides = [-1.0, 1.0]
            .map(|side| Shape::capsule(v(0.257 + side * wedge * 0.5, 0.45), v(0.257 + side * 0.01, 0.7), 0.003));
        let mut layout = bare();
        layout.parts = vec![frame(WOOD), part("wedge", walls(sides.to_vec(), [RUBBER, WOOD, METAL][game % 3]))];
        let mut machine = machine(layout);
        let reach = 0.25 * wedge;
        throw(&mut machine, 2 + game % 3, [v(0.257 - reach, 0.25), v(0.257 + reach, 0.5)], &mut chance);
        let mut lost = Lost::default();
        for tick in 0..2500 {
            let before = machine.clone();
            machine.tick(Controls::NONE, &[]);
            lost.look(&before, &machine);
            let (was, is) = (energy(&before), energy(&machine));
            let at = || format!("game {game}, tick {tick}: {:#?}", machine.pose().balls);
            assert!(lost.most <= 1, "time has stood still for {} ticks, {}", lost.now, at());
            assert!(is <= was * (1.0 + ROUNDING), "{was} to {is} J/kg, {}", at());
            met += machine.contacts().iter().filter(|contact| contact.part.is_none()).count();
        }
    }
    assert!(met > 100, "they meet: {met}");
}

#[test]
fn balls_between_flippers_that_never_rest_lose_no_time() {
    let mut chance = Chance(29);
    for game in 0..20 {
        let mut layout = bare();
        // The tips nearly meet, so that balls jam between flipper and flipper, flipper and guide, and each other.
        let guides = [(0.02, 0.80, 0.152, 0.9188), (0.494, 0.80, 0.362, 0.9188)];
        let guides = guides.map(|(ax, ay, bx, by)| Shape::capsule(v(ax, ay), v(bx, by), 0.002));
        layout.parts = vec![frame(WOOD), flipper(true), flipper(false), part("guides", walls(guides.to_vec(), WOOD))];
        let mut machine = live(layout);
        throw(&mut machine, 2 + game % 3, [v(0.15, 0.7), v(0.36, 0.88)], &mut chance);
        let (left, right) = (chance.between(40.0, 200.0) as usize, chance.between(40.0, 200.0) as usize);
        let mut lost = Lost::default();
        for tick in 0..2500 {
            let before = machine.clone();
            let hands = Controls { left: tick % left < left / 2, right: tick % right < right / 3, ..Controls::NONE };
            machine.tick(hands, &[]);
            lost.look(&before, &machine);
            let balls = machine.pose().balls;
            assert!(lost.most <= 1, "game {game}, tick {tick}: time stands still, {balls:#?}");
            let fastest = balls.iter().map(|ball| ball.velocity.length()).fold(0.0, f64::max);
            assert!(fastest < 12.0, "game {game}, tick {tick}: {fastest} m/s, {balls:#?}");
        }
    }
}
