//! What may be repainted without breaking recordings, and what is printed where.

use super::{SVG, read, read_files, table};
use crate::Table;
use crate::table::{Watch, art};
use geometry::DVec2;
use std::time::{Duration, SystemTime};
use tracer::View;

const LAMPS: &str = r##"<circle id="bulb" class="lamp" cx="100" cy="100" r="5" fill="#ff8000"/>
    <rect id="win" class="insert" x="200" y="200" width="40" height="20" fill="#ff0000"/>"##;

#[test]
fn the_hash_sees_what_a_game_depends_on_and_no_paint() {
    let original = read(LAMPS, "").unwrap().hash;
    let repainted = LAMPS.replace("#ff8000", "#0080ff") + r#"<rect width="9" height="9" fill="blue"/>"#;
    assert_eq!(read(&repainted, "[class.lamp]\npower = 9\nreach_mm = 99").unwrap().hash, original);
    assert_eq!(read(LAMPS, "ambient = \"#ffffff\"\nname = \"x\"").unwrap().hash, original);
    assert_eq!(read(LAMPS, "[finish.a]\n[class.flipper]\nfinish = \"a\"").unwrap().hash, original);
    // Where the new thing stands in the drawing must not matter to the names of those after it.
    let before = SVG.replace("<line class=\"drain\"", r#"<circle class="plastic" r="9"/><line class="drain""#);
    assert_eq!(read_files(&before.replace("{}", LAMPS), "", "").unwrap().hash, original);
    let others = [
        read(&LAMPS.replace("bulb", "blub"), ""),
        read(&LAMPS.replace("\"lamp\"", "\"insert\""), ""),
        read(&(LAMPS.to_string() + r#"<line class="wall" x2="9"/>"#), ""),
        read(LAMPS, "[class.flipper]\nmass_kg = 0.081"),
        read(LAMPS, "slope_deg = 6.500001"),
        read_files(&SVG.replace("{}", LAMPS), "", "fn start() {}"),
        read_files(&SVG.replace("{}", LAMPS).replace("x1=\"150\"", "x1=\"150.001\""), "", ""),
    ];
    for (index, other) in others.into_iter().enumerate() {
        assert_ne!(other.unwrap().hash, original, "change {index}");
    }
}

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

struct Folder(std::path::PathBuf);

impl Folder {
    fn new(name: &str) -> Folder {
        let dir = std::env::temp_dir().join(format!("caustic-{name}-{}", std::process::id()));
        std::fs::create_dir_all(&dir).unwrap();
        let folder = Folder(dir);
        folder.write("table.svg", &SVG.replace("{}", ""), 0);
        folder.write("table.toml", "name = \"Small\"", 0);
        folder.write("rules.rhai", "", 0);
        folder
    }

    fn write(&self, file: &str, text: &str, saved_s: u64) {
        let path = self.0.join(file);
        std::fs::write(&path, text).unwrap();
        let saved = SystemTime::UNIX_EPOCH + Duration::from_secs(1_000_000_000 + saved_s);
        std::fs::File::options().write(true).open(path).unwrap().set_modified(saved).unwrap();
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

#[test]
fn a_folder_is_a_table_and_its_missing_files_are_named() {
    let folder = Folder::new("load");
    let table = Table::load(folder.0.to_str().unwrap()).unwrap();
    assert_eq!((table.title.as_str(), Some(table.name.as_str())), ("Small", folder.0.file_name().unwrap().to_str()));
    std::fs::remove_file(folder.0.join("rules.rhai")).unwrap();
    std::fs::write(folder.0.join("table.toml"), b"name = \"a\"\n\xff").unwrap();
    let mistakes: Vec<String> = Table::load_dir(&folder.0).unwrap_err().iter().map(ToString::to_string).collect();
    assert_eq!(mistakes.len(), 2, "{mistakes:?}");
    assert!(mistakes[0].ends_with("rules.rhai: there is no such file, and a table needs it"), "{mistakes:?}");
    assert!(mistakes[1].contains("table.toml:2: this is not UTF-8"), "{mistakes:?}");
    std::fs::write(folder.0.join("table.toml"), "#".repeat(2 << 20)).unwrap();
    let mistakes = Table::load_dir(&folder.0).unwrap_err();
    assert!(mistakes.iter().any(|mistake| mistake.to_string().contains("larger than 1024 kB")), "{mistakes:?}");
}

#[test]
fn a_watch_tells_what_was_saved_once_and_waits_until_it_is_whole() {
    let folder = Folder::new("watch");
    let mut watch = Watch::new(&folder.0);
    let mut at = |ms: u64| watch.changed(Duration::from_millis(ms));
    assert!(at(1000).is_empty());
    folder.write("rules.rhai", "fn half", 1);
    assert!(at(1100).is_empty(), "it looks only now and then");
    assert!(at(1250).is_empty(), "it may still be being written");
    folder.write("rules.rhai", "fn half() {}", 1);
    folder.write("table.svg", "<svg/>", 1);
    assert!(at(1500).is_empty(), "it was written to since");
    assert_eq!(at(1800), ["table.svg", "rules.rhai"]);
    assert!(at(2100).is_empty(), "it tells once");
    folder.write("table.toml", "name = \"Large\"", 2);
    assert!(at(2400).is_empty());
    assert_eq!(at(2700), ["table.toml"]);
}

#[test]
fn a_repainted_table_plays_the_same_game() {
    let repainted = LAMPS.replace("#ff8000", "#0080ff").replace("#ff0000", "#00ff00");
    let play = |drawn: &str, numbers: &str| {
        let mut table = read(drawn, numbers).unwrap();
        table.rules = "fn on_start() { lamp(\"bulb\", 700); }".to_string();
        let mut simulation = crate::Simulation::new(std::sync::Arc::new(table), 7).unwrap();
        for _ in 0..200 {
            simulation.tick(crate::Buttons::LEFT);
        }
        simulation.hash()
    };
    assert_eq!(play(LAMPS, ""), play(&repainted, "[class.lamp]\npower = 3"));
}
