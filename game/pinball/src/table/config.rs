//! The configuration in `table.toml`: materials, finishes, and numbers by class and by id; and what holds when the file
//! says nothing.

mod hint;
mod idle;
mod parse;
mod syntax;
mod torques;
mod words;

pub(super) use idle::warnings as idle_warnings;
pub(super) use parse::parse;
pub(super) use torques::mistakes as torque_mistakes;

use super::Profile;
use super::normal_map::NormalMapInputs;
use super::svg::element_class::ElementClass;
use physics::Material;
use std::collections::{BTreeMap, BTreeSet};

/// The configuration of a table.
#[derive(Debug)]
pub(super) struct Config {
    pub title: Option<String>,
    pub slope_deg: f64,
    pub playfield_friction: f64,
    /// sRGB.
    pub ambient: [u8; 3],
    pub ambient_power: f64,
    /// Its numbers; the art is the drawing's.
    pub normal_map: NormalMapInputs,
    pub materials: BTreeMap<String, Material>,
    pub finishes: BTreeMap<String, FinishOverrides>,
    /// The byte at which the file says each of them.
    finish_places: BTreeMap<String, usize>,
    classes: BTreeMap<ElementClass, Settings>,
    parts: BTreeMap<String, Settings>,
    /// Names are missing, for what names them cannot be read, which has been told.
    pub is_cut: bool,
}

/// A `[finish.NAME]`; what it does not say comes from the class and the drawing.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct FinishOverrides {
    /// sRGB.
    pub albedo: Option<[u8; 3]>,
    pub gloss: Option<f32>,
    pub profile: Option<Profile>,
    pub opacity: Option<f32>,
    /// How much of the light below comes through.
    pub translucency: Option<f32>,
    /// sRGB.
    pub emission: Option<[u8; 3]>,
    pub emission_power: Option<f32>,
}

/// What is said of a class or of one element.
#[derive(Clone, Debug, Default)]
pub(super) struct Settings {
    material: Option<String>,
    finish: Option<String>,
    shadow: Option<bool>,
    /// Each with the byte at which the file says it.
    numbers: BTreeMap<&'static str, (f64, usize)>,
    /// Those that the file says, and that could not be read or are out of range.
    refused: BTreeSet<&'static str>,
}

impl Config {
    /// The number `key` of the element called `name`.
    pub fn number(&self, class: ElementClass, name: &str, key: &'static str) -> f64 {
        let default = class.parameters().iter().find(|known| known.name == key).map_or(0.0, |known| known.default);
        self.given(class, name, key).map_or(default, |(number, _)| number)
    }

    /// The number `key` of the element called `name` if the file says it, and the byte at which it does.
    pub fn given(&self, class: ElementClass, name: &str, key: &str) -> Option<(f64, usize)> {
        self.setting(class, name, |settings| settings.numbers.get(key).copied())
    }

    /// Whether the file says this number of the element and it was told to be wrong, so that nothing follows from it.
    fn is_refused(&self, class: ElementClass, name: &str, key: &str) -> bool {
        self.setting(class, name, |settings| settings.refused.contains(key).then_some(())).is_some()
    }

    /// Whether a class or a thing is said to be made of this material.
    fn is_made_of(&self, material: &str) -> bool {
        let all = self.classes.values().chain(self.parts.values());
        all.filter_map(|settings| settings.material.as_deref()).any(|word| word == material)
    }

    /// Whether a class or a thing is said to look so.
    fn is_finished_by(&self, finish: &str) -> bool {
        let all = self.classes.values().chain(self.parts.values());
        all.filter_map(|settings| settings.finish.as_deref()).any(|word| word == finish)
    }

    /// Whether the element was said to cast a shadow.
    pub fn shadow(&self, class: ElementClass, name: &str) -> Option<bool> {
        self.setting(class, name, |settings| settings.shadow)
    }

    /// What the element was said to be made of.
    pub fn material(&self, class: ElementClass, name: &str) -> Option<&Material> {
        self.setting(class, name, |settings| settings.material.as_ref()).and_then(|word| self.materials.get(word))
    }

    /// How the element was said to look.
    pub fn finish(&self, class: ElementClass, name: &str) -> Option<&FinishOverrides> {
        self.setting(class, name, |settings| settings.finish.as_ref()).and_then(|word| self.finishes.get(word))
    }

    /// The finish of this name.
    ///
    /// # Errors
    /// If there is none.
    pub fn finish_named(&self, name: &str) -> Result<&FinishOverrides, String> {
        self.finishes.get(name).ok_or_else(|| {
            let known: Vec<&str> = self.finishes.keys().map(String::as_str).collect();
            let known = match known.as_slice() {
                [] => "none yet".to_string(),
                [only] => format!("there is {only}"),
                _ => format!("there are {}", known.join(", ")),
            };
            format!("data-finish: there is no [finish.{name}] in table.toml; {known}")
        })
    }

    fn setting<'a, T>(
        &'a self,
        class: ElementClass,
        name: &str,
        what: impl Fn(&'a Settings) -> Option<T>,
    ) -> Option<T> {
        self.parts.get(name).and_then(&what).or_else(|| self.classes.get(&class).and_then(&what))
    }
}

impl Config {
    /// What holds when the file says nothing: figures of real machines.
    fn new() -> Config {
        let material = |restitution, falloff_s_per_m, friction| Material { restitution, falloff_s_per_m, friction };
        let known = [
            ("rubber", material(0.85, 0.13, 0.3)),
            ("post", material(0.9, 0.1, 0.3)),
            ("sleeve", material(0.77, 0.1, 0.3)),
            ("wood", material(0.4, 0.0, 0.25)),
            ("metal", material(0.3, 0.0, 0.2)),
            ("wire", material(0.45, 0.0, 0.15)),
            ("target", material(0.35, 0.5, 0.2)),
            ("drop-target", material(0.38, 0.15, 0.2)),
            ("flipper-rubber", material(0.88, 0.15, 0.9)),
        ];
        Config {
            title: None,
            slope_deg: 6.5,
            playfield_friction: 0.09,
            ambient: [11, 13, 24],
            ambient_power: 0.5,
            normal_map: NormalMapInputs::default(),
            materials: known.into_iter().map(|(name, material)| (name.to_string(), material)).collect(),
            finishes: BTreeMap::new(),
            finish_places: BTreeMap::new(),
            classes: BTreeMap::new(),
            parts: BTreeMap::new(),
            is_cut: false,
        }
    }
}
