//! Coulomb's cone: no impact rubs harder than its friction allows.

use physics::{Contact, Kind, Layout, PartId};

/// What rounding may add to a rub, as a part of it and in N s.
const ROUNDING: f64 = 1e-9;
const ROUNDING_N_S: f64 = 1e-15;

/// The coefficient of friction of each part; `None` where the drawing names none (the tips of rods).
pub struct Frictions(Vec<Option<f64>>);

impl Frictions {
    /// Those of a layout.
    pub fn of(layout: &Layout) -> Frictions {
        let friction = |kind: &Kind| match kind {
            Kind::Wall(part) => Some(part.material.friction),
            Kind::Flipper(part) => Some(part.material.friction),
            Kind::Bumper(part) => Some(part.material.friction),
            Kind::Slingshot(part) => Some(part.material.friction),
            Kind::Target(part) => Some(part.material.friction),
            Kind::DropTarget(part) => Some(part.material.friction),
            Kind::Ramp(part) => Some(part.material.friction),
            Kind::Gate(part) => Some(part.material.friction),
            _ => None,
        };
        Frictions(layout.parts.iter().map(|part| friction(&part.kind)).collect())
    }

    fn at(&self, part: Option<PartId>) -> Option<f64> {
        self.0.get(usize::from(part?.0)).copied().flatten()
    }
}

/// Impacts, judged.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct FrictionCone {
    /// Impacts on parts whose friction is known.
    pub impacts: u64,
    /// Those of them whose impulse along the surface is more than its friction times that across it.
    pub outside: u64,
}

impl FrictionCone {
    /// Judges an impact.
    pub fn add(&mut self, contact: &Contact, frictions: &Frictions) {
        let Some(friction) = frictions.at(contact.part) else { return };
        let pressed = contact.impulse_n_s.dot(contact.normal);
        let rubbed = contact.impulse_n_s.dot(contact.normal.perp()).abs();
        self.impacts += 1;
        // What is not a number is not inside.
        let inside = rubbed <= friction * pressed * (1.0 + ROUNDING) + ROUNDING_N_S;
        self.outside += u64::from(!inside);
    }

    /// Both together.
    pub fn and(self, other: FrictionCone) -> FrictionCone {
        FrictionCone { impacts: self.impacts + other.impacts, outside: self.outside + other.outside }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use geometry::{DVec2, Shape};
    use physics::{Material, Part, Wall};

    #[test]
    fn an_impact_is_outside_when_it_rubs_too_hard_or_pulls() {
        let material = Material { restitution: 0.5, falloff_s_per_m: 0.0, friction: 0.3 };
        let wall = Wall { shapes: vec![Shape::disc(DVec2::ONE, 0.1)], material };
        let parts = vec![Part { name: "wall".into(), kind: Kind::Wall(wall) }];
        let layout = Layout { size_m: DVec2::ONE, slope_rad: 0.1, playfield_friction: 0.1, parts };
        let frictions = Frictions::of(&layout);
        let judge = |part: Option<PartId>, impulse_n_s: DVec2| {
            let mut cone = FrictionCone::default();
            let (point, normal) = (DVec2::ONE, DVec2::Y);
            cone.add(
                &Contact { time_s: 0.0, part, point, normal, speed_m_s: 1.0, impulse_n_s, events_before: 0 },
                &frictions,
            );
            (cone.impacts, cone.outside)
        };
        let wall = Some(PartId(0));
        assert_eq!(judge(wall, DVec2::new(0.3, 1.0)), (1, 0));
        assert_eq!(judge(wall, DVec2::new(-0.3001, 1.0)), (1, 1));
        assert_eq!(judge(wall, DVec2::new(0.0, -1.0)), (1, 1), "a wall does not pull");
        assert_eq!(judge(wall, DVec2::NAN), (1, 1));
        assert_eq!(judge(None, DVec2::X), (0, 0), "two balls have no part");
    }
}
