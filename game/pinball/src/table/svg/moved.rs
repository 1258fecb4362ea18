//! A shape moved in the drawing's own text: one `transform` changes, every other byte stays.

use super::drawing::inner_svg;
use super::drawn_shapes::{DrawnShape, DrawnShapes};
use super::page::Page;
use super::text_edit::attributes_start;
use super::transform::Transform;
use super::xml;
use geometry::DVec2;
use roxmltree::Node;
use svgtypes::{TransformListParser, TransformListToken};

impl DrawnShapes {
    /// The drawing as its maker wrote it, but with this shape moved, mm. A shape of a clone moves with all of its clone.
    ///
    /// `None` if the shape is none of this drawing's.
    pub fn moved(&self, shape: &DrawnShape, by_mm: DVec2) -> Option<String> {
        let text = &self.file.text;
        let document = xml::parse(&self.file).ok()?;
        let node = document.descendants().find(|node| node.is_element() && node.range().start == shape.in_file)?;
        let around = around(node).ok()?;
        let by = around.own_vector(by_mm);
        let (range, new) = match node.attribute_node("transform") {
            Some(attribute) => (attribute.range_value(), translated(attribute.value(), by)),
            None => {
                let at = attributes_start(text, node);
                (at..at, format!(" transform=\"{}\"", translated("", by)))
            }
        };
        Some(format!("{}{new}{}", &text[..range.start], &text[range.end..]))
    }
}

/// The coordinates that an element's own transform stands in.
pub(super) fn around(node: Node) -> Result<Transform, String> {
    let mut outer: Vec<Node> = node.ancestors().skip(1).filter(Node::is_element).collect();
    let root = outer.pop().ok_or("it is the drawing itself")?;
    let mut transform = Transform::scaling(Page::of(root)?.mm_per_unit);
    for node in outer.into_iter().rev() {
        transform = transform.transformed(node.attribute("transform").unwrap_or(""))?;
        if node.tag_name().name() == "svg" {
            transform = inner_svg(transform, node)?;
        }
    }
    Ok(transform)
}

/// A `transform` that moves first by `by` and then does what it did; a move that it begins with is made longer.
fn translated(attribute: &str, by: DVec2) -> String {
    let first = TransformListParser::from(attribute).next();
    let (before, rest) = match first {
        Some(Ok(TransformListToken::Translate { tx, ty })) => {
            let end = attribute.find(')').map_or(attribute.len(), |end| end + 1);
            (DVec2::new(tx, ty), attribute[end..].trim_start_matches([' ', ',', '\t', '\n', '\r']))
        }
        _ => (DVec2::ZERO, attribute.trim_start()),
    };
    let by = before + by;
    let gap = if rest.is_empty() { "" } else { " " };
    format!("translate({} {}){gap}{rest}", short(by.x), short(by.y))
}

/// A number to a ten-thousandth, without zeros at its end.
fn short(number: f64) -> String {
    let text = format!("{number:.4}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_string() } else { text.to_string() }
}

#[cfg(test)]
mod tests {
    use super::super::drawn_shapes::{DrawnOutline, DrawnShapes};
    use geometry::DVec2;

    fn read(shapes: &str) -> DrawnShapes {
        let text = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" width=\"400mm\" \
             height=\"200mm\" viewBox=\"0 0 200 100\">{shapes}</svg>"
        );
        DrawnShapes::read("a.svg", text.into_bytes(), &["glass"]).expect("it is sound")
    }

    fn center(drawn: &DrawnShapes, at: usize) -> DVec2 {
        match &drawn.shapes[at].outline {
            DrawnOutline::Circle(circle) => circle.center,
            DrawnOutline::Lines(_) => panic!("a circle was drawn"),
        }
    }

    /// Whatever stands around a shape, it is afterwards where it was dragged to, and nothing else has changed.
    #[test]
    fn a_shape_goes_where_it_is_moved_to() {
        let shapes = [
            "<circle class=\"glass\" cx=\"50\" cy=\"50\" r=\"9\"/>",
            "<circle cx='50' class='glass' transform='rotate(30) translate(2)' cy='50' r='9'/>",
            "<g transform=\"rotate(90) scale(0.5)\"><circle class=\"glass\" cx=\"50\" cy=\"-50\" r=\"9\"\n transform=\"translate(1,2) scale(2)\"/></g>",
            "<style>.big { stroke: red }</style><circle class=\"glass big\" cx=\"50\" cy=\"50\" r=\"9\"/>",
            "<defs><circle id=\"c\" class=\"glass\" cx=\"5\" cy=\"5\" r=\"9\"/></defs><use id=\"u\" xlink:href=\"#c\" x=\"9\"/>",
        ];
        for shapes in shapes {
            let drawn = read(&format!("{shapes}<circle class=\"glass\" cx=\"150\" cy=\"50\" r=\"3\"/>"));
            let by = DVec2::new(11.0, -7.5);
            let text = drawn.moved(&drawn.shapes[0], by).expect("it is there");
            let again = DrawnShapes::read("a.svg", text.clone().into_bytes(), &["glass"]).expect("it is sound");
            let gone = center(&again, 0) - center(&drawn, 0);
            assert!(gone.distance(by) < 1e-3, "{shapes}: {gone}");
            assert_eq!(center(&again, 1), center(&drawn, 1));
            let twice = again.moved(&again.shapes[0], -by).expect("it is there");
            let back = DrawnShapes::read("a.svg", twice.clone().into_bytes(), &["glass"]).expect("it is sound");
            assert!(center(&back, 0).distance(center(&drawn, 0)) < 1e-3);
            assert_eq!(text.matches("translate").count(), twice.matches("translate").count(), "moves are one move");
        }
    }
}
