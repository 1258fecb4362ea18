//! The ball search on a whole machine: a ball that lies where no switch is comes free, or another comes instead.

use crate::rules::tests::bench::table;
use crate::{Buttons, Simulation};
use geometry::{Circle, DVec2, Segment, Shape};
use physics::{
    BALL_RADIUS_M, Bumper, EventKind, Kickback, Kind, Magnet, Material, Part, PartId, Saucer, Slingshot, Wall,
};
use std::sync::Arc;

const METAL: Material = Material { restitution: 0.3, falloff_s_per_m: 0.0, friction: 0.2 };
/// A script that waits for nothing but the ball.
const RULES: &str = "fn on_button(name) { start_game(1); flippers(true); kickers(true); }";
/// A script that forgets that its magnet is on.
const MAGNET_RULES: &str = "fn on_button(name) { start_game(1); kickers(true); magnet(\"thing\", true); }";
/// How long a ball may lie, ticks.
const PATIENCE: u64 = 15_000;
/// As far from where it lay a ball is free, m.
const FREE_M: f64 = 0.06;
/// Slower than this it lies, m/s.
const LIES_M_S: f64 = 5e-3;

/// A game without a ball, on a playfield with this on it.
fn game(thing: Kind, walls: Vec<Shape>) -> Simulation {
    let rules = if matches!(thing, Kind::Magnet(_)) { MAGNET_RULES } else { RULES };
    let mut table = table(rules, &["plunger"], &[]);
    let more = [("thing", thing), ("walls", Kind::Wall(Wall { shapes: walls, material: METAL }))];
    table.layout.parts.extend(more.map(|(name, kind)| Part { name: name.into(), kind }));
    let mut game = Simulation::new(Arc::new(table), 1).expect("the rules are sound");
    game.tick(Buttons::START);
    game
}

/// What became of a ball that was put to rest at `place`.
#[derive(Debug, Default, PartialEq)]
struct Fate {
    /// When it last moved before it was free or given up.
    stopped: u64,
    /// When it had left its place.
    free: Option<u64>,
    /// When another ball came.
    fed: Option<u64>,
}

fn watch(mut game: Simulation, place: DVec2) -> Fate {
    game.machine.put_ball(place, DVec2::ZERO, [0.0; 3]);
    let mut fate = Fate { stopped: game.ticks(), ..Fate::default() };
    let mut lay = place;
    while fate.free.is_none() && fate.fed.is_none() && game.ticks() < 3 * PATIENCE {
        game.tick(Buttons::NONE);
        let ball = game.pose().balls[0];
        let searched = game.ticks() > fate.stopped + PATIENCE / 2;
        if !searched && ball.velocity.length() > LIES_M_S {
            (fate.stopped, lay) = (game.ticks(), ball.center);
        }
        if searched && ball.center.distance(lay) > FREE_M {
            fate.free = Some(game.ticks());
        }
        if game.events().any(|event| event.kind == EventKind::Fed) {
            fate.fed = Some(game.ticks());
        }
    }
    fate
}

/// Two guides beside a ball at `center`, so that it can only go up the table.
fn chute(center: DVec2, width: f64) -> Vec<Shape> {
    let side = |x: f64| Shape::capsule(center + DVec2::new(x, 0.03), center + DVec2::new(x, -0.03), 0.002);
    vec![side(-width), side(width)]
}

/// Places all over the playfield.
fn places() -> impl Iterator<Item = DVec2> {
    (0..12).map(|index| DVec2::new(0.08 + 0.07 * f64::from(index % 4), 0.35 + 0.2 * f64::from(index / 4)))
}

/// Asserts that a ball that lies at `place` comes free in time, and that no other had to come.
fn assert_freed(name: &str, game: Simulation, place: DVec2) {
    let fate = watch(game, place);
    assert!(fate.free.is_some_and(|free| free <= fate.stopped + PATIENCE), "{name} at {place}: {fate:?}");
    assert_eq!(fate.fed, None, "{name} at {place}");
}

#[test]
fn a_ball_that_only_a_coil_can_free_is_freed_wherever_it_lies() {
    let beside = BALL_RADIUS_M + 0.003;
    for place in places() {
        let circle = Circle { center: place + DVec2::new(0.0, 0.02 + BALL_RADIUS_M), radius: 0.02 };
        let bumper = Bumper { circle, material: METAL, kick_m_s: 0.8, threshold_m_s: 0.05 };
        assert_freed("a bumper", game(Kind::Bumper(bumper), chute(place, beside)), place);

        let below = place + DVec2::new(0.0, BALL_RADIUS_M + 0.004);
        let segment = Segment { a: below - DVec2::new(0.03, 0.0), b: below + DVec2::new(0.03, 0.0) };
        let sling = Slingshot { segment, radius_m: 0.004, material: METAL, kick_m_s: 2.2, threshold_m_s: 0.2 };
        assert_freed("a slingshot", game(Kind::Slingshot(sling), chute(place, beside)), place);

        let tip = place + DVec2::new(0.0, BALL_RADIUS_M);
        let way = DVec2::new(0.0, -1.0);
        let rod = Kickback { tip, half_width_m: 0.01, direction: way, stroke_m: 0.025, speed_m_s: 3.5 };
        assert_freed("a kickback", game(Kind::Kickback(rod), chute(place, beside)), place);

        let circle = Circle { center: place, radius: 0.014 };
        let saucer = Saucer { circle, capture_m_s: 1.0, eject_m_s: DVec2::new(0.2, -1.0) };
        assert_freed("a saucer", game(Kind::Saucer(saucer), Vec::new()), place);

        let magnet = Magnet { circle: Circle { center: place, radius: 0.045 }, pull_m_s2: 40.0 };
        assert_freed("a magnet", game(Kind::Magnet(magnet), Vec::new()), place);
    }
}

#[test]
fn for_a_ball_that_nothing_can_free_another_comes() {
    for place in places() {
        for half_width in [0.012, 0.014, 0.016, 0.02] {
            // Two sides that meet below the ball, at some angle: it lies in the corner, or between them above it.
            let foot = place + DVec2::new(0.0, 0.03);
            let side = |x: f64| Shape::capsule(foot, place + DVec2::new(x, -0.02), 0.002);
            let walls = vec![side(-half_width - BALL_RADIUS_M), side(half_width + BALL_RADIUS_M)];
            let far = Circle { center: DVec2::new(0.25, 0.1), radius: 0.02 };
            let bumper = Bumper { circle: far, material: METAL, kick_m_s: 0.8, threshold_m_s: 0.05 };
            let fate = watch(game(Kind::Bumper(bumper), walls), place - DVec2::new(0.0, 0.01));
            assert_eq!(fate.free, None, "{place}");
            assert!(fate.fed.is_some_and(|fed| fed <= fate.stopped + PATIENCE), "{place}: {fate:?}");
        }
    }
}

#[test]
fn the_ball_that_comes_is_the_only_one_that_counts() {
    let place = DVec2::new(0.2, 0.5);
    let far = Circle { center: DVec2::new(0.25, 0.1), radius: 0.02 };
    let bumper = Kind::Bumper(Bumper { circle: far, material: METAL, kick_m_s: 0.8, threshold_m_s: 0.05 });
    let side = |x: f64| Shape::capsule(place + DVec2::new(0.0, 0.03), place + DVec2::new(x, -0.02), 0.002);
    let mut game = game(bumper, vec![side(-0.03), side(0.03)]);
    game.machine.put_ball(place, DVec2::ZERO, [0.0; 3]);
    let mut fed = 0;
    for _ in 0..4 * PATIENCE {
        game.tick(Buttons::NONE);
        let plunger = Some(PartId(0));
        fed += game.events().filter(|event| event.kind == EventKind::Fed && event.part == plunger).count();
    }
    assert_eq!(fed, 1, "it waits at the plunger, so that no third ball comes");
    assert_eq!(game.pose().balls.len(), 2);
}
