//! Fixtures: what the experiments are set up on: the chosen table, or only those of its parts that are asked about.

use crate::{Failure, Table};
use geometry::{Circle, Taper, trig};
use physics::{Command, Controls, Error, Flipper, FlipperControl, Kind, Layout, Machine, Part};
use std::sync::Arc;

/// The left button down and nothing else.
pub const LEFT: Controls = Controls { left: true, ..Controls::NONE };

/// The table's playfield with only those of its parts that `keep` wants.
pub fn bare(table: &Table, keep: impl Fn(&Part) -> bool) -> Layout {
    let parts = table.layout.parts.iter().filter(|part| keep(part)).cloned().collect();
    Layout { parts, ..table.layout.clone() }
}

/// A machine on this layout.
///
/// # Errors
/// If a number of the table cannot be.
pub fn machine(layout: Layout) -> Result<Machine, Failure> {
    Machine::new(Arc::new(layout)).map_err(|error| match error {
        Error::Layout(_, sentence) | Error::Save(sentence) => {
            Failure::new(format!("the physics refuses this table: {sentence}"))
        }
    })
}

/// The same with flippers that obey their buttons.
///
/// # Errors
/// As [`machine`].
pub fn live(layout: Layout) -> Result<Machine, Failure> {
    let mut machine = machine(layout)?;
    machine.tick(Controls::default(), &[Command::SetFlippers(true)]);
    Ok(machine)
}

/// The first flipper that answers to the left button, and its name.
///
/// # Errors
/// If the table has none.
pub fn left_flipper(table: &Table) -> Result<(&Part, &Flipper), Failure> {
    let flipper =
        |part: &'_ Part| matches!(&part.kind, Kind::Flipper(flipper) if flipper.control == FlipperControl::Left);
    let part = table.layout.parts.iter().find(|part| flipper(part));
    match part.map(|part| (part, &part.kind)) {
        Some((part, Kind::Flipper(flipper))) => Ok((part, flipper)),
        _ => Err(Failure::new(format!("the table {} has no left flipper to measure; choose another", table.name))),
    }
}

/// The outline of a flipper that points to `angle_rad`.
pub fn outline(flipper: &Flipper, angle_rad: f64) -> Taper {
    let center = flipper.base.center + trig::direction(angle_rad) * flipper.length_m;
    Taper { a: flipper.base, b: Circle { center, radius: flipper.tip_radius_m } }
}

/// The way that the machine's only flipper points, rad.
pub fn angle_rad(machine: &Machine) -> f64 {
    machine.pose().flippers_rad[0].1
}
