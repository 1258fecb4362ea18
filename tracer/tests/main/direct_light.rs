//! Scenes with a known answer.

use geometry::{Arc, Circle, Core, DVec2, Segment, Shape, Taper};
use tracer::{
    Ball, Emitter, Finish, Floor, Frame, Group, ItemId, Lamp, Occluder, Outline, Profile, Radiance, Renderer, Scene,
    SimdLevel, Top, View, scalar, scenes, tone_map,
};

const SIDE: usize = 96;

fn white() -> Floor {
    scenes::white(SIDE, SIDE)
}

/// 96 x 96 mm around the origin, one lamp 60 mm above the middle of the view.
fn lone_lamp(floor: &Floor) -> Scene<'_> {
    let lamp = Lamp {
        id: ItemId(0),
        center_mm: DVec2::new(0.0, -40.0),
        emitter: Emitter::Disc { radius_mm: 5.0 },
        height_mm: 30.0,
        reach_mm: 120.0,
        color: [0.1, 0.2, 0.05],
        inside: None,
    };
    let half = SIDE as f64 * 0.5;
    Scene {
        view: View { width: SIDE, height: SIDE, origin_mm: DVec2::splat(-half), mm_per_px: 1.0 },
        lamps: vec![lamp],
        ..scenes::white_view(floor, 1.0)
    }
}

fn rendered(scene: &Scene) -> Radiance {
    let mut radiance = Radiance::default();
    Renderer::new().render_uncached(scene, &mut radiance);
    radiance
}

fn cast(scene: &mut Scene, shape: Shape, group: u16) {
    let id = ItemId(scene.occluders.len() as u32);
    scene.occluders.push(Occluder::opaque(id, shape, Group(group)));
}

/// Twelve pixels in from the right edge, three up from the bottom.
const PIXEL: (usize, usize) = (SIDE - 12, SIDE - 3);

#[test]
fn one_lamp_and_nothing_else_is_the_falloff() {
    let floor = white();
    let scene = lone_lamp(&floor);
    let radiance = rendered(&scene);
    for (x, y) in [(0, 0), (48, 8), (50, 70), PIXEL] {
        let square = scene.view.table_from_pixel(x, y).distance_squared(scene.lamps[0].center_mm);
        let rest = 1.0 - square / (120.0 * 120.0);
        let expected = if rest > 0.0 { 0.2 * 1e4 / (square + 900.0) * rest * rest } else { 0.0 };
        assert!((f64::from(radiance.pixel(x, y)[1]) - expected).abs() <= 2e-6 * expected.max(1.0), "{x} {y}");
    }
}

/// A wall whose edge lies on the line from the point to the lamp's middle, reaching far to one side.
#[test]
fn a_half_hidden_lamp_gives_exactly_half() {
    let floor = white();
    let mut scene = lone_lamp(&floor);
    let point = scene.view.table_from_pixel(PIXEL.0, PIXEL.1);
    let open = rendered(&scene).pixel(PIXEL.0, PIXEL.1);
    let way = (scene.lamps[0].center_mm - point).normalize();
    let radius = 2.0;
    let touching = point + way * 30.0 + way.perp() * radius;
    cast(&mut scene, Shape::capsule(touching, touching + way.perp() * 40.0, radius), 1);
    let half = rendered(&scene).pixel(PIXEL.0, PIXEL.1);
    assert!((half[1] / open[1] - 0.5).abs() < 1e-5, "{} of {}", half[1], open[1]);
}

/// Each of two walls hides one half: a product of their visibilities would leave a quarter.
#[test]
fn two_occluders_that_hide_a_lamp_together_leave_nothing() {
    let floor = white();
    let mut scene = lone_lamp(&floor);
    let point = scene.view.table_from_pixel(PIXEL.0, PIXEL.1);
    let way = (scene.lamps[0].center_mm - point).normalize();
    for (group, side) in [-1.0, 1.0].into_iter().enumerate() {
        let near = point + way * (25.0 + 10.0 * side) - way.perp() * (0.01 * side);
        cast(&mut scene, Shape::capsule(near, near + way.perp() * (40.0 * side), 0.5), group as u16);
    }
    assert_eq!(rendered(&scene).pixel(PIXEL.0, PIXEL.1), [0.0; 3]);
}

#[test]
fn a_point_inside_an_occluder_is_dark() {
    let floor = white();
    let mut scene = lone_lamp(&floor);
    let point = scene.view.table_from_pixel(PIXEL.0, PIXEL.1);
    cast(&mut scene, Shape::disc(point + DVec2::new(1.0, 2.0), 4.0), 1);
    assert_eq!(rendered(&scene).pixel(PIXEL.0, PIXEL.1), [0.0; 3]);
}

#[test]
fn what_stands_behind_the_lamp_hides_nothing() {
    let floor = white();
    let mut scene = lone_lamp(&floor);
    let open = rendered(&scene);
    let lamp = scene.lamps[0].center_mm;
    cast(&mut scene, Shape::capsule(lamp - DVec2::new(40.0, 6.0), lamp + DVec2::new(40.0, -6.0), 0.9), 1);
    let walled = rendered(&scene);
    for (x, y) in [(10, 60), (48, 70), PIXEL] {
        assert_eq!(walled.pixel(x, y), open.pixel(x, y));
    }
}

#[test]
fn the_group_that_holds_a_lamp_does_not_hide_it() {
    let floor = white();
    let mut scene = lone_lamp(&floor);
    let open = rendered(&scene);
    let middle = scene.lamps[0].center_mm;
    cast(&mut scene, Shape::disc(middle, 9.0), 7);
    assert_eq!(rendered(&scene).pixel(PIXEL.0, PIXEL.1), [0.0; 3]);
    scene.lamps[0].inside = Some(Group(7));
    assert_eq!(rendered(&scene).pixel(PIXEL.0, PIXEL.1), open.pixel(PIXEL.0, PIXEL.1));
}

#[test]
fn a_lamp_without_size_gives_hard_shadows() {
    let floor = white();
    let mut scene = lone_lamp(&floor);
    scene.lamps[0].emitter = Emitter::Disc { radius_mm: 0.0 };
    let open = rendered(&scene);
    cast(&mut scene, Shape::disc(DVec2::new(3.0, -10.0), 6.0), 1);
    let shaded = rendered(&scene);
    let mut dark = 0;
    for at in 0..SIDE * SIDE {
        let (lit, got) = (open.pixel(at % SIDE, at / SIDE)[1], shaded.pixel(at % SIDE, at / SIDE)[1]);
        assert!(got == lit || got == 0.0, "{got} of {lit}");
        dark += usize::from(got == 0.0 && lit > 0.0);
    }
    assert!(dark > 300, "{dark} pixels in shadow");
}

#[test]
fn a_top_is_not_darkened_by_its_own_group() {
    let floor = white();
    let mut scene = lone_lamp(&floor);
    let shape = Shape::disc(DVec2::new(0.0, 10.0), 12.0);
    let finish = Finish {
        albedo: [1.0; 3],
        profile: Profile::Bevel(0.5),
        gloss: 0.0,
        art: false,
        emission: [0.0; 3],
        opacity: 1.0,
        translucency: 0.0,
    };
    scene.tops.push(Top { id: ItemId(0), outline: Outline::Shape(shape), group: Group(3), finish });
    let open = rendered(&scene);
    cast(&mut scene, shape, 3);
    let own = rendered(&scene);
    let (x, y) = (48, 58);
    assert!(open.pixel(x, y)[1] > 0.0);
    assert_eq!(own.pixel(x, y), open.pixel(x, y));
    scene.occluders[0].group = Group(4);
    assert_eq!(rendered(&scene).pixel(x, y)[1], 0.0);
}

/// A flat top shows what the floor would show there.
#[test]
fn a_flat_white_top_is_as_bright_as_a_white_floor() {
    let floor = white();
    let mut scene = lone_lamp(&floor);
    let bare = rendered(&scene).pixel(48, 58);
    let finish = Finish {
        albedo: [1.0; 3],
        profile: Profile::Bevel(0.5),
        gloss: 0.0,
        art: false,
        emission: [0.0; 3],
        opacity: 1.0,
        translucency: 0.0,
    };
    let outline = [(-15.0, 0.0), (15.0, 0.0), (15.0, 25.0), (-15.0, 25.0)].map(|(x, y)| DVec2::new(x, y));
    scene.tops.push(Top { id: ItemId(0), outline: Outline::Polygon(outline.to_vec()), group: Group(3), finish });
    let top = rendered(&scene).pixel(48, 58);
    assert!((top[1] - bare[1]).abs() < 1e-5 * bare[1], "{} {}", top[1], bare[1]);
}

/// Shapes without size, on top of each other, around lamps and points: whatever comes out, it is a number.
#[test]
fn degenerate_scenes_give_numbers() {
    let floor = white();
    let mut scene = lone_lamp(&floor);
    let at = DVec2::new(10.5, 20.5);
    let lamp = scene.lamps[0];
    for (id, radius_mm) in [(1, 0.0), (2, 3.0)] {
        scene.lamps.push(Lamp {
            id: ItemId(id),
            center_mm: at,
            emitter: Emitter::Disc { radius_mm },
            height_mm: 0.0,
            ..lamp
        });
    }
    scene.lamps.push(Lamp { id: ItemId(3), center_mm: DVec2::NAN, ..lamp });
    scene.lamps.push(Lamp { id: ItemId(4), reach_mm: 0.0, ..lamp });
    let point = Circle { center: at, radius: 0.0 };
    let round = Circle { center: at, radius: 4.0 };
    for (group, shape) in [
        Shape::disc(at, 0.0),
        Shape::disc(at, 0.0),
        Shape::disc(at, 5.0),
        Shape::disc(at, 5.0),
        Shape::disc(DVec2::NAN, 5.0),
        Shape::capsule(at, at, 0.0),
        Shape::capsule(at, at + DVec2::X, 0.0),
        Shape { core: Core::Segment(Segment { a: at, b: lamp.center_mm }), radius: 2.0 },
        Shape { core: Core::Taper(Taper { a: point, b: round }), radius: 0.0 },
        Shape { core: Core::Taper(Taper { a: point, b: point }), radius: 0.0 },
        Shape { core: Core::Arc(Arc::new(point, 0.0, 1.0)), radius: 1.0 },
        Shape { core: Core::Arc(Arc::new(round, 0.0, 9.0)), radius: 0.0 },
        Shape { core: Core::Arc(Arc::new(round, 0.0, 0.0)), radius: 9.0 },
    ]
    .into_iter()
    .enumerate()
    {
        cast(&mut scene, shape, group as u16);
        let finish = Finish {
            albedo: [0.5; 3],
            profile: Profile::Dome,
            gloss: 1.0,
            art: true,
            emission: [0.0; 3],
            opacity: 0.5,
            translucency: 0.0,
        };
        let [id, next] = [0, 1].map(|next| ItemId(2 * group as u32 + next));
        scene.tops.push(Top { id, outline: Outline::Shape(shape), group: Group(group as u16), finish });
        scene.tops.push(Top { id: next, outline: Outline::Polygon(vec![at; group]), group: Group(1), finish });
    }
    for (id, radius_mm) in [(0, 0.0), (2, 13.5)] {
        let (group, rotation) = (Group(90), [0.0; 4]);
        let ball = Ball { id: ItemId(id), center_mm: at, radius_mm, height_mm: 0.0, below: false, group, rotation };
        let far = DVec2::splat(-60.0);
        scene.balls.extend([ball, Ball { id: ItemId(id + 1), center_mm: far, group: Group(91), ..ball }]);
    }
    let radiance = rendered(&scene);
    for pixel in 0..SIDE * SIDE {
        let light = radiance.pixel(pixel % SIDE, pixel / SIDE);
        assert!(light.iter().all(|c| c.is_finite() && *c >= 0.0), "{light:?} at {pixel}");
    }
    let direct = scalar::irradiance(&scene, at, None);
    assert!(direct.iter().all(|c| c.is_finite()), "{direct:?}");
}

/// One picture of everything: the same on every instruction set, on any number of threads, and the second time.
#[test]
fn a_picture_has_the_same_bytes_everywhere() {
    let view = View::fit(250, 500, scenes::SIZE_MM);
    let props = scenes::props(&view);
    let scene = scenes::table(view, &props);
    let picture = |path: SimdLevel, threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| {
            let (mut renderer, mut radiance) = (Renderer::on(path), Radiance::default());
            let mut frames = [Frame::default(), Frame::default()];
            for frame in &mut frames {
                renderer.render(&scene, &mut radiance);
                tone_map::map_on(path, &radiance, 1.0, frame);
            }
            assert!(frames[0] == frames[1], "a still scene changed");
            (radiance, frames)
        })
    };
    let expected = picture(SimdLevel::best(), 1);
    assert!(expected == picture(SimdLevel::best(), 2), "two threads");
    for path in SimdLevel::available() {
        assert!(expected == picture(path, 3), "{}", path.name());
    }
}
