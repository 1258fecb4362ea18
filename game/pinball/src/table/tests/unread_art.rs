//! Art that a reader of SVG draws otherwise than it is written: what cannot be read of it is told.

use super::{one, read, warned};

/// `rotate(45deg)` on art was passed over, and on a clone it was told of a group that nobody had drawn.
#[test]
fn a_transform_that_cannot_be_read_is_a_mistake_on_art_too() {
    let usual = "cannot be read; write translate(x y), rotate(degrees), scale(factor) or matrix(a b c d e f)";
    for wrong in ["rotate(45deg)", "translate(100;60)", "tranlate(100 60)"] {
        for shape in ["rect width='9' height='9'", "path d='M0 0h9'", "text"] {
            let told = one(read(&format!("<g>\n<{shape} transform='{wrong}'/></g>"), "").unwrap_err());
            let name = shape.split(' ').next().unwrap();
            assert_eq!(told, format!("table.svg:6: of this {name}: the transform `{wrong}` {usual}"));
        }
    }
    let post =
        "<g id='two'><circle class='post' cx='99' cy='99' r='4'/></g>\n<use href='#two' transform='tranlate(9,9)'/>";
    let told = one(read(post, "").unwrap_err());
    assert_eq!(told, format!("table.svg:6: of this use: the transform `tranlate(9,9)` {usual}"));
    assert_eq!(warned("<rect width='9' height='9' transform='rotate(45) skewX(3)'/>"), [""; 0]);
}

/// The posts of a group with `data-groups` were of no group.
#[test]
fn a_groups_misspelt_data_is_told_as_a_shapes_is() {
    for wrong in ["data-groups", "data-gruop", "data-Group"] {
        let group = format!("<g>\n<g {wrong}='a'><circle class='post' cx='99' cy='99' r='4'/></g></g>");
        let told = one(read(&group, "").unwrap_err());
        assert_eq!(told, format!("table.svg:6: a g has no `{wrong}`; did you mean `data-group`?"));
    }
    // It was told of each clone too.
    let cloned =
        "<g id='two' data-gruop='a'><circle class='post' cx='99' cy='99' r='4'/></g>\n<use id='b' href='#two' x='40'/>";
    assert_eq!(one(read(cloned, "").unwrap_err()), "table.svg:5: a g has no `data-gruop`; did you mean `data-group`?");
    assert_eq!(warned("<g data-group='a' data-grouping='b' data-name='c'><path d='M0 0h9'/></g>"), [""; 0]);
}

/// A floor whose gradient had one wrong word was black, or grey.
#[test]
fn a_broken_gradient_or_pattern_that_is_painted_with_is_told_with_its_line() {
    let painted = |server: &str| one(warned(&format!("<rect width='9' height='9' fill='url(#a)'/>\n{server}")));
    let stop = "<stop stop-color='red'/>";
    let gradient = |said: &str| painted(&format!("<linearGradient id='a' {said}>{stop}</linearGradient>"));
    assert!(
        painted("<linearGradient id='a'/>").starts_with("6: this linearGradient has no <stop>, so nothing is painted")
    );
    let units = gradient("gradientUnits='userspaceonuse'");
    assert_eq!(
        units,
        "6: the gradientUnits of this linearGradient is `userspaceonuse`, which is not read; write userSpaceOnUse or objectBoundingBox"
    );
    assert!(
        gradient("spreadMethod='mirror'").ends_with("is `mirror`, which is not read; write pad or reflect or repeat")
    );
    let turned = gradient("gradientTransform='rotat(3)'");
    assert!(
        turned.starts_with("6: of this linearGradient: the gradientTransform `rotat(3)` cannot be read; "),
        "{turned}"
    );
    let flat = "6: of this linearGradient: the gradientTransform `scale(0)` shrinks it to nothing";
    assert_eq!(gradient("gradientTransform='scale(0)'"), flat);
    let offset = painted("<linearGradient id='a'>\n<stop offset='abc'/></linearGradient>");
    assert_eq!(offset, "7: the offset of this stop is `abc`, which is not read; write a number from 0 to 1");
    let pattern = painted("<pattern id='a' width='0' height='5'><path d='M0 0h9'/></pattern>");
    assert_eq!(pattern, "6: this pattern's width is 0, so nothing is painted with it");
    let url = one(warned("<linearGradient id='a'/><rect width='9' height='9' style='fill:url(a);stroke:none'/>"));
    assert_eq!(url, "5: the fill of this rect is `url(a)`, which names a file, so nothing is painted; write url(#a)");
}

/// What is painted with something whole, and what nothing is painted with, says nothing wrong.
#[test]
fn whole_paint_and_unused_paint_are_left_alone() {
    let stops = "<stop offset='10%' stop-color='red'/><stop offset='.5'/>";
    let chain = format!(
        "<linearGradient id='s'>{stops}</linearGradient><radialGradient id='a' href='#s' gradientTransform='scale(2 3)'/>\
         <pattern id='p' width='3' height='50%'><path d='M0 0h9'/></pattern><pattern id='q' href='#p' patternUnits='userSpaceOnUse'/>\
         <rect width='9' height='9' fill='url(#a)' stroke='url(#q)'/>"
    );
    assert_eq!(warned(&chain), [""; 0]);
    assert_eq!(warned("<linearGradient id='a' spreadMethod='mirror'/><pattern id='p' width='0'/>"), [""; 0]);
}

/// A path of the art with an `o` for a 0 was drawn half.
#[test]
fn art_that_cannot_be_read_is_told() {
    for (drawn, told) in [
        ("<path d='M 10 10 L 3oo 40'/>", "of this path: its path cannot be read from `oo 40` on: "),
        ("<path d='10 10 L 20 30'/>", "of this path: its path cannot be read: it begins with M"),
        ("<polyline points='10 10 20'/>", "the `points` of this polyline must be pairs of numbers, and they are not"),
        ("<polygon points='10 10 2o 3'/>", "the `points` of this polygon must be pairs of numbers, and they are not"),
        ("<circle r='-4'/>", "the r of this circle is -4, so it is not drawn as it is meant"),
        ("<rect width='3q' height='4'/>", "the width of this rect is `3q`, which is no number, so it is not read"),
        (
            "<text text-anchor='centre'>a</text>",
            "the text-anchor of this text is `centre`, which is not read; write start",
        ),
        ("<text style='font-size:0'>a</text>", "the font-size of this text is 0, so nobody sees it"),
        ("<text style='font-size:0'><tspan>a</tspan></text>", "the font-size of this tspan is 0, so nobody sees it"),
    ] {
        let warned = one(warned(&format!("<g>\n{drawn}</g>")));
        assert!(warned.starts_with(&format!("6: {told}")), "{warned}");
    }
    for good in [
        "<path d=''/><path d='none'/><path d='M1-2.5.5-3z'/><polygon points=''/><polygon points='1,2-3-4\n5 6'/>",
        "<rect width='50%' height='4px' rx='auto'/><circle r='0'/><ellipse cx='-3' rx='4' ry='2'/>",
        "<text style='font-size:0;text-anchor:middle'> <tspan style='font-size:9px'>a</tspan></text>",
    ] {
        assert_eq!(warned(good), [""; 0], "{good}");
    }
}

/// What stands in `@media (min-width: 100px)` a browser applies, and here it was neither read nor told.
#[test]
fn a_sheets_rules_that_are_not_read_are_told() {
    let sheet = |sheet: &str| warned(&format!("<style>\n{sheet}</style><path class='a' d='M0 0h9'/>"));
    let window = ": a table has no window of a known size; write what is in it without it";
    for media in ["(min-width: 100px)", "screen and (color)"] {
        let told = one(sheet(&format!("@media {media} {{ .a {{ fill: red }} }} .a {{ stroke: red }}")));
        assert_eq!(told, format!("6: the rule `@media {media}` of this sheet is not read{window}"));
    }
    for media in ["screen", "all", "print", "not print", "print and (color)", "print, screen and (color), all"] {
        assert_eq!(sheet(&format!("@media {media} {{ .a {{ fill: red }} }} .a {{ stroke: red }}")), [""; 0], "{media}");
    }
    let inner = one(sheet("@media screen { @media (color) { .a { fill: red } } } .a { stroke: red }"));
    assert!(inner.starts_with("6: the rule `@media (color)` of this sheet is not read: "), "{inner}");
    let nested = one(sheet(".a { stroke: red; .b { fill: blue } }"));
    assert_eq!(nested, "6: the rule `.b` inside another is not read: write it behind that, with its whole selector");
    let less = one(warned("<g>\n<style type='text/less'>.a { fill: red }</style></g>"));
    assert_eq!(
        less,
        "6: this sheet is of the type `text/less`, so nobody reads it; write CSS, and type=\"text/css\" or none"
    );
    let wide = one(warned("<style media='(min-width: 9px)'>.a { fill: red }</style>"));
    assert!(wide.starts_with("5: this sheet is for the media `(min-width: 9px)` and is not read"), "{wide}");
}

/// A spring of 0.0005 was refused, and the coil measured against the 0.3 that nobody had written.
#[test]
fn nothing_follows_from_a_number_that_is_refused() {
    let arm = "<line class='diverter' id='div' x1='99' y1='99' x2='139' y2='99' stroke-width='6' data-turn-deg='40'/>";
    let coil = "[part.div]\ncoil_torque_n_m = 0.001\nhold_torque_n_m = 0.001\n";
    let told = one(read(arm, &format!("{coil}spring_torque_n_m = 0.0005")).unwrap_err());
    assert_eq!(told, "table.toml:4: `spring_torque_n_m` must be a number from 0.001 to 100");
    assert_eq!(read(arm, coil).unwrap_err().len(), 2);
}

/// `[material.foo]` without its restitution was told to mean `wood`.
#[test]
fn a_new_material_of_a_short_name_is_no_misspelling() {
    let told = one(read("", "[material.foo]\nfriction = 0.3").unwrap_err());
    assert_eq!(told, "table.toml:1: the material `foo` has no `restitution`");
}
