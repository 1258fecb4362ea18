//! Light that is spread over a row: up to three boxes, folded with each other.

/// A narrower box than this is none, pixels.
const NARROW: f64 = 1e-3;

/// The widest box is no narrower than this, pixels: light that crosses itself in a point is spread over it.
const NARROWEST: f64 = 1.0 / 64.0;

/// Unit light spread over the folding of boxes round `middle`: one is a box, two a trapezoid, three a smooth hill.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spread {
    middle: f64,
    /// From the widest on; 0 where there is none.
    widths: [f64; 3],
}

impl Spread {
    /// The folding of boxes of these widths, of any sign.
    pub fn new(middle: f64, widths: [f64; 3]) -> Spread {
        let mut widths = widths.map(f64::abs);
        widths.sort_unstable_by(|a, b| b.total_cmp(a));
        let [wide, second, third] = widths;
        let or_none = |width: f64| if width < NARROW { 0.0 } else { width };
        Spread { middle, widths: [wide.max(NARROWEST), or_none(second), or_none(third)] }
    }

    /// Where it begins and ends.
    pub fn ends(&self) -> [f64; 2] {
        let half = 0.5 * self.widths.iter().sum::<f64>();
        [self.middle - half, self.middle + half]
    }

    /// The part to the left of `place`, 0 to 1.
    ///
    /// Of k boxes with the widths w it is the sum over all signs s of `prod(s) max(x + s.w / 2, 0)^k / (k! prod(w))`.
    pub fn left_of(&self, place: f64) -> f64 {
        let x = place - self.middle;
        let [a, b, c] = self.widths.map(|width| 0.5 * width);
        if x >= a + b + c {
            return 1.0;
        }
        let part = if b == 0.0 {
            0.5 * x / a + 0.5
        } else if c == 0.0 {
            let ramp = |at: f64| (x + at).max(0.0) * (x + at).max(0.0);
            (ramp(a + b) - ramp(a - b) - ramp(b - a) + ramp(-a - b)) / (8.0 * a * b)
        } else {
            let ramp = |at: f64| {
                let over = (x + at).max(0.0);
                over * over * over
            };
            let even = ramp(a + b + c) + ramp(a - b - c) + ramp(b - a - c) + ramp(c - a - b);
            let odd = ramp(a + b - c) + ramp(a + c - b) + ramp(b + c - a) + ramp(-a - b - c);
            (even - odd) / (48.0 * a * b * c)
        };
        part.clamp(0.0, 1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const FORMS: [[f64; 3]; 7] = [
        [4.0, 1.0, 0.0],
        [1.0, -4.0, 0.5],
        [3.0, 3.0, 3.0],
        [0.2, 0.0, 0.0],
        [0.0, 0.0, 0.0],
        [50.0, 0.01, 1.0],
        [1.0, 0.7, 0.002],
    ];

    #[test]
    fn it_holds_one_in_all_and_is_even() {
        for widths in FORMS {
            let spread = Spread::new(10.0, widths);
            let [begin, end] = spread.ends();
            assert!(spread.left_of(begin) < 1e-9 && spread.left_of(end) > 1.0 - 1e-9);
            assert!((spread.left_of(10.0) - 0.5).abs() < 1e-9, "{widths:?}");
            let mut before = 0.0;
            for step in 0..200 {
                let away = f64::from(step) * 0.05;
                let sum = spread.left_of(10.0 - away) + spread.left_of(10.0 + away);
                assert!((sum - 1.0).abs() < 1e-9, "{widths:?} {away}: {sum}");
                let left = spread.left_of(f64::from(step) * 0.1);
                assert!(left >= before - 1e-9, "it never falls");
                before = left;
            }
        }
    }

    /// A box of width 4 folded with one of width 2: flat over 2 with height 1/4.
    #[test]
    fn the_middle_of_two_boxes_is_flat() {
        let spread = Spread::new(0.0, [4.0, 2.0, 0.0]);
        assert!((spread.left_of(1.0) - spread.left_of(0.0) - 0.25).abs() < 1e-12);
        assert!((spread.left_of(-1.0) - 0.25).abs() < 1e-12);
        assert!((spread.left_of(-2.0) - 0.0625).abs() < 1e-12);
    }

    /// Beams on a diagonal were up to 3 % too bright: of three boxes the narrowest was folded by its variance alone.
    #[test]
    fn three_boxes_are_counted_as_they_fall() {
        for widths in [[1.0, 0.7, 0.3], [2.0, 2.0, 1.0], [5.0, 0.1, 1.0]] {
            let spread = Spread::new(0.0, widths);
            let side = 60;
            let at = |step: i32| (f64::from(step) + 0.5) / f64::from(side) - 0.5;
            for place in [-1.1, -0.4, 0.0, 0.3, 0.9] {
                let mut left = 0;
                for cell in 0..side * side * side {
                    let x = widths[0] * at(cell % side)
                        + widths[1] * at(cell / side % side)
                        + widths[2] * at(cell / side / side);
                    left += i32::from(x < place);
                }
                let counted = f64::from(left) / f64::from(side * side * side);
                assert!((counted - spread.left_of(place)).abs() < 0.01, "{widths:?} {place}: {counted}");
            }
        }
    }
}
