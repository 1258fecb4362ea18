//! A ball rolls down a bare playfield and bounces off a rubber post: prints its path as comma-separated values.

use geometry::{DVec2, Shape};
use physics::{Controls, Error, Kind, Layout, Machine, Material, Part, Wall};
use std::sync::Arc;

fn main() -> Result<(), Error> {
    let rubber = Material { restitution: 0.85, falloff_s_per_m: 0.13, friction: 0.3 };
    let post = Wall { shapes: vec![Shape::disc(DVec2::new(0.25, 0.60), 0.01)], material: rubber };
    let layout = Layout {
        size_m: DVec2::new(0.514, 1.067),
        slope_rad: 6.5_f64.to_radians(),
        playfield_friction: 0.09,
        parts: vec![Part { name: "post".into(), kind: Kind::Wall(post) }],
    };
    let mut machine = Machine::new(Arc::new(layout))?;
    machine.put_ball(DVec2::new(0.253, 0.10), DVec2::ZERO, [0.0; 3]);
    println!("time_ms,x_mm,y_mm,speed_m_s");
    for tick in 0..=1500 {
        if tick % 25 == 0 {
            let ball = machine.balls()[0];
            let place_mm = ball.center * 1000.0;
            println!("{tick},{:.3},{:.3},{:.4}", place_mm.x, place_mm.y, ball.velocity.length());
        }
        machine.tick(Controls::NONE, &[]);
        for contact in machine.contacts() {
            eprintln!("hit after {tick} ms and {:.1} us at {:.3} m/s", contact.time_s * 1e6, contact.speed_m_s);
        }
    }
    Ok(())
}
