//! Direct light of a scene of transport, by the game's own integrators.

use geometry::{Core, Shape};
use tracer::monte_carlo::Sampling;
use tracer::transport::spectrum::Weights;
use tracer::transport::{Body, Curve, Falloff, LightSource, Scene, SourceForm, into_gamut};
use tracer::{Floor, Group, Integrator, ItemId, Lamp, Material, Occluder, Radiance, View, render};

/// The direct light in each pixel, row by row: every outline is opaque.
///
/// # Errors
/// If a lamp or an outline is of a kind that direct light does not know.
pub fn fluence(
    scene: &Scene,
    view: &View,
    weights: &Weights,
    sampling: Option<Sampling>,
) -> Result<Vec<[f64; 3]>, String> {
    let floor = Floor::plain(view.width, view.height, [255; 3]);
    let mut direct = tracer::Scene::new(*view, &floor);
    direct.ambient = [0.0; 3];
    for (number, source) in scene.sources.iter().enumerate() {
        direct.lamps.push(lamp(ItemId(number as u32), source, weights)?);
    }
    for body in &scene.bodies {
        occluders(body, &mut direct.occluders)?;
    }
    let mut radiance = Radiance::default();
    render(&direct, sampling.map_or(Integrator::Exact, Integrator::MonteCarlo), &mut radiance);
    let pixels =
        (0..view.width * view.height).map(|at| radiance.pixel(at % view.width, at / view.width).map(f64::from));
    Ok(pixels.collect())
}

fn lamp(id: ItemId, source: &LightSource, weights: &Weights) -> Result<Lamp, String> {
    let Falloff::Table { height_mm, reach_mm } = source.falloff else {
        return Err("direct light fades as on a table: write data-falloff=\"table\" on the drawing's <svg>".to_string());
    };
    let color = into_gamut(source.color(weights)).map(|channel| channel as f32);
    let lamp = match source.form {
        SourceForm::Point(center) => Lamp::disc(id, center, 0.0, color),
        SourceForm::Disc { center, radius } => Lamp::disc(id, center, radius, color),
        SourceForm::Tube(line) => Lamp::of_tube(id, (line.a + line.b) * 0.5, line.along() * 0.5, color),
        SourceForm::Cone { .. } | SourceForm::Beam { .. } => {
            return Err(
                "direct light knows lamps that shine all around; this drawing has one with `data-beam-deg`".to_string()
            );
        }
    };
    Ok(Lamp { height_mm, reach_mm, ..lamp })
}

fn occluders(body: &Body, occluders: &mut Vec<Occluder>) -> Result<(), String> {
    for edge in &body.edges {
        let core = match edge.curve {
            Curve::Line(line) => Core::Segment(line),
            Curve::Arc(arc) => Core::Arc(arc),
            Curve::Parabola(_) => {
                return Err("direct light knows lines and arcs; this scene has a parabola".to_string());
            }
        };
        let id = ItemId(occluders.len() as u32);
        let group = Group(u16::MAX);
        occluders.push(Occluder { id, shape: Shape { core, radius: 0.0 }, group, material: Material::Opaque });
    }
    Ok(())
}
