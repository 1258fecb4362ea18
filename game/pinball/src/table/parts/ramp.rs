//! Ways above the playfield: a line with a height at each of its corners.

use super::M_PER_MM;
use crate::table::svg::element::Element;
use crate::table::svg::outline::Outline;
use crate::table::svg::path_flattening::{Piece, Subpath};
use geometry::{DVec2, Segment};
use physics::{BALL_RADIUS_M, Leg, Material};

/// What a height of a ramp may be, mm.
const HEIGHTS_MM: std::ops::RangeInclusive<f64> = 0.0..=200.0;

/// A ramp or a wire-form: its line is the middle of its floor, and as thick as the ball's way between its sides is wide.
///
/// # Errors
/// If it is not one open line, or its heights are not one for each of its ends and corners.
pub(super) fn ramp(element: &Element, material: Material) -> Result<physics::Ramp, String> {
    let way = match &element.outline {
        Outline::Subpaths(subpaths) => match subpaths.as_slice() {
            [subpath] if !subpath.closed => legs(subpath),
            _ => return Err("it is drawn as one open line, from one of its ends to the other".to_string()),
        },
        Outline::Circle(_) => return Err("it is drawn as one open line, not as a circle".to_string()),
    };
    let heights_m = heights(element, way.len() + 1)?;
    let ball_mm = BALL_RADIUS_M / M_PER_MM;
    if element.radius_mm() <= ball_mm {
        return Err(format!("its stroke-width must be more than a ball's {} mm", 2.0 * ball_mm));
    }
    let tightest = element.radius_mm() + ball_mm;
    if way.iter().any(|leg| matches!(leg, Leg::Turn { arc, .. } if arc.circle().radius / M_PER_MM <= tightest)) {
        return Err(format!("a turn must have a radius of {tightest} or more, half its width and a ball's radius"));
    }
    Ok(physics::Ramp { path: way, heights_m, half_width_m: element.radius_mm() * M_PER_MM, material })
}

fn legs(subpath: &Subpath) -> Vec<Leg> {
    let mut pen = subpath.polygon.first().copied().unwrap_or_default();
    let leg = |piece: &Piece| match *piece {
        Piece::Segment(line) => {
            pen = line.b;
            Leg::Line(Segment { a: line.a * M_PER_MM, b: line.b * M_PER_MM })
        }
        Piece::Arc(arc) => {
            let [first, second] = arc.ends();
            let backwards = nearer(pen, second, first);
            pen = if backwards { first } else { second };
            Leg::Turn { arc: arc.scaled(M_PER_MM), backwards }
        }
    };
    subpath.pieces.iter().map(leg).collect()
}

/// Whether `one` is nearer to `point` than `other` is.
fn nearer(point: DVec2, one: DVec2, other: DVec2) -> bool {
    point.distance_squared(one) < point.distance_squared(other)
}

fn heights(element: &Element, count: usize) -> Result<Vec<f64>, String> {
    let wanted = || {
        format!(
            "data-heights-mm must give {count} heights, one for each end and corner of its line, from {} to {}",
            HEIGHTS_MM.start(),
            HEIGHTS_MM.end()
        )
    };
    let text = element.data.get("heights-mm").ok_or_else(|| format!("it needs heights: {}", wanted()))?;
    let words = text.split([' ', ',']).filter(|word| !word.is_empty());
    let heights: Vec<f64> = words.map(str::parse).collect::<Result<_, _>>().map_err(|_| wanted())?;
    if heights.len() != count || heights.iter().any(|height| !HEIGHTS_MM.contains(height)) {
        return Err(wanted());
    }
    Ok(heights.into_iter().map(|height| height * M_PER_MM).collect())
}
