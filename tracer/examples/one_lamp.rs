//! One disc lamp in a ring of posts: the smallest program that renders.
//!
//!     cargo run --release -p tracer --example one_lamp -- OUT.png

mod output;

use geometry::{DVec2, Shape, trig};
use std::f64::consts::TAU;
use tracer::{Finish, Floor, Frame, Group, ItemId, Lamp, Radiance, Renderer, Scene, View, tone_map};

/// 400 x 400 mm of grey floor with a warm lamp in the middle.
pub fn picture() -> Frame {
    let (size, center) = (DVec2::splat(400.0), DVec2::splat(200.0));
    let floor = Floor::plain(720, 720, [150, 148, 145]);
    let mut scene = Scene::new(View::fit(720, 720, size), &floor);
    scene.lamps.push(Lamp::disc(ItemId(0), center, 9.0, [1.1, 0.72, 0.38]));
    for number in 0..14u16 {
        let post = center + trig::direction(f64::from(number) * TAU / 14.0) * (70.0 + 4.0 * f64::from(number));
        scene.add_solid(
            ItemId(number.into()),
            Shape::disc(post, 7.0),
            Group(number + 1),
            Finish::matte([0.5, 0.16, 0.1]),
        );
    }
    let (mut radiance, mut frame) = (Radiance::default(), Frame::default());
    Renderer::new().render(&scene, &mut radiance);
    tone_map::map(&radiance, 1.0, &mut frame);
    frame
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    output::save(&picture(), "one_lamp.png")
}
