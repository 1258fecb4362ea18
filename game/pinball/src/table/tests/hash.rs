//! What may be repainted without breaking recordings.

use super::{SVG, read, read_files};

const LAMPS: &str = r##"<circle id="bulb" class="lamp" cx="100" cy="100" r="5" fill="#ff8000"/>
    <rect id="win" class="insert" x="200" y="200" width="40" height="20" fill="#ff0000"/>"##;

#[test]
fn the_hash_sees_what_a_game_depends_on_and_no_paint() {
    let original = read(LAMPS, "").unwrap().hash;
    let repainted = LAMPS.replace("#ff8000", "#0080ff") + r#"<rect width="9" height="9" fill="blue"/>"#;
    assert_eq!(read(&repainted, "[class.lamp]\npower = 9\nreach_mm = 99").unwrap().hash, original);
    assert_eq!(read(LAMPS, "ambient = \"#ffffff\"\nname = \"x\"").unwrap().hash, original);
    assert_eq!(read(LAMPS, "[finish.a]\n[class.flipper]\nfinish = \"a\"").unwrap().hash, original);
    // Where the new element stands in the drawing must not matter to the names of those after it.
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
