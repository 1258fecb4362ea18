//! A captive ball: hit like any ball, kept in its place, not in play.

use crate::fixture::*;
use geometry::DVec2;
use physics::*;

/// The table's captive ball in its pocket, alone on the slope.
fn pocketed(threshold_m_s: f64) -> Machine {
    let mut layout = bare();
    layout.parts.push(pocket(CAPTIVE));
    layout.parts.push(part("captive", Kind::CaptiveBall(CaptiveBall { center: CAPTIVE, threshold_m_s })));
    live(layout)
}

fn captive(machine: &Machine) -> BallPose {
    machine.pose().captives[0].1
}

#[test]
fn a_ball_that_hits_it_gives_its_speed_away_and_closes_its_switch() {
    let mut machine = pocketed(0.1);
    run(&mut machine, 500, EventKind::Closed);
    machine.put_ball(CAPTIVE + v(0.0, 0.05), v(0.0, -2.0), [0.0; 3]);
    let mut parts = Vec::new();
    let (mut before, mut given) = (0.0, 0.0);
    for _ in 0..40 {
        let speed = -machine.pose().balls[0].velocity.y;
        machine.tick(Controls::default(), &[]);
        parts.extend(machine.events().iter().filter(|event| event.kind == EventKind::Closed).map(|event| event.part));
        if parts.len() == 1 && before == 0.0 {
            (before, given) = (speed, -captive(&machine).velocity.y);
        }
    }
    assert_eq!(parts, [Some(id(&machine, "captive"))]);
    // Two equal balls in line: the one that is hit takes (1 + e) / 2.
    assert!((given / before - 0.5 * 1.87).abs() < 0.03, "{given} of {before} m/s");
}

#[test]
fn a_soft_touch_does_not_close_it() {
    for (speed, closes) in [(0.3, 0), (1.2, 1)] {
        let mut machine = pocketed(0.8);
        machine.put_ball(CAPTIVE + v(0.0, 2.0 * BALL_RADIUS_M + 1e-3), v(0.0, -speed), [0.0; 3]);
        assert_eq!(run(&mut machine, 200, EventKind::Closed), closes, "at {speed} m/s");
    }
}

#[test]
fn it_stays_in_its_pocket_whatever_hits_it_and_comes_back_to_lie() {
    let mut chance = Chance(4);
    for _ in 0..100 {
        let mut machine = pocketed(0.1);
        let from = CAPTIVE + v(chance.between(-0.03, 0.03), 0.06);
        let way = (CAPTIVE + v(chance.between(-0.01, 0.01), 0.0) - from).normalize();
        machine.put_ball(from, way * chance.between(0.5, 15.0), [0.0; 3]);
        for _ in 0..200 {
            run(&mut machine, 1, EventKind::Closed);
            let away = captive(&machine).center - CAPTIVE;
            assert!(away.x.abs() < 0.002 && (-0.03..1e-4).contains(&away.y), "{away}");
        }
        run(&mut machine, 4000, EventKind::Closed);
        let lies = captive(&machine);
        assert!(lies.center.distance(CAPTIVE) < 1e-4 && lies.velocity.length() < 1e-3, "{lies:?}");
    }
}

#[test]
fn it_is_never_in_play() {
    let mut machine = pocketed(0.1);
    assert!(machine.pose().balls.is_empty() && machine.stuck_ticks().is_empty());
    assert_eq!(machine.pose().captives.len(), 1);
    let first = machine.put_ball(v(0.1, 0.2), DVec2::ZERO, [0.0; 3]);
    run(&mut machine, 10, EventKind::Closed);
    assert_eq!((machine.pose().balls.len(), machine.pose().balls[0].id), (1, first));
    assert_eq!(machine.stuck_ticks().len(), 1);
    assert_ne!(captive(&machine).id, first);
}

#[test]
fn neither_a_drain_nor_a_saucer_takes_it() {
    let mut layout = bare();
    let shape = geometry::Shape::disc(CAPTIVE, 0.01);
    let circle = geometry::Circle { center: CAPTIVE, radius: 0.014 };
    layout.parts.push(part("drain", Kind::Drain(Drain { shape })));
    layout.parts.push(part("saucer", Kind::Saucer(Saucer { circle, capture_m_s: 2.0, eject_m_s: v(0.0, 1.0) })));
    layout.parts.push(pocket(CAPTIVE));
    layout.parts.push(part("captive", Kind::CaptiveBall(CaptiveBall { center: CAPTIVE, threshold_m_s: 0.1 })));
    let mut machine = live(layout);
    assert_eq!(run(&mut machine, 1000, EventKind::Closed), 0);
    assert!(machine.pose().captives.len() == 1 && !captive(&machine).held);
}

#[test]
fn one_that_is_drawn_into_a_wall_is_refused() {
    let mut layout = bare();
    layout.parts.push(pocket(CAPTIVE));
    let center = CAPTIVE + v(0.0, -0.035);
    layout.parts.push(part("captive", Kind::CaptiveBall(CaptiveBall { center, threshold_m_s: 0.1 })));
    let error = Machine::new(std::sync::Arc::new(layout)).expect_err("it has no room");
    assert!(matches!(&error, Error::Layout(PartId(1), text) if text.contains("pocket")), "{error:?}");
}

/// In a heap only near balls are asked for impacts; in debug builds each search is held against its slow twin, which asks
/// every pair. Twenty balls thrown at each other meet, and none goes into another.
#[test]
fn in_a_heap_only_near_balls_are_asked_and_none_is_missed() {
    let mut machine = machine(bare());
    for ball in 0..20 {
        let (column, row) = (f64::from(ball % 5), f64::from(ball / 5));
        let inwards = v(2.0 - column, 1.5 - row);
        machine.put_ball(v(0.15 + 0.04 * column, 0.4 + 0.04 * row), inwards, [0.0; 3]);
    }
    let mut met = false;
    for _ in 0..300 {
        machine.tick(Controls::NONE, &[]);
        let balls = machine.pose().balls.clone();
        for (index, ball) in balls.iter().enumerate() {
            for other in &balls[index + 1..] {
                let apart = ball.center.distance(other.center) - 2.0 * BALL_RADIUS_M;
                met |= apart < 1e-4;
                assert!(apart > -5e-5, "{apart} m at {}", ball.center);
            }
        }
    }
    assert!(met);
}
