//! `caustic render`: drawings as pictures of their light.

use super::parallel;
use super::print::print_lines;
use crate::cli::RenderArgs;
use crate::drawn_scene::DrawnScene;
use crate::optics::{OpticsScene, picture};
use crate::rendering::{Integrator, Passes, Picture, Settings, Stopped, add_art, develop, finds_all_by_beams, weights};
use crate::screen::Size;
use crate::storage::check_place;
use crate::storage::picture_file::{self, LinearPicture};
use crate::storage::text_file;
use crate::{Failure, art, interrupt, tell};
use geometry::DVec2;
use std::path::Path;
use std::time::{Duration, Instant};
use tracer::View;
use tracer::transport::Scene;

/// The longer side of a picture, pixels, where no size is given.
const USUAL_SIDE: f64 = 1080.0;
/// Samples where nothing is said.
const SAMPLES: u32 = 64;
/// Beams of a family where nothing is said.
const BEAMS: u32 = 64;

/// Packets for each cell of a bake where nothing is said.
const BAKE_PACKETS: u32 = 16;

/// Pieces of beams beyond which photons are taken where nobody has chosen: some ten seconds.
const MOST_PIECES: u64 = 3_000_000;

/// Of the time that a picture may take, the part after which photons are taken where nobody has chosen.
const BEAMS_TIME: f64 = 0.5;

/// Renders the scenes that the arguments name.
///
/// # Errors
/// If a scene cannot be read or rendered, or a picture cannot be written; the others are rendered all the same.
pub fn run(args: &RenderArgs) -> Result<(), Failure> {
    let pool = parallel::pool(args.threads)?;
    interrupt::listen_while_working()?;
    let mut failures = Vec::new();
    for scene in &args.scenes {
        let out = args.place(scene);
        if let Err(failure) = pool.install(|| render(args, scene, &out)) {
            failures.push(failure);
        }
        if interrupt::is_interrupted() {
            break;
        }
    }
    match failures.len() {
        0 => Ok(()),
        1 => Err(Failure::of_many(failures)),
        count => {
            let all = args.scenes.len();
            failures.push(Failure::new(format!("{count} of {all} scenes could not be rendered")));
            Err(Failure::of_many(failures))
        }
    }
}

/// A picture and what its file says of it.
struct Rendered {
    picture: Picture,
    metadata: Vec<(&'static str, String)>,
    /// What a person is told, after the name of the file.
    report: String,
}

#[expect(
    clippy::disallowed_methods,
    reason = "a person is told how long a picture took, and may say how long it may take"
)]
fn render(args: &RenderArgs, scene: &Path, out: &Path) -> Result<(), Failure> {
    check_place(out)?;
    let name = scene.display().to_string();
    let is_json = scene.extension().is_some_and(|end| end.eq_ignore_ascii_case("json"));
    let begin = Instant::now();
    let rendered = if is_json { optics(args, scene, &name)? } else { drawing(args, scene, &name, begin)? };
    let Rendered { picture, mut metadata, report } = rendered;
    metadata.push(("Software", format!("Caustic {}", env!("CARGO_PKG_VERSION"))));
    metadata.push(("Source", scene.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned())));
    picture_file::save(LinearPicture { width: picture.width, pixels: &picture.pixels }, &metadata, out)?;
    let size = format!("{}x{}", picture.width, picture.height);
    print_lines([format!("{}: {size}, {report}, {:.1} s", out.display(), begin.elapsed().as_secs_f64())])
}

/// The view of a page.
fn view(args: &RenderArgs, size_mm: DVec2) -> View {
    let usual = || {
        let pixels = (size_mm * (USUAL_SIDE / size_mm.max_element())).round();
        Size { width: pixels.x.max(1.0) as usize, height: pixels.y.max(1.0) as usize }
    };
    let Size { width, height } = args.size.unwrap_or_else(usual);
    View::fit(width, height, size_mm)
}

fn drawing(args: &RenderArgs, scene: &Path, name: &str, begin: Instant) -> Result<Rendered, Failure> {
    let drawn = DrawnScene::read(name, text_file::read_bytes(scene)?).map_err(Failure::of_many)?;
    drawn.warnings.iter().for_each(tell);
    let view = view(args, drawn.drawing.size_mm);
    let settings = settings(args, &drawn.scene);
    let art =
        art::drawing(&drawn.drawing.svg, drawn.drawing.size_mm, &view).map_err(|failure| failure.in_file(name))?;
    let (passes, settings, stopped) =
        make(args, &drawn.scene, view, settings, begin).map_err(|why| Failure::new(format!("{name}: {why}")))?;
    let (done, all) = passes.steps();
    if !passes.is_whole() {
        let what = "it was stopped before its first pass was whole, so there is no picture";
        return Err(Failure::new(format!("{name}: {what}; give it more time, or fewer --samples")));
    }
    let stops = args.exposure + drawn.stops;
    let (mut picture, factor) = develop(&passes.fluence(), &view, stops);
    add_art(&mut picture, &art, drawn.ambient);
    let mut report = format!("{}, {}", integrator_name(settings.integrator), passes.amount(done));
    if stopped == Stopped::Early {
        report += &format!(" of {all} (stopped early)");
    }
    if passes.given_up() > 0.0 {
        let percent = 100.0 * passes.given_up();
        report += &format!(", {percent:.4} % of the light given up after too many surfaces (--depth)");
    }
    let mut metadata = vec![
        ("Integrator", integrator_name(settings.integrator).to_string()),
        ("Samples", settings.samples.to_string()),
        ("Passes", format!("{done} of {all}")),
        ("Seed", settings.seed.to_string()),
        ("Exposure", format!("{factor:e}")),
    ];
    metadata.extend(settings.white_kelvin.map(|kelvin| ("White", format!("{kelvin} K"))));
    Ok(Rendered { picture, metadata, report })
}

/// All passes; where nobody chose an integrator and there are too many beams, or no time for them, by photons after all.
fn make<'a>(
    args: &RenderArgs,
    scene: &'a Scene,
    view: View,
    settings: Settings,
    begin: Instant,
) -> Result<(Passes<'a>, Settings, Stopped), String> {
    let mut passes = Passes::new(scene, view, &settings);
    let may_change = args.integrator.is_none() && settings.integrator == Integrator::Beams;
    let seconds = args.seconds.map(|seconds| if may_change { BEAMS_TIME * seconds } else { seconds });
    match run_passes(seconds, &mut passes, begin)? {
        Stopped::TooManyBeams | Stopped::Early if may_change && !interrupt::is_interrupted() => {
            let samples = args.samples.unwrap_or(SAMPLES);
            let settings = Settings { integrator: Integrator::Photons, samples, ..settings };
            make(args, scene, view, settings, begin)
        }
        stopped => Ok((passes, settings, stopped)),
    }
}

fn run_passes(seconds: Option<f64>, passes: &mut Passes, begin: Instant) -> Result<Stopped, String> {
    let limit = seconds.map(Duration::from_secs_f64);
    let (_, all) = passes.steps();
    let bar = parallel::progress_bar(all, "passes");
    let is_over = || interrupt::is_interrupted() || limit.is_some_and(|limit| begin.elapsed() >= limit);
    let goes_on = |done, _| {
        bar.set_position(done);
        // One pass at least is made, however little time there is, unless a person asks to end.
        !(is_over() && done > 0 || interrupt::is_interrupted())
    };
    let stopped = interrupt::work(|| passes.run(goes_on, &is_over));
    bar.finish_and_clear();
    stopped
}

fn settings(args: &RenderArgs, scene: &Scene) -> Settings {
    let fitting = || if finds_all_by_beams(scene) { Integrator::Beams } else { Integrator::Photons };
    let integrator = args.integrator.map_or_else(fitting, Integrator::from);
    let usual = match integrator {
        Integrator::Beams => BEAMS,
        Integrator::Bake => BAKE_PACKETS,
        Integrator::Exact => 1,
        _ => SAMPLES,
    };
    let samples = args.samples.unwrap_or(usual);
    let most_pieces = args.integrator.is_none().then_some(MOST_PIECES);
    let (seed, depth, white_kelvin) = (args.seed, args.depth, args.white);
    Settings { integrator, samples, seed, depth, most_pieces, is_preview: false, white_kelvin }
}

fn integrator_name(integrator: Integrator) -> &'static str {
    match integrator {
        Integrator::Exact => "exact",
        Integrator::MonteCarlo => "monte-carlo",
        Integrator::Photons => "photons",
        Integrator::Path => "path",
        Integrator::Beams => "beams",
        Integrator::Bake => "bake",
    }
}

/// A ray-optics scene: its own list of rays, without chance.
fn optics(args: &RenderArgs, scene: &Path, name: &str) -> Result<Rendered, Failure> {
    let scene = OpticsScene::parse(name, &text_file::read(scene)?).map_err(Failure::of_many)?;
    scene.warnings.iter().for_each(|what| tell(&Failure::warning(what.clone())));
    scene.check_lit(name)?;
    let bounds = picture::frame(&scene);
    let bounds =
        bounds.ok_or_else(|| Failure::new(format!("{name}: there is nothing in this scene that could be seen")))?;
    let View { width, height, mm_per_px, origin_mm } = view(args, bounds.size());
    let view = View { width, height, mm_per_px, origin_mm: origin_mm + bounds.min };
    let weights = weights(args.white);
    let fluence = interrupt::work(|| picture::fluence(&scene, &view, &weights, &interrupt::is_interrupted));
    if interrupt::is_interrupted() {
        return Err(Failure::new(format!(
            "{name}: it was stopped before all of its rays were followed, so there is no picture"
        )));
    }
    let (picture, factor) = develop(&fluence, &view, args.exposure);
    let metadata = vec![("Integrator", "rays".to_string()), ("Exposure", format!("{factor:e}"))];
    Ok(Rendered { picture, metadata, report: format!("{} rays", scene.rays.len()) })
}
