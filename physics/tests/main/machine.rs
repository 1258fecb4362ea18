//! The machine as a whole: saving, cloning, the plunger, switches.

use crate::fixture::*;
use physics::*;
use std::sync::Arc;

#[test]
fn the_plunger_shoots_in_proportion_to_its_pull() {
    for pull in [200, 400, 600, 800, 1200] {
        let layout = table();
        let mut machine = machine(layout);
        machine.tick(Controls::default(), &[Command::AddBall]);
        (0..1500).for_each(|_| machine.tick(Controls::default(), &[]));
        let held = Controls { plunger: true, ..Controls::default() };
        (0..pull).for_each(|_| machine.tick(held, &[]));
        let mut fastest: f64 = 0.0;
        let mut launched = 0;
        for _ in 0..100 {
            machine.tick(Controls::default(), &[]);
            fastest = fastest.max(-machine.pose().balls[0].velocity.y);
            launched += machine.events().iter().filter(|e| e.kind == EventKind::Launched).count();
        }
        let wanted = 3.5 * (f64::from(pull) / 800.0).min(1.0);
        println!("{pull} ms: {fastest} m/s, {launched} launches");
        assert!((fastest / wanted - 1.0).abs() < 0.01, "{pull} ms: {fastest} m/s, not {wanted}");
        assert_eq!(launched, 1);
    }
}

#[test]
fn a_restored_machine_goes_on_as_if_nothing_had_been() {
    let layout = Arc::new(table());
    let mut machine = Machine::new(layout.clone()).expect("fixture");
    machine.tick(Controls::default(), &[Command::SetFlippers(true), Command::SetCoils(true), Command::AddBall]);
    machine.put_ball(v(0.25, 0.2), v(1.0, -2.0), [0.0; 3]);
    machine.put_ball(v(0.30, 0.4), v(-1.0, -2.0), [0.0; 3]);
    for tick in 0..3000u32 {
        let controls = Controls {
            left: tick % 170 < 60,
            right: tick % 230 < 90,
            plunger: tick % 900 > 300,
            nudge_up: tick % 700 == 0,
            nudge_down: tick % 900 == 50,
            ..Controls::default()
        };
        if tick % 50 == 0 {
            let restored = Machine::restore(layout.clone(), &machine.save()).expect("just saved");
            assert_eq!(restored.hashes(), machine.hashes());
            machine = if tick % 100 == 0 { restored } else { machine.clone() };
        }
        let orders = orders(&machine, tick);
        let mut twin = machine.clone();
        machine.tick(controls, &orders);
        twin.tick(controls, &orders);
        assert_eq!(twin.hashes(), machine.hashes());
    }
}

#[test]
fn damaged_bytes_are_refused_and_nothing_panics() {
    let layout = Arc::new(table());
    let mut machine = Machine::new(layout.clone()).expect("fixture");
    machine.put_ball(v(0.25, 0.2), v(1.0, -2.0), [0.0; 3]);
    (0..50).for_each(|_| machine.tick(Controls::default(), &[]));
    let bytes = machine.save();
    for place in (0..bytes.len()).step_by(7) {
        let mut damaged = bytes.clone();
        damaged[place] ^= 1 << (place % 8);
        assert!(matches!(Machine::restore(layout.clone(), &damaged), Err(Error::Save(_))), "byte {place}");
        assert!(matches!(Machine::restore(layout.clone(), &bytes[..place]), Err(Error::Save(_))), "cut at {place}");
    }
    assert!(matches!(Machine::restore(Arc::new(bare()), &bytes), Err(Error::Save(_))), "another layout");
}

fn of<'a>(layout: &'a mut Layout, name: &str) -> Option<&'a mut Kind> {
    layout.parts.iter_mut().find(|part| part.name == name).map(|part| &mut part.kind)
}

#[test]
fn numbers_that_cannot_be_are_refused_by_name() {
    type Spoil = fn(&mut Layout);
    let spoils: [Spoil; 10] = [
        |layout| layout.size_m.x = f64::NAN,
        |layout| layout.playfield_friction = -0.1,
        |layout| layout.slope_rad = f64::INFINITY,
        |layout| {
            if let Kind::Flipper(f) = &mut layout.parts[1].kind {
                f.mass_kg = 0.0
            }
        },
        |layout| {
            if let Kind::Plunger(p) = &mut layout.parts[3].kind {
                p.direction = v(1.0, 1.0)
            }
        },
        |layout| {
            if let Kind::Wall(w) = &mut layout.parts[4].kind {
                w.material.restitution = 1.5
            }
        },
        |layout| {
            if let Some(Kind::Magnet(m)) = of(layout, "magnet") {
                m.pull_m_s2 = 1e4
            }
        },
        |layout| {
            if let Some(Kind::Kickback(k)) = of(layout, "kickback") {
                k.stroke_m = 0.0
            }
        },
        |layout| {
            if let Some(Kind::Gate(g)) = of(layout, "gate") {
                g.direction = v(-0.8, 0.6)
            }
        },
        |layout| {
            if let Some(Kind::CaptiveBall(c)) = of(layout, "captive") {
                c.threshold_m_s = f64::NAN
            }
        },
    ];
    for (index, spoil) in spoils.into_iter().enumerate() {
        let mut layout = table();
        spoil(&mut layout);
        let error = Machine::new(Arc::new(layout)).expect_err("this cannot be");
        assert!(matches!(&error, Error::Layout(_, text) if !text.is_empty()), "{index}: {error:?}");
    }
}

#[test]
fn a_machine_that_nobody_touches_does_not_change() {
    let mut machine = machine(table());
    machine.tick(Controls::default(), &[]);
    let before = machine.hashes();
    (0..1000).for_each(|_| machine.tick(Controls::default(), &[]));
    assert_eq!(machine.hashes(), before);
    assert!(machine.events().is_empty());
}
