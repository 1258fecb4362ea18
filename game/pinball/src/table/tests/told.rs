//! What is told, and where: the cause by its own line, once, and not what comes of it.

use super::{SVG, one, read, read_files, table};
use crate::table::{Table, TableSources};

#[track_caller]
fn numbers(numbers: &str) -> String {
    one(read("", numbers).unwrap_err()).replacen("table.toml:", "", 1)
}

#[track_caller]
fn files(svg: &str, toml: &str, rules: &str) -> String {
    one(read_files(svg, toml, rules).unwrap_err())
}

/// Swapped files were told by up to 62 lines that could not be read.
#[test]
fn a_file_that_holds_what_belongs_elsewhere_is_told_in_one_sentence() {
    let (svg, toml, rules) =
        (&SVG.replace("{}", ""), "name = \"x\"\n\n[class.wall]\nshadow = true\n", "// x\nfn on_start() {}\n");
    let home = |held: &str, belongs: &str, home: &str| {
        format!(":1: {held} is in it, and {belongs} here; that is {home}'s; give each file the name of what is in it")
    };
    let (drawing, here) = ("a drawing (SVG)", "a drawing (SVG) belongs");
    let (of_numbers, numbers_here) = ("a table's numbers (TOML)", "the table's numbers (TOML) belong");
    let (of_rules, rules_here) = ("rules (Rhai)", "the rules (Rhai) belong");
    assert_eq!(files(rules, toml, rules), format!("table.svg{}", home(of_rules, here, "rules.rhai")));
    assert_eq!(files(toml, toml, rules), format!("table.svg{}", home(of_numbers, here, "table.toml")));
    assert_eq!(files(svg, svg, rules), format!("table.toml{}", home(drawing, numbers_here, "table.svg")));
    assert_eq!(files(svg, rules, rules), format!("table.toml{}", home(of_rules, numbers_here, "rules.rhai")));
    assert_eq!(files(svg, toml, svg), format!("rules.rhai{}", home(drawing, rules_here, "table.svg")));
    assert_eq!(files(svg, toml, toml), format!("rules.rhai{}", home(of_numbers, rules_here, "table.toml")));
    let page = "<!DOCTYPE html>\n<html><body><svg/></body></html>";
    assert_eq!(
        files(page, toml, rules),
        "table.svg:1: a web page (HTML) is in it, and a drawing (SVG) belongs here; save the drawing alone, as plain SVG"
    );
    assert!(files(svg, "{\n \"name\": 1\n}", rules).starts_with("table.toml:1: JSON is in it"));
    assert!(read_files(svg, toml, rules).is_ok() && read_files(svg, "", "").is_ok());
}

/// Numbers that were compressed were told to be an .svgz.
#[test]
fn what_is_no_text_is_told_by_the_file_that_it_is_in() {
    let svg = SVG.replace("{}", "").into_bytes();
    let read = |place: usize, bytes: &[u8]| {
        let mut files = [svg.clone(), Vec::new(), Vec::new()];
        files[place] = bytes.to_vec();
        let (name, origin, folder) = ("small".to_string(), String::new(), String::new());
        let told = Table::parse(TableSources { name, origin, folder, files: files.map(Ok) }).unwrap_err();
        one(told.iter().map(ToString::to_string).collect())
    };
    assert!(read(0, &[0x1f, 0x8b, 8]).starts_with("table.svg: it is compressed, as an .svgz is; "));
    let packed = "it is compressed with gzip; unpack it: here plain text belongs";
    assert_eq!(read(1, &[0x1f, 0x8b, 8]), format!("table.toml: {packed}"));
    assert_eq!(read(2, &[0x1f, 0x8b, 8]), format!("rules.rhai: {packed}"));
    assert_eq!(read(2, b"%PDF-1.7"), "rules.rhai: it is a PDF, and here plain text belongs");
}

/// A quote was missed where a `>` was, or the end of a CDATA.
#[test]
fn what_xml_does_not_end_is_told_by_its_name() {
    let told = |drawn: &str| one(read(drawn, "").unwrap_err()).replacen("table.svg:", "", 1);
    let wall = "<path class='wall' d='M0 0h9'/>";
    let broken = "5: this is not well-formed XML: ";
    assert_eq!(
        told(&format!("<style><![CDATA[\n.wall {{ fill: red }}\n</style>{wall}")),
        format!("{broken}this `<![CDATA[` is never closed with `]]>`")
    );
    assert_eq!(
        told(&format!("<g\n{wall}</g>")),
        format!("{broken}the tag `<g` does not end: a `>` is missing behind it")
    );
    assert_eq!(
        told(&format!("<g class=\"a\"\n{wall}</g>")),
        format!("{broken}the tag `<g class=\"a\"` does not end: a `>` is missing behind it")
    );
    assert!(told(&format!("<g class=\"a>\n{wall}</g>")).starts_with(&format!("{broken}a quote is missing in")));
}

/// `40mm` was told that text stands in quotes, and `==` was told twice, once of line 1.
#[test]
fn a_line_that_is_no_toml_is_told_with_what_was_meant() {
    for (line, hint) in [
        ("slope_deg = 40mm", "a number stands alone: write slope_deg = 40, which is in degrees"),
        ("relief_mm = 1.5 mm", "a number stands alone: write relief_mm = 1.5, which is in millimetres"),
        ("ambient_power = 100 %", "a number stands alone: write ambient_power = 100"),
        ("slope_deg = 6 // steep", "a comment begins with #"),
        ("// steep", "a comment begins with #"),
        ("/* steep */", "a comment begins with #"),
        ("slope_deg = 6 ; steep", "a comment begins with #"),
        ("slope_deg = 6;", "nothing stands behind a value, no comma and no ;"),
        ("name = \"x\",", "nothing stands behind a value, no comma and no ;"),
        ("slope_deg == 6", "one = is enough"),
        ("ambient==3", "one = is enough"),
        ("slope_deg =", "its value is missing"),
        ("slope_deg = 05", "a number is written as 5, -5 or 0.5"),
        ("slope_deg = .5", "a number is written as 5, -5 or 0.5"),
        ("slope_deg = 1 000", "a number is written as 5, -5 or 0.5"),
        ("name = \u{201c}x\u{201d}", "quotes are written \", straight ones"),
        ("name = \"a\" slope_deg = 6", "each NAME = VALUE stands on a line of its own"),
        ("name = \"a\\q\"", "a \\ in a text is written \\\\"),
        ("shadow = True", "write true or false"),
        ("name = x", "text stands in \"quotes\""),
    ] {
        let told = numbers(line);
        assert_eq!(told, format!("1: this is not TOML: `{line}`; {hint}"), "{line}");
    }
}

/// A text that was never closed was told of the last line, with names that it had swallowed.
#[test]
fn a_text_without_an_end_is_told_where_it_begins() {
    for quote in ["\"\"\"", "'''"] {
        let text =
            format!("slope_deg = 6\nname = {quote}x\n[finish.gold]\ngloss = 1\n[class.wall]\nfinish = \"gold\"\n");
        let svg = SVG.replace("{}", "<path class='wall' d='M0 0h9' data-finish='gold'/>");
        let told = files(&svg, &text, "");
        let what = format!(
            "the text in {quote} that begins here is never closed, and swallows the rest; close it with {quote}"
        );
        assert_eq!(told, format!("table.toml:2: {what}"));
    }
    let lost = "[finish.gold\ngloss = 1\n[class.wall]\nfinish = \"gold\"";
    assert!(numbers(lost).starts_with("1: this is not TOML: `[finish.gold`"));
}

/// A dotted key behind a table was told not to be known, with `gloss` for `class`; one that is there twice had no first.
#[test]
fn a_key_is_told_by_the_table_that_it_stands_in() {
    let below = "stands below a [TABLE], and so belongs to that; ";
    assert_eq!(
        numbers("[finish.gold]\nclass.wall.shadow = true"),
        format!("2: `class` {below}write it in brackets of its own, as [class.NAME]")
    );
    assert_eq!(numbers("[finish.gold]\nslope_deg = 6"), format!("2: `slope_deg` {below}put it above the first one"));
    let twice = "class.wall.shadow = true\n\n[class.wall]\nshadow = true";
    assert_eq!(numbers(twice), "3: `[class.wall]` is there already, from line 1; take one of them out");
    let key = "[finish.a]\ngloss = 1\n[finish.b]\ngloss = 1\ngloss = 1";
    assert_eq!(numbers(key), "5: `gloss = 1` is there already, from line 4; take one of them out");
}

/// One slip in a sheet was told of every thing that it meant, at their lines.
#[test]
fn a_value_of_a_sheet_is_told_once_in_the_sheet() {
    let walls = "<path class='wall' id='a' d='M40 40h40'/>\n<path class='wall' id='b' d='M40 60h40'/>";
    let told = |sheet: &str| one(read(&format!("<style>\n{sheet}\n</style>\n{walls}"), "").unwrap_err());
    let given = "(the sheet gives it to a of line 8, and to 1 more)";
    assert_eq!(
        told(".wall { stroke-width: 8mm }"),
        format!("table.svg:6: this stroke-width `8mm` is not a plain number; one unit is one millimetre {given}")
    );
    assert!(
        told(".wall { stroke-width: 8mmm }")
            .starts_with("table.svg:6: this stroke-width `8mmm` is not a plain number; ")
    );
    assert_eq!(
        told(".wall { stroke: rubbr }"),
        format!("table.svg:6: this stroke `rubbr` is not a colour; write it as \"#rrggbb\" {given}")
    );
    let own = "<path class='wall' id='a' style='stroke-width: 8mm' d='M40 40h40'/>";
    assert!(one(read(own, "").unwrap_err()).starts_with("table.svg:5: a: its stroke-width `8mm` is not"), "its own");
    let warned = |sheet: &str| {
        let drawn = format!("<style>{sheet}</style><path class='wall' fill='red' stroke-width='2' d='M40 40h40'/>");
        table(&drawn)
            .warnings
            .iter()
            .map(|one| one.to_string().replacen("warning: table.svg:5: ", "", 1))
            .collect::<Vec<_>>()
    };
    assert_eq!(warned(".wall { fill: #12 }"), ["this fill `#12` is not a colour; write it as \"#rrggbb\""]);
    assert_eq!(warned(".wall { opacity: o.5 }"), ["this opacity `o.5` is not a plain number"]);
    assert_eq!(warned(".wall { display: nonne }"), ["this display `nonne` means nothing; did you mean `none`?"]);
    for word in ["material", "kick_m_s"] {
        let what = "is no property of a drawing: write it into table.toml, below the thing's [class.NAME]";
        assert_eq!(warned(&format!(".wall {{ {word}: rubber }}")), [format!("`{word}` {what}")]);
    }
    for good in
        ["fill: url(#a) none", "opacity: 50%", "stroke-width: .5px", "opacity: calc(1 / 2)", "visibility: inherit"]
    {
        assert_eq!(warned(&format!(".wall {{ {good} }}")), [""; 0], "{good}");
    }
}

/// What was hidden, or had lost its class, was told not to be in the drawing at all.
#[test]
fn what_is_drawn_and_no_thing_is_told_with_why() {
    let circle = |rest: &str| format!("<g>\n<circle id='pop' cx='90' cy='90' r='20' {rest}/></g>");
    let told = |rest: &str, why: &str| {
        let numbers = "[part.pop]\nkick_m_s = 1";
        let expected = format!("table.toml:1: no thing in the drawing has the id `pop`: line {why}");
        assert_eq!(read(&circle(rest), numbers).unwrap_err()[0], expected);
        let rules = "fn on_switch(name) {\n  closed(\"pop\");\n}";
        let table = read_files(&SVG.replace("{}", &circle(rest)), "", rules).unwrap();
        let failure = crate::rules::Program::new(&table).map(|_| ()).unwrap_err().to_string();
        assert_eq!(failure, format!("rules.rhai:2: there is no part called \"pop\": line {why}"));
    };
    told("", "6 of the drawing draws it without a class, so it is art; give it a thing's");
    told("class='bumper' display='none'", "6 of the drawing hides it (`display: none`), so it is not there");
    let clone = "<use id='pop' href='#nothing'/>";
    let failure = read(clone, "[part.pop]\nkick_m_s = 1").unwrap_err().join(" ");
    // It was called art without a class, and with a class it is refused.
    assert!(failure.contains("is a clone of what is no thing; let its href name a thing"), "{failure}");
    told("class='st0'", "6 of the drawing draws it with the class `st0`, which makes it art");
}

/// A group was told that a thing cannot be a `g`.
#[test]
fn a_class_of_a_thing_on_a_group_is_told_in_plain_words() {
    let group = "<g class='plastic'><path d='M40 40h40v9z'/></g>";
    let told = one(read(group, "").unwrap_err());
    assert_eq!(told, "table.svg:5: plastic#0: a group is no thing: give the class to each shape in it instead");
}
