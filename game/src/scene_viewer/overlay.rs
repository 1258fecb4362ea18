//! The overlay: the picture, and what stands over it.

use super::pick::chords;
use super::resampling::frame_in_view;
use crate::Failure;
use crate::drawn_scene::DrawnScene;
use crate::hud::{Anchor, BRASS, FontFamily, IVORY, NIGHT, TextRenderer, TextStyle};
use crate::screen::{Canvas, Color, Layer, Rect, Size};
use geometry::{DVec2, Segment};
use pinball::table::DrawnOutline;
use std::sync::Arc;
use tracer::{Frame, View};

/// Keys and what they do.
pub const HELP: &[(&str, &str)] = &[
    ("drag a thing", "move it"),
    ("drag the ground", "move the page"),
    ("wheel  \u{b7}  +  \u{2212}", "closer, farther"),
    ("0", "the whole page"),
    ("Z", "take the last move back"),
    ("E", "write the drawing"),
    ("P  \u{b7}  F12", "save a picture"),
    ("X", "expose anew"),
    ("F11", "full screen"),
    ("H  \u{b7}  F1", "these keys"),
    ("Q  \u{b7}  Esc", "leave"),
];

/// Letters, pixels.
const SIZE_PX: f32 = 15.0;
/// A line of letters, pixels.
const LINE_PX: i32 = 22;

/// All that a frame is painted from.
pub struct Overlay {
    /// The frame's size.
    pub size: Size,
    /// Where the page is on it.
    pub view: View,
    /// The picture and its view: another one while a new picture is being made.
    pub picture: Option<(Arc<Frame>, View)>,
    /// The outline of what the mouse holds or would take, pixels.
    pub outline: Option<Vec<Segment>>,
    /// A line at the foot.
    pub status: String,
    /// The keys are shown.
    pub is_help: bool,
}

/// What paints the viewer's frames.
///
/// # Errors
/// If a font of this build is damaged.
pub fn painter() -> Result<impl FnMut(Overlay, &mut Frame) -> Result<(), Failure> + Send + 'static, Failure> {
    let mut text = TextRenderer::new()?;
    Ok(move |overlay: Overlay, frame: &mut Frame| {
        let Size { width, height } = overlay.size;
        (frame.width, frame.height) = (width, height);
        match &overlay.picture {
            Some((picture, view)) if *view == overlay.view => frame.pixels.clone_from(&picture.pixels),
            Some((picture, view)) => frame.pixels = frame_in_view(picture, view, &overlay.view, NIGHT),
            None => frame.pixels = vec![NIGHT; width * height],
        }
        let mut canvas = Canvas::new(frame);
        if let Some(outline) = &overlay.outline {
            let mut layer = Layer::new(Rect::new(0, 0, width as i32, height as i32));
            outline.iter().for_each(|line| layer.line(line.a, line.b, 1.5, BRASS, 150));
            layer.lay(&mut canvas);
        }
        if overlay.is_help {
            help(&mut canvas, &mut text, overlay.size);
        }
        status(&mut canvas, &mut text, overlay.size, &overlay.status);
        Ok(())
    })
}

/// A shape's outline on the screen.
pub fn outline(scene: &DrawnScene, shape: usize, view: &View) -> Vec<Segment> {
    let Some(shape) = scene.drawing.shapes.get(shape) else { return Vec::new() };
    let lines = match &shape.outline {
        DrawnOutline::Circle(circle) => round(circle.center, circle.radius),
        DrawnOutline::Lines(lines) => lines.iter().flat_map(chords).collect(),
    };
    let place = |place| view.screen_from_table(place);
    lines.iter().map(|line| Segment { a: place(line.a), b: place(line.b) }).collect()
}

fn round(center: DVec2, radius: f64) -> Vec<Segment> {
    let at = |step: u32| center + geometry::trig::direction(std::f64::consts::TAU * f64::from(step) / 64.0) * radius;
    (0..64).map(|step| Segment { a: at(step), b: at(step + 1) }).collect()
}

fn style(family: FontFamily, color: Color) -> TextStyle {
    TextStyle { family, size_px: SIZE_PX, tracking: 0.01, color, alpha: 255 }
}

fn status(canvas: &mut Canvas, text: &mut TextRenderer, size: Size, told: &str) {
    if told.is_empty() {
        return;
    }
    let (width, height) = (size.width as i32, size.height as i32);
    let style = text.fitted(told, style(FontFamily::Plain, IVORY), width as f32 - 24.0);
    let pane = Rect::new(0, height - LINE_PX - 6, text.width(told, style) as i32 + 24, LINE_PX + 6);
    let mut layer = Layer::new(pane);
    layer.fill(pane, NIGHT, 170);
    layer.lay(canvas);
    text.write(canvas, told, style, Anchor::left(12.0, (height - 10) as f32));
}

fn help(canvas: &mut Canvas, text: &mut TextRenderer, size: Size) {
    let rows = HELP.len() as i32;
    let whole = Rect::new(0, 0, size.width as i32, size.height as i32);
    let pane = whole.centred((size.width as i32 - 20).min(400), LINE_PX * rows + 2 * LINE_PX);
    let mut layer = Layer::new(pane);
    layer.fill(pane, NIGHT, 225);
    layer.frame(pane, BRASS, 160);
    layer.lay(canvas);
    let middle = pane.x as f32 + pane.width as f32 * 0.48;
    for (row, (keys, action)) in HELP.iter().enumerate() {
        let y = (pane.y + LINE_PX * (row as i32 + 2)) as f32 - 6.0;
        let room = pane.width as f32 * 0.45;
        let keys_style = text.fitted(keys, style(FontFamily::Bold, BRASS), room);
        text.write(canvas, keys, keys_style, Anchor::right(middle - 10.0, y));
        let action_style = text.fitted(action, style(FontFamily::Plain, IVORY), room);
        text.write(canvas, action, action_style, Anchor::left(middle + 10.0, y));
    }
}
