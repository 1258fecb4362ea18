//! Rules that are wrong only in play, as their maker meets them on the command line.

use std::fs;
use std::path::PathBuf;
use std::process::{Command, Output};

/// A box with a plunger, a drain and two flippers.
const DRAWING: &str = r##"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 514 1067">
<path class="wall" d="M8 1060 V8 H506 V1060" stroke-width="8" fill="none"/>
<path class="wall" d="M462 1060 V200" stroke-width="8" fill="none"/>
<path class="wall" d="M462 1020 H506" stroke-width="8"/>
<line class="flipper" id="lf" x1="145.5" y1="900" x2="205" y2="933" stroke-width="18" data-side="left" data-up-deg="51"/>
<line class="flipper" id="rf" x1="324.5" y1="900" x2="265" y2="933" stroke-width="18" data-side="right" data-up-deg="51"/>
<line class="plunger" id="plunger" x1="484" y1="960" x2="484" y2="1006" stroke-width="30"/>
<rect class="drain" id="drain" x="12" y="1016" width="440" height="45"/>
<circle class="lamp" id="L" cx="250" cy="400" r="5" fill="#ffddaa"/>
</svg>"##;

/// The beginning of every script here: a game starts, a lost ball ends it.
const GAME: &str = r#"fn on_button(n) { if n == "start" && !playing() { start_game(3); flippers(true); kickers(true); add_ball(); } }
fn on_switch(n) { if n == "drain" && balls_in_play() == 0 { if !next_player() { game_over(); } else { add_ball(); } } }
"#;

/// A table's folder, gone when the test ends.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str, rules: &str) -> Folder {
        let path = std::env::temp_dir().join(format!("caustic-rules-{}-{name}", std::process::id()));
        fs::create_dir_all(&path).expect("a folder");
        for (file, text) in [("table.svg", DRAWING), ("table.toml", "name = \"x\""), ("rules.rhai", rules)] {
            fs::write(path.join(file), text).expect(file);
        }
        Folder(path)
    }

    /// What the program says: its exit code and standard output, and its complaint.
    fn run(&self, words: &[&str]) -> (Option<i32>, String, String) {
        let mut command = Command::new(env!("CARGO_BIN_EXE_caustic"));
        let Output { status, stdout, stderr } = command.args(words).arg(&self.0).output().expect("the program runs");
        let text = |bytes: Vec<u8>| String::from_utf8_lossy(&bytes).into_owned();
        (status.code(), text(stdout), text(stderr))
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

const SIMULATE: [&str; 6] = ["simulate", "--games", "1", "--minutes", "0.1", "--table"];

/// Both said nothing and ended with 0, because the script only went wrong when a ball was fed and shot.
#[test]
fn rules_that_do_not_end_in_play_end_check_and_simulate_with_1() {
    let rules = format!("{GAME}fn on_feed() {{ loop {{}} }}\nfn on_launch() {{ while true {{ let x = 1; }} }}\n");
    let folder = Folder::new("loop", &rules);
    let (code, said, complained) = folder.run(&["check"]);
    assert_eq!((code, said.as_str()), (Some(1), ""));
    for line in [3, 4] {
        assert!(complained.contains(&format!("rules.rhai:{line}: this does not come to an end (")), "{complained}");
    }
    let (code, said, complained) = folder.run(&SIMULATE);
    assert_eq!(code, Some(1), "{complained}");
    assert!(said.contains("rules.rhai:3: this does not come to an end ("), "{said}");
    assert!(complained.contains("went wrong; --save-failures DIR keeps"), "{complained}");
}

/// The sort of Rust's library panics when comparisons contradict each other, and the panic was printed.
#[test]
fn a_sort_by_chance_prints_no_panic() {
    let sort = "let a = []; for i in 0..200 { a.push(random(100)); } a.sort(|x, y| random(3) - 1); score(1);";
    let folder = Folder::new("sort", &format!("{GAME}fn on_launch() {{ {sort} }}\n"));
    for words in [&["check"][..], &SIMULATE] {
        let (code, _, complained) = folder.run(words);
        assert_eq!((code, complained.as_str()), (Some(0), ""), "{words:?}");
    }
}
