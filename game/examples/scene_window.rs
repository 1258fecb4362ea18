//! The desktop's shell without a game: a scene of light in a window. The arrows move a lamp, Q leaves.
//!
//!     cargo run --release -p game --example scene_window

use game::Failure;
use game::desktop::{App, Commands, Display, Event, WindowOptions};
use game::input::Key;
use game::screen::Size;
use geometry::DVec2;
use std::time::Duration;
use tracer::{DisplayBuffer, Frame, Renderer, View, scenes};

/// How far the arrows have moved the lamp, mm.
struct SceneViewer(DVec2);

impl App for SceneViewer {
    type FrameInput = (Size, DVec2);
    type FrameReport = ();

    fn update(&mut self, _now: Duration, _commands: &mut Commands) {}

    fn event(&mut self, event: Event<()>, commands: &mut Commands) {
        let Event::Key { key, down: true } = event else { return };
        match key {
            Key::ArrowLeft => self.0.x -= 10.0,
            Key::ArrowRight => self.0.x += 10.0,
            Key::ArrowUp => self.0.y -= 10.0,
            Key::ArrowDown => self.0.y += 10.0,
            Key::KeyQ => commands.quit = true,
            _ => {}
        }
        commands.redraw = true;
    }

    fn frame_input(&mut self, size: Size) -> (Size, DVec2) {
        (size, self.0)
    }

    fn is_animating(&self) -> bool {
        false
    }
}

fn main() -> Result<(), Failure> {
    let (mut renderer, mut pixels) = (Renderer::new(), DisplayBuffer::default());
    let paint = move |(size, moved_mm): (Size, DVec2), frame: &mut Frame| {
        let view = View::fit(size.width, size.height, scenes::SIZE_MM);
        let props = scenes::props(&view);
        let mut scene = scenes::table(view, &props);
        scene.lamps[0].center_mm += moved_mm;
        renderer.draw(&scene, 1.0, &mut pixels);
        frame.clone_from(pixels.frame());
        Ok(())
    };
    let options = WindowOptions { title: "A scene of light".to_string(), ..WindowOptions::default() };
    Display::open()?.run(&mut SceneViewer(DVec2::ZERO), options, paint)
}
