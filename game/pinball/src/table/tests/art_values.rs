//! Values and places of art that a browser reads otherwise than a table's picture, or that nobody reads.

use super::{one, read, warned};

/// `opacity="half"` was opaque, `stroke-linecap:rond` cut off, and check said ok: of attributes, of styles and of sheets.
#[test]
fn values_that_nobody_reads_are_told_with_their_line() {
    let circle = |said: &str| one(warned(&format!("<g>\n<circle r='9' {said}/></g>")));
    let opacity = "6: the opacity of this circle is `half`, which is not read; write a number from 0 to 1";
    assert_eq!([circle("opacity='half'"), circle("style='opacity:half'")], [opacity, opacity]);
    let cap = circle("style='stroke:#fff;stroke-linecap:rond'");
    assert_eq!(cap, "6: the stroke-linecap of this circle is `rond`, which is not read; did you mean `round`?");
    let sheet = "<style>\n.a { stroke-dasharray: a b }\n</style><circle class='a' r='9'/>\n<circle class='a' r='8'/>";
    let dashes = "6: this stroke-dasharray `a b` means nothing; write none, or numbers, as in \"4 2\"";
    assert_eq!(one(warned(sheet)), dashes);
    let twice = "<circle r='9' opacity='half'/>\n<circle r='8' opacity='half'/>";
    assert!(one(warned(twice)).starts_with("5: "), "once");
    assert_eq!(warned("<circle r='9' style='opacity:var(--o);stroke-width:1e-1px;fill-rule:inherit'/>"), [""; 0]);
}

/// `x="150mm"` put a rectangle off the page.
#[test]
fn lengths_of_art_in_millimetres_are_told_where_they_are_others() {
    let rect = one(warned("<g transform='scale(2)'>\n<rect x='15mm' y='9' width='60mm' height='9'/></g>"));
    assert_eq!(
        rect,
        "6: the x of this rect is `15mm`: SVG makes 56.7 units of that, which are 113.4 mm here; write a number without a unit"
    );
    let as_written = "<g transform='scale(0.2645833)'><rect x='15mm' y='9' width='60mm' height='9'/></g>";
    assert_eq!(warned(as_written), [""; 0], "a unit is a screen's pixel there");
    assert_eq!(warned("<rect x='15px' y='1e1' width='20%' height='9'/>"), [""; 0]);
}

/// A browser moved and turned art by its style, and the table's picture left it where it was.
#[test]
fn places_that_only_a_browser_obeys_are_told_with_what_to_write() {
    let rect = |style: &str| warned(&format!("<g>\n<rect x='9' y='9' width='60' height='9' style='{style}'/></g>"));
    let said = |style: &str, declared: &str, instead: &str| {
        let what = format!(
            "6: the style of this rect says `{declared}`: a browser obeys that, and a table's picture does not; {instead}"
        );
        assert_eq!(one(rect(style)), what);
    };
    said("transform:translate(40px)", "transform: translate(40px)", "write the attribute transform=\"translate(40)\"");
    said("width:10px", "width: 10px", "write the attribute width=\"10\"");
    let turned =
        "write what it does into the attribute `transform`, as translate(x y), rotate(degrees x y) and scale(factor)";
    said("rotate:45deg", "rotate: 45deg", turned);
    said("transform-box:fill-box;transform-origin:center;transform:rotate(45deg)", "transform: rotate(45deg)", turned);
    assert!(
        one(rect("clip-path:circle(10px)"))
            .ends_with("is `circle(10px)`, which is not read; write none, or url(#ID) with the id of a <clipPath>")
    );
    let idle = "width:60px;x:9;cx:4px;rotate:none;transform:scale(2);transform-origin:0px 0px;d:none;r:3px";
    assert_eq!(rect(idle), [""; 0], "what says the same, or says it of other shapes");
    let sheet = "<style>\n.a { cx: 40px }\n.b { cx: 4px }</style>\n<circle class='a' r='9'/><g class='b'/><circle class='a' r='4'/>";
    let told = "6: this sheet says `cx: 40px` of the circle of line 8: a browser obeys that, and a table's picture does not; \
                write the attribute cx=\"40\"";
    assert_eq!(one(warned(sheet)), told);
    let post = "<g style='transform:translate(4px)'><circle class='post' cx='99' cy='99' r='4'/></g>";
    assert_eq!(read(post, "").unwrap_err().len(), 1, "of a thing it is a mistake, told once");
}

/// A gradient whose `href` was misspelt was told to have no colours too.
#[test]
fn a_gradient_that_builds_on_nothing_is_told_once() {
    let gradient = "<linearGradient id='a' href='#b'/><rect width='9' height='9' fill='url(#a)'/>";
    assert!(one(warned(gradient)).contains("builds on nothing"));
}
