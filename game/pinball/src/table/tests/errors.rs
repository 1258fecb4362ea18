//! Each diagnostic is found, in its line, with what was expected.

use super::{SVG, read, read_files};

/// The one diagnostic of the small table with `drawn` in its line 5, without the file's name.
fn drawn(drawn: &str) -> String {
    one(read(drawn, ""), "table.svg:")
}

/// The one diagnostic of a small table with these numbers.
fn numbers(numbers: &str) -> String {
    let drawn = r#"<circle id="pop" class="bumper" cx="100" cy="100" r="25"/>"#;
    one(read(drawn, numbers), "table.toml:")
}

fn one(read: Result<crate::Table, Vec<String>>, file: &str) -> String {
    let diagnostics = read.expect_err("a mistake");
    let [diagnostic] = &diagnostics[..] else { panic!("{}", diagnostics.join("\n")) };
    diagnostic.strip_prefix(file).unwrap_or_else(|| panic!("not in {file} {diagnostic}")).to_string()
}

#[test]
fn a_finish_that_is_not_there_is_named() {
    let drawn = r#"<line class="wall" data-finish="glas" x1="10" y1="10" x2="90" y2="10"/>"#;
    let numbers = "[finish.glass]\ntranslucency = 0.5";
    says(one(read(drawn, numbers), "table.svg:"), &["there is no [finish.glas]", "glass"]);
    let lamp = r##"<circle id="l" class="lamp" data-finish="glass" fill="#fff" cx="50" cy="50" r="4"/>"##;
    says(one(read(lamp, numbers), "table.svg:"), &["a lamp has no `data-finish`"]);
}

#[track_caller]
fn says(diagnostic: String, parts: &[&str]) {
    for part in parts {
        assert!(diagnostic.contains(part), "`{diagnostic}` does not say `{part}`");
    }
}

/// A million attributes took 24 seconds: each is compared with all before it.
#[test]
fn an_element_with_very_many_attributes_is_refused_before_it_is_read() {
    let with = |count: usize| {
        let attributes = (0..count).map(|index| format!(" a{index}='>'")).collect::<String>();
        read(&format!("<!-- <g>\n --><![CDATA[ < ]]><g{attributes}/>"), "")
    };
    assert!(with(1000).is_ok());
    says(one(with(1001), "table.svg:"), &["6: this element has more than 1000 attributes"]);
}

#[test]
fn mistakes_in_shapes_have_their_line() {
    let wall = |rest: &str| drawn(&format!("<!-- -->\n<line id=\"w\" class=\"wall\" {rest}/>"));
    says(wall(r#"x1="9" y1="9" x2="9" y2="9""#), &["6: w: it has no length"]);
    says(wall(r#"x1="9" y1="9" x2="inf" y2="9""#), &["6: w: its x2 `inf` is not a plain number"]);
    says(wall(r#"x1="9" y1="9" x2="nan" y2="9""#), &["6: w: its x2 `nan`"]);
    says(wall(r#"x1="9" y1="9" x2="5cm" y2="9""#), &["6: w: its x2 `5cm`", "one unit is one millimetre"]);
    says(wall(r#"x1="9" y1="9" x2="1e300" y2="9""#), &["6: w: ", "far outside the playfield"]);
    says(wall(r#"x1="900" y1="9" x2="950" y2="9""#), &["6: w: it lies outside the playfield, near 900 9"]);
    says(wall(r#"x2="90" stroke-width="-3""#), &["6: w: its line is -3 mm thick"]);
    says(wall(r#"x2="90" transform="scale(1 2)""#), &["6: w: ", "stretch or skew"]);
    says(wall(r#"x2="90" transform="spin(3)""#), &["6: w: the transform `spin(3)` cannot be read"]);
    says(wall(r#"x2="90" stroke="reddish""#), &["6: w: its stroke `reddish` is not a colour"]);
    says(drawn(r#"<path id="w" class="wall" d="M10 10 L20 x"/>"#), &["5: w: its path cannot be read"]);
    says(drawn(r#"<path id="w" class="wall"/>"#), &["5: w: it has no `d`"]);
    says(drawn(r#"<polyline id="w" class="wall" points="1 2 3"/>"#), &["5: w: its `points` must be two or more pairs"]);
    says(drawn(r#"<rect id="w" class="wall" width="3"/>"#), &["5: w: its `width` and `height` must be more than 0"]);
    says(drawn(r#"<circle id="w" class="post" r="0"/>"#), &["5: w: its radius `r` must be more than 0"]);
    says(
        drawn(r#"<ellipse id="w" class="post" rx="3" ry="4"/>"#),
        &["5: w: a thing cannot be an `ellipse`", "polyline"],
    );
    says(drawn(r#"<text id="w" class="wall">x</text>"#), &["5: w: a thing cannot be a `text`"]);
}

#[test]
fn mistakes_in_words_have_their_line() {
    let gate = |rest: &str| drawn(&format!(r#"<line id="g" class="gate" x1="9" y1="9" x2="9" y2="40" {rest}/>"#));
    says(gate(""), &["5: g: a gate needs data-way"]);
    says(gate(r#"data-way="sideways""#), &["5: g: a gate needs data-way=\"up\""]);
    says(gate(r#"data-way="up""#), &["5: g: its data-way runs along the gate"]);
    says(gate(r#"data-way="left" data-side="left""#), &["5: g: a gate has no `data-side`; it may have data-way"]);
    let flipper =
        |rest: &str| drawn(&format!(r#"<line id="f" class="flipper" x1="9" y1="9" x2="80" y2="40" {rest}/>"#));
    says(flipper(r#"data-up-deg="50""#), &["5: f: a flipper needs data-side=\"left\" or"]);
    says(flipper(r#"data-side="up" data-up-deg="50""#), &["5: f: a flipper needs data-side"]);
    says(flipper(r#"data-side="left""#), &["5: f: a flipper needs data-up-deg", "from 10 to 120"]);
    says(flipper(r#"data-side="left" data-up-deg="-22""#), &["5: f: data-up-deg must be", "and it is `-22`"]);
    says(drawn(r#"<circle id="s" class="saucer" cx="99" cy="99" r="9"/>"#), &["5: s: a saucer needs data-eject-deg"]);
    says(drawn(r#"<circle class="bumper" cx="99" cy="99" r="9"/>"#), &["5: this bumper has no id"]);
    says(drawn(r#"<line id="left" class="wall" x2="9"/>"#), &["5: the id `left` is already taken in line 2"]);
    says(drawn(r#"<line id="w" class="wall rubber" x2="9"/>"#), &["5: it is both wall and rubber"]);
    says(drawn(r#"<line id="w" class="bumper" x2="9"/>"#), &["5: w: a bumper is drawn as a circle"]);
    says(drawn(r#"<circle id="w" class="slingshot" r="9"/>"#), &["5: w: a slingshot is drawn as one straight line"]);
    says(
        drawn(r#"<path id="w" class="insert" fill="red" d="M9 9h9v9"/>"#),
        &["5: w: an insert is drawn as closed outlines"],
    );
    says(drawn(r#"<path class="plastic" d="M9 9h9v9"/>"#), &["5: ", "a plastic is drawn as a circle or as one closed"]);
    says(drawn(r#"<circle id="w" class="lamp" r="9" fill="none"/>"#), &["5: w: the fill of a lamp is its light"]);
    says(
        drawn(r#"<circle id="w" class="lamp" r="9" fill="red" data-inside="z"/>"#),
        &["5: w: data-inside: no solid has the id `z`"],
    );
    says(drawn(r#"<defs><line id="w" class="wall" x2="9"/></defs>"#), &["5: a wall inside `defs` is not drawn"]);
    says(drawn(r#"<image href="a.png"/>"#), &["5: `image` cannot be printed"]);
    says(
        drawn(r#"<line class="flippr" data-side="left" x2="9"/>"#),
        &["5: the class `flippr` means nothing; did you mean `flipper`?"],
    );
    says(drawn(r#"<line data-side="left" x2="9"/>"#), &["5: it has `data-side` but its class is no thing"]);
    says(drawn(r#"<line id="p" class="plunger" x1="9" y1="9" x2="9" y2="40"/>"#), &["5: there is already a plunger"]);
}

#[test]
fn mistakes_in_ramps_have_their_line() {
    let ramp = |way: &str, rest: &str| drawn(&format!(r#"<path id="r" class="ramp" d="{way}" {rest}/>"#));
    let wide = r#"stroke-width="40" data-heights-mm="0 40""#;
    says(ramp("M99 99 V50", r#"stroke-width="40""#), &["5: r: it needs heights", "2 heights", "from 0 to 200"]);
    says(ramp("M99 99 V50 H90", wide), &["5: r: data-heights-mm must give 3 heights"]);
    says(ramp("M99 99 V50", r#"stroke-width="40" data-heights-mm="0 x""#), &["5: r: data-heights-mm must give 2"]);
    says(ramp("M99 99 V50", r#"stroke-width="40" data-heights-mm="0 -4""#), &["5: r: data-heights-mm must give 2"]);
    says(ramp("M99 99 V50 H50 Z", wide), &["5: r: it is drawn as one open line"]);
    says(drawn(r#"<circle id="r" class="ramp" cx="99" cy="99" r="9"/>"#), &["5: r: it is drawn as one open line"]);
    says(ramp("M99 99 V50", r#"stroke-width="26" data-heights-mm="0 40""#), &["5: r: its stroke-width must be more"]);
    says(ramp("M99 99 A30 30 0 0 1 129 69", wide), &["5: r: a turn must have a radius of 33.5 or more"]);
    let wires = r#"<path class="wire-form" d="M9 9 V50" stroke-width="30" data-heights-mm="0 9"/>"#;
    says(drawn(wires), &["5: this wire-form has no id"]);
}

#[test]
fn mistakes_in_coils_and_captive_balls_have_their_line() {
    let ball = |r: &str| drawn(&format!(r#"<circle id="c" class="captive-ball" cx="99" cy="99" r="{r}"/>"#));
    says(ball("12"), &["5: c: a captive ball is a pinball, so its r is 13.5, and it is 12.0"]);
    says(ball("14.1"), &["5: c: a captive ball is a pinball"]);
    // Six balls in one place took longer to play than play lasts.
    let two = |x: f64| {
        let ball = |id: &str, x: f64| format!(r#"<circle id="{id}" class="captive-ball" cx="{x}" cy="99" r="13.5"/>"#);
        format!("{}\n{}", ball("c", 99.0), ball("d", x))
    };
    says(drawn(&two(125.0)), &["5: c: it lies 1.0 mm deep in the captive ball d; draw them apart"]);
    says(drawn(&two(73.0)), &["6: d: it lies 1.0 mm deep in the captive ball c; draw them apart"]);
    assert!(read(&two(126.0), "").is_ok());
    says(drawn(r#"<line id="c" class="captive-ball" x2="9"/>"#), &["5: c: a captive-ball is drawn as a circle"]);
    says(drawn(r#"<circle class="captive-ball" cx="99" cy="99" r="13.5"/>"#), &["5: this captive-ball has no id"]);
    let flap = |rest: &str| drawn(&format!(r#"<line id="d" class="diverter" x1="9" y1="9" x2="9" y2="50" {rest}/>"#));
    says(flap(""), &["5: d: a diverter needs data-turn-deg", "from -120 to 120"]);
    says(flap(r#"data-turn-deg="130""#), &["5: d: data-turn-deg must be", "and it is `130`"]);
    says(flap(r#"data-turn-deg="2""#), &["5: d: data-turn-deg must be 5 or more either way, and it is 2"]);
    says(flap(r#"data-turn-deg="40" stroke-width="0.4""#), &["5: d: its stroke-width must be 1 or more"]);
    says(
        flap(r#"data-turn-deg="40" data-side="left""#),
        &["5: d: a diverter has no `data-side`; it may have data-turn-deg"],
    );
    says(
        drawn(r#"<circle id="k" class="kickback" cx="9" cy="9" r="9"/>"#),
        &["5: k: a kickback is drawn as one straight"],
    );
    says(drawn(r#"<line id="m" class="magnet" x2="9"/>"#), &["5: m: a magnet is drawn as a circle"]);
    says(drawn(r#"<line class="kickback" x2="9"/>"#), &["5: this kickback has no id"]);
    let magnet = r#"<circle id="m" class="magnet" cx="99" cy="99" r="45"/>"#;
    says(
        one(read(magnet, "[part.m]\npull_m_s2 = 900"), "table.toml:"),
        &["2: `pull_m_s2` must be a number from 1 to 500"],
    );
    says(
        one(read(magnet, "[part.m]\nfinish = \"x\""), "table.toml:"),
        &["2: `finish` is not known here; there is pull_m_s2"],
    );
}

#[test]
fn mistakes_in_numbers_have_their_line() {
    says(numbers("\nslope = 6"), &["2: `slope` is not known", "slope_deg"]);
    says(numbers("slope_deg = 90"), &["1: `slope_deg` must be a number from 0.5 to 20"]);
    says(numbers("slope_deg = nan"), &["1: `slope_deg` must be a number"]);
    says(numbers("playfield_friction = \"low\""), &["1: `playfield_friction` must be a number from 0 to 1"]);
    says(numbers("name = 3"), &["1: `name` must be text in quotes"]);
    says(numbers("ambient = \"#12\""), &["1: ambient: `#12` is not a colour"]);
    says(numbers("[class.bumpr]\n"), &["1: there is no class `bumpr` (did you mean `bumper`?); there are wall, "]);
    says(numbers("[part.pip]\n"), &["1: no thing in the drawing has the id `pip`"]);
    says(numbers("slope_dg = 6"), &["1: `slope_dg` is not known (did you mean `slope_deg`?); there are name, "]);
    says(numbers("[class.bumper]\nkik_m_s = 6"), &["2: `kik_m_s` is not known here (did you mean `kick_m_s`?); there"]);
    says(
        numbers("[part.pop]\nkick = 2"),
        &["2: `kick` is not known here; there are material, finish, shadow, kick_m_s"],
    );
    says(numbers("[part.pop]\nkick_m_s = 200"), &["2: `kick_m_s` must be a number from 0 to 20"]);
    says(numbers("[part.pop]\nmaterial = \"gum\""), &["2: there is no material `gum`; there are drop-target, "]);
    says(numbers("[part.pop]\nfinish = \"gold\""), &["2: there is no finish `gold`"]);
    says(numbers("[part.pop]\nshadow = 1"), &["2: `shadow` must be true or false"]);
    says(numbers("[class.drain]\nshadow = true"), &["2: `shadow` is not known here, and nothing is: take it out"]);
    says(numbers("[material.gum]\nfriction = 1"), &["1: the material `gum` has no `restitution`"]);
    says(numbers("[material.gum]\nrestitution = 2\nfriction = 1"), &["2: `restitution` must be a number from 0 to 1"]);
    says(numbers("[finish.gold]\nprofile = \"round\""), &["2: the profile is `round`", "bevel 0.8"]);
    says(numbers("[finish.gold]\nshine = 1"), &["2: `shine` is not known here", "gloss"]);
    says(numbers("\nrelief_mm = 5.1"), &["2: `relief_mm` must be a number from 0 to 5"]);
    says(numbers("relief_mm = -0.1"), &["1: `relief_mm` must be a number from 0 to 5"]);
    says(numbers("relief = 0.6"), &["1: `relief` must be a table"]);
    says(numbers("[relief]\ngrain = 2"), &["2: `grain` must be a number from 0 to 1"]);
    says(numbers("[relief]\n\nplanks_mm = 4"), &["3: `planks_mm` must be 0, for no planks, or a width from 5"]);
    says(numbers("[relief]\nknots = 1"), &["2: `knots` is not known here; there are planks_mm, grain, scratches"]);
    says(numbers("part = 3"), &["1: `part` must be a table"]);
    says(
        numbers("name = \"a\"\nname = \"b\""),
        &["2: `name = \"b\"` is there already, from line 1; take one of them out"],
    );
    says(numbers("slope_deg = = 6"), &["1: this is not TOML"]);
}

#[test]
fn mistakes_of_the_whole_drawing_are_told() {
    let svg = |svg: &str| one(read_files(svg, "", ""), "table.svg:");
    says(svg("hello"), &["1: this is not well-formed XML"]);
    says(svg("<svg>\n<g></svg>"), &["2: this is not well-formed XML"]);
    says(svg("<!DOCTYPE svg [<!ENTITY a \"aaaa\">]><svg/>"), &["it has a DOCTYPE"]);
    let empty = r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 500 1000"/>"#;
    let missing = read_files(empty, "", "").unwrap_err();
    assert_eq!(missing.len(), 3, "{missing:?}");
    for word in ["no flipper", "no drain", "no plunger"] {
        assert!(missing.iter().any(|diagnostic| diagnostic.contains(word)), "{missing:?}");
    }
    let with = |from: &str, to: &str| svg(&SVG.replace("{}", "").replace(from, to));
    says(with("viewBox=\"0 0 500 1000\"", ""), &["1: the drawing has no viewBox"]);
    says(with("0 0 500 1000", "0 0 500 1e9"), &["1: the viewBox is `0 0 500 1e9`"]);
    says(with("0 0 500 1000", "5 0 500 1000"), &["1: the viewBox is `5 0 500 1000`"]);
    says(with("www.w3.org/2000/svg", "example.org"), &["1: the drawing must begin with <svg xmlns="]);
}

#[test]
fn drawings_without_end_are_refused() {
    let deep = format!("{}{}", "<g>".repeat(100_000), "</g>".repeat(100_000));
    says(drawn(&deep), &["elements lie inside each other"]);
    // What is hidden was not counted, and the stack ran over when the layers were cut apart.
    let hidden = format!(r#"<g display="none">{}{}</g>"#, "<g>".repeat(30_000), "</g>".repeat(30_000));
    says(drawn(&hidden), &["5: more than 64 elements lie inside each other"]);
    says(one(read(&"<g/>".repeat(250_000), ""), "table.svg: "), &["more than 200000 nodes"]);
    let many = format!("M0 0{}", "h1h-1".repeat(20_000));
    says(drawn(&format!(r#"<path id="w" class="wall" d="{many}"/>"#)), &["5: w: it has more than 10000 pieces"]);
    let coil: String = (0..9000).map(|_| "<circle/>").collect();
    says(
        drawn(&coil.replace("<circle/>", r#"<path class="wall" d="M9 9 q400 0 400 400 q-400 0 -400 -380"/>"#)),
        &["more than 200000 pieces"],
    );
    let curve = r#"<path id="w" class="wall" d="M0 0 C 1e5 0 0 1e5 9 9"/>"#;
    says(drawn(curve), &["5: w: "]);
}

/// A half of a drawing was said to be wrong in line 1.
#[test]
fn a_drawing_that_was_cut_off_is_told_where_it_ends() {
    for cut in ["<g>\n<g>\n", "<g>\n<path\n", "<g>\n<path d=\"M0", "<g>\n"] {
        let whole = SVG.replace("{}\n", "{}").replace("{}", cut);
        let half = &whole[..whole.find(cut).unwrap() + cut.len()];
        let told = one(read_files(half, "", ""), "table.svg:");
        let line = half.trim_end().lines().count();
        assert!(told.starts_with(&format!("{line}: ")), "{line} of {cut:?}: {told}");
    }
    says(
        one(read_files("<svg xmlns=\"http://www.w3.org/2000/svg\">\n<g>\n\n", "", ""), "table.svg:"),
        &["2: the drawing ends here, in the middle of an element; it was not saved whole"],
    );
}

/// "of a insert" stood in the sentence.
#[test]
fn an_insert_has_its_article() {
    let insert = r#"<rect id="i" class="insert" x="9" y="9" width="9" height="9" fill="none"/>"#;
    says(one(read(insert, ""), "table.svg:"), &["5: i: the fill of an insert is its light"]);
}

/// A lamp in a bumper whose radius was forgotten was told too, though nothing was wrong with it.
#[test]
fn what_names_a_refused_thing_is_no_second_mistake() {
    let lamp = r##"<circle id="l" class="lamp" data-inside="pop" fill="#fff" cx="50" cy="50" r="4"/>"##;
    let with_lamp =
        |drawn: &str| one(read(&format!("{drawn}\n{lamp}"), "[part.pop]\nfinish = \"x\"\n[finish.x]\n"), "table.svg:");
    says(with_lamp(r#"<circle id="pop" class="bumper" cx="50" cy="50"/>"#), &["5: pop: "]);
    says(with_lamp(r#"<circle id="pop" class="bumpers" cx="50" cy="50" r="20"/>"#), &["did you mean `bumper`?"]);
    says(
        with_lamp(r#"<circle id="pop" class="bumper post" cx="50" cy="50" r="20"/>"#),
        &["it is both bumper and post"],
    );
    says(with_lamp(r#"<defs><circle id="pop" class="bumper" cx="50" cy="50" r="20"/></defs>"#), &["is not drawn"]);
    let twice = r#"<circle id="pop" class="bumper" cx="50" cy="50" r="20"/><circle id="pop" class="post" cx="90" cy="50" r="0"/>"#;
    let told = read(&format!("{twice}\n{lamp}"), "").unwrap_err();
    assert!(told.len() == 2 && told.iter().all(|one| one.starts_with("table.svg:5: ")), "{told:?}");
}

#[test]
fn all_mistakes_are_told_at_once_in_their_order() {
    let diagnostics = read(
        "<circle class=\"bumper\" r=\"3\"/>\n<line id=\"w\" class=\"wall\"/>",
        "[part.nobody]\n[class.wall]\nmaterial = \"air\"\n",
    )
    .unwrap_err();
    let places: Vec<&str> = diagnostics.iter().map(|diagnostic| diagnostic.split(": ").next().unwrap()).collect();
    assert_eq!(places, ["table.svg:5", "table.svg:6", "table.toml:1", "table.toml:3"], "{diagnostics:#?}");
}

#[test]
fn lamps_of_no_form_and_of_no_sensible_size_have_their_line() {
    let lamp = |drawn_as: &str| drawn(&drawn_as.replace("{}", r##"id="w" class="lamp" fill="#fff" stroke="#fff""##));
    says(
        lamp(r#"<rect {} width="9" height="9"/>"#),
        &["5: w: a lamp is drawn as a circle (a bulb) or as one straight"],
    );
    says(lamp(r#"<circle {} cx="99" cy="99" r="0"/>"#), &["5: w: its radius `r` must be more than 0"]);
    says(lamp(r#"<line {} x1="99" y1="99" x2="99.001" y2="99"/>"#), &["5: w: its line is 0.00", "as a circle"]);
    says(lamp(r#"<line {} x1="99" y1="99" x2="99" y2="99"/>"#), &["5: w: it has no length"]);
    let no_stroke = r##"<line id="w" class="lamp" fill="#fff" x1="99" y1="99" x2="199" y2="99"/>"##;
    says(drawn(no_stroke), &["5: w: the stroke of a lamp is its light"]);
    let hall = SVG.replace("0 0 500 1000", "0 0 5000 5000");
    let moon = r#"<circle id="w" class="lamp" cx="2500" cy="2500" r="2000"/>"#;
    let diagnostics = read_files(&hall.replace("{}", moon), "", "").unwrap_err();
    assert_eq!(diagnostics[0], "table.svg:5: w: the radius of a lamp must be at most 1000 mm, and it is 2000.0 mm");
    assert!(diagnostics[1].starts_with("warning: table.svg:1: the playfield is 5000 x 5000 mm"), "{diagnostics:?}");
}
