//! What is printed where.

mod agreement;
mod normal_map;
mod refusals;

use crate::art;
use crate::small_table::{read, table};
use geometry::DVec2;
use tracer::View;

const LAMPS: &str = r##"<circle id="bulb" class="lamp" cx="100" cy="100" r="5" fill="#ff8000"/>
    <rect id="win" class="insert" x="200" y="200" width="40" height="20" fill="#ff0000"/>"##;

/// One pixel a millimetre.
const VIEW: View = View { width: 500, height: 1000, origin_mm: DVec2::ZERO, mm_per_px: 1.0 };

fn pixel(pixels: &[[u8; 4]], x: usize, y: usize) -> [u8; 4] {
    pixels[y * VIEW.width + x]
}

const ART: &str = r##"<defs><linearGradient id="sky"><stop stop-color="#204080"/></linearGradient></defs>
    <rect width="500" height="1000" fill="url(#sky)"/>
    <line class="wall" x1="20" y1="20" x2="120" y2="20" stroke="#ff0000" stroke-width="10"/>
    <rect id="win" class="insert" x="200" y="200" width="40" height="20" fill="#ff0000"/>
    <circle id="hole" class="saucer" cx="300" cy="300" r="14" fill="#010203" data-eject-deg="90" data-eject-m-s="1"/>
    <g transform="translate(100 400)"><g class="plastics"><circle class="plastic" r="20" fill="#00ff00"/>
      <rect x="-2" y="-2" width="4" height="4" fill="#ffffff"/>
      <circle class="post" cx="10" cy="0" r="3" fill="#ff00ff"/></g></g>"##;

#[test]
fn each_art_is_printed_where_it_belongs() {
    // Without facets: what is asked here is where things are printed.
    let art = art::floor(&read(ART, "[relief]\ninserts = 0").unwrap(), &VIEW).unwrap();
    let sky = [0x20, 0x40, 0x80, 255];
    assert_eq!(pixel(&art.floor, 400, 50), sky);
    assert_eq!(pixel(&art.floor, 70, 20), sky, "a wall is no art");
    assert_eq!(pixel(&art.floor, 100, 400), sky, "plastics are above the floor");
    assert_eq!(pixel(&art.floor, 300, 300), [1, 2, 3, 255], "a hole is in the floor");
    let [red, green, blue, _] = pixel(&art.floor, 220, 210);
    assert!(red > 40 && red < 90 && green < 20 && blue < 20, "an unlit window is dark: {red} {green} {blue}");
    assert_eq!(pixel(&art.tops, 100, 400), [255; 4]);
    assert_eq!(pixel(&art.tops, 112, 400), [0, 255, 0, 255], "a post among the plastics is no art");
    assert_eq!(pixel(&art.tops, 400, 50), [0; 4]);
}

#[test]
fn a_view_may_scale_and_shift_the_art() {
    let view = View { width: 60, height: 40, origin_mm: DVec2::new(-10.0, 0.0), mm_per_px: 0.5 };
    let table = table(
        r##"<rect width="10" height="10" fill="#ffffff"/><rect x="-99" width="99" height="99" fill="#ff0000"/>"##,
    );
    let art = art::floor(&table, &view).unwrap();
    let at = |x: usize, y: usize| art.floor[y * 60 + x];
    assert_eq!([at(20, 0), at(39, 19)], [[255; 4]; 2]);
    assert_ne!(at(40, 0), [255; 4]);
    assert_eq!(at(19, 0), at(0, 30), "nothing is printed beside the playfield");
}

#[test]
fn masks_cover_what_their_windows_cover() {
    let table = table(LAMPS);
    let view = View { width: 250, height: 500, origin_mm: DVec2::new(0.0, 1.0), mm_per_px: 2.0 };
    let masks = art::masks(&table, &view);
    assert!(masks[0].coverage.is_empty(), "a bulb has no mask");
    let window = &masks[1];
    assert_eq!((window.x, window.y, window.width), (100, 99, 20));
    // It begins half way down its first row of pixels.
    assert!((120..=136).contains(&window.coverage[5]), "{}", window.coverage[5]);
    assert_eq!(window.coverage[window.width * 3 + 5], 255);
    let area: f64 = window.coverage.iter().map(|&coverage| f64::from(coverage) / 255.0 * 4.0).sum();
    assert!((area - 800.0).abs() < 2.0, "{area} mm2");
}

#[test]
fn a_font_that_is_not_there_is_a_mistake() {
    let text = |font: &str| table(&format!(r#"<text x="9" y="99" font-family="{font}" font-size="20">Lux</text>"#));
    art::check(&text("Marcellus, serif")).unwrap();
    let mistake = art::check(&text("Comic Sans MS")).unwrap_err().to_string();
    assert!(mistake.contains("no font") && mistake.contains("Cinzel, ") && mistake.contains("Marcellus"), "{mistake}");
    let art = art::floor(&text("Oxanium"), &VIEW).unwrap();
    let fonts_background = pixel(&art.floor, 499, 999);
    assert!((80..100).any(|y| (9..60).any(|x| pixel(&art.floor, x, y) != fonts_background)), "the text is printed");
}

/// A heart that no font has was printed as a box, and check said ok.
#[test]
fn a_letter_that_no_font_has_is_told_with_its_line() {
    let text = |inside: &str| table(&format!("<g>\n<text x=\"9\" y=\"99\">{inside}</text></g>"));
    let told = art::letters_warning(&text("Lux \u{2665} <tspan>\u{4e2d}</tspan>")).unwrap();
    let lines: Vec<&str> = told.to_string().leak().split(": ").collect();
    assert!(told.is_warning() && lines[1].starts_with("table.svg:"), "{told}");
    assert!(told.to_string().contains("has the letter `\u{2665}` (U+2665), `\u{4e2d}` (U+4E2D), so a box"), "{told}");
    let plain =
        "L\u{fc}x e\u{301}\u{a0}\u{ad}\u{200b}&amp; <title>\u{2665}</title><tspan display=\"none\">\u{2665}</tspan>";
    assert_eq!(art::letters_warning(&text(plain)), None);
    assert_eq!(art::letters_warning(&table("<desc>\u{2665}</desc>")), None);
}
