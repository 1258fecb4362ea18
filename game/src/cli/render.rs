//! `caustic render`: its words.

use super::values::{picture_file, positive_seconds, threads, whole};
use crate::rendering::Integrator;
use crate::screen::Size;
use clap::{Args, ValueEnum};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// `caustic render`
#[derive(Args, Debug, Clone)]
pub struct RenderArgs {
    /// Drawings, or scenes of the ray-optics simulator
    #[arg(required = true, value_name = "DRAWING.svg|SCENE.json")]
    pub scenes: Vec<PathBuf>,
    /// The picture to write: PNG, TIFF or EXR by the end of its name; a folder for several scenes. By default a PNG with
    /// the scene's name in this folder
    #[arg(long, value_name = "FILE.png|tif|exr|DIR")]
    pub out: Option<PathBuf>,
    /// Size in pixels; the page is fitted in. By default as the page, 1080 pixels on its longer side
    #[arg(long, value_name = "WxH", allow_hyphen_values = true, value_parser = Size::parse)]
    pub size: Option<Size>,
    /// How light is found; by default by beams, and by photons where something is matt or rough
    #[arg(long, value_enum)]
    pub integrator: Option<LightIntegrator>,
    /// Photons: packets for each pixel (64). Path: directions from each pixel (64). Beams: beams that each family of rays
    /// begins with (64). Bake: packets for each cell (16). Monte Carlo: shadow rays for each lamp and pixel (64)
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = whole(1..=1_048_576_u32), verbatim_doc_comment)]
    pub samples: Option<u32>,
    /// Surfaces that light meets at most
    #[arg(long, value_name = "N", allow_hyphen_values = true, value_parser = whole(0..=1_000_000_u32))]
    pub depth: Option<u32>,
    /// Stop after the pass in which this time is over, and keep what there is. Beams are one pass: those that were not
    /// asked for give way to photons at half of the time
    #[arg(long, value_name = "S", allow_hyphen_values = true, value_parser = positive_seconds)]
    pub seconds: Option<f64>,
    /// Seed of the random numbers
    #[arg(long, default_value_t = 0, value_name = "N", allow_hyphen_values = true, value_parser = whole(0..=u64::MAX))]
    pub seed: u64,
    /// Stops brighter than the exposure that is found from the picture; each doubles its light
    #[arg(long, default_value_t = 0.0, value_name = "EV", allow_hyphen_values = true, value_parser = stops)]
    pub exposure: f64,
    /// The temperature of the light that is white, in kelvin; without it light of equal power at every wavelength is white
    #[arg(long, value_name = "K", allow_hyphen_values = true, value_parser = kelvin)]
    pub white: Option<f64>,
    /// Threads that trace light; by default one for each core
    #[arg(long, value_name = "N", value_parser = threads, allow_hyphen_values = true)]
    pub threads: Option<usize>,
}

/// How light is found in a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum LightIntegrator {
    /// Direct light with exact soft shadows, as in the game
    Exact,
    /// Packets of light from the lamps
    Photons,
    /// Beams between neighbouring rays: caustics without noise
    Beams,
    /// Straight light by beams, the rest baked in cells of 4 x 4 pixels: quick and without noise where walls are matt
    Bake,
    /// Paths from the pixels, with indirect light
    Path,
    /// Direct light by shadow rays: the slow reference
    MonteCarlo,
}

impl From<LightIntegrator> for Integrator {
    fn from(word: LightIntegrator) -> Integrator {
        match word {
            LightIntegrator::Exact => Integrator::Exact,
            LightIntegrator::Photons => Integrator::Photons,
            LightIntegrator::Beams => Integrator::Beams,
            LightIntegrator::Bake => Integrator::Bake,
            LightIntegrator::Path => Integrator::Path,
            LightIntegrator::MonteCarlo => Integrator::MonteCarlo,
        }
    }
}

impl RenderArgs {
    /// What two words together may not say.
    pub(super) fn check(&self) -> Result<(), String> {
        if self.integrator == Some(LightIntegrator::Exact) && self.samples.is_some() {
            return Err("--samples is for integrators that sample; exact light takes none".to_string());
        }
        let is_json = |scene: &PathBuf| scene.extension().is_some_and(|end| end.eq_ignore_ascii_case("json"));
        let is_sampled = self.integrator.is_some() || self.samples.is_some() || self.seconds.is_some();
        if is_sampled && self.scenes.iter().any(is_json) {
            return Err("a ray-optics scene (.json) has a list of rays of its own: --integrator, --samples and --seconds are for \
                        drawings"
                .to_string());
        }
        match &self.out {
            Some(out) if self.scenes.len() == 1 && !out.is_dir() => picture_file(out),
            Some(out) if self.scenes.len() > 1 && out.exists() && !out.is_dir() => Err(format!(
                "--out {} is a file, and several scenes are rendered into a folder: name one",
                out.display()
            )),
            Some(out) if self.scenes.len() > 1 && !out.is_dir() && picture_file(out).is_ok() => Err(format!(
                "--out {} is the name of one picture, and several scenes are rendered into a folder: name one",
                out.display()
            )),
            _ => self.check_places(),
        }
    }

    /// No two pictures may be one file.
    fn check_places(&self) -> Result<(), String> {
        let mut places = BTreeMap::new();
        for scene in &self.scenes {
            let place = self.place(scene);
            if let Some(other) = places.insert(place.clone(), scene) {
                return Err(format!(
                    "{} and {} would both be rendered to {}: render one of them alone, with another --out",
                    other.display(),
                    scene.display(),
                    place.display()
                ));
            }
        }
        Ok(())
    }

    /// Where a scene's picture is to be.
    pub fn place(&self, scene: &Path) -> PathBuf {
        let name = PathBuf::from(scene.file_name().unwrap_or(scene.as_os_str())).with_extension("png");
        match &self.out {
            None => name,
            Some(out) if self.scenes.len() > 1 || out.is_dir() => out.join(name),
            Some(out) => out.clone(),
        }
    }
}

fn stops(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(value) if (-30.0..=30.0).contains(&value) => Ok(value),
        _ => Err("it must be a number from -30 to 30".to_string()),
    }
}

pub(super) fn kelvin(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(value) if (1000.0..=40_000.0).contains(&value) => Ok(value),
        _ => Err("it must be a temperature from 1000 to 40000".to_string()),
    }
}
