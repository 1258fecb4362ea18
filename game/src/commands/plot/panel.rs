//! Two axes, a grid, and the curves between them.

use super::ink;
use super::sheet::{Lettering, PLAIN, Place, Sheet, undrawn};
use crate::Failure;
use plotters::coord::cartesian::Cartesian2d;
use plotters::coord::ranged1d::Ranged;
use plotters::coord::types::RangedCoordf64;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, VPos};
use std::ops::Range;

/// One axis.
pub struct Axis {
    /// What is measured along it, with its unit.
    name: String,
    range: Range<f64>,
    /// Where the grid's lines are, and what is written there.
    ticks: Vec<(f64, String)>,
}

impl Axis {
    /// An axis with about `most` round numbers on it.
    pub fn new(name: &str, range: Range<f64>, most: usize) -> Axis {
        let points = RangedCoordf64::from(range.clone()).key_points(most);
        let step = points.get(1).map_or(1.0, |second| second - points[0]);
        let decimals = (0..6).find(|places| is_whole(step * libm::pow(10.0, f64::from(*places)))).unwrap_or(6) as usize;
        let ticks = points.into_iter().map(|value| (value, format!("{:.decimals$}", value + 0.0))).collect();
        Axis { name: name.to_string(), range, ticks }
    }

    /// An axis of equal ratios, with these numbers on it. What is drawn on it must be given as [`log`].
    pub fn ratios(name: &str, range: Range<f64>, numbers: &[f64]) -> Axis {
        let ticks = numbers.iter().map(|number| (log(*number), number.to_string())).collect();
        Axis { name: name.to_string(), range: log(range.start)..log(range.end), ticks }
    }

    /// The same grid without its name and its numbers, for an axis that another panel below shares.
    #[must_use]
    pub fn unnamed(mut self) -> Axis {
        self.name.clear();
        self.ticks.iter_mut().for_each(|(_, number)| number.clear());
        self
    }
}

/// Where a number is on an axis of equal ratios.
pub fn log(number: f64) -> f64 {
    libm::log10(number)
}

fn is_whole(number: f64) -> bool {
    (number - number.round()).abs() < 1e-6
}

/// Axes with room between them.
pub struct Panel<'s, 'a> {
    sheet: &'s Sheet<'a>,
    place: Place,
    coordinates: DrawingArea<BitMapBackend<'a>, Cartesian2d<RangedCoordf64, RangedCoordf64>>,
}

impl<'s, 'a> Panel<'s, 'a> {
    /// Draws the grid, the numbers and the names of the axes.
    ///
    /// # Errors
    /// If they cannot be drawn.
    pub fn new(sheet: &'s Sheet<'a>, place: Place, x: &Axis, y: &Axis) -> Result<Panel<'s, 'a>, Failure> {
        let (low, high) = (sheet.pixel((place.left, place.bottom)), sheet.pixel((place.right, place.top)));
        let pixels = (low.0..high.0, low.1..high.1);
        let spec = Cartesian2d::<RangedCoordf64, RangedCoordf64>::new(x.range.clone(), y.range.clone(), pixels);
        let panel = Panel { sheet, place, coordinates: sheet.area.apply_coord_spec(spec) };
        panel.rectangle([(low.0, high.1), (high.0, low.1)], ink::PANEL)?;
        panel.rule_across(x)?;
        panel.rule_down(y)?;
        panel.stroke(&[(low.0, high.1), low, (high.0, low.1)], 1.4, ink::BRASS)?;
        Ok(panel)
    }

    fn rule_across(&self, axis: &Axis) -> Result<(), Failure> {
        let Place { left, top, right, bottom } = self.place;
        let numbers = Lettering { anchor: (HPos::Center, VPos::Top), ..PLAIN };
        for (value, number) in &axis.ticks {
            let x = f64::from(self.at((*value, 0.0)).0) / self.sheet.unit;
            self.units(&[(x, top), (x, bottom)], 1.0, ink::GRID)?;
            self.sheet.text((x, bottom + 12.0), number, numbers)?;
        }
        self.sheet.text((0.5 * (left + right), bottom + 40.0), &axis.name, numbers)
    }

    fn rule_down(&self, axis: &Axis) -> Result<(), Failure> {
        let Place { left, top, right, bottom } = self.place;
        for (value, number) in &axis.ticks {
            let y = f64::from(self.at((0.0, *value)).1) / self.sheet.unit;
            self.units(&[(left, y), (right, y)], 1.0, ink::GRID)?;
            let numbers = Lettering { anchor: (HPos::Right, VPos::Center), ..PLAIN };
            self.sheet.text((left - 12.0, y), number, numbers)?;
        }
        let name = Lettering { anchor: (HPos::Center, VPos::Center), upright: true, ..PLAIN };
        self.sheet.text((44.0, 0.5 * (top + bottom)), &axis.name, name)
    }

    /// A curve through these points, `width` units wide.
    ///
    /// # Errors
    /// If it cannot be drawn.
    pub fn line(
        &self,
        points: impl IntoIterator<Item = (f64, f64)>,
        width: f64,
        color: RGBColor,
    ) -> Result<(), Failure> {
        let mut pixels: Vec<(i32, i32)> = points.into_iter().map(|point| self.at(point)).collect();
        pixels.dedup();
        self.stroke(&pixels, width, color)
    }

    /// A dot at each of these points, `radius` units large.
    ///
    /// # Errors
    /// If they cannot be drawn.
    pub fn dots(
        &self,
        points: impl IntoIterator<Item = (f64, f64)>,
        radius: f64,
        color: RGBColor,
    ) -> Result<(), Failure> {
        points.into_iter().try_for_each(|point| self.dot(self.at(point), self.sheet.fine(radius), color))
    }

    /// Everything between 0 and these points, which are in the order of x.
    ///
    /// # Errors
    /// If it cannot be drawn.
    pub fn fill(&self, points: impl IntoIterator<Item = (f64, f64)>, color: RGBColor) -> Result<(), Failure> {
        let mut last: Option<(i32, i32)> = None;
        for (x, y) in points {
            let top = self.at((x, y));
            let foot = self.at((x, 0.0)).1;
            let left = last.map_or(top.0, |last| last.0);
            self.rectangle([(left, last.map_or(top.1, |last| last.1)), (top.0, foot)], color)?;
            last = Some(top);
        }
        Ok(())
    }

    /// A line across at `y` with a name over it that begins at `x`.
    ///
    /// # Errors
    /// If it cannot be drawn.
    pub fn level(&self, (x, y): (f64, f64), name: &str) -> Result<(), Failure> {
        let (across, height) = self.at((x, y));
        let (across, height) = (f64::from(across) / self.sheet.unit, f64::from(height) / self.sheet.unit);
        self.units(&[(self.place.left, height), (self.place.right, height)], 1.6, ink::BRASS)?;
        let lettering = Lettering { color: ink::BRASS, anchor: (HPos::Left, VPos::Center), ..PLAIN };
        self.sheet.text((across, height - 15.0), name, lettering)
    }

    /// A line down at `x` with a name beside its upper end.
    ///
    /// # Errors
    /// If it cannot be drawn.
    pub fn moment(&self, x: f64, name: &str) -> Result<(), Failure> {
        let across = f64::from(self.at((x, 0.0)).0) / self.sheet.unit;
        self.units(&[(across, self.place.top), (across, self.place.bottom)], 1.6, ink::BRASS)?;
        let lettering = Lettering { color: ink::BRASS, anchor: (HPos::Left, VPos::Top), ..PLAIN };
        self.sheet.text((across + 8.0, self.place.top + 8.0), name, lettering)
    }

    /// The fine pixel of a point.
    fn at(&self, point: (f64, f64)) -> (i32, i32) {
        self.coordinates.map_coordinate(&point)
    }

    fn units(&self, points: &[(f64, f64)], width: f64, color: RGBColor) -> Result<(), Failure> {
        let pixels: Vec<(i32, i32)> = points.iter().map(|point| self.sheet.pixel(*point)).collect();
        self.stroke(&pixels, width, color)
    }

    /// A line with round joints: each piece alone, and a dot where two meet.
    fn stroke(&self, pixels: &[(i32, i32)], width: f64, color: RGBColor) -> Result<(), Failure> {
        let fine = self.sheet.fine(width).max(1);
        for pair in pixels.windows(2) {
            let piece = PathElement::new(pair.to_vec(), color.stroke_width(fine as u32));
            self.sheet.area.draw(&piece).map_err(undrawn)?;
        }
        let joints = pixels.iter().skip(1).take(pixels.len().saturating_sub(2));
        joints.copied().try_for_each(|joint| self.dot(joint, fine / 2, color))
    }

    fn dot(&self, center: (i32, i32), radius: i32, color: RGBColor) -> Result<(), Failure> {
        self.sheet.area.draw(&Circle::new(center, radius.max(0), color.filled())).map_err(undrawn)
    }

    fn rectangle(&self, corners: [(i32, i32); 2], color: RGBColor) -> Result<(), Failure> {
        self.sheet.area.draw(&Rectangle::new(corners, color.filled())).map_err(undrawn)
    }
}
