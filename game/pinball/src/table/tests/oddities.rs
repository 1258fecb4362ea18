//! What a browser passes over in silence, and a maker wants to know.

use super::{SVG, one, read, read_files, warned};

/// A brace that was forgotten swallowed every rule after it, and all that they style was black.
#[test]
fn a_bracket_that_is_never_closed_is_told_with_its_line() {
    let sheet = |sheet: &str| one(read(&format!("<style>\n{sheet}\n</style>"), "").unwrap_err());
    let brace = sheet(".foam { opacity: .4\n.word { fill: red }");
    assert_eq!(brace, "table.svg:6: this `{` is never closed, so the sheet swallows all that follows it; close it");
    assert!(sheet(".a { fill: red }\n.b { fill: rgb(1, 2, 3; }").starts_with("table.svg:7: this `(` is never"));
    assert!(sheet(".a { fill: red }\n\n/* .b { fill: blue }").starts_with("table.svg:8: this `/*` is never"));
    let after = "<style>/* { */ .a { fill: red } .b::after { content: '{' }</style><path class='a' d='M0 0h9'/>";
    assert_eq!(warned(after).len(), 1, "of ::after");
}

/// Walls of the sheet `stroke-widht: 28px` were one unit thick.
#[test]
fn a_property_that_is_nearly_one_is_told() {
    let meant = |name: &str| format!("the property `{name}` means nothing; did you mean `stroke-width`?");
    let sheet = "<style>\n.sea { fill: blue;\n stroke-widht: 28px }</style><path class='sea' d='M0 0h9'/>";
    assert_eq!(one(warned(sheet)), format!("7: {}", meant("stroke-widht")));
    let own = "<path style='fill:red;\nstroke-with:3' d='M0 0h9'/>\n<path style='stroke-with:4' d='M0 0h9'/>";
    assert_eq!(one(warned(own)), format!("5: {}", meant("stroke-with")), "once");
    assert_eq!(one(warned("<g>\n<path strokeWidth='3' d='M0 0h9'/></g>")), format!("6: {}", meant("strokeWidth")));
    let programs = "-inkscape-font-specification:'Cinzel';mix-blend-mode:normal;line-height:1.25;marks:none;--own:1";
    assert_eq!(warned(&format!("<path style=\"{programs};se-fill:red;wavy:2\" d='M0 0h9'/>")), [""; 0]);
}

/// A floor whose gradient had another name was black.
#[test]
fn what_is_named_and_is_not_there_is_told() {
    let fill = one(warned("<g>\n<rect width='9' height='9' fill='url(#sea)'/></g>"));
    assert_eq!(fill, "6: the fill of this rect is `#sea`, which is not in the drawing, so nothing is painted");
    let sheet =
        "<style>.sea { stroke: url('#deep') }</style>\n<path class='sea' d='M0 0h9'/>\n<path class='sea' d='M0 0v9'/>";
    assert!(one(warned(sheet)).starts_with("6: the stroke of this path is `#deep`, "), "once, where it is drawn first");
    for property in ["filter", "mask", "clip-path", "marker-start", "marker"] {
        let told = one(warned(&format!("<path style='{property}:url(#x)' d='M0 0h9'/>")));
        let expected =
            format!("5: the {property} of this path is `#x`, which is not in the drawing, so it is not drawn");
        assert!(told.starts_with(&expected), "{told}");
    }
    let gradient = one(warned("<linearGradient id='a' href='#b'/>"));
    assert_eq!(gradient, "5: this linearGradient builds on nothing: there is no `#b` in the drawing");
    assert_eq!(
        one(warned("<defs>\n<use href='#b'/></defs>")),
        "6: this <use> draws nothing: there is no `#b` in the drawing"
    );
    assert_eq!(one(warned("<use/>")), "5: this <use> draws nothing: it has no href");
    assert_eq!(warned("<rect width='9' height='9' fill='url(#sea) red'/>"), [""; 0], "a second choice");
    assert_eq!(
        warned("<radialGradient id='sea'><stop/></radialGradient><rect width='9' height='9' fill='url(#sea)'/>"),
        [""; 0]
    );
}

/// A lamp that nobody gave a colour is filled with black by SVG, and gives no light.
#[test]
fn a_lamp_without_light_is_told_by_its_name() {
    let lamp = |look: &str| warned(&format!("<circle id='gi' class='lamp' cx='99' cy='99' r='4' {look}/>"));
    assert!(
        one(lamp("")).starts_with("5: gi: its fill is black, so it gives no light unless the rules give it a colour")
    );
    assert!(one(lamp("fill='#000'")).starts_with("5: gi: its fill is black"));
    let nearly = one(lamp("fill='rgb(1.0,0.8,0.5)'"));
    let dark = "5: gi: its fill is read as #010101, which is nearly black, so it gives hardly any light; the numbers of `rgb()` go to 255";
    assert!(nearly.starts_with(dark), "{nearly}");
    assert!(
        one(lamp("fill='#0b0b0b'")).starts_with(
            "5: gi: its fill is read as #0b0b0b, which is nearly black, so it gives hardly any light; write"
        )
    );
    assert_eq!([lamp("fill='#300'"), lamp("fill='#00f'"), lamp("fill='#222'")].concat(), [""; 0]);
    let tube = "<line id='t' class='lamp' x1='9' y1='9' x2='99' y2='9' stroke='black'/>";
    assert!(one(warned(tube)).starts_with("5: t: its stroke is black"));
    let insert = "<rect id='i' class='insert' x='9' y='9' width='9' height='9'/>";
    assert!(one(warned(insert)).starts_with("5: i: its fill is black"));
}

#[test]
fn what_stands_and_cannot_be_seen_is_told_once() {
    let wall = |id: &str, look: &str| format!("<path id='{id}' class='wall' d='M9 9h90v90' {look}/>\n");
    let thin = ["a", "b"].map(|id| wall(id, "stroke-width='0'")).concat();
    let told = one(warned(&thin));
    assert!(
        told.starts_with("5: a: its line is 0 wide, so nobody sees it") && told.ends_with(" (so it is with 1 more)")
    );
    let filled = "<rect class='wall' x='9' y='9' width='9' height='9' fill='red' stroke-width='0'/>
        <circle class='post' cx='99' cy='99' r='4' fill='red' stroke-width='0'/>";
    assert_eq!(warned(filled), [""; 0]);
    let hidden = format!("<g visibility='hidden'>{}{}</g>", wall("a", ""), wall("b", "visibility='visible'"));
    assert_eq!(
        one(warned(&hidden)),
        "5: a: its visibility is hidden, and it is there all the same; what is not to be there has display=\"none\""
    );
    assert_eq!(warned(&wall("a", "visibility='hidden' display='none'")), [""; 0]);
    let dark = "i: its opacity is 0, and it shines all the same; what is not to shine has display=\"none\", or is switched off by the \
                rules (so it is with 1 more)";
    let lamps = "<circle id='i' class='insert' cx='9' cy='99' r='4' fill='red' opacity='0'/>
        <circle id='l' class='lamp' cx='99' cy='99' r='4' fill='red' style='fill-opacity:0'/>";
    assert_eq!(one(warned(lamps)), format!("5: {dark}"));
}

/// A layer with the walls, or with all parts, that was switched off in Inkscape was not told: the drawing had no drain.
#[test]
fn a_group_with_things_that_is_switched_off_is_told() {
    let walls = "<path id='a' class='wall' d='M9 9h90'/><path id='b' class='wall' d='M9 99h90'/>";
    let layer = "xmlns:i='http://www.inkscape.org/namespaces/inkscape' i:groupmode='layer' i:label='Walls'";
    let so = "is hidden (`display: none`), so the 2 things in it are not on the table; show it, or delete it";
    for off in ["style='display:none'", "display='none' visibility='hidden'"] {
        assert_eq!(one(warned(&format!("<g {off} {layer}>{walls}</g>"))), format!("5: this layer `Walls` {so}"));
    }
    assert_eq!(
        one(warned(&format!("<g display='none' id='x'><g display='none'>{walls}</g></g>"))),
        format!("5: this g `x` {so}")
    );
    for meant in [
        "<g display='none'><path d='M9 9h90'/></g>",
        "<g><path class='wall' d='M9 9h90' display='none'/></g>",
        "<g display='none'><circle id='pin' class='post' cx='9' cy='9' r='4' fill='red'/></g><use id='p' href='#pin' x='90' y='90'/>",
        "<defs><g display='none'><path class='wall' d='M9 9h90'/></g></defs>",
    ] {
        assert_eq!(warned(meant), [""; 0], "{meant}");
    }
}

/// `#44667` and `fill:bluu` were painted black, and check said ok.
#[test]
fn colours_that_are_none_are_told() {
    let told = |look: &str| warned(&format!("<rect width='9' height='9' {look}/>"));
    let none = |property: &str, value: &str| {
        format!(
            "5: the {property} of this rect is `{value}`, which is no colour, so a browser passes over it; write it as \"#rrggbb\""
        )
    };
    assert_eq!(one(told("fill='#44667'")), none("fill", "#44667"));
    assert_eq!(one(told("style='fill:bluu'")), none("fill", "bluu"));
    assert_eq!(one(told("fill='red' style='stroke: #12345'")), none("stroke", "#12345"));
    let bumper = "<circle class='bumper' id='pop' cx='99' cy='99' r='25' fill='tomato' style='fill: #12345'/>";
    assert!(one(warned(bumper)).starts_with("5: the fill of this circle is `#12345`, which is no colour"));
    assert!(one(warned("<linearGradient id='g'><stop stop-color='rde'/></linearGradient><rect width='9' height='9' fill='url(#g)'/>")).contains("the stop-color of this stop is `rde`"));
    for good in [
        "fill='none'",
        "fill='inherit'",
        "fill='var(--x)'",
        "style='fill:var(--x, red)'",
        "fill=''",
        "stroke='currentColor'",
        "fill='hsl(0 100% 50%)'",
        "fill='context-stroke'",
    ] {
        assert_eq!(told(good), [""; 0], "{good}");
    }
    assert_eq!(warned("<rect width='9' height='9'><animate attributeName='x' fill='freeze'/></rect>"), [""; 0]);
}

#[test]
fn text_that_nobody_draws_and_ids_of_two_are_told() {
    assert!(
        one(warned("<flowRoot><flowPara>Lux</flowPara></flowRoot>")).starts_with("5: `flowRoot` is text that only")
    );
    let twice = "<path id='a' d='M0 0h9'/>\n<path id='a' d='M0 0h9'/>\n<g id='a'/><g id='left'/>";
    assert_eq!(
        one(warned(twice)),
        "6: the id `a` is already taken in line 5, and 2 more are given twice; give each element its own"
    );
}

/// Of a drawing without a viewBox every thing was told to lie outside the playfield.
#[test]
fn what_comes_of_a_mistake_is_not_told() {
    let svg = SVG.replace("viewBox=\"0 0 500 1000\"", "").replace("{}", "");
    let told = one(read_files(&svg, "", "").unwrap_err());
    assert!(told.starts_with("table.svg:1: the drawing has no viewBox; write viewBox="), "{told}");
    let svg = SVG.replace("class=\"plunger\"", "class=\"Plunger\"").replace("{}", "");
    let told = one(read_files(&svg, "", "").unwrap_err());
    assert_eq!(told, "table.svg:4: the class `Plunger` means nothing; did you mean `plunger`?");
}

#[test]
fn a_doctype_is_told_with_its_line() {
    let svg = format!("<?xml version='1.0'?>\n<!-- <!DOCTYPE a> -->\n<!DOCTYPE svg>\n{}", SVG.replace("{}", ""));
    let told = one(read_files(&svg, "", "").unwrap_err());
    assert_eq!(told, "table.svg:3: it has a DOCTYPE; take it out, entities are not read");
    let told = one(read("<g>\n<text>&wall;</text></g>", "").unwrap_err());
    assert!(told.starts_with("table.svg:6: this is not well-formed XML: ") && told.contains("wall"), "{told}");
}

/// It was told of each thing in the clone that it had no id, in a line where there was none of them.
#[test]
fn a_clone_without_an_id_is_told_as_such() {
    let group = "<g id='bank'><line class='target' id='t1' x1='9' y1='9' x2='9' y2='40' stroke-width='4'/>
        <line class='wall' x1='29' y1='9' x2='29' y2='40'/></g>\n";
    let told = one(read(&format!("{group}<use href='#bank' x='50'/>"), "").unwrap_err());
    assert_eq!(
        told,
        "table.svg:7: this clone of `bank` has no id, so no rule can name what it shows; give it one; with id=\"two\" one is \
         `two-t1`"
    );
    let told = one(read(&format!("{group}<use href='#t1' x='50'/>"), "").unwrap_err());
    assert_eq!(told, "table.svg:7: this clone of `t1` has no id, so no rule can name what it shows; give it one");
    assert!(read(&format!("{group}<use id='two' href='#bank' x='50'/>"), "").is_ok());
}

#[test]
fn lengths_are_told_in_the_drawing_s_own_scale() {
    let svg = SVG.replace("viewBox", "width=\"250mm\" viewBox");
    let svg = svg.replace("{}", "<line id='w' class='wall' x1='9' y1='9' x2='5cm' y2='9'/>");
    let told = read_files(&svg, "", "").unwrap_err().join("\n");
    assert!(told.contains(": w: its x2 `5cm` is not a plain number; a unit of this drawing is 0.5 mm"), "{told}");
}
