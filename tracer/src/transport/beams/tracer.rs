//! A scene, ready for the beam sweep.

use super::corner::Corner;
use super::family::{Family, families};
use super::landmarks::Landmarks;
use crate::transport::spectrum::Weights;
use crate::transport::{LightSource, Material, Media, Scene, StartsOn, Surfaces, TOLERANCE_MM};

/// How fine a sweep is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BeamOptions {
    /// Beams of each family to begin with.
    pub beams: u32,
    /// Strata of the wavelengths, if they matter.
    pub wavelengths: u32,
    /// Strata of the width of wide sources.
    pub widths: u32,
    /// Surfaces that a beam meets at most.
    pub most_surfaces: u32,
    /// Of its family's power, what a branch must have to be followed.
    pub least_power: f64,
    /// Straight pieces of beams of one family at most: among many curved glasses beams are halved without end, and photons are
    /// the better way. What is beyond is left out, and [`super::BeamPicture::is_cut`] says so.
    pub most_pieces: u64,
}

impl Default for BeamOptions {
    fn default() -> BeamOptions {
        BeamOptions {
            beams: 64,
            wavelengths: 32,
            widths: 4,
            most_surfaces: 256,
            least_power: 1e-3,
            most_pieces: u64::MAX,
        }
    }
}

/// A scene, ready for beams.
pub struct BeamTracer<'a> {
    pub(super) surfaces: Surfaces,
    pub(super) landmarks: Landmarks,
    pub(super) families: Vec<(Family<'a>, Media)>,
    pub(super) options: BeamOptions,
}

impl<'a> BeamTracer<'a> {
    /// The tracer of a scene, for a screen whose white is that of `weights`.
    pub fn new(scene: &'a Scene, weights: &Weights, options: BeamOptions) -> BeamTracer<'a> {
        let surfaces = Surfaces::new(&scene.bodies, TOLERANCE_MM);
        let chromatic = scene.bodies.iter().any(|body| body.band.is_some() || is_chromatic(&body.material));
        let of = |source: &'a LightSource| {
            let media = surfaces.media_at(source.form.middle()).into_iter().filter(|body| surfaces.absorbs(*body));
            let media = Media::of(media);
            families(source, weights, chromatic, [options.wavelengths, options.widths], media.is_empty())
                .into_iter()
                .map(move |family| (family, media))
        };
        let families: Vec<(Family, Media)> =
            scene.sources.iter().filter(|source| source.power > 0.0).flat_map(of).collect();
        let landmarks = Landmarks::new(&scene.bodies);
        BeamTracer { surfaces, landmarks, families, options }
    }

    /// The same with another limit of pieces of one family.
    pub fn with_most_pieces(mut self, most_pieces: u64) -> BeamTracer<'a> {
        self.options.most_pieces = most_pieces;
        self
    }

    /// How many families there are: tasks for [`super::BeamPicture::expose`].
    pub fn tasks(&self) -> usize {
        self.families.len()
    }

    /// The ray of a family at u and v, where it leaves the source.
    pub(super) fn start(&self, family: &Family, media: Media, [u, v]: [f64; 2]) -> Corner {
        let (ray, nm) = family.ray(u, v);
        let way = family.source.form.head_start(&ray);
        Corner { ray, starts_on: StartsOn::NOTHING, nm, power: [0.5; 2], way, media }
    }
}

/// Whether light of different wavelengths fares differently.
fn is_chromatic(material: &Material) -> bool {
    let colored = |color: &[f64; 3]| color[0] != color[1] || color[1] != color[2];
    match material {
        Material::Mirror { reflectance, .. } => colored(reflectance),
        Material::Metal { .. } => true,
        Material::Dielectric(glass) => !glass.dispersion.is_constant() || colored(&glass.transmittance_per_mm),
        _ => false,
    }
}
