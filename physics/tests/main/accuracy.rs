//! Where and when a ball hits, and how it leaves, against the oracle.

use crate::collision::{Other, Pair};
use crate::distances::{Outline, slope};
use crate::fixture::*;
use crate::oracle::{Field, Path, State};
use crate::strokes::{Stroke, numbers, outline_at};
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
    /// Of the same machine in eight times as many steps.
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

/// The tick of the first contact, and how many there are in it.
fn first_contact(machine: &mut Machine, controls: Controls, ticks: usize) -> Option<(usize, usize)> {
    (0..ticks).find_map(|tick| {
        machine.tick(controls, &[]);
        let count = machine.contacts().len();
        (count > 0).then_some((tick, count))
    })
}

/// One shot's errors.
struct Trial {
    field: Field,
    hit: f64,
    pair: Pair,
    material: Material,
    /// Of the slow twin: eight times as many steps in a tick as the machine takes.
    divisions: u32,
}

impl Trial {
    /// Compares where, when and how the machine hits, and how the ball leaves.
    fn judge(&self, machine: &Machine, controls: Controls, errors: &mut Errors) {
        let mut fast = machine.clone();
        let Some((tick, count)) = first_contact(&mut fast, controls, 35) else { return };
        let contact = fast.contacts()[0];
        let point = self.pair.ball.center - self.pair.normal * BALL_RADIUS_M;
        errors.hits += 1;
        errors.time_s = errors.time_s.max((tick as f64 * TICK_S + contact.time_s - self.hit).abs());
        errors.point_m = errors.point_m.max(contact.point.distance(point));
        errors.normal_rad = errors.normal_rad.max(contact.normal.perp_dot(self.pair.normal).abs());
        if count == 1 {
            self.judge_exit(machine, fast, controls, tick, errors);
        }
    }

    /// Compares the velocity at the end of the hit's tick, of the machine, of its slow twin and of the oracle.
    fn judge_exit(&self, machine: &Machine, mut fast: Machine, controls: Controls, tick: usize, errors: &mut Errors) {
        let restitution = self.material.restitution_at(fast.contacts()[0].speed_m_s);
        let after = self.pair.part(restitution, self.material.friction);
        let rest = ((tick + 1) as f64 * TICK_S - self.hit).max(0.0);
        let exit = Path::new(&self.field, after, rest + STEP_S, STEP_S).at(rest).velocity;
        let off = |one: &Machine, other: DVec2| (one.pose().balls[0].velocity - other).length() / exit.length();
        errors.exit = errors.exit.max(off(&fast, exit));
        let mut slow = machine.clone().substepped(self.divisions);
        if let Some((late, 1)) = first_contact(&mut slow, controls, tick + 2) {
            (late..tick).for_each(|_| slow.tick(controls, &[]));
            (tick..late).for_each(|_| fast.tick(controls, &[]));
            errors.exit_8khz = errors.exit_8khz.max(off(&slow, fast.pose().balls[0].velocity));
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
        let trial = Trial { field, hit, pair, material, divisions: 8 };
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
        Trial { field, hit, pair, material, divisions: 8 }.judge(&machine, Controls::default(), &mut errors);
    }
    errors.check("ball on ball");
}

/// A ball that comes to the flipper when it is where it will be in some milliseconds.
fn shot_at_flipper(stroke: &Stroke, chance: &mut Chance) -> Option<State> {
    let time = chance.between(0.0, LONGEST_S);
    let outline = outline_at(stroke.at(time));
    let part = chance.between(-0.01, 0.07);
    let pivot = numbers().base.center;
    let along = trig::direction(stroke.at(time));
    let mut touch = pivot + along * part + along.perp() * if chance.next() < 0.8 { -0.05 } else { 0.05 };
    for _ in 0..50 {
        touch -= outline.normal(touch) * (outline.distance(touch) - BALL_RADIUS_M);
    }
    let way = trig::rotate(-outline.normal(touch), chance.between(-LEAN_RAD, LEAN_RAD));
    let velocity = way * any_speed(chance);
    let time = time.min(0.1 / velocity.length());
    let center = touch - velocity * time;
    let clear = outline_at(stroke.at(0.0)).distance(center) > BALL_RADIUS_M + 1e-6;
    clear.then(|| State { center, velocity, spin: any_spin(chance, velocity) })
}

/// The pair that meets at `time`, if the flipper then turns evenly or lies on its lower stop and is pressed on it.
fn pair_at(stroke: &Stroke, path: &Path, time: f64) -> Option<Pair> {
    let ball = path.at(time);
    let (angle, turn) = (stroke.at(time), stroke.turn(time));
    let normal = slope(|center| outline_at(angle).distance(center), ball.center);
    let Flipper { base, length_m, tip_radius_m, mass_kg, rest_rad, .. } = numbers();
    let lever = ball.center - normal * BALL_RADIUS_M - base.center;
    let closing = turn * lever.perp() - ball.velocity;
    let straight = closing.dot(normal) > libm::cos(LEAN_RAD) * closing.length();
    let end = length_m + tip_radius_m;
    let rests = (angle - rest_rad).abs() < 1e-9 && turn.abs() < 1e-6;
    let presses = rests && lever.perp_dot(-normal) > 1e-3;
    let inertia = if presses { f64::INFINITY } else { mass_kg * end * end / 3.0 };
    let known = presses || (turn.abs() > 1.0 && stroke.is_smooth(time));
    let other = Other::Rotor { pivot: base.center, turn, inertia };
    (straight && known).then_some(Pair { ball, other, normal })
}

#[test]
fn a_ball_hits_a_turning_flipper_where_and_when_it_must() {
    let mut layout = bare();
    layout.parts.push(flipper(true));
    let field = Field::of(&layout);
    let mut resting = machine(layout);
    resting.tick(Controls::default(), &[Command::SetFlippers(true)]);
    let up = Controls { left: true, ..Controls::default() };
    let mut raised = resting.clone();
    (0..150).for_each(|_| raised.tick(up, &[]));
    let mut chance = Chance(13);
    for (what, fresh, controls, longest) in [
        ("flipper at rest", &resting, Controls::default(), 0.0),
        ("flipper on its way up", &resting, up, 22.0),
        ("flipper on its way down", &raised, Controls::default(), 70.0),
    ] {
        let mut errors = Errors::default();
        let mut stroke = Stroke::of(fresh, controls);
        for _ in 0..1200 {
            let mut fresh = fresh.clone();
            stroke.from = chance.between(0.0, longest) as usize;
            (0..stroke.from).for_each(|_| fresh.tick(controls, &[]));
            let Some(start) = shot_at_flipper(&stroke, &mut chance) else { continue };
            let path = Path::new(&field, start, 1.5 * LONGEST_S, STEP_S);
            let gap = |time: f64, center: DVec2| outline_at(stroke.at(time)).distance(center) - BALL_RADIUS_M;
            let Some(hit) = path.hit(gap) else { continue };
            let Some(pair) = pair_at(&stroke, &path, hit) else { continue };
            put(&mut fresh, &start);
            let divisions = if longest > 0.0 { 8 * 32 } else { 8 };
            Trial { field, hit, pair, material: FLIPPER_RUBBER, divisions }.judge(&fresh, controls, &mut errors);
        }
        errors.check(what);
    }
}
