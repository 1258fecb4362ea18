//! A bake as bytes: a name, a version, a check over all that follows, and the light.

use super::cells::Cells;
use super::{Bake, BakeOptions};
use crate::transport::spectrum::Weights;
use crate::transport::{Scene, Surfaces, TOLERANCE_MM};
use serde::{Deserialize, Serialize};
use xxhash_rust::xxh3::xxh3_64;

/// What the bytes begin with.
const MAGIC: &[u8; 8] = b"CSTCBAKE";

/// Goes up when the bytes, or the light that the same options make, change.
const VERSION: u32 = 1;

/// Name, version, check.
const HEADER: usize = 8 + 4 + 8;

/// What is kept; cells and surfaces are those of the scene.
#[derive(Serialize, Deserialize)]
struct Kept {
    options: BakeOptions,
    fingerprint: u64,
    lamps: u64,
    light: Vec<f32>,
}

/// A number that says which scene a bake is of: all that is written of it, to the last bit of each number, and the screen's
/// white.
pub(super) fn fingerprint(scene: &Scene, weights: &Weights) -> u64 {
    xxh3_64(format!("{scene:?}{weights:?}").as_bytes())
}

impl Bake {
    /// The bake as bytes.
    pub fn to_bytes(&self) -> Vec<u8> {
        let Bake { options, fingerprint, lamps, light, .. } = self;
        let kept = Kept { options: *options, fingerprint: *fingerprint, lamps: *lamps as u64, light: light.clone() };
        // Into memory, of plain numbers: it has no way to fail.
        let body = postcard::to_stdvec(&kept).unwrap_or_default();
        let mut bytes = Vec::with_capacity(HEADER + body.len());
        bytes.extend(MAGIC);
        bytes.extend(VERSION.to_le_bytes());
        bytes.extend(xxh3_64(&body).to_le_bytes());
        bytes.extend(body);
        bytes
    }

    /// The bake of a scene from its bytes.
    ///
    /// # Errors
    /// A sentence, if they are no bake, are damaged, are of another version, or of another scene or white.
    pub fn from_bytes(bytes: &[u8], scene: &Scene, weights: &Weights) -> Result<Bake, String> {
        let damaged = || "the baked light is damaged".to_string();
        let Some((header, body)) = bytes.split_at_checked(HEADER) else { return Err(damaged()) };
        if header[..8] != *MAGIC {
            return Err("this is not baked light".to_string());
        }
        let version = u32::from_le_bytes([header[8], header[9], header[10], header[11]]);
        if version != VERSION {
            return Err(format!("the baked light has version {version}; this program reads version {VERSION}"));
        }
        if xxh3_64(body).to_le_bytes() != header[12..] {
            return Err(damaged());
        }
        let kept: Kept = postcard::from_bytes(body).map_err(|_| damaged())?;
        if kept.fingerprint != fingerprint(scene, weights) {
            return Err("the baked light is that of another scene".to_string());
        }
        let lamps = scene.sources.len();
        let surfaces = Surfaces::new(&scene.bodies, TOLERANCE_MM);
        let cells = Cells::new(&surfaces, &kept.options.region, kept.options.cell_mm);
        if kept.lamps != lamps as u64 || kept.light.len() != cells.nodes().len() * lamps * 3 {
            return Err(damaged());
        }
        let Kept { options, fingerprint, light, .. } = kept;
        Ok(Bake { options, fingerprint, lamps, light, surfaces, cells })
    }
}
