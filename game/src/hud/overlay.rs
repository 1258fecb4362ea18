//! What happens behind the picture: the shapes that balls and light share, where each ball is going, what it has
//! touched, and what the frame cost.

use super::canvas::{Canvas, Rect};
use super::lettering::{Align, Family, Lettering, Style};
use super::{AMBER, IVORY, NIGHT};
use crate::Table;
use crate::picture::placement::Placement;
use crate::simulation::Snapshot;
use crate::stage::BALL_RADIUS_MM;
use geometry::{DVec2, Hit, Ray, Shape};
use physics::{Contact, Kind, Layout};
use tracer::Frame;

/// What the parts of a frame cost, ms.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Times {
    /// From the moment to the scene.
    pub stage_ms: f64,
    /// The light.
    pub light_ms: f64,
    /// The tone map.
    pub tone_ms: f64,
    /// The display.
    pub hud_ms: f64,
    /// Handing the picture to the window.
    pub present_ms: f64,
    /// From one picture in the window to the next.
    pub between_ms: f64,
}

/// An impact that is still shown.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Touch {
    /// What happened.
    pub contact: Contact,
    /// How long ago, in parts of the time that it is shown: 0 to 1.
    pub age: f64,
}

/// What to show.
#[derive(Clone, Debug, Default)]
pub struct Debug {
    /// What the last frames cost.
    pub times: Times,
    /// The last impacts.
    pub touches: Vec<Touch>,
}

const SOLID: u32 = 0x4f_d8ff;
const SENSOR: u32 = 0x8a_ff9a;
const RAY: u32 = 0xff_5fd2;

/// The outlines of a table's shapes as pixels: drawn once for a size, since they stand still.
#[derive(Default)]
pub struct Outlines {
    rect: Rect,
    pixels: Frame,
}

impl Outlines {
    /// Draws the outlines for a table at this place on the screen.
    pub fn fit(&mut self, table: &Table, rect: Rect) {
        if self.rect == rect && !rect.is_empty() {
            return;
        }
        self.rect = rect;
        self.pixels = Frame::new(rect.width as usize, rect.height as usize);
        let px_per_m = f64::from(rect.width) / table.layout.size_m.x;
        let mut canvas = Canvas::new(&mut self.pixels);
        for (shape, color) in shapes(&table.layout) {
            canvas.outline(&shape.scaled(px_per_m), 1.0, color, 200);
        }
    }

    fn draw(&self, canvas: &mut Canvas) {
        for (index, &pixel) in self.pixels.pixels.iter().enumerate().filter(|(_, pixel)| **pixel != 0) {
            let (x, y) = ((index % self.pixels.width) as i32, (index / self.pixels.width) as i32);
            canvas.dot(self.rect.x + x, self.rect.y + y, pixel, 190);
        }
    }
}

/// Draws the overlay.
pub fn draw(
    canvas: &mut Canvas,
    lettering: &mut Lettering,
    outlines: &Outlines,
    table: &Table,
    placement: &Placement,
    moment: &Snapshot,
    debug: &Debug,
) {
    outlines.draw(canvas);
    let px_per_m = f64::from(placement.table.width) / table.layout.size_m.x;
    let corner = DVec2::new(f64::from(placement.table.x), f64::from(placement.table.y));
    let screen = |point_m: DVec2| corner + point_m * px_per_m;
    for ball in moment.pose.balls.iter().filter(|ball| !ball.held) {
        let radius_px = BALL_RADIUS_MM / 1000.0 * px_per_m;
        let speed = ball.velocity.length();
        canvas.outline(&Shape::disc(screen(ball.center), radius_px), 1.0, RAY, 255);
        if let Some(ray) = Ray::towards(ball.center, ball.center + ball.velocity).filter(|_| speed > 0.02) {
            if let Some(hit) = first_hit(&table.layout, &ray) {
                let there = screen(ray.at(hit.distance));
                canvas.shape(&Shape::capsule(screen(ball.center), there, 0.4), RAY, 150);
                canvas.outline(&Shape::disc(there, radius_px), 1.0, RAY, 150);
                let foot = there - hit.normal * radius_px;
                canvas.shape(&Shape::capsule(foot, foot + hit.normal * 18.0, 0.7), AMBER, 220);
            }
            // A tenth of a second of its way.
            let tip = screen(ball.center + ball.velocity * 0.1);
            canvas.shape(&Shape::capsule(screen(ball.center), tip, 1.2), RAY, 255);
        }
        let style = style(placement, IVORY);
        let label = screen(ball.center);
        let right_half = label.x > corner.x + f64::from(placement.table.width) * 0.5;
        let (align, aside) = if right_half { (Align::Right, -1.0) } else { (Align::Left, 1.0) };
        let x = label.x + aside * (radius_px + 3.0);
        lettering.write(canvas, &format!("{speed:.2} m/s"), style, align, x as f32, label.y as f32 + 3.0);
    }
    for touch in &debug.touches {
        let point = screen(touch.contact.point);
        let alpha = (255.0 * (1.0 - touch.age).clamp(0.0, 1.0)) as u32;
        let length = 8.0 + 12.0 * touch.contact.speed_m_s.abs().min(5.0);
        canvas.shape(&Shape::disc(point, 2.5), AMBER, alpha);
        canvas.shape(&Shape::capsule(point, point + touch.contact.normal * length, 0.7), AMBER, alpha);
    }
    figures(canvas, lettering, placement, moment, &debug.times);
}

fn style(placement: &Placement, color: u32) -> Style {
    let size_px = (placement.table.width as f32 / 34.0).clamp(7.0, 18.0);
    Style { family: Family::Plain, size_px, tracking: 0.0, color, alpha: 255 }
}

fn figures(canvas: &mut Canvas, lettering: &mut Lettering, placement: &Placement, moment: &Snapshot, times: &Times) {
    let style = style(placement, IVORY);
    let rows = [
        ("stage", times.stage_ms),
        ("light", times.light_ms),
        ("tone", times.tone_ms),
        ("hud", times.hud_ms),
        ("present", times.present_ms),
        ("between", times.between_ms),
    ];
    let line = style.size_px * 1.25;
    let (width, height) = (style.size_px * 11.5, line * (rows.len() as f32 + 1.6));
    let pane = Rect::new(placement.table.x, placement.table.y, width as i32, height as i32);
    canvas.fill(pane, NIGHT, 190);
    let (left, right) = (pane.x as f32 + 4.0, pane.right() as f32 - 4.0);
    for (index, (name, ms)) in rows.into_iter().enumerate() {
        let y = pane.y as f32 + line * (index as f32 + 1.0);
        lettering.write(canvas, name, style, Align::Left, left, y);
        lettering.write(canvas, &format!("{ms:.2} ms"), style, Align::Right, right, y);
    }
    let y = pane.y as f32 + line * (rows.len() as f32 + 1.0);
    lettering.write(canvas, &format!("tick {}", moment.tick), style, Align::Left, left, y);
}

/// Where a ball that flies along `ray` first meets something that stands: the same rays, the same shapes, grown by
/// the ball's radius.
fn first_hit(layout: &Layout, ray: &Ray) -> Option<Hit> {
    let radius_m = BALL_RADIUS_MM / 1000.0;
    let solids = shapes(layout).filter(|(_, color)| *color == SOLID);
    solids.fold(None, |nearest, (shape, _)| Hit::nearer(nearest, shape.inflated(radius_m).cast(ray)))
}

/// Every shape of a layout, m, with the colour of what it does.
fn shapes(layout: &Layout) -> impl Iterator<Item = (Shape, u32)> + '_ {
    layout.parts.iter().flat_map(|part| match &part.kind {
        Kind::Wall(wall) => wall.shapes.iter().map(|&shape| (shape, SOLID)).collect(),
        Kind::Bumper(bumper) => vec![(Shape::disc(bumper.circle.center, bumper.circle.radius), SOLID)],
        Kind::Slingshot(sling) => vec![(Shape::capsule(sling.segment.a, sling.segment.b, sling.radius_m), SOLID)],
        Kind::Target(target) => vec![(target.shape, SOLID)],
        Kind::DropTarget(target) => vec![(target.shape, SENSOR)],
        Kind::Rollover(rollover) => vec![(rollover.zone, SENSOR)],
        Kind::Gate(gate) => vec![(Shape::capsule(gate.segment.a, gate.segment.b, 0.0005), SENSOR)],
        Kind::Spinner(spinner) => vec![(Shape::capsule(spinner.segment.a, spinner.segment.b, 0.0005), SENSOR)],
        Kind::Saucer(saucer) => vec![(Shape::disc(saucer.circle.center, saucer.circle.radius), SENSOR)],
        Kind::Drain(drain) => vec![(drain.zone, SENSOR)],
        Kind::Flipper(_) | Kind::Plunger(_) => Vec::new(),
    })
}
