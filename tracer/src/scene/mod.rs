//! The scene: what is lit, what lights it and what is in the way: plain data.

pub(crate) mod id;
pub(crate) mod lamp;
pub(crate) mod material;
pub(crate) mod overhang;
pub mod validation;
pub(crate) mod view;

use crate::{ItemId, Lamp, Material, Overhang, Revision, View};
use geometry::{DVec2, Shape};

/// Linear light or reflectance, red, green, blue (sRGB primaries).
pub type Rgb = [f32; 3];

/// Things that belong together do not shade each other's tops: a bumper's body does not darken its own cap, nor the
/// lamp inside it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Group(pub u16);

/// Everything that a picture is made of.
#[derive(Clone, Debug)]
pub struct Scene<'a> {
    /// Where the table is on the screen.
    pub view: View,
    /// The lamps. A lamp whose colour is black costs nothing.
    pub lamps: Vec<Lamp>,
    /// What casts shadows.
    pub occluders: Vec<Occluder>,
    /// Surfaces above the floor, from the lowest to the highest.
    pub tops: Vec<Top>,
    /// The balls, above every top.
    pub balls: Vec<Ball>,
    /// What hangs above those balls that are below.
    pub overhangs: Vec<Overhang>,
    /// What glows from below: the inserts of a playfield.
    pub glows: Vec<Glow<'a>>,
    /// The floor's art.
    pub floor: &'a Floor,
    /// The floor's art at half the resolution ([`View::halved`]), if light is to be found at that.
    pub half_floor: Option<&'a Floor>,
    /// Light from everywhere: what a surface shows where no lamp reaches.
    pub ambient: Rgb,
}

/// Something that casts shadows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Occluder {
    /// The caller's name for it.
    pub id: ItemId,
    /// Its outline from above, mm.
    pub shape: Shape,
    /// What it belongs to.
    pub group: Group,
    /// What it is made of: the same as all of its group.
    pub material: Material,
}

/// A visible surface above the floor.
#[derive(Clone, Debug, PartialEq)]
pub struct Top {
    /// The caller's name for it.
    pub id: ItemId,
    /// Its outline from above, mm.
    pub outline: Outline,
    /// What it belongs to.
    pub group: Group,
    /// How it looks.
    pub finish: Finish,
}

/// An outline from above, mm.
#[derive(Clone, Debug, PartialEq)]
pub enum Outline {
    /// Core plus radius.
    Shape(Shape),
    /// A closed polygon, either way round.
    Polygon(Vec<DVec2>),
}

/// How a surface looks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Finish {
    /// Reflectance, 0 to 1. With `art` it multiplies the art.
    pub albedo: Rgb,
    /// Its form.
    pub profile: Profile,
    /// Strength of its highlights: 0 is matt, 1 is polished metal.
    pub gloss: f32,
    /// Takes its colour from [`Floor::tops`] (a printed plastic, a bumper's cap) where that is opaque.
    pub art: bool,
    /// Light of its own (a cap with a lamp below it).
    pub emission: Rgb,
    /// How much of it there is: 1 is solid, 0 is not there (a drop target that has fallen).
    pub opacity: f32,
    /// How much of the light below it comes through, in the colour of its albedo: 0 for wood, most of it for a printed
    /// plastic.
    pub translucency: f32,
}

/// A surface's form in cross section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Profile {
    /// Flat, with an edge rounded over this width, mm.
    Bevel(f32),
    /// Round all over: a rubber ring, a wire, a dome.
    Dome,
}

/// A chrome ball. One that lies on the floor has its shadow from the occluder of the same group; one that floats has none
/// there, and hides lamps from what is below it as the sphere that it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ball {
    /// The caller's name for it.
    pub id: ItemId,
    /// The middle, mm.
    pub center_mm: DVec2,
    /// The radius, mm.
    pub radius_mm: f64,
    /// How far its lowest point is above the floor, mm; up to [`Ball::LEAST_HEIGHT_MM`], and below 0, it lies on it.
    pub height_mm: f64,
    /// Its group.
    pub group: Group,
    /// It is below the scene's overhangs, where there are any.
    pub below: bool,
    /// How it has turned: a unit quaternion x, y, z, w. Scratches on the chrome show it.
    pub rotation: [f32; 4],
}

/// Light that comes through the floor from below, as from an insert of a playfield: a mask on the screen and a colour.
#[derive(Clone, Debug)]
pub struct Glow<'a> {
    /// The caller's name for it.
    pub id: ItemId,
    /// Which pixels, and how much.
    pub mask: &'a Mask,
    /// Its radiance.
    pub color: Rgb,
}

/// Coverage of some pixels of a view.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Mask {
    /// Which version of it this is.
    pub revision: Revision,
    /// The leftmost pixel.
    pub x: usize,
    /// The topmost pixel.
    pub y: usize,
    /// Pixels across.
    pub width: usize,
    /// `width` x height coverages, 255 is all.
    pub coverage: Vec<u8>,
}

/// The art of a table at a view's resolution, pixel for pixel, sRGB 8 bit: R, G, B, A premultiplied as tiny-skia
/// leaves them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Floor {
    /// Which version of it this is.
    pub revision: Revision,
    /// Pixels across.
    pub width: usize,
    /// Pixels down.
    pub height: usize,
    /// The playfield: opaque.
    pub floor: Vec<[u8; 4]>,
    /// Plastics and caps above it: transparent where there is none.
    pub tops: Vec<[u8; 4]>,
    /// Which way the floor leans: the horizontal part of its unit normal, x and y, 127 is 1. Empty for a flat floor.
    pub normals: Vec<[i8; 2]>,
    /// Strength of the highlights on the floor's lacquer: 0 is matt, 1 is a mirror's.
    pub gloss: f32,
}

/// A glow with the revision of its mask: what a tile knows its light by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct GlowKey(ItemId, Revision);

impl Glow<'_> {
    /// Whose light it is, through which mask.
    pub(crate) fn key(&self) -> GlowKey {
        GlowKey(self.id, self.mask.revision)
    }
}

impl<'a> Scene<'a> {
    /// All of a floor in the dark, with nothing on it.
    pub fn new(view: View, floor: &'a Floor) -> Scene<'a> {
        Scene {
            view,
            lamps: Vec::new(),
            occluders: Vec::new(),
            overhangs: Vec::new(),
            tops: Vec::new(),
            balls: Vec::new(),
            glows: Vec::new(),
            floor,
            half_floor: None,
            ambient: [0.0; 3],
        }
    }

    /// Adds a solid: an opaque occluder and its top, both under the same id.
    pub fn add_solid(&mut self, id: ItemId, shape: Shape, group: Group, finish: Finish) {
        self.occluders.push(Occluder::opaque(id, shape, group));
        self.tops.push(Top { id, outline: Outline::Shape(shape), group, finish });
    }
}

impl Finish {
    /// Solid and matt, with an edge that is rounded over 2 mm.
    pub fn matte(albedo: Rgb) -> Finish {
        let (profile, emission) = (Profile::Bevel(2.0), [0.0; 3]);
        Finish { albedo, profile, gloss: 0.0, art: false, emission, opacity: 1.0, translucency: 0.0 }
    }
}

impl Occluder {
    /// A piece of a wall, a post: light does not pass it.
    pub fn opaque(id: ItemId, shape: Shape, group: Group) -> Occluder {
        Occluder { id, shape, group, material: Material::Opaque }
    }
}

impl Ball {
    /// A ball that is no higher than this lies on the floor, mm: from a point right under a ball that touches the floor,
    /// the ball hides everything, and what it hides there would have no end.
    pub const LEAST_HEIGHT_MM: f64 = 0.1;

    /// Whether it is in the air: then it needs no occluder.
    pub fn is_airborne(&self) -> bool {
        self.height_mm > Ball::LEAST_HEIGHT_MM
    }

    /// How high it is above the floor that it lies on, mm: 0 if it does not float.
    pub(crate) fn lift_mm(&self) -> f64 {
        if self.is_airborne() { self.height_mm } else { 0.0 }
    }
}

impl Mask {
    /// Whole rows of pixels.
    pub fn height(&self) -> usize {
        self.coverage.len().checked_div(self.width).unwrap_or(0)
    }
}

/// No art.
pub(crate) static NO_FLOOR: Floor = Floor {
    revision: Revision::NONE,
    width: 0,
    height: 0,
    floor: Vec::new(),
    tops: Vec::new(),
    normals: Vec::new(),
    gloss: 0.0,
};

impl Floor {
    /// A flat, matt floor of one sRGB colour, without art above it.
    pub fn plain(width: usize, height: usize, [red, green, blue]: [u8; 3]) -> Floor {
        let (floor, tops) = (vec![[red, green, blue, 255]; width * height], vec![[0; 4]; width * height]);
        Floor { revision: Revision::fresh(), width, height, floor, tops, ..Floor::default() }
    }

    /// Whether the art is of the size of the scene's view, with every pixel there.
    pub(crate) fn fits(&self, scene: &Scene) -> bool {
        let pixels = self.width * self.height;
        (self.width, self.height) == (scene.view.width, scene.view.height)
            && self.floor.len() == pixels
            && self.tops.len() == pixels
            && (self.normals.is_empty() || self.normals.len() == pixels)
    }
}
