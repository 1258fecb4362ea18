//! The pixels that a way crosses, and the lengths of its chords in them.
//!
//! The way is gone in columns of the axis along which it is longer, where it meets at most two pixels of each: what lies in the
//! second is what the column's chord has more than the first. So there is no question at each line of pixels, and what a column
//! costs does not depend on the angle.

use geometry::DVec2;

/// A way across the picture, in pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PixelSegment {
    /// Where it begins, pixels from the upper left corner.
    pub from: DVec2,
    /// Where it ends.
    pub to: DVec2,
}

/// A pixel's side in the places across the columns: whole numbers, so that a step has no error of its own.
const SIDE: f64 = (1_u64 << SIDE_BITS) as f64;
const SIDE_BITS: u32 = 32;

/// The part of a way within the picture, gone so that the place on the longer axis grows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PixelWalk {
    /// The longer axis: 0 is x, 1 is y.
    pub axis: usize,
    /// Places across are counted from the other side of the picture, so that they grow too.
    pub mirrored: bool,
    /// The chord of a whole column, pixels.
    chord: f64,
    /// The chord over the way across, for one unit across; infinite for a way along the axis.
    chord_per_unit: f64,
    /// Where it begins and ends on the longer axis.
    begin: f64,
    end: f64,
    /// Where it begins across, in units, and how far across it goes in a whole column.
    across: u64,
    step: f64,
    /// The distance of its beginning from that of the way, and 1 or -1: how the distance grows.
    distance: f64,
    forward: f64,
}

/// A column of pixels that a way crosses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Column {
    /// Its number.
    pub column: usize,
    /// The pixels of it: the second may be the first again, with a chord of nothing but rounding. By rounding a pixel may be
    /// the one behind the last.
    pub rows: [usize; 2],
    /// The chords in them, pixels.
    pub chords: [f64; 2],
}

impl PixelWalk {
    /// The walk of a way across a picture of this size; `None` where it does not cross it.
    pub fn new(segment: &PixelSegment, width: usize, height: usize) -> Option<PixelWalk> {
        let way = segment.to - segment.from;
        let length = way.length();
        if !(length > 0.0 && length.is_finite()) {
            return None;
        }
        let direction = way / length;
        let size = DVec2::new(width as f64, height as f64);
        let [enters, leaves] = clip(segment.from, direction, length, size)?;
        let axis = usize::from(way.y.abs() > way.x.abs());
        let (distance, forward) = if direction[axis] < 0.0 { (leaves, -1.0) } else { (enters, 1.0) };
        let (start, direction) = (segment.from + direction * distance, direction * forward);
        let (from, across) = (start[axis], start[1 - axis]);
        let (along, slope) = (direction[axis], direction[1 - axis] / direction[axis]);
        let across = if slope < 0.0 { size[1 - axis] - across } else { across };
        let begin = from.clamp(0.0, size[axis]);
        Some(PixelWalk {
            axis,
            mirrored: slope < 0.0,
            chord: 1.0 / along,
            chord_per_unit: 1.0 / (along * slope.abs() * SIDE),
            begin,
            end: (from + (leaves - enters) * along).clamp(begin, size[axis]),
            across: (across.max(0.0) * SIDE) as u64,
            step: slope.abs() * SIDE,
            distance,
            forward,
        })
    }

    /// Its columns, one after the other.
    #[inline(always)]
    pub fn columns(&self) -> Columns<'_> {
        Columns {
            walk: self,
            first: self.begin as usize,
            last: (self.end.ceil() as usize).max(1) - 1,
            column: self.begin as usize,
            across: self.across,
            row: (self.across >> SIDE_BITS) as usize,
        }
    }

    /// Shows `visit` each of its pixels, in a picture of this size: x and y, the chord in it, and how far from the way's beginning that
    /// chord's middle is, pixels.
    pub fn visit(&self, size: [usize; 2], mut visit: impl FnMut([usize; 2], f64, f64)) {
        let (last_column, last_row) = (size[self.axis] - 1, size[1 - self.axis] - 1);
        let mut walked = 0.0;
        for column in self.columns() {
            for (row, chord) in column.rows.into_iter().zip(column.chords).filter(|(_, chord)| *chord > 0.0) {
                let row = if self.mirrored { last_row.saturating_sub(row) } else { row.min(last_row) };
                let mut pixel = [column.column.min(last_column), row];
                if self.axis == 1 {
                    pixel.reverse();
                }
                visit(pixel, chord, self.distance(walked + 0.5 * chord));
                walked += chord;
            }
        }
    }

    /// The part of it from where it begins to the next column whose number is a multiple of `side`, and the rest, if there is one. Both
    /// together have the columns of the whole, bit for bit.
    pub fn cut(&self, side: usize) -> (PixelWalk, Option<PixelWalk>) {
        let first = self.begin as usize;
        let next = (first / side + 1) * side;
        if next as f64 >= self.end {
            return (*self, None);
        }
        let at = next as f64;
        let in_first = (self.step * ((first + 1) as f64 - self.begin)) as u64;
        let across = self.across + in_first + (next - first - 1) as u64 * self.step as u64;
        let walked = (at - self.begin) * self.chord;
        let rest = PixelWalk { begin: at, across, distance: self.distance(walked), ..*self };
        (PixelWalk { end: at, ..*self }, Some(rest))
    }

    /// The pixel in the middle of it, by its column and its place across.
    pub fn middle(&self) -> [usize; 2] {
        let middle = 0.5 * (self.begin + self.end);
        [middle as usize, ((self.across as f64 + (middle - self.begin) * self.step) / SIDE) as usize]
    }

    /// The distance from the way's beginning, after so much of the walk.
    pub fn distance(&self, walked: f64) -> f64 {
        self.distance + walked * self.forward
    }
}

/// The columns of a walk; an iterator, since a closure would be compiled for the least of the instruction sets.
pub struct Columns<'a> {
    walk: &'a PixelWalk,
    first: usize,
    last: usize,
    /// The next one.
    column: usize,
    /// Where the way is across at its beginning, in units, and in which pixel.
    across: u64,
    row: usize,
}

impl Iterator for Columns<'_> {
    type Item = Column;

    #[inline(always)]
    fn next(&mut self) -> Option<Column> {
        let Columns { walk, column, .. } = *self;
        if column > self.last {
            return None;
        }
        let (mut step, mut chord) = (walk.step, walk.chord);
        if column == self.first || column == self.last {
            let part = walk.end.min(column as f64 + 1.0) - walk.begin.max(column as f64);
            (step, chord) = (step * part, chord * part);
        }
        // From here to the next pixel, at least one unit: times infinity it is no less than the column's chord.
        let left = (1 << SIDE_BITS) - (self.across & ((1 << SIDE_BITS) - 1));
        let before = left as i64 as f64 * walk.chord_per_unit;
        let before = if before < chord { before } else { chord };
        self.across += step as i64 as u64;
        let rows = [self.row, (self.across >> SIDE_BITS) as usize];
        self.row = rows[1];
        self.column += 1;
        Some(Column { column, rows, chords: [before, chord - before] })
    }
}

/// Where the way is within the picture, from and to, pixels from its start.
fn clip(from: DVec2, direction: DVec2, length: f64, size: DVec2) -> Option<[f64; 2]> {
    let (mut begin, mut end) = (0.0_f64, length);
    for axis in 0..2 {
        let (start, along) = (from[axis], direction[axis]);
        if along == 0.0 {
            if !(0.0..=size[axis]).contains(&start) {
                return None;
            }
            continue;
        }
        let (low, high) = (-start / along, (size[axis] - start) / along);
        begin = begin.max(low.min(high));
        end = end.min(low.max(high));
    }
    (begin < end).then_some([begin, end])
}

#[cfg(test)]
mod tests {
    use super::*;
    use geometry::rng::SplitMix64;

    const SIZE: [usize; 2] = [40, 30];

    /// The chord in each pixel, literally: the way is cut at the pixel's sides, whatever pixels there are.
    fn literal(segment: &PixelSegment) -> Vec<f64> {
        let (length, way) = (segment.from.distance(segment.to), segment.to - segment.from);
        let direction = way.normalize_or_zero();
        let chord = |pixel: usize| {
            let corner = DVec2::new((pixel % SIZE[0]) as f64, (pixel / SIZE[0]) as f64);
            clip(segment.from - corner, direction, length, DVec2::ONE).map_or(0.0, |[begin, end]| end - begin)
        };
        (0..SIZE[0] * SIZE[1]).map(chord).collect()
    }

    fn walked(segment: &PixelSegment) -> Vec<f64> {
        let mut chords = vec![0.0; SIZE[0] * SIZE[1]];
        let Some(walk) = PixelWalk::new(segment, SIZE[0], SIZE[1]) else { return chords };
        for column in walk.columns() {
            for of in 0..2 {
                let rows = SIZE[1 - walk.axis];
                let row = column.rows[of].min(rows - 1);
                let row = if walk.mirrored { rows - 1 - row } else { row };
                let [x, y] = if walk.axis == 0 { [column.column, row] } else { [row, column.column] };
                chords[y * SIZE[0] + x] += column.chords[of];
            }
        }
        chords
    }

    /// In every pixel, within what a place's unit is worth over all columns; between pixels, along their sides and from corner to
    /// corner too.
    #[test]
    fn every_chord_is_that_of_the_pixel_cut_out_of_the_way() {
        let mut random = SplitMix64::new(4);
        for turn in 0..20_000 {
            let mut point = || DVec2::new(random.uniform(-20.0, 60.0), random.uniform(-20.0, 50.0));
            let (from, mut to) = (point(), point());
            match turn % 8 {
                0 => to.y = from.y,
                1 => to.x = from.x,
                2 => to = from + (to - from) * 0.02,
                3 => to.y = from.y + 1e-9 * to.y,
                _ => {}
            }
            let segment = PixelSegment { from, to };
            let (expected, found) = (literal(&segment), walked(&segment));
            for pixel in 0..expected.len() {
                // A way that is cut too early or late by a unit has that much more or less in the next pixel, over its slope.
                let slack = if turn % 8 == 3 { 1.5 } else { 1e-6 };
                assert!((expected[pixel] - found[pixel]).abs() < slack, "{segment:?} {pixel}");
            }
            let [expected, found] = [expected, found].map(|chords| chords.iter().sum::<f64>());
            assert!((expected - found).abs() < 1e-8, "{segment:?}: {expected} {found}");
        }
    }

    /// On a side between pixels either may have the chord, but not both.
    #[test]
    fn a_way_between_pixels_is_counted_once() {
        let mut random = SplitMix64::new(5);
        for turn in 0..2_000 {
            let mut point = || DVec2::new(random.uniform(0.0, 40.0), random.uniform(0.0, 30.0)).round();
            let (from, mut to) = (point(), point());
            match turn % 3 {
                0 => to.y = from.y,
                1 => to.x = from.x,
                _ => {}
            }
            let sum: f64 = walked(&PixelSegment { from, to }).iter().sum();
            assert!((sum - from.distance(to)).abs() < 1e-8, "{from} {to}: {sum}");
        }
    }

    #[test]
    fn a_walk_that_is_cut_has_the_columns_of_the_whole() {
        let mut random = SplitMix64::new(6);
        for _ in 0..5_000 {
            let mut point = || DVec2::new(random.uniform(-20.0, 60.0), random.uniform(-20.0, 50.0));
            let segment = PixelSegment { from: point(), to: point() };
            let Some(walk) = PixelWalk::new(&segment, SIZE[0], SIZE[1]) else { continue };
            let mut parts: Vec<Column> = Vec::new();
            let mut rest = Some(walk);
            while let Some(walk) = rest {
                let (part, more) = walk.cut(8);
                parts.extend(part.columns());
                rest = more;
            }
            assert_eq!(parts, walk.columns().collect::<Vec<_>>());
        }
    }

    /// Distances are those from the way's beginning, whichever way it goes.
    #[test]
    fn distances_grow_from_the_beginning_of_the_way() {
        for (from, to) in [([-3.0, 2.0], [30.0, 9.0]), ([30.0, 9.0], [-3.0, 2.0]), ([5.0, 29.0], [6.0, 1.0])] {
            let segment = PixelSegment { from: DVec2::from_array(from), to: DVec2::from_array(to) };
            let direction = (segment.to - segment.from).normalize();
            let walk = PixelWalk::new(&segment, SIZE[0], SIZE[1]).expect("it crosses the picture");
            let mut gone = 0.0;
            for column in walk.columns() {
                let middle = segment.from + direction * walk.distance(gone + 0.5 * column.chords[0]);
                assert!((column.column as f64..=column.column as f64 + 1.0).contains(&middle[walk.axis]));
                gone += column.chords[0] + column.chords[1];
            }
        }
    }
}
