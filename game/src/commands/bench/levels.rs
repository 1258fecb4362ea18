//! How far two pictures of light are from each other on a screen.

use tracer::transport::into_gamut;

/// Light on a screen without dithering, levels of 255.
pub fn levels(light: &[[f64; 3]]) -> Vec<[f32; 3]> {
    let inside = light.iter().map(|color| into_gamut(*color).map(|channel| channel as f32));
    inside.map(|color| tracer::tone_map::displayed(color).map(|channel| channel * 255.0)).collect()
}

/// How two pictures differ, levels of 255.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Difference {
    /// The most in any channel, rounded up.
    pub most: u8,
    /// The root mean square over all channels.
    pub rms: f64,
    /// Pixels that differ by more than one level.
    pub pixels: usize,
}

/// The difference between two pictures of the same size.
pub fn apart(one: &[[f32; 3]], other: &[[f32; 3]]) -> Difference {
    let (mut most, mut square, mut pixels) = (0.0_f32, 0.0, 0);
    for (one, other) in one.iter().zip(other) {
        let apart = [0, 1, 2].map(|channel| (one[channel] - other[channel]).abs());
        let largest = apart.into_iter().fold(0.0, f32::max);
        most = most.max(largest);
        pixels += usize::from(largest > 1.0);
        square += apart.iter().map(|apart| f64::from(apart * apart)).sum::<f64>();
    }
    let rms = (square / (3 * one.len()).max(1) as f64).sqrt();
    Difference { most: most.ceil() as u8, rms, pixels }
}
