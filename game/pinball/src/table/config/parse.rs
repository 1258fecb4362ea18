//! Reads `table.toml`, word by word, and says what is wrong with each.
//!
//! Refuses to know what is drawn, except which ids there are and what they are.

use super::syntax;
use super::words::{TABLES, TOP, meant, setting_words, unknown};
use super::{Config, FinishOverrides, Settings};
use crate::spelling;
use crate::table::Profile;
use crate::table::source::{Diagnostic, Source};
use crate::table::svg::element_class::ElementClass;
use crate::table::svg::ids::Ids;
use crate::table::svg::style;
use physics::Material;
use std::collections::BTreeSet;
use std::ops::RangeInclusive;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// Reads the file; `drawn` says what each id in the drawing is, or nothing when the drawing could not be read.
pub(in crate::table) fn parse(source: &Source, drawn: Option<&Ids>, diagnostics: &mut Vec<Diagnostic>) -> Config {
    let (root, errors) = DeTable::parse_recoverable(&source.text);
    let (mut broken, mut config) = (BTreeSet::new(), Config::new());
    if let Some((line, quote)) = syntax::unclosed(&source.text).filter(|_| !errors.is_empty()) {
        let what = format!(
            "the text in {quote} that begins here is never closed, and swallows the rest; close it with {quote}"
        );
        diagnostics.push(source.diagnostic_in_line(line, what));
        broken.extend(line..=source.line(source.text.len()));
        config.is_cut = true;
    }
    for error in &errors {
        let line = source.line(error.span().map_or(0, |span| span.start));
        if broken.insert(line) {
            diagnostics.push(source.diagnostic_in_line(line, syntax::sentence(&source.text, line, error.message())));
            let lost = syntax::lost(&source.text, line);
            config.is_cut |= !lost.is_empty();
            broken.extend(lost);
        }
    }
    let mut reader = Reader { source, diagnostics, config, drawn, broken, materials: Vec::new() };
    reader.root(root.get_ref());
    reader.config
}

type Value<'i> = Spanned<DeValue<'i>>;
type Word<'i> = Spanned<std::borrow::Cow<'i, str>>;

struct Reader<'a> {
    source: &'a Source,
    diagnostics: &'a mut Vec<Diagnostic>,
    config: Config,
    drawn: Option<&'a Ids>,
    /// Lines that are not TOML: what they seem to say is no further diagnostic.
    broken: BTreeSet<usize>,
    /// The materials that are not there from the start.
    materials: Vec<NewMaterial>,
}

/// A material that the file makes.
struct NewMaterial {
    name: String,
    at: usize,
    /// What it does not say and must.
    missing: Vec<&'static str>,
}

impl Reader<'_> {
    fn diagnostic(&mut self, at: usize, what: impl std::fmt::Display) {
        // What the library makes of a value that it could not read stands nowhere.
        let is_nowhere = at == 0 && !self.broken.is_empty();
        if !is_nowhere && !self.broken.contains(&self.source.line(at)) {
            self.diagnostics.push(self.source.diagnostic(at, what));
        }
    }

    fn root(&mut self, root: &DeTable) {
        // Names first, so that classes and parts may come before what they name.
        for wanted in [&["material", "finish"][..], &["class", "part"]] {
            for (key, value) in root.iter().filter(|(key, _)| wanted.contains(&key.get_ref().as_ref())) {
                let Some(table) = self.table(key.get_ref(), value) else { continue };
                for (name, value) in table {
                    self.named(key.get_ref(), name, value);
                }
            }
        }
        for (key, value) in root {
            self.top(key, value);
        }
        self.review_materials();
    }

    fn top(&mut self, key: &Word, value: &Value) {
        match key.get_ref().as_ref() {
            "name" => self.config.title = self.text("name", value),
            "slope_deg" => self.set(value, "slope_deg", 0.5..=20.0, |config, x| config.slope_deg = x),
            "playfield_friction" => {
                self.set(value, "playfield_friction", 0.0..=1.0, |config, x| config.playfield_friction = x);
            }
            "ambient" => {
                if let Some(color) = self.color("ambient", value) {
                    self.config.ambient = color;
                }
            }
            "ambient_power" => self.set(value, "ambient_power", 0.0..=100.0, |config, x| config.ambient_power = x),
            "relief_mm" => self.set(value, "relief_mm", 0.0..=5.0, |config, x| config.normal_map.height_mm = x),
            "relief" => self.normal_map(value),
            "material" | "finish" | "class" | "part" => {}
            other => {
                let what = format!(
                    "`{other}` is not known{}; there are {}, [relief], [material.NAME], [finish.NAME], [class.NAME] and \
                     [part.ID]",
                    meant(other, TOP.into_iter().chain(TABLES)),
                    TOP.join(", ")
                );
                self.diagnostic(key.span().start, what);
            }
        }
    }

    fn normal_map(&mut self, value: &Value) {
        let Some(table) = self.table("relief", value) else { return };
        for (key, value) in table {
            match key.get_ref().as_ref() {
                "planks_mm" => {
                    // Narrower boards than 5 mm would be nothing but seams.
                    let planks = self.number("planks_mm", value, 0.0..=1000.0);
                    match planks {
                        Some(width) if width > 0.0 && width < 5.0 => {
                            let why = "`planks_mm` must be 0, for no planks, or a width from 5 to 1000";
                            self.diagnostic(value.span().start, why);
                        }
                        Some(width) => self.config.normal_map.planks_mm = width,
                        None => {}
                    }
                }
                "grain" => self.set(value, "grain", 0.0..=1.0, |config, x| config.normal_map.grain = x),
                "scratches" => self.set(value, "scratches", 0.0..=1.0, |config, x| config.normal_map.scratches = x),
                "inserts" => self.set(value, "inserts", 0.0..=1.0, |config, x| config.normal_map.inserts = x),
                "gloss" => self.set(value, "gloss", 0.0..=1.0, |config, x| config.normal_map.gloss = x as f32),
                other => self.unknown(key.span().start, other, "planks_mm, grain, scratches, inserts, gloss"),
            }
        }
    }

    fn set(&mut self, value: &Value, name: &str, range: RangeInclusive<f64>, set: impl Fn(&mut Config, f64)) {
        if let Some(x) = self.number(name, value, range) {
            set(&mut self.config, x);
        }
    }

    fn named(&mut self, kind: &str, name: &Word, value: &Value) {
        let Some(table) = self.table(name.get_ref(), value) else { return };
        let at = name.span().start;
        let name = name.get_ref().to_string();
        match kind {
            "material" => self.material(at, &name, table),
            "finish" => {
                let finish = self.finish(table);
                self.config.finish_places.insert(name.clone(), at);
                self.config.finishes.insert(name, finish);
            }
            "class" => match ElementClass::from_word(&name) {
                Some(class) => {
                    let settings = self.settings(class, table);
                    self.config.classes.insert(class, settings);
                }
                None => {
                    let meant = meant(&name, ElementClass::ALL.into_iter().map(ElementClass::word));
                    let known = ElementClass::words();
                    self.diagnostic(at, format!("there is no class `{name}`{meant}; there are {known}"));
                }
            },
            _ => self.part(at, name, table),
        }
    }

    fn part(&mut self, at: usize, name: String, table: &DeTable) {
        let Some(drawn) = self.drawn else { return };
        match drawn.class(&name) {
            Some(class) => {
                let settings = self.settings(class, table);
                self.config.parts.insert(name, settings);
            }
            None if drawn.is_refused(&name) => {}
            None => {
                let art = drawn.art().get(&name).map(|why| format!(": {why}"));
                let meant = art.unwrap_or_else(|| meant(&name, drawn.all()));
                self.diagnostic(at, format!("no thing in the drawing has the id `{name}`{meant}"));
            }
        }
    }

    /// Reads a material; of one that is there from the start the rest stays as it was.
    fn material(&mut self, at: usize, name: &str, table: &DeTable) {
        let known = self.config.materials.get(name).copied();
        let mut material = known.unwrap_or(Material { restitution: 0.0, falloff_s_per_m: 0.0, friction: 0.0 });
        for (key, value) in table {
            let (range, number) = match key.get_ref().as_ref() {
                "restitution" => (0.0..=1.0, &mut material.restitution),
                "falloff_s_per_m" => (0.0..=100.0, &mut material.falloff_s_per_m),
                "friction" => (0.0..=10.0, &mut material.friction),
                other => {
                    self.unknown(key.span().start, other, "restitution, falloff_s_per_m, friction");
                    continue;
                }
            };
            if let Some(given) = self.number(key.get_ref(), value, range) {
                *number = given;
            }
        }
        if known.is_none() {
            let missing = ["restitution", "friction"].into_iter().filter(|key| !table.contains_key(*key)).collect();
            self.materials.push(NewMaterial { name: name.to_string(), at, missing });
        }
        self.config.materials.insert(name.to_string(), material);
    }

    /// Tells of new materials what they lack, and those that nothing is made of.
    fn review_materials(&mut self) {
        let new = std::mem::take(&mut self.materials);
        let is_new = |name: &str| new.iter().any(|material| material.name == name);
        let known: Vec<String> = self.config.materials.keys().filter(|name| !is_new(name)).cloned().collect();
        // Without the drawing nothing is known of parts, and what is mistaken may have been to name it.
        let is_known = self.drawn.is_some() && self.diagnostics.iter().all(Diagnostic::is_warning);
        for NewMaterial { name, at, missing } in &new {
            let is_idle = is_known && !self.config.is_made_of(name);
            let meant = spelling::near(name, known.iter().map(String::as_str)).filter(|_| is_idle);
            // Of three letters a third is too much to be one letter off: `foo` is no `wood`.
            let meant = meant.filter(|meant| name.len() > 3 || meant.len() == name.len());
            if let Some(meant) = meant {
                self.diagnostic(*at, format!("nothing is made of `{name}`; did you mean `{meant}`?"));
            } else if !missing.is_empty() && self.broken.is_empty() {
                let missing = missing.join("` and no `");
                self.diagnostic(*at, format!("the material `{name}` has no `{missing}`"));
            } else if is_idle {
                let what = format!(
                    "nothing is made of `{name}`; write material = \"{name}\" to a [class.NAME] or a [part.ID], or take it out"
                );
                self.diagnostics.push(self.source.diagnostic(*at, what).into_warning());
            }
        }
    }

    fn finish(&mut self, table: &DeTable) -> FinishOverrides {
        let mut finish = FinishOverrides::default();
        for (key, value) in table {
            match key.get_ref().as_ref() {
                "albedo" => finish.albedo = self.color("albedo", value),
                "gloss" => finish.gloss = self.number("gloss", value, 0.0..=1.0).map(|x| x as f32),
                "opacity" => finish.opacity = self.number("opacity", value, 0.0..=1.0).map(|x| x as f32),
                "translucency" => {
                    finish.translucency = self.number("translucency", value, 0.0..=1.0).map(|x| x as f32);
                }
                "emission" => finish.emission = self.color("emission", value),
                "emission_power" => {
                    finish.emission_power = self.number("emission_power", value, 0.0..=100.0).map(|x| x as f32);
                }
                "profile" => finish.profile = self.profile(value),
                other => {
                    let known = "albedo, gloss, profile, opacity, translucency, emission, emission_power";
                    self.unknown(key.span().start, other, known);
                }
            }
        }
        finish
    }

    fn profile(&mut self, value: &Value) -> Option<Profile> {
        let text = self.text("profile", value)?;
        if text == "dome" {
            return Some(Profile::Dome);
        }
        let width = text.strip_prefix("bevel ").and_then(|width| width.trim().parse::<f32>().ok());
        let profile = width.filter(|width| (0.0..=100.0).contains(width)).map(Profile::Bevel);
        if profile.is_none() {
            let at = value.span().start;
            self.diagnostic(
                at,
                format!("the profile is `{text}`; write \"dome\", or \"bevel 0.8\" for an edge of 0.8 mm"),
            );
        }
        profile
    }

    fn settings(&mut self, class: ElementClass, table: &DeTable) -> Settings {
        let mut settings = Settings::default();
        for (key, value) in table {
            let word = key.get_ref().as_ref();
            match word {
                "material" if class.has_material() => settings.material = self.known_material(value),
                "finish" if class.has_finish() => settings.finish = self.known_finish(value),
                "shadow" if class.has_finish() => settings.shadow = self.truth("shadow", value),
                _ => match class.parameters().iter().find(|known| known.name == word) {
                    Some(known) => match self.number(known.name, value, known.min..=known.max) {
                        Some(x) => drop(settings.numbers.insert(known.name, (x, value.span().start))),
                        None => drop(settings.refused.insert(known.name)),
                    },
                    None => self.unknown(key.span().start, word, &setting_words(class)),
                },
            }
        }
        settings
    }

    fn known_material(&mut self, value: &Value) -> Option<String> {
        let word = self.text("material", value)?;
        if self.config.materials.contains_key(&word) {
            return Some(word);
        }
        let known: Vec<&str> = self.config.materials.keys().map(String::as_str).collect();
        let known = known.join(", ");
        let meant = meant(&word, known.split(", "));
        if self.config.is_cut {
            return None;
        }
        self.diagnostic(value.span().start, format!("there is no material `{word}`{meant}; there are {known}"));
        None
    }

    fn known_finish(&mut self, value: &Value) -> Option<String> {
        let word = self.text("finish", value)?;
        if self.config.finishes.contains_key(&word) {
            return Some(word);
        }
        let known: Vec<&str> = self.config.finishes.keys().map(String::as_str).collect();
        let meant = meant(&word, known.iter().copied());
        let known = if known.is_empty() { "none yet; write [finish.NAME]".to_string() } else { known.join(", ") };
        if self.config.is_cut {
            return None;
        }
        self.diagnostic(value.span().start, format!("there is no finish `{word}`{meant}; there are {known}"));
        None
    }

    fn unknown(&mut self, at: usize, word: &str, known: &str) {
        let is_dotted = self.source.text.get(at + word.len()..).is_some_and(|rest| rest.starts_with('.'));
        self.diagnostic(at, unknown(word, is_dotted, known));
    }

    fn table<'t, 'i>(&mut self, name: &str, value: &'t Value<'i>) -> Option<&'t DeTable<'i>> {
        match value.get_ref() {
            DeValue::Table(table) => Some(table),
            _ => {
                self.diagnostic(value.span().start, format!("`{name}` must be a table, as in [material.rubber]"));
                None
            }
        }
    }

    fn text(&mut self, name: &str, value: &Value) -> Option<String> {
        match value.get_ref() {
            DeValue::String(text) => Some(text.to_string()),
            _ => {
                self.diagnostic(value.span().start, format!("`{name}` must be text in quotes"));
                None
            }
        }
    }

    fn truth(&mut self, name: &str, value: &Value) -> Option<bool> {
        match value.get_ref() {
            DeValue::Boolean(truth) => Some(*truth),
            _ => {
                self.diagnostic(value.span().start, format!("`{name}` must be true or false"));
                None
            }
        }
    }

    fn color(&mut self, name: &str, value: &Value) -> Option<[u8; 3]> {
        let text = self.text(name, value)?;
        let color = style::color(&text);
        color.map_err(|why| self.diagnostic(value.span().start, format!("{name}: {why}"))).ok()
    }

    fn number(&mut self, name: &str, value: &Value, range: RangeInclusive<f64>) -> Option<f64> {
        let number = match value.get_ref() {
            DeValue::Float(float) => float.as_str().parse::<f64>().ok(),
            DeValue::Integer(integer) if integer.radix() == 10 => integer.as_str().parse::<f64>().ok(),
            _ => None,
        };
        let number = number.filter(|number| range.contains(number));
        if number.is_none() {
            let (min, max) = range.into_inner();
            self.diagnostic(value.span().start, format!("`{name}` must be a number from {min} to {max}"));
        }
        number
    }
}
