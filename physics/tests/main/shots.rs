//! Shots from everywhere to everywhere: nothing gets through anything.

use crate::fixture::*;
use geometry::trig;
use physics::*;

#[test]
fn random_shots_neither_escape_nor_sink_in() {
    let mut chance = Chance(1);
    let layout = std::sync::Arc::new(table());
    let mut deepest: f64 = 0.0;
    for shot in 0..1500 {
        let mut machine = Machine::new(layout.clone()).expect("fixture");
        machine.tick(Controls::default(), &[Command::SetFlippers(true), Command::SetCoils(true)]);
        let speed = 0.05 * libm::pow(300.0, chance.next());
        let angle = chance.between(0.0, std::f64::consts::TAU);
        machine.put_ball(
            v(chance.between(0.05, 0.43), chance.between(0.25, 0.85)),
            trig::direction(angle) * speed,
            [0.0; 3],
        );
        if machine.penetration_m() > 0.0 {
            continue;
        }
        let (left, right) = (chance.between(20.0, 60.0) as usize, chance.between(20.0, 60.0) as usize);
        for tick in 0..200_usize {
            let controls =
                Controls { left: tick % left > left / 2, right: tick % right > right / 2, ..Controls::default() };
            let orders = orders(&machine, tick as u32);
            machine.tick(controls, &orders);
            assert_eq!(machine.escaped(), 0, "shot {shot}, tick {tick}: {:?}", machine.pose().balls);
            let overlap = machine.penetration_m();
            deepest = deepest.max(overlap);
            assert!(
                overlap < 5e-5,
                "shot {shot}, tick {tick}: {overlap} m deep, {:?} {:?}",
                machine.pose(),
                machine.contacts()
            );
        }
    }
    println!("deepest {deepest} m");
}
