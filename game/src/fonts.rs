//! The fonts, built in.

/// The fonts of `assets/fonts`, built in: a picture must be the same on every machine, so neither the system's fonts
/// nor a file that may be missing are read.
pub const FONTS: [(&str, &[u8]); 4] = [
    ("Cinzel-SemiBold.ttf", include_bytes!("../../assets/fonts/Cinzel-SemiBold.ttf")),
    ("Marcellus-Regular.ttf", include_bytes!("../../assets/fonts/Marcellus-Regular.ttf")),
    ("Oxanium-Bold.ttf", include_bytes!("../../assets/fonts/Oxanium-Bold.ttf")),
    ("Oxanium-Regular.ttf", include_bytes!("../../assets/fonts/Oxanium-Regular.ttf")),
];
