//! A drawing as a scene of light.

use super::attributes::Attributes;
use super::{body, lamp, material};
use crate::Failure;
use pinball::table::{DrawnShape, DrawnShapes, LIGHT_BENDING_WORDS};
use std::ops::RangeInclusive;
use tracer::transport::{Body, Dielectric, LightSource, Material, Scene, Surfaces, TOLERANCE_MM};

/// Words of a scene beside the table's.
const OWN_WORDS: [&str; 5] = ["glass", "prism", "lens", "mirror", "lamp"];
/// A table's words for what has no place in a scene of light.
const ART_WORDS: [&str; 2] = ["insert", "plastic"];
/// Mistakes that are worth reading at once.
const MOST_TOLD: usize = 100;
/// Light from everywhere, where nothing is said: what is drawn is just seen.
const AMBIENT: f64 = 0.1;
/// What is left of light after a millimetre of glass in which a lamp could not be seen at all.
const OPAQUE: f64 = 1e-9;

/// What a drawing says of light.
#[derive(Clone, Debug)]
pub struct DrawnScene {
    /// Its bodies and lamps, mm.
    pub scene: Scene,
    /// The drawing itself: what is seen of it without any lamp. The picture shows its page whole.
    pub drawing: DrawnShapes,
    /// Which of its shapes light knows, by number.
    pub things: Vec<usize>,
    /// Light from everywhere in which the drawing is seen, as a part of full light.
    pub ambient: f64,
    /// Stops brighter than a picture is exposed by its own light.
    pub stops: f64,
    /// What is odd in the drawing and yet no mistake.
    pub warnings: Vec<Failure>,
}

/// What a shape is in a scene.
enum Thing {
    Bodies(Vec<Body>),
    Lamp(LightSource),
    Art,
}

impl DrawnScene {
    /// Reads the drawing in the file `path`, which holds `bytes`.
    ///
    /// # Errors
    /// One sentence for each mistake: file, line, what was expected.
    pub fn read(path: &str, bytes: Vec<u8>) -> Result<DrawnScene, Vec<Failure>> {
        let drawn = DrawnShapes::read(path, bytes, &OWN_WORDS)?;
        let mut mistakes = Vec::new();
        let mut warnings = drawn.warnings.clone();
        let mut scene = Scene::default();
        let (mut lamps, mut things) = (Vec::new(), Vec::new());
        for (number, shape) in drawn.shapes.iter().enumerate() {
            let attributes = Attributes::new(shape);
            match thing(shape, &attributes) {
                Ok(Thing::Bodies(bodies)) => scene.bodies.extend(bodies),
                Ok(Thing::Lamp(lamp)) => {
                    scene.sources.push(lamp);
                    lamps.push(shape);
                }
                Ok(Thing::Art) => continue,
                Err(why) => {
                    mistakes.push(drawn.mistake(shape, format!("{}: {why}", name(shape))));
                    continue;
                }
            }
            things.push(number);
            warnings.extend(unread(shape, &attributes).map(|what| drawn.warning(shape, what)));
        }
        if mistakes.is_empty() {
            let dark = lamps.iter().zip(lamps_in_the_dark(&scene)).filter_map(|(shape, why)| Some((shape, why?)));
            mistakes.extend(dark.map(|(shape, why)| drawn.mistake(shape, format!("{}: {why}", name(shape)))));
        }
        if mistakes.is_empty() && scene.sources.is_empty() {
            mistakes.push(Failure::new(format!(
                "{path}: there is no lamp, so the picture would be black; give a circle or a line class=\"lamp\""
            )));
        }
        let mut of_all = |name: &str, range: RangeInclusive<f64>, usual: f64| {
            let read = number(&drawn, name, range, usual);
            read.map_err(|why| mistakes.push(drawn.mistake_of_all(why))).unwrap_or(usual)
        };
        let (ambient, stops) = (of_all("ambient", 0.0..=1.0, AMBIENT), of_all("exposure", -30.0..=30.0, 0.0));
        if mistakes.len() > MOST_TOLD {
            let more = mistakes.len() - MOST_TOLD;
            mistakes.truncate(MOST_TOLD);
            mistakes.push(Failure::new(format!("and {more} more mistakes")));
        }
        if mistakes.is_empty() {
            Ok(DrawnScene { scene, drawing: drawn, things, ambient, stops, warnings })
        } else {
            Err(mistakes)
        }
    }
}

/// A number that the drawing says as a whole.
fn number(drawn: &DrawnShapes, name: &str, range: RangeInclusive<f64>, usual: f64) -> Result<f64, String> {
    let Some(text) = drawn.data.get(name) else { return Ok(usual) };
    match text.parse::<f64>() {
        Ok(number) if range.contains(&number) => Ok(number),
        _ => Err(format!("its `data-{name}` is `{text}`; write a number from {} to {}", range.start(), range.end())),
    }
}

/// What a shape is called.
fn name(shape: &DrawnShape) -> String {
    shape.id.clone().unwrap_or_else(|| word(shape).to_string())
}

/// The word of its class that counts.
fn word(shape: &DrawnShape) -> &str {
    let own = shape.words.iter().find(|word| OWN_WORDS.contains(&word.as_str()));
    own.or(shape.words.first()).map_or("", String::as_str)
}

fn unread<'a>(shape: &'a DrawnShape, attributes: &Attributes<'a>) -> impl Iterator<Item = String> {
    let known: Vec<String> = attributes.known().into_iter().map(|name| format!("data-{name}")).collect();
    let known = if known.is_empty() { "none".to_string() } else { known.join(", ") };
    let (name, word) = (name(shape), word(shape).to_string());
    let kind = match word.as_str() {
        "lens" if body::is_closed(shape) => "lens of glass".to_string(),
        "lens" => "lens that is a line".to_string(),
        word => word.to_string(),
    };
    let unread = attributes.unread().into_iter().map(str::to_string).collect::<Vec<_>>();
    // What a table says of its things is no mistake in a scene.
    let is_tables = !OWN_WORDS.contains(&word.as_str());
    unread
        .into_iter()
        .filter(move |_| !is_tables)
        .map(move |unread| format!("{name}: a {kind} has no `data-{unread}`, so it says nothing; it may have {known}"))
}

fn thing(shape: &DrawnShape, attributes: &Attributes) -> Result<Thing, String> {
    let own: Vec<&str> = shape.words.iter().map(String::as_str).filter(|word| OWN_WORDS.contains(word)).collect();
    if let [one, other, ..] = own[..] {
        return Err(format!("it is both {one} and {other}; a thing is one of them"));
    }
    match word(shape) {
        "lamp" => Ok(Thing::Lamp(lamp::source(shape, attributes)?)),
        "mirror" => {
            let (of, band) = material::mirror(attributes)?;
            if matches!(of, Material::IdealMirror { .. }) && body::straight(shape).is_none() {
                return Err("a mirror with `data-focal-mm` is one straight line".to_string());
            }
            Ok(Thing::Bodies(vec![Body { band, ..body::line(shape, of) }]))
        }
        "lens" if !body::is_closed(shape) => {
            if body::straight(shape).is_none() {
                return Err(
                    "a lens is one straight line with `data-focal-mm`, or a closed outline of glass".to_string()
                );
            }
            Ok(Thing::Bodies(vec![body::line(shape, material::ideal_lens(attributes)?)]))
        }
        word if LIGHT_BENDING_WORDS.contains(&word) => {
            let of = material::glass(shape, attributes)?;
            let body = body::area(shape, of);
            let body = body.ok_or("its outline is open, so nobody knows where the glass ends; end its path with Z")?;
            Ok(Thing::Bodies(vec![body]))
        }
        word if ART_WORDS.contains(&word) => Ok(Thing::Art),
        _ => Ok(Thing::Bodies(body::solid(shape, material::wall(shape)?))),
    }
}

/// For each lamp why none of its light comes out, if that is so.
fn lamps_in_the_dark(scene: &Scene) -> Vec<Option<String>> {
    let surfaces = Surfaces::new(&scene.bodies, TOLERANCE_MM);
    let why = |lamp: &LightSource| {
        let media = surfaces.media_at(lamp.form.middle());
        let is_opaque = |glass: &Dielectric| glass.transmittance_per_mm.iter().all(|left| *left <= OPAQUE);
        let inside = media.iter().any(|body| match surfaces.material(*body) {
            Material::Dielectric(glass) => is_opaque(glass),
            _ => false,
        });
        inside.then(|| "it lies in glass that absorbs all of its light; give that glass a lighter tint".to_string())
    };
    scene.sources.iter().map(why).collect()
}
