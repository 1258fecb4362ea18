//! Renders the generated table to a PNG and says how long each part takes.
//!
//!     cargo run --release -p tracer --example table -- OUT.png [WIDTHxHEIGHT] [THREADS] [baseline|avx2|avx512]

use geometry::DVec2;
use std::error::Error;
use std::fs::File;
use std::io::BufWriter;
use std::time::Instant;
use tracer::{Frame, Radiance, Renderer, SimdLevel, View, scenes, tone_map};

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let out = arguments.first().map_or("table.png", String::as_str);
    let (width, height) = arguments.get(1).and_then(|size| size.split_once('x')).unwrap_or(("540", "1080"));
    let threads = arguments.get(2).map_or(Ok(2), |threads| threads.parse())?;
    let wanted = arguments.get(3).map(String::as_str);
    let path =
        SimdLevel::available().into_iter().find(|path| Some(path.name()) == wanted).unwrap_or_else(SimdLevel::best);
    let view = View::fit(width.parse()?, height.parse()?, scenes::SIZE_MM);
    let props = scenes::props(&view);
    let mut scene = scenes::table(view, &props);
    let mut renderer = Renderer::on(path);
    let (mut radiance, mut frame) = (Radiance::default(), Frame::default());
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build()?;
    println!("{} lamps, {} occluders, {} tops", scene.lamps.len(), scene.occluders.len(), scene.tops.len());
    for what in ["relit", "moving", "still"] {
        let (mut light_ms, mut tone_ms) = (Vec::new(), Vec::new());
        let cpu_before = cpu_ms();
        pool.install(|| {
            for _ in 0..60 {
                match what {
                    "relit" => renderer.invalidate(),
                    "moving" => scenes::roll(&mut scene, DVec2::new(0.4, -1.1)),
                    _ => {}
                }
                let start = now();
                renderer.render(&scene, &mut radiance);
                let middle = now();
                tone_map::map_on(path, &radiance, 1.0, &mut frame);
                light_ms.push((middle - start).as_secs_f64() * 1e3);
                tone_ms.push(middle.elapsed().as_secs_f64() * 1e3);
            }
        });
        let ((least_light, light), (least_tone, tone)) = (spread(light_ms), spread(tone_ms));
        let cpu = (cpu_ms() - cpu_before) / 60.0;
        println!(
            "{what} {} threads={threads}: light {light:.2} ms (least {least_light:.2}), \
             tone {tone:.2} ms (least {least_tone:.2}), both {cpu:.2} ms of processor",
            path.name()
        );
    }
    save(&frame, out)
}

#[expect(clippy::disallowed_methods, reason = "an example that measures")]
fn now() -> Instant {
    Instant::now()
}

/// Processor time of all threads so far, where Linux tells: on a busy machine it says more than the clock.
fn cpu_ms() -> f64 {
    let tasks = std::fs::read_dir("/proc/self/task").into_iter().flatten().flatten();
    let spent = tasks.filter_map(|task| std::fs::read_to_string(task.path().join("schedstat")).ok());
    spent.filter_map(|text| text.split(' ').next()?.parse::<f64>().ok()).sum::<f64>() * 1e-6
}

/// The least and the median.
fn spread(mut times: Vec<f64>) -> (f64, f64) {
    times.sort_by(f64::total_cmp);
    (times[0], times[times.len() / 2])
}

fn save(frame: &Frame, path: &str) -> Result<(), Box<dyn Error>> {
    let mut encoder = png::Encoder::new(BufWriter::new(File::create(path)?), frame.width as u32, frame.height as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.write_header()?.write_image_data(&frame.to_rgb8())?;
    Ok(())
}
