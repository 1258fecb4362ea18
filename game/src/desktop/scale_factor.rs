//! The scale factor that the environment asks for, checked before winit reads it: winit panics at one that is none.
//!
//! All sizes in this room are pixels, so no scale that winit takes changes what is drawn.

use crate::Failure;
use std::ffi::OsStr;

/// The variable that winit reads.
pub const VARIABLE: &str = "WINIT_X11_SCALE_FACTOR";

/// Whether winit takes what the variable says.
///
/// # Errors
/// If it is neither `randr` nor a number above 0.
pub fn check(value: Option<&OsStr>) -> Result<(), Failure> {
    // What is not Unicode winit reads as not set.
    let Some(value) = value.and_then(OsStr::to_str) else { return Ok(()) };
    let is_scale = value.parse::<f64>().is_ok_and(|scale| scale.is_normal() && scale > 0.0);
    if value.is_empty() || value.eq_ignore_ascii_case("randr") || is_scale {
        return Ok(());
    }
    let shown = value.escape_debug();
    Err(Failure::new(format!("{VARIABLE} is \"{shown}\", which is no scale: set it to a number above 0, or unset it")))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// `WINIT_X11_SCALE_FACTOR=nan caustic play` panicked in winit.
    #[test]
    fn what_is_no_scale_is_told_before_winit_panics_at_it() {
        for scale in ["nan", "0", "-0", "-1", "inf", "1e-320", "1e999", "abc", " 1", "1,5", "\u{1b}[2J"] {
            let failure = check(Some(OsStr::new(scale))).expect_err(scale).to_string();
            assert!(failure.starts_with(VARIABLE) && !failure.contains('\u{1b}'), "{failure}");
        }
        for scale in ["", "1", "1.5", "2e0", "1e9", "1e-300", "randr", "RandR"] {
            assert!(check(Some(OsStr::new(scale))).is_ok(), "{scale}");
        }
        assert!(check(None).is_ok());
    }
}
