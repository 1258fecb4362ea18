//! The film of beams: second differences of what they leave in each row and in each column of pixels.
//!
//! Across a row a beam's light is a trapezoid. Its second difference is zero but at its four corners, so laying a beam costs the
//! same however wide it is, and two running sums over all rows at the end give every pixel (F. Crow, "Summed-area tables for
//! texture mapping", SIGGRAPH 1984, turned round). Places are 1/256 pixel and all sums are whole numbers: a trapezoid closes
//! exactly, in any order, where floating point would leave a streak up to the row's end.
//!
//! A beam crosses rows one after the other at almost the same place, so what is side by side in memory is a place's rows.

use rayon::prelude::*;

/// Units of a place in a pixel.
const PER_PX: f64 = 256.0;

/// Bits behind the point of a pixel's sum. All beams of a film together have light 1; one pixel may be crossed some fifty times by all of
/// them.
const BITS: u32 = 56;

/// Pixels behind a row's end, which corners there fall into.
const SLACK: usize = 2;

/// Places farther out than this are there, units.
const FARTHEST: f64 = (1_u64 << 36) as f64;

/// The axis along which a trapezoid lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Along {
    /// A row of pixels: the beam crosses rows more squarely than columns.
    Row,
    /// A column.
    Column,
}

/// The sums of a picture's pixels, for light of one colour.
#[derive(Clone, Debug)]
pub struct BeamFilm {
    width: usize,
    height: usize,
    /// Of each pixel of a row and its slack, all rows.
    rows: Vec<i64>,
    /// The same of each pixel of a column.
    columns: Vec<i64>,
    /// Whether anything lies on it.
    is_black: bool,
}

/// Light spread evenly over a row from one end to the other, and each end over a box of its own round it, pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trapezoid {
    /// Its ends: in the other order where the beam has crossed itself.
    pub ends: [f64; 2],
    /// The widths of their boxes, of any sign; they differ by no more than twice the distance of the ends, or it is negative in
    /// places.
    pub blurs: [f64; 2],
}

impl BeamFilm {
    /// A black film.
    pub fn new(width: usize, height: usize) -> BeamFilm {
        let rows = vec![0; (width + SLACK) * height];
        let columns = vec![0; (height + SLACK) * width];
        BeamFilm { width, height, rows, columns, is_black: true }
    }

    /// Takes all light from it.
    pub fn clear(&mut self) {
        if !self.is_black {
            self.rows.fill(0);
            self.columns.fill(0);
            self.is_black = true;
        }
    }

    /// Its memory, bytes.
    pub fn bytes(&self) -> usize {
        size_of_val(&self.rows[..]) + size_of_val(&self.columns[..])
    }

    /// Pixels across and down.
    pub fn size(&self) -> [usize; 2] {
        [self.width, self.height]
    }

    /// Adds light to a row (or column) of this number.
    pub fn lay(&mut self, along: Along, number: usize, light: f64, trapezoid: &Trapezoid) {
        let (length, count, sums) = match along {
            Along::Row => (self.width, self.height, &mut self.rows),
            Along::Column => (self.height, self.width, &mut self.columns),
        };
        let places = trapezoid.corners();
        let last = PER_PX as i64 * length as i64;
        if places[0] >= last || places[3] <= 0 {
            return;
        }
        self.is_black = false;
        let [low, high] = [places[1] - places[0], places[3] - places[2]];
        // The slope at which a unit's corner gives twice the area under its ramp.
        let twice_width = places[2] + places[3] - places[0] - places[1];
        let scale = (1_u64 << BITS) as f64 / (low as f64 * twice_width as f64);
        let rounding = rounding(&places, number);
        let rise = floor(light * scale + rounding);
        add_ramp(sums, [count, length], number, places[0], rise);
        add_ramp(sums, [count, length], number, places[1], -rise);
        if low == high {
            add_ramp(sums, [count, length], number, places[2], -rise);
            add_ramp(sums, [count, length], number, places[3], rise);
            return;
        }
        // What is left where the other slope has come down in whole numbers falls within the last unit.
        let rounding = self::rounding(&[places[2], 0, 0, places[1]], number);
        let fall = floor((rise * low) as f64 / high as f64 + rounding);
        let rest = rise * low - fall * high;
        add_ramp(sums, [count, length], number, places[2], -fall);
        add_ramp(sums, [count, length], number, places[3], fall - rest);
        add_ramp(sums, [count, length], number, places[3] + 1, rest);
    }

    /// Adds the light on all these films of one size together, times `color`, to the light in each pixel, row by row.
    pub fn develop(films: &[&BeamFilm], color: [f64; 3], pixels: &mut [[f64; 3]]) {
        let films: Vec<&&BeamFilm> = films.iter().filter(|film| !film.is_black).collect();
        let Some(BeamFilm { width, height, .. }) = films.first() else { return };
        let of_rows: Vec<&[i64]> = films.iter().map(|film| &film.rows[..]).collect();
        let of_columns: Vec<&[i64]> = films.iter().map(|film| &film.columns[..]).collect();
        let unit = 1.0 / (1_u64 << BITS) as f64;
        let columns = sums(&of_columns, *height, *width);
        let rows = sums(&of_rows, *width, *height);
        pixels.par_chunks_exact_mut(*width).enumerate().with_min_len(STRIP / 4).for_each(|(y, pixels)| {
            let (row, in_row) = (&rows[y / STRIP][y % STRIP..], strip(*height, y));
            for (x, pixel) in pixels.iter_mut().enumerate() {
                let column = columns[x / STRIP][y * strip(*width, x) + x % STRIP];
                let light = row[x * in_row].wrapping_add(column) as f64 * unit;
                (0..3).for_each(|channel: usize| pixel[channel] += color[channel] * light);
            }
        });
    }
}

/// Rows whose sums are made side by side.
const STRIP: usize = 64;

/// How many rows the strip has in which this one lies.
fn strip(count: usize, row: usize) -> usize {
    STRIP.min(count - row / STRIP * STRIP)
}

impl Trapezoid {
    /// Its corners, units: where its light rises from and to, and where it falls. No slope and no width is less than a unit.
    fn corners(&self) -> [i64; 4] {
        let unit = |place: f64| floor((place * PER_PX).clamp(-FARTHEST, FARTHEST) + 0.5);
        let is_turned = self.ends[0] > self.ends[1];
        let [left, right] = if is_turned { [1, 0] } else { [0, 1] };
        let slope = |end: usize| {
            let blur = unit(self.blurs[end].abs()).max(1);
            let first = unit(self.ends[end]) - blur / 2;
            [first, first + blur]
        };
        let ([a, b], [c, d]) = (slope(left), slope(right));
        let narrow = (2 - (c + d - a - b)).max(0);
        let narrow = narrow / 2 + narrow % 2;
        [a, b, c + narrow, d + narrow]
    }
}

/// The greatest whole number that is no more.
fn floor(value: f64) -> i64 {
    let cut = value as i64;
    cut - i64::from(cut as f64 > value)
}

/// What is added before a height is cut to a whole number, 0 to 1: of wide, weak trapezoids heights are few units, and rounding all
/// of them alike would lose or add light.
fn rounding(places: &[i64; 4], number: usize) -> f64 {
    let mixed = (places[0] ^ places[3].rotate_left(32)) as u64 ^ (number as u64) << 16;
    let mixed = mixed.wrapping_mul(0x9E37_79B9_7F4A_7C15);
    let mixed = (mixed ^ mixed >> 32).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    (mixed >> 11) as f64 / (1_u64 << 53) as f64
}

/// Adds the second difference of a ramp that rises by `height` a unit from `place` on, each pixel holding twice its area under it.
///
/// With g units from the place to its pixel's end, that pixel has g^2, the next one (256 + g)^2 - g^2, and each further one
/// 2 * 256^2 more than the one before: the differences of the differences are the three below.
fn add_ramp(sums: &mut [i64], [count, length]: [usize; 2], number: usize, place: i64, height: i64) {
    let pixel = place >> 8;
    if pixel >= length as i64 {
        return;
    }
    let (at, parts) = if pixel >= 0 {
        let rest = 256 - (place & 255);
        (pixel as usize, [rest * rest, 65_536 + 512 * rest - 2 * rest * rest, (256 - rest) * (256 - rest)])
    } else {
        // All of the row is on the slope: its first pixel's value, and the rise.
        let first = 512 * (128 - place);
        (0, [first, 131_072 - first, 0])
    };
    for (step, part) in parts.into_iter().enumerate() {
        // What is far too high on the way is taken back by the other corners: sums are right to 64 bits in the end.
        let sum = &mut sums[(at + step) * count + number];
        *sum = sum.wrapping_add(height.wrapping_mul(part));
    }
}

/// The values of `count` rows from the second differences of all films, strip by strip; in a strip what is side by side is a place's
/// rows.
fn sums(films: &[&[i64]], length: usize, count: usize) -> Vec<Vec<i64>> {
    let of_strip = |first: usize| {
        let rows = strip(count, first);
        let (mut slopes, mut running) = (vec![0_i64; rows], vec![0_i64; rows]);
        let mut values = Vec::with_capacity(length * rows);
        for at in 0..length {
            let differences = films.iter().map(|film| &film[at * count + first..][..rows]);
            for differences in differences {
                for (slope, difference) in slopes.iter_mut().zip(differences) {
                    *slope = slope.wrapping_add(*difference);
                }
            }
            for (value, slope) in running.iter_mut().zip(&slopes) {
                *value = value.wrapping_add(*slope);
            }
            values.extend_from_slice(&running);
        }
        values
    };
    (0..count).into_par_iter().step_by(STRIP).map(of_strip).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The part of a trapezoid's light to the left of a place: the ramp of each end's box, clamped, integrated.
    fn left_of(trapezoid: &Trapezoid, place: f64) -> f64 {
        let Trapezoid { mut ends, mut blurs } = *trapezoid;
        if ends[0] > ends[1] {
            (ends, blurs) = ([ends[1], ends[0]], [blurs[1], blurs[0]]);
        }
        ends[1] = ends[1].max(ends[0] + 1e-6);
        let integral = |end: usize| {
            let blur = blurs[end].abs().max(1e-6);
            let parts = (place - ends[end]) / blur + 0.5;
            blur * if parts < 1.0 { 0.5 * parts.max(0.0) * parts.max(0.0) } else { parts - 0.5 }
        };
        (integral(0) - integral(1)) / (ends[1] - ends[0])
    }

    fn pixels(film: &BeamFilm) -> Vec<f64> {
        let mut pixels = vec![[0.0; 3]; film.width * film.height];
        BeamFilm::develop(&[film], [1.0; 3], &mut pixels);
        pixels.into_iter().map(|pixel| pixel[0]).collect()
    }

    const fn form(begin: f64, end: f64, blurs: [f64; 2]) -> Trapezoid {
        Trapezoid { ends: [begin, end], blurs }
    }

    const FORMS: [Trapezoid; 13] = [
        form(3.3, 9.1, [2.0, 2.0]),
        form(9.1, 3.3, [-2.0, -2.0]),
        form(5.25, 5.5, [0.0, 0.0]),
        form(5.5, 5.5, [1.0, 1.0]),
        form(4.5, 5.0, [7.0, 7.0]),
        form(-3.0, 4.5, [1.0, 1.0]),
        form(-900.0, 4.5, [30.0, 30.0]),
        form(14.5, 70.0, [1.0, 1.0]),
        form(-1e4, 2e4, [1e3, 1e3]),
        form(3.3, 9.1, [0.0, 3.7]),
        form(9.1, 3.3, [4.3, 0.01]),
        form(-8.0, 12.4, [9.0, 2.0]),
        form(2.0, 40.0, [3.0, 70.0]),
    ];

    /// Each pixel holds the light that falls into it, in rows and in columns, also of a trapezoid that begins or ends beside the
    /// picture.
    #[test]
    fn a_pixel_has_the_light_that_falls_into_it() {
        for form in FORMS {
            for along in [Along::Row, Along::Column] {
                let mut film = BeamFilm::new(16, 16);
                film.lay(along, 7, 1.0, &form);
                let pixels = pixels(&film);
                for at in 0..16 {
                    let pixel = pixels[if along == Along::Row { 7 * 16 + at } else { at * 16 + 7 }];
                    let expected = left_of(&form, at as f64 + 1.0) - left_of(&form, at as f64);
                    // Places are rounded to 1/256 pixel.
                    let blur = form.blurs[0].abs().min(form.blurs[1].abs());
                    let density = 1.0 / (form.ends[1] - form.ends[0]).abs().max(blur).max(1.0 / 256.0);
                    let slack = (density / 128.0).min(0.01);
                    assert!((pixel - expected).abs() < slack, "{form:?} {at}: {pixel} {expected}");
                }
                let elsewhere: f64 = pixels.iter().map(|pixel| pixel.abs()).sum();
                let there: f64 = left_of(&form, 16.0) - left_of(&form, 0.0);
                assert!((elsewhere - there).abs() < 1e-2, "nothing beside its row: {elsewhere} {there}");
            }
        }
    }

    /// Light so weak that its trapezoid is less than a unit high is not lost where there is much of it.
    #[test]
    fn weak_light_adds_up() {
        let mut film = BeamFilm::new(1000, 1);
        let beams = 20_000;
        for step in 0..beams {
            let begin = 100.0 + f64::from(step) * 0.01;
            film.lay(Along::Row, 0, 1e-8, &form(begin, begin + 500.0, [60.0, 80.0]));
        }
        let sum: f64 = pixels(&film).iter().sum();
        assert!((sum / (1e-8 * f64::from(beams)) - 1.0).abs() < 0.05, "{sum}");
    }

    /// A trapezoid that lies in the picture leaves nothing behind it, to the last bit.
    #[test]
    fn it_closes_exactly() {
        let mut film = BeamFilm::new(64, 2);
        for step in 0..500 {
            let begin = f64::from(step) * 0.0613;
            let blurs = [step % 7, step % 5].map(|step| 0.11 * f64::from(step));
            let form = form(begin, begin + 0.37 * f64::from(step % 13), blurs);
            film.lay(Along::Row, 1, if step % 3 == 0 { 1e-9 } else { 0.7 }, &form);
        }
        assert!(pixels(&film)[64 + 45..].iter().all(|pixel| *pixel == 0.0));
    }
}
