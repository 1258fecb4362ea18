//! Cost of printing: how many pixel operations a tree of art takes, and how much of it is held at once.
//!
//! The same for every machine and every picture: it is counted for a picture of [`PICTURE`] pixels, from the tree alone,
//! as the rasteriser would go through it. A pixel operation is one pixel blended once; all else is told in as many of them as
//! it takes the time of (`caustic bench art`). Whatever lies so far away that the
//! rasteriser's numbers would not hold is refused on the way.

mod area;
mod filter;
mod path;
mod rows;
mod tally;

pub(super) use tally::{Tally, millions};

use crate::Failure;
use area::Area;
use resvg::usvg::{ClipPath, Group, Mask, Node, Paint, Pattern, Transform, Tree};

/// Width and height of the picture that costs are for, pixels.
pub(super) const PICTURE: (usize, usize) = (1080, 2160);

/// How far anything may be from the picture, pixels: far below where the rasteriser's fixed-point numbers end, 2^29.
const MAX_DISTANCE_PX: f64 = 1e6;
/// A layer reaches so many times the picture's size beyond it, at most.
const LAYER_MARGIN: f64 = 2.0;

/// Passes over all pixels: of a layer that is cleared and put on what is below, of a clip, of a mask.
const LAYER_PASSES: f64 = 2.0;
const CLIP_PASSES: f64 = 5.0;
const MASK_PASSES: f64 = 7.0;

/// Counts what printing `tree` costs on a picture of this size, in which `from_own` places it, into `tally`.
///
/// # Errors
/// If something lies too far away, or a filter is larger than what is drawn.
pub(super) fn count(tree: &Tree, from_own: Transform, size: (f64, f64), tally: &mut Tally) -> Result<(), Failure> {
    let picture = Area::of_size(size);
    let mut counter = Counter { layers: picture.beyond(LAYER_MARGIN), tally };
    counter.tally.hold(picture.pixels());
    counter.children(tree.root(), from_own, picture)?;
    counter.tally.release(picture.pixels());
    Ok(())
}

/// A walk over a tree as the rasteriser goes through it.
struct Counter<'a> {
    /// What layers are cut to.
    layers: Area,
    tally: &'a mut Tally,
}

impl Counter<'_> {
    /// Counts what is drawn in `target`; `transform` leads to the picture.
    fn children(&mut self, group: &Group, transform: Transform, target: Area) -> Result<(), Failure> {
        group.children().iter().try_for_each(|node| self.node(node, transform, target))
    }

    fn node(&mut self, node: &Node, transform: Transform, target: Area) -> Result<(), Failure> {
        match node {
            Node::Group(group) => self.group(group, transform, target),
            Node::Path(path) => self.path(path, transform, target),
            Node::Text(text) => self.tally.inside(text.id(), |tally| {
                Counter { layers: self.layers, tally }.group(text.flattened(), transform, target)
            }),
            // No picture is read, so there is none.
            Node::Image(_) => Ok(()),
        }
    }

    fn group(&mut self, group: &Group, transform: Transform, target: Area) -> Result<(), Failure> {
        let layers = self.layers;
        self.tally.inside(name(group), |tally| {
            let transform = transform.pre_concat(group.transform());
            let mut counter = Counter { layers, tally };
            if group.should_isolate() {
                counter.layer(group, transform)
            } else {
                counter.children(group, transform, target)
            }
        })
    }

    /// A group that is drawn on a layer of its own.
    fn layer(&mut self, group: &Group, transform: Transform) -> Result<(), Failure> {
        let bounds = Area::transformed(&group.layer_bounding_box().to_rect(), transform);
        let layer = self.near(bounds)?.rounded_out().cut_to(&self.layers);
        let pixels = layer.pixels();
        self.tally.hold(pixels);
        self.tally.spend(LAYER_PASSES * pixels);
        self.children(group, transform, layer)?;
        for filter in group.filters() {
            self.filter(filter, transform, layer)?;
        }
        if let Some(clip) = group.clip_path() {
            self.clip(clip, transform, layer)?;
        }
        if let Some(mask) = group.mask() {
            self.mask(mask, transform, layer)?;
        }
        self.tally.release(pixels);
        Ok(())
    }

    /// A clip is a picture of the layer's size; so is each group in it that is clipped itself.
    fn clip(&mut self, clip: &ClipPath, transform: Transform, layer: Area) -> Result<(), Failure> {
        let pixels = layer.pixels();
        self.tally.hold(2.0 * pixels);
        self.tally.spend(CLIP_PASSES * pixels);
        self.clip_children(clip.root(), transform.pre_concat(clip.transform()), layer)?;
        if let Some(next) = clip.clip_path() {
            self.clip(next, transform, layer)?;
        }
        self.tally.release(2.0 * pixels);
        Ok(())
    }

    fn clip_children(&mut self, group: &Group, transform: Transform, layer: Area) -> Result<(), Failure> {
        for node in group.children() {
            match node {
                Node::Path(path) => self.path(path, transform, layer)?,
                Node::Text(text) => self.clip_children(text.flattened(), transform, layer)?,
                Node::Group(group) => {
                    let transform = transform.pre_concat(group.transform());
                    self.clip_children(group, transform, layer)?;
                    if let Some(clip) = group.clip_path() {
                        self.clip(clip, transform, layer)?;
                    }
                }
                Node::Image(_) => {}
            }
        }
        Ok(())
    }

    /// A mask is a picture of the layer's size and the shape of its region.
    fn mask(&mut self, mask: &Mask, transform: Transform, layer: Area) -> Result<(), Failure> {
        self.near(Area::transformed(&mask.rect().to_rect(), transform))?;
        let pixels = layer.pixels();
        self.tally.hold(2.0 * pixels);
        self.tally.spend(MASK_PASSES * pixels);
        self.children(mask.root(), transform, layer)?;
        if let Some(next) = mask.mask() {
            self.mask(next, transform, layer)?;
        }
        self.tally.release(2.0 * pixels);
        Ok(())
    }

    /// What of a paint is made before anything is painted with it.
    fn paint(&mut self, paint: &Paint, transform: Transform) -> Result<(), Failure> {
        if let Paint::Pattern(pattern) = paint { self.pattern(pattern, transform) } else { Ok(()) }
    }

    /// A pattern is drawn anew for each shape, as a picture of its own.
    fn pattern(&mut self, pattern: &Pattern, transform: Transform) -> Result<(), Failure> {
        let (x, y) = transform.pre_concat(pattern.transform()).get_scale();
        let rect = pattern.rect();
        let size = (f64::from(rect.width() * x).round(), f64::from(rect.height() * y).round());
        let tile = self.near(Area::of_size(size))?;
        self.tally.hold(tile.pixels());
        self.tally.spend(tile.pixels());
        self.children(pattern.root(), Transform::from_scale(x, y), tile)?;
        self.tally.release(tile.pixels());
        Ok(())
    }

    /// What is near enough for the rasteriser's numbers.
    fn near(&self, area: Area) -> Result<Area, Failure> {
        if area.farthest() <= MAX_DISTANCE_PX { Ok(area) } else { Err(self.tally.too_far()) }
    }
}

/// A group's id, or that of the one thing in it: what a filter or a mask is put on is wrapped into a group.
fn name(group: &Group) -> &str {
    match group.children() {
        [one] if group.id().is_empty() => one.id(),
        _ => group.id(),
    }
}
