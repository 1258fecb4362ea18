//! Where and when a ball hits, and how it leaves, against the oracle.

use crate::collision::{Other, Pair};
use crate::distances::{Outline, slope};
use crate::fixture::*;
use crate::oracle::{Field, Path, State};
use geometry::{Arc, Circle, Core, DVec2, Shape, Taper, trig};
use glam::DVec3;
use physics::*;

/// Steps of the oracle.
const STEP_S: f64 = 4e-6;
/// How long a shot may take to its hit.
const LONGEST_S: f64 = 0.02;
/// The most by which a shot may lean from the normal.
const LEAN_RAD: f64 = 1.3;

/// How far the machine is from the oracle, at most.
#[derive(Clone, Copy, Debug, Default)]
struct Errors {
    hits: usize,
    time_s: f64,
    point_m: f64,
    normal_rad: f64,
    /// Over the speed.
    exit: f64,
    /// Of the same machine at 8 kHz.
    exit_8khz: f64,
}

impl Errors {
    fn check(&self, what: &str) {
        println!(
            "{what}: {} hits, time {:.3} us, point {:.3} um, normal {:.5} deg, exit {:.5} %, 8 kHz {:.5} %",
            self.hits,
            self.time_s * 1e6,
            self.point_m * 1e6,
            self.normal_rad.to_degrees(),
            self.exit * 100.0,
            self.exit_8khz * 100.0
        );
        if std::env::var("LOOK").is_ok() { return; }
        assert!(self.hits > 100, "{what}: {} hits only", self.hits);
        assert!(self.time_s < 1e-6, "{what}: {} s", self.time_s);
        assert!(self.point_m < 1e-5, "{what}: {} m", self.point_m);
        assert!(self.normal_rad.to_degrees() < 0.01, "{what}: {} rad", self.normal_rad);
        assert!(self.exit < 0.005, "{what}: {} of the speed", self.exit);
        assert!(self.exit_8khz < 0.005, "{what}: {} of the speed", self.exit_8khz);
    }
}

/// A spin of any kind: rolling, or as chance will have it.
fn any_spin(chance: &mut Chance, velocity: DVec2) -> DVec3 {
    if chance.next() < 0.4 {
        return DVec3::new(-velocity.y, velocity.x, 0.0) / BALL_RADIUS_M;
    }
    let most = velocity.length() / BALL_RADIUS_M;
    DVec3::new(chance.between(-most, most), chance.between(-most, most), chance.between(-most, most))
}

fn any_speed(chance: &mut Chance) -> f64 {
    0.05 * libm::pow(300.0, chance.next())
}

/// A ball that will hit the outline from a place near it.
fn shot_at(outline: &Outline, near: DVec2, chance: &mut Chance) -> Option<State> {
    // From a place near the outline down to its surface, by its own distance.
    let mut touch = near + trig::direction(chance.between(0.0, 6.3)) * 0.1 * chance.next();
    for _ in 0..50 {
        touch -= outline.normal(touch) * (outline.distance(touch) - BALL_RADIUS_M);
    }
    let way = trig::rotate(-outline.normal(touch), chance.between(-LEAN_RAD, LEAN_RAD));
    let velocity = way * any_speed(chance);
    let center = touch - velocity * chance.between(0.0, LONGEST_S).min(0.1 / velocity.length());
    let outside = outline.distance(center) > BALL_RADIUS_M + 1e-6;
    outside.then(|| State { center, velocity, spin: any_spin(chance, velocity) })
}

fn put(machine: &mut Machine, state: &State) {
    machine.put_ball(state.center, state.velocity, state.spin.to_array());
}

/// The first contact, with the tick that it is in, and the machine's balls at that tick's end.
fn first_contact(machine: &mut Machine, controls: Controls, ticks: usize) -> Option<(usize, Contact)> {
    (0..ticks).find_map(|tick| {
        machine.tick(controls, &[]);
        let [contact] = machine.contacts() else { return None };
        Some((tick, *contact))
    })
}

/// One shot's errors.
struct Trial<'a> {
    field: Field,
    path: &'a Path,
    hit: f64,
    pair: Pair,
    material: Material,
}

impl Trial<'_> {
    fn judge(&self, machine: &Machine, controls: Controls, errors: &mut Errors) {
        let mut fast = machine.clone();
        let Some((tick, contact)) = first_contact(&mut fast, controls, 30) else { return };
        let time = tick as f64 * TICK_S + contact.time_s;
        let point = self.pair.ball.center - self.pair.normal * BALL_RADIUS_M;
        let approach = contact.speed_m_s;
        let after = self.pair.part(self.material.restitution_at(approach), self.material.friction);
        let rest = (tick + 1) as f64 * TICK_S - self.hit;
        let exit = Path::new(&self.field, after, rest.max(0.0) + STEP_S, STEP_S).at(rest.max(0.0)).velocity;
        let off = fast.pose().balls[0].velocity - exit;
        errors.hits += 1;
        if std::env::var("LOOK").is_ok() && (time - self.hit).abs() > errors.time_s {
            println!("  {time} {} approach {approach} speed {}", self.hit, self.pair.ball.velocity.length());
        }
        errors.time_s = errors.time_s.max((time - self.hit).abs());
        errors.point_m = errors.point_m.max(contact.point.distance(point));
        errors.normal_rad = errors.normal_rad.max(contact.normal.perp_dot(self.pair.normal).abs());
        errors.exit = errors.exit.max(off.length() / exit.length());
        let mut slow = machine.clone().divided(8);
        if let Some((late, _)) = first_contact(&mut slow, controls, tick + 2) {
            (late..tick).for_each(|_| slow.tick(controls, &[]));
            (tick..late).for_each(|_| fast.tick(controls, &[]));
            let off = slow.pose().balls[0].velocity - fast.pose().balls[0].velocity;
            errors.exit_8khz = errors.exit_8khz.max(off.length() / exit.length());
        }
    }
}

fn judge_shape(what: &str, shape: Shape, outline: Outline, material: Material, near: DVec2) {
    let mut layout = bare();
    layout.parts.push(part("thing", walls(vec![shape], material)));
    let (field, fresh) = (Field::of(&layout), machine(layout));
    let mut chance = Chance(7);
    let mut errors = Errors::default();
    for _ in 0..300 {
        let Some(start) = shot_at(&outline, near, &mut chance) else { continue };
        let path = Path::new(&field, start, 1.5 * LONGEST_S, STEP_S);
        let Some(hit) = path.hit(|_, center| outline.distance(center) - BALL_RADIUS_M) else { continue };
        let ball = path.at(hit);
        let normal = outline.normal(ball.center);
        if -ball.velocity.dot(normal) < libm::cos(LEAN_RAD) * ball.velocity.length() {
            continue;
        }
        let mut machine = fresh.clone();
        put(&mut machine, &start);
        let pair = Pair { ball, other: Other::Wall, normal };
        let trial = Trial { field, path: &path, hit, pair, material };
        trial.judge(&machine, Controls::default(), &mut errors);
    }
    errors.check(what);
}

#[test]
fn a_ball_hits_discs_lines_arcs_and_tapers_where_and_when_it_must() {
    let middle = v(0.25, 0.5);
    let disc = Outline::Disc { center: middle, radius: 0.004 };
    judge_shape("point", Shape::disc(middle, 0.004), disc, RUBBER, middle);
    let (a, b) = (v(0.2, 0.52), v(0.3, 0.47));
    let capsule = |radius| (Shape::capsule(a, b, radius), Outline::Capsule { a, b, radius });
    let (shape, outline) = capsule(0.0);
    judge_shape("segment", shape, outline, WOOD, middle);
    let (shape, outline) = capsule(0.003);
    judge_shape("capsule", shape, outline, RUBBER, middle);
    for (name, line, start, sweep) in [("arc", 0.06, 3.5, 2.4), ("tight arc", 0.02, 0.4, 4.0)] {
        let circle = Circle { center: middle, radius: line };
        let shape = Shape { core: Core::Arc(Arc::new(circle, start, sweep)), radius: 0.002 };
        let outline = Outline::Bow { center: middle, line, start, sweep, radius: 0.002 };
        judge_shape(name, shape, outline, WOOD, middle);
    }
    let (a_radius, b_radius) = (0.0116, 0.007);
    let taper = Taper { a: Circle { center: a, radius: a_radius }, b: Circle { center: b, radius: b_radius } };
    let outline = Outline::Hull { a, a_radius, b, b_radius };
    judge_shape("taper", Shape { core: Core::Taper(taper), radius: 0.0 }, outline, FLIPPER_RUBBER, middle);
}

#[test]
fn two_balls_hit_where_and_when_they_must() {
    let (field, fresh) = (Field::of(&bare()), machine(bare()));
    let mut chance = Chance(11);
    let mut errors = Errors::default();
    for _ in 0..300 {
        let velocity = trig::direction(chance.between(0.0, 6.3)) * chance.between(0.0, 0.5);
        let other = State { center: v(0.25, 0.5), velocity, spin: any_spin(&mut chance, velocity) };
        let disc = Outline::Disc { center: other.center, radius: BALL_RADIUS_M };
        let Some(mut start) = shot_at(&disc, other.center, &mut chance) else { continue };
        start.velocity += velocity;
        let path = Path::new(&field, start, 1.5 * LONGEST_S, STEP_S);
        let way = Path::new(&field, other, 1.5 * LONGEST_S, STEP_S);
        let gap = |time: f64, center: DVec2| center.distance(way.at(time).center) - 2.0 * BALL_RADIUS_M;
        let Some(hit) = path.hit(gap) else { continue };
        let (ball, struck) = (path.at(hit), way.at(hit));
        let normal = (ball.center - struck.center).normalize();
        let closing = struck.velocity - ball.velocity;
        if closing.dot(normal) < libm::cos(LEAN_RAD) * closing.length() {
            continue;
        }
        let mut machine = fresh.clone();
        put(&mut machine, &start);
        put(&mut machine, &other);
        let material = Material { restitution: 0.9, falloff_s_per_m: 0.02, friction: 0.1 };
        let pair = Pair { ball, other: Other::Ball(struck), normal };
        Trial { field, path: &path, hit, pair, material }.judge(&machine, Controls::default(), &mut errors);
    }
    errors.check("ball on ball");
}
