//! A small drawing in lines and shapes, kept as pixels and laid over a frame.
//!
//! It is drawn with tiny-skia when what it shows changes, and only copied while it stays the same. Its coordinates are
//! the frame's own, so that nobody has to know where its corner is; what falls outside it is lost.

use super::canvas::{Canvas, Color, Rect};
use super::contour;
use geometry::{DVec2, Shape};
use tiny_skia::{
    FillRule, GradientStop, LineCap, LinearGradient, Paint, Path, PathBuilder, Pixmap, Point, RadialGradient, Shader,
    SpreadMode, Stroke, Transform,
};

/// Pixels with a place on a frame; empty ones draw nothing.
#[derive(Default)]
pub struct Layer {
    rect: Rect,
    pixels: Option<Pixmap>,
}

impl Layer {
    /// Nothing yet, in `rect`.
    pub fn new(rect: Rect) -> Layer {
        let pixels = if rect.is_empty() { None } else { Pixmap::new(rect.width as u32, rect.height as u32) };
        Layer { rect, pixels }
    }

    /// The pixels that it covers.
    pub fn rect(&self) -> Rect {
        self.rect
    }

    /// R, G, B and A of each of its pixels, the colour not multiplied by A.
    pub fn rgba(&self) -> Vec<u8> {
        let pixels = self.pixels.iter().flat_map(|pixels| pixels.pixels());
        let straight = |pixel: &tiny_skia::PremultipliedColorU8| {
            let pixel = pixel.demultiply();
            [pixel.red(), pixel.green(), pixel.blue(), pixel.alpha()]
        };
        pixels.flat_map(straight).collect()
    }

    /// A rectangle, `alpha` of 255 of it.
    pub fn fill(&mut self, rect: Rect, color: Color, alpha: u32) {
        self.fill_with(rect, solid(color, alpha));
    }

    /// A rectangle's outline: a hairline inside its edge.
    pub fn frame(&mut self, rect: Rect, color: Color, alpha: u32) {
        self.fill(Rect { height: 1, ..rect }, color, alpha);
        self.fill(Rect { y: rect.bottom() - 1, height: 1, ..rect }, color, alpha);
        let sides = Rect::new(rect.x, rect.y + 1, 1, rect.height - 2);
        self.fill(sides, color, alpha);
        self.fill(Rect { x: rect.right() - 1, ..sides }, color, alpha);
    }

    /// A rectangle whose colour goes from `top` to `bottom`.
    pub fn gradient(&mut self, rect: Rect, top: Color, bottom: Color) {
        let (from, to) = (Point::from_xy(0.0, rect.y as f32), Point::from_xy(0.0, rect.bottom() as f32));
        let stops = vec![GradientStop::new(0.0, ink(top, 255)), GradientStop::new(1.0, ink(bottom, 255))];
        let shader = LinearGradient::new(from, to, stops, SpreadMode::Pad, self.place());
        shader.into_iter().for_each(|shader| self.fill_with(rect, shader));
    }

    /// A soft light that fills the ellipse in `rect` and fades towards its edge.
    pub fn glow(&mut self, rect: Rect, color: Color, alpha: u32) {
        let radius = rect.width as f32 * 0.5;
        // Half of the light is gone at a third of the way, a quarter of it is left at half: no edge is seen.
        let parts = [(0.0, 16), (0.25, 9), (0.5, 4), (0.75, 1), (1.0, 0)];
        let stops = parts.map(|(at, part)| GradientStop::new(at, ink(color, alpha * part / 16))).to_vec();
        let middle = Point::from_xy(rect.x as f32 + radius, rect.y as f32 + rect.height as f32 * 0.5);
        let stretch = rect.height as f32 / rect.width.max(1) as f32;
        let ellipse = Transform::from_row(1.0, 0.0, 0.0, stretch, 0.0, middle.y * (1.0 - stretch));
        let place = self.place().pre_concat(ellipse);
        let shader = RadialGradient::new(middle, 0.0, middle, radius, stops, SpreadMode::Pad, place);
        shader.into_iter().for_each(|shader| self.fill_with(rect, shader));
    }

    /// A soft light around a capsule's line, `reach` pixels to each side.
    pub fn halo(&mut self, a: DVec2, b: DVec2, reach: f64, color: Color, alpha: u32) {
        let rings = 8;
        let path = line(a, b);
        for ring in 0..rings {
            let width = 2.0 * reach * f64::from(rings - ring) / f64::from(rings);
            self.stroke(path.as_ref(), width, color, alpha / rings);
        }
    }

    /// A shape, `alpha` of 255 of it.
    pub fn shape(&mut self, shape: &Shape, color: Color, alpha: u32) {
        let (path, place) = (contour::path(shape), self.place());
        if let (Some(path), Some(pixels)) = (path, &mut self.pixels) {
            pixels.fill_path(&path, &paint(solid(color, alpha)), FillRule::EvenOdd, place, None);
        }
    }

    /// A shape's outline, `width` pixels wide.
    pub fn outline(&mut self, shape: &Shape, width: f64, color: Color, alpha: u32) {
        self.stroke(contour::path(shape).as_ref(), width, color, alpha);
    }

    /// A straight line with round ends, `width` pixels wide.
    pub fn line(&mut self, a: DVec2, b: DVec2, width: f64, color: Color, alpha: u32) {
        self.stroke(line(a, b).as_ref(), width, color, alpha);
    }

    /// Its pixels over those of the frame.
    pub fn lay(&self, canvas: &mut Canvas) {
        let Some(pixels) = &self.pixels else { return };
        canvas.blend(self.rect, |index| {
            let pixel = pixels.pixels()[index];
            let color = u32::from(pixel.red()) << 16 | u32::from(pixel.green()) << 8 | u32::from(pixel.blue());
            (color, u32::from(pixel.alpha()))
        });
    }

    /// How opaque it is at each pixel, of 255.
    pub fn coverage(&self) -> Vec<u32> {
        self.pixels.iter().flat_map(|pixels| pixels.pixels()).map(|pixel| u32::from(pixel.alpha())).collect()
    }

    fn stroke(&mut self, path: Option<&Path>, width: f64, color: Color, alpha: u32) {
        let place = self.place();
        if let (Some(path), Some(pixels)) = (path, &mut self.pixels) {
            let stroke = Stroke { width: width as f32, line_cap: LineCap::Round, ..Stroke::default() };
            pixels.stroke_path(path, &paint(solid(color, alpha)), &stroke, place, None);
        }
    }

    fn fill_with(&mut self, rect: Rect, shader: Shader) {
        let inside = rect.clipped(self.rect);
        if inside.is_empty() {
            return;
        }
        let (x, y) = ((inside.x - self.rect.x) as f32, (inside.y - self.rect.y) as f32);
        let rect = tiny_skia::Rect::from_xywh(x, y, inside.width as f32, inside.height as f32);
        if let (Some(rect), Some(pixels)) = (rect, &mut self.pixels) {
            // Whole pixels: there is no edge to smooth.
            let paint = Paint { anti_alias: false, ..paint(shader) };
            pixels.fill_rect(rect, &paint, Transform::identity(), None);
        }
    }

    /// From the frame's coordinates to its own.
    fn place(&self) -> Transform {
        Transform::from_translate(-self.rect.x as f32, -self.rect.y as f32)
    }
}

/// A drawing that is kept for as long as what it shows, `K`, and its place stay the same.
pub struct CachedLayer<K> {
    shown: Option<K>,
    layer: Layer,
}

impl<K> Default for CachedLayer<K> {
    fn default() -> CachedLayer<K> {
        CachedLayer { shown: None, layer: Layer::default() }
    }
}

impl<K: PartialEq> CachedLayer<K> {
    /// Lays it over the frame in `rect`, after drawing it anew with `draw` if it shows something else.
    pub fn lay(&mut self, canvas: &mut Canvas, rect: Rect, shows: K, draw: impl FnOnce(&mut Layer)) {
        if self.layer.rect() != rect || self.shown.as_ref() != Some(&shows) {
            self.layer = Layer::new(rect);
            draw(&mut self.layer);
            self.shown = Some(shows);
        }
        self.layer.lay(canvas);
    }
}

fn line(a: DVec2, b: DVec2) -> Option<Path> {
    let mut path = PathBuilder::new();
    path.move_to(a.x as f32, a.y as f32);
    path.line_to(b.x as f32, b.y as f32);
    path.finish()
}

fn ink(color: Color, alpha: u32) -> tiny_skia::Color {
    tiny_skia::Color::from_rgba8((color >> 16) as u8, (color >> 8) as u8, color as u8, alpha.min(255) as u8)
}

fn solid(color: Color, alpha: u32) -> Shader<'static> {
    Shader::SolidColor(ink(color, alpha))
}

fn paint(shader: Shader) -> Paint {
    Paint { shader, ..Paint::default() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use tracer::Frame;

    /// What a layer that covers all of a black frame leaves of white.
    fn covered(draw: impl FnOnce(&mut Layer)) -> f64 {
        let mut layer = Layer::new(Rect::new(0, 0, 64, 64));
        draw(&mut layer);
        layer.coverage().iter().map(|&alpha| f64::from(alpha) / 255.0).sum()
    }

    #[test]
    fn a_disc_covers_its_area() {
        let area = std::f64::consts::PI * 15.0 * 15.0;
        let covered = covered(|layer| layer.shape(&Shape::disc(DVec2::new(20.3, 19.8), 15.0), 0xff, 255));
        assert!((covered - area).abs() < 0.01 * area, "{covered} {area}");
    }

    #[test]
    fn a_line_covers_its_length_times_its_width_and_two_half_discs() {
        let area = 30.0 * 4.0 + std::f64::consts::PI * 4.0;
        let covered = covered(|layer| layer.line(DVec2::new(12.0, 15.0), DVec2::new(30.0, 39.0), 4.0, 0xff_ffff, 255));
        assert!((covered - area).abs() < 0.02 * area, "{covered} {area}");
    }

    #[test]
    fn a_layer_lies_where_it_was_drawn_and_nowhere_else() {
        let mut frame = Frame::new(8, 8);
        let mut layer = Layer::new(Rect::new(6, -1, 4, 4));
        layer.fill(Rect::new(-50, -50, 200, 200), 0x12_3456, 255);
        layer.lay(&mut Canvas::new(&mut frame));
        let expected = |index: usize| if index % 8 >= 6 && index / 8 < 3 { 0x12_3456 } else { 0 };
        assert!(frame.pixels.iter().enumerate().all(|(index, &pixel)| pixel == expected(index)));
    }

    #[test]
    fn what_stays_the_same_is_not_drawn_again() {
        let (mut frame, mut kept, mut drawn) = (Frame::new(8, 8), CachedLayer::default(), 0);
        for (shows, x) in [(1, 0), (1, 0), (2, 0), (2, 1)] {
            kept.lay(&mut Canvas::new(&mut frame), Rect::new(x, 0, 4, 4), shows, |_| drawn += 1);
        }
        assert_eq!(drawn, 3);
    }
}
