//! Whatever a file holds, reading it ends with a table or with sentences.

use super::{SVG, read_files};
use proptest::prelude::*;

const DRAWN: &str = r##"<g transform="translate(3 4) rotate(5)" data-group="g">
<path id="w" class="wall" d="M10 100 V50 A30 30 0 0 1 70 50 q9 9 20 0 t10 10 c1 2 3 4 5 6 s1 1 2 2 z" stroke-width="6"/></g>
<circle id="pop" class="bumper" cx="100" cy="100" r="25"/><circle id="bulb" class="lamp" cx="99" cy="99" r="5" fill="#ff8000" data-inside="pop"/>
<path id="arrow" class="insert" style="fill:#00ff00" d="M200 200 h20 v20 h-20 z"/>
<g class="plastics"><circle class="plastic" cx="100" cy="100" r="20" fill="url(#a)"/><text>A &amp; B</text></g>
<style>@media screen { .wall, #pop:not(.a) > b { Stroke: red /* x */ !important } } * { fill: hwb(30 0% 0%) icc-color(a, 1) }</style>
<defs><symbol id="s" viewBox="0 0 9 9"><circle class="post" cx="3" cy="3" r="2" style="font-family:'a;b'"/></symbol></defs>
<use id="u" href="#s" x="300" y="300" width="50" height="50"/><use id="v" href="#pop" transform="translate(0 200)"/>
<svg x="9" y="300" width="50" height="50" viewBox="0 0 9 9" opacity="0.5"><line class="wall" x2="5" y1="3"/></svg>"##;
const NUMBERS: &str = "name = \"Small\"\nslope_deg = 6.5\n[material.gum]\nrestitution = 0.5\nfriction = 0.1\n\
    [finish.gold]\nalbedo = \"#b08d57\"\nprofile = \"bevel 0.8\"\n[class.wall]\nmaterial = \"gum\"\nfinish = \"gold\"\n\
    [part.pop]\nkick_m_s = 1\n";

/// `text` with some bytes replaced, taken out or repeated; what is no UTF-8 any more is replaced.
fn damaged(text: &str, damages: &[(usize, u8, u8)]) -> String {
    let mut bytes = text.as_bytes().to_vec();
    for &(place, how, byte) in damages {
        let at = place % bytes.len();
        match how % 4 {
            0 => bytes[at] = byte,
            1 => drop(bytes.remove(at)),
            2 => bytes.insert(at, byte),
            _ => {
                let end = (at + usize::from(byte)).min(bytes.len());
                let piece = bytes[at..end].to_vec();
                bytes.splice(at..at, piece);
            }
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 600, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn damaged_files_never_stop_the_game(
        svg in prop::collection::vec((any::<usize>(), any::<u8>(), any::<u8>()), 0..4),
        toml in prop::collection::vec((any::<usize>(), any::<u8>(), any::<u8>()), 0..3),
    ) {
        let drawing = SVG.replace("{}", DRAWN);
        if let Err(diagnostics) = read_files(&damaged(&drawing, &svg), &damaged(NUMBERS, &toml), "") {
            prop_assert!(!diagnostics.is_empty());
            prop_assert!(diagnostics.iter().all(|diagnostic| !diagnostic.contains("table.") || diagnostic.contains(": ")));
        }
    }

    #[test]
    fn noise_never_stops_the_game(path in "[MLHVCSQTAZmlhvcsqtaz0-9 .,e-]{0,60}", transform in "[a-z0-9() ,.-]{0,30}") {
        let drawn = format!(r#"<path id="w" class="wall" d="{path}" transform="{transform}" fill="red"/>"#);
        let _ = read_files(&SVG.replace("{}", &drawn), "", "");
    }
}

#[test]
fn the_undamaged_files_are_good() {
    read_files(&SVG.replace("{}", DRAWN), NUMBERS, "").unwrap();
}
