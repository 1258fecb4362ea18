//! What surfaces give back, and what they may take: restitution by speed, and Coulomb's cone.

use crate::fixture::*;
use geometry::{DVec2, Shape};
use physics::*;

/// What pinball surfaces are made of: restitution, its falloff in s/m, friction.
const MATERIALS: [(&str, [f64; 3]); 12] = [
    ("rubber band", [0.85, 0.13, 0.3]),
    ("soft rubber band", [0.8, 0.3, 0.6]),
    ("post", [0.9, 0.1, 0.3]),
    ("sleeve", [0.77, 0.1, 0.3]),
    ("wood", [0.3, 0.0, 0.2]),
    ("hard wood", [0.43, 0.0, 0.3]),
    ("metal wall", [0.3, 0.0, 0.2]),
    ("wire guide", [0.45, 0.0, 0.15]),
    ("hit target", [0.35, 0.5, 0.2]),
    ("drop target", [0.38, 0.15, 0.2]),
    ("flipper rubber", [0.88, 0.15, 0.9]),
    ("dead", [0.0, 0.0, 0.5]),
];

fn material([restitution, falloff_s_per_m, friction]: [f64; 3]) -> Material {
    Material { restitution, falloff_s_per_m, friction }
}

/// A level playfield without friction, and a wall of this along x = 400 mm.
fn wall(material: Material) -> Machine {
    let mut layout = bare();
    layout.slope_rad = 0.0;
    layout.playfield_friction = 0.0;
    layout.parts.push(part("wall", walls(vec![Shape::capsule(v(0.4, 0.0), v(0.4, 1.0), 0.003)], material)));
    machine(layout)
}

/// The first impact of a ball that is thrown at the wall from a tenth of a millisecond before it.
fn impact(fresh: &Machine, velocity: DVec2, spin: [f64; 3]) -> (Contact, BallPose) {
    let mut machine = fresh.clone();
    machine.put_ball(v(0.4 - 0.003 - BALL_RADIUS_M - 3e-4, 0.5), velocity, spin);
    for _ in 0..20 {
        machine.tick(Controls::default(), &[]);
        if let Some(&contact) = machine.contacts().first() {
            return (contact, machine.pose().balls[0]);
        }
    }
    panic!("it reaches the wall: {velocity}");
}

#[test]
fn every_material_gives_back_what_it_should_at_every_speed() {
    for (name, numbers) in MATERIALS {
        let fresh = wall(material(numbers));
        for step in 0..=24 {
            let speed = 0.05 * libm::pow(100.0, f64::from(step) / 24.0);
            let (_, ball) = impact(&fresh, v(speed, 0.0), [0.0; 3]);
            let wanted = numbers[0] / (1.0 + numbers[1] * speed);
            let given = -ball.velocity.x / speed;
            assert!((given - wanted).abs() <= 0.01 * wanted + 1e-9, "{name} at {speed} m/s: {given}, not {wanted}");
        }
    }
}

#[test]
fn friction_stays_within_its_cone_and_never_turns_a_slip_round() {
    let mut chance = Chance(4);
    let mut slid = 0;
    for (name, numbers) in MATERIALS {
        let fresh = wall(material(numbers));
        for _ in 0..2000 {
            let velocity = v(0.05 * libm::pow(200.0, chance.next()), chance.between(-5.0, 5.0));
            let spin = [0.0, 0.0, 0.0].map(|_: f64| chance.between(-300.0, 300.0));
            let (contact, ball) = impact(&fresh, velocity, spin);
            let along = contact.impulse_n_s.dot(contact.normal);
            let across = contact.impulse_n_s.dot(contact.normal.perp()).abs();
            assert!(across <= numbers[2] * along * (1.0 + 1e-9) + 1e-15, "{name}: {across} N s for {along} N s");
            let slip =
                |velocity: DVec2, spin: [f64; 3]| velocity.y - BALL_RADIUS_M * spin[2] * contact.normal.x.signum();
            let (before, after) = (slip(velocity, spin), slip(ball.velocity, ball.spin));
            slid += u32::from(after.abs() > 1e-6);
            assert!(after.abs() <= before.abs() + 1e-9, "{name}: slips at {before} m/s, then at {after} m/s");
        }
    }
    assert!(slid > 1000, "many slide on: {slid}");
}
