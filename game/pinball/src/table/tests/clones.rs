//! Clones as Inkscape makes them: what a `<use>` draws is there.

use super::{SVG, read, read_files, table};
use crate::table::{LampKind, Table};
use geometry::{Core, DVec2, Shape};
use physics::Kind;

fn names(table: &Table) -> Vec<&str> {
    table.layout.parts.iter().map(|part| part.name.as_str()).filter(|name| !SMALL.contains(name)).collect()
}

/// What the small table has already.
const SMALL: [&str; 3] = ["left", "drain#1", "plunger"];

#[track_caller]
fn disc(table: &Table, name: &str) -> (f64, f64, f64) {
    let id = table.part(name).unwrap_or_else(|| panic!("no {name} in {:?}", names(table)));
    let shape = match &table.layout.parts[usize::from(id.0)].kind {
        Kind::Bumper(bumper) => Shape::disc(bumper.circle.center, bumper.circle.radius),
        Kind::Wall(wall) => wall.shapes[0],
        other => panic!("{other:?}"),
    };
    let Shape { core: Core::Point(center), radius } = shape.scaled(1000.0) else { panic!("{shape:?}") };
    let round = |mm: f64| (mm * 1e6).round() / 1e6;
    (round(center.x), round(center.y), round(radius))
}

#[test]
fn a_clone_of_a_bumper_is_a_bumper() {
    // Inkscape's "Edit > Clone" of a bumper was printed on the floor, and nothing was there to hit.
    let table = table(
        r##"<g transform="translate(10,5)"><circle class="bumper" id="bump1" style="fill:#eeeeec" cx="130" cy="230" r="26"/>
        <use x="0" y="0" href="#bump1" id="use32" transform="translate(23.8125,307.9375)"/></g>"##,
    );
    assert_eq!(names(&table), ["bump1", "use32"]);
    assert_eq!(disc(&table, "bump1"), (140.0, 235.0, 26.0));
    assert_eq!(disc(&table, "use32"), (163.8125, 542.9375, 26.0));
    assert!(!table.floor_svg.contains("<use"), "it is no art any more");
}

#[test]
fn a_clone_is_transformed_first_and_moved_then() {
    // SVG 2, 5.6.2: the translation by x and y comes after, so inside, the element's own transform.
    let drawn = |rest: &str| {
        let post = r#"<circle id="p" class="post" cx="10" cy="0" r="4" fill="gray" transform="translate(0 5)"/>"#;
        disc(&table(&format!(r##"{post}<use id="c" href="#p" {rest}/>"##)), "c")
    };
    assert_eq!(drawn(r#"x="100" y="200""#), (110.0, 205.0, 4.0));
    assert_eq!(drawn(r#"x="20" transform="translate(100 300) rotate(90) scale(2)""#), (90.0, 360.0, 8.0));
    assert_eq!(drawn(r#"transform="matrix(-1 0 0 1 300 100)""#), (290.0, 105.0, 4.0));
}

#[test]
fn clones_of_groups_of_symbols_and_of_clones_are_named_after_themselves() {
    let table = table(
        r##"<defs><symbol id="pair" viewBox="0 0 50 100"><circle class="post" id="low" cx="5" cy="5" r="1" fill="gray"/>
        </symbol></defs>
        <g id="bank"><circle id="a" class="bumper" cx="100" cy="100" r="20"/>
          <circle class="post" cx="140" cy="100" r="4" fill="gray"/>
          <use id="b" href="#a" x="80"/></g>
        <use id="two" href="#bank" y="200"/>
        <use id="three" href="#two" y="200"/>
        <use id="sym" href="#pair" x="10" y="20" width="100" height="400"/>"##,
    );
    let named: Vec<&str> = names(&table).into_iter().filter(|name| !name.contains('#')).collect();
    assert_eq!(named, ["a", "b", "two-a", "two-b", "three-a", "three-b", "sym-low"]);
    assert_eq!(names(&table).len(), 10, "and three posts");
    assert_eq!(disc(&table, "two-b"), (180.0, 300.0, 20.0));
    assert_eq!(disc(&table, "three-b"), (180.0, 500.0, 20.0));
    // 50 x 100 fits twice into 100 x 400 and lies in its middle.
    assert_eq!(disc(&table, "sym-low"), (20.0, 130.0, 2.0));
}

#[test]
fn a_clone_inherits_where_it_stands() {
    let table = table(
        r##"<g fill="none" stroke-width="9"><circle id="p" class="rubber" cx="100" cy="100" r="20" stroke="red"/></g>
        <g fill="gray" stroke-width="3"><use id="c" href="#p" x="100" style="stroke:blue"/></g>"##,
    );
    // The original is a ring as thick as its line; the clone is filled, and has the line that it has itself.
    assert_eq!(disc(&table, "c"), (200.0, 100.0, 21.5));
    let colors: Vec<[u8; 3]> = table.solids.iter().map(|solid| solid.finish.albedo).collect();
    assert_eq!(colors[..2], [[255, 0, 0]; 2]);
}

#[test]
fn clones_of_lamps_windows_and_plastics_are_lamps_windows_and_plastics() {
    let table = table(
        r##"<circle id="bulb" class="lamp" cx="100" cy="100" r="5" fill="#ff8000"/>
        <rect id="win" class="insert" x="200" y="200" width="40" height="20" fill="#ff0000"/>
        <g class="plastics"><circle class="plastic" id="roof" cx="100" cy="100" r="20" fill="lime"/></g>
        <use id="bulb2" href="#bulb" x="50"/><use id="win2" href="#win" x="50"/><use id="roof2" href="#roof" x="50"/>"##,
    );
    let lamps: Vec<&str> = table.lamps.iter().map(|lamp| lamp.name.as_str()).collect();
    assert_eq!(lamps, ["bulb", "win", "bulb2", "win2"]);
    let LampKind::Bulb { center_mm, .. } = table.lamps[2].kind else { panic!() };
    assert_eq!(center_mm, DVec2::new(150.0, 100.0));
    assert_eq!(table.solids.iter().filter(|solid| solid.finish.art).count(), 2);
    assert_eq!(table.floor_svg.matches("fill-opacity:.9").count(), 2, "both windows are dark: {}", table.floor_svg);
    assert_eq!(table.tops_svg.matches("<circle").count(), 2, "{}", table.tops_svg);
}

#[test]
fn what_belongs_together_in_a_group_belongs_together_in_its_clone() {
    let table = table(
        r##"<g id="pop" data-group="island"><circle id="skirt" class="bumper" cx="100" cy="100" r="20"/>
        <circle id="bulb" class="lamp" data-inside="skirt" cx="100" cy="100" r="5" fill="#fff"/>
        <line class="wall" x1="90" y1="140" x2="110" y2="140"/></g><use id="pop2" href="#pop" x="100"/>"##,
    );
    let group = |name: &str| {
        let id = table.part(name).unwrap();
        table.solids.iter().find(|solid| solid.part == Some(id)).unwrap().group
    };
    assert_ne!(group("skirt"), group("pop2-skirt"));
    let inside = |index: usize| match table.lamps[index].kind {
        LampKind::Bulb { inside, .. } => inside,
        LampKind::Insert { .. } => None,
    };
    assert_eq!((inside(0), inside(1)), (Some(group("skirt")), Some(group("pop2-skirt"))));
    let groups: std::collections::BTreeSet<u16> = table.solids.iter().map(|solid| solid.group).collect();
    assert_eq!(groups.len(), 3, "two islands and a flipper");
}

#[test]
fn a_template_in_defs_is_drawn_where_it_is_used() {
    let drawn = r##"<defs><circle id="p" class="post" cx="10" cy="10" r="4" fill="gray"/></defs>
        <use id="one" href="#p" x="100" y="100"/>"##;
    assert_eq!(names(&table(drawn)), ["one"]);
    let unused = read(&drawn.replace("<use", "<g").replace("href=\"#p\"", ""), "").unwrap_err();
    assert!(unused[0].contains("a post inside `defs` is not drawn"), "{unused:?}");
}

#[test]
fn art_that_uses_art_stays_as_it_is_written() {
    let art = r##"<defs><path id="star" d="M0 0h9v9z"/></defs><use href="#star" x="50" fill="red"/>"##;
    assert!(table(art).floor_svg.contains(art));
    // A thing that art is cut out by is needed there, though it is no art.
    let clipped = r##"<circle id="hole" class="bumper" cx="100" cy="100" r="20"/>
        <clipPath id="clip"><use href="#hole"/></clipPath><rect width="9" height="9" clip-path="url(#clip)"/>"##;
    let table = table(clipped);
    assert_eq!(names(&table), ["hole"]);
    assert!(table.floor_svg.contains(r#"<defs><circle id="hole""#), "{}", table.floor_svg);
}

#[test]
fn mistakes_in_clones_have_their_line() {
    let drawn = |drawn: &str| {
        let post = r#"<circle id="p" class="bumper" cx="10" cy="10" r="4"/>"#;
        read(&format!("{post}\n{drawn}"), "").unwrap_err().join("\n")
    };
    let says = |drawn: String, what: &str| assert!(drawn.contains(what), "`{drawn}` does not say `{what}`");
    says(drawn(r##"<use href="#p" x="50"/>"##), "table.svg:6: this clone of `p` has no id");
    says(
        drawn(r##"<use id="p" href="#p" x="50"/>"##),
        "table.svg:6: the id `p` is given twice, and is meant to draw itself; give each its own",
    );
    says(drawn(r##"<use id="c" href="#p" x="5%"/>"##), "table.svg:6: its x `5%` is not a plain number");
    says(drawn("<use id=\"c\"\nhref=\"#p\" x=\"5000\"/>"), "table.svg:6: c: it lies outside the playfield");
    says(drawn(r##"<use id="c" href="#p" transform="scale(1 2)"/>"##), "table.svg:6: c: its transforms stretch");
    says(drawn(r##"<use id="c" class="post" href="#p"/>"##), "table.svg:6: c: a thing cannot be a `use`");
    says(
        drawn(
            r##"<g id="a">
        <use id="b" href="#a"/></g>"##,
        ),
        "table.svg:7: #a refers to itself without end: #a -> #a",
    );
}

/// Inkscape notes where the middle of a star was when it was made.
#[test]
fn what_a_program_notes_for_itself_is_no_place() {
    let drawn = r#"<g xmlns:sodipodi="http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd"><circle sodipodi:cx="300" id="a" class="bumper" cx="100" cy="100" sodipodi:r="4" r="20"/></g>"#;
    assert_eq!(disc(&table(drawn), "a"), (100.0, 100.0, 20.0));
}

/// Illustrator writes a drawing for itself before the one for others.
#[test]
fn of_a_switch_the_first_choice_is_drawn_that_needs_nothing() {
    let drawn = r##"<switch><foreignObject requiredExtensions="http://ns.adobe.com/AdobeIllustrator/10.0/"/>
        <g><circle id="a" class="bumper" cx="100" cy="100" r="20"/></g>
        <g><circle id="b" class="bumper" cx="200" cy="100" r="20"/></g></switch>"##;
    assert_eq!(names(&table(drawn)), ["a"]);
}

#[test]
fn a_clone_of_nothing_is_warned_of() {
    let table = table(r##"<use href="#nobody"/><use/>"##);
    let warnings: Vec<String> = table.warnings.iter().map(ToString::to_string).collect();
    assert_eq!(
        warnings,
        [
            "warning: table.svg:5: this <use> draws nothing: it has no href",
            "warning: table.svg:5: this <use> draws nothing: there is no `#nobody` in the drawing"
        ]
    );
}

#[test]
fn names_of_elements_may_have_a_prefix() {
    let drawn = r##"<circle id="p" class="post" cx="50" cy="50" r="4" fill="gray"/><use id="c" href="#p" x="9"/>
        <rect id="win" class="insert" x="200" y="200" width="40" height="20" fill="#ff0000"/>"##;
    let svg = SVG.replace("{}", drawn).replace("</", "</s:").replace("xmlns=", "xmlns:s=");
    let mut prefixed = String::new();
    for (index, piece) in svg.split('<').enumerate() {
        let opens = index > 0 && !piece.starts_with('/');
        prefixed += &format!("{}{}{piece}", if index > 0 { "<" } else { "" }, if opens { "s:" } else { "" });
    }
    let table = read_files(&prefixed, "", "").unwrap();
    assert_eq!(names(&table), ["p", "c"]);
    assert!(roxmltree::Document::parse(&table.floor_svg).is_ok(), "{}", table.floor_svg);
}
