//! A table's scene of direct light as one of transport: the opposite way is `direct`.

use tracer::transport::spectrum::Emission;
use tracer::transport::{Body, Falloff, LightSource, Material, Scene, SourceForm};
use tracer::{Emitter, Lamp};

/// What walls of a table reflect: no drawing says it.
const REFLECTANCE: [f64; 3] = [0.5; 3];

/// A table's lamps, each white and of power 1, and its opaque occluders as matt walls; and the colours of the lamps. Left out is
/// what lamps stand inside of, since it lets their light out, tinted things, which light passes straight, and balls.
pub fn table_scene(scene: &tracer::Scene) -> (Scene, Vec<[f64; 3]>) {
    let lets_light_out = |group| scene.lamps.iter().any(|lamp| lamp.inside == Some(group));
    let is_ball = |group| scene.balls.iter().any(|ball| ball.group == group);
    let walls = scene.occluders.iter().filter(|occluder| {
        occluder.material == tracer::Material::Opaque && !lets_light_out(occluder.group) && !is_ball(occluder.group)
    });
    let bodies = walls.map(|wall| Body::of_shape(&wall.shape, Material::Diffuse { reflectance: REFLECTANCE }));
    let colors = scene.lamps.iter().map(|lamp| lamp.color.map(f64::from)).collect();
    (Scene { bodies: bodies.collect(), sources: scene.lamps.iter().map(source).collect() }, colors)
}

fn source(lamp: &Lamp) -> LightSource {
    let form = match lamp.emitter {
        Emitter::Disc { radius_mm } if radius_mm > 0.0 => {
            SourceForm::Disc { center: lamp.center_mm, radius: radius_mm }
        }
        Emitter::Disc { .. } => SourceForm::Point(lamp.center_mm),
        Emitter::Tube { half_mm } if half_mm.length() >= Lamp::LEAST_HALF_MM => {
            let (a, b) = (lamp.center_mm - half_mm, lamp.center_mm + half_mm);
            SourceForm::Tube(geometry::Segment { a, b })
        }
        Emitter::Tube { .. } => SourceForm::Point(lamp.center_mm),
    };
    let falloff = Falloff::Table { height_mm: lamp.height_mm, reach_mm: lamp.reach_mm };
    LightSource { form, emission: Emission::EqualEnergy, power: 1.0, falloff }
}
