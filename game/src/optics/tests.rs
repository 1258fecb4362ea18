//! Scenes with answers that a formula gives, and scenes that are none.

use super::*;

fn scene(objects: &str) -> OpticsScene {
    let text = format!("{{\"rayModeDensity\": 10, \"objs\": [{objects}]}}");
    OpticsScene::parse("scene.json", &text).unwrap_or_else(|failures| panic!("{failures:?}"))
}

fn refused(text: &str) -> Vec<String> {
    OpticsScene::parse("scene.json", text).unwrap_err().iter().map(ToString::to_string).collect()
}

fn line(kind: &str, [x1, y1, x2, y2]: [f64; 4], more: &str) -> String {
    format!(r#"{{"type": "{kind}", "p1": {{"x": {x1}, "y": {y1}}}, "p2": {{"x": {x2}, "y": {y2}}}{more}}}"#)
}

fn measured(objects: &[String]) -> (Measurement, OpticsScene) {
    let scene = scene(&objects.join(","));
    (Measurement::of(&scene), scene)
}

/// A detector upwards at this x, from 200 to 0, in bins of 10: rays to the right count as power of one sign.
fn detector(x: f64) -> String {
    line("Detector", [x, 0.0, x, 200.0], r#", "irradMap": true, "binSize": 10"#)
}

#[test]
fn a_ray_is_counted_in_its_bin_with_its_force() {
    let ray = line("SingleRay", [0.0, 42.0, 30.0, 82.0], r#", "brightness": 0.5"#);
    let (measurement, scene) = measured(&[ray, detector(60.0)]);
    let measured = &measurement.measured[0];
    // Direction (0.6, 0.8); it crosses at y = 122.
    assert!((measured.power - 0.5).abs() < 1e-12);
    assert!((measured.normal_force - 0.3).abs() < 1e-12 && (measured.shear_force + 0.4).abs() < 1e-12);
    let map = scene.detectors[0].irradiance(measured);
    assert_eq!(map.len(), 20);
    assert!(map.iter().all(|(position, irradiance)| *irradiance == if *position == 120.0 { 0.05 } else { 0.0 }));
}

/// All orders of reflection in a slab at right angles: T = (1 - R) / (1 + R) with R = 0.04, either way round its outline.
#[test]
fn a_slab_passes_what_fresnel_says() {
    for corners in [[(20, 0), (40, 0), (40, 99), (20, 99)], [(20, 99), (40, 99), (40, 0), (20, 0)]] {
        let path: Vec<String> = corners.map(|(x, y)| format!(r#"{{"x": {x}, "y": {y}, "arc": false}}"#)).to_vec();
        let glass = format!(r#"{{"type": "Glass", "path": [{}], "refIndex": 1.5}}"#, path.join(","));
        let ray = line("SingleRay", [0.0, 42.0, 30.0, 42.0], "");
        let (measurement, _) = measured(&[ray, glass, detector(60.0)]);
        assert!((measurement.measured[0].power - 0.923_077).abs() < 1e-6, "{}", measurement.measured[0].power);
        assert!(measurement.given_up.weak < 1e-6 && measurement.given_up.long == 0.0);
    }
}

/// Parallel light of a beam comes to the focus of a lens without aberration: all of its power in one bin there.
#[test]
fn a_beam_meets_in_the_focus_of_a_lens() {
    let beam = line("Beam", [0.0, 75.0, 0.0, 135.0], r#", "brightness": 0.1"#);
    let lens = line("IdealLens", [10.0, 55.0, 10.0, 155.0], r#", "focalLength": 80"#);
    let (measurement, _) = measured(&[beam, lens, detector(90.0)]);
    let measured = &measurement.measured[0];
    assert!(measurement.sent > 0.0 && (measured.power.abs() - measurement.sent).abs() < 1e-9, "{measured:?}");
    assert_eq!(measured.bins.iter().filter(|power| **power != 0.0).count(), 1, "{measured:?}");
}

#[test]
fn what_is_not_read_is_named() {
    let broken = "this is not JSON, of which ray-optics scenes are made: EOF while parsing an object";
    assert_eq!(refused("{"), [format!("scene.json:1:1: {broken}")]);
    assert_eq!(refused("{\n"), [format!("scene.json:2:1: {broken}")]);
    let modes = "it may be rays, extended, images, observer";
    assert_eq!(refused(r#"{"mode": "ray", "objs": []}"#), [format!("scene.json: \"mode\" is \"ray\"; {modes}")]);
    assert_eq!(
        scene(&detector(60.0)).check_lit("a.json").unwrap_err().to_string(),
        "a.json: there is no source of light in this scene; add a PointSource, a Beam or a SingleRay"
    );
    assert_eq!(refused("{}"), ["scene.json: \"objs\" must be a list of the scene's objects"]);
    let unknown = refused(r#"{"objs": [{"type": "CurvedMirror"}, {"type": "Mirror", "p1": {"x": 1, "y": 1}}]}"#);
    let expected = [
        "scene.json: object 0 (CurvedMirror): objects of this type are not read",
        "scene.json: object 1 (Mirror): \"p2\" is missing: a point {\"x\": .., \"y\": ..}",
    ];
    assert_eq!(unknown, expected);
    let bow = r#"[{"x":0,"y":0},{"x":9,"y":9},{"x":9,"y":0},{"x":0,"y":8}]"#;
    let crossing = refused(&format!(r#"{{"objs": [{{"type": "Glass", "path": {bow}}}]}}"#));
    assert_eq!(crossing, ["scene.json: object 0 (Glass): the outline \"path\" crosses itself"]);
    let odd = scene(&line("Mirror", [0.0, 0.0, 1.0, 1.0], r#", "colour": 3"#));
    assert_eq!(odd.warnings, ["scene.json: object 0 (Mirror): \"colour\" is not read"]);
}

/// A scene of 10^9 rays, or of a source without brightness, is a sentence and no hang.
#[test]
fn too_many_rays_are_refused() {
    let dense = r#"{"rayModeDensity": 1e8, "objs": [{"type": "PointSource", "x": 0, "y": 0}]}"#;
    assert!(refused(dense)[0].contains("all sources together have 2000000 at most"), "{:?}", refused(dense));
    let dark = r#"{"objs": [{"type": "PointSource", "x": 0, "y": 0, "brightness": 0}]}"#;
    assert!(refused(dark)[0].contains("\"brightness\" must be over 0"));
}

/// Each detector kept within its million bins, and 150 of them took over a gigabyte and no end. So it is with all that is
/// limited for one object and not for their sum.
#[test]
fn what_all_objects_together_are_is_limited() {
    let of = |objects: &[String]| refused(&format!("{{\"objs\": [{}]}}", objects.join(",")));
    let fine = line("Detector", [0.0, 0.0, 0.0, 100.0], r#", "irradMap": true, "binSize": 0.0002"#);
    let expected = "scene.json: the irradiance maps of all detectors have 1500000 bins; at most 1000000 are measured: give \
                    a larger \"binSize\"";
    assert_eq!(of(&vec![fine; 3]), [expected]);
    let plain = line("Detector", [0.0, 0.0, 0.0, 100.0], "");
    assert_eq!(of(&vec![plain.clone(); 1001]), ["scene.json: there are 1001 detectors; at most 1000 are read"]);
    let dense = r#"{"rayModeDensity": 1000, "objs": [{"type": "PointSource", "x": 0, "y": 0}, "#;
    let pairs = refused(&format!("{dense}{}]}}", vec![plain; 500].join(",")));
    assert!(pairs[0].contains("500 detectors are 250000000 pairs to measure; at most 200000000 are"), "{pairs:?}");
    let corners = (0..300).map(|x| format!(r#"{{"x": {x}, "y": {}}}"#, x % 2)).collect::<Vec<_>>().join(",");
    let jagged = format!(r#"{{"type": "Glass", "path": [{corners}]}}"#);
    let jagged = of(&vec![jagged; 70]);
    assert!(jagged.last().is_some_and(|last| last.contains("more than 20000 corners")), "{jagged:?}");
}

/// A file of an editor that begins with a mark of its encoding was no JSON.
#[test]
fn a_byte_order_mark_is_passed_over() {
    let text = format!("\u{feff}{{\"objs\": [{}]}}", detector(60.0));
    assert_eq!(OpticsScene::parse("scene.json", &text).map(|scene| scene.detectors.len()).ok(), Some(1));
}
