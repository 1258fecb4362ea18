//! A ball rolls down a resting flipper and is shot by it: prints the path and the flipper's angle as comma-separated
//! values.

use geometry::{Circle, DVec2};
use physics::{Command, Controls, Error, Flipper, FlipperControl, Kind, Layout, Machine, Material, Part};
use std::sync::Arc;

fn main() -> Result<(), Error> {
    let flipper = Flipper {
        base: Circle { center: DVec2::new(0.16, 0.93), radius: 0.0116 },
        length_m: 0.0605,
        tip_radius_m: 0.007,
        rest_rad: 28.0_f64.to_radians(),
        up_rad: -23.0_f64.to_radians(),
        control: FlipperControl::Left,
        material: Material { restitution: 0.88, falloff_s_per_m: 0.15, friction: 0.9 },
        coil_torque_n_m: 3.3,
        hold_torque_n_m: 1.4,
        spring_torque_n_m: 0.32,
        mass_kg: 0.30,
    };
    let parts = vec![Part { name: "flipper".into(), kind: Kind::Flipper(flipper) }];
    let (size_m, slope_rad) = (DVec2::new(0.514, 1.067), 6.5_f64.to_radians());
    let mut machine = Machine::new(Arc::new(Layout { size_m, slope_rad, playfield_friction: 0.09, parts }))?;
    machine.put_ball(DVec2::new(0.175, 0.905), DVec2::ZERO, [0.0; 3]);
    machine.tick(Controls::NONE, &[Command::SetFlippers(true)]);
    println!("time_ms,x_mm,y_mm,speed_m_s,flipper_deg");
    for tick in 1..=500 {
        if tick % 10 == 0 {
            let (pose, ball) = (machine.pose(), machine.balls()[0]);
            let (place_mm, angle_deg) = (ball.center * 1000.0, pose.flippers_rad[0].1.to_degrees());
            println!("{tick},{:.3},{:.3},{:.4},{angle_deg:.2}", place_mm.x, place_mm.y, ball.velocity.length());
        }
        machine.tick(Controls { left: tick > 280, ..Controls::NONE }, &[]);
    }
    Ok(())
}
