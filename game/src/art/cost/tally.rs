//! Tally: what has been counted, and whom the most is owed to.

use crate::Failure;
use crate::art::unnamed;
use resvg::usvg::roxmltree::Document;
use std::collections::BTreeMap;

/// What art costs, counted so far.
#[derive(Clone, Debug, Default)]
pub(in crate::art) struct Tally {
    /// Pixel operations.
    pub operations: f64,
    /// Pixels that are held at once, at most.
    pub peak_pixels: f64,
    held_pixels: f64,
    /// The line of each id.
    lines: BTreeMap<String, u32>,
    /// The element that takes the most by itself, and how much.
    largest: Option<(f64, String)>,
    /// The ids that the walk is in, the innermost last.
    path: Vec<String>,
}

impl Tally {
    /// Nothing counted, of art that was read from `document`.
    pub fn new(document: &Document) -> Tally {
        let ids = document.descendants().filter_map(|node| Some((node.attribute("id")?, node.range().start)));
        // They come in the order of the text, so that it is counted through once.
        let (mut line, mut counted) = (1, 0);
        let lines = ids.map(|(id, at)| {
            let between = document.input_text().get(counted..at).unwrap_or_default();
            (line, counted) = (line + between.matches('\n').count() as u32, at);
            (id.to_string(), line)
        });
        Tally { lines: lines.collect(), ..Tally::default() }
    }

    /// Counts operations of the element that the walk is in.
    pub(super) fn spend(&mut self, operations: f64) {
        self.operations += operations;
        if self.largest.as_ref().is_none_or(|(most, _)| operations > *most) {
            self.largest = Some((operations, self.place()));
        }
    }

    pub(super) fn hold(&mut self, pixels: f64) {
        self.held_pixels += pixels;
        self.peak_pixels = self.peak_pixels.max(self.held_pixels);
    }

    pub(super) fn release(&mut self, pixels: f64) {
        self.held_pixels -= pixels;
    }

    /// Walks through an element.
    pub(super) fn inside(
        &mut self,
        id: &str,
        walk: impl FnOnce(&mut Tally) -> Result<(), Failure>,
    ) -> Result<(), Failure> {
        if id.is_empty() {
            return walk(self);
        }
        self.path.push(id.to_string());
        let walked = walk(self);
        self.path.pop();
        walked
    }

    /// The element that the walk is in, as far as it has a name.
    fn place(&self) -> String {
        let Some(id) = self.path.last() else { return "an element without an id".to_string() };
        if let Some(told) = unnamed::told(id) {
            return told;
        }
        self.lines.get(id).map_or_else(|| format!("`{id}`"), |line| format!("`{id}` in line {line}"))
    }

    /// What takes the most by itself, to be put behind a sentence.
    pub fn largest(&self) -> String {
        let told = |(operations, place): &(f64, String)| format!("; the most takes {place}, {}", millions(*operations));
        self.largest.as_ref().map_or_else(String::new, told)
    }

    pub(super) fn too_far(&self) -> Failure {
        Failure::new(format!("{} reaches too far beyond the playfield to be printed; cut it off", self.place()))
    }

    pub(super) fn filter_too_large(&self, filter: &str) -> Failure {
        let place = self.place();
        let what = format!("the filter `{filter}` of {place} reaches more than two playfields beyond the playfield");
        Failure::new(format!("{what}; give it a smaller region"))
    }
}

/// A number in millions, rounded up.
pub(in crate::art) fn millions(number: f64) -> String {
    format!("{:.0} million", (number * 1e-6).ceil())
}
