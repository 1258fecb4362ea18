//! The page: how large a drawing is on the table, and how many millimetres one of its units is.

use super::class_typo;
use geometry::DVec2;
use roxmltree::Node;
use std::str::FromStr;
use svgtypes::{Align, AspectRatio};

/// SVG's namespace.
pub(in crate::table) const SVG: &str = "http://www.w3.org/2000/svg";

/// What a unit of a drawing may be, mm: numbers beyond are a slip.
const MM_PER_UNIT: std::ops::RangeInclusive<f64> = 1e-3..=1e3;
/// The playfield's sides, mm.
const SIDES_MM: std::ops::RangeInclusive<f64> = 50.0..=5000.0;
/// Sides of tables that people can stand at, mm. A real playfield is about 514 x 1067.
const USUAL_MM: std::ops::RangeInclusive<f64> = 200.0..=1500.0;
/// Scales this near to 1 are 1, and scales this near to each other are equal: sizes are rounded when they are saved.
const ROUNDED: f64 = 1e-4;
/// Scales across and down that are farther from each other than this are told: half a millimetre on a playfield.
const UNEQUAL: f64 = 1e-3;

/// Lengths that say how large something is in print, mm. `px` are units, whatever a screen makes of them.
const UNITS_MM: [(&str, f64); 6] =
    [("mm", 1.0), ("cm", 10.0), ("in", 25.4), ("pt", 25.4 / 72.0), ("pc", 25.4 / 6.0), ("q", 0.25)];
/// Other units of CSS, which say nothing of millimetres.
const OTHER_UNITS: [&str; 14] =
    ["px", "%", "em", "ex", "rem", "ch", "vw", "vh", "vmin", "vmax", "vi", "vb", "lh", "rlh"];

/// The page of a drawing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::table) struct Page {
    /// Of the playfield.
    pub size_mm: DVec2,
    /// Millimetres in a unit of the drawing.
    pub mm_per_unit: f64,
    /// Millimetres in a unit across and down, as width and height say them, where one was taken for both.
    unequal: Option<[f64; 2]>,
}

impl Page {
    /// The page that a drawing's first element says, or what is wrong with it.
    pub fn of(root: Node) -> Result<Page, String> {
        if root.tag_name().name() != "svg" || root.tag_name().namespace() != Some(SVG) {
            return Err(format!("the drawing must begin with <svg xmlns=\"{SVG}\" ...>"));
        }
        if root.has_attribute("transform") {
            return Err("the drawing as a whole has a transform; give it to a <g> around everything".to_string());
        }
        let expected = "viewBox=\"0 0 WIDTH HEIGHT\", the playfield's size in millimetres";
        let text = root.attribute("viewBox").ok_or_else(|| match misspelt_view_box(root) {
            Some(word) => format!("an svg has no `{word}`; did you mean `viewBox`?"),
            None => format!("the drawing has no viewBox; write {expected}"),
        })?;
        let numbers: Vec<f64> = text.split([',', ' ']).filter(|word| !word.is_empty()).flat_map(str::parse).collect();
        let units = match numbers[..] {
            [x, y, width, height] if x == 0.0 && y == 0.0 && width > 0.0 && height > 0.0 => DVec2::new(width, height),
            _ => return Err(format!("the viewBox is `{text}`; write {expected}")),
        };
        let Scale { mm_per_unit, unequal } = scale(root, units)?;
        if !MM_PER_UNIT.contains(&mm_per_unit) {
            return Err(format!(
                "the viewBox is `{text}`, so that a unit is {mm_per_unit:e} mm; give it about as many units as there are \
                 millimetres"
            ));
        }
        let size_mm = units * mm_per_unit;
        if size_mm.to_array().iter().all(|side| SIDES_MM.contains(side)) {
            return Ok(Page { size_mm, mm_per_unit, unequal });
        }
        let size = match mm_per_unit {
            1.0 => String::new(),
            _ => format!(" and the playfield {} x {} mm", rounded(size_mm.x), rounded(size_mm.y)),
        };
        Err(format!(
            "the viewBox is `{text}`{size}; write {expected}, each side from {} to {}",
            SIDES_MM.start(),
            SIDES_MM.end()
        ))
    }

    /// What is odd about the size.
    pub fn warnings(&self) -> impl Iterator<Item = String> {
        self.unequal_warning().into_iter().chain(self.unusual_warning())
    }

    fn unequal_warning(&self) -> Option<String> {
        let [across, down] = self.unequal?;
        let (taken, DVec2 { x, y }) = (self.mm_per_unit, self.size_mm);
        Some(format!(
            "width and height do not fit the viewBox: they say {across:.4} mm a unit across and {down:.4} down; {taken:.4} \
             was taken for both, so the playfield is {} x {} mm; give width and height in the viewBox's proportion",
            rounded(x),
            rounded(y)
        ))
    }

    fn unusual_warning(&self) -> Option<String> {
        let DVec2 { x, y } = self.size_mm;
        let odd = ![x, y].iter().all(|side| USUAL_MM.contains(side));
        odd.then(|| {
            format!(
                "the playfield is {} x {} mm, and a real one about 514 x 1067; the drawing's width and height, written \
                 with mm, and its viewBox say together how large it is",
                rounded(x),
                rounded(y)
            )
        })
    }
}

/// What was to be the drawing's viewBox, but for case or a letter.
fn misspelt_view_box<'a>(root: Node<'a, '_>) -> Option<&'a str> {
    root.attributes().map(|own| own.name()).find(|name| class_typo::nearest(name, ["viewBox"]).is_some())
}

/// How long a unit of a drawing is, for a sentence: `one unit is one millimetre`.
pub(in crate::table) fn unit(node: Node) -> String {
    let page = node.ancestors().filter(Node::is_element).last().map(Page::of);
    match page {
        Some(Ok(Page { mm_per_unit, .. })) if mm_per_unit != 1.0 => {
            format!("a unit of this drawing is {} mm", (mm_per_unit * 1e4).round() * 1e-4)
        }
        _ => "one unit is one millimetre".to_string(),
    }
}

/// A length to a hundredth, for a sentence.
pub(super) fn rounded(mm: f64) -> f64 {
    (mm * 100.0).round() / 100.0
}

/// What the size in print says of a drawing's units.
struct Scale {
    mm_per_unit: f64,
    /// See [`Page::unequal`].
    unequal: Option<[f64; 2]>,
}

/// Millimetres in a unit: what the size in print says, 1 where it says nothing.
fn scale(root: Node, units: DVec2) -> Result<Scale, String> {
    let side = |name: &str, units: f64| match root.attribute(name).map_or(Ok(None), |text| length_mm(name, text))? {
        Some(mm) => Ok(Some(mm / units)),
        None => Ok::<_, String>(None),
    };
    let (scale, unequal) = match (side("width", units.x)?, side("height", units.y)?) {
        (Some(x), Some(y)) => (both(root, x, y)?, ((x - y).abs() > UNEQUAL * x.max(y)).then_some([x, y])),
        (Some(one), None) | (None, Some(one)) => (one, None),
        (None, None) => (1.0, None),
    };
    Ok(Scale { mm_per_unit: if (scale - 1.0).abs() <= ROUNDED { 1.0 } else { scale }, unequal })
}

/// One scale of two, as `preserveAspectRatio` says.
fn both(root: Node, x: f64, y: f64) -> Result<f64, String> {
    if (x - y).abs() <= ROUNDED * x.max(y) {
        return Ok(x);
    }
    let text = root.attribute("preserveAspectRatio").unwrap_or("xMidYMid");
    let aspect = AspectRatio::from_str(text)
        .map_err(|_| format!("preserveAspectRatio is `{text}`, which says nothing; take it out"))?;
    match aspect {
        AspectRatio { align: Align::None, .. } => Err(format!(
            "its width and height stretch its viewBox ({x:.4} mm a unit across and {y:.4} down), so a ball would be no \
             circle; give width and height in the viewBox's proportion, or take preserveAspectRatio out"
        )),
        AspectRatio { slice: true, .. } => Ok(x.max(y)),
        _ => Ok(x.min(y)),
    }
}

/// A length in print, if it is one.
fn length_mm(name: &str, text: &str) -> Result<Option<f64>, String> {
    let text = text.trim();
    let lower = text.to_ascii_lowercase();
    let number = lower.trim_end_matches(|letter: char| letter.is_alphabetic() || letter == '%');
    let unit = &lower[number.len()..];
    let known = UNITS_MM.iter().find(|(known, _)| *known == unit);
    match (number.trim_end().parse::<f64>(), known) {
        (Ok(number), Some((_, mm))) if number.is_finite() && number > 0.0 => Ok(Some(number * mm)),
        (Ok(_), None) if unit.is_empty() || OTHER_UNITS.contains(&unit) => Ok(None),
        (Ok(_), None) => Err(format!(
            "the drawing's {name} is `{text}`, and there is no unit `{unit}`; there are mm, cm, in, pt, pc and Q; with px, or \
             without a unit, one unit of the viewBox is one millimetre"
        )),
        (Err(_), None) if !UNITS_MM.iter().any(|(known, _)| unit.ends_with(known)) => Ok(None),
        _ => Err(format!("the drawing's {name} is `{text}`; write a length like \"514mm\"")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn page(attributes: &str) -> Result<Page, String> {
        let svg = format!("<svg xmlns=\"{SVG}\" {attributes}/>");
        Page::of(roxmltree::Document::parse(&svg).unwrap().root_element())
    }

    #[track_caller]
    fn is(attributes: &str, size: (f64, f64), mm_per_unit: f64) {
        let page = page(attributes).unwrap();
        let near = (page.size_mm - DVec2::from(size)).length() < 1e-9 && (page.mm_per_unit - mm_per_unit).abs() < 1e-12;
        assert!(near, "{attributes}: {page:?}");
    }

    #[test]
    fn units_and_pixels_are_millimetres() {
        for attributes in ["", "width=\"514\" height=\"1067\"", "width=\"1028px\" height=\"2134px\"", "width=\"100%\""]
        {
            is(&format!("viewBox=\"0 0 514 1067\" {attributes}"), (514.0, 1067.0), 1.0);
        }
    }

    #[test]
    fn a_width_in_print_sets_the_scale() {
        let pixels = "viewBox=\"0 0 1680 3600\"";
        is(&format!("{pixels} width=\"420mm\" height=\"900mm\""), (420.0, 900.0), 0.25);
        is(&format!("{pixels} width=\"42 cm\""), (420.0, 900.0), 0.25);
        is(&format!("{pixels} height=\"3600Q\" width=\"100%\""), (420.0, 900.0), 0.25);
        is("viewBox=\"0 0 400 800\" width=\"20in\"", (508.0, 1016.0), 1.27);
        is("viewBox=\"0 0 1440 2880\" width=\"1440PT\" height=\"240pc\"", (508.0, 1016.0), 25.4 / 72.0);
    }

    #[test]
    fn a_size_that_was_rounded_when_it_was_saved_is_the_size() {
        let Page { mm_per_unit, .. } = page("viewBox=\"0 0 514.00002 1067\" width=\"514mm\"").unwrap();
        assert_eq!(mm_per_unit, 1.0);
    }

    #[test]
    fn two_scales_are_one_or_a_mistake() {
        let wide = "viewBox=\"0 0 500 1000\" width=\"1000mm\" height=\"1000mm\"";
        is(wide, (500.0, 1000.0), 1.0);
        let told: Vec<String> = page(wide).unwrap().warnings().collect();
        let [told] = &told[..] else { panic!("{told:?}") };
        assert!(
            told.contains("2.0000 mm a unit across and 1.0000 down; 1.0000 was taken for both")
                && told.contains("500 x 1000"),
            "{told}"
        );
        is(&format!("{wide} preserveAspectRatio=\"xMinYMin slice\""), (1000.0, 2000.0), 2.0);
        let why = page(&format!("{wide} preserveAspectRatio=\"none\"")).unwrap_err();
        assert!(why.contains("2.0000 mm a unit across and 1.0000 down"), "{why}");
        assert!(page(&format!("{wide} preserveAspectRatio=\"maybe\"")).unwrap_err().contains("`maybe`"));
    }

    #[test]
    fn sizes_that_are_none_are_mistakes() {
        for wrong in ["0mm", "-5mm", "mm", "nanmm", "1e999mm"] {
            let why = page(&format!("viewBox=\"0 0 500 1000\" width=\"{wrong}\"")).unwrap_err();
            assert!(why.contains(&format!("width is `{wrong}`")), "{why}");
        }
        let why = page("viewBox=\"0 0 500 1000\" width=\"5mm\"").unwrap_err();
        assert!(why.contains("the playfield 5 x 10 mm"), "{why}");
        assert!(page("viewBox=\"0 0 500 1000\" transform=\"scale(2)\"").unwrap_err().contains("a transform"));
    }

    /// `473.5mn` was one unit of the drawing for a millimetre, in silence.
    #[test]
    fn a_unit_that_css_does_not_have_is_a_mistake() {
        for (width, unit) in [("473.5mn", "mn"), ("10m", "m"), ("5 0", ""), ("20 inch", "inch")] {
            let page = page(&format!("viewBox=\"0 0 500 1000\" width=\"{width}\" height=\"{width}\""));
            let expected =
                format!("the drawing's width is `{width}`, and there is no unit `{unit}`; there are mm, cm, in,");
            match unit {
                "" => assert_eq!(page.unwrap().mm_per_unit, 1.0),
                _ => assert!(page.as_ref().unwrap_err().starts_with(&expected), "{page:?}"),
            }
        }
        for width in OTHER_UNITS.map(|unit| format!("9{unit}")).iter().chain(&["auto".to_string(), "1e3".to_string()]) {
            is(&format!("viewBox=\"0 0 500 1000\" width=\"{width}\""), (500.0, 1000.0), 1.0);
        }
    }

    #[test]
    fn an_odd_size_is_warned_of() {
        let warning = |sides: &str| page(&format!("viewBox=\"0 0 {sides}\"")).unwrap().warnings().next();
        assert_eq!((warning("200 1500"), warning("514 1067")), (None, None));
        assert!(warning("1587.4016 3401.5748").unwrap().contains("1587.4 x 3401.57 mm"));
        assert!(warning("199 400").is_some());
    }
}
