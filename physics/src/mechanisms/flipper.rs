//! Flipper: its numbers, and what turns it. A diverter is a flipper that the rules turn.
//!
//! How it turns is in `crate::mechanisms::flipper_model`.

use crate::mechanisms::controls::Controls;
use crate::mechanisms::flipper_model::FlipperModel;
use crate::mechanisms::model::Model;
use crate::mechanisms::{MechanismModels, MechanismStates};
use crate::part::PartId;
use crate::part::material::Material;
use crate::part::validation::{self, Checked};
use geometry::{Circle, Taper, trig};
use serde::{Deserialize, Serialize};

/// The longest stroke, rad: a little over half a turn.
const MAX_STROKE_RAD: f64 = 3.2;

/// What turns a flipper up.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum FlipperControl {
    /// The left button, while flippers are live.
    Left,
    /// The right button, while flippers are live.
    Right,
    /// [`crate::Command::Divert`], whatever the buttons do and whether flippers are live or not: a diverter.
    Rules,
}

/// A flipper: the hull of two discs that turns round the first. A diverter is one with equal discs.
///
/// Numbers that give a real one's strokes (up in 19 to 26 ms, back at rest in 85 to 100 ms, tip at 5 to 6.5 m/s) for
/// base 11.6 mm, tip 7 mm, `length_m` 60.5 mm and a stroke of 51 degrees: coil 3.3, hold 1.4, spring 0.32 N m, 0.30 kg.
/// For another length keep torque over moment of inertia.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Flipper {
    /// The disc at the pivot.
    pub base: Circle,
    /// From the pivot to the centre of the tip's disc, m.
    pub length_m: f64,
    /// Radius of the tip's disc, m.
    pub tip_radius_m: f64,
    /// The angle at which it points at rest, rad (y down: positive is clockwise on the screen).
    pub rest_rad: f64,
    /// The angle at which it points at the end of its stroke, rad.
    pub up_rad: f64,
    /// What turns it up.
    pub control: FlipperControl,
    /// Its rubber.
    pub material: Material,
    /// Torque of the full coil, N m.
    pub coil_torque_n_m: f64,
    /// Torque of the held coil, N m.
    pub hold_torque_n_m: f64,
    /// Torque of the return spring, N m.
    pub spring_torque_n_m: f64,
    /// Mass, kg; its moment of inertia is m L^2 / 3 with L from pivot to the end of the tip.
    pub mass_kg: f64,
}

impl Flipper {
    /// Its outline when it points this way, m.
    pub fn outline(&self, angle_rad: f64) -> Taper {
        let tip = self.base.center + trig::direction(angle_rad) * self.length_m;
        Taper { a: self.base, b: Circle { center: tip, radius: self.tip_radius_m } }
    }

    pub(crate) fn check(&self) -> Checked {
        validation::circle(&self.base)?;
        validation::positive("the length", self.length_m)?;
        validation::positive("the tip's radius", self.tip_radius_m)?;
        validation::finite("the angle at rest", self.rest_rad)?;
        validation::finite("the angle when up", self.up_rad)?;
        validation::positive("the stroke", (self.up_rad - self.rest_rad).abs())?;
        validation::at_most("the stroke", (self.up_rad - self.rest_rad).abs(), MAX_STROKE_RAD)?;
        validation::positive("the coil's torque", self.coil_torque_n_m)?;
        validation::positive("the hold torque", self.hold_torque_n_m)?;
        validation::positive("the spring's torque", self.spring_torque_n_m)?;
        validation::positive("the mass", self.mass_kg)?;
        if self.hold_torque_n_m <= self.spring_torque_n_m {
            return Err("the hold torque must be more than the spring's".into());
        }
        validation::material(&self.material)
    }

    pub(crate) fn add_to(&self, part: PartId, model: &mut Model) {
        model.mechanisms.flippers.push(FlipperModel::new(part, self));
    }
}

/// For each flipper whether its coil is on.
pub(crate) fn coils(models: &MechanismModels, states: &MechanismStates, controls: &Controls) -> Vec<bool> {
    let is_on = |(model, &diverted): (&FlipperModel, &bool)| match model.flipper.control {
        FlipperControl::Left => states.flippers_enabled && controls.left,
        FlipperControl::Right => states.flippers_enabled && controls.right,
        FlipperControl::Rules => diverted,
    };
    models.flippers.iter().zip(&states.diverted).map(is_on).collect()
}

/// Turns a diverter on or off: a flipper with a button takes no notice.
pub(crate) fn divert(models: &MechanismModels, states: &mut MechanismStates, part: PartId, on: bool) {
    if let Some(flipper) = models.flippers.iter().position(|model| model.part == part) {
        states.diverted[flipper] = on;
    }
}
