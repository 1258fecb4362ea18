//! Art that cannot be printed, or not in time, is refused in a sentence before anything is printed.

use super::VIEW;
use crate::art;
use crate::small_table::{read, table};

/// What is said of art; empty if it may be printed.
fn refusal(drawn: &str) -> String {
    let checked = read(drawn, "").and_then(|table| art::check(&table).map_err(|failure| vec![failure.to_string()]));
    checked.err().map_or_else(String::new, |mistakes| mistakes.join("\n"))
}

fn refuses(drawn: &str, sentence: &str) {
    let told = refusal(drawn);
    assert!(told.contains(sentence) && told.lines().count() == 1, "{sentence:?}: {told:?}");
}

/// A filter on a rectangle that covers the playfield.
fn filtered(primitives: &str) -> String {
    format!(
        "<filter id=\"f\" x=\"0\" y=\"0\" width=\"1\" height=\"1\">{primitives}</filter>\n\
         <rect id=\"sky\" width=\"500\" height=\"1000\" filter=\"url(#f)\"/>"
    )
}

/// A corner at -2147483649 mm made the rasteriser panic, while `check` said that all was well; with arcs in the same path
/// it took the process down.
#[test]
fn art_with_a_corner_at_the_end_of_the_world_is_refused() {
    refuses(
        r#"<path id="far" d="M12 668 L408 838 L-2147483649 812 V704 L458 668 V914 L284 992 Z" fill="red"/>"#,
        "line 5: path `far`: the number 2147483649 in it is too large; 10000000 is the most",
    );
    refuses(
        r#"<g id="wood" class="wood"><path d="M12 668 A36 36 0 0 1 48 704 V812 L62 838 L145 892 L146 912 L205 950 H265 L324
           912 L325 892 L408 838 L-2147483649 812 V704 A36 36 0 0 1 458 668 V914 L284 992 V1067 H186 V992 L12 914 Z"/></g>"#,
        "the number 2147483649 in it is too large",
    );
}

#[test]
fn whatever_makes_art_reach_far_is_refused_too() {
    for drawn in [
        r#"<rect width="9" height="9" transform="scale(1e7)"/>"#,
        r#"<rect width="9" height="9" transform="translate(-1e7 3)"/>"#,
        r#"<line x1="1" y1="1" x2="9" y2="9" stroke="red" stroke-width="1e7"/>"#,
        r#"<text x="3" y="90" font-size="1e7">far</text>"#,
        r#"<mask id="m" maskUnits="userSpaceOnUse" x="0" y="0" width="1e7" height="9"><rect width="9" height="9"/></mask>
           <rect width="9" height="9" mask="url(#m)"/>"#,
        r#"<clipPath id="c"><path d="M0 0H9V1e7Z"/></clipPath><rect width="9" height="9" clip-path="url(#c)"/>"#,
        r#"<pattern id="p" patternUnits="userSpaceOnUse" width="9" height="9"><path d="M0 0H9V1e7Z"/></pattern>
           <rect width="9" height="9" fill="url(#p)"/>"#,
        r#"<pattern id="p" patternUnits="userSpaceOnUse" width="1e7" height="1e7"><path d="M0 0H9V9Z"/></pattern>
           <rect width="9" height="9" fill="url(#p)"/>"#,
        r#"<svg width="9" height="9" viewBox="0 0 1e-9 1e-9"><rect width="9" height="9"/></svg>"#,
    ] {
        refuses(drawn, "reaches too far beyond the playfield to be printed; cut it off");
    }
    let region = |side: &str| {
        format!(
            r#"<filter id="f" filterUnits="userSpaceOnUse" x="0" y="0" width="{side}" height="{side}"><feFlood/></filter>
            <rect id="sky" width="9" height="9" filter="url(#f)"/>"#
        )
    };
    refuses(&region("1e7"), "too far beyond");
    refuses(&region("9000"), "the filter `f` of `sky` in line 6 reaches more than two playfields beyond the playfield");
    assert_eq!(refusal(&region("900")), "");
}

/// An arc of 1e300 mm is cut into more curves than there is memory.
#[test]
fn numbers_without_measure_are_refused() {
    for drawn in [
        r#"<path d="M1 1A1e300 1e300 0 0 1 9 9"/>"#,
        r#"<circle r="3e38"/>"#,
        r#"<rect width="9" height="9" style="rx: 3e38"/>"#,
        r#"<g font-size="1e38"><text x="9">far</text></g>"#,
        r#"<rect width="9" height="9" style="filter: blur(1e38px)"/>"#,
        r#"<rect width="9" height="9" filter="drop-shadow(1e38px 0 3px red)"/>"#,
    ] {
        refuses(drawn, "line 5: ");
        refuses(drawn, "in it is too large; 10000000 is the most");
    }
    refuses(
        r#"<rect id="r" width="9" height="9" style="filter: blur(1e-38px)"/>"#,
        "line 5: rect `r`: the number 1e-38 in it is too small; write 0, or 1e-9 at least",
    );
    refuses(r#"<circle id="c" r="9em"/>"#, "line 5: circle `c`: its r is given in letters; give it as a number");
}

#[test]
fn filters_that_take_too_long_are_refused() {
    refuses(
        &filtered(r#"<feTurbulence baseFrequency=".01" numOctaves="1000000"/>"#),
        "million pixel operations to be printed, and 10000 million is the most; the most takes `sky` in line 6, ",
    );
    assert_eq!(refusal(&filtered(r#"<feTurbulence baseFrequency=".01" numOctaves="5"/>"#)), "");
    refuses(&filtered(r#"<feMorphology operator="dilate" radius="400"/>"#), "pixel operations");
    assert_eq!(refusal(&filtered(r#"<feMorphology operator="dilate" radius="2"/>"#)), "");
    refuses(&filtered(&r#"<feGaussianBlur stdDeviation="20"/>"#.repeat(100)), "million pixel");
    assert_eq!(refusal(&filtered(r#"<feGaussianBlur stdDeviation="20"/>"#)), "");
    let matrix = "1 ".repeat(60 * 60);
    refuses(&filtered(&format!(r#"<feConvolveMatrix order="60" kernelMatrix="{matrix}"/>"#)), "pixel operations");
    refuses(&filtered(&r#"<feFlood/>"#.repeat(60)), "million pixels at once");
}

#[test]
fn sheets_upon_sheets_are_refused() {
    let sheet = r#"<rect width="500" height="1000" fill="red" fill-opacity=".01"/>"#;
    refuses(&sheet.repeat(20_000), "million pixel operations");
    assert_eq!(refusal(&sheet.repeat(200)), "");
    let layers = |count: usize| format!("{}{sheet}{}", r#"<g opacity=".9">"#.repeat(count), "</g>".repeat(count));
    refuses(&layers(50), "million pixels at once");
    assert_eq!(refusal(&layers(10)), "");
}

/// Of a line that goes there and back 24,000 times a quarter of the time was estimated that it took, and of one that goes
/// 600,000 times, a minute, it was let through.
#[test]
fn edges_upon_edges_are_refused() {
    let path = |turns: usize, look: &str| format!(r#"<path id="p" d="M0 0{}" {look}/>"#, "L490 900L0 0".repeat(turns));
    let (filled, stroked) = (r#"fill="red""#, r#"fill="none" stroke="red""#);
    let told = "million pixel operations to be printed, and 10000 million is the most; the most takes `p` in line 5, ";
    for (look, few, many) in [(filled, 5_000, 40_000), (stroked, 5_000, 20_000), (stroked, 5_000, 300_000)] {
        assert_eq!(refusal(&path(few, look)), "");
        refuses(&path(many, look), told);
    }
    let dashed = |dash: &str| path(500, &format!(r#"{stroked} stroke-dasharray="{dash}""#));
    assert_eq!(refusal(&dashed("3 3")), "");
    refuses(&dashed("0.01 0.01"), told);
}

#[test]
fn letters_upon_letters_are_refused() {
    let text = |letters: usize| format!(r#"<text x="9" y="99" font-size="2">{}</text>"#, "ab ".repeat(letters / 3));
    refuses(&text(500_000), " letters, and 50000 is the most, once it is written out");
    assert_eq!(refusal(&text(3_000)), "");
}

/// Ten elements in each of ten that refer to each other are ten thousand million.
#[test]
fn references_that_multiply_are_refused() {
    let nested = |kind: &str, property: &str, attributes: &str| {
        let each = |level: usize| {
            let rect = format!(r#"<rect width="9" height="9" {property}="url(#n{})"/>"#, level + 1);
            format!(r#"<{kind} id="n{level}" {attributes}>{}</{kind}>"#, rect.repeat(10))
        };
        let all: Vec<String> = (0..10).map(each).collect();
        format!(r#"{}<{kind} id="n10"/><rect width="9" height="9" {property}="url(#n0)"/>"#, all.join("\n"))
    };
    for (kind, property, attributes) in [
        ("pattern", "fill", r#"width="1" height="1""#),
        ("mask", "mask", ""),
        ("clipPath", "clip-path", ""),
        ("marker", "marker-start", ""),
    ] {
        let drawn = nested(kind, property, attributes).replace("<marker", "<marker overflow=\"visible\"");
        let drawn = if kind == "marker" {
            drawn.replace("<rect width=\"9\" height=\"9\"", "<path d=\"M0 0V1\"")
        } else {
            drawn
        };
        refuses(&drawn, " elements, and 200000 is the most, once it is written out; `n");
    }
    let used: Vec<String> = (0..10)
        .map(|level| format!(r##"<g id="n{level}">{}</g>"##, format!(r##"<use href="#n{}"/>"##, level + 1).repeat(10)))
        .collect();
    refuses(
        &format!(r#"<defs>{}<g id="n10"><path d="M0 0H9V9Z"/></g></defs><use href="{}"/>"#, used.join(""), "#n0"),
        "written out; `n",
    );
    let inherited = format!(
        r#"<pattern id="p" width="1" height="1">{}</pattern><g fill="url(#p)">{}</g>"#,
        r#"<rect width="1" height="1"/>"#.repeat(1000),
        r#"<rect width="9" height="9"/>"#.repeat(1000)
    );
    refuses(&inherited, "table.svg:5: the drawing has ");
    let by_sheet = inherited.replace("fill=\"url(#p)\"", "id=\"all\"") + "<style>#all { fill: url(#p) }</style>";
    refuses(&by_sheet, "table.svg:5: the drawing has ");
}

#[test]
fn what_lies_too_deep_or_in_itself_is_refused() {
    let mask = |n: usize| format!(r##"<mask id="m{n}" mask="url(#m{})"><rect width="9" height="9"/></mask>"##, n + 1);
    let chain: String = (0..10_000).map(mask).collect();
    refuses(&format!(r##"{chain}<rect width="9" height="9" mask="url(#m0)"/>"##), "more than 128 elements lie inside");
    refuses(
        r##"<g id="a"><use href="#b"/></g><g id="b"><use href="#a"/></g>"##,
        "table.svg:5: #a and what it refers to refer to each other without end: #a -> #b -> #a",
    );
    refuses(
        r##"<pattern id="p" width="1" height="1"><rect width="9" height="9" fill="url(#p)"/></pattern>
        <rect width="9" height="9" fill="url(#p)"/>"##,
        "#p refers to itself without end: #p -> #p",
    );
}

#[test]
fn sheets_of_styles_that_take_too_long_are_refused() {
    let rules = |count: usize, selector: &str| {
        format!("<style>{}</style>", format!("{selector} {{ fill: red }}").repeat(count))
    };
    let shape = |count: usize| r#"<path class="x" d="M0 0H9V9Z"/>"#.repeat(count);
    let shapes = shape(5_000);
    refuses(&format!("{}{shapes}", rules(20_000, ".a")), "the sheets have more than 256 kB");
    refuses(&format!("{}{shapes}{}", rules(2_000, ".a"), shape(25_000)), "comparisons, and at most");
    assert_eq!(refusal(&format!("{}{shapes}", rules(100, ".a"))), "");
    let deep = format!("{}{}", r#"<g class="a">"#.repeat(50), "</g>".repeat(50));
    // Upstream's own reader tries every way up, so it took hours.
    assert_eq!(refusal(&format!("{}{deep}", rules(1, &".a ".repeat(12)))), "");
}

/// Numbers at the ends of what numbers can be, in every place that the rasteriser sees: what is not refused is printed.
#[test]
fn nothing_but_a_sentence_comes_of_any_number() {
    let numbers = [
        "0",
        "-0.0",
        "1e-38",
        "1e-7",
        "0.3",
        "7",
        "-400",
        "1e4",
        "-3e5",
        "16777217",
        "1e9",
        "-2147483649",
        "3e38",
        "1e300",
    ];
    let forms = [
        r#"<path d="M10 10L@ 500 A@ 30 20 1 1 90 @ Q@ 9 8 7 C1 2 3 @ 5 6Z" fill="red" stroke="blue"/>"#,
        r#"<circle cx="@" cy="40" r="@" fill="url(#g)"/><linearGradient id="g" x1="@" x2="9" gradientUnits="userSpaceOnUse">
           <stop offset="0" stop-color="red"/><stop offset="1"/></linearGradient>"#,
        r#"<radialGradient id="g" cx="@" fx="@" r="@"><stop/><stop offset="1" stop-color="red"/></radialGradient>
           <rect width="100" height="100" fill="url(#g)"/>"#,
        r#"<rect width="90" height="90" transform="matrix(@ 0 7 1 3 @)" stroke="red" stroke-width="3"/>"#,
        r#"<path d="M0 0 500 1000" stroke="red" stroke-width="@" stroke-dasharray="@ 3" stroke-dashoffset="@"
           stroke-linejoin="round" stroke-miterlimit="@"/>"#,
        r#"<g opacity=".5"><rect x="@" y="3" width="@" height="40"/></g>"#,
        r#"<filter id="f" x="@" width="@"><feGaussianBlur stdDeviation="@"/><feOffset dx="@"/></filter>
           <rect width="90" height="90" filter="url(#f)"/>"#,
        r#"<filter id="f"><feComposite operator="arithmetic" k1="@" in2="SourceAlpha"/><feTile/><feMorphology radius="@"/>
           <feTurbulence baseFrequency="@" seed="@"/><feDisplacementMap scale="@" in2="SourceGraphic"/></filter>
           <rect width="90" height="90" filter="url(#f)"/>"#,
        r#"<filter id="f"><feSpecularLighting surfaceScale="@"><fePointLight x="@" z="@"/></feSpecularLighting>
           <feConvolveMatrix order="3" kernelMatrix="1 @ 1 1 1 1 1 1 1" divisor="@"/><feDropShadow dx="@" stdDeviation="@"/></filter>
           <rect width="90" height="90" filter="url(#f)"/>"#,
        r#"<rect width="90" height="90" filter="blur(@px)"/><g style="filter:drop-shadow(@px 3px 1px red)"><path d="M0 0H9V9Z"/></g>"#,
        r#"<rect width="90" height="90" style="filter:brightness(@) hue-rotate(@deg) opacity(@) contrast(@) sepia(@)"/>"#,
        r#"<pattern id="p" x="@" width="@" height="3" patternUnits="userSpaceOnUse" patternTransform="scale(@ 2)">
           <rect width="2" height="2"/></pattern><rect width="90" height="90" fill="url(#p)"/>"#,
        r#"<mask id="m" x="@" width="@" height="1"><rect width="@" height="20" fill="white"/></mask>
           <rect width="90" height="90" mask="url(#m)"/>"#,
        r#"<text x="@" y="90" font-size="@" letter-spacing="@" rotate="@">Lux</text>"#,
        r#"<marker id="m" markerWidth="@" markerHeight="4" refX="@" viewBox="0 0 @ 9"><path d="M0 0H9V9Z"/></marker>
           <path d="M0 0 90 90 90 0" marker-mid="url(#m)" stroke="red" stroke-width="@"/>"#,
    ];
    for form in forms {
        for number in numbers {
            let table = table(&form.replace('@', number));
            // Either way in a sentence: a panic that is not caught would end the test.
            let (checked, printed) = (art::check(&table), art::floor(&table, &VIEW));
            assert!(checked.is_err() || printed.is_ok(), "{number} in {form}: {:?}", printed.err());
        }
    }
}

/// Of 300 blurred shapes without ids the group was named that they are in.
#[test]
fn what_takes_too_long_is_told_by_its_line_where_it_has_no_id() {
    let blurred = r#"<rect width="480" height="900" filter="url(#bl)"/>"#.repeat(300);
    let filter = r#"<filter id="bl"><feGaussianBlur stdDeviation="80"/></filter>"#;
    refuses(&format!("<g id=\"layer1\">\n{filter}\n{blurred}</g>"), "the most takes a rect in line 7, ");
}
