//! How a window is opened: its size, its icon, and how often its monitor shows a picture.

use super::{Look, icon};
use crate::Failure;
use std::time::Duration;
use winit::dpi::PhysicalSize;
use winit::event_loop::ActiveEventLoop;
use winit::monitor::MonitorHandle;
use winit::window::{Fullscreen, Window};

/// Pictures a second where the monitor does not say.
const USUAL_HZ: f64 = 60.0;
/// The part of the monitor's height that a new window takes.
const HEIGHT_PART: f64 = 0.86;

/// Opens the window.
///
/// # Errors
/// If the display gives none.
pub fn window(events: &ActiveEventLoop, look: Look, title: &str) -> Result<Window, Failure> {
    let monitor = events.primary_monitor().or_else(|| events.available_monitors().next());
    let size = match (look.size, &monitor) {
        (Some(size), _) => PhysicalSize::new(size.width as u32, size.height as u32),
        (None, Some(monitor)) => usual_size(monitor.size()),
        (None, None) => PhysicalSize::new(540, 1080),
    };
    let attributes = Window::default_attributes()
        .with_title(title)
        .with_inner_size(size)
        .with_min_inner_size(PhysicalSize::new(64, 64))
        .with_window_icon(icon::icon())
        .with_fullscreen(look.fullscreen.then_some(Fullscreen::Borderless(None)));
    let window = events.create_window(attributes);
    let window = window.map_err(|error| Failure::new(format!("no window could be opened: {error}")))?;
    window.set_cursor_visible(!look.fullscreen);
    Ok(window)
}

/// From one picture of the monitor to the next.
pub fn interval(monitor: Option<MonitorHandle>) -> Duration {
    let hz = monitor.and_then(|monitor| monitor.refresh_rate_millihertz());
    let hz = hz.map_or(USUAL_HZ, |millihertz| f64::from(millihertz) / 1000.0);
    Duration::from_secs_f64(1.0 / hz.clamp(10.0, 1000.0))
}

/// Most of the monitor's height, and the shape of a table with its display above it.
fn usual_size(monitor: PhysicalSize<u32>) -> PhysicalSize<u32> {
    let height = (f64::from(monitor.height) * HEIGHT_PART).max(240.0);
    let width = (height * 0.5).min(f64::from(monitor.width.max(240)));
    PhysicalSize::new(width as u32, height as u32)
}
