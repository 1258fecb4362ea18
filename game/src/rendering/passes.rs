//! Passes: an integrator at work, which can be stopped after any whole pass.

use super::baking::Baking;
use super::direct;
use tracer::View;
use tracer::monte_carlo::Sampling;
use tracer::transport::beams::{BeamOptions, BeamPicture, BeamTracer};
use tracer::transport::spectrum::{Emission, Weights};
use tracer::transport::{
    Counts, LampFaces, MOST_SURFACES, Material, PathPicture, PathTracer, PhotonPicture, PhotonTracer, Scene,
};

/// Packets of a pass of photons: even where each meets a thousand surfaces, a pass is over in seconds.
const PACKETS: u64 = 1 << 13;

/// Directions that a path tracer's pass follows from a pixel.
const DIRECTIONS: u32 = 16;

/// Beams that show where light goes.
const PREVIEW: BeamOptions =
    BeamOptions { beams: 32, wavelengths: 8, widths: 2, most_surfaces: 8, least_power: 0.02, most_pieces: u64::MAX };

/// How the light of a scene is found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Integrator {
    /// Direct light, exactly.
    Exact,
    /// Direct light by shadow rays: a reference.
    MonteCarlo,
    /// Packets of light from the lamps.
    Photons,
    /// Paths from the pixels.
    Path,
    /// Beams between neighbouring rays: caustics without noise.
    Beams,
    /// Straight light by beams, all other light baked in cells.
    Bake,
}

/// What an integrator is told.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Which.
    pub integrator: Integrator,
    /// Photons: packets for each pixel. Path: directions from each pixel. Beams: beams that each family of rays begins
    /// with. Bake: packets for each cell. Monte Carlo: shadow rays for each lamp and pixel. Exact takes none.
    pub samples: u32,
    /// Of chance.
    pub seed: u64,
    /// Surfaces that light meets at most.
    pub depth: Option<u32>,
    /// Beams end when this many pieces of them were laid, all families together, each its share: never where nothing is said.
    pub most_pieces: Option<u64>,
    /// Beams: as few of them as show where light goes, for a picture at once; of too many some are left out.
    pub is_preview: bool,
    /// The temperature of the black body whose light is white, K; without it equal power at every wavelength is.
    pub white_kelvin: Option<f64>,
}

/// Why passes ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stopped {
    /// All were made.
    Done,
    /// They were told to.
    Early,
    /// There are more beams than there may be.
    TooManyBeams,
}

/// A picture in the making.
pub struct Passes<'a> {
    work: Work<'a>,
    /// What is seen of the lamps themselves; direct light has them in its own.
    faces: LampFaces,
}

enum Work<'a> {
    /// Direct light: one pass.
    Direct { scene: &'a Scene, view: View, weights: Box<Weights>, sampling: Option<Sampling>, fluence: Vec<[f64; 3]> },
    /// The packets of all passes; the last pass may have fewer.
    Photons { picture: Box<PhotonPicture<'a>>, packets: u64, pixels: u64 },
    /// A pass is some directions from each pixel.
    Path { picture: Box<PathPicture<'a>>, passes: u64 },
    /// All families are one pass: a part of them lacks light. The steps are families.
    Beams { picture: Box<BeamPicture<'a>>, families: u64, done: u64, may_be_cut: bool },
    /// The steps are the families of the straight light, and then the bake.
    Bake { straight: Box<BeamPicture<'a>>, families: u64, done: u64, baking: Box<Baking<'a>> },
}

/// The weights of wavelengths with which the light of a black body of this temperature is white, or that of equal energy.
pub fn weights(white_kelvin: Option<f64>) -> Weights {
    match white_kelvin {
        None => Weights::equal_energy(),
        Some(kelvin) => {
            let white = Emission::Blackbody { kelvin };
            Weights::balanced(|nm| white.power(nm))
        }
    }
}

/// Whether beams find all of a scene's light: nothing is matt or rough.
pub fn finds_all_by_beams(scene: &Scene) -> bool {
    let scatters = |material: &Material| matches!(material, Material::Diffuse { .. }) || material.roughness() > 0.0;
    !scene.bodies.iter().any(|body| scatters(&body.material))
}

impl<'a> Passes<'a> {
    /// Begins a picture of a scene.
    pub fn new(scene: &'a Scene, view: View, settings: &Settings) -> Passes<'a> {
        let weights = weights(settings.white_kelvin);
        let Settings { samples, seed, depth, .. } = *settings;
        let faces = match settings.integrator {
            Integrator::Exact | Integrator::MonteCarlo => LampFaces::default(),
            _ => LampFaces::new(scene, &view, &weights),
        };
        let work = match settings.integrator {
            Integrator::Exact | Integrator::MonteCarlo => {
                let sampling = Sampling { samples, seed, stratified: true };
                let sampling = (settings.integrator == Integrator::MonteCarlo).then_some(sampling);
                Work::Direct { scene, view, weights: Box::new(weights), sampling, fluence: Vec::new() }
            }
            Integrator::Photons => {
                let tracer = PhotonTracer::new(scene, weights, seed).with_most_surfaces(depth.unwrap_or(MOST_SURFACES));
                let pixels = view.width as u64 * view.height as u64;
                let packets = pixels * u64::from(samples);
                Work::Photons { picture: Box::new(PhotonPicture::new(tracer, view)), packets, pixels }
            }
            Integrator::Path => {
                let directions = samples.min(DIRECTIONS);
                let tracer = PathTracer::new(scene, weights, seed).with_most_surfaces(depth.unwrap_or(MOST_SURFACES));
                let picture = Box::new(PathPicture::new(tracer, view, directions));
                Work::Path { picture, passes: u64::from(samples.div_ceil(directions.max(1))) }
            }
            Integrator::Beams => {
                let usual = if settings.is_preview { PREVIEW } else { BeamOptions::default() };
                let options =
                    BeamOptions { beams: samples, most_surfaces: depth.unwrap_or(usual.most_surfaces), ..usual };
                let tracer = BeamTracer::new(scene, &weights, options);
                let families = tracer.tasks() as u64;
                let share = settings.most_pieces.map_or(u64::MAX, |pieces| pieces / families.max(1));
                let tracer = tracer.with_most_pieces(share);
                let picture = Box::new(BeamPicture::new(tracer, view));
                Work::Beams { picture, families, done: 0, may_be_cut: settings.is_preview }
            }
            Integrator::Bake => {
                let options = BeamOptions { most_surfaces: 0, ..BeamOptions::default() };
                let tracer = BeamTracer::new(scene, &weights, options);
                let families = tracer.tasks() as u64;
                let straight = Box::new(BeamPicture::new(tracer, view));
                let baking = Box::new(Baking::new(scene, view, weights, settings));
                Work::Bake { straight, families, done: 0, baking }
            }
        };
        Passes { work, faces }
    }

    /// Makes passes until all are made or `goes_on`, which is told how many steps of how many are done, says no.
    /// `is_cancelled` is asked within a pass, by any thread, where a part of a pass is of no use: beams end there.
    ///
    /// # Errors
    /// If the integrator cannot find this scene's light.
    pub fn run(
        &mut self,
        mut goes_on: impl FnMut(u64, u64) -> bool,
        is_cancelled: &(dyn Fn() -> bool + Sync),
    ) -> Result<Stopped, String> {
        let (mut done, all) = self.steps();
        while done < all {
            if !goes_on(done, all) {
                return Ok(Stopped::Early);
            }
            self.step(is_cancelled)?;
            if let Work::Beams { picture, may_be_cut, .. } = &self.work
                && picture.is_cut()
            {
                if is_cancelled() {
                    return Ok(Stopped::Early);
                }
                if !may_be_cut {
                    return Ok(Stopped::TooManyBeams);
                }
            }
            if matches!(self.work, Work::Bake { .. }) && is_cancelled() {
                return Ok(Stopped::Early);
            }
            done = self.steps().0;
        }
        goes_on(done, all);
        Ok(Stopped::Done)
    }

    /// Steps that are done, and all of them.
    pub fn steps(&self) -> (u64, u64) {
        match &self.work {
            Work::Direct { fluence, .. } => (u64::from(!fluence.is_empty()), 1),
            Work::Photons { picture, packets, .. } => {
                (picture.counts().sent.div_ceil(PACKETS), packets.div_ceil(PACKETS))
            }
            Work::Path { picture, passes } => (picture.passes(), *passes),
            Work::Beams { families, done, .. } => (*done, *families),
            Work::Bake { families, done, .. } => (*done, *families + 1),
        }
    }

    /// What so many steps are, for a sentence.
    pub fn amount(&self, steps: u64) -> String {
        match &self.work {
            Work::Direct { .. } => "one pass".to_string(),
            Work::Photons { picture, pixels, .. } => {
                let sent = picture.counts().sent as f64;
                format!("{:.3} packets a pixel, {:.2} million in all", sent / *pixels as f64, sent * 1e-6)
            }
            Work::Path { picture, .. } => format!("{} directions a pixel", steps * u64::from(picture.directions())),
            Work::Beams { .. } if steps == 1 => "one family of rays".to_string(),
            Work::Beams { .. } => format!("{steps} families of rays"),
            Work::Bake { baking, .. } => format!("{} packets from each lamp", baking.packets()),
        }
    }

    /// Whether what there is is a whole picture, if a noisier one.
    pub fn is_whole(&self) -> bool {
        match (&self.work, self.steps()) {
            (Work::Beams { picture, .. }, (done, all)) => done == all && !picture.is_cut(),
            (Work::Bake { baking, .. }, _) => baking.is_done(),
            (_, (done, _)) => done > 0,
        }
    }

    fn step(&mut self, is_cancelled: &(dyn Fn() -> bool + Sync)) -> Result<(), String> {
        match &mut self.work {
            Work::Direct { scene, view, weights, sampling, fluence } => {
                *fluence = direct::fluence(scene, view, weights, *sampling)?;
            }
            Work::Photons { picture, packets, .. } => {
                let left = *packets - picture.counts().sent;
                picture.expose(left.min(PACKETS));
            }
            Work::Path { picture, .. } => picture.expose(),
            Work::Beams { picture, done, .. } => {
                picture.expose(1, &|| !is_cancelled());
                *done = picture.done() as u64;
            }
            Work::Bake { straight, families, done, baking } => {
                if *done < *families {
                    straight.expose(1, &|| !is_cancelled());
                    *done = straight.done() as u64;
                } else {
                    baking.bake(is_cancelled);
                    *done += 1;
                }
            }
        }
        Ok(())
    }

    /// The fluence in each pixel, row by row, signed.
    pub fn fluence(&self) -> Vec<[f64; 3]> {
        let mut fluence = match &self.work {
            Work::Direct { fluence, .. } => fluence.clone(),
            Work::Photons { picture, .. } => picture.fluence(),
            Work::Path { picture, .. } => picture.fluence(),
            Work::Beams { picture, .. } => picture.fluence(),
            Work::Bake { straight, baking, .. } => baking.added_to(straight.fluence()),
        };
        self.faces.add_to(&mut fluence);
        fluence
    }

    /// The part of the light that was followed no farther, for it had met too many surfaces.
    pub fn given_up(&self) -> f64 {
        match &self.work {
            Work::Photons { picture, .. } => {
                let Counts { sent, given_up, .. } = *picture.counts();
                given_up as f64 / sent.max(1) as f64
            }
            Work::Beams { picture, .. } => picture.given_up(),
            Work::Direct { .. } | Work::Path { .. } | Work::Bake { .. } => 0.0,
        }
    }

    /// How the packets of light have ended, where there were some.
    pub fn counts(&self) -> Option<Counts> {
        match &self.work {
            Work::Photons { picture, .. } => Some(*picture.counts()),
            _ => None,
        }
    }
}
