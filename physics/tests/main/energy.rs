//! Energy of balls that meet each other: where nothing is powered it never grows.

use crate::fixture::*;
use geometry::{Circle, DVec2, Shape};
use physics::*;

/// The most that energy may grow in a tick, in parts of itself.
pub const ROUNDING: f64 = 1e-6;

/// Of all balls, over a ball's mass, J/kg: motion, spin, and height over the playfield's lower edge.
pub fn energy(machine: &Machine) -> f64 {
    let layout = machine.layout();
    let gravity = 9.81 * libm::sin(layout.slope_rad);
    let inertia = 0.4 * BALL_RADIUS_M * BALL_RADIUS_M;
    let of = |ball: &BallPose| {
        let spin: f64 = ball.spin.iter().map(|part| part * part).sum();
        0.5 * ball.velocity.length_squared() + 0.5 * inertia * spin + gravity * (layout.size_m.y - ball.center.y)
    };
    let pose = machine.pose();
    pose.balls.iter().chain(pose.captives.iter().map(|(_, ball)| ball)).map(of).sum()
}

/// Throws so many balls at each other from this part of the playfield, each from where it is free.
pub fn throw(machine: &mut Machine, balls: usize, [from, to]: [DVec2; 2], chance: &mut Chance) {
    while machine.pose().balls.len() < balls {
        let mut next = machine.clone();
        let place = v(chance.between(from.x, to.x), chance.between(from.y, to.y));
        let slack = v(chance.between(-0.02, 0.02), chance.between(-0.02, 0.02));
        let velocity = ((from + to) * 0.5 + slack - place) * chance.between(2.0, 10.0);
        let spin = [0.0; 3].map(|_: f64| chance.between(-200.0, 200.0));
        next.put_ball(place, velocity, spin);
        if next.penetration_m() <= 0.0 {
            *machine = next;
        }
    }
}

/// Plays on and asserts that energy never grows; how many impacts of two balls there were.
fn assert_falls(name: &str, mut machine: Machine, ticks: usize) -> usize {
    let mut before = energy(&machine);
    let mut met = 0;
    for tick in 0..ticks {
        machine.tick(Controls::NONE, &[]);
        let after = energy(&machine);
        let grown = (after - before) / before;
        assert!(grown <= ROUNDING, "{name}, tick {tick}: by {grown:e} of {before} J/kg\n{:#?}", machine.contacts());
        met += machine.contacts().iter().filter(|contact| contact.part.is_none()).count();
        before = after;
    }
    met
}

/// Posts and a curve within four walls.
fn yard(material: Material, slope_rad: f64) -> Layout {
    let mut layout = bare();
    layout.slope_rad = slope_rad;
    let curve = geometry::Arc::new(Circle { center: v(0.257, 0.26), radius: 0.2 }, 3.3, 2.5);
    let mut shapes = vec![Shape { core: geometry::Core::Arc(curve), radius: 0.002 }];
    shapes.extend((0..6).map(|post| Shape::disc(v(0.1 + 0.06 * f64::from(post), 0.5), 0.005)));
    layout.parts = vec![frame(material), part("things", walls(shapes, material))];
    layout
}

const YARD: [DVec2; 2] = [DVec2::new(0.1, 0.55), DVec2::new(0.41, 0.95)];

/// Throws 2, 3 and 4 balls at each other in yards of this slope; how often they met.
fn play_yards(name: &str, seed: u64, slope_rad: f64, ticks: usize) -> usize {
    let mut chance = Chance(seed);
    let mut play = |game: usize| {
        let mut machine = machine(yard([RUBBER, WOOD, METAL][game % 3], slope_rad));
        throw(&mut machine, 2 + game % 3, YARD, &mut chance);
        assert_falls(&format!("{name}, game {game}"), machine, ticks)
    };
    (0..30).map(&mut play).sum()
}

#[test]
fn balls_that_meet_on_a_slope_gain_none() {
    let met = play_yards("slope", 21, 6.5_f64.to_radians(), 3000);
    assert!(met > 100, "they meet: {met}");
}

#[test]
fn balls_that_meet_on_the_level_gain_none() {
    let met = play_yards("level", 22, 0.0, 1500);
    assert!(met > 50, "they meet: {met}");
}

#[test]
fn balls_on_a_table_with_every_coil_dead_gain_none() {
    let mut chance = Chance(24);
    for game in 0..24 {
        let mut layout = table();
        // What takes a ball's energy and gives it back later is not a ball.
        let stores = |kind: &Kind| {
            matches!(kind, Kind::Plunger(_) | Kind::Kickback(_) | Kind::Saucer(_) | Kind::Gate(_) | Kind::Spinner(_))
        };
        layout.parts.retain(|part| !stores(&part.kind));
        let mut machine = machine(layout);
        throw(&mut machine, 1 + game % 4, [v(0.1, 0.3), v(0.42, 0.8)], &mut chance);
        assert_falls(&format!("table, game {game}"), machine, 2000);
    }
}
