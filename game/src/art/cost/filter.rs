//! What a filter takes: passes over its region, one primitive after the other, whose results are all kept.

use super::Counter;
use super::area::Area;
use crate::Failure;
use resvg::usvg::Transform;
use resvg::usvg::filter::{Filter, Kind, Primitive};

/// Passes of any primitive: its inputs are copied, and go from one colour space into another and back.
const INPUTS: f64 = 12.0;
/// Passes of a blur, whatever its radius.
const BLUR: f64 = 120.0;
/// Operations of an octave of noise for the four channels of a pixel.
const OCTAVE: f64 = 80.0;
/// Passes of light on a relief.
const LIGHTING: f64 = 40.0;
/// Operations for a pixel of a convolution's matrix.
const CONVOLVED: f64 = 8.0;
/// Operations for a pixel that is looked at by a dilation.
const DILATED: f64 = 4.0;
/// Passes of a tile, which is sampled as a pattern is.
const TILED: f64 = 24.0;

impl Counter<'_> {
    pub(super) fn filter(&mut self, filter: &Filter, transform: Transform, layer: Area) -> Result<(), Failure> {
        let region = Area::transformed(&filter.rect().to_rect(), transform);
        if !self.layers.holds(&region) {
            return Err(self.tally.filter_too_large(filter.id()));
        }
        // The library takes the larger of both: what it reads is the layer, what it makes is the region.
        let pixels = region.rounded_out().pixels().max(layer.pixels());
        let held = pixels * (filter.primitives().len() as f64 + 2.0);
        self.tally.hold(held);
        for primitive in filter.primitives() {
            self.near(Area::transformed(&primitive.rect().to_rect(), transform))?;
            self.tally.spend(pixels * passes(primitive, transform, &region));
            if let Kind::Image(image) = primitive.kind() {
                self.children(image.root(), transform, region)?;
            }
        }
        self.tally.release(held);
        Ok(())
    }
}

/// How often a primitive goes over all pixels.
fn passes(primitive: &Primitive, transform: Transform, region: &Area) -> f64 {
    let (x, y) = transform.get_scale();
    // No side of a dilation is longer than the picture.
    let side = |radius: f32, scale: f32, most: f64| (2.0 * (f64::from(radius) * f64::from(scale)).ceil()).min(most);
    let own = match primitive.kind() {
        Kind::GaussianBlur(_) | Kind::DropShadow(_) => BLUR,
        Kind::Turbulence(noise) => OCTAVE * f64::from(noise.num_octaves()),
        Kind::Morphology(own) => {
            let columns = side(own.radius_x().get(), x, region.width() + 2.0);
            DILATED * columns * side(own.radius_y().get(), y, region.height() + 2.0)
        }
        Kind::ConvolveMatrix(own) => CONVOLVED * f64::from(own.matrix().columns()) * f64::from(own.matrix().rows()),
        Kind::DiffuseLighting(_) | Kind::SpecularLighting(_) => LIGHTING,
        Kind::Merge(merge) => INPUTS * merge.inputs().len() as f64,
        Kind::Tile(_) => TILED,
        _ => 0.0,
    };
    INPUTS + own
}
