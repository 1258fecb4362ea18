//! From winit's mouse to the pointer of an application.

use super::app::Pointer;
use geometry::DVec2;
use winit::event::{ElementState, MouseButton, MouseScrollDelta, WindowEvent};

/// Pixels that a smooth wheel turns for one line.
const PX_PER_LINE: f64 = 40.0;

/// What the mouse did; `None` if the event is none of the mouse's, or of a button that nothing is bound to.
pub fn pointer(event: &WindowEvent) -> Option<Pointer> {
    match event {
        WindowEvent::CursorMoved { position, .. } => Some(Pointer::Moved(DVec2::new(position.x, position.y))),
        WindowEvent::MouseInput { state: ElementState::Pressed, button: MouseButton::Left, .. } => {
            Some(Pointer::Pressed)
        }
        WindowEvent::MouseInput { state: ElementState::Released, button: MouseButton::Left, .. } => {
            Some(Pointer::Released)
        }
        WindowEvent::MouseWheel { delta, .. } => Some(Pointer::Wheel(match delta {
            MouseScrollDelta::LineDelta(_, lines) => f64::from(*lines),
            MouseScrollDelta::PixelDelta(way) => way.y / PX_PER_LINE,
        })),
        _ => None,
    }
}
