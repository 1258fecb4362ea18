//! The shell's window: its size, its icon, its pixels, and how often its monitor shows a frame.

use super::icon;
use super::surface::Surface;
use crate::Failure;
use crate::screen::Size;
use std::sync::Arc;
use std::time::Duration;
use tracer::Frame;
use winit::dpi::PhysicalSize;
use winit::event_loop::ActiveEventLoop;
use winit::monitor::MonitorHandle;
use winit::window::{Fullscreen, Window};

/// Frames a second where the monitor does not say.
const USUAL_HZ: f64 = 60.0;
/// The part of the monitor's height that a new window takes.
const HEIGHT_PART: f64 = 0.86;
/// A new window's width, in parts of its height: a pinball table's, with its display above it.
const USUAL_ASPECT: f64 = 0.5;
/// A new window's size where there is no monitor to measure.
const USUAL_SIZE: PhysicalSize<u32> = PhysicalSize::new(540, 1080);

/// What a window is opened with.
#[derive(Clone, Debug, Default)]
pub struct WindowOptions {
    /// What the window is called.
    pub title: String,
    /// Its size in pixels; by default most of the monitor's height.
    pub size: Option<Size>,
    /// Whether it fills the screen.
    pub fullscreen: bool,
}

/// A window and its pixels.
pub struct ShellWindow {
    window: Arc<Window>,
    surface: Surface,
    /// As the window's last event has told it: a window that another program has destroyed cannot be asked any more.
    size: Size,
}

impl ShellWindow {
    /// Opens a window.
    ///
    /// # Errors
    /// If the display gives none, or takes no pixels.
    pub fn open(events: &ActiveEventLoop, options: &WindowOptions) -> Result<ShellWindow, Failure> {
        let window = Arc::new(open(events, options)?);
        let surface = Surface::new(events.owned_display_handle(), window.clone())?;
        let size = pixels(window.inner_size());
        Ok(ShellWindow { window, surface, size })
    }

    /// Shows a frame in the window.
    pub fn present(&mut self, frame: &Frame) {
        self.surface.present(frame, self.size);
    }

    /// The window's size in pixels.
    pub fn size(&self) -> Size {
        self.size
    }

    /// The window has another size now.
    pub fn set_size(&mut self, inner: PhysicalSize<u32>) {
        self.size = pixels(inner);
    }

    /// From one frame of the window's monitor to the next.
    pub fn frame_interval(&self) -> Duration {
        interval(self.window.current_monitor())
    }

    /// Fills the screen, or does so no longer.
    pub fn toggle_fullscreen(&self) {
        let fills = self.window.fullscreen().is_some();
        self.window.set_fullscreen((!fills).then_some(Fullscreen::Borderless(None)));
        self.window.set_cursor_visible(fills);
    }
}

fn pixels(inner: PhysicalSize<u32>) -> Size {
    Size { width: inner.width as usize, height: inner.height as usize }
}

fn open(events: &ActiveEventLoop, options: &WindowOptions) -> Result<Window, Failure> {
    let monitor = events.primary_monitor().or_else(|| events.available_monitors().next());
    let size = match (options.size, &monitor) {
        (Some(size), _) => PhysicalSize::new(size.width as u32, size.height as u32),
        (None, Some(monitor)) => usual_size(monitor.size()),
        (None, None) => USUAL_SIZE,
    };
    let attributes = Window::default_attributes()
        .with_title(&options.title)
        .with_inner_size(size)
        .with_min_inner_size(PhysicalSize::new(64, 64))
        .with_window_icon(icon::icon())
        .with_fullscreen(options.fullscreen.then_some(Fullscreen::Borderless(None)));
    let window = events.create_window(attributes);
    let window = window.map_err(|error| Failure::new(format!("no window could be opened: {error}")))?;
    window.set_cursor_visible(!options.fullscreen);
    Ok(window)
}

fn interval(monitor: Option<MonitorHandle>) -> Duration {
    let hz = monitor.and_then(|monitor| monitor.refresh_rate_millihertz());
    let hz = hz.map_or(USUAL_HZ, |millihertz| f64::from(millihertz) / 1000.0);
    Duration::from_secs_f64(1.0 / hz.clamp(10.0, 1000.0))
}

/// Most of the monitor's height.
fn usual_size(monitor: PhysicalSize<u32>) -> PhysicalSize<u32> {
    let height = (f64::from(monitor.height) * HEIGHT_PART).max(240.0);
    let width = (height * USUAL_ASPECT).min(f64::from(monitor.width.max(240)));
    PhysicalSize::new(width as u32, height as u32)
}
