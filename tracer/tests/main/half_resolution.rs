//! Light at half the resolution against its slow twin, the full one.

use geometry::{DVec2, Shape};
use tracer::scenes::{self, Props};
use tracer::{
    Ball, DisplayBuffer, Emitter, Finish, Floor, Frame, Group, Integrator, ItemId, Lamp, Occluder, Outline, Profile,
    Radiance, Renderer, Scene, SimdLevel, Top, View, tone_map,
};

/// A table with the art for both resolutions.
struct Set {
    view: View,
    props: Props,
    half: Floor,
}

impl Set {
    fn new(width: usize, height: usize) -> Set {
        let view = View::fit(width, height, scenes::SIZE_MM);
        let Props { floor: half, .. } = scenes::props(&view.halved());
        Set { view, props: scenes::props(&view), half }
    }

    fn scene(&self) -> Scene<'_> {
        scenes::table(self.view, &self.props)
    }
}

/// The scene with its art at half the resolution.
fn with_half<'a>(scene: &Scene<'a>, half: &'a Floor) -> Scene<'a> {
    Scene { half_floor: Some(half), ..scene.clone() }
}

fn drawn_half(scene: &Scene, half: &Floor) -> Frame {
    let mut display = DisplayBuffer::default();
    Renderer::with(Integrator::HalfResolution).draw(&with_half(scene, half), 1.0, &mut display);
    display.frame().clone()
}

fn drawn_full(scene: &Scene) -> Frame {
    let mut display = DisplayBuffer::default();
    Renderer::new().draw(scene, 1.0, &mut display);
    display.frame().clone()
}

/// How far two pictures are apart, in 8-bit levels.
struct Apart {
    mean: f64,
    rmse: f64,
    /// The part of all channels that are more than 16 levels apart.
    far: f64,
}

fn apart(a: &Frame, b: &Frame) -> Apart {
    let levels: Vec<f64> =
        a.to_rgb8().iter().zip(b.to_rgb8()).map(|(a, b)| (f64::from(*a) - f64::from(b)).abs()).collect();
    let count = levels.len() as f64;
    Apart {
        mean: levels.iter().sum::<f64>() / count,
        rmse: (levels.iter().map(|level| level * level).sum::<f64>() / count).sqrt(),
        far: levels.iter().filter(|level| **level > 16.0).count() as f64 / count,
    }
}

/// The bounds are of 8-bit levels: a mean of two thirds of a level, and one channel in a hundred (a pixel along edges that
/// are lit from one side, thin wires) that is visibly another.
#[test]
fn half_the_resolution_looks_like_all_of_it() {
    let set = Set::new(540, 1080);
    let scene = set.scene();
    let full = drawn_full(&scene);
    let Apart { mean, rmse, far } = apart(&full, &drawn_half(&scene, &set.half));
    assert!(mean < 0.7 && rmse < 5.0 && far < 0.01, "mean {mean}, root mean square {rmse}, far apart {far}");
}

/// Under a sky and nothing else, what arrives is the same everywhere: the picture is the art, and that is known in full.
#[test]
fn where_light_is_constant_nothing_is_lost() {
    let mut set = Set::new(135, 271);
    // Art is printed anew for each resolution, so its mean, which the bloom is made of, need not be the same.
    for art in [&mut set.props.floor, &mut set.half] {
        art.floor.fill([150, 90, 60, 255]);
        art.tops.fill([40, 180, 90, 255]);
    }
    let mut scene = set.scene();
    scene.glows.clear();
    scene.lamps.clear();
    scene.balls.clear();
    for top in &mut scene.tops {
        // What shines or mirrors is more than what arrives.
        (top.finish.emission, top.finish.gloss) = ([0.0; 3], 0.0);
    }
    scene.ambient = [0.4, 0.5, 0.6];
    let full = drawn_full(&scene);
    let half = drawn_half(&scene, &set.half);
    let most = full.to_rgb8().iter().zip(half.to_rgb8()).map(|(a, b)| a.abs_diff(b)).max();
    assert!(most <= Some(1), "{most:?} levels apart");
}

/// A white plastic in full light over a floor that a wall keeps dark: the plastic ends where it ends, and its light does
/// not come out of it. Where along a row the light falls through half is found to a part of a pixel.
#[test]
fn an_edge_stays_where_it_is_and_light_does_not_bleed() {
    let (width, height) = (64, 64);
    let view = View { width, height, origin_mm: DVec2::ZERO, mm_per_px: 1.0 };
    let grey = |view: View| {
        let pixels = view.width * view.height;
        let (floor, tops) = (vec![[128, 128, 128, 255]; pixels], vec![[0; 4]; pixels]);
        Floor { width: view.width, height: view.height, floor, tops, ..Floor::default() }
    };
    let (floor, half) = (grey(view), grey(view.halved()));
    let top = |x: f64| DVec2::new(x, 0.0);
    for edge in [30.0, 30.25, 30.5, 31.0, 31.75] {
        let corners = vec![top(-9.0), top(edge), DVec2::new(edge, 80.0), DVec2::new(-9.0, 80.0)];
        let finish = Finish {
            albedo: [0.5; 3],
            profile: Profile::Bevel(0.0),
            gloss: 0.0,
            art: false,
            emission: [0.0; 3],
            opacity: 1.0,
            translucency: 0.0,
        };
        // The wall is the plastic's own: it keeps the lamp from the floor, not from the plastic.
        let wall = Shape::capsule(DVec2::new(edge - 1.0, -20.0), DVec2::new(edge - 1.0, 90.0), 0.5);
        let lamp = Lamp {
            id: ItemId(0),
            center_mm: DVec2::new(4.0, 32.0),
            emitter: Emitter::Disc { radius_mm: 1.0 },
            height_mm: 40.0,
            reach_mm: 500.0,
            color: [0.1; 3],
            inside: None,
        };
        let scene = Scene {
            view,
            lamps: vec![lamp],
            occluders: vec![Occluder::opaque(ItemId(0), wall, Group(1))],
            tops: vec![Top { id: ItemId(0), outline: Outline::Polygon(corners), group: Group(1), finish }],
            ambient: [0.001; 3],
            ..scenes::white_view(&floor, 1.0)
        };
        let full = drawn_full(&scene);
        let drawn = drawn_half(&scene, &half);
        for y in [7, 20, 41] {
            let row = |frame: &Frame| -> Vec<f64> {
                (0..width).map(|x| f64::from(frame.pixels[y * width + x] >> 8 & 255)).collect()
            };
            let (full, half) = (row(&full), row(&drawn));
            let middle = (full[20] + full[50]) * 0.5;
            let crossing = |row: &[f64]| {
                let at = (20..50).find(|&x| row[x + 1] < middle).expect("light ends");
                at as f64 + (row[at] - middle) / (row[at] - row[at + 1])
            };
            let (expected, found) = (crossing(&full), crossing(&half));
            assert!((expected - found).abs() < 1.0, "edge at {edge}, row {y}: {expected} became {found}");
            for x in 34..width {
                assert!((full[x] - half[x]).abs() <= 3.0, "edge at {edge}, row {y}, {x}: {} {}", full[x], half[x]);
            }
        }
    }
}

#[test]
fn every_path_any_threads_and_any_past_give_the_same_bytes() {
    let set = Set::new(251, 501);
    let scene = set.scene();
    let expected = drawn_half(&scene, &set.half);
    for path in SimdLevel::available() {
        for threads in [1, 3] {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
            let (mut renderer, mut display) = (Renderer::on(path), DisplayBuffer::default());
            renderer.set_integrator(Integrator::HalfResolution);
            pool.install(|| {
                let mut other = scene.clone();
                scenes::roll(&mut other, DVec2::new(31.0, -14.0));
                other.tops.pop();
                other.lamps[3].color = [0.0; 3];
                other.glows.pop();
                display.set_scissor(0, 0, 60, 60);
                renderer.draw(&with_half(&other, &set.half), 1.5, &mut display);
                renderer.draw(&with_half(&scene, &set.half), 1.0, &mut display);
                display.set_scissor(0, 0, 251, 501);
                renderer.draw(&with_half(&scene, &set.half), 1.0, &mut display);
            });
            assert!(expected == *display.frame(), "{} with {threads} threads", path.name());
        }
    }
}

/// Drawing is rendering and tone mapping, to the bit, whichever of the two the renderer did last.
#[test]
fn drawing_is_rendering_and_tone_mapping() {
    let set = Set::new(65, 129);
    let mut scene = set.scene();
    let mut renderer = Renderer::with(Integrator::HalfResolution);
    let (mut display, mut radiance, mut frame) = (DisplayBuffer::default(), Radiance::default(), Frame::default());
    for number in 0..6 {
        scenes::roll(&mut scene, DVec2::new(9.0, -14.0));
        scene.lamps[number].color = [0.1 * number as f32; 3];
        if number % 3 != 1 {
            renderer.render(&with_half(&scene, &set.half), &mut radiance);
            tone_map::map(&radiance, 1.0, &mut frame);
            assert!(frame == drawn_half(&scene, &set.half), "picture {number}");
        }
        if number % 3 != 2 {
            renderer.draw(&with_half(&scene, &set.half), 1.0, &mut display);
            assert!(*display.frame() == drawn_half(&scene, &set.half), "picture {number}");
        }
    }
}

#[test]
fn no_size_is_too_small_or_too_odd() {
    for (width, height) in [(1, 1), (1, 40), (33, 1), (17, 31), (2, 3)] {
        let set = Set::new(width, height);
        let frame = drawn_half(&set.scene(), &set.half);
        assert_eq!((frame.width, frame.height), (width, height));
    }
}

/// A scene of more lamps than are remembered is made from nothing every time.
#[test]
fn many_lamps_are_drawn_too() {
    let set = Set::new(270, 540);
    let mut scene = set.scene();
    let lamp = scene.lamps[0];
    scene.lamps.extend((0..200).map(|n| Lamp {
        id: ItemId(1000 + n),
        color: [0.002; 3],
        emitter: Emitter::Disc { radius_mm: f64::from(n) * 0.01 },
        ..lamp
    }));
    let full = drawn_full(&scene);
    let Apart { mean, .. } = apart(&full, &drawn_half(&scene, &set.half));
    assert!(mean < 2.0, "{mean}");
}

/// What a scene may not have is left out, and the rest is drawn as if it had never been there.
#[test]
fn what_is_refused_is_not_drawn() {
    let set = Set::new(90, 180);
    let mut scene = set.scene();
    let expected = drawn_half(&scene, &set.half);
    scene.lamps.push(Lamp { id: ItemId(99), center_mm: DVec2::NAN, ..scene.lamps[0] });
    scene.balls.push(Ball { id: ItemId(99), radius_mm: f64::INFINITY, ..scene.balls[0] });
    assert!(drawn_half(&scene, &set.half) == expected);
    scene.view.mm_per_px = f64::NAN;
    assert_eq!(drawn_half(&scene, &set.half).pixels.len(), 0);
}
