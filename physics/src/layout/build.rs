//! From layout to model: every surface at the ball's centre, sorted into grids.

use crate::GRAVITY_M_S2;
use crate::ball::floor::Floor;
use crate::collision::world::CollisionWorld;
use crate::layout::Layout;
use crate::mechanisms::MechanismModels;
use crate::mechanisms::model::Model;
use crate::mechanisms::ramp;
use crate::part::PartId;
use geometry::trig;

/// The model of a layout that has been checked.
pub(crate) fn model(layout: &Layout) -> Model {
    let mut model = Model {
        size: layout.size_m,
        floor: playfield(layout),
        collision: CollisionWorld::empty(layout.size_m),
        mechanisms: MechanismModels::default(),
    };
    for (index, part) in layout.parts.iter().enumerate() {
        part.kind.add_to(PartId(index as u16), &mut model);
    }
    model.collision.sort(layout.size_m);
    ramp::add_sides(&mut model);
    model
}

/// Gravity along the slope and across it.
fn playfield(layout: &Layout) -> Floor {
    let (sin, cos) = trig::sin_cos(layout.slope_rad);
    let (slope_gravity, normal_load) = (GRAVITY_M_S2 * sin, GRAVITY_M_S2 * cos);
    Floor { slope_gravity, normal_load, friction: layout.playfield_friction, drag: 0.0 }
}
