//! Chance that a place has: the same at every size of the picture, on every machine.

use geometry::rng::mix32;

/// A hash of a place.
pub(super) fn hash(x: i32, y: i32) -> u32 {
    mix32((x as u32).wrapping_mul(0x9e37_79b1) ^ (y as u32).wrapping_mul(0x85eb_ca77).rotate_left(13))
}

/// A number from 0 to just below 1.
pub(super) fn unit(x: i32, y: i32) -> f32 {
    fraction(hash(x, y))
}

/// Two of them that do not depend on each other.
pub(super) fn pair(x: i32, y: i32) -> [f32; 2] {
    let bits = hash(x, y);
    [fraction(bits), fraction(bits.wrapping_mul(0x2c1b_3c6d) ^ (bits >> 15))]
}

fn fraction(bits: u32) -> f32 {
    // 24 bits are a float's mantissa, so nothing is rounded up to 1.
    (bits >> 8) as f32 * (1.0 / 16_777_216.0)
}

/// Smooth chance, 0 to 1: numbers at whole places with a smoothstep between them.
pub(super) fn smooth(x: f64, y: f64, seed: i32) -> f32 {
    let (column, row) = (x.floor(), y.floor());
    let [u, v] = [x - column, y - row].map(|part| {
        let part = part as f32;
        part * part * (3.0 - 2.0 * part)
    });
    let (column, row) = (column as i32, row as i32);
    let at = |i: i32, j: i32| unit(column.wrapping_add(i) ^ seed, row.wrapping_add(j));
    let top = at(0, 0) + (at(1, 0) - at(0, 0)) * u;
    let bottom = at(0, 1) + (at(1, 1) - at(0, 1)) * u;
    top + (bottom - top) * v
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn chance_is_even() {
        let mut counts = [0; 16];
        for place in 0..16_000 {
            counts[(unit(place % 160, place / 160) * 16.0) as usize] += 1;
        }
        assert!(counts.iter().all(|count| (900..1100).contains(count)), "{counts:?}");
        let together: f32 =
            (0..4000).map(|place| pair(place, 7)).map(|[a, b]| (a - 0.5) * (b - 0.5) * 12.0).sum::<f32>() / 4000.0;
        assert!(together.abs() < 0.05, "{together}");
    }

    #[test]
    fn smooth_chance_has_no_jumps_and_stays_between_0_and_1() {
        let mut before = smooth(-20.0, 3.3, 5);
        for step in 1..4000 {
            let now = smooth(-20.0 + f64::from(step) * 0.01, 3.3, 5);
            assert!((0.0..=1.0).contains(&now) && (now - before).abs() < 0.016, "{before} {now}");
            before = now;
        }
    }
}
