//! Slips of the pen and of the keyboard: each is told once, in words for whoever draws.

use super::{SVG, one, read, read_files, table, warned};
use crate::table::{FILES, Table, TableSources};

#[track_caller]
fn drawn(drawn: &str) -> String {
    one(read(drawn, "").unwrap_err()).replacen("table.svg:", "", 1)
}

#[track_caller]
fn numbers(numbers: &str) -> String {
    one(read("", numbers).unwrap_err()).replacen("table.toml:", "", 1)
}

/// The place that was meant was 0 in silence, and in a clone the fault was told of the clone.
#[test]
fn a_misspelt_place_is_told_once_where_it_is_written() {
    assert_eq!(
        drawn("<g>\n<circle class='post' cx='40' yc='40' r='4'/></g>"),
        "6: a circle has no `yc`; did you mean `cy`?"
    );
    assert_eq!(drawn("<rect widht='40' height='40'/>"), "5: a rect has no `widht`; did you mean `width`?");
    let clones =
        "<defs>\n<circle id='p' class='post' cx='40' raduis='4'/></defs><use href='#p'/><use href='#p' x='9'/>";
    assert_eq!(drawn(clones), "6: a circle has no `raduis`; did you mean `r`?");
    assert_eq!(drawn("<cirlce class='post' cx='40' cy='40' r='4'/>"), "5: SVG has no `cirlce`; did you mean `circle`?");
    let line = "<line class='wall' id='w' x1='40' y1='40'/>";
    assert_eq!(drawn(line), "5: w: it has neither `x2` nor `y2`, so nobody knows where it ends");
    assert_eq!(warned("<circle cx='4' cy='5'/>"), ["5: this circle has no `r`, so it draws nothing"]);
    assert_eq!(warned("<rect width='4'/>"), ["5: this rect has no `height`, so it draws nothing"]);
    assert_eq!(warned("<line x1='4' y1='4'/>"), ["5: this line has no `x2` and no `y2`, so it ends at 0 0"]);
    let corner = warned("<circle class='post' id='p' r='5' fill='red'/>");
    assert_eq!(corner, ["5: p: its middle is the corner of the drawing, 0 0; say with cx and cy where it is"]);
    assert_eq!(warned("<line x2='4'/><circle r='4'/>"), [""; 0]);
}

/// A post whose `cy` was forgotten lay at the upper edge of the drawing, and nobody said so.
#[test]
fn a_place_that_is_said_by_half_is_told() {
    let half = |name: &str, said: &str, missing: &str, so: &str, edge: &str| {
        format!(
            "5: this {name} has `{said}` and no `{missing}`, so {so} at the drawing's {edge} edge; write {missing}=\"0\" if that is meant"
        )
    };
    let post = "<circle class='post' cx='40' r='4' fill='red'/>";
    assert_eq!(warned(post), [half("circle", "cx", "cy", "its middle is", "upper")]);
    assert_eq!(warned(&post.replace("cx", "cy")), [half("circle", "cy", "cx", "its middle is", "left")]);
    let rect = warned("<rect class='wall' y='9' width='9' height='9'/>");
    assert_eq!(rect, [half("rect", "y", "x", "its corner is", "left")]);
    let begins = warned("<line class='wall' x1='9' x2='40' y2='9'/>");
    assert_eq!(begins, [half("line", "x1", "y1", "it begins", "upper")]);
    let ends = warned("<line class='wall' x1='9' y1='9' x2='40'/>");
    assert_eq!(ends, [half("line", "x2", "y2", "it ends", "upper")]);
    // Art may be anywhere; in a frame of its own 0 is a place like others; and who writes it means it.
    for good in [
        "<circle cx='40' r='4'/>".to_string(),
        post.replace("cx=", "cy='0' cx="),
        post.replace("cx=", "transform='translate(40 40)' cx="),
        format!("<g transform='translate(40 40)'>{post}</g>"),
        format!("<svg x='40' y='40'>{post}</svg>"),
        format!("<defs><g id='a'>{post}</g></defs><use href='#a' y='40'/>"),
    ] {
        assert_eq!(warned(&good), [""; 0], "{good}");
    }
}

/// A flipper of `data-sied` was also told to need `data-side`.
#[test]
fn a_misspelt_data_word_is_one_mistake() {
    let flipper =
        |data: &str| drawn(&format!("<line class='flipper' id='f' x1='99' y1='99' x2='160' y2='99' {data}/>"));
    let told = flipper("data-sied='left' data-up-deg='50'");
    assert_eq!(told, "5: f: a flipper has no `data-sied`; did you mean `data-side`?");
    assert!(flipper("data-side='left' data-updeg='50'").ends_with("did you mean `data-up-deg`?"));
    assert!(
        flipper("data-side='left' data-up='50'").ends_with("a flipper has no `data-up`; did you mean `data-up-deg`?")
    );
    let lamp = "<circle class='lamp' id='l' cx='99' cy='99' r='4' fill='red' data-isnide='p'/>";
    let told = read(&format!("<circle class='bumper' id='p' cx='99' cy='99' r='20'/>{lamp}"), "").unwrap_err();
    assert_eq!(told, ["table.svg:5: l: a lamp has no `data-isnide`; did you mean `data-inside`?"]);
}

/// `finish="glass"` on a guide was passed over, and it had no glass.
#[test]
fn a_data_word_without_its_data_is_told() {
    let guide = "<line class='guide' id='g' finish='glass' x1='99' y1='99' x2='160' y2='99' stroke-width='5'/>";
    let told = read(guide, "").unwrap_err();
    assert_eq!(told[0], "table.svg:5: g: a guide has no `finish`; did you mean `data-finish`?");
    // One that it needs was told to be missing, and is one mistake.
    let gate = drawn("<line class='gate' id='g' way='left' x1='99' y1='99' x2='99' y2='140'/>");
    assert_eq!(gate, "5: g: a gate has no `way`; did you mean `data-way`?");
}

/// A maker's own `data-note` was a mistake.
#[test]
fn a_data_word_of_the_makers_own_is_warned_of() {
    let post = "<circle class='post' cx='99' cy='99' r='4' data-note='mine'/>";
    let [told] = &warned(post)[..] else { panic!("{:?}", warned(post)) };
    assert!(told.ends_with("5: post#3: a post has no `data-note`; it may have data-finish"), "{told}");
}

/// A misspelt word of art beside a thing's word was taken for a drawing program's own: the plastic had no grain.
#[test]
fn a_misspelt_word_of_art_on_a_thing_is_told() {
    let plastic = |word: &str| warned(&format!("<path class='plastic {word}' fill='red' d='M40 40h40v9z'/>"));
    let [told] = &plastic("woods")[..] else { panic!("{:?}", plastic("woods")) };
    assert!(told.ends_with("5: the class `woods` means nothing; did you mean `wood`?"), "{told}");
    assert_eq!(plastic("wood"), [""; 0]);
    assert_eq!(plastic("st0"), [""; 0]);
}

#[test]
fn what_is_not_xml_is_told_in_plain_words() {
    let xml = |from: &str, to: &str| {
        let told = one(read_files(&SVG.replace("{}", "").replacen(from, to, 1), "", "").unwrap_err());
        told.replacen("this is not well-formed XML: ", "", 1).replacen("table.svg:", "", 1)
    };
    assert_eq!(
        xml("y2=\"885\"/>", "y2=\"885/>"),
        "2: a quote is missing in `<line id=\"left\" class=\"f`: its value swallows what follows it"
    );
    assert_eq!(
        xml("stroke-width=\"24\"", "stroke-width=\"24"),
        "4: a quote is missing in `<line id=\"plunger\" class`: its value swallows what follows it"
    );
    assert!(xml("x1=\"150\"", "x1=\"150").starts_with("2: `850\" x2="), "{}", xml("x1=\"150\"", "x1=\"150"));
    assert!(xml("x1=\"150\"", "x1=150").starts_with("2: `150 y1="));
    assert_eq!(xml("<line", "<text>a & b</text><line"), "2: a plain & is written `&amp;`");
    // What is no character was told as a plain &.
    let forbidden = "2: `&#27;` is the character U+001B, which no XML may hold; take it out";
    assert_eq!(xml("<line", "<text>a &#27; b</text><line"), forbidden);
    assert_eq!(xml("<line", "<text fill=\"&#x0;\"/><line"), forbidden.replace("27", "x0").replace("1B", "00"));
    assert_eq!(xml("x1=\"150\"", "x1=\"150\" x1=\"1\""), "2: `x1` is given twice in one element; take one of them out");
    let open = "6: `</svg>` stands here, and the `<g>` of line 2 is still open; close it with `</g>` first";
    assert_eq!(xml("<line", "<g><line"), open);
    assert!(
        xml("<line", "<use xlink:href='#a'/><line")
            .starts_with("2: nobody says what `xlink:` is; write xmlns:xlink=\"http://")
    );
    assert!(xml("<svg", "\n<?xml version='1.0'?><svg").starts_with("2: `<?xml` can only be the very first"));
    assert_eq!(xml("<line", "\0<line"), "2: U+0000 is no letter of a text; take it out");
    assert!(xml("<svg", "svg").starts_with("1: it begins with `svg"));
    assert!(
        drawn("<path id='w' class='wall' d='10 10 L20 20'/>").ends_with("it begins with M and a place, as in `M10 20`")
    );
    let path = drawn("<path id='w' class='wall' d='M10 10 L20 x'/>");
    assert!(path.starts_with("5: w: its path cannot be read from `x` on: each command is one letter of M L"), "{path}");
    assert!(
        drawn("<path id='w' class='wall' d='M10 10 L20'/>")
            .ends_with("it ends in the middle of a command; numbers are missing")
    );
}

/// Half a drawing was told to be wrong where it began, for some of the places where it can be cut.
#[test]
fn a_drawing_is_cut_off_where_it_ends_wherever_that_is() {
    let whole = SVG.replace("{}", "<!-- a -->\n<g><text>a<![CDATA[b]]></text></g>\n<path d='M0 0\nh9'/>");
    for end in whole.find('>').unwrap()..whole.len() - 1 {
        let told = one(read_files(&whole[..end], "", "").unwrap_err());
        let line = whole[..end].trim_end().lines().count();
        assert!(told.starts_with(&format!("table.svg:{line}: the drawing ends here")), "{end} {told}");
    }
}

/// A compressed drawing was no UTF-8.
#[test]
fn a_file_that_is_no_text_in_utf_8_is_named_as_what_it_is() {
    let told = |bytes: Vec<u8>| {
        let files = [Ok(bytes), Ok(Vec::new()), Ok(Vec::new())];
        let sources = TableSources { name: String::new(), origin: String::new(), folder: String::new(), files };
        one(Table::parse(sources).unwrap_err().iter().map(ToString::to_string).collect())
    };
    assert!(told(vec![0x1f, 0x8b, 8, 0]).starts_with(&format!("{}: it is compressed, as an .svgz is", FILES[0])));
    for bytes in [[0xff, 0xfe, b'<', 0], [0xfe, 0xff, 0, b'<'], [b'<', 0, b's', 0], [0, b'<', 0, b's']] {
        assert_eq!(told(bytes.to_vec()), "table.svg: this is text in UTF-16; save the file as UTF-8");
    }
}

/// A turned viewBox gave seventeen mistakes.
#[test]
fn a_wrong_view_box_is_one_mistake() {
    let walls: String =
        (0..9).map(|i| format!("<line class='wall' x1='9' y1='{0}' x2='90' y2='{0}'/>\n", 700 + 9 * i)).collect();
    let told = |view_box: &str| {
        let svg = SVG.replace("{}", &walls).replace("viewBox=\"0 0 500 1000\"", view_box);
        one(read_files(&svg, "", "").unwrap_err())
    };
    let turned = told("viewBox=\"0 0 1000 500\"");
    assert!(
        turned.starts_with("table.svg:1: the playfield is 1000 x 500 mm, and what is drawn on it fits 500 x 1000"),
        "{turned}"
    );
    let small = told("viewBox=\"0 0 250 500\"");
    assert!(
        small.starts_with(
            "table.svg:2: left: it lies outside the playfield, near 150 850 (so do 11 more things; the viewBox"
        ),
        "{small}"
    );
    assert!(
        told("viewBox=\"0 0 -500 1000\"").starts_with("table.svg:1: the viewBox is `0 0 -500 1000`; write viewBox=")
    );
    assert_eq!(told("viewbox=\"0 0 500 1000\""), "table.svg:1: an svg has no `viewbox`; did you mean `viewBox`?");
}

/// `[material.rubber]` with one number was refused, though the rest stays as it was.
#[test]
fn a_material_that_is_there_keeps_what_is_not_said() {
    let table = read("", "[material.rubber]\nrestitution = 0.5").unwrap();
    let rubber = table.materials.iter().find(|(name, _)| name == "rubber").unwrap().1;
    assert_eq!((rubber.restitution, rubber.falloff_s_per_m, rubber.friction), (0.5, 0.13, 0.3));
    assert!(table.warnings.is_empty());
    assert_eq!(numbers("[material.ruber]\nrestitution = 0.5"), "1: nothing is made of `ruber`; did you mean `rubber`?");
    assert_eq!(
        numbers("[material.gum]\nfalloff_s_per_m = 1"),
        "1: the material `gum` has no `restitution` and no `friction`"
    );
    let gum = "[material.gum]\nrestitution = 0.5\nfriction = 1\n";
    let idle = read("", gum).unwrap().warnings;
    assert!(
        idle.len() == 1
            && idle[0].to_string().starts_with("warning: table.toml:1: nothing is made of `gum`; write material")
    );
    assert!(read("", &format!("{gum}[class.wall]\nmaterial = \"gum\"")).unwrap().warnings.is_empty());
}

/// A saucer of 3 mm, a capture speed of a millimetre a second: each was accepted, and the part was dead.
#[test]
fn numbers_with_which_a_part_is_dead_are_refused() {
    let saucer = |r: f64| {
        format!("<circle class='saucer' id='s' cx='99' cy='99' r='{r}' data-eject-deg='90' data-eject-m-s='1'/>")
    };
    assert!(
        drawn(&saucer(3.0))
            .starts_with("5: s: its r is 3.0 and must be 6.75 or more: a hole as small as that holds no ball")
    );
    assert!(
        drawn("<circle class='magnet' id='m' cx='99' cy='99' r='1'/>").starts_with("5: m: its r is 1.0 and must be")
    );
    for (class, number, least, most) in [
        ("saucer", "capture_m_s = 0.001", "0.1", "20"),
        ("bumper", "threshold_m_s = 9", "0", "3"),
        ("spinner", "damping_per_s = 900", "0", "50"),
        ("plunger", "full_speed_m_s = 0.1", "0.5", "15"),
        ("kickback", "speed_m_s = 0.1", "0.5", "15"),
        ("magnet", "pull_m_s2 = 0", "1", "500"),
    ] {
        let name = number.split(' ').next().unwrap();
        let told = numbers(&format!("[class.{class}]\n{number}"));
        assert_eq!(told, format!("2: `{name}` must be a number from {least} to {most}"));
    }
    let weak = numbers("[part.left]\n\ncoil_torque_n_m = 0.01");
    assert_eq!(
        weak,
        "3: left: its `coil_torque_n_m`, 0.01, must be more than its `spring_torque_n_m`, 0.06, or it never turns"
    );
    assert!(numbers("[class.flipper]\nspring_torque_n_m = 0.5").contains("left: its `hold_torque_n_m`, 0.4, must be"));
}

/// `.fliper { ... }` meant nothing in silence.
#[test]
fn a_selector_that_means_nothing_is_told() {
    let sheet =
        |rules: &str| warned(&format!("<style>.sky {{ fill: red }}\n{rules}</style><g class='sky' id='dome'/>"));
    let told = sheet(".fliper { fill: red }\n.skyy, .sky { fill: red }\n#domes { fill: red }\ncirlce { fill: red }");
    let meant = |line: usize, wrong: &str, meant: &str| {
        format!("{line}: `{wrong}` of this sheet means nothing in the drawing; did you mean `{meant}`?")
    };
    let expected = [
        meant(6, ".fliper", ".flipper"),
        meant(7, ".skyy", ".sky"),
        meant(8, "#domes", "#dome"),
        meant(9, "cirlce", "circle"),
    ];
    assert_eq!(told, expected);
    let others = sheet(".a { fill: red }\n.b, .sky { fill: red }\n.c { fill: red }");
    assert_eq!(others, ["6: `.a` of this sheet means nothing in the drawing (so it is with 2 more)"]);
    assert_eq!(sheet(".bumper, .wood, text, .sky:hover, g > .sky, * { fill: red }"), [""; 0]);
    // `g[id="row"] > .rollover` was passed over for its bracket.
    let nothing =
        |written: &str| format!("5: `{written}` of this sheet means nothing in the drawing").replacen('5', "6", 1);
    for wrong in ["g[id=row] > .rollover", ".far:hover", "g:not(.sky) .far", "[class~=far] line", ":is(.far .sky) g"] {
        assert_eq!(sheet(&format!("{wrong} {{ fill: red }}")), [nothing(wrong)]);
    }
    assert_eq!(sheet("g[id=dom] > .sky { fill: red }"), [meant(6, "g[id=dom] > .sky", "#dome")]);
    let good = "g[id='dome'], [class='sky'] .wall, [id='DOME' i], [id^='ro'], :not(.far) text, :is(.far, .farther) g, g:empty > g";
    assert_eq!(sheet(&format!("{good} {{ fill: red }}")), [""; 0]);
}

/// A sheet that hid a layer took its walls off the table, and a wall that nobody sees was there.
#[test]
fn what_a_sheet_hides_and_what_is_clear_is_told() {
    let wall = |id: &str, rest: &str| format!("<line class='wall' id='{id}' x1='9' y1='9' x2='90' y2='9' {rest}/>");
    let layer =
        format!("<style>.layer {{ display: none }}</style>\n<g class='layer'>{}{}</g>", wall("a", ""), wall("b", ""));
    assert_eq!(
        warned(&layer),
        ["6: a sheet says `display: none` of this g, so the 2 things in it are not on the table"]
    );
    assert_eq!(warned(&wall("a", "style='display:none'")), [""; 0], "its maker says so");
    let clear = "its opacity is 0, and it is there all the same; what is not to be there has display=\"none\"";
    assert_eq!(warned(&wall("a", "opacity='0'")), [format!("5: a: {clear}")]);
    assert_eq!(
        warned(&format!("<style>.x {{ opacity: 0% }}</style><g class='x'>{}</g>", wall("a", ""))),
        [format!("5: a: {clear}")]
    );
    assert_eq!(warned(&wall("a", "opacity='0.1'")), [""; 0]);
}

#[test]
fn what_is_not_toml_is_told_in_plain_words() {
    assert_eq!(numbers("slope_deg = 6,5"), "1: this is not TOML: `slope_deg = 6,5`; a number has a point, not a comma");
    assert_eq!(numbers("ambient = #fff"), "1: this is not TOML: `ambient = #fff`; text stands in \"quotes\"");
    assert_eq!(numbers("ambient = \"#fff"), "1: this is not TOML: `ambient = \"#fff`; a quote is missing");
    assert_eq!(numbers("slope_deg: 6"), "1: this is not TOML: `slope_deg: 6`; a line is NAME = VALUE, or [TABLE]");
    // The numbers of a table whose name could not be read were told to be unknown.
    let table = numbers("[material.rubber\nrestitution = 0.9\n[class.wall]\nmaterial = \"wood\"");
    assert_eq!(table, "1: this is not TOML: `[material.rubber`; a table is written in brackets, as [class.wall]");
    assert_eq!(
        numbers("[class.wall]\n[class.wall]"),
        "2: `[class.wall]` is there already, from line 1; take one of them out"
    );
}

/// What a crafted recording carries was refused in the words of the JSON library.
#[test]
fn a_carried_table_that_is_none_is_refused_in_plain_words() {
    let whole = crate::table::EmbeddedTable::of(&table(""));
    for wrong in [
        whole.game.replacen("\"layout\":{", "\"layout\":[{", 1),
        whole.game.replacen("\"parts\":", "\"bits\":", 1),
        "{}".to_string(),
    ] {
        let told = crate::table::EmbeddedTable { game: wrong, look: None }.table("small").unwrap_err().to_string();
        let expected = "the table small that it carries is none that this program knows, from byte ";
        assert!(
            told.starts_with(expected) && told.ends_with("changed by hand, or recorded with a newer Caustic"),
            "{told}"
        );
    }
}

/// A colon that was forgotten cost a declaration, and a point a whole rule, in silence.
#[test]
fn what_of_a_sheet_says_nothing_is_told() {
    let says_nothing =
        |begin: &str| format!("5: `{begin}` says nothing: write `property: value;`, with a `:` between the two");
    let wall = "<path class='wall' d='M40 40h40'/>";
    for (sheet, begin) in [
        (".wall { stroke-width 8; }", "stroke-width 8"),
        (".wall { stroke-width = 8 }", "stroke-width = 8"),
        (".wall { stroke: red; fill #fff; stroke-width: 3 }", "fill #fff"),
    ] {
        let told = warned(&format!("<style>{sheet}</style>{}", wall.replace("d=", "stroke-width='4' d=")));
        assert_eq!(told, [says_nothing(begin)], "{sheet}");
    }
    let style = "<path class='wall' stroke-width='4' style='fill=#60a0ff;stroke:red' d='M40 40h40'/>";
    assert_eq!(warned(&format!("{style}{style}")), [says_nothing("fill=#60a0ff")]);
    let point =
        warned(&format!("<style>wall {{ stroke-width: 8 }}</style>{}", wall.replace("d=", "stroke-width='4' d=")));
    assert_eq!(point, ["5: `wall` of this sheet means nothing in the drawing; did you mean `.wall`?"]);
}

/// One slip in a group's transform was told of each thing in it, and never of the group.
#[test]
fn a_transform_of_a_group_is_told_once() {
    let things = "<circle class='post' cx='40' cy='40' r='4'/><circle class='post' id='p' cx='90' cy='40' r='4'/>";
    let told = drawn(&format!("\n<g transform='scal(2)'>\n{things}<g>{things}</g></g>").replacen(" id='p'", "", 1));
    assert!(told.starts_with("6: of this g: the transform `scal(2)` cannot be read; write "), "{told}");
}

/// What was made larger than any number was told as shrunk to nothing.
#[test]
fn a_transform_that_is_too_large_and_one_that_is_too_small_are_told_apart() {
    for (scale, expected) in [("1e300", "make it larger than any number"), ("1e-9", "shrink it to nothing")] {
        let told = drawn(&format!("<circle class='post' cx='40' cy='40' r='4' transform='scale({scale})'/>"));
        assert!(told.contains(expected), "{told}");
    }
}
