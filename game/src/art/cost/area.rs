//! Area: a rectangle of a picture, pixels.

use resvg::usvg::tiny_skia_path::Point;
use resvg::usvg::{Rect, Transform};

/// A rectangle along the axes, pixels; its right and lower sides are not to the left of or above the others.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Area {
    pub left: f64,
    pub top: f64,
    pub right: f64,
    pub bottom: f64,
}

impl Area {
    /// From the upper left corner on.
    pub fn of_size((width, height): (f64, f64)) -> Area {
        Area { left: 0.0, top: 0.0, right: width, bottom: height }
    }

    /// What holds a rectangle of a drawing in the picture.
    pub fn transformed(rect: &Rect, transform: Transform) -> Area {
        let corners = [
            (rect.left(), rect.top()),
            (rect.right(), rect.top()),
            (rect.left(), rect.bottom()),
            (rect.right(), rect.bottom()),
        ];
        let corners = corners.map(|(x, y)| moved(transform, Point::from_xy(x, y)));
        let [x, y] = [0, 1].map(|axis| corners.map(|corner| corner[axis]));
        let least = |values: [f64; 4]| values.into_iter().reduce(lesser).unwrap_or(f64::NAN);
        let most = |values: [f64; 4]| -least(values.map(|value| -value));
        Area { left: least(x), top: least(y), right: most(x), bottom: most(y) }
    }

    pub fn width(&self) -> f64 {
        self.right - self.left
    }

    pub fn height(&self) -> f64 {
        self.bottom - self.top
    }

    pub fn pixels(&self) -> f64 {
        self.width() * self.height()
    }

    /// How far its farthest side is from the picture's corner; more than any number if a side is no number.
    pub fn farthest(&self) -> f64 {
        let sides = [self.left, self.top, self.right, self.bottom];
        if sides.iter().any(|side| !side.is_finite()) {
            return f64::INFINITY;
        }
        sides.into_iter().map(f64::abs).fold(0.0, f64::max)
    }

    /// With so many times its size more on each side.
    pub fn beyond(&self, times: f64) -> Area {
        let (x, y) = (times * self.width(), times * self.height());
        Area { left: self.left - x, top: self.top - y, right: self.right + x, bottom: self.bottom + y }
    }

    /// To whole pixels, and two more on each side, as layers are made.
    pub fn rounded_out(&self) -> Area {
        Area {
            left: self.left.floor() - 2.0,
            top: self.top.floor() - 2.0,
            right: self.right.ceil() + 2.0,
            bottom: self.bottom.ceil() + 2.0,
        }
    }

    /// What of it is in `other`; nothing, if nothing is.
    pub fn cut_to(&self, other: &Area) -> Area {
        let (left, top) = (self.left.max(other.left), self.top.max(other.top));
        Area { left, top, right: self.right.min(other.right).max(left), bottom: self.bottom.min(other.bottom).max(top) }
    }

    /// Whether all of `other` is in it.
    pub fn holds(&self, other: &Area) -> bool {
        self.left <= other.left && self.top <= other.top && self.right >= other.right && self.bottom >= other.bottom
    }
}

/// The lesser of two numbers; no number if one is none.
fn lesser(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() { f64::NAN } else { a.min(b) }
}

/// A point of a drawing, in the picture.
pub(super) fn moved(transform: Transform, mut point: Point) -> [f64; 2] {
    transform.map_point(&mut point);
    [f64::from(point.x), f64::from(point.y)]
}
