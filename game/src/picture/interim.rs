//! Lamps without shadows, until the tracer renders.

use rayon::prelude::*;
use tracer::{Frame, Lamp, Outline, Scene};

pub fn render(scene: &Scene, frame: &mut Frame) {
    let width = frame.width.max(1);
    frame.pixels.par_chunks_mut(width).enumerate().for_each(|(y, row)| {
        for (x, pixel) in row.iter_mut().enumerate() {
            let p = scene.view.table_from_pixel(x, y);
            let mut light = scene.ambient;
            for lamp in &scene.lamps {
                let d2 = p.distance_squared(lamp.center_mm);
                let fade = (1.0 - d2 / (lamp.reach_mm * lamp.reach_mm)).max(0.0);
                let k = Lamp::REFERENCE_MM.powi(2) / (d2 + lamp.height_mm * lamp.height_mm) * fade * fade;
                (0..3).for_each(|i| light[i] += lamp.color[i] * k as f32);
            }
            let art = scene.floor.floor[y * width + x];
            let mut albedo = crate::stage::linear([art[0], art[1], art[2]]);
            let mut add = [0.0; 3];
            for glow in &scene.glows {
                let m = glow.mask;
                if x >= m.x && y >= m.y && x < m.x + m.width {
                    let c = m.coverage.get((y - m.y) * m.width + x - m.x).copied().unwrap_or(0);
                    (0..3).for_each(|i| add[i] += glow.color[i] * f32::from(c) / 255.0);
                }
            }
            for top in &scene.tops {
                let inside = match &top.outline {
                    Outline::Shape(shape) => shape.distance(p).0 < 0.0,
                    Outline::Polygon(points) => {
                        let n = points.len();
                        (0..n)
                            .filter(|&i| {
                                let (a, b) = (points[i], points[(i + 1) % n]);
                                (a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)
                            })
                            .count()
                            % 2
                            == 1
                    }
                };
                if inside {
                    let art = scene.floor.tops[y * width + x];
                    let k = top.finish.opacity;
                    let mut color = top.finish.albedo;
                    if top.finish.art && art[3] > 0 {
                        let print = crate::stage::linear([art[0], art[1], art[2]]);
                        (0..3).for_each(|i| color[i] *= print[i]);
                    }
                    (0..3).for_each(|i| albedo[i] += (color[i] - albedo[i]) * k);
                    add = top.finish.emission;
                }
            }
            for ball in &scene.balls {
                if p.distance(ball.center_mm) < ball.radius_mm {
                    albedo = [0.8; 3];
                }
            }
            let byte = |i: usize| {
                let v = albedo[i] * light[i] + add[i];
                let v = (v * (1.0 + v / 4.0) / (1.0 + v)).clamp(0.0, 1.0);
                (libm::powf(v, 1.0 / 2.2) * 255.0) as u32
            };
            *pixel = byte(0) << 16 | byte(1) << 8 | byte(2);
        }
    });
}
