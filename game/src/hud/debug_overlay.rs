//! The debug overlay: the shapes that balls and light share, where each ball is going, what it has touched, and what
//! the frame cost.

mod shapes;

use shapes::{first_hit, moving, standing};

use super::frame_times::FrameTimes;
use super::palette::{AMBER, IVORY, NIGHT};
use super::text::{Align, Anchor, FontFamily, TextRenderer, TextStyle};
use crate::Table;
use crate::screen::{CachedLayer, Canvas, Layer, Placement, Rect, ScreenFromTable};
use crate::simulation::Snapshot;
use geometry::{Bounds, Circle, Core, DVec2, Ray, Shape, Taper, trig};
use physics::{BALL_RADIUS_M, BallPose, Contact, Flipper, Kind};

/// A contact of a ball that is still shown.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TrailContact {
    /// What happened.
    pub contact: Contact,
    /// How long ago, in parts of the time that it is shown: 0 to 1.
    pub age: f64,
}

/// What to show.
#[derive(Clone, Debug, Default)]
pub struct DebugInfo {
    /// What the last frames cost.
    pub times: FrameTimes,
    /// The contact trail: the last contacts of balls.
    pub contact_trail: Vec<TrailContact>,
}

const RAY: u32 = 0xff_5fd2;
const IMPULSE: u32 = 0xff_4d3a;
/// How long an impulse of one newton second is drawn, px.
const IMPULSE_PX: f64 = 160.0;
/// How far round a torque of one newton metre is drawn, rad.
const TORQUE_RAD: f64 = 0.63;

/// What the overlay is drawn over.
#[derive(Clone, Copy)]
pub struct OverlayView<'a> {
    /// The table that is played.
    pub table: &'a Table,
    /// Where what is shown of it is on the screen.
    pub placement: &'a Placement,
    /// Where its points are there.
    pub screen_from_table: ScreenFromTable,
    /// What happens on it.
    pub snapshot: &'a Snapshot,
}

/// The overlay and what it keeps: what stands still is drawn once.
#[derive(Default)]
pub struct DebugOverlay {
    standing: CachedLayer<ScreenFromTable>,
    pane: CachedLayer<()>,
}

/// A shape in pixels; its outline if it has a `line`'s width, else all of it.
struct Mark {
    shape: Shape,
    line: Option<f64>,
    color: u32,
    alpha: u32,
}

impl DebugOverlay {
    /// Draws the overlay.
    pub fn draw(
        &mut self,
        canvas: &mut Canvas,
        text_renderer: &mut TextRenderer,
        view: &OverlayView,
        debug: &DebugInfo,
    ) {
        let layout = &view.table.layout;
        self.standing.lay(canvas, view.placement.table, view.screen_from_table, |layer| {
            let marks = layout.parts.iter().flat_map(|part| standing(&part.kind)).map(|shape| {
                let (shape, color) = shape;
                view.outline(shape, color, 150)
            });
            marks.for_each(|mark| mark.draw(layer));
        });
        lay(canvas, view.placement.table, &view.marks(debug));
        for ball in view.moving_balls() {
            view.tell_speed(canvas, text_renderer, ball);
        }
        for (flipper, torque) in view.torques() {
            view.tell_torque(canvas, text_renderer, flipper, torque);
        }
        self.figures(canvas, text_renderer, view, &debug.times);
    }

    fn figures(
        &mut self,
        canvas: &mut Canvas,
        text_renderer: &mut TextRenderer,
        view: &OverlayView,
        times: &FrameTimes,
    ) {
        let (style, table) = (view.style(), view.placement.table);
        let ms = |ms: f64| format!("{ms:.2} ms");
        let latency = |ms: Option<f64>| ms.map_or("no input yet".to_string(), |ms| format!("{ms:.1} ms"));
        let rates = &times.rates;
        let rows = [
            ("scene", ms(times.scene_ms)),
            ("prepare", ms(times.prepare_ms)),
            ("shadows", ms(times.shadows_ms)),
            ("balls", ms(times.balls_ms)),
            ("bloom", ms(times.bloom_ms)),
            ("tone map", ms(times.tone_map_ms)),
            ("hud", ms(times.hud_ms)),
            ("present", ms(times.present_ms)),
            ("between", ms(times.between_ms)),
            ("longest of 5 s", ms(rates.longest_ms)),
            ("pictures a second", format!("{:.1}", rates.frames_per_s)),
            ("input to picture", latency(rates.latency_median_ms)),
            ("- 99th of 100", latency(rates.latency_99th_ms)),
        ];
        let line = style.size_px * 1.25;
        let (width, height) = (style.size_px * 15.0, line * (rows.len() as f32 + 1.6));
        let pane = Rect::new(table.x, table.y, width as i32, height as i32);
        self.pane.lay(canvas, pane, (), |layer| layer.fill(pane, NIGHT, 190));
        let (left, right) = (pane.x as f32 + 4.0, pane.right() as f32 - 4.0);
        for (index, (name, figure)) in rows.iter().enumerate() {
            let y = pane.y as f32 + line * (index as f32 + 1.0);
            text_renderer.write(canvas, name, style, Anchor::left(left, y));
            text_renderer.write(canvas, figure, style, Anchor::right(right, y));
        }
        let y = pane.y as f32 + line * (rows.len() as f32 + 1.0);
        text_renderer.write(canvas, &format!("tick {}", view.snapshot.tick), style, Anchor::left(left, y));
    }
}

impl OverlayView<'_> {
    fn px_per_m(&self) -> f64 {
        self.screen_from_table.px_per_m
    }

    /// Where a point of the table, m, is on the screen.
    fn screen(&self, point_m: DVec2) -> DVec2 {
        self.screen_from_table.origin + point_m * self.px_per_m()
    }

    fn moving_balls(&self) -> impl Iterator<Item = &BallPose> {
        self.snapshot.pose.balls.iter().filter(|ball| !ball.held)
    }

    /// The outline of a shape in metres.
    fn outline(&self, shape_m: Shape, color: u32, alpha: u32) -> Mark {
        let shape = moved(shape_m.scaled(self.px_per_m()), self.screen(DVec2::ZERO));
        Mark { shape, line: Some(1.0), color, alpha }
    }

    /// Everything that moves: parts, balls, their rays, and what they have touched.
    fn marks(&self, debug: &DebugInfo) -> Vec<Mark> {
        let pose = &self.snapshot.pose;
        let parts = &self.table.layout.parts;
        let mut marks: Vec<Mark> = parts
            .iter()
            .enumerate()
            .flat_map(|(index, part)| moving(index, part, pose))
            .map(|(shape, color)| self.outline(shape, color, 200))
            .collect();
        for ball in self.moving_balls() {
            marks.push(self.outline(Shape::disc(ball.center, BALL_RADIUS_M), RAY, 255));
            self.add_ray(ball, &mut marks);
        }
        debug.contact_trail.iter().for_each(|contact| self.add_contact(contact, &mut marks));
        self.torques().for_each(|(flipper, torque)| self.add_torque(flipper, torque, &mut marks));
        marks
    }

    /// The flippers, each with what its coil and its spring turn it with, N m.
    fn torques(&self) -> impl Iterator<Item = (&Flipper, f64)> {
        self.snapshot.pose.flipper_torques_n_m.iter().filter_map(|&(part, torque)| {
            match self.table.layout.parts.get(usize::from(part.0)).map(|part| &part.kind) {
                Some(Kind::Flipper(flipper)) => Some((flipper, torque)),
                _ => None,
            }
        })
    }

    /// A torque as an arc round the pivot, from the way that the flipper points at rest: a tenth of a turn a newton
    /// metre.
    fn add_torque(&self, flipper: &Flipper, torque: f64, marks: &mut Vec<Mark>) {
        let lifts = (flipper.up_rad - flipper.rest_rad).signum();
        let sweep = (lifts * torque * TORQUE_RAD).clamp(-3.0, 3.0);
        let circle = Circle { center: flipper.base.center, radius: 1.7 * flipper.base.radius };
        if sweep.abs() > 1e-3 {
            let arc = geometry::Arc::new(circle, flipper.rest_rad, sweep);
            let color = if torque > 0.0 { AMBER } else { RAY };
            let mut mark = self.outline(Shape { core: Core::Arc(arc), radius: 0.0 }, color, 255);
            mark.line = Some(2.4);
            marks.push(mark);
        }
    }

    fn tell_torque(&self, canvas: &mut Canvas, text_renderer: &mut TextRenderer, flipper: &Flipper, torque: f64) {
        let place = self.screen(flipper.base.center);
        let y = place.y - 2.2 * flipper.base.radius * self.px_per_m();
        let text = format!("{torque:.1} N m");
        text_renderer.write(canvas, &text, self.style(), Anchor::centre(place.x as f32, y as f32));
    }

    /// The ball's way as the simulation and the light know it: a ray to the first hit, the ball there, and the normal.
    fn add_ray(&self, ball: &BallPose, marks: &mut Vec<Mark>) {
        let slow = ball.velocity.length() < 0.02;
        let Some(ray) = Ray::towards(ball.center, ball.center + ball.velocity).filter(|_| !slow) else { return };
        if let Some(hit) = first_hit(&self.table.layout, &self.snapshot.pose, ball, &ray) {
            let there = ray.at(hit.distance);
            marks.push(line(self.screen(ball.center), self.screen(there), 1.0, RAY, 170));
            marks.push(self.outline(Shape::disc(there, BALL_RADIUS_M), RAY, 170));
            let foot = self.screen(there - hit.normal * BALL_RADIUS_M);
            marks.push(line(foot, foot + hit.normal * 18.0, 1.6, AMBER, 230));
        }
        // A tenth of a second of its way.
        let tip = self.screen(ball.center + ball.velocity * 0.1);
        marks.push(line(self.screen(ball.center), tip, 2.4, RAY, 255));
    }

    fn add_contact(&self, contact: &TrailContact, marks: &mut Vec<Mark>) {
        let point = self.screen(contact.contact.point);
        let alpha = (255.0 * (1.0 - contact.age).clamp(0.0, 1.0)) as u32;
        let length = 8.0 + 12.0 * contact.contact.speed_m_s.abs().min(5.0);
        marks.push(Mark { shape: Shape::disc(point, 2.5), line: None, color: AMBER, alpha });
        marks.push(line(point, point + contact.contact.normal * length, 1.4, AMBER, alpha));
        let impulse = contact.contact.impulse_n_s * IMPULSE_PX;
        marks.push(line(point, point + impulse.clamp_length_max(90.0), 2.4, IMPULSE, alpha));
    }

    fn tell_speed(&self, canvas: &mut Canvas, text_renderer: &mut TextRenderer, ball: &BallPose) {
        let (label, table) = (self.screen(ball.center), self.placement.table);
        let right_half = label.x > f64::from(table.x) + f64::from(table.width) * 0.5;
        let (align, aside) = if right_half { (Align::Right, -1.0) } else { (Align::Left, 1.0) };
        let x = label.x + aside * (BALL_RADIUS_M * self.px_per_m() + 3.0);
        let text = format!("{:.2} m/s", ball.velocity.length());
        text_renderer.write(canvas, &text, self.style(), Anchor { align, x: x as f32, y: label.y as f32 + 3.0 });
    }

    fn style(&self) -> TextStyle {
        let size_px = (self.placement.table.width as f32 / 34.0).clamp(7.0, 18.0);
        TextStyle { family: FontFamily::Plain, size_px, tracking: 0.0, color: IVORY, alpha: 255 }
    }
}

impl Mark {
    fn draw(&self, layer: &mut Layer) {
        match (self.line, self.shape.core) {
            (Some(width), Core::Segment(segment)) if self.shape.radius <= 0.0 => {
                layer.line(segment.a, segment.b, width, self.color, self.alpha);
            }
            (Some(width), _) => layer.outline(&self.shape, width, self.color, self.alpha),
            (None, _) => layer.shape(&self.shape, self.color, self.alpha),
        }
    }
}

/// Draws marks in a layer that is no larger than they need.
fn lay(canvas: &mut Canvas, table: Rect, marks: &[Mark]) {
    let bounds = |mark: &Mark| mark.shape.bounds().grown(mark.line.unwrap_or(0.0) + 1.0);
    let Some(all) = marks.iter().map(bounds).reduce(Bounds::union) else { return };
    let (x, y) = (all.min.x.floor() as i32, all.min.y.floor() as i32);
    let rect = Rect::new(x, y, all.max.x.ceil() as i32 - x, all.max.y.ceil() as i32 - y).clipped(table);
    let mut layer = Layer::new(rect);
    marks.iter().for_each(|mark| mark.draw(&mut layer));
    layer.lay(canvas);
}

/// A straight line in pixels.
fn line(a: DVec2, b: DVec2, width: f64, color: u32, alpha: u32) -> Mark {
    Mark { shape: Shape::capsule(a, b, 0.0), line: Some(width), color, alpha }
}

/// The shape, elsewhere.
fn moved(shape: Shape, by: DVec2) -> Shape {
    let circle = |circle: Circle| Circle { center: circle.center + by, ..circle };
    let core = match shape.core {
        Core::Point(center) => Core::Point(center + by),
        Core::Segment(segment) => Core::Segment(geometry::Segment { a: segment.a + by, b: segment.b + by }),
        Core::Arc(arc) => {
            let start_rad = trig::angle(arc.middle()) - arc.half_angle();
            Core::Arc(geometry::Arc::new(circle(arc.circle()), start_rad, 2.0 * arc.half_angle()))
        }
        Core::Taper(taper) => Core::Taper(Taper { a: circle(taper.a), b: circle(taper.b) }),
    };
    Shape { core, ..shape }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_shape_that_is_moved_keeps_its_surface() {
        let by = DVec2::new(7.0, -3.0);
        let circle = Circle { center: DVec2::new(10.0, 20.0), radius: 8.0 };
        let cores = [
            Core::Point(circle.center),
            Core::Segment(geometry::Segment { a: DVec2::ZERO, b: circle.center }),
            Core::Arc(geometry::Arc::new(circle, 0.4, -2.0)),
            Core::Taper(Taper { a: circle, b: Circle { center: DVec2::new(40.0, 22.0), radius: 3.0 } }),
        ];
        for shape in cores.map(|core| Shape { core, radius: 1.5 }) {
            for point in [DVec2::new(3.0, 4.0), DVec2::new(-12.0, 30.0), DVec2::new(25.0, 21.0)] {
                let (there, here) = (moved(shape, by).distance(point + by).0, shape.distance(point).0);
                assert!((there - here).abs() < 1e-9, "{shape:?} {point}");
            }
        }
    }
}
