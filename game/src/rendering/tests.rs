use super::{Integrator, Passes, Settings, Stopped, develop};
use crate::drawn_scene::DrawnScene;
use tracer::View;
use tracer::transport::{Scene, luminance};

const SETTINGS: Settings = Settings {
    integrator: Integrator::Photons,
    samples: 4,
    seed: 0,
    depth: None,
    most_pieces: None,
    is_preview: false,
    white_kelvin: None,
};

fn scene(attributes: &str, shapes: &str) -> DrawnScene {
    let text = format!("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 200 200\" {attributes}>{shapes}</svg>");
    DrawnScene::read("a.svg", text.into_bytes()).expect("it is sound")
}

fn fluence(scene: &Scene, view: View, settings: &Settings) -> Vec<[f64; 3]> {
    let mut passes = Passes::new(scene, view, settings);
    assert_eq!(passes.run(|_, _| true, &|| false), Ok(Stopped::Done));
    passes.fluence()
}

fn view(side: usize) -> View {
    View::fit(side, side, geometry::DVec2::splat(200.0))
}

/// Light that fades as on a table is the game's, whoever finds it: the exact integrator and the photons agree in the open. A
/// pixel of the exact one is the light of its middle, of the others the mean of its area.
#[test]
fn photons_find_the_direct_light_of_the_game() {
    let shapes = "<circle class=\"lamp\" cx=\"40\" cy=\"40\" r=\"1\" fill=\"#fa8\" data-beam-deg=\"360\"/>
                  <rect class=\"wall\" x=\"90\" y=\"90\" width=\"30\" height=\"30\" fill=\"#000\"/>";
    let drawn = scene("data-falloff=\"table\"", shapes);
    let view = view(80);
    let exact = fluence(&drawn.scene, view, &Settings { integrator: Integrator::Exact, ..SETTINGS });
    let photons = fluence(&drawn.scene, view, &Settings { samples: 500, ..SETTINGS });
    let beams = fluence(&drawn.scene, view, &Settings { integrator: Integrator::Beams, samples: 512, ..SETTINGS });
    let mut compared = 0;
    for y in 0..80 {
        for x in 0..80 {
            let place = view.table_from_pixel(x, y);
            let of = |light: &[[f64; 3]]| luminance(light[y * 80 + x]);
            let (one, other, third) = (of(&exact), of(&photons), of(&beams));
            // Not in half shadow, where one point of the pixel is another light than its mean.
            let beyond = place.x > 75.0 && place.y > 75.0;
            if place.distance(geometry::DVec2::splat(40.0)) > 25.0 && !beyond {
                assert!((other / one - 1.0).abs() < 0.03, "{place}: {one} {other}");
                assert!((third / one - 1.0).abs() < 0.02, "{place}: {one} {third}");
                compared += 1;
            }
        }
    }
    assert!(compared > 2500, "{compared}");
}

/// Glass of index 1 is not there: the same bits as without it, by every integrator that bends light.
#[test]
fn glass_of_index_one_vanishes() {
    let lamp = "<circle class=\"lamp\" cx=\"40\" cy=\"40\" r=\"4\" fill=\"#fff\"/>";
    let glass = "<circle class=\"glass\" cx=\"120\" cy=\"110\" r=\"30\" data-index=\"1\"/>";
    let (without, with) = (scene("", lamp), scene("", &format!("{lamp}{glass}")));
    let view = view(40);
    for (integrator, samples) in [(Integrator::Beams, 1024), (Integrator::Photons, 64)] {
        let settings = Settings { integrator, samples, ..SETTINGS };
        let (clear, glazed) = (fluence(&without.scene, view, &settings), fluence(&with.scene, view, &settings));
        let all: f64 = clear.iter().map(|light| luminance(*light)).sum();
        let off: f64 = clear.iter().zip(&glazed).map(|(a, b)| (luminance(*a) - luminance(*b)).abs()).sum();
        assert!(off / all < 2e-3, "{integrator:?}: {}", off / all);
    }
}

/// A picture that is stopped has whole passes only, and is the picture of so many samples.
#[test]
fn a_stopped_picture_is_one_of_fewer_samples() {
    let drawn = scene("", "<circle class=\"lamp\" cx=\"100\" cy=\"100\" r=\"4\" fill=\"#fff\"/>");
    for integrator in [Integrator::Photons, Integrator::Path] {
        let settings = Settings { integrator, samples: 64, ..SETTINGS };
        let mut passes = Passes::new(&drawn.scene, view(64), &settings);
        assert_eq!(passes.run(|done, _| done < 2, &|| false), Ok(Stopped::Early));
        // A pass of photons has 2^13 packets, here for 64 x 64 pixels.
        let samples = if integrator == Integrator::Photons { 4 } else { 32 };
        let fewer = fluence(&drawn.scene, view(64), &Settings { samples, ..settings });
        assert_eq!(passes.fluence(), fewer, "{integrator:?}");
    }
}

/// Twice the light is the same picture: exposure is relative, and stops double it.
#[test]
fn exposure_follows_the_light_and_stops_double_it() {
    let light: Vec<[f64; 3]> = (1..=100).map(|step| [f64::from(step), 0.5, 0.25]).collect();
    let twice: Vec<[f64; 3]> = light.iter().map(|color| color.map(|channel| 2.0 * channel)).collect();
    let view = view(10);
    let plain = develop(&light, &view, 0.0).0;
    assert_eq!(develop(&twice, &view, 0.0).0, plain);
    let brighter = develop(&light, &view, 1.0).0;
    assert!(brighter.pixels.iter().zip(&plain.pixels).all(|(a, b)| (a[0] - 2.0 * b[0]).abs() < 1e-6 * a[0]));
}
