//! The window's icon: a chrome ball in a spectrum's arc.

use crate::hud::Canvas;
use geometry::{Arc, Circle, Core, DVec2, Shape};
use tracer::Frame;
use winit::window::Icon;

const SIDE: usize = 64;
const NIGHT: u32 = 0x0a_0e1a;
const ARC: [u32; 6] = [0xff_4038, 0xff_a62a, 0xff_e23c, 0x4f_e06a, 0x3c_9dff, 0xb0_62ff];

/// The icon; `None` if the platform takes none.
pub fn icon() -> Option<Icon> {
    let mut frame = Frame::new(SIDE, SIDE);
    let mut canvas = Canvas::new(&mut frame);
    let middle = DVec2::splat(SIDE as f64 * 0.5);
    canvas.shape(&Shape::disc(middle, 31.0), NIGHT, 255);
    for (index, color) in ARC.into_iter().enumerate() {
        let circle = Circle { center: middle, radius: 29.0 - 1.7 * index as f64 };
        let arc = Arc::new(circle, -2.9, 2.2);
        canvas.shape(&Shape { core: Core::Arc(arc), radius: 0.9 }, color, 255);
    }
    let ball = middle + DVec2::new(3.0, 5.0);
    canvas.shape(&Shape::disc(ball, 15.0), 0x5c_6474, 255);
    canvas.shape(&Shape::disc(ball + DVec2::new(-1.5, -2.0), 12.0), 0x8c_94a4, 255);
    canvas.halo(&Shape::disc(ball + DVec2::new(-5.0, -6.0), 2.5), 6.0, 0xff_ffff, 255);
    let rgba = frame.pixels.iter().flat_map(|&p| [(p >> 16) as u8, (p >> 8) as u8, p as u8, opaque(p)]).collect();
    Icon::from_rgba(rgba, SIDE as u32, SIDE as u32).ok()
}

/// What nothing was drawn on is transparent.
fn opaque(pixel: u32) -> u8 {
    if pixel == 0 { 0 } else { 255 }
}
