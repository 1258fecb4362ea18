//! The same bars under a point, a disc and a tube: a hard edge, a soft one, and one that is soft in one direction.
//!
//!     cargo run --release -p tracer --example soft_shadow -- OUT.png

mod output;

use geometry::{DVec2, Shape};
use tracer::{Finish, Floor, Frame, Group, ItemId, Lamp, Radiance, Renderer, Scene, View, tone_map};

/// 600 x 400 mm of grey floor with three lamps of three colours along the top.
pub fn picture() -> Frame {
    let floor = Floor::plain(900, 600, [190, 190, 190]);
    let mut scene = Scene::new(View::fit(900, 600, DVec2::new(600.0, 400.0)), &floor);
    scene.lamps.push(Lamp::disc(ItemId(0), DVec2::new(90.0, 60.0), 0.0, [1.0, 0.25, 0.15]));
    scene.lamps.push(Lamp::disc(ItemId(1), DVec2::new(300.0, 50.0), 18.0, [0.2, 0.9, 0.35]));
    scene.lamps.push(Lamp::of_tube(ItemId(2), DVec2::new(510.0, 60.0), DVec2::new(45.0, 0.0), [0.25, 0.4, 1.3]));
    for number in 0..7u16 {
        let from = DVec2::new(60.0 + 80.0 * f64::from(number), 170.0);
        let bar = Shape::capsule(from, from + DVec2::new(0.0, 22.0), 4.0);
        scene.add_solid(ItemId(number.into()), bar, Group(number + 1), Finish::matte([0.8; 3]));
    }
    let (mut radiance, mut frame) = (Radiance::default(), Frame::default());
    Renderer::new().render(&scene, &mut radiance);
    tone_map::map(&radiance, 1.0, &mut frame);
    frame
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    output::save(&picture(), "soft_shadow.png")
}
