//! Outlines: what one element draws, on the table, in millimetres.

use super::path_data;
use super::path_flattening::{self, Curves, Ellipse, PathFlattener, Piece, Subpath};
use super::style;
use super::transform::Transform;
use geometry::{Bounds, Circle, DVec2, Segment};
use roxmltree::Node;

/// What one element draws.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::table) enum Outline {
    /// A circle.
    Circle(Circle),
    /// Lines, at least one, each with some length.
    Subpaths(Vec<Subpath>),
}

impl Outline {
    /// What `node` draws at `place`, which enlarges by `scale`; its curves become these.
    pub fn of(node: Node, transform: Transform, scale: f64, curves: Curves) -> Result<Outline, String> {
        let mut pen = PathFlattener::new(transform, scale, curves);
        match node.tag_name().name() {
            "circle" => return circle(node, transform, scale).map(Outline::Circle),
            "line" => {
                if !node.has_attribute("x2") && !node.has_attribute("y2") {
                    return Err("it has neither `x2` nor `y2`, so nobody knows where it ends".to_string());
                }
                pen.start(point(node, "x1", "y1")?)?;
                pen.line(point(node, "x2", "y2")?)?;
            }
            "rect" => rect(node, &mut pen)?,
            "ellipse" if curves == Curves::Arcs => ellipse(node, &mut pen)?,
            "polyline" => corners(node, &mut pen)?,
            "polygon" => {
                corners(node, &mut pen)?;
                pen.close()?;
            }
            "path" => path_data::draw(&mut pen, required(node, "d")?)?,
            "g" => return Err("a group is no thing: give the class to each shape in it instead".to_string()),
            other => {
                let article = if other == "ellipse" { "an" } else { "a" };
                return Err(format!(
                    "a thing cannot be {article} `{other}`: draw it as line, polyline, polygon, path, circle or rect"
                ));
            }
        }
        let subpaths = pen.finish();
        if subpaths.is_empty() { Err("it has no length".to_string()) } else { Ok(Outline::Subpaths(subpaths)) }
    }

    /// The one straight line that this is.
    pub fn line(&self) -> Option<Segment> {
        match self {
            Outline::Subpaths(subpaths) => match subpaths.as_slice() {
                [Subpath { pieces, .. }] => match pieces.as_slice() {
                    [Piece::Segment(segment)] => Some(*segment),
                    _ => None,
                },
                _ => None,
            },
            Outline::Circle(_) => None,
        }
    }

    /// The circle that this is.
    pub fn circle(&self) -> Option<Circle> {
        match self {
            Outline::Circle(circle) => Some(*circle),
            Outline::Subpaths(_) => None,
        }
    }

    /// The closed polygons that this is, if all of it is closed.
    pub fn polygons(&self) -> Option<Vec<Vec<DVec2>>> {
        match self {
            Outline::Circle(circle) => Some(vec![path_flattening::circle_polygon(*circle)]),
            Outline::Subpaths(subpaths) => {
                let closed = subpaths.iter().all(|subpath| subpath.closed && subpath.polygon.len() > 2);
                closed.then(|| subpaths.iter().map(|subpath| subpath.polygon.clone()).collect())
            }
        }
    }

    /// How many pieces and corners it has.
    pub fn pieces(&self) -> usize {
        match self {
            Outline::Circle(_) => 1,
            Outline::Subpaths(subpaths) => {
                subpaths.iter().map(|subpath| subpath.pieces.len() + subpath.polygon.len()).sum()
            }
        }
    }

    /// The smallest box around it.
    pub fn bounds(&self) -> Bounds {
        match self {
            Outline::Circle(circle) => circle.bounds(),
            Outline::Subpaths(subpaths) => {
                let boxes = subpaths.iter().flat_map(|subpath| &subpath.pieces).map(|piece| piece.shape(0.0).bounds());
                boxes.reduce(Bounds::union).unwrap_or(Bounds::of(DVec2::ZERO, DVec2::ZERO))
            }
        }
    }
}

fn required<'a>(node: Node<'a, '_>, name: &str) -> Result<&'a str, String> {
    node.attribute(name).ok_or_else(|| format!("it has no `{name}`"))
}

fn number(node: Node, name: &str) -> Result<f64, String> {
    node.attribute(name).map_or(Ok(0.0), |text| style::length(node, text, name))
}

fn point(node: Node, x: &str, y: &str) -> Result<DVec2, String> {
    Ok(DVec2::new(number(node, x)?, number(node, y)?))
}

fn circle(node: Node, transform: Transform, scale: f64) -> Result<Circle, String> {
    required(node, "r")?;
    let middle = point(node, "cx", "cy")?;
    let radius = number(node, "r")? * scale;
    let center = transform.point(middle.x, middle.y);
    if radius.is_finite() && radius > 0.0 && center.is_finite() {
        Ok(Circle { center, radius })
    } else {
        Err("its radius `r` must be more than 0".to_string())
    }
}

fn ellipse(node: Node, pen: &mut PathFlattener) -> Result<(), String> {
    let (middle, radii) = (point(node, "cx", "cy")?, point(node, "rx", "ry")?);
    if radii.min_element() <= 0.0 {
        return Err("its radii `rx` and `ry` must be more than 0".to_string());
    }
    let half = Ellipse { rx: radii.x, ry: radii.y, turn_deg: 0.0, large: false, sweep: true };
    let ends = [middle - DVec2::X * radii.x, middle + DVec2::X * radii.x];
    pen.start(ends[0])?;
    pen.arc(ends[0], half, ends[1])?;
    pen.arc(ends[1], half, ends[0])?;
    pen.close()
}

fn corners(node: Node, pen: &mut PathFlattener) -> Result<(), String> {
    let text = required(node, "points")?;
    let numbers: Result<Vec<f64>, String> = text
        .split(|c: char| c == ',' || c.is_ascii_whitespace())
        .filter(|word| !word.is_empty())
        .map(|word| style::length(node, word, "points"))
        .collect();
    let numbers = numbers?;
    if numbers.len() % 2 == 1 || numbers.len() < 4 {
        return Err("its `points` must be two or more pairs of numbers".to_string());
    }
    for (index, pair) in numbers.chunks_exact(2).enumerate() {
        let corner = DVec2::new(pair[0], pair[1]);
        if index == 0 { pen.start(corner)? } else { pen.line(corner)? }
    }
    Ok(())
}

fn rect(node: Node, pen: &mut PathFlattener) -> Result<(), String> {
    let corner = point(node, "x", "y")?;
    let size = point(node, "width", "height")?;
    if size.min_element() <= 0.0 {
        return Err("its `width` and `height` must be more than 0".to_string());
    }
    let rx = node.attribute("rx").or_else(|| node.attribute("ry"));
    let rx = rx.map_or(Ok(0.0), |text| style::length(node, text, "rx"))?;
    let ry = node.attribute("ry").map_or(Ok(rx), |text| style::length(node, text, "ry"))?;
    if rx < 0.0 || ry != rx {
        return Err("its corners `rx` and `ry` must be equal, and 0 or more".to_string());
    }
    let round = rx.min(size.min_element() * 0.5);
    let at = |x: f64, y: f64| corner + size * DVec2::new(x, y);
    // Each corner: where the round begins, and where it ends.
    let [right, down] = [DVec2::X * round, DVec2::Y * round];
    let corners = [
        (at(1.0, 0.0) - right, at(1.0, 0.0) + down),
        (at(1.0, 1.0) - down, at(1.0, 1.0) - right),
        (at(0.0, 1.0) + right, at(0.0, 1.0) - down),
        (at(0.0, 0.0) + down, at(0.0, 0.0) + right),
    ];
    pen.start(corners[3].1)?;
    for (begin, end) in corners {
        pen.line(begin)?;
        pen.arc(begin, Ellipse::corner(round), end)?;
    }
    pen.close()
}
