//! `caustic plot`: what the physics does, measured by running it, as pictures.
//!
//! Every plot is two functions: `measure` runs the machine and returns plain series, `draw` makes a picture of them.
//! No curve is drawn from a formula alone; where one is shown, what was measured lies on it.

pub mod energy;
mod fixture;
pub mod flipper;
mod ink;
mod panel;
pub mod restitution;
mod sheet;
pub mod shots;

use super::parallel;
use super::print::print;
use crate::cli::{Plot, PlotArgs};
use crate::storage::save_png;
use crate::storage::tables;
use crate::{Failure, Table};
use tracer::Frame;

/// Impacts of each material.
const IMPACTS: u32 = 25;
/// Balls that are thrown.
const BALLS: usize = 5;
/// How long they are watched, ms.
const FALL_MS: usize = 5000;

/// The plots, and how their files are called.
const PLOTS: [(Plot, &str); 4] =
    [(Plot::Flipper, "flipper"), (Plot::Shots, "shots"), (Plot::Restitution, "restitution"), (Plot::Energy, "energy")];

/// A plot.
pub struct Drawn {
    /// The picture.
    pub frame: Frame,
    /// What was found, as one sentence.
    pub finding: String,
}

/// Writes the plots that the command line asks for and prints what they found.
///
/// # Errors
/// If the table cannot be read or has nothing to measure, or a file cannot be written.
pub fn run(args: &PlotArgs) -> Result<(), Failure> {
    let table = tables::load(&args.table).map_err(Failure::of_many)?;
    let path = |name: &str| args.out.join(name).with_extension("png");
    let asked: Vec<(Plot, &str)> =
        PLOTS.into_iter().filter(|(plot, _)| args.plot == *plot || args.plot == Plot::All).collect();
    let before = asked.iter().map(|(_, name)| path(name)).find(|path| path.exists());
    if let Some(before) = before.filter(|_| !args.overwrite) {
        let before = before.display();
        return Err(Failure::new(format!(
            "{before} is there already: name another folder, or write over it with --overwrite"
        )));
    }
    parallel::make_folder(&args.out)?;
    for (plot, name) in asked {
        let drawn = draw(plot, &table, args)?;
        save_png(&drawn.frame, &path(name))?;
        print(&format!("{}: {}", path(name).display(), drawn.finding))?;
    }
    Ok(())
}

fn draw(plot: Plot, table: &Table, args: &PlotArgs) -> Result<Drawn, Failure> {
    match plot {
        Plot::Shots => shots::draw(&shots::measure(table, 1)?, table, args.size),
        Plot::Restitution => restitution::draw(&restitution::measure(table, IMPACTS)?, table, args.size),
        Plot::Energy => energy::draw(&energy::measure(table, BALLS, FALL_MS)?, table, args.size),
        Plot::Flipper | Plot::All => flipper::draw(&flipper::measure(table)?, table, args.size),
    }
}
