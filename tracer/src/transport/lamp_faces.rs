//! The faces of lamps: what is seen of a disc from above.
//!
//! A disc of light sends all of its light outwards, so no ray is inside it. What is seen there is its own radiance, alike in all
//! directions: with power P and radius a it is P / (4 pi a), and the fluence 2 pi times that, P / (2 a).

use super::spectrum::Weights;
use super::{LightSource, Scene, SourceForm};
use crate::View;
use geometry::DVec2;
use std::f64::consts::PI;

/// The fluence inside the discs of a scene, in the pixels of a view.
#[derive(Clone, Debug, Default)]
pub struct LampFaces {
    /// Pixels by number, row by row; where discs overlap a pixel is there again.
    pixels: Vec<(usize, [f64; 3])>,
}

impl LampFaces {
    /// Those of a scene, for a screen whose white is that of `weights`.
    pub fn new(scene: &Scene, view: &View, weights: &Weights) -> LampFaces {
        let mut pixels = Vec::new();
        for source in &scene.sources {
            if let SourceForm::Disc { center, radius } = source.form {
                let light = face(source, radius, weights);
                pixels.extend(covered(center, radius, view).map(|(pixel, part)| (pixel, light.map(|of| of * part))));
            }
        }
        LampFaces { pixels }
    }

    /// Adds them to the light of a picture.
    pub fn add_to(&self, fluence: &mut [[f64; 3]]) {
        for (pixel, light) in &self.pixels {
            (0..3).for_each(|channel| fluence[*pixel][channel] += light[channel]);
        }
    }
}

/// The fluence inside a disc; its light fades as it has at the rim.
fn face(source: &LightSource, radius: f64, weights: &Weights) -> [f64; 3] {
    source.color(weights).map(|channel| channel * source.falloff.weight(radius) / (2.0 * radius))
}

/// The pixels that a disc covers, and how much of each: its rim is taken as straight in a pixel.
fn covered(center: DVec2, radius: f64, view: &View) -> impl Iterator<Item = (usize, f64)> {
    let (middle, radius) = (view.screen_from_table(center), radius / view.mm_per_px);
    let whole = (PI * radius * radius).min(1.0);
    let side = |middle: f64, count: usize| {
        let [from, to] = [middle - radius - 1.0, middle + radius + 1.0].map(|edge| edge.clamp(0.0, count as f64));
        from as usize..to.ceil() as usize
    };
    let (columns, width) = (side(middle.x, view.width), view.width);
    side(middle.y, view.height).flat_map(move |y| {
        columns.clone().filter_map(move |x| {
            let distance = middle.distance(DVec2::new(x as f64 + 0.5, y as f64 + 0.5));
            let part = (radius - distance + 0.5).clamp(0.0, 1.0) * whole;
            (part > 0.0).then_some((y * width + x, part))
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::transport::Falloff;
    use crate::transport::spectrum::Emission;

    fn scene(radius: f64) -> Scene {
        let form = SourceForm::Disc { center: DVec2::new(20.3, 14.9), radius };
        let source = LightSource { form, emission: Emission::EqualEnergy, power: 3.0, falloff: Falloff::Plane };
        Scene { bodies: Vec::new(), sources: vec![source] }
    }

    #[test]
    fn a_face_is_as_bright_as_its_radiance_from_all_sides() {
        let view = View::fit(160, 120, DVec2::new(40.0, 30.0));
        let mut fluence = vec![[0.0; 3]; 160 * 120];
        LampFaces::new(&scene(4.0), &view, &Weights::equal_energy()).add_to(&mut fluence);
        let middle = fluence[59 * 160 + 81];
        let expected = scene(4.0).sources[0].form.fluence(DVec2::new(20.3, 14.9)).expect("it is a disc") * 3.0;
        assert!(middle.iter().all(|channel| (channel - expected).abs() < 2e-3 * expected), "{middle:?} {expected}");
        // The sum over the picture is the fluence times the disc's area.
        let sum: f64 = fluence.iter().map(|pixel| pixel[1]).sum::<f64>() * view.mm_per_px * view.mm_per_px;
        let area = PI * 16.0;
        assert!((sum / (expected * area) - 1.0).abs() < 4e-3, "{}", sum / (expected * area));
    }

    #[test]
    fn a_face_beside_the_picture_is_not_in_it() {
        let view = View { origin_mm: DVec2::new(25.0, 0.0), ..View::fit(16, 12, DVec2::new(4.0, 3.0)) };
        assert!(LampFaces::new(&scene(4.0), &view, &Weights::equal_energy()).pixels.is_empty());
    }
}
