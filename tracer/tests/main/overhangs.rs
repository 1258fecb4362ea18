//! Balls below what hangs above them.

use geometry::Shape;
use tracer::scenes;
use tracer::{Overhang, Radiance, Renderer, Scene, View};

const SIZE: (usize, usize) = (182, 391);

fn lit(scene: &Scene) -> Vec<[f32; 3]> {
    let mut radiance = Radiance::default();
    Renderer::new().render(scene, &mut radiance);
    (0..SIZE.1).flat_map(|y| (0..SIZE.0).map(move |x| (x, y))).map(|(x, y)| radiance.pixel(x, y)).collect()
}

#[test]
fn a_ball_below_an_opaque_veil_is_not_seen_and_one_above_it_is() {
    let view = View::fit(SIZE.0, SIZE.1, scenes::SIZE_MM);
    let props = scenes::props(&view);
    let mut scene = scenes::table(view, &props);
    let overhang =
        |ball: &tracer::Ball| Overhang { shape: Shape::disc(ball.center_mm, 3.0 * ball.radius_mm), passes: 0.0 };
    scene.overhangs = scene.balls.iter().map(overhang).collect();
    // What a ball shows of its scratches when it turns.
    let turned = |below: bool| {
        let mut scene = scene.clone();
        scene.balls.iter_mut().for_each(|ball| ball.below = below);
        let before = lit(&scene);
        scene.balls.iter_mut().for_each(|ball| ball.rotation = [0.6, -0.2, 0.5, 0.591_608]);
        (before.clone(), before == lit(&scene))
    };
    let ((above, above_same), (below, below_same)) = (turned(false), turned(true));
    assert!(!above_same, "a ball above its overhang is seen to turn");
    assert!(below_same, "one below it is not");
    assert!(above != below);
}
