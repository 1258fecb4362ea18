//! The shell: takes the window's events and hands them to the application, and the application's frames to the window.

use super::app::{App, Commands, Event, Wake, Waker};
use super::frame_pipeline::{FramePipeline, now};
use super::key_codes;
use super::painter_thread::{Painter, PainterThread};
use super::pointer;
use super::screenshot::Screenshot;
use super::shell_window::{ShellWindow, WindowOptions};
use crate::{Failure, interrupt};
use std::time::{Duration, Instant};
use winit::application::ApplicationHandler;
use winit::event::{ElementState, KeyEvent, WindowEvent};
use winit::event_loop::{ActiveEventLoop, ControlFlow, EventLoopProxy};
use winit::keyboard::PhysicalKey;
use winit::window::WindowId;

/// How often an application that moves by itself is updated.
const ANIMATING: Duration = Duration::from_millis(8);
/// How often an application in which nothing moves is updated.
const RESTING: Duration = Duration::from_millis(200);

/// A window with an application in it.
pub struct Shell<'a, A: App> {
    app: &'a mut A,
    options: WindowOptions,
    commands: Commands,
    /// Until there is a window to paint for.
    painter: Option<Painter<A::FrameInput, A::FrameReport>>,
    opened: Option<Opened<A>>,
    screenshot: Screenshot,
    started: Instant,
    /// The keyboard is ours.
    focused: bool,
    failure: Option<Failure>,
}

/// What there is once the window is open.
struct Opened<A: App> {
    window: ShellWindow,
    frames: FramePipeline<A::FrameInput, A::FrameReport>,
}

impl<'a, A: App> Shell<'a, A> {
    /// A shell that has no window yet.
    pub fn new(
        app: &'a mut A,
        options: WindowOptions,
        painter: Painter<A::FrameInput, A::FrameReport>,
        proxy: EventLoopProxy<Wake>,
    ) -> Shell<'a, A> {
        Shell {
            app,
            options,
            commands: Commands::new(Waker::new(proxy)),
            painter: Some(painter),
            opened: None,
            screenshot: Screenshot::default(),
            started: now(),
            focused: false,
            failure: None,
        }
    }

    /// What made the window close, if it was not the application.
    pub fn failure(self) -> Option<Failure> {
        self.failure
    }

    fn open(&mut self, events: &ActiveEventLoop) -> Result<(), Failure> {
        let window = ShellWindow::open(events, &self.options)?;
        if let Some(painter) = self.painter.take() {
            let thread = PainterThread::start(painter, self.commands.waker())?;
            let frames = FramePipeline::new(thread, window.frame_interval(), self.started);
            self.opened = Some(Opened { window, frames });
        }
        Ok(())
    }

    /// Lets the application come up to now.
    fn update(&mut self) {
        if self.opened.is_some() {
            self.app.update(now().duration_since(self.started), &mut self.commands);
        }
    }

    /// Hands an event to the application, as it is now.
    fn hand_on(&mut self, events: &ActiveEventLoop, event: Event<A::FrameReport>) {
        self.update();
        self.app.event(event, &mut self.commands);
        self.execute(events);
    }

    /// A window that never had the keyboard (some systems say so as it opens) has nothing to lose.
    fn focus(&mut self, events: &ActiveEventLoop, focused: bool) {
        let had = std::mem::replace(&mut self.focused, focused);
        if had && !focused {
            self.hand_on(events, Event::FocusLost);
        }
    }

    /// Another program has destroyed the window: the application comes up to now, and there is nothing more to show.
    fn lose_window(&mut self, events: &ActiveEventLoop) {
        self.update();
        self.opened = None;
        events.exit();
    }

    /// Does what the application has asked for.
    fn execute(&mut self, events: &ActiveEventLoop) {
        let asked = self.commands.take();
        let Some(Opened { window, frames }) = &mut self.opened else { return };
        if asked.redraw {
            frames.mark_dirty();
        }
        if asked.toggle_fullscreen {
            window.toggle_fullscreen();
        }
        if asked.screenshot
            && let Err(failure) = self.screenshot.save(frames.shown(), self.commands.waker())
        {
            self.app.event(Event::Message(failure.to_string()), &mut self.commands);
        }
        if asked.quit {
            events.exit();
        }
    }

    /// Takes what other threads have done.
    fn collect(&mut self) {
        let mut news: Vec<Event<A::FrameReport>> = self.screenshot.news().map(Event::Message).into_iter().collect();
        if let Some(Opened { window, frames }) = &mut self.opened
            && let Some(painted) = frames.take()
        {
            news.push(match painted {
                Ok((frame, report)) => Event::FrameShown { report, timing: frames.show(frame, window) },
                Err(failure) => Event::Message(failure.to_string()),
            });
        }
        for event in news {
            self.app.event(event, &mut self.commands);
        }
    }

    /// Orders a frame if one is due.
    fn order(&mut self) {
        let Some(Opened { window, frames }) = &mut self.opened else { return };
        let size = window.size();
        if frames.is_due(size) {
            frames.order(self.app.frame_input(size));
        }
    }
}

impl<A: App> ApplicationHandler<Wake> for Shell<'_, A> {
    fn resumed(&mut self, events: &ActiveEventLoop) {
        if self.opened.is_some() {
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
        let Some(Opened { window, frames }) = &mut self.opened else { return };
        match event {
            WindowEvent::CloseRequested => events.exit(),
            WindowEvent::Destroyed => self.lose_window(events),
            WindowEvent::RedrawRequested => window.present(frames.shown()),
            WindowEvent::Resized(inner) => {
                window.set_size(inner);
                frames.mark_dirty();
                // The frame that is there is of another size: it stands for the new one, until that is painted.
                window.present(frames.shown());
            }
            WindowEvent::ScaleFactorChanged { .. } => frames.mark_dirty(),
            WindowEvent::Occluded(hidden) => frames.set_hidden(hidden),
            WindowEvent::Focused(focused) => self.focus(events, focused),
            WindowEvent::KeyboardInput {
                event: KeyEvent { physical_key: PhysicalKey::Code(code), state, repeat: false, .. },
                is_synthetic,
                ..
            } => {
                let down = state == ElementState::Pressed;
                // A key that was already down when the window got the focus was not pressed for the application.
                if !(is_synthetic && down)
                    && let Some(key) = key_codes::key(code)
                {
                    self.hand_on(events, Event::Key { key, down });
                }
            }
            other => {
                if let Some(pointer) = pointer::pointer(&other) {
                    self.hand_on(events, Event::Pointer(pointer));
                }
            }
        }
    }

    fn about_to_wait(&mut self, events: &ActiveEventLoop) {
        if interrupt::is_interrupted() {
            events.exit();
        }
        self.update();
        self.collect();
        self.execute(events);
        self.order();
        let rest = if self.app.is_animating() { ANIMATING } else { RESTING };
        let until = self.opened.as_ref().map_or_else(|| now() + rest, |opened| opened.frames.wake_at(rest));
        events.set_control_flow(ControlFlow::WaitUntil(until));
    }
}
