//! The window's icon: a chrome ball in a spectrum's arc.

use crate::screen::{Layer, Rect};
use geometry::{Arc, Circle, Core, DVec2, Shape};
use winit::window::Icon;

const SIDE: i32 = 64;
const ICON_NIGHT: u32 = 0x0a_0e1a;
const ARC: [u32; 6] = [0xff_4038, 0xff_a62a, 0xff_e23c, 0x4f_e06a, 0x3c_9dff, 0xb0_62ff];

/// The icon; `None` if the platform takes none.
pub fn icon() -> Option<Icon> {
    let mut layer = Layer::new(Rect::new(0, 0, SIDE, SIDE));
    let middle = DVec2::splat(f64::from(SIDE) * 0.5);
    layer.shape(&Shape::disc(middle, 31.0), ICON_NIGHT, 255);
    for (index, color) in ARC.into_iter().enumerate() {
        let circle = Circle { center: middle, radius: 29.0 - 1.7 * index as f64 };
        let arc = Arc::new(circle, -2.9, 2.2);
        layer.shape(&Shape { core: Core::Arc(arc), radius: 0.9 }, color, 255);
    }
    let ball = middle + DVec2::new(3.0, 5.0);
    layer.shape(&Shape::disc(ball, 15.0), 0x5c_6474, 255);
    layer.shape(&Shape::disc(ball + DVec2::new(-1.5, -2.0), 12.0), 0x8c_94a4, 255);
    layer.glow(Rect::new(22, 23, 17, 17), 0xff_ffff, 255);
    Icon::from_rgba(layer.rgba(), SIDE as u32, SIDE as u32).ok()
}
