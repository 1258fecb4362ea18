//! Scenes made by a program: for measurements, for tests and to look at.

use crate::{
    Ball, Emitter, Finish, Floor, Glow, Group, ItemId, Lamp, Mask, Occluder, Outline, Profile, Revision, Rgb, Scene,
    Top, View,
};

mod growth;
mod jumble;
mod optical_jumble;

pub use growth::{lift, with_balls, with_lamps, with_posts};
pub use jumble::{any_shape, floating_jumble, jumble, mixed_jumble};
pub use optical_jumble::{OPTICAL_JUMBLE_MM, optical_jumble};

use geometry::rng::SplitMix64;
use geometry::{Arc, Circle, Core, DVec2, Shape, Taper, trig};

/// The size of the generated table, mm.
pub const SIZE_MM: DVec2 = DVec2::new(514.0, 1067.0);

/// Art and masks, which a [`Scene`] borrows.
#[derive(Clone, Debug, Default)]
pub struct Props {
    /// The floor's art.
    pub floor: Floor,
    /// The glows, each with its colour.
    pub glows: Vec<(Mask, Rgb)>,
}

/// A portrait table as big as a real one: 16 lamps, some 250 pieces of wall, 80 tops, three balls, glows.
pub fn table<'a>(view: View, props: &'a Props) -> Scene<'a> {
    let mut builder = Builder { occluders: Vec::new(), tops: Vec::new(), group: 1, random: SplitMix64::new(7) };
    builder.outer_walls();
    builder.lanes();
    builder.posts();
    let caps = builder.bumpers();
    builder.plastics();
    builder.wires();
    builder.flippers();
    let balls = builder.balls();
    let Builder { occluders, tops, .. } = builder;
    let glows =
        (0..).zip(&props.glows).map(|(id, (mask, color))| Glow { id: ItemId(id), mask, color: *color }).collect();
    Scene {
        view,
        lamps: lamps(&caps),
        occluders,
        overhangs: Vec::new(),
        tops,
        balls,
        glows,
        floor: &props.floor,
        half_floor: None,
        ambient: [0.035, 0.037, 0.05],
    }
}

/// Moves every ball, and the shadow that belongs to it.
pub fn roll(scene: &mut Scene, by_mm: DVec2) {
    for ball in &mut scene.balls {
        ball.center_mm += by_mm;
        for occluder in scene.occluders.iter_mut().filter(|occluder| occluder.group == ball.group) {
            occluder.shape = Shape::disc(ball.center_mm, ball.radius_mm);
        }
    }
}

/// Floor art and glows for `view`.
pub fn props(view: &View) -> Props {
    let revision = Revision::fresh();
    let mut floor = Floor { revision, width: view.width, height: view.height, floor: Vec::new(), ..Floor::default() };
    for y in 0..view.height {
        for x in 0..view.width {
            let at = view.table_from_pixel(x, y);
            floor.floor.push(playfield(at));
            floor.tops.push(print(at));
        }
    }
    let mut glows = Vec::new();
    for k in 0..7 {
        let angle = -2.6 + 0.35 * f64::from(k);
        let center = DVec2::new(257.0, 700.0) + trig::direction(angle) * 150.0;
        let hue = [[1.6, 0.5, 0.05], [1.4, 0.1, 0.1], [0.1, 1.2, 0.3], [0.1, 0.4, 1.8]][k as usize % 4];
        glows.push((mask(view, center, 11.0), hue));
    }
    Props { floor, glows }
}

/// A white floor of `width` x `height` pixels, tops printed white too.
pub fn white(width: usize, height: usize) -> Floor {
    let count = width * height;
    let revision = Revision::fresh();
    Floor { revision, width, height, floor: vec![[255; 4]; count], tops: vec![[255; 4]; count], ..Floor::default() }
}

/// All of `floor` from above, its corner at the table's origin, with nothing on it and in the dark.
pub fn white_view(floor: &Floor, mm_per_px: f64) -> Scene<'_> {
    let view = View { width: floor.width, height: floor.height, origin_mm: DVec2::ZERO, mm_per_px };
    Scene::new(view, floor)
}

fn byte(value: f64) -> u8 {
    (value.clamp(0.0, 1.0) * 255.0 + 0.5) as u8
}

/// Wood, with a star burst and bands printed on it.
fn playfield(at: DVec2) -> [u8; 4] {
    let from = at - DVec2::new(257.0, 640.0);
    let angle = trig::angle(from) / std::f64::consts::TAU * 24.0;
    let ray = (angle - angle.floor() - 0.5).abs() < 0.25;
    let ring = from.length();
    let color = if ring < 60.0 {
        [0.95, 0.83, 0.35]
    } else if ring < 64.0 || (200.0..206.0).contains(&ring) {
        [0.95, 0.95, 0.92]
    } else if ring < 200.0 {
        if ray { [0.75, 0.18, 0.16] } else { [0.14, 0.22, 0.50] }
    } else if ring < 330.0 && ray {
        [0.55, 0.40, 0.62]
    } else {
        let grain = 0.03 * libm::sin(at.x * 0.9 + 3.0 * libm::sin(at.y * 0.01));
        [0.78 + grain, 0.62 + grain, 0.42 + grain]
    };
    [byte(color[0]), byte(color[1]), byte(color[2]), 255]
}

/// What is printed on plastics and caps: stripes.
fn print(at: DVec2) -> [u8; 4] {
    let stripe = ((at.x + at.y) / 14.0).rem_euclid(1.0) < 0.5;
    if stripe { [byte(0.95), byte(0.75), byte(0.15), 255] } else { [byte(0.85), byte(0.16), byte(0.20), 255] }
}

fn mask(view: &View, center: DVec2, radius_mm: f64) -> Mask {
    let reach = DVec2::splat(radius_mm + view.mm_per_px);
    let size = DVec2::new(view.width as f64, view.height as f64);
    let from = view.screen_from_table(center - reach).clamp(DVec2::ZERO, size).floor();
    let to = view.screen_from_table(center + reach).clamp(DVec2::ZERO, size).ceil();
    let (x, y) = (from.x as usize, from.y as usize);
    let (width, height) = (to.x as usize - x, to.y as usize - y);
    let coverage = (0..width * height)
        .map(|at| {
            let distance = view.table_from_pixel(x + at % width, y + at / width).distance(center);
            byte(0.5 - (distance - radius_mm) / view.mm_per_px)
        })
        .collect();
    Mask { revision: Revision::fresh(), x, y, width, coverage }
}

const METAL: Finish = Finish {
    albedo: [0.72, 0.73, 0.76],
    profile: Profile::Dome,
    gloss: 1.0,
    art: false,
    emission: [0.0; 3],
    opacity: 1.0,
    translucency: 0.0,
};
const RUBBER: Finish = Finish { albedo: [0.82, 0.80, 0.76], gloss: 0.25, ..METAL };
const WOOD: Finish = Finish { albedo: [0.10, 0.09, 0.10], gloss: 0.35, profile: Profile::Bevel(2.0), ..METAL };
const PLASTIC: Finish = Finish { albedo: [0.9; 3], gloss: 0.4, art: true, profile: Profile::Bevel(1.2), ..METAL };
const BAT: Finish = Finish { albedo: [0.85, 0.82, 0.75], gloss: 0.4, profile: Profile::Bevel(3.0), ..METAL };

struct Builder {
    occluders: Vec<Occluder>,
    tops: Vec<Top>,
    group: u16,
    random: SplitMix64,
}

impl Builder {
    fn next(&mut self) -> Group {
        self.group += 1;
        Group(self.group)
    }

    fn occlude(&mut self, shape: Shape, group: Group) {
        let id = ItemId(self.occluders.len() as u32);
        self.occluders.push(Occluder::opaque(id, shape, group));
    }

    fn cover(&mut self, outline: Outline, group: Group, finish: Finish) {
        let id = ItemId(self.tops.len() as u32);
        self.tops.push(Top { id, outline, group, finish });
    }

    fn solid(&mut self, shape: Shape, finish: Finish) -> Group {
        let group = self.next();
        self.occlude(shape, group);
        self.cover(Outline::Shape(shape), group, finish);
        group
    }

    /// A wall along points: one top a piece, all of one group.
    fn wall(&mut self, points: &[DVec2], radius: f64, finish: Finish) {
        let group = self.next();
        for ends in points.windows(2) {
            let shape = Shape::capsule(ends[0], ends[1], radius);
            self.occlude(shape, group);
            self.cover(Outline::Shape(shape), group, finish);
        }
    }

    fn arc(&mut self, center: DVec2, radius: f64, start: f64, sweep: f64, thick: f64, finish: Finish) {
        let core = Core::Arc(Arc::new(Circle { center, radius }, start, sweep));
        self.solid(Shape { core, radius: thick }, finish);
    }

    fn outer_walls(&mut self) {
        let p = DVec2::new;
        self.wall(&[p(4.0, 1064.0), p(4.0, 257.0)], 5.0, WOOD);
        self.arc(p(257.0, 257.0), 253.0, -std::f64::consts::PI, std::f64::consts::PI, 5.0, WOOD);
        self.wall(&[p(510.0, 257.0), p(510.0, 1064.0)], 5.0, WOOD);
        self.wall(&[p(470.0, 330.0), p(470.0, 1060.0)], 2.0, METAL);
        self.arc(p(257.0, 257.0), 213.0, -0.9, 0.75, 1.5, METAL);
        self.arc(p(257.0, 257.0), 213.0, -3.0, 0.8, 1.5, METAL);
    }

    fn lanes(&mut self) {
        for x in [120.0, 170.0, 220.0, 270.0, 320.0] {
            self.wall(&[DVec2::new(x, 130.0), DVec2::new(x, 165.0)], 3.0, PLASTIC);
        }
        let p = DVec2::new;
        for side in [-1.0, 1.0] {
            let at = |x: f64, y: f64| p(237.0 + side * x, y);
            self.wall(&[at(185.0, 760.0), at(185.0, 890.0), at(95.0, 945.0)], 2.0, METAL);
            self.wall(&[at(150.0, 790.0), at(150.0, 870.0), at(102.0, 902.0), at(150.0, 790.0)], 3.5, RUBBER);
            let group = self.next();
            let corners = vec![at(152.0, 800.0), at(152.0, 868.0), at(112.0, 893.0)];
            self.cover(Outline::Polygon(corners), group, PLASTIC);
        }
    }

    fn posts(&mut self) {
        for _ in 0..36 {
            let center = DVec2::new(self.random.uniform(40.0, 450.0), self.random.uniform(320.0, 740.0));
            if center.distance(DVec2::new(257.0, 350.0)) < 150.0 {
                continue;
            }
            self.solid(Shape::disc(center, 4.5), RUBBER);
        }
    }

    fn bumpers(&mut self) -> Vec<(DVec2, Group)> {
        let mut caps = Vec::new();
        for center in [DVec2::new(190.0, 280.0), DVec2::new(320.0, 300.0), DVec2::new(245.0, 400.0)] {
            let group = self.next();
            self.occlude(Shape::disc(center, 20.0), group);
            let finish = Finish { emission: [0.5, 0.25, 0.1], profile: Profile::Bevel(8.0), ..PLASTIC };
            self.cover(Outline::Shape(Shape::disc(center, 28.0)), group, finish);
            caps.push((center, group));
        }
        caps
    }

    fn plastics(&mut self) {
        for k in 0..6 {
            let left = k % 2 == 0;
            let base = DVec2::new(if left { 18.0 } else { 462.0 }, 340.0 + 70.0 * f64::from(k));
            let reach = if left { 45.0 } else { -45.0 };
            let p = |x: f64, y: f64| base + DVec2::new(x * reach, y);
            let corners = vec![p(0.0, 0.0), p(1.0, 14.0), p(1.1, 40.0), p(0.6, 66.0), p(0.0, 72.0)];
            let group = self.next();
            for (at, &corner) in corners.iter().enumerate() {
                let next = corners[(at + 1) % corners.len()];
                self.occlude(Shape::capsule(corner, next, 2.0), group);
            }
            self.cover(Outline::Polygon(corners), group, PLASTIC);
        }
    }

    fn wires(&mut self) {
        for _ in 0..3 {
            let mut at = DVec2::new(self.random.uniform(60.0, 400.0), self.random.uniform(450.0, 600.0));
            let mut angle = self.random.uniform(0.0, 6.0);
            let mut points = vec![at];
            for _ in 0..14 {
                angle += self.random.uniform(-0.4, 0.5);
                at += trig::direction(angle) * 9.0;
                points.push(at);
            }
            self.wall(&points, 1.5, METAL);
        }
    }

    fn flippers(&mut self) {
        for (base, tip) in [((150.0, 950.0), (217.0, 985.0)), ((324.0, 950.0), (257.0, 985.0))] {
            let circle = |(x, y): (f64, f64), radius| Circle { center: DVec2::new(x, y), radius };
            let taper = Taper { a: circle(base, 11.0), b: circle(tip, 6.0) };
            let group = self.solid(Shape { core: Core::Taper(taper), radius: 0.0 }, BAT);
            let band = Taper { a: circle(base, 5.0), b: circle(base, 5.0) };
            let finish = Finish { albedo: [0.7, 0.1, 0.1], profile: Profile::Dome, ..RUBBER };
            let outline = Outline::Shape(Shape { core: Core::Taper(band), radius: 0.0 });
            self.cover(outline, group, finish);
        }
    }

    fn balls(&mut self) -> Vec<Ball> {
        (0..)
            .zip([(215.0, 880.0), (330.0, 620.0), (120.0, 480.0)])
            .map(|(id, (x, y))| {
                let group = self.next();
                let center_mm = DVec2::new(x, y);
                self.occlude(Shape::disc(center_mm, 13.5), group);
                Ball {
                    id: ItemId(id),
                    center_mm,
                    radius_mm: 13.5,
                    height_mm: 0.0,
                    below: false,
                    group,
                    rotation: [0.3, 0.2, 0.1, 0.927_361_85],
                }
            })
            .collect()
    }
}

fn lamps(caps: &[(DVec2, Group)]) -> Vec<Lamp> {
    let warm = [1.0, 0.72, 0.42];
    let lamp = |x: f64, y: f64, color: Rgb, power: f32, reach_mm: f64| Lamp {
        id: ItemId(0),
        center_mm: DVec2::new(x, y),
        emitter: Emitter::Disc { radius_mm: 6.0 },
        height_mm: 28.0,
        reach_mm,
        color: color.map(|c| c * power),
        inside: None,
    };
    let mut lamps = vec![
        lamp(60.0, 180.0, [0.25, 0.45, 1.0], 0.9, 280.0),
        lamp(440.0, 160.0, [1.0, 0.25, 0.55], 0.8, 280.0),
        lamp(145.0, 105.0, warm, 0.35, 180.0),
        lamp(245.0, 95.0, warm, 0.35, 180.0),
        lamp(345.0, 105.0, warm, 0.35, 180.0),
        lamp(40.0, 420.0, warm, 0.55, 240.0),
        lamp(445.0, 450.0, warm, 0.55, 240.0),
        lamp(35.0, 640.0, [0.2, 1.0, 0.5], 0.5, 240.0),
        lamp(450.0, 660.0, [1.0, 0.35, 0.1], 0.6, 240.0),
        lamp(110.0, 850.0, warm, 0.6, 260.0),
        lamp(364.0, 850.0, warm, 0.6, 260.0),
        lamp(237.0, 1040.0, [0.5, 0.6, 1.0], 0.6, 300.0),
        lamp(257.0, 640.0, [1.0, 0.9, 0.75], 0.5, 300.0),
    ];
    for &(center, group) in caps {
        lamps.push(Lamp { inside: Some(group), ..lamp(center.x, center.y, [1.0, 0.5, 0.15], 0.6, 200.0) });
    }
    (0..).zip(&mut lamps).for_each(|(id, lamp)| lamp.id = ItemId(id));
    lamps
}
