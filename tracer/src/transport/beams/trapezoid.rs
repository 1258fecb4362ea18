//! A box folded with a box: how much of it lies to the left of a place.

/// The narrower box is nothing below this width, pixels.
const NARROW: f64 = 1e-3;

/// No box is narrower than this, pixels: light that crosses itself in a point is spread over it.
const NARROWEST: f64 = 1.0 / 64.0;

/// Unit light spread over two boxes' folding, round `middle`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trapezoid {
    middle: f64,
    /// The wider box.
    wide: f64,
    /// The narrower one, 0 if it is nothing.
    narrow: f64,
}

impl Trapezoid {
    /// The folding of boxes of these widths, of any sign.
    pub fn new(middle: f64, a: f64, b: f64) -> Trapezoid {
        let (a, b) = (a.abs(), b.abs());
        let (wide, narrow) = if a > b { (a, b) } else { (b, a) };
        Trapezoid { middle, wide: wide.max(NARROWEST), narrow: if narrow < NARROW { 0.0 } else { narrow } }
    }

    /// Where it begins and ends.
    pub fn ends(&self) -> [f64; 2] {
        let half = 0.5 * (self.wide + self.narrow);
        [self.middle - half, self.middle + half]
    }

    /// The part to the left of `place`, 0 to 1.
    pub fn left_of(&self, place: f64) -> f64 {
        let x = place - self.middle;
        let Trapezoid { wide, narrow, .. } = *self;
        if narrow == 0.0 {
            return (x / wide + 0.5).clamp(0.0, 1.0);
        }
        // The integral of the trapezoid's four ramps.
        let ramp = |at: f64| 0.5 * (x - at).max(0.0) * (x - at).max(0.0);
        let (outer, inner) = (0.5 * (wide + narrow), 0.5 * (wide - narrow));
        if x >= outer {
            return 1.0;
        }
        ((ramp(-outer) - ramp(-inner) - ramp(inner) + ramp(outer)) / (wide * narrow)).clamp(0.0, 1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_holds_one_in_all_and_is_even() {
        for (a, b) in [(4.0, 1.0), (1.0, -4.0), (3.0, 3.0), (0.2, 0.0), (0.0, 0.0), (50.0, 0.01)] {
            let trapezoid = Trapezoid::new(10.0, a, b);
            let [begin, end] = trapezoid.ends();
            assert!(trapezoid.left_of(begin) < 1e-12);
            assert!(trapezoid.left_of(end) > 1.0 - 1e-12);
            assert!((trapezoid.left_of(10.0) - 0.5).abs() < 1e-12, "{a} {b}");
            for step in 0..100 {
                let away = f64::from(step) * 0.05;
                let sum = trapezoid.left_of(10.0 - away) + trapezoid.left_of(10.0 + away);
                assert!((sum - 1.0).abs() < 1e-12, "{a} {b} {away}: {sum}");
            }
        }
    }

    /// A box of width 4 folded with one of width 2: flat over 2 with height 1/4.
    #[test]
    fn its_middle_is_flat() {
        let trapezoid = Trapezoid::new(0.0, 4.0, 2.0);
        assert!((trapezoid.left_of(1.0) - trapezoid.left_of(0.0) - 0.25).abs() < 1e-12);
        assert!((trapezoid.left_of(-1.0) - 0.25).abs() < 1e-12);
        assert!((trapezoid.left_of(-2.0) - 0.0625).abs() < 1e-12);
    }
}
