//! The gamut of a screen: colours that it cannot show, as the nearest of the same luminance that it can.

/// The luminance of linear sRGB: ITU-R BT.709.
const LUMINANCE: [f64; 3] = [0.2126, 0.7152, 0.0722];

/// The luminance of a linear colour.
pub fn luminance(color: [f64; 3]) -> f64 {
    (0..3).map(|channel| LUMINANCE[channel] * color[channel]).sum()
}

/// A colour without negative channels: mixed with grey of its own luminance until the least channel is 0. Light that comes to no
/// luminance is black.
///
/// With Y the luminance and m the least channel, `c' = Y + k (c - Y)` and `k = Y / (Y - m)`. Wavelengths are summed up signed
/// before: brought into the gamut one by one, equal energy would be 37 % too red.
pub fn into_gamut(color: [f64; 3]) -> [f64; 3] {
    let luminance = luminance(color);
    let least = color[0].min(color[1]).min(color[2]);
    if least >= 0.0 {
        return color;
    }
    if luminance <= 0.0 || !luminance.is_finite() {
        return [0.0; 3];
    }
    let kept = luminance / (luminance - least);
    // Rounding must not leave what was cut.
    color.map(|channel| (luminance + kept * (channel - luminance)).max(0.0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::transport::spectrum::Weights;

    #[test]
    fn every_wavelength_comes_into_the_gamut_with_its_luminance() {
        let weights = Weights::equal_energy();
        for nm in 390..770 {
            let color = weights.at(f64::from(nm)).map(f64::from);
            let shown = into_gamut(color);
            assert!(shown.iter().all(|channel| *channel >= 0.0), "{nm}: {shown:?}");
            let (before, after) = (luminance(color), luminance(shown));
            assert!((before - after).abs() <= 1e-9 + 1e-9 * before, "{nm}: {before} {after}");
        }
        assert_eq!(into_gamut([0.2, 0.5, 0.9]), [0.2, 0.5, 0.9]);
        assert_eq!(into_gamut([0.1, -0.9, 0.1]), [0.0; 3]);
    }

    /// Clamping each wavelength by itself makes white 37 % too red.
    #[test]
    fn wavelengths_are_summed_up_before_they_are_cut() {
        let weights = Weights::equal_energy();
        let mut sums = ([0.0; 3], [0.0; 3]);
        for nm in 380..780 {
            let color = weights.at(f64::from(nm) + 0.5).map(f64::from);
            for channel in 0..3 {
                sums.0[channel] += color[channel] / 400.0;
                sums.1[channel] += color[channel].max(0.0) / 400.0;
            }
        }
        let white = into_gamut(sums.0);
        assert!(white.iter().all(|channel| (channel - 1.0).abs() < 1e-4), "{white:?}");
        assert!(sums.1[0] / sums.1[2] > 1.2, "{:?}", sums.1);
    }
}
