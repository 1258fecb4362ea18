//! What is remembered of tiles, against pictures that are made from nothing.

use geometry::DVec2;
use geometry::rng::SplitMix64;
use tracer::scenes::{self, Props};
use tracer::{
    DisplayBuffer, Finish, Frame, ItemId, Lamp, Radiance, Renderer, Revision, Rgb, Scene, SimdLevel, View, tone_map,
};

const SIZE: (usize, usize) = (182, 391);

fn view() -> View {
    View::fit(SIZE.0, SIZE.1, scenes::SIZE_MM)
}

/// The generated table, on a floor that leans and shines.
fn props() -> Props {
    let view = view();
    let mut props = scenes::props(&view);
    let lean = |at: usize| [(at * 37 % 41) as i8 - 20, (at * 53 % 31) as i8 - 15];
    props.floor.normals = (0..SIZE.0 * SIZE.1).map(lean).collect();
    props.floor.gloss = 0.4;
    props
}

fn anew(scene: &Scene) -> Radiance {
    let mut radiance = Radiance::default();
    Renderer::new().render_uncached(scene, &mut radiance);
    radiance
}

fn kept(scene: &Scene) -> Radiance {
    let mut radiance = Radiance::default();
    Renderer::new().render(scene, &mut radiance);
    radiance
}

/// A tile keeps numbers in 32,767 steps up to the largest with nothing in the way, and multiplies them by a factor of one
/// lamp alone that is as finely kept: half a step off each is two 65,535ths of that; under 1e-20 is dark. Of bare floor
/// it keeps what arrives and what shines, each for itself: neither is more than what the tile would show were it white.
/// Light is linear, so what holds for each lamp alone bounds the sum.
#[test]
fn what_is_kept_is_within_half_a_step_of_what_is_made_anew() {
    let props = props();
    let mut white = props.clone();
    white.floor.floor.fill([255; 4]);
    let mut scene = scenes::table(view(), &props);
    scene.balls.clear();
    scene.glows.clear();
    scene.ambient = [0.0; 3];
    scene.tops.iter_mut().for_each(|top| top.finish.emission = [0.0; 3]);
    let lamps = std::mem::take(&mut scene.lamps);
    let mut lit_tiles = 0;
    for lamp in lamps {
        scene.lamps = vec![Lamp { color: [1.0, 0.5, 2.0], ..lamp }];
        let (kept, painted) = (kept(&scene), anew(&scene));
        let white = anew(&Scene { floor: &white.floor, occluders: Vec::new(), ..scene.clone() });
        for (left, top) in tiles() {
            let pixels =
                || (top..(top + 16).min(SIZE.1)).flat_map(|y| (left..(left + 16).min(SIZE.0)).map(move |x| (x, y)));
            for (channel, gain) in [1.0f32, 0.5, 2.0].into_iter().enumerate() {
                // The brightest of all channels counts, before the lamp's colour.
                let brightest = pixels()
                    .map(|(x, y)| white.pixel(x, y))
                    .map(|[r, g, b]| r.max(g / 0.5).max(b / 2.0))
                    .fold(0.0, f32::max);
                lit_tiles += usize::from(channel == 0 && brightest > 0.0);
                for (x, y) in pixels() {
                    let off = (kept.pixel(x, y)[channel] - painted.pixel(x, y)[channel]).abs();
                    let most = gain * (brightest * (2.0 / 65_535.0 + 4.0 * f32::EPSILON) + 1e-20);
                    assert!(off <= most, "{off} of {most} at {x} {y}");
                }
            }
        }
    }
    assert!(lit_tiles > 500, "{lit_tiles} tiles were lit");
}

fn tiles() -> impl Iterator<Item = (usize, usize)> {
    (0..SIZE.1).step_by(16).flat_map(|y| (0..SIZE.0).step_by(16).map(move |x| (x, y)))
}

/// A game's worth of changes, from frame to frame.
fn play(scene: &mut Scene, frame: usize) {
    for (at, lamp) in scene.lamps.iter_mut().enumerate() {
        if (at + frame).is_multiple_of(3) {
            lamp.color = lamp.color.map(|c: f32| if c > 0.3 { c * 0.5 } else { c * 1.9 });
        }
    }
    match frame % 5 {
        0 => scenes::roll(scene, DVec2::new(7.0, -11.0)),
        1 => scene.tops[20].finish.emission = [0.1 * frame as f32, 0.2, 0.0],
        2 => scene.glows.iter_mut().for_each(|glow| glow.color = glow.color.map(|c| c * 0.8)),
        3 => scene.tops[25].finish = Finish { gloss: 0.7, translucency: 0.5, ..scene.tops[25].finish },
        _ => {}
    }
}

/// Drawing in one go is rendering and developing, to the bit, on every path and any number of threads; and a still
/// picture stays as it is.
#[test]
fn drawing_is_rendering_and_developing() {
    let props = props();
    for (path, threads) in SimdLevel::available().into_iter().flat_map(|path| [(path, 1), (path, 3)]) {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| {
            let mut scene = scenes::table(view(), &props);
            let (mut drawing, mut rendering) = (Renderer::on(path), Renderer::on(path));
            let (mut display, mut radiance, mut frame) =
                (DisplayBuffer::default(), Radiance::default(), Frame::default());
            for number in 0..12 {
                play(&mut scene, number);
                let exposure = if number > 8 { 1.25 } else { 1.0 };
                drawing.draw(&scene, exposure, &mut display);
                rendering.render(&scene, &mut radiance);
                tone_map::map_on(path, &radiance, exposure, &mut frame);
                assert!(*display.frame() == frame, "frame {number} on {} with {threads} threads", path.name());
                drawing.draw(&scene, exposure, &mut display);
                assert!(*display.frame() == frame, "frame {number} again");
            }
        });
    }
}

/// Whoever looks at a part sees of it what whoever looks at all would see, wherever one has looked before.
#[test]
fn a_part_is_drawn_as_if_it_were_all() {
    let props = props();
    let mut scene = scenes::table(view(), &props);
    let (mut part, mut whole) = (Renderer::new(), Renderer::new());
    let (mut seen, mut all) = (DisplayBuffer::default(), DisplayBuffer::default());
    for number in 0..20 {
        if number % 4 != 3 {
            play(&mut scene, number);
        }
        let (x, y) = (number * 5, number * 13);
        seen.set_scissor(x, y, 70, 110);
        part.draw(&scene, 1.0, &mut seen);
        whole.draw(&scene, 1.0, &mut all);
        for y in y..y + 110 {
            let row = y * SIZE.0 + x..y * SIZE.0 + x + 70;
            assert!(seen.frame().pixels[row.clone()] == all.frame().pixels[row], "frame {number}, row {y}");
        }
    }
}

/// More lamps than are remembered: every picture is made from nothing, and is as right as with few.
#[test]
fn a_thousand_lamps_are_the_sum_of_a_thousand_pictures() {
    let props = props();
    let mut scene = scenes::table(view(), &props);
    scene.balls.clear();
    scene.lamps.truncate(2);
    let dim = |lamp: &Lamp, parts: f32| Lamp { color: lamp.color.map(|c| c / parts), ..*lamp };
    let few = anew(&scene);
    let lamps: Vec<Lamp> = scene.lamps.iter().flat_map(|lamp| vec![dim(lamp, 500.0); 500]).collect();
    scene.lamps = lamps;
    (0..).zip(&mut scene.lamps).for_each(|(id, lamp)| lamp.id = ItemId(id));
    let many = kept(&scene);
    for (x, y) in (0..SIZE.1).step_by(7).flat_map(|y| (0..SIZE.0).step_by(5).map(move |x| (x, y))) {
        let (a, b): (Rgb, Rgb) = (few.pixel(x, y), many.pixel(x, y));
        for channel in 0..3 {
            assert!((a[channel] - b[channel]).abs() <= 1e-4 * a[channel].max(0.1), "{a:?} {b:?} at {x} {y}");
        }
    }
}

/// A picture is the same whatever was drawn before it: told from one that another renderer made of the same scene.
struct Twins {
    renderer: Renderer,
    remembered: Radiance,
}

impl Twins {
    fn new() -> Twins {
        Twins { renderer: Renderer::new(), remembered: Radiance::default() }
    }

    fn assert_same(&mut self, scene: &Scene, what: &str) {
        assert_eq!(scene.check(), Ok(()), "{what}");
        self.renderer.render(scene, &mut self.remembered);
        assert!(self.remembered == kept(scene), "{what}");
    }
}

/// Items are known by their ids, not by their places in a list: whoever puts them in another order, leaves some out,
/// moves some or calls some by another name gets the picture that is made of that scene from nothing.
#[test]
fn any_order_and_any_names_give_the_picture_that_is_made_from_nothing() {
    fn shuffle<T>(random: &mut SplitMix64, list: &mut [T]) {
        let pick = |random: &mut SplitMix64| (random.unit() * list.len() as f64) as usize;
        let (a, b) = (pick(random), pick(random));
        if !list.is_empty() {
            list.swap(a, b);
        }
    }
    let props = props();
    let whole = scenes::table(view(), &props);
    let (mut twins, mut scene, mut random) = (Twins::new(), whole.clone(), SplitMix64::new(21));
    for frame in 0..24 {
        match frame % 12 {
            0 => scene.lamps.reverse(),
            1 => scene.tops.rotate_left(5),
            2 => scene.occluders.rotate_right(2),
            3 => scene.balls.reverse(),
            4 => scene.lamps[2].center_mm += DVec2::new(40.0, 25.0),
            5 => scene.lamps[7].id = ItemId(700 + frame),
            6 => scene.tops[40].id = ItemId(700 + frame),
            7 => drop((scene.occluders.remove(30), scene.tops.remove(9), scene.lamps.remove(4))),
            8 => scene.glows.reverse(),
            9 => scene.clone_from(&whole),
            10 => scene.lamps.swap(0, 5),
            _ => scene.balls[1].id = ItemId(700 + frame),
        }
        shuffle(&mut random, &mut scene.lamps);
        shuffle(&mut random, &mut scene.tops);
        shuffle(&mut random, &mut scene.occluders);
        shuffle(&mut random, &mut scene.glows);
        twins.assert_same(&scene, &format!("frame {frame}"));
    }
}

/// A lamp that is moved under its name takes its light with it.
#[test]
fn a_lamp_that_moves_leaves_no_light_behind() {
    let props = props();
    let (mut twins, mut scene) = (Twins::new(), scenes::table(view(), &props));
    let color = scene.lamps[2].color;
    for frame in 0..10 {
        scene.lamps[2].center_mm.y += 90.0;
        scene.lamps[2].color = if frame % 3 == 1 { [0.0; 3] } else { color };
        twins.assert_same(&scene, &format!("frame {frame}"));
    }
}

/// Art is known by its revision, not by its address: new art in the old art's place is drawn, and the old art in another
/// place is not drawn again.
#[test]
fn art_is_known_by_its_revision() {
    let mut props = props();
    let mut twins = Twins::new();
    twins.assert_same(&scenes::table(view(), &props), "the first art");
    props.floor.floor.iter_mut().for_each(|pixel| pixel[0] = 255 - pixel[0]);
    props.floor.revision = Revision::fresh();
    twins.assert_same(&scenes::table(view(), &props), "other art in the same place");
    props.glows[1].0.coverage.iter_mut().for_each(|coverage| *coverage /= 2);
    props.glows[1].0.revision = Revision::fresh();
    twins.assert_same(&scenes::table(view(), &props), "another mask in the same place");
    let mut copy = props.clone();
    copy.floor.floor.fill([9; 4]);
    twins.renderer.render(&scenes::table(view(), &copy), &mut twins.remembered);
    assert!(twins.remembered == kept(&scenes::table(view(), &props)), "the same revision is the same art");
}
