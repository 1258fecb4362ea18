//! Biarcs: a smooth curve as circular arcs whose tangents go on from one to the next.
//!
//! Chords would do for a ball. A mirror or a lens of chords has a focus for each chord: light shows the slope of a curve, not
//! its place, and arcs keep the slope. K. M. Bolton, "Biarc curves", Computer-Aided Design 7, 1975.

use super::path_flattening::Piece;
use geometry::{Arc, Circle, DVec2, Segment, trig};

/// How far the arcs may be from the curve, mm.
const TOLERANCE_MM: f64 = 1e-3;
/// Halvings of a curve at most.
const MOST_HALVINGS: u32 = 9;
/// Places between the ends where the arcs are held against the curve.
const PROBES: [f64; 3] = [0.25, 0.5, 0.75];
/// An arc whose middle is this near to its chord is a line, mm: far below a wavelength.
const STRAIGHT_MM: f64 = 1e-7;

/// A piece and where it ends.
pub(super) type PieceTo = (Piece, DVec2);

/// A place on a curve and the direction of the curve there, of any length.
#[derive(Clone, Copy)]
struct Joint {
    at: DVec2,
    tangent: DVec2,
}

/// The curve from 0 to 1 as arcs and lines, one after the other.
pub(super) fn arcs_along(curve: impl Fn(f64) -> DVec2) -> Vec<PieceTo> {
    let mut pieces = Vec::new();
    halve(&curve, [0.0, 1.0], MOST_HALVINGS, &mut pieces);
    pieces
}

fn halve(curve: &impl Fn(f64) -> DVec2, [from, to]: [f64; 2], halvings: u32, pieces: &mut Vec<PieceTo>) {
    let arcs = biarc(joint(curve, from), joint(curve, to));
    let between = |part: f64| curve(from + (to - from) * part);
    let holds = |arcs: &[PieceTo; 2]| PROBES.iter().all(|part| distance(arcs, between(*part)) <= TOLERANCE_MM);
    match arcs.filter(|arcs| halvings == 0 || holds(arcs)) {
        Some(arcs) => pieces.extend(arcs.into_iter().filter(|(piece, _)| length(piece) > 0.0)),
        None if halvings == 0 => pieces.push((Piece::Segment(Segment { a: curve(from), b: curve(to) }), curve(to))),
        None => {
            let middle = 0.5 * (from + to);
            halve(curve, [from, middle], halvings - 1, pieces);
            halve(curve, [middle, to], halvings - 1, pieces);
        }
    }
}

/// The direction by a difference: a curve whose control points coincide has no derivative at its end, and yet a direction.
fn joint(curve: &impl Fn(f64) -> DVec2, t: f64) -> Joint {
    const STEP: f64 = 1e-5;
    // The parabola through three places, so that the error is of the third order at the ends too.
    let tangent = if t < STEP {
        curve(STEP) * 4.0 - curve(2.0 * STEP) - curve(0.0) * 3.0
    } else if t > 1.0 - STEP {
        curve(1.0) * 3.0 - curve(1.0 - STEP) * 4.0 + curve(1.0 - 2.0 * STEP)
    } else {
        curve(t + STEP) - curve(t - STEP)
    };
    Joint { at: curve(t), tangent: tangent.normalize_or_zero() }
}

/// The two arcs from one joint to another whose legs are equally long; `None` where they turn back.
fn biarc(from: Joint, to: Joint) -> Option<[PieceTo; 2]> {
    let way = to.at - from.at;
    let sum = from.tangent + to.tangent;
    let turn = 1.0 - from.tangent.dot(to.tangent);
    // With legs d: |way - d sum|^2 = (2 d)^2, a quadratic in d whose first coefficient is 2 turn.
    let (square, half) = (way.length_squared(), way.dot(sum));
    let leg = square / (half + (half * half + 2.0 * turn * square).sqrt());
    let middle = (from.at + to.at + (from.tangent - to.tangent) * leg) * 0.5;
    let is_sound = leg > 0.0 && leg.is_finite() && middle.is_finite();
    let first = arc(from.at, from.tangent, middle);
    // The second one from its end, backwards.
    let second = arc(to.at, -to.tangent, middle);
    is_sound.then_some([(first, middle), (second, to.at)])
}

/// The arc that leaves `from` along `tangent` and ends at `to`.
fn arc(from: DVec2, tangent: DVec2, to: DVec2) -> Piece {
    let way = to - from;
    let normal = tangent.perp();
    let across = normal.dot(way);
    if across.abs() < STRAIGHT_MM {
        return Piece::Segment(Segment { a: from, b: to });
    }
    let signed_radius = 0.5 * way.length_squared() / across;
    let center = from + normal * signed_radius;
    // The chord lies at half of the sweep from the tangent.
    let sweep = 2.0 * trig::angle(DVec2::new(tangent.dot(way), across));
    Piece::Arc(Arc::new(Circle { center, radius: signed_radius.abs() }, trig::angle(from - center), sweep))
}

fn length(piece: &Piece) -> f64 {
    match piece {
        Piece::Segment(line) => line.length(),
        Piece::Arc(arc) => 2.0 * arc.half_angle() * arc.circle().radius,
    }
}

/// How far a point is from the nearer of two pieces.
fn distance(pieces: &[PieceTo; 2], point: DVec2) -> f64 {
    let one = |(piece, _): &PieceTo| match piece {
        Piece::Segment(line) => line.closest(point).distance(point),
        Piece::Arc(arc) => arc.closest(point).distance(point),
    };
    one(&pieces[0]).min(one(&pieces[1]))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ends(piece: &Piece) -> [DVec2; 2] {
        match piece {
            Piece::Segment(line) => [line.a, line.b],
            Piece::Arc(arc) => arc.ends(),
        }
    }

    /// The direction of a piece at one of its ends, either way.
    fn tangent(piece: &Piece, at: DVec2) -> DVec2 {
        match piece {
            Piece::Segment(line) => (line.b - line.a).normalize(),
            Piece::Arc(arc) => (at - arc.circle().center).perp().normalize(),
        }
    }

    /// A parabola of chords sent parallel light to a focus for each chord.
    #[test]
    fn a_parabolic_mirror_of_arcs_has_one_focus() {
        let (focal, half) = (60.0, 50.0);
        let parabola = |t: f64| {
            let x = half * (2.0 * t - 1.0);
            DVec2::new(x, x * x / (4.0 * focal))
        };
        let pieces = arcs_along(parabola);
        assert!(pieces.len() < 40, "{}", pieces.len());
        for (piece, _) in &pieces {
            let Piece::Arc(arc) = piece else { continue };
            let place = arc.circle().center + arc.middle() * arc.circle().radius;
            let normal = arc.middle();
            let down = DVec2::NEG_Y;
            let out = down - normal * (2.0 * normal.dot(down));
            let past = out.perp_dot(DVec2::new(0.0, focal) - place).abs();
            assert!(past < 0.05, "{past} mm past the focus");
        }
    }

    #[test]
    fn arcs_follow_one_another_without_a_kink() {
        let cubic = |t: f64| {
            let s = 1.0 - t;
            DVec2::new(0.0, 0.0) * (s * s * s)
                + DVec2::new(120.0, -40.0) * (3.0 * s * s * t)
                + DVec2::new(-30.0, 90.0) * (3.0 * s * t * t)
                + DVec2::new(100.0, 100.0) * (t * t * t)
        };
        let pieces = arcs_along(cubic);
        let mut at = cubic(0.0);
        for pair in pieces.windows(2) {
            let ((piece, to), (next, _)) = (pair[0], pair[1]);
            assert!(ends(&piece).iter().any(|end| end.distance(at) < 1e-9));
            assert!(ends(&piece).iter().any(|end| end.distance(to) < 1e-9));
            assert!(tangent(&piece, to).perp_dot(tangent(&next, to)).abs() < 1e-5, "a kink at {to}");
            at = to;
        }
        assert!(at.distance(cubic(1.0)) < 60.0 && pieces.last().is_some_and(|last| last.1 == cubic(1.0)));
        for step in 0..=1000 {
            let point = cubic(f64::from(step) / 1000.0);
            let nearest =
                pieces.windows(2).map(|pair| distance(&[pair[0], pair[1]], point)).fold(f64::INFINITY, f64::min);
            assert!(nearest < 3.0 * TOLERANCE_MM, "{nearest}");
        }
    }

    #[test]
    fn a_straight_curve_is_a_line_and_a_circle_is_itself() {
        let line = arcs_along(|t| DVec2::new(t * 10.0, t * 5.0));
        assert!(line.iter().all(|(piece, _)| matches!(piece, Piece::Segment(_))));
        let circle = arcs_along(|t| trig::direction(t * 3.0) * 20.0);
        for (piece, _) in circle {
            let Piece::Arc(arc) = piece else { panic!("a line") };
            assert!((arc.circle().radius - 20.0).abs() < 1e-4 && arc.circle().center.length() < 1e-4);
        }
    }
}
