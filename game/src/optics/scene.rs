//! A scene of ray-optics: its JSON, as sources, bodies and detectors.

use super::detector::{Detector, MOST_BINS, MOST_DETECTORS};
use super::fields::Fields;
use super::objects::{self, MOST_CORNERS, Object};
use super::sources::{MOST_RAYS, RayDensity, SourceRay};
use crate::Failure;
use serde_json::Value;
use tracer::transport::Body;

/// Objects at most.
const MOST_OBJECTS: usize = 100_000;

/// Pairs of a ray and a detector at most: some ten seconds, if no ray divides.
const MOST_PAIRS: usize = 200_000_000;

/// What a scene says that matters to its light.
#[derive(Clone, Debug, Default)]
pub struct OpticsScene {
    /// All rays of its sources.
    pub rays: Vec<SourceRay>,
    /// What they meet.
    pub bodies: Vec<Body>,
    /// What is measured.
    pub detectors: Vec<Detector>,
    /// The length of a unit: hits nearer to each other than a millionth of it are one.
    pub length_scale: f64,
    /// Wavelengths have their colours and act.
    pub colors: bool,
    /// Surfaces that a ray may meet.
    pub most_surfaces: Option<u32>,
    /// What the file says and is not read, sentences.
    pub warnings: Vec<String>,
}

/// Fields of the top that change no measurement.
const EDITOR_FIELDS: [&str; 26] = [
    "version",
    "name",
    "modules",
    "width",
    "height",
    "origin",
    "scale",
    "showGrid",
    "snapToGrid",
    "gridSize",
    "lockObjs",
    "observer",
    "randomSeed",
    "theme",
    "symbolBodyMerging",
    "backgroundImage",
    "credits",
    "description",
    "title",
    "snapToDirection",
    "showRayArrows",
    "layoutAids",
    "localLayoutAids",
    "date",
    "author",
    "objs",
];

/// Ways to look at a scene: they differ in how many rays there are.
const MODES: [&str; 4] = ["rays", "extended", "images", "observer"];

impl OpticsScene {
    /// Whether it sends any light.
    ///
    /// # Errors
    /// If it does not: nothing could be seen or measured.
    pub fn check_lit(&self, name: &str) -> Result<(), Failure> {
        if self.rays.is_empty() {
            let what = "there is no source of light in this scene; add a PointSource, a Beam or a SingleRay";
            return Err(Failure::new(format!("{name}: {what}")));
        }
        Ok(())
    }

    /// Reads a scene; `name` is the file's.
    ///
    /// # Errors
    /// One sentence for each thing that is wrong or cannot be read.
    pub fn parse(name: &str, text: &str) -> Result<OpticsScene, Vec<Failure>> {
        let one = |what: String| vec![Failure::new(what)];
        let value: Value = serde_json::from_str(text.trim_start_matches('\u{feff}')).map_err(|error| {
            let (line, column, said) = (error.line(), error.column().max(1), error.to_string());
            let what = said.split(" at line ").next().unwrap_or(&said);
            one(format!("{name}:{line}:{column}: this is not JSON, of which ray-optics scenes are made: {what}"))
        })?;
        let Value::Object(top) = &value else {
            return Err(one(format!("{name}: a scene is a JSON object: {{\"objs\": [..]}}")));
        };
        let top = Fields::new(top);
        top.ignore(&EDITOR_FIELDS);
        let mut scene = OpticsScene::default();
        let density = scene.read_top(&top).map_err(|what| one(format!("{name}: {what}")))?;
        let colors = top.flag("simulateColors", false).map_err(|what| one(format!("{name}: {what}")))?;
        scene.colors = colors;
        let objects = top.list("objs").map_err(|what| one(format!("{name}: {what} of the scene's objects")))?;
        if objects.len() > MOST_OBJECTS {
            return Err(one(format!("{name}: there are {} objects; at most {MOST_OBJECTS} are read", objects.len())));
        }
        let mut failures = Vec::new();
        let mut corners = 0;
        for (number, object) in objects.iter().enumerate() {
            corners += object.get("path").and_then(Value::as_array).map_or(0, Vec::len);
            if corners > MOST_CORNERS {
                let what =
                    format!("the outlines of all objects have more than {MOST_CORNERS} corners; draw some coarser");
                return Err(one(format!("{name}: object {number}: {what}")));
            }
            if let Err(what) = scene.read_object(name, number, object, &density, colors) {
                failures.push(Failure::new(what));
            }
        }
        let unread = top.unread().into_iter().map(|field| format!("{name}: \"{field}\" is not read"));
        scene.warnings.splice(0..0, unread);
        failures.extend(scene.check_sums().err().map(|what| Failure::new(format!("{name}: {what}"))));
        if failures.is_empty() { Ok(scene) } else { Err(failures) }
    }

    /// What all objects together may not be.
    fn check_sums(&self) -> Result<(), String> {
        let (detectors, rays) = (self.detectors.len(), self.rays.len());
        if detectors > MOST_DETECTORS {
            return Err(format!("there are {detectors} detectors; at most {MOST_DETECTORS} are read"));
        }
        let bins: f64 = self.detectors.iter().map(Detector::bins).sum();
        if bins > MOST_BINS {
            return Err(format!(
                "the irradiance maps of all detectors have {bins:.0} bins; at most {MOST_BINS:.0} are measured: give a \
                 larger \"binSize\""
            ));
        }
        if detectors * rays > MOST_PAIRS {
            return Err(format!(
                "{rays} rays and {detectors} detectors are {} pairs to measure; at most {MOST_PAIRS} are: give fewer \
                 detectors, or a lower density of rays",
                detectors * rays
            ));
        }
        Ok(())
    }

    /// What the top of the file says.
    fn read_top(&mut self, top: &Fields) -> Result<RayDensity, String> {
        let mode = top.text("mode")?.unwrap_or("rays");
        if !MODES.contains(&mode) {
            return Err(format!("\"mode\" is \"{mode}\"; it may be {}", MODES.join(", ")));
        }
        let (ray_density, image_density) = (top.number("rayModeDensity", 0.1)?, top.number("imageModeDensity", 1.0)?);
        let density = if matches!(mode, "rays" | "extended") { ray_density } else { image_density };
        let length_scale = top.number("lengthScale", 1.0)?;
        if !(density > 0.0 && length_scale > 0.0) {
            return Err("the density of rays and \"lengthScale\" must be over 0".to_string());
        }
        let correct_brightness = top.text("colorMode")?.unwrap_or("default") != "default";
        let depth = top.number("maxRayDepth", f64::from(u32::MAX))?;
        self.most_surfaces = (depth < f64::from(u32::MAX)).then_some(depth.max(0.0) as u32);
        self.length_scale = length_scale;
        Ok(RayDensity { density, length_scale, correct_brightness })
    }

    fn read_object(
        &mut self,
        name: &str,
        number: usize,
        object: &Value,
        density: &RayDensity,
        colors: bool,
    ) -> Result<(), String> {
        let at = |kind: &str, what: &str| format!("{name}: object {number}{kind}: {what}");
        let Value::Object(map) = object else { return Err(at("", "it must be a JSON object with a \"type\"")) };
        let fields = Fields::new(map);
        fields.ignore(&["name", "notDone", "snapToGrid"]);
        let kind = fields.text("type").map_err(|what| at("", &what))?.ok_or_else(|| at("", "\"type\" is missing"))?;
        let place = format!(" ({kind})");
        let wrong = |what: String| at(&place, &what);
        match objects::read(kind, &fields, colors).map_err(wrong)? {
            Object::Source(source, brightness, wavelength_nm) => {
                let rays = source.rays(density, brightness, wavelength_nm);
                let rays = rays.filter(|rays| self.rays.len() + rays.len() <= MOST_RAYS);
                self.rays.extend(rays.ok_or_else(|| {
                    wrong(format!("its rays are none or too many: all sources together have {MOST_RAYS} at most"))
                })?);
            }
            Object::Bodies(bodies) => self.bodies.extend(bodies),
            Object::Detector(detector) => self.detectors.push(detector),
            Object::Decoration => return Ok(()),
        }
        // A glass, a source: what it has besides is told, for it may matter.
        fields.ignore(&["filter", "invert", "wavelength", "bandwidth"]);
        self.warnings.extend(fields.unread().into_iter().map(|field| at(&place, &format!("\"{field}\" is not read"))));
        Ok(())
    }
}
