//! From the colours that people write to light that can be added.

use tracer::Rgb;

/// The linear light of an sRGB colour, each channel 0 to 1 (IEC 61966-2-1).
pub fn linear(srgb: [u8; 3]) -> Rgb {
    srgb.map(linear_channel)
}

/// The linear light of one sRGB channel, 0 to 1.
pub fn linear_channel(value: u8) -> f32 {
    let encoded = f32::from(value) / 255.0;
    if encoded <= 0.04045 { encoded / 12.92 } else { libm::powf((encoded + 0.055) / 1.055, 2.4) }
}
