//! `caustic optics`: what the detectors of an optical bench measure.

use super::print::print_lines;
use crate::cli::OpticsArgs;
use crate::optics::{Measurement, OpticsScene};
use crate::storage::text_file;
use crate::{Failure, tell};
use serde_json::json;

/// Of the light that is sent, what may be given up without a word.
const WORTH_TELLING: f64 = 1e-3;

/// Measures a scene and prints it.
///
/// # Errors
/// If the scene cannot be read.
pub fn run(args: &OpticsArgs) -> Result<(), Failure> {
    let text = text_file::read(&args.scene)?;
    let name = args.scene.display().to_string();
    let scene = OpticsScene::parse(&name, &text).map_err(Failure::of_many)?;
    scene.warnings.iter().for_each(|what| tell(&Failure::warning(what.clone())));
    scene.check_lit(&name)?;
    if scene.detectors.is_empty() {
        return Err(Failure::new(format!(
            "{name}: there is no Detector in this scene, so nothing is measured; add one"
        )));
    }
    let measurement = Measurement::of(&scene);
    let given_up = measurement.given_up.weak + measurement.given_up.long;
    if given_up > WORTH_TELLING * measurement.sent {
        tell(&Failure::warning(format!(
            "{name}: {:.2} % of the light was given up, for it divides too often; what is measured lacks it",
            100.0 * given_up / measurement.sent
        )));
    }
    if args.json { print_json(&scene, &measurement) } else { print_csv(&scene, &measurement) }
}

fn print_csv(scene: &OpticsScene, measurement: &Measurement) -> Result<(), Failure> {
    let count = scene.detectors.len();
    let mut lines = Vec::new();
    for (number, (detector, measured)) in scene.detectors.iter().zip(&measurement.measured).enumerate() {
        lines.push(format!(
            "# detector {} of {count}: power={:.6} normal_force={:.6} shear_force={:.6}",
            number + 1,
            measured.power,
            measured.normal_force,
            measured.shear_force
        ));
        if detector.bin.is_some() {
            lines.push("Position,Irradiance".to_string());
            let map = detector.irradiance(measured);
            lines.extend(map.into_iter().map(|(position, irradiance)| format!("{position},{irradiance}")));
        }
    }
    lines.push(given_up(measurement));
    print_lines(lines)
}

/// What was sent, and how much of it was not followed to its end.
fn given_up(measurement: &Measurement) -> String {
    let Measurement { given_up, sent, .. } = measurement;
    format!("# power sent={sent:.6} given_up={:.3e}", given_up.weak + given_up.long)
}

fn print_json(scene: &OpticsScene, measurement: &Measurement) -> Result<(), Failure> {
    let detectors = scene.detectors.iter().zip(&measurement.measured).map(|(detector, measured)| {
        json!({
            "power": measured.power,
            "normal_force": measured.normal_force,
            "shear_force": measured.shear_force,
            "irradiance": detector.irradiance(measured),
        })
    });
    let detectors: Vec<_> = detectors.collect();
    let given_up = measurement.given_up.weak + measurement.given_up.long;
    print_lines([json!({ "detectors": detectors, "sent": measurement.sent, "given_up": given_up }).to_string()])
}
