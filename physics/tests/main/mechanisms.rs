//! Every thing on the playfield does what such a thing does.

use crate::fixture::*;
use geometry::{Circle, DVec2, Segment, Shape};
use physics::*;

fn velocity(machine: &Machine) -> DVec2 {
    machine.pose().balls[0].velocity
}

fn across(y: f64) -> Segment {
    Segment { a: v(0.2, y), b: v(0.25, y) }
}

#[test]
fn a_bumper_adds_its_kick_outwards_and_closes() {
    let circle = Circle { center: v(0.25, 0.5), radius: 0.03 };
    let bumper = Bumper { circle, material: RUBBER, kick_m_s: 0.8, threshold_m_s: 0.05 };
    let mut machine = live(with(Kind::Bumper(bumper)));
    machine.put_ball(v(0.35, 0.5), v(-1.0, 0.0), [0.0, -1.0 / BALL_RADIUS_M, 0.0]);
    assert_eq!(run(&mut machine, 100, EventKind::Closed), 1);
    let speed = velocity(&machine).x;
    assert!(speed > 1.2, "{speed} m/s");
}

#[test]
fn a_slingshot_kicks_most_in_its_middle() {
    let speeds = [0.212, 0.218, 0.225].map(|x| {
        let material = Material { friction: 0.0, ..RUBBER };
        let mut layout = with(Kind::Slingshot(Slingshot {
            segment: across(0.5),
            radius_m: 0.004,
            material,
            kick_m_s: 2.2,
            threshold_m_s: 0.2,
        }));
        layout.playfield_friction = 0.0;
        let mut machine = live(layout);
        machine.put_ball(v(x, 0.45), v(0.0, 1.0), [0.0; 3]);
        assert_eq!(run(&mut machine, 50, EventKind::Closed), 1);
        -velocity(&machine).y
    });
    assert!(speeds[0] < speeds[1] && speeds[1] < speeds[2], "{speeds:?}");
    let own = 0.85 / 1.13;
    assert!((speeds[2] - own - 2.2).abs() < 0.01, "{speeds:?}");
}

#[test]
fn a_target_closes_on_a_firm_hit_only() {
    for (speed, closes) in [(0.05, 0), (0.5, 1)] {
        let shape = Shape::capsule(v(0.2, 0.5), v(0.25, 0.5), 0.002);
        let mut machine = live(with(Kind::Target(Target { shape, material: WOOD, threshold_m_s: 0.1 })));
        machine.put_ball(v(0.225, 0.5 - 0.002 - BALL_RADIUS_M - 0.001), v(0.0, speed), [0.0; 3]);
        assert_eq!(run(&mut machine, 100, EventKind::Closed), closes, "at {speed} m/s");
    }
}

#[test]
fn a_drop_target_falls_lets_the_ball_pass_and_rises_when_it_has_gone() {
    let shape = Shape::capsule(v(0.2, 0.5), v(0.25, 0.5), 0.002);
    let mut machine = live(with(Kind::DropTarget(DropTarget { shape, material: WOOD, threshold_m_s: 0.3 })));
    machine.put_ball(v(0.225, 0.45), v(0.0, 1.0), [0.0; 3]);
    let height = |machine: &Machine| machine.pose().drop_targets[0].1;
    assert!(height(&machine) > 0.99);
    assert_eq!(run(&mut machine, 300, EventKind::Closed), 1);
    assert!(velocity(&machine).y < 0.0, "it throws the ball back once");
    assert!(height(&machine) < 0.01, "it has fallen");
    machine.put_ball(v(0.225, 0.47), v(0.0, 1.0), [0.0, 0.0, 0.0]);
    machine.tick(Controls::default(), &[Command::Raise(PartId(0))]);
    let mut over = false;
    for _ in 0..400 {
        machine.tick(Controls::default(), &[]);
        let ball = machine.pose().balls[1];
        let covers = (ball.center.y - 0.5).abs() < 0.0155;
        over |= covers;
        assert!(!(covers && height(&machine) > 0.6), "it rises into the ball");
        assert!(machine.penetration_m() < 5e-5);
    }
    assert!(over && velocity_of(&machine, 1).y > 0.0, "the second ball rolled over it");
    assert!(height(&machine) > 0.95, "it has risen");
    machine.put_ball(v(0.225, 0.47), v(0.0, 1.0), [0.0; 3]);
    run(&mut machine, 100, EventKind::Closed);
    assert!(velocity_of(&machine, 2).y < 0.0, "it stands again");
}

fn velocity_of(machine: &Machine, ball: usize) -> DVec2 {
    machine.pose().balls[ball].velocity
}

#[test]
fn a_gate_opens_one_way_and_is_shut_the_other() {
    let gate = Gate { segment: across(0.5), direction: v(0.0, -1.0), material: WOOD };
    for speed in [0.3, 1.0, 3.0, 7.0] {
        let rolling = |v_y: f64| [-v_y / BALL_RADIUS_M, 0.0, 0.0];
        let mut machine = live(with(Kind::Gate(gate.clone())));
        machine.put_ball(v(0.225, 0.56), v(0.0, -speed), rolling(-speed));
        let (mut open, mut closed): (f64, usize) = (0.0, 0);
        for _ in 0..((0.2 / speed * 1000.0) as usize) {
            machine.tick(Controls::default(), &[]);
            open = open.max(machine.pose().gates_rad[0].1);
            closed += machine.events().iter().filter(|event| event.kind == EventKind::Closed).count();
        }
        let left = -velocity(&machine).y / speed;
        println!("{speed} m/s: opens {open}, {left} of the speed left");
        assert!(machine.pose().balls[0].center.y < 0.48, "it lets the ball through at {speed} m/s");
        assert!((0.8..1.0).contains(&left), "and takes a little of its speed: {left} left");
        assert!(open > 0.5, "the flap is lifted by {open} rad");
        assert_eq!(closed, 1, "and its switch closes once");
        let mut machine = live(with(Kind::Gate(gate.clone())));
        machine.put_ball(v(0.225, 0.44), v(0.0, speed), rolling(speed));
        assert_eq!(run(&mut machine, (0.2 / speed * 1000.0) as usize, EventKind::Closed), 0);
        assert!(machine.pose().balls[0].center.y < 0.4866, "it holds the ball at {speed} m/s");
    }
}

#[test]
fn a_flap_shuts_again_and_everything_comes_to_rest() {
    let gate = Gate { segment: across(0.5), direction: v(0.0, -1.0), material: WOOD };
    let mut machine = live(with(Kind::Gate(gate)));
    machine.put_ball(v(0.225, 0.56), v(0.0, -2.0), [0.0; 3]);
    run(&mut machine, 4000, EventKind::Closed);
    assert!(machine.pose().gates_rad[0].1.abs() < 0.02, "{:?}", machine.pose().gates_rad);
    let before = machine.hashes().mechanisms;
    run(&mut machine, 1, EventKind::Closed);
    assert_eq!(machine.hashes().mechanisms, before, "a quiet machine does not change");
}

#[test]
fn a_spinner_counts_more_turns_for_a_faster_ball_both_ways() {
    let turns = |speed: f64| {
        let mut machine = live(with(Kind::Spinner(Spinner { segment: across(0.5), damping_per_s: 0.7 })));
        machine.put_ball(v(0.225, 0.5 - 0.05 * speed.signum()), v(0.0, speed), [0.0; 3]);
        let count = run(&mut machine, 12000, EventKind::Closed);
        let left = velocity(&machine).y / speed;
        println!("{speed} m/s: {count} half turns, {left} of the speed left");
        assert!(machine.pose().balls[0].center.y * speed.signum() > 0.5 * speed.signum(), "the ball has passed");
        count
    };
    let counts = [0.2, 0.6, 1.5, 3.0].map(turns);
    assert!(counts[1] < counts[2] && counts[2] < counts[3], "{counts:?}");
    assert!(counts[3] > 10, "{counts:?}");
    let back = turns(-3.0);
    assert!(back > counts[3] / 2 && back < counts[3] * 2, "{back} back, {} forth", counts[3]);
}

#[test]
fn a_plate_that_turns_pushes_the_ball_under_it() {
    let mut machine = live(with(Kind::Spinner(Spinner { segment: across(0.5), damping_per_s: 0.7 })));
    machine.put_ball(v(0.225, 0.45), v(0.0, 3.0), [0.0; 3]);
    run(&mut machine, 40, EventKind::Closed);
    machine.put_ball(v(0.225, 0.505), DVec2::ZERO, [0.0; 3]);
    run(&mut machine, 100, EventKind::Closed);
    let pushed = velocity_of(&machine, 1);
    assert!(pushed.y.abs() > 0.1 && pushed.x.abs() < 1e-3, "{pushed}");
}

#[test]
fn a_saucer_catches_a_slow_ball_holds_it_and_throws_it_out() {
    let circle = Circle { center: v(0.25, 0.5), radius: 0.014 };
    let saucer = Saucer { circle, capture_m_s: 1.0, eject_m_s: v(-0.6, 0.8) };
    let mut layout = with(Kind::Saucer(saucer));
    layout.slope_rad = 0.11;
    let mut machine = live(layout.clone());
    machine.put_ball(v(0.25, 0.44), v(0.05, 0.7), [0.0; 3]);
    assert_eq!(run(&mut machine, 500, EventKind::Closed), 1);
    let ball = machine.pose().balls[0];
    assert!(ball.held && ball.center == circle.center && ball.velocity == DVec2::ZERO);
    assert_eq!(machine.stuck_ticks(), [0], "a held ball is not stuck");
    machine.tick(Controls::default(), &[Command::Eject(PartId(0))]);
    assert!(machine.events().iter().any(|event| event.kind == EventKind::Opened));
    assert_eq!(run(&mut machine, 200, EventKind::Closed), 0);
    let ball = machine.pose().balls[0];
    assert!(!ball.held && ball.center.distance(circle.center) > 0.05);
    let mut machine = live(layout);
    machine.put_ball(v(0.25, 0.44), v(0.0, 3.0), [0.0; 3]);
    assert_eq!(run(&mut machine, 100, EventKind::Closed), 0, "a fast ball rolls over it");
}

#[test]
fn a_rollover_closes_and_opens_once_even_under_a_fast_ball() {
    for speed in [0.1, 1.0, 7.0, 15.0] {
        let mut machine =
            live(with(Kind::Rollover(Rollover { shape: Shape::capsule(v(0.2, 0.5), v(0.25, 0.5), 0.003) })));
        machine.put_ball(v(0.225, 0.4883), v(0.0, speed), [0.0; 3]);
        let mut copy = machine.clone();
        assert_eq!(run(&mut machine, 500, EventKind::Closed), 1, "at {speed} m/s");
        assert_eq!(run(&mut copy, 500, EventKind::Opened), 1, "at {speed} m/s");
    }
}

#[test]
fn a_drain_takes_the_ball() {
    let mut machine = live(with(Kind::Drain(Drain { shape: Shape::capsule(v(0.1, 0.9), v(0.4, 0.9), 0.005) })));
    machine.put_ball(v(0.225, 0.8), v(0.0, 6.0), [0.0; 3]);
    assert_eq!(run(&mut machine, 100, EventKind::Closed), 1);
    assert!(machine.pose().balls.is_empty());
}

#[test]
fn balls_wait_for_their_place_in_the_lane() {
    let mut machine = live(table());
    machine.tick(Controls::default(), &[Command::AddBall, Command::AddBall]);
    assert_eq!(machine.events().iter().filter(|event| event.kind == EventKind::Fed).count(), 1);
    assert_eq!(run(&mut machine, 2000, EventKind::Fed), 1, "the second when the first has rolled to the tip");
    assert_eq!(run(&mut machine, 2000, EventKind::Fed), 0);
    assert_eq!(machine.pose().balls.len(), 2);
    assert_eq!(machine.stuck_ticks(), [0, 0]);
}

#[test]
fn two_balls_share_momentum() {
    let mut layout = bare();
    layout.slope_rad = 0.0;
    layout.playfield_friction = 0.0;
    let mut machine = live(layout);
    machine.put_ball(v(0.2, 0.5), v(1.5, 0.1), [3.0, 0.0, 20.0]);
    machine.put_ball(v(0.3, 0.51), v(-0.5, 0.0), [0.0; 3]);
    run(&mut machine, 100, EventKind::Closed);
    let sum = velocity_of(&machine, 0) + velocity_of(&machine, 1);
    assert!((sum - v(1.0, 0.1)).length() < 1e-3, "{sum}: only rolling resistance may take any");
    assert!(velocity_of(&machine, 1).x > 0.8, "they met");
}

#[test]
fn a_ball_squeezed_into_a_corner_stays_out_of_both_walls() {
    let sides =
        vec![Shape::capsule(v(0.1, 0.3), v(0.25, 0.6), 0.003), Shape::capsule(v(0.4, 0.3), v(0.25, 0.6), 0.003)];
    let mut layout = bare();
    layout.parts.push(part("corner", walls(sides, RUBBER)));
    let mut machine = live(layout);
    for ball in 0..3 {
        machine.put_ball(v(0.22 + 0.03 * f64::from(ball), 0.35), v(0.3, 3.0), [0.0; 3]);
    }
    run(&mut machine, 8000, EventKind::Closed);
    for ball in machine.pose().balls {
        assert!(ball.velocity.length() < 1e-3, "{ball:?}");
    }
    assert!(machine.stuck_ticks().iter().all(|&ticks| ticks > 1000), "and the machine knows that they are stuck");
}

#[test]
fn a_ball_search_frees_a_ball_that_lies_on_a_bumper() {
    let mut layout = bare();
    let circle = Circle { center: v(0.25, 0.5), radius: 0.03 };
    layout
        .parts
        .push(part("bumper", Kind::Bumper(Bumper { circle, material: RUBBER, kick_m_s: 0.8, threshold_m_s: 0.05 })));
    let mut machine = live(layout);
    machine.put_ball(v(0.25, 0.5 - 0.03 - BALL_RADIUS_M), v(0.0, 0.0), [0.0; 3]);
    run(&mut machine, 100, EventKind::Closed);
    assert!(velocity(&machine).length() < 1e-3);
    machine.tick(Controls::default(), &[Command::BallSearch]);
    assert!(velocity(&machine).y < -0.7, "{}", velocity(&machine));
}

#[test]
fn a_ball_that_was_put_into_a_wall_comes_out_gently() {
    let mut layout = bare();
    layout.slope_rad = 0.0;
    layout.parts.push(part("wall", walls(vec![Shape::capsule(v(0.1, 0.5), v(0.4, 0.5), 0.003)], RUBBER)));
    let mut machine = live(layout);
    machine.put_ball(v(0.25, 0.5 - 0.003 - BALL_RADIUS_M + 0.002), DVec2::ZERO, [0.0; 3]);
    machine.put_ball(v(0.252, 0.45), DVec2::ZERO, [0.0; 3]);
    machine.put_ball(v(0.252, 0.43), DVec2::ZERO, [0.0; 3]);
    assert!(machine.penetration_m() > 1e-3);
    for _ in 0..300 {
        machine.tick(Controls::default(), &[]);
        assert!(machine.pose().balls.iter().all(|ball| ball.velocity.length() < 0.01));
    }
    assert!(machine.penetration_m() < 5e-5, "{} m deep", machine.penetration_m());
}
