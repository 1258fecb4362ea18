//! `caustic render`: drawings as pictures of their light.

#![expect(clippy::disallowed_methods, reason = "the test reads what it has written")]

use super::command_line::{Folder, caustic, complaint};
use std::fs;

const PRISM: &str = "assets/scenes/prism.svg";

fn render(words: &[&str]) -> std::process::Output {
    caustic(&[&["render"], words].concat())
}

fn scene(name: &str) -> String {
    format!("{}/../{name}", env!("CARGO_MANIFEST_DIR"))
}

/// A picture's file as text: what it says of itself is in plain letters.
fn texts(file: &[u8]) -> String {
    String::from_utf8_lossy(file).into_owned()
}

#[test]
fn a_prism_parts_white_light_in_each_format_and_the_files_say_how() {
    let folder = Folder::new("render");
    for (name, magic) in [("p.png", &b"\x89PNG"[..]), ("p.tif", b"II*\0"), ("p.exr", b"\x76\x2f\x31\x01")] {
        let out = folder.path(name);
        let done = render(&[&scene(PRISM), "--size", "128x72", "--samples", "64", "--out", &out]);
        assert_eq!(done.status.code(), Some(0), "{}", complaint(&done));
        let bytes = fs::read(&out).expect("a picture");
        assert!(bytes.starts_with(magic), "{name}");
        let told = texts(&bytes);
        for expected in ["Integrator", "beams", "Samples", "64", "Seed", "prism.svg"] {
            assert!(told.contains(expected), "{name} lacks {expected}");
        }
    }
    let png = fs::File::open(folder.path("p.png")).expect("a picture");
    let mut reader = png::Decoder::new(std::io::BufReader::new(png)).read_info().expect("a PNG");
    let mut pixels = vec![0; reader.output_buffer_size().expect("a size")];
    reader.next_frame(&mut pixels).expect("pixels");
    // Behind the prism the spectrum lies from red, above, to blue.
    let column = (0..72).map(|y| &pixels[(y * 128 + 116) * 3..][..3]);
    let brightest = |channel: usize| {
        let others = |pixel: &[u8]| i32::from(pixel[channel]) - i32::from(pixel[(channel + 2) % 3]);
        column.clone().enumerate().max_by_key(|(_, pixel)| others(pixel)).map_or(0, |(y, _)| y)
    };
    assert!(brightest(0) < brightest(2), "red {} blue {}", brightest(0), brightest(2));
}

#[test]
fn threads_and_stops_do_not_change_a_byte() {
    let folder = Folder::new("render-threads");
    for integrator in ["photons", "path", "beams"] {
        let pictures = ["1", "3"].map(|threads| {
            let out = folder.path(&format!("{integrator}-{threads}.exr"));
            let words = ["--integrator", integrator, "--samples", "16", "--size", "64x64", "--threads", threads];
            let done = render(&[&words[..], &[&scene(PRISM), "--out", &out]].concat());
            assert_eq!(done.status.code(), Some(0), "{}", complaint(&done));
            fs::read(out).expect("a picture")
        });
        assert!(pictures[0] == pictures[1], "{integrator}: other bytes");
    }
}

#[test]
fn what_cannot_be_rendered_is_one_sentence() {
    let folder = Folder::new("render-bad");
    let bad = folder.path("bad.svg");
    fs::write(&bad, "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 90 90\"><circle class=\"glass\" r=\"9\" data-glass=\"x\"/></svg>")
        .expect("a file");
    let json = folder.path("a.json");
    fs::write(&json, "{\"objs\": []}").expect("a file");
    let prism = scene(PRISM);
    for (words, code, expected) in [
        (vec!["nosuch.svg"], 1, "nosuch.svg"),
        (vec![&bad], 1, "bad.svg:1: glass: there is no glass `x`"),
        (vec![&json], 1, "a.json: there is no source of light in this scene; add"),
        (vec![&json, "--samples", "3"], 2, "has a list of rays of its own"),
        (vec![&prism, "--integrator", "exact", "--samples", "4"], 2, "exact light takes none"),
        (vec![&prism, "--integrator", "exact", "--size", "128x72"], 1, "data-falloff=\"table\""),
        (vec![&prism, "--out", "a.jpg"], 2, "nobody knows its format"),
        (vec![&prism, "--white", "10"], 2, "1000 to 40000"),
        (vec![&prism, "--seconds", "0"], 2, "above 0"),
    ] as [(Vec<&str>, i32, &str); 9]
    {
        let done = render(&words);
        let told = complaint(&done);
        assert_eq!(done.status.code(), Some(code), "{words:?}: {told}");
        assert!(told.contains(expected) && !told.contains("panicked"), "{words:?}: {told}");
    }
    assert_eq!(folder.names(), ["a.json", "bad.svg"], "nothing half drawn is written");
}

/// A place where nothing can be written was found when the picture was done.
#[test]
fn a_place_that_cannot_be_is_refused_before_anything_is_made() {
    let folder = Folder::new("render-place");
    let file = folder.path("file");
    fs::write(&file, "text").expect("a file");
    let inside = format!("{file}/x.png");
    let done = caustic(&["frame", "--out", &inside]);
    assert_eq!(done.status.code(), Some(1), "{}", complaint(&done));
    assert!(complaint(&done).contains("a part of this path is a file"), "{}", complaint(&done));
    let done = render(&[&scene(PRISM), "--out", &inside, "--integrator", "photons", "--samples", "100000"]);
    assert_eq!(done.status.code(), Some(1), "{}", complaint(&done));
    for words in [&["plot", "flipper", "--out", "-"][..], &["simulate", "--games", "1", "--save-all", "-"]] {
        let done = caustic(words);
        assert_eq!(done.status.code(), Some(2), "{}", complaint(&done));
        assert!(complaint(&done).contains("name one"), "{}", complaint(&done));
    }
}

/// Two scenes of one name from two folders overwrote each other's picture, and the same line was printed twice.
#[test]
fn no_two_scenes_are_rendered_to_one_file() {
    let folder = Folder::new("render-same-name");
    let (a, b, pictures) = (folder.path("a/x.svg"), folder.path("b/x.json"), folder.path("pics"));
    let file = folder.path("o.png");
    fs::write(&file, "mine").expect("a file");
    let twice = "would both be rendered to";
    for (words, expected) in [
        (vec![&a[..], &b, "--out", &pictures], twice),
        (vec![&a, &b], twice),
        (vec![&a, &a], twice),
        (vec![&a, &a, "--out", &file], "o.png is a file, and several scenes are rendered into a folder: name one"),
    ] {
        let done = render(&words);
        let told = complaint(&done);
        assert_eq!(done.status.code(), Some(2), "{words:?}: {told}");
        assert!(told.contains(expected) && told.lines().count() == 1, "{words:?}: {told}");
    }
    assert_eq!(folder.names(), ["o.png"], "nothing was rendered");
}

/// A round mirror that keeps all of its light had beams without end, and neither time nor signals ended them.
#[test]
fn a_scene_of_endless_reflections_ends_in_time() {
    let folder = Folder::new("render-mirrors");
    let (drawing, out) = (folder.path("ring.svg"), folder.path("ring.png"));
    let ring = "<circle class=\"mirror\" cx=\"100\" cy=\"100\" r=\"90\" fill=\"none\" stroke=\"#fff\"/>\
                <circle class=\"lamp\" cx=\"100\" cy=\"180\" r=\"2\" fill=\"#fff\"/>";
    let svg = format!("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 200 200\">{ring}</svg>");
    fs::write(&drawing, svg).expect("a file");
    let words = [&drawing, "--out", &out, "--size", "64x64"];
    let beams = ["--integrator", "beams", "--samples", "65536", "--seconds", "1"];
    let done = render(&[&words[..], &beams].concat());
    assert_eq!(done.status.code(), Some(1), "{}", complaint(&done));
    assert!(complaint(&done).contains("stopped before its first pass was whole"), "{}", complaint(&done));
    let photons = ["--integrator", "photons", "--samples", "4", "--depth", "50"];
    let done = render(&[&words[..], &photons].concat());
    let told = String::from_utf8_lossy(&done.stdout).into_owned();
    assert_eq!(done.status.code(), Some(0), "{}", complaint(&done));
    assert!(told.contains("100.0000 % of the light given up after too many surfaces"), "{told}");
}
