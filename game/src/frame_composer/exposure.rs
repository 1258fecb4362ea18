//! Exposure: the factor from the table's light to the light that is tone-mapped: less where the table has been bright for a while, more in the dark.
//!
//! A function of what the snapshot says of the light that eyes have got used to ([`crate::lamps::ExposureAdaptation`]), so that a
//! frame is the same whoever draws it.

/// The exposure of usual light, stops: a quarter below 1 keeps the lamps' colours, and leaves the night dark.
const USUAL_STOPS: f32 = -0.25;
/// How much of a change of light is taken back: half of it, so that a lamp that goes out still makes the table darker.
const PART: f32 = 0.5;
/// The farthest from that, stops.
const MOST_STOPS: f32 = 0.7;
/// Steps in a stop: a thirty-second of a stop is about an 8-bit level, and a table that hardly changes is not tone-mapped
/// again.
const STEPS: f32 = 32.0;

/// The factor from the table's light to the light that is tone-mapped, where eyes are used to `light` times what is usual.
pub fn exposure(light: f32) -> f32 {
    let stops = (-PART * libm::log2f(light.max(1e-6))).clamp(-MOST_STOPS, MOST_STOPS);
    libm::exp2f(USUAL_STOPS + (stops * STEPS).round() / STEPS)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_more_light_less_is_taken() {
        assert_eq!(exposure(1.0), libm::exp2f(USUAL_STOPS));
        assert_eq!(exposure(2.0), libm::exp2f(USUAL_STOPS - 0.5));
        assert_eq!(exposure(0.5), libm::exp2f(USUAL_STOPS + 0.5));
    }

    #[test]
    fn it_stays_within_its_bounds_whatever_the_light() {
        for light in [0.0, -1.0, 1e-30, 1e30, f32::INFINITY, f32::NAN] {
            let stops = libm::log2f(exposure(light)) - USUAL_STOPS;
            assert!(stops.abs() <= MOST_STOPS + 0.02, "{light}: {stops}");
        }
    }

    #[test]
    fn a_hair_more_light_changes_nothing() {
        assert_eq!(exposure(1.0), exposure(1.01));
    }
}
