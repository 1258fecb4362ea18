//! The flipper: how fast it is, and what it does to balls.

use crate::fixture::*;
use geometry::{Circle, DVec2, Shape, Taper, trig};
use physics::*;

fn angle(machine: &Machine) -> f64 {
    machine.pose().flippers_rad[0].1.to_degrees()
}

fn lone_flipper() -> Machine {
    let mut layout = bare();
    layout.parts.push(flipper(true));
    let mut machine = machine(layout);
    machine.tick(Controls::default(), &[Command::SetFlippers(true)]);
    machine
}

#[test]
fn a_flipper_is_up_in_time_and_back_in_time() {
    let mut machine = lone_flipper();
    let up = Controls { left: true, ..Controls::default() };
    let mut arrival = 0;
    let mut fastest: f64 = 0.0;
    let mut last = angle(&machine);
    for tick in 1..200 {
        machine.tick(up, &[]);
        let now = angle(&machine);
        fastest = fastest.max((last - now).to_radians() * 1000.0);
        if arrival == 0 && now <= -23.0 {
            arrival = tick;
        }
        last = now;
    }
    let tip = fastest * 0.0675;
    let mut rest = 0;
    for tick in 1..300 {
        machine.tick(Controls::default(), &[]);
        let now = angle(&machine);
        if (now - 28.0).abs() > 0.5 {
            rest = tick + 1;
        }
    }
    println!("up in {arrival} ms, tip {tip} m/s, back in {rest} ms");
    assert!((19..=26).contains(&arrival), "up in {arrival} ms");
    assert!((85..=100).contains(&rest), "back in {rest} ms");
    assert!((5.0..=6.5).contains(&tip), "tip at {tip} m/s");
}

#[test]
fn longer_presses_lift_higher() {
    let mut last = 0.0;
    for press in [2, 4, 8, 12, 16, 24] {
        let mut machine = lone_flipper();
        let mut peak: f64 = 0.0;
        for tick in 0..150 {
            machine.tick(Controls { left: tick < press, ..Controls::default() }, &[]);
            peak = peak.max(28.0 - angle(&machine));
        }
        println!("{press} ms: {peak} deg");
        assert!(peak > last + 1e-3, "{press} ms lifts by {peak} deg, less by {last}");
        last = peak;
    }
}

#[test]
fn a_ball_lies_still_on_a_raised_flipper() {
    let mut machine = machine(table());
    let up = Controls { left: true, ..Controls::default() };
    machine.tick(up, &[Command::SetFlippers(true)]);
    (0..100).for_each(|_| machine.tick(up, &[]));
    machine.put_ball(v(0.13, 0.87), v(0.0, 0.0), [0.0; 3]);
    (0..2500).for_each(|_| machine.tick(up, &[]));
    let start = machine.pose().balls[0];
    println!("{start:?}");
    assert!(start.velocity.length() < 1e-3, "{start:?}");
    (0..10000).for_each(|_| machine.tick(up, &[]));
    let drift = machine.pose().balls[0].center.distance(start.center);
    assert!(drift < 5e-5, "drifts {drift} m");
}

/// A guide that goes on in the upper side of the resting left flipper.
fn seam() -> (Layout, DVec2, DVec2) {
    let mut layout = bare();
    let part_of_flipper = flipper(true);
    let Kind::Flipper(numbers) = &part_of_flipper.kind else { unreachable!("it is a flipper") };
    let tip = numbers.base.center + trig::direction(numbers.rest_rad) * numbers.length_m;
    let outline = Taper { a: numbers.base, b: Circle { center: tip, radius: numbers.tip_radius_m } };
    let normals = outline.side_normals().expect("a flipper has sides");
    let normal = if normals[0].y < 0.0 { normals[0] } else { normals[1] };
    let side = outline.side(normal);
    let along = side.along().normalize();
    let radius = 0.002;
    let guide = Shape::capsule(side.a - along * 0.1 - normal * radius, side.a - along * 1e-4 - normal * radius, radius);
    layout.parts = vec![part_of_flipper, part("guide", walls(vec![guide], WOOD))];
    (layout, side.a - along * 0.08 + normal * (BALL_RADIUS_M + 1e-6), side.b)
}

#[test]
fn a_ball_rolls_from_the_inlane_onto_the_flipper_without_a_hop() {
    let (layout, start, end) = seam();
    let mut machine = machine(layout);
    machine.put_ball(start, v(0.0, 0.0), [0.0; 3]);
    let mut widest: f64 = 0.0;
    let mut impacts = 0;
    while machine.pose().balls[0].center.x < end.x - 0.002 {
        machine.tick(Controls::default(), &[]);
        widest = widest.max(-machine.penetration_m());
        impacts += machine.contacts().len();
    }
    assert!(widest < 5e-5, "it leaves the surface by {widest} m");
    assert_eq!(impacts, 0);
}

#[test]
fn no_ball_passes_a_flipper_in_any_phase_of_its_stroke() {
    let mut layout = bare();
    layout.parts = vec![flipper(true)];
    let fresh = machine(layout);
    let mut chance = Chance(3);
    let mut deepest = f64::NEG_INFINITY;
    for shot in 0..3000 {
        let mut machine = fresh.clone();
        machine.tick(Controls::default(), &[Command::SetFlippers(true)]);
        let (phase, press) = (chance.between(0.0, 160.0) as u32, chance.between(0.0, 80.0) as u32);
        let hands = |tick: u32| Controls { left: tick < press || tick % 50 > 25, ..Controls::default() };
        (0..phase).for_each(|tick| machine.tick(hands(tick), &[]));
        let way = trig::direction(chance.between(0.0, std::f64::consts::TAU));
        let speed = 0.05 * libm::pow(300.0, chance.next());
        let aim = v(0.16, 0.93) + v(1.0, chance.between(-0.45, 0.55)) * chance.between(0.0, 0.065);
        machine.put_ball(aim - way * chance.between(0.035, 0.06), way * speed, [0.0, 0.0, chance.between(-99.0, 99.0)]);
        if machine.penetration_m() > 0.0 {
            continue;
        }
        for tick in phase..phase + 60 {
            machine.tick(hands(tick), &[]);
            deepest = deepest.max(machine.penetration_m());
        }
        assert!(deepest < 2e-5, "shot {shot}: {deepest} m deep");
    }
}

#[test]
fn a_ball_dropped_on_a_resting_flipper_bounces_over_to_the_other() {
    let mut layout = bare();
    layout.parts = vec![flipper(true), flipper(false)];
    let mut crossed = 0;
    for place in 0..10 {
        for speed in 0..10 {
            let mut machine = machine(layout.clone());
            let speed = 1.0 + 0.1 * f64::from(speed);
            let spin = [-speed / BALL_RADIUS_M, 0.0, 0.0];
            machine.put_ball(v(0.175 + 0.0035 * f64::from(place), 0.86), v(0.0, speed), spin);
            let over = (0..800).any(|_| {
                machine.tick(Controls::default(), &[]);
                let ball = machine.pose().balls[0];
                ball.center.x > 0.275 && ball.center.y < 0.96
            });
            crossed += u32::from(over);
        }
    }
    assert!(crossed >= 80, "{crossed} of 100 cross");
}

#[test]
fn a_flipper_that_yields_takes_the_ball_down_and_one_that_holds_throws_it_back() {
    let layout = table();
    let left_with = |release: Option<usize>| {
        let mut machine = machine(layout.clone());
        let hands =
            |tick: usize| Controls { left: release.is_none_or(|release| tick < release), ..Controls::default() };
        machine.tick(hands(0), &[Command::SetFlippers(true)]);
        (0..200).for_each(|_| machine.tick(Controls { left: true, ..Controls::default() }, &[]));
        machine.put_ball(v(0.19, 0.80), v(0.0, 2.0), [-2.0 / BALL_RADIUS_M, 0.0, 0.0]);
        let hit = (0..200).find(|&tick| {
            machine.tick(hands(tick), &[]);
            !machine.contacts().is_empty()
        });
        machine.tick(hands(usize::MAX - 1), &[]);
        (hit, machine.pose().balls[0].velocity.length() / 2.0)
    };
    let (hit, held) = left_with(None);
    let contact = hit.expect("the ball falls on the flipper");
    let (_, caught) = left_with(Some(contact - 25));
    assert!(held > 0.5, "a held flipper throws it back with {held} of its speed");
    assert!(caught < 0.15, "a drop catch leaves it {caught}");
}

#[test]
fn the_later_the_press_the_farther_across_goes_the_shot() {
    let (layout, start, _) = seam();
    let fresh = {
        let mut machine = machine(layout);
        machine.tick(Controls::default(), &[Command::SetFlippers(true)]);
        machine.put_ball(start, v(0.0, 0.0), [0.0; 3]);
        (0..790).for_each(|_| machine.tick(Controls::default(), &[]));
        machine
    };
    let mut angles: Vec<f64> = Vec::new();
    for delay in 0..60 {
        let mut machine = fresh.clone();
        for tick in 0..300 {
            machine.tick(Controls { left: tick >= delay, ..Controls::default() }, &[]);
        }
        let ball = machine.pose().balls[0];
        angles.push(trig::angle(ball.velocity).to_degrees());
    }
    println!("{angles:?}");
    for pair in angles.windows(2) {
        assert!(pair[1] > pair[0], "{} degrees, then {}", pair[0], pair[1]);
    }
}

/// An inlane that ends in the upper side of the resting left flipper: the guide below, and a rail above it that ends
/// well before the flipper.
fn inlane() -> (Layout, DVec2, DVec2) {
    let (mut layout, start, end) = seam();
    let Kind::Wall(wall) = &mut layout.parts[1].kind else { unreachable!("it is the guide") };
    let geometry::Core::Segment(guide) = wall.shapes[0].core else { unreachable!("it is a line") };
    let way = (guide.b - guide.a).normalize();
    let rail = |back: f64| guide.b - way * back - way.perp() * 0.045;
    wall.shapes[0] = Shape::capsule(guide.b - way * 0.12, guide.b, 0.002);
    wall.shapes.push(Shape::capsule(rail(0.12), rail(0.035), 0.002));
    (layout, start, (end - start).normalize())
}

#[test]
fn an_early_flip_sends_the_ball_back_up_its_inlane() {
    let (layout, start, way) = inlane();
    let fresh = {
        let mut machine = machine(layout);
        machine.tick(Controls::default(), &[Command::SetFlippers(true)]);
        let rolling = [-way.y * 0.2 / BALL_RADIUS_M, way.x * 0.2 / BALL_RADIUS_M, 0.0];
        machine.put_ball(start, way * 0.2, rolling);
        machine
    };
    let back = |wait: usize| {
        let mut machine = fresh.clone();
        (0..700).any(|tick| {
            machine.tick(Controls { left: (wait..wait + 40).contains(&tick), ..Controls::default() }, &[]);
            let ball = machine.pose().balls[0];
            let from_start = ball.center - start;
            tick > wait && ball.velocity.dot(way) < 0.0 && from_start.dot(way) < 0.01 && from_start.length() < 0.04
        })
    };
    let waits: Vec<usize> = (200..340).filter(|&wait| back(wait)).collect();
    println!("{waits:?}");
    assert!((3..15).contains(&waits.len()), "it goes back for {waits:?} ms");
}

/// A ball that rolls down the resting flipper and is shot when it has come some way.
fn shot(substeps: u32, wait: usize) -> DVec2 {
    let (layout, start, _) = seam();
    let mut machine = machine(layout).substepped(substeps);
    machine.put_ball(start, v(0.0, 0.0), [0.0; 3]);
    machine.tick(Controls::default(), &[Command::SetFlippers(true)]);
    (0..wait).for_each(|_| machine.tick(Controls::default(), &[]));
    let up = Controls { left: true, ..Controls::default() };
    (0..40).for_each(|_| machine.tick(up, &[]));
    machine.pose().balls[0].velocity
}

#[test]
fn a_shot_is_the_same_in_eight_times_as_many_steps() {
    for wait in (620..980).step_by(10) {
        let (fast, slow) = (shot(1, wait), shot(8 * 32, wait));
        let off = (fast - slow).length() / slow.length();
        println!("{wait} ms: {fast} {slow} {:.4} %", off * 100.0);
        assert!(off < 5e-3, "after {wait} ms {fast} and {slow}, {off} of it apart");
    }
}
