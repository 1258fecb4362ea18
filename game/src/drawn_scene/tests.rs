use super::DrawnScene;
use tracer::transport::spectrum::{Emission, Gas};
use tracer::transport::{Falloff, Material, SourceForm};

const PAGE: &str = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 400 300\">";

fn read(shapes: &str) -> Result<DrawnScene, Vec<String>> {
    let text = format!("{PAGE}\n{shapes}\n</svg>");
    let failures = |failures: Vec<crate::Failure>| failures.iter().map(ToString::to_string).collect();
    DrawnScene::read("a.svg", text.into_bytes()).map_err(failures)
}

fn mistakes(shapes: &str) -> Vec<String> {
    read(shapes).expect_err("it has a mistake")
}

const LAMP: &str = "<circle class=\"lamp\" cx=\"9\" cy=\"9\" r=\"2\" fill=\"#fff\"/>";

#[test]
fn lamps_have_the_forms_and_spectra_that_are_drawn() {
    let scene = read(
        "<circle class=\"lamp\" cx=\"50\" cy=\"60\" r=\"4\" fill=\"#ff0000\" data-power=\"3\"/>
         <circle class=\"lamp\" cx=\"50\" cy=\"60\" r=\"4\" data-spectrum=\"neon\" data-beam-deg=\"360\"/>
         <circle class=\"lamp\" cx=\"50\" cy=\"60\" r=\"4\" data-spectrum=\"5600K\" data-beam-deg=\"90\" data-towards-deg=\"90\"/>
         <line class=\"lamp\" x1=\"10\" y1=\"20\" x2=\"30\" y2=\"20\" stroke=\"#fff\" data-falloff=\"table\" data-reach-mm=\"99\"/>
         <line class=\"lamp\" x1=\"10\" y1=\"50\" x2=\"10\" y2=\"20\" data-spectrum=\"532nm\" data-beam-deg=\"0\"/>",
    );
    let sources = scene.expect("it is sound").scene.sources;
    let emissions: Vec<Emission> = sources.iter().map(|source| source.emission.clone()).collect();
    let red = Emission::Color([1.0, 0.0, 0.0]);
    let white = Emission::Color([1.0; 3]);
    assert_eq!(
        emissions,
        [red, Emission::Gas(Gas::Neon), Emission::Blackbody { kelvin: 5600.0 }, white, Emission::Line(532.0)]
    );
    assert!(matches!(sources[0].form, SourceForm::Disc { radius: 4.0, .. }) && sources[0].power == 3.0);
    assert!(matches!(sources[1].form, SourceForm::Point(at) if at.x == 50.0));
    // On the page 90 degrees is down.
    assert!(matches!(sources[2].form, SourceForm::Cone { axis, .. } if (axis.y - 1.0).abs() < 1e-12));
    assert_eq!(sources[3].falloff, Falloff::Table { height_mm: 30.0, reach_mm: 99.0 });
    // Upwards, so its left is towards smaller x.
    let ray = sources[4].form.emit([0.5, 0.5]);
    assert!((ray.direction.x + 1.0).abs() < 1e-12, "{ray:?}");
}

#[test]
fn bodies_are_made_of_what_their_class_and_colour_say() {
    let scene = read(&format!(
        "{LAMP}
         <rect class=\"wall\" x=\"100\" y=\"100\" width=\"20\" height=\"20\" fill=\"#000\"/>
         <rect class=\"post\" x=\"140\" y=\"100\" width=\"20\" height=\"20\" fill=\"#fff\"/>
         <line class=\"mirror\" x1=\"0\" y1=\"200\" x2=\"50\" y2=\"200\" data-metal=\"gold\" data-band-nm=\"500 600\"/>
         <line class=\"mirror\" x1=\"0\" y1=\"200\" x2=\"50\" y2=\"200\" data-transmittance=\"0.25\"/>
         <line class=\"lens\" x1=\"0\" y1=\"200\" x2=\"50\" y2=\"200\" data-focal-mm=\"-40\"/>
         <circle class=\"glass\" cx=\"200\" cy=\"200\" r=\"20\"/>
         <ellipse class=\"lens\" cx=\"300\" cy=\"200\" rx=\"10\" ry=\"30\" data-index=\"1.6\" data-abbe=\"40\"/>"
    ));
    let bodies = scene.expect("it is sound").scene.bodies;
    let [black, white, gold, splitter, lens, glass, ellipse] = &bodies[..] else { panic!("{}", bodies.len()) };
    assert_eq!(black.material, Material::Absorber);
    assert_eq!(white.material, Material::Diffuse { reflectance: [1.0; 3] });
    assert!(matches!(gold.material, Material::Metal { .. }) && gold.band.is_some_and(|band| band.holds(550.0)));
    assert!(gold.band.is_some_and(|band| !band.holds(650.0)));
    assert_eq!(splitter.material, Material::BeamSplitter { transmittance: 0.25 });
    assert_eq!(lens.material, Material::IdealLens { focal_length: -40.0 });
    let index = |body: &tracer::transport::Body, nm: f64| match body.material {
        Material::Dielectric(glass) => glass.dispersion.index(nm),
        _ => panic!("no glass"),
    };
    assert!((index(glass, 587.562) - 1.5168).abs() < 1e-5, "BK7 where nothing is said");
    // V = (n_d - 1) / (n_F - n_C).
    let abbe = (index(ellipse, 587.562) - 1.0) / (index(ellipse, 486.134) - index(ellipse, 656.281));
    assert!((index(ellipse, 587.562) - 1.6).abs() < 1e-9 && (abbe - 40.0).abs() < 1e-3, "{abbe}");
    assert!(ellipse.edges.iter().all(|edge| !edge.inward), "its normals point outward");
}

/// Each mistake is one sentence with the line, and says what to do.
#[test]
fn bad_materials_and_lamps_are_named_with_file_and_line() {
    let told = |shape: &str, expected: &str| {
        let all = mistakes(&format!("{LAMP}\n{shape}"));
        assert_eq!(all.len(), 1, "{shape}: {all:?}");
        assert!(all[0].starts_with("a.svg:3: ") && all[0].contains(expected), "{shape}: {}", all[0]);
    };
    let circle = "class=\"glass\" cx=\"100\" cy=\"100\" r=\"20\"";
    told(&format!("<circle {circle} data-index=\"0.9\"/>"), "its `data-index` is `0.9`; write a number from 1 to 5");
    told(&format!("<circle {circle} data-glass=\"BK8\"/>"), "there is no glass `BK8`; known are N-BK7");
    told("<path class=\"glass\" d=\"M 10,10 L 50,10 L 30,60\"/>", "its outline is open");
    told("<line class=\"lens\" x1=\"0\" y1=\"0\" x2=\"9\" y2=\"0\"/>", "needs `data-focal-mm`");
    told("<line class=\"mirror\" x2=\"9\" y2=\"0\" x1=\"0\" y1=\"1\" data-metal=\"tin\"/>", "there is no metal `tin`");
    told("<circle class=\"lamp\" cx=\"50\" cy=\"50\" r=\"3\" data-spectrum=\"argon\"/>", "write `equal-energy`");
    told("<circle class=\"lamp\" cx=\"50\" cy=\"50\" r=\"3\" fill=\"#000\"/>", "it is black");
    told("<circle class=\"glas\" cx=\"50\" cy=\"50\" r=\"3\"/>", "did you mean `glass`?");
    told("<circle class=\"glass lamp\" cx=\"50\" cy=\"50\" r=\"3\"/>", "it is both glass and lamp");
    // A lamp in glass that lets nothing through.
    let dark = "<circle class=\"glass\" cx=\"100\" cy=\"100\" r=\"20\" fill=\"#000\" data-tint-mm=\"1\"/>\n";
    let inside = mistakes(&format!("{dark}<circle class=\"lamp\" cx=\"100\" cy=\"100\" r=\"2\" fill=\"#fff\"/>"));
    assert!(inside[0].starts_with("a.svg:3: ") && inside[0].contains("absorbs all of its light"), "{inside:?}");
    assert!(mistakes("<circle class=\"wall\" cx=\"9\" cy=\"9\" r=\"2\"/>")[0].contains("there is no lamp"));
}

/// A misspelt attribute says nothing: that is told, and the picture is made all the same.
#[test]
fn attributes_that_say_nothing_are_warned_of() {
    let scene = read(&format!("{LAMP}\n<circle class=\"glass\" cx=\"99\" cy=\"99\" r=\"20\" data-indx=\"1.6\"/>"));
    let warnings = scene.expect("it is sound").warnings;
    assert_eq!(warnings.len(), 1);
    let told = warnings[0].to_string();
    assert!(told.starts_with("warning: a.svg:3: glass: a glass has no `data-indx`"), "{told}");
}

/// What the drawing says as a whole is read, and told in its line where it cannot be.
/// Roughness of an ideal mirror was read and passed over, and glass on a group was no glass at all.
#[test]
fn what_would_be_passed_over_is_a_mistake() {
    let mirror = |more: &str| {
        mistakes(&format!(
            "{LAMP}\n<line class=\"mirror\" x1=\"9\" y1=\"9\" x2=\"9\" y2=\"60\" stroke=\"#fff\" {more}/>"
        ))
    };
    let told = mirror("id=\"m\" data-focal-mm=\"50\" data-roughness=\"0.3\"");
    assert_eq!(told, ["a.svg:3: m: a mirror with `data-focal-mm` is smooth; leave `data-roughness` away"]);
    assert!(mirror("data-transmittance=\"0.5\" data-roughness=\"0.3\"")[0].contains("`data-transmittance` is smooth"));
    let group = mistakes(&format!("{LAMP}\n<g class=\"glass\"><circle cx=\"99\" cy=\"99\" r=\"20\"/></g>"));
    assert_eq!(group, ["a.svg:3: a group is no thing: give the class to each shape in it instead"]);
}

/// "A lens has no `data-glass`" and "a lens has no `data-focal-mm`" were told of two lenses.
#[test]
fn a_lens_of_glass_and_one_that_is_a_line_have_names_of_their_own() {
    let line = read(&format!(
        "{LAMP}<line class=\"lens\" data-focal-mm=\"50\" data-glass=\"F2\" x1=\"99\" y1=\"9\" x2=\"99\" y2=\"60\"/>"
    ));
    let told = line.expect("it is sound").warnings[0].to_string();
    assert!(told.contains("a lens that is a line has no `data-glass`"), "{told}");
    let glass = read(&format!("{LAMP}<circle class=\"lens\" data-focal-mm=\"50\" cx=\"99\" cy=\"99\" r=\"20\"/>"));
    let told = glass.expect("it is sound").warnings[0].to_string();
    assert!(told.contains("a lens of glass has no `data-focal-mm`"), "{told}");
}

#[test]
fn ambient_light_and_exposure_are_the_drawings() {
    let of = |attributes: &str| {
        let text =
            format!("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 400 300\" {attributes}>{LAMP}</svg>");
        DrawnScene::read("a.svg", text.into_bytes())
    };
    let scene = of("data-ambient=\"0.3\" data-exposure=\"-2\"").expect("it is sound");
    assert_eq!((scene.ambient, scene.stops), (0.3, -2.0));
    let told = of("data-ambient=\"bright\"").expect_err("it is no number")[0].to_string();
    assert_eq!(told, "a.svg:1: its `data-ambient` is `bright`; write a number from 0 to 1");
}

/// A clone of glass is glass, where it is put.
#[test]
fn clones_of_glass_bend_light_too() {
    let scene = read(&format!(
        "{LAMP}
         <defs><circle id=\"bead\" class=\"glass\" cx=\"0\" cy=\"0\" r=\"5\"/></defs>
         <use href=\"#bead\" x=\"100\" y=\"50\"/><use href=\"#bead\" transform=\"translate(200 50) scale(2)\"/>"
    ));
    let bodies = scene.expect("it is sound").scene.bodies;
    let bounds: Vec<f64> = bodies.iter().map(|body| body.edges[0].curve.bounds().max.x).collect();
    assert_eq!(bounds, [105.0, 210.0]);
}
