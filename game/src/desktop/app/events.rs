//! What the window tells: each event, and what of the application it is for.

use super::App;
use crate::desktop::Wake;
use winit::application::ApplicationHandler;
use winit::event::{ElementState, KeyEvent, WindowEvent};
use winit::event_loop::ActiveEventLoop;
use winit::keyboard::PhysicalKey;
use winit::window::WindowId;

impl ApplicationHandler<Wake> for App {
    fn resumed(&mut self, events: &ActiveEventLoop) {
        if self.window.is_some() {
            return;
        }
        if let Err(failure) = self.open(events) {
            self.failure = Some(failure);
            events.exit();
        }
    }

    fn user_event(&mut self, _events: &ActiveEventLoop, _wake: Wake) {
        // What woke the loop is collected before it waits again.
    }

    fn window_event(&mut self, events: &ActiveEventLoop, _window: WindowId, event: WindowEvent) {
        match event {
            WindowEvent::CloseRequested => events.exit(),
            WindowEvent::RedrawRequested => self.present(),
            WindowEvent::Resized(_) | WindowEvent::ScaleFactorChanged { .. } => self.dirty = true,
            WindowEvent::Occluded(hidden) => {
                self.hidden = hidden;
                self.dirty = true;
            }
            WindowEvent::Focused(focused) => self.focus(focused),
            WindowEvent::KeyboardInput {
                event: KeyEvent { physical_key: PhysicalKey::Code(key), state, repeat: false, .. },
                is_synthetic,
                ..
            } => {
                let down = state == ElementState::Pressed;
                // A key that was already down when the window got the focus was not pressed for the game.
                if !(is_synthetic && down) {
                    self.key(events, key, down);
                }
            }
            _ => {}
        }
    }

    fn about_to_wait(&mut self, events: &ActiveEventLoop) {
        self.catch_up();
        self.collect();
        self.order();
        events.set_control_flow(self.wait());
    }
}
